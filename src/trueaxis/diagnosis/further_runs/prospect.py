"""What further runs would add to what the readings at hand tell of candidates, computed before they are taken.

With the whitened base B = Q S V' of the readings at hand the signature of a candidate has Q's in it and leaves M s. A
further run brings rows B1, s1. Its own unknowns (zero, ball, whatever no reading so far holds) are the part of B1 in
the null space of B: P projects them out. What is left, the innovation d = P (s1 - B1 V S^-1 Q's), has the covariance
1 + C C' with C = P B1 V S^-1, since the base's unknowns are known from the readings at hand no better than that. So

    s' M s (with the run) = s' M s (without) + d' (1 + C C')^-1 d,

exact, at the cost of the run's rows alone.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from typing import Any

import numpy as np

from trueaxis.diagnosis.causes.search import Ground
from trueaxis.diagnosis.causes.signature import Readings, readings_of
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.further_runs.menu import FurtherRun, menu
from trueaxis.diagnosis.further_runs.of_plan import Placed
from trueaxis.diagnosis.null_model.base import ANYWHERE, base_of
from trueaxis.diagnosis.null_model.by_run import of_basis
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import Rows
from trueaxis.diagnosis.null_model.whiten import RANK, RunNoise, Whitening, whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.runs import MeasuredRun, noise_groups
from trueaxis.measurement.context import context_of
from trueaxis.model.context import Context

PROBE_MM = 5e-4  # standard deviation of a probe on a step gauge, where the readings do not tell it
USUAL_MM = 3e-4  # the same of laser and ball bar
TIMES = (1, 3)  # how often a run is taken


@dataclass(frozen=True, slots=True, eq=False)
class Innovation:
    """One run of the menu. rows: its rows among all; known: (m, rank), C; own: what projects
    the run's own unknowns out; roots: inverse roots of 1 + t C C', for each t of TIMES.
    """

    rows: slice
    known: FloatArray
    own: Projection
    roots: "tuple[InverseRoot, ...]"


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Prospect:
    """The menu, and what it takes to say what each of its runs would tell. readings: at hand, then all of the menu."""

    ground: Ground
    further: tuple[FurtherRun, ...]
    readings: Readings
    whitening: Whitening
    basis: Projection
    innovations: tuple[Innovation, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Outlook:
    """A candidate: left: (n, k) whitened, what the base leaves of it in the readings at hand; whole: its squared size
    with base and unknowns of all runs, in standard deviations of the readings; largest: of any reading, mm per unit;
    added: for each further run and each of TIMES the whitened innovation (m, k).
    """

    left: FloatArray
    whole: float
    largest: float
    added: tuple[tuple[FloatArray, ...], ...]


def prospect_of(ground: Ground) -> Prospect:
    """Factors the base once, with all runs of the menu in its layout; linear in the number of readings."""
    readings = ground.readings
    further = menu(readings.model, readings.rows)
    everything = _with_further(readings.rows, further)
    base = base_of(readings.model, everything, ground.rough)
    known: dict[str, list[RunNoise]] = {}
    groups = noise_groups(readings.rows.runs)
    for run, one in zip(readings.rows.present, ground.whitening.runs, strict=True):
        for name in {readings.rows.runs[run].instrument, groups[run]}:
            known.setdefault(name, []).append(one)
    parts = [everything.of_run(len(readings.rows.runs) + number) for number in range(len(further))]
    new = slice(len(ground.whitening.runs), None)
    ahead = [_noise(*one, known) for one in zip(base.runs[new], base.drifts[new], base.balls[new], strict=True)]
    whiten = whitening(everything.run, (*ground.whitening.runs, *ahead), base.free)
    white = base.columns.whitened(whiten)
    here = white.first(len(ground.whitening.runs))
    scale = np.linalg.norm(here.weights, axis=0)
    unseen = scale == 0.0
    scale[unseen] = np.maximum(np.linalg.norm(white.weights[:, unseen], axis=0), 1e-300)
    q, r = np.linalg.qr(here.weights / scale)
    left, singular, right = decomposed(r, whole=True)
    rank = int(np.count_nonzero(singular > RANK * singular[0]))
    innovations = []
    for part, (few, weights) in zip(parts, list(white.parts())[len(here.few) :], strict=True):
        turned = few @ (weights / scale) @ right.T
        own = Projection(of_basis(_spanned(turned[:, rank:])))
        held = own.rest(turned[:, :rank] / singular[:rank])
        roots = inverse_roots(held)
        innovations.append(Innovation(part, held, own, roots))
    return Prospect(
        ground=ground,
        further=further,
        readings=readings_of(readings.model, everything),
        whitening=whiten,
        basis=Projection(replace(here, weights=q @ left[:, :rank])),
        innovations=tuple(innovations),
    )


def outlooks_of(prospect: Prospect, candidates: Sequence[Placed]) -> list[Outlook]:
    """What candidates do to the readings at hand and to the menu's; all at once: the base is read but once."""
    each = [signature_of(prospect.readings, one.effect, (one.point,)).over_all() for one in candidates]
    size = prospect.ground.values.size
    columns = np.hstack([np.zeros((prospect.readings.rows.size, 0)), *each])
    white = prospect.whitening(columns)
    here = white[:size]
    by_noise = columns[:size] / prospect.ground.whitening.sigma[:, np.newaxis]
    inside, left = prospect.basis.basis.transposed(here), prospect.basis.rest(here)
    added = []
    for one in prospect.innovations:
        innovation = one.own.rest(white[one.rows]) - one.known @ inside
        added.append([np.sqrt(times) * root(innovation) for times, root in zip(TIMES, one.roots, strict=True)])
    ends = np.cumsum([0, *(one.shape[1] for one in each)])
    return [
        Outlook(
            left[:, mine],
            float(np.sum(by_noise[:, mine] ** 2)),
            float(np.abs(columns[:size, mine]).max(initial=0.0)),
            tuple(tuple(two[:, mine] for two in one) for one in added),
        )
        for mine in (slice(*pair) for pair in pairwise(ends))
    ]


def _with_further(rows: Rows, further: Sequence[FurtherRun]) -> Rows:
    """The rows at hand, then those of every run of the menu, each with a set-up of its own."""
    counts = [one.positions.shape[1] for one in further]
    size = sum(counts)
    run = np.repeat(np.arange(len(further), dtype=np.int64), counts)
    seq = np.concatenate([np.arange(count, dtype=np.int64) for count in counts])
    feed = np.concatenate([np.full(count, one.feed) for count, one in zip(counts, further, strict=True)])
    last = 0.0 if rows.time is None else float(np.nanmax(rows.time))
    time = last + np.concatenate(
        [one.after + np.linspace(0.0, one.lasts, count) for count, one in zip(counts, further, strict=True)]
    )
    new = Rows(
        runs=tuple(one.run for one in further),
        axes=rows.axes,
        row=np.zeros(size, dtype=np.int64),
        run=run,
        seq=seq,
        positions=np.hstack([one.positions for one in further]),
        directions=np.hstack([one.directions for one in further]),
        reading=np.zeros(size),
        time=None if rows.time is None else time,
        temperature=None
        if rows.temperature is None
        else _usual_temperature(rows, time) + np.concatenate([one.warmer for one in further]),
        feed=None if rows.feed is None else feed,
        setup=run,
        mounted=run,
        target=np.arange(size, dtype=np.int64),
        passing=np.zeros(size, dtype=np.int64),
        context=rows.context,
    )
    new = replace(new, context=context_of(new.runs, new))
    return _joined(rows, new)


def _usual_temperature(rows: Rows, time: FloatArray) -> FloatArray:
    """(n,), degC, at later times: as the straight course of the readings at hand goes on. What goes with the time does
    so later, too, unless somebody sees to it.
    """
    assert rows.temperature is not None
    known = np.isfinite(rows.temperature) & (np.isfinite(rows.time) if rows.time is not None else True)
    mean = float(np.mean(rows.temperature[known])) if known.any() else 0.0
    if rows.time is None or not known.any() or np.ptp(rows.time[known]) == 0.0:
        return np.full(time.size, mean)
    slope = np.cov(rows.time[known], rows.temperature[known])[0, 1] / np.var(rows.time[known], ddof=1)
    return np.asarray(mean + slope * (time - np.mean(rows.time[known])))


def _joined(rows: Rows, new: Rows) -> Rows:
    """Numbers of runs, set-ups and targets go on where the others end."""
    start = {
        "run": len(rows.runs),
        **{one: int(getattr(rows, one).max(initial=0)) + 1 for one in ("setup", "mounted", "target")},
    }
    joined: dict[str, Any] = {
        "runs": (*rows.runs, *new.runs), "axes": rows.axes, "context": _contexts(rows.context, new.context)
    }  # fmt: skip
    for one in (each.name for each in fields(Rows) if each.name not in joined):
        here, there = getattr(rows, one), getattr(new, one)
        lacking = here is None or there is None
        joined[one] = None if lacking else np.concatenate([here, there + start.get(one, 0)], axis=-1)
    return Rows(**joined)


def _contexts(one: Context, other: Context) -> Context:
    home = None if one.home is None or other.home is None else _contexts(one.home, other.home)
    names = [each.name for each in fields(Context) if each.name != "home"]
    both = {name: np.concatenate([getattr(one, name), getattr(other, name)], axis=-1) for name in names}
    return Context(**both, home=home)


def _noise(run: MeasuredRun, drifts: float, ball: FloatArray, known: Mapping[str, Sequence[RunNoise]]) -> RunNoise:
    """As that of other runs of the group (`noise_groups`), else of the instrument, or as usual."""
    steps, passed = run.rows.steps, run.rows.passed
    alike = known.get(run.noise_group) or known.get(run.instrument, [])
    of_instrument = sorted(alike, key=lambda one: one.sigma)
    if not of_instrument:
        noise = Noise(PROBE_MM if run.instrument == "probe" else USUAL_MM)
        courses = {"wanders": 0.0, "settles": 0.0, "drifts": drifts}
        return RunNoise(noise=noise, steps=steps, passed=passed, ball=ball, places=ANYWHERE, **courses)
    return replace(of_instrument[len(of_instrument) // 2], steps=steps, passed=passed, drifts=drifts, ball=ball)


def _spanned(columns: FloatArray) -> FloatArray:
    """(m, rank): an orthonormal basis of what columns, parts of some of unit length, span beyond rounding. They are not
    scaled to one length first: of a small one mostly rounding would be left.
    """
    left, singular, _ = decomposed(columns)
    return np.asarray(left[:, : np.count_nonzero(singular > RANK * max(float(singular.max(initial=0.0)), 1.0))])


@dataclass(frozen=True, slots=True, eq=False)
class InverseRoot:
    """A W with W' W = (I + t C C')^-1. left: (m, r), orthonormal; least: (r,), what it leaves of each direction."""

    left: FloatArray
    least: FloatArray

    def __call__(self, columns: FloatArray) -> FloatArray:
        """(r + m, k): W times columns (m, k)."""
        inside = self.left.T @ columns
        return np.vstack([self.least[:, np.newaxis] * inside, columns - self.left @ inside])


def inverse_roots(known: FloatArray) -> tuple[InverseRoot, ...]:
    """For each of TIMES. known: C, (m, rank). Its product with itself is never formed: where a run leads far from the
    readings at hand it is so large that rounding takes the I away.
    """
    left, singular, _ = decomposed(known)
    return tuple(InverseRoot(left, 1.0 / np.sqrt(1.0 + times * singular**2)) for times in TIMES)
