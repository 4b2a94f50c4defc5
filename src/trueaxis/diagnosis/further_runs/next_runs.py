"""Which further run would tell more: for causes with rivals, for structure that has no name, for candidates alike."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np

from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.search import Found
from trueaxis.diagnosis.further_runs.audit import Audit, size_of
from trueaxis.diagnosis.further_runs.of_plan import Limit, NextRun, Placed, Separating, Told
from trueaxis.diagnosis.further_runs.prospect import Outlook, Prospect, outlooks_of
from trueaxis.diagnosis.further_runs.separation import Separation, isolable, largest_reading, separation
from trueaxis.diagnosis.judging.structure import Check
from trueaxis.diagnosis.null_model.noise import REPEATS, STATED
from trueaxis.diagnosis.result import NoiseOf
from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.planned import ASSUMED

MOST_FAMILIES = 12  # of confounded candidates that are looked at
MOST = 5  # runs proposed for them
MOST_NAMED = 3
FARTHEST_POINT = 5.0  # mm, by which a point that somebody has set up may be off
MOST_TAKEN = 10  # times that a run is taken: beyond it nobody does


@dataclass(frozen=True, slots=True, eq=False)
class Ahead:
    """A cause, its rivals, and the run that tells them apart; size: its amplitude; None: no run of the menu does."""

    cause: Placed
    rivals: tuple[Placed, ...]
    size: float
    separation: Separation | None


def ahead_of(prospect: Prospect, found: Found, size: float) -> Ahead:
    """What to do about the rivals of a cause; cheap where it has none."""
    cause, *rivals = (Placed(one.effect, one.point) for one in (found.scan, *(each.scan for each in found.rivals)))
    best = None
    if rivals:
        mine, *others = outlooks_of(prospect, [cause, *rivals])
        best = separation(prospect, mine, others)
    return Ahead(cause, tuple(rivals), size, best)


def separating_run(kinds: Mapping[str, Kind], ahead: Ahead) -> Separating | None:
    """The run, from which size on it tells the cause from its rivals, and what it leaves open; None without a rival."""
    if not ahead.rivals:
        return None
    best, kind = ahead.separation, kinds[ahead.cause.effect.kind]
    if best is None:
        return Separating(cause=ahead.cause, left=ahead.rivals, broken_by=kind.broken_by)
    return Separating(
        cause=ahead.cause,
        run=best.further.what,
        times=best.times,
        apart=tuple(ahead.rivals[place] for place in best.told),
        left=tuple(one for place, one in enumerate(ahead.rivals) if place not in best.told),
        told=_told(kind, ahead.cause.effect, best),
        needed=_needed(kind, best, ahead.size),
    )


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
    return tuple(found)


def _for_causes(kinds: Mapping[str, Kind], ahead: Sequence[Ahead]) -> Iterator[NextRun]:
    for one in ahead:
        best, effect = one.separation, one.cause.effect
        if best is not None and _needed(kinds[effect.kind], best, one.size) <= MOST_TAKEN:
            apart = tuple(one.rivals[place] for place in best.told)
            told = _told(kinds[effect.kind], effect, best)
            yield NextRun(run=best.further.what, times=best.times, pairs=((one.cause, apart),), told=told)


def _for_structure(checks: Sequence[Check]) -> Iterator[NextRun]:
    """A look closer at where the surest checks have fired."""
    fired = sorted((one for one in checks if one.fired), key=lambda one: one.p_value)
    yield from (NextRun(check=one) for one in fired[:MOST_NAMED])


def _for_noise(noise: Sequence[NoiseOf]) -> Iterator[NextRun]:
    yield from (NextRun(instrument=one.group) for one in noise if one.origin not in (REPEATS, STATED))


def _for_alike(prospect: Prospect, audit: Audit) -> list[NextRun]:
    """Runs for confounded candidates: of each two kinds those most alike; those that serve most pairs first."""
    kinds = prospect.ground.readings.model.machine.kinds
    families: dict[frozenset[str], Limit] = {}
    for one in audit.limits:
        if one.state == "confounded" and one.nearest is not None:
            key = frozenset((one.effect.kind, one.nearest.kind))
            if key not in families or one.r2 > families[key].r2:
                families[key] = one
    by_run: dict[tuple[str, int], list[tuple[Limit, Separation]]] = {}
    looked_at = list(islice(families.values(), MOST_FAMILIES))
    mine = [_middle(prospect, one.effect) for one in looked_at]
    rivals = [Placed(one.nearest, one.nearest_at) for one in looked_at if one.nearest is not None]
    outlooks = outlooks_of(prospect, [*mine, *rivals])
    for one, outlook, rival in zip(looked_at, outlooks[: len(mine)], outlooks[len(mine) :], strict=True):
        best = separation(prospect, outlook, [rival])
        kind = kinds[one.effect.kind]
        if best is not None and is_of_use(kind, outlook, best):
            by_run.setdefault((best.further.what, best.times), []).append((one, best))
    found = []
    for (run, times), members in sorted(by_run.items(), key=lambda item: -len(item[1]))[:MOST]:
        pairs = tuple((Placed(one.effect), (Placed(one.nearest),)) for one, _ in members[:MOST_NAMED] if one.nearest)
        first, best = members[0]
        told = _told(kinds[first.effect.kind], first.effect, best)
        found.append(NextRun(run=run, times=times, pairs=pairs, told=told))
    return found


def is_of_use(kind: Kind, outlook: Outlook, best: Separation) -> bool:
    """Whether an effect of the size from which it is told apart is one that a set-up or a machine may have."""
    if kind.place == "point" and isolable(kind, best.after) > FARTHEST_POINT:
        return False
    return largest_reading(outlook, best.after) <= ASSUMED


def _middle(prospect: Prospect, effect: Effect) -> Placed:
    """As the audit has it: the middle of the grid."""
    readings = prospect.ground.readings
    points = grid_of(readings.model.machine.kinds[effect.kind], effect, readings.rows)
    return Placed(effect, points[len(points) // 2])


def _told(kind: Kind, effect: Effect, best: Separation) -> Told:
    _, unit = size_of(kind, effect)
    never = best.before < 1e-6 * best.after
    return Told(effect, unit, isolable(kind, best.after), np.inf if never else isolable(kind, best.before))


def _needed(kind: Kind, best: Separation, size: float) -> int:
    """How often the run has to be taken to tell an amplitude of this size: information grows with the number."""
    if size == 0.0 or not np.isfinite(size):
        return best.times
    limit = isolable(kind, best.after)
    power = 4.0 if any(one.role == "root" for one in kind.parameters) else 2.0
    return int(np.ceil(best.times * (limit / abs(size)) ** power))
