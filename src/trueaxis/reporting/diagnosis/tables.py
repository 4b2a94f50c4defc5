"""The tables of the report: numbers already written out."""

import math
from collections.abc import Collection
from dataclasses import dataclass

from trueaxis.diagnosis.result import Cause, Diagnosis
from trueaxis.measurement.instrument_kinds import SmallUnit, small_unit
from trueaxis.reporting.diagnosis.further import proposals
from trueaxis.reporting.diagnosis.quantity import NBSP, UM, URAD, micrometres, percent, probability, quantity, written
from trueaxis.reporting.diagnosis.structures import check_meaning, check_name
from trueaxis.reporting.diagnosis.words import (
    ESTIMATED,
    effect_title,
    in_words,
    noise_origin,
    rival_title,
    size_of,
    stale_range,
)

R2 = "R\N{SUPERSCRIPT TWO}"
MOST_IN_SIGHT = 12  # rows, each of up to two lines, before the frame of a table scrolls
MOST_PRINTED = 16  # of a table that has the most telling rows first: six pages hold the most that there is
DASH = "\N{EN DASH}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Table:
    """A table of the page. rows: cells as text, the first of each naming its row; numbers: columns set to the right;
    printed: how many of the rows come on paper, None: all.
    """

    caption: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    numbers: frozenset[int] = frozenset()
    printed: int | None = None

    @property
    def unprinted(self) -> int:
        """How many rows are on the screen alone."""
        return 0 if self.printed is None else max(len(self.rows) - self.printed, 0)

    @property
    def long(self) -> bool:
        """Whether it has more rows than fit its frame on the screen, and has to be scrolled."""
        return len(self.rows) > MOST_IN_SIGHT


def measured(diagnosis: Diagnosis) -> Table:
    """With what, how much and when. Only columns in which something is known."""
    head = ("with", "device", "sessions", "runs", "readings", "motions", "hours", "temperature, degC")
    rows = [
        (
            one.instrument,
            " ".join(filter(None, (one.device, one.serial))),
            ", ".join(one.sessions),
            str(one.runs),
            str(one.readings),
            ", ".join(one.motions),
            "" if one.time_s is None else f"{(one.time_s[1] - one.time_s[0]) / 3600.0:.1f}",
            "" if one.temperature_c is None else DASH.join(f"{end:.1f}" for end in dict.fromkeys(one.temperature_c)),
        )
        for one in diagnosis.measured
    ]
    kept = [place for place in range(len(head)) if any(row[place] for row in rows)]
    numbers = frozenset(kept.index(place) for place in (3, 4, 6) if place in kept)
    return Table(
        caption="Readings used: without outliers and those of a bar next to a reversal or before an axis has moved",
        head=tuple(head[place] for place in kept),
        rows=tuple(tuple(row[place] for place in kept) for row in rows),
        numbers=numbers,
    )


def errors(diagnosis: Diagnosis) -> Table:
    """All errors of the machine: as given, as these readings have them, and by what they have changed."""
    said = {"data": "readings", "partly": "readings, partly", "prior": "no reading"}
    rows = tuple(
        (
            one.name,
            quantity(one.given, one.unit),
            *(
                (DASH, DASH)
                if one.determined == "prior"
                else (quantity(one.now, one.unit), quantity(one.change, one.unit))
            ),
            quantity(one.u, one.unit) if math.isfinite(one.u) else DASH,
            said[one.determined],
        )
        for one in diagnosis.errors
    )
    head = ("error", "given", "now", "change", "u", "change determined by")
    return Table(
        caption="Largest over the travel; u: standard uncertainty of the change; what no reading tells stays as given",
        head=head,
        rows=rows,
        numbers=frozenset(range(1, 5)),
    )


def rivals(cause: Cause) -> Table:
    """What explains the readings about as well as the cause."""
    rows = tuple(
        (rival_title(one), size_of(one), _short(one.evidence), probability(one.p_value))
        for one in sorted(cause.rivals, key=lambda one: -one.evidence)
    )
    own = (effect_title(cause.effect), size_of(cause), _short(cause.evidence), probability(cause.p_value))
    return Table(
        caption="Cannot be distinguished from",
        head=("candidate", "size", "evidence", "p"),
        rows=(own, *rows),
        numbers=frozenset({2, 3}),
        printed=MOST_PRINTED,
    )


def circularity(diagnosis: Diagnosis) -> Table:
    """ISO 230-4, measured and what is left."""
    rows = tuple(
        (one.run, *(micrometres(value) for value in (one.measured, one.given, one.refitted, one.extended)))
        for one in sorted(diagnosis.circles, key=lambda one: -one.extended)
    )
    head = ("run", "measured", "residual, as given", "residual, refitted", "residual, extended")
    return Table(
        caption=f"Circular deviation (ISO 230-4), {UM}",
        head=head,
        rows=rows,
        numbers=frozenset(range(1, 5)),
        printed=MOST_PRINTED,
    )


def limits(diagnosis: Diagnosis) -> Table:
    """What each candidate had to have for size to be seen; numbered as the heat map has it."""
    number = {effect: str(k) for k, effect in enumerate(diagnosis.isolability, 1)}
    rows = []
    for one in diagnosis.limits:
        nearest = DASH if one.nearest is None else f"{effect_title(one.nearest)} ({R2}{NBSP}{one.r2:.2f})"
        rows.append(
            (
                effect_title(one.effect),
                number.get(one.effect, DASH),
                one.size,
                _least(one.detection, one.unit),
                _least(one.isolation, one.unit),
                percent(one.share),
                nearest,
                f"{one.state}: {one.reason}" if one.reason else one.state,
            )
        )
    head = (
        "candidate",
        "no.",
        "size",
        "detected from",
        "distinguished from",
        "beyond the null model",
        "nearest",
        "state",
    )
    return Table(
        caption="Detection limits, from the runs alone, before any reading",
        head=head,
        rows=tuple(rows),
        numbers=frozenset({1, 3, 4, 5}),
    )


def checks(diagnosis: Diagnosis) -> Table:
    """Those that fired first, then by p."""
    rows = tuple(
        (
            check_name(one),
            check_meaning(one),
            probability(one.p_value),
            micrometres(one.rms),
            "FIRED" if one.fired else "quiet",
        )
        for one in sorted(diagnosis.checks, key=lambda one: (not one.fired, _last(one.p_value)))
    )
    head = ("check", "what it looks for", "p", f"RMS ({UM})", "result")
    return Table(
        caption="Structure left by the final model",
        head=head,
        rows=rows,
        numbers=frozenset({2, 3}),
        printed=MOST_PRINTED,
    )


def units_of_runs(diagnosis: Diagnosis) -> dict[str, SmallUnit]:
    """Id of each run -> small unit of its readings."""
    residuals = diagnosis.residuals
    return {run: small_unit(name) for run, name in zip(residuals.runs, residuals.instruments, strict=True)}


def _deviation(value: float, unit: SmallUnit) -> str:
    """In micrometres as the head of the column says, else with its unit."""
    return micrometres(value) + (f"{NBSP}{URAD}" if unit == "urad" else "")


def outliers(diagnosis: Diagnosis) -> Table:
    """Readings left out, the farthest first."""
    units = units_of_runs(diagnosis)
    rows = tuple(
        (f"{one.run}, {one.seq}", _deviation(one.deviation, units[one.run]), written(one.z, "+.1f"))
        for one in sorted(diagnosis.outliers, key=lambda one: -abs(one.z))
    )
    head = ("run, seq", f"deviation ({UM})", "standard deviations")
    return Table(
        caption="Readings left out as outliers", head=head, rows=rows, numbers=frozenset({1, 2}), printed=MOST_PRINTED
    )


def next_runs(diagnosis: Diagnosis, kinds: Collection[str]) -> Table:
    """What to measure next. kinds: whose names become words."""
    rows = tuple(
        (in_words(one.run, kinds), in_words(one.purpose, kinds), in_words(one.gain, kinds))
        for one in proposals(diagnosis)
    )
    return Table(caption="Runs that would help", head=("run", "purpose", "what it would show"), rows=rows)


def stale(diagnosis: Diagnosis) -> Table:
    """Values given that are no longer true, the most evident first."""
    rows = tuple(
        (
            one.component,
            *(end or DASH for end in stale_range(one)),
            quantity(one.value, one.unit),
            quantity(one.u, one.unit, 2),
            probability(one.p_value),
        )
        for one in diagnosis.stale
    )
    head = ("error", "from", "to", "change", "u", "p")
    return Table(caption="Values that have changed", head=head, rows=rows, numbers=frozenset(range(1, 6)))


def noise(diagnosis: Diagnosis) -> Table:
    """Noise of each instrument: correlation is that of the slow part from one reading to the next."""
    rows = tuple(
        (
            one.group if small_unit(one.instrument) == "um" else f"{one.group}, {URAD}",
            micrometres(one.sigma),
            micrometres(one.white),
            micrometres(one.correlated),
            _short(one.correlation) if one.correlated else DASH,
            micrometres(one.settles),
            micrometres(one.wanders),
            micrometres(one.places) if one.places else DASH,
            f"{one.freedom:.0f}" if one.origin in ESTIMATED else DASH,
            noise_origin(one.origin),
        )
        for one in diagnosis.noise
    )
    sizes = ("in all", "white", "slow", "correlation", "runs settle by", "runs wander by", "balls differ by")
    head = ("instrument", *sizes, "d.o.f.", "known from")
    return Table(caption=f"Noise of a reading, {UM}", head=head, rows=rows, numbers=frozenset(range(1, 9)))


def scan(diagnosis: Diagnosis) -> Table:
    """Every candidate, the strongest first."""
    rows = tuple(
        (
            effect_title(one.effect),
            _short(one.evidence),
            probability(one.p_value),
            written(one.tries, ".3g" if one.tries < 1e3 else ".0f"),
            str(one.freedom),
        )
        for one in sorted(diagnosis.scan, key=lambda one: -_first(one.evidence))
    )
    head = ("candidate", "evidence", "p", "effective tries", "d.o.f.")
    return Table(
        caption=f"Evidence of every candidate (threshold {diagnosis.threshold:.3g})",
        head=head,
        rows=rows,
        numbers=frozenset({1, 2, 3, 4}),
    )


def _short(value: float) -> str:
    return written(value, ".2f") if math.isfinite(value) else DASH


def _least(size: float, unit: str) -> str:
    if math.isnan(size):
        return DASH
    return "never" if math.isinf(size) else quantity(size, unit, 2)


def _first(value: float) -> float:
    return -math.inf if math.isnan(value) else value


def _last(value: float) -> float:
    return math.inf if math.isnan(value) else value
