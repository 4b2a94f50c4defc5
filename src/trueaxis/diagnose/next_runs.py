"""Which further run would tell more: for causes with rivals, for structure that has no name, for candidates alike."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from trueaxis.diagnose.audit import Audit, size_of
from trueaxis.diagnose.grids import grid_of
from trueaxis.diagnose.noise import REPEATS, STATED
from trueaxis.diagnose.prospect import Placed, Prospect, outlooks_of
from trueaxis.diagnose.report.quantity import quantity
from trueaxis.diagnose.report.structures import check_name, closer_look
from trueaxis.diagnose.report.words import enumerated
from trueaxis.diagnose.result import Check, Limit, NextRun, NoiseOf
from trueaxis.diagnose.search import Found
from trueaxis.diagnose.separation import Separation, isolable, separation
from trueaxis.effects.kind import Effect, Kind

MOST_FAMILIES = 12  # of confounded candidates that are looked at
MOST = 5  # runs proposed for them
MOST_NAMED = 3
DIGITS = 2  # of sizes that are told apart
FARTHEST_POINT = 5.0  # mm, by which a point that somebody has set up may be off


@dataclass(frozen=True, slots=True, eq=False)
class Ahead:
    """A cause, its rivals, and the run that tells them apart; size: its amplitude; None: no run of the menu does."""

    effect: Effect
    rivals: tuple[Effect, ...]
    size: float
    separation: Separation | None


def ahead_of(prospect: Prospect, found: Found, size: float) -> Ahead:
    """What to do about the rivals of a cause; cheap where it has none."""
    rivals = tuple(one.effect for one in found.rivals)
    best = None
    if rivals:
        placed = [Placed(one.effect, one.point) for one in (found.scan, *found.rivals)]
        mine, *others = outlooks_of(prospect, placed)
        best = separation(prospect, mine, others)
    return Ahead(found.scan.effect, rivals, size, best)


def separating_run(kinds: Mapping[str, Kind], ahead: Ahead) -> str:
    """A sentence: the run, from which size on it tells the cause from its rivals, and what it leaves open.

    Empty where there is no rival.
    """
    if not ahead.rivals:
        return ""
    best, kind = ahead.separation, kinds[ahead.effect.kind]
    if best is None:
        other = f"; what would: {kind.broken_by}" if kind.broken_by else ""
        return f"none of the runs considered would tell {ahead.effect.label} from {_labels(ahead.rivals)}{other}"
    apart = [ahead.rivals[place] for place in best.told]
    text = f"{_taken(best)} would tell {ahead.effect.label} from {_labels(apart)}: {_gain(kind, ahead.effect, best)}"
    times = _needed(kind, best, ahead.size)
    if times > best.times:
        text += f"; for the size found it has to be taken about {times} times"
    left = [one for place, one in enumerate(ahead.rivals) if place not in best.told]
    return text + (f"; not from {_labels(left)}" if left else "")


def next_runs(
    prospect: Prospect, audit: Audit, ahead: Sequence[Ahead], checks: Sequence[Check], noise: Sequence[NoiseOf]
) -> tuple[NextRun, ...]:
    """What to measure next, the most urgent first. ahead: of the causes named; none where no name is given."""
    kinds = prospect.ground.readings.model.machine.kinds
    found = [*_for_causes(kinds, ahead)]
    if not ahead:
        found += _for_structure(checks)
    found += _for_noise(noise)
    found += _for_alike(prospect, audit)
    first: dict[str, NextRun] = {}
    for one in found:
        first.setdefault(one.run, one)
    return tuple(first.values())


def _for_causes(kinds: Mapping[str, Kind], ahead: Sequence[Ahead]) -> Iterator[NextRun]:
    for one in ahead:
        if one.separation is not None:
            apart = [one.rivals[place] for place in one.separation.told]
            yield NextRun(
                f"tell {one.effect.label} from {_labels(apart)}",
                _taken(one.separation),
                _gain(kinds[one.effect.kind], one.effect, one.separation),
            )


def _for_structure(checks: Sequence[Check]) -> Iterator[NextRun]:
    """A look closer at where the surest checks have fired."""
    fired = sorted((one for one in checks if one.fired), key=lambda one: one.p_value)
    for one in fired[:MOST_NAMED]:
        run = closer_look(one)
        if run:
            purpose = f"see whether the structure returns ({check_name(one)})"
            yield NextRun(purpose, run, f"{quantity(one.rms, 'mm')} RMS that has no name yet")


def _for_noise(noise: Sequence[NoiseOf]) -> Iterator[NextRun]:
    for one in noise:
        if one.origin not in (REPEATS, STATED):
            yield NextRun(
                f"know the noise of the {one.instrument}",
                f"every run of the {one.instrument} three times",
                "noise from repeats, which no effect can be mistaken for",
            )


def _for_alike(prospect: Prospect, audit: Audit) -> list[NextRun]:
    """Runs for confounded candidates: of each two kinds those most alike; those that serve most pairs first."""
    kinds = prospect.ground.readings.model.machine.kinds
    families: dict[frozenset[str], Limit] = {}
    for one in audit.limits:
        if one.state == "confounded" and one.nearest is not None:
            key = frozenset((one.effect.kind, one.nearest.kind))
            if key not in families or one.r2 > families[key].r2:
                families[key] = one
    by_run: dict[str, list[tuple[Limit, Separation]]] = {}
    looked_at = list(islice(families.values(), MOST_FAMILIES))
    mine = [_middle(prospect, one.effect) for one in looked_at]
    rivals = [Placed(one.nearest, one.nearest_at) for one in looked_at if one.nearest is not None]
    outlooks = outlooks_of(prospect, [*mine, *rivals])
    for one, outlook, rival in zip(looked_at, outlooks[: len(mine)], outlooks[len(mine) :], strict=True):
        best = separation(prospect, outlook, [rival])
        kind = kinds[one.effect.kind]
        if best is not None and not (kind.place == "point" and isolable(kind, best.after) > FARTHEST_POINT):
            by_run.setdefault(_taken(best), []).append((one, best))
    found = []
    for run, pairs in sorted(by_run.items(), key=lambda item: -len(item[1]))[:MOST]:
        said = [f"{one.effect.label} from {one.nearest.label}" for one, _ in pairs[:MOST_NAMED] if one.nearest]
        first, best = pairs[0]
        gain = _gain(kinds[first.effect.kind], first.effect, best)
        found.append(NextRun(f"could tell {enumerated(said)}", run, gain))
    return found


def _middle(prospect: Prospect, effect: Effect) -> Placed:
    """As the audit has it: the middle of the grid."""
    readings = prospect.ground.readings
    points = grid_of(readings.model.machine.kinds[effect.kind], effect, readings.rows)
    return Placed(effect, points[len(points) // 2])


def _taken(best: Separation) -> str:
    return best.further.what + (f", {best.times} times" if best.times > 1 else "")


def _gain(kind: Kind, effect: Effect, best: Separation) -> str:
    _, unit = size_of(kind, effect)
    after, before = isolable(kind, best.after), isolable(kind, best.before)
    never = best.before < 1e-6 * best.after
    now = "no size would do" if never else f"{quantity(before, unit, DIGITS)} are needed"
    return f"with this run {quantity(after, unit, DIGITS)} of {effect.label} would do; now {now}"


def _needed(kind: Kind, best: Separation, size: float) -> int:
    """How often the run has to be taken to tell an amplitude of this size: information grows with the number."""
    if size == 0.0 or not np.isfinite(size):
        return best.times
    limit = isolable(kind, best.after)
    power = 4.0 if any(one.role == "root" for one in kind.parameters) else 2.0
    return int(np.ceil(best.times * (limit / abs(size)) ** power))


def _labels(effects: Sequence[Effect]) -> str:
    labels = [one.label for one in effects]
    if len(labels) > MOST_NAMED:
        labels = [*labels[:MOST_NAMED], f"{len(labels) - MOST_NAMED} more"]
    return enumerated(labels)
