"""What the readings cannot tell from a cause: other effects, and other periods of the same.

At targets that are nearly even a period and its aliases (one over the period, plus or minus one over the distance of the
targets) do nearly the same. Every peak of the grid is fitted, with what its own form may lack, and the likeliest is the
cause. Those that are about as likely are its rivals.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.fitted import Fitted
from trueaxis.diagnosis.grids import grid_of
from trueaxis.diagnosis.imperfection import beside_forms
from trueaxis.diagnosis.prepared import prepared
from trueaxis.diagnosis.refit import refit
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.scan import HELD, LN10, peaks_of, statistics
from trueaxis.diagnosis.search import (
    RIVAL,
    WORTH_ZOOMING,
    Found,
    Ground,
    Rival,
    Search,
    beside_causes,
    scan_all,
    scan_at,
    search_of,
    with_tries,
    zoomed,
)
from trueaxis.diagnosis.signatures import signature_of
from trueaxis.effects.kind import Kind
from trueaxis.estimation.effects.grids import FEWEST_PERIODS, OF_RIVALS

ALIKE = 2.0 * RIVAL * LN10  # of the sums of squares, within which another period remains in the running
FORMED = 0.75  # share of the most that is explained, from which another period may do as well with what forms may lack
SAME = 0.5  # periods over the range of the axis, by which two peaks differ at least: a peak is two of them wide


@dataclass(frozen=True, slots=True, eq=False)
class _Period:
    """A period of a cause. squares: minus twice the logarithm of its likelihood, but for what all have in common."""

    found: Found
    fitted: Fitted
    squares: float


def with_best_periods(
    ground: Ground, found: Search, causes: tuple[Fitted, ...], standing: Sequence[Fitted]
) -> tuple[Ground, Search, tuple[Fitted, ...]]:
    """Each periodic cause with the likeliest of its periods, and with the others as rivals; on a ground beside whose
    forms that is.
    """
    fitted = {one.effect: one for one in causes}
    every, changed = list(found.causes), False
    for index in range(len(every)):
        others = [fitted[one.scan.effect] for place, one in enumerate(every) if place != index]
        periods = _periods(ground, every, index, (*standing, *others))
        if not periods:
            continue
        near = sorted(periods, key=lambda one: one.squares)
        near = [one for one in near if one.squares < near[0].squares + ALIKE]
        best = periods[0] if periods[0] in near else near[0]  # of those alike that which was found
        rivals = tuple(Rival(one.found.scan, one.fitted) for one in near if one is not best)
        if best is not periods[0]:
            changed = True
            every[index], fitted[best.fitted.effect] = best.found, best.fitted
        every[index] = replace(every[index], rivals=rivals)
    if not changed:
        return ground, replace(found, causes=tuple(every)), causes
    ground = beside_forms(ground, [*standing, *fitted.values()])
    found = search_of(ground, every, found.first)
    return ground, found, refit(ground, found.causes)


def of_rivals(found: Sequence[Found], causes: Sequence[Fitted]) -> list[FloatArray]:
    """(n,) each, mm: what readings would hold besides, were another period that of a cause; found: the causes."""
    signal = {one.effect: one.signal for one in causes}
    return [
        rival.fitted.signal - signal[one.scan.effect]
        for one in found
        for rival in one.rivals
        if rival.fitted.effect == one.scan.effect
    ]


def with_rivals(ground: Ground, found: Search) -> Search:
    """The same causes, each with the other effects, too, that explain the readings about as well in its place."""
    causes = tuple(_with_rivals(ground, found, index) for index in range(len(found.causes)))
    return replace(found, causes=causes)


def _with_rivals(ground: Ground, found: Search, index: int) -> Found:
    mine, others = found.causes[index], [*found.causes[:index], *found.causes[index + 1 :]]
    residual = ground.left(beside_causes(ground, others))
    taken = {one.scan.effect for one in found.causes}
    if others:
        scans = scan_all(ground, residual, [one for one in ground.effects if one not in taken])
    else:
        scans = tuple(one for one in found.first if one.effect not in taken)
    rivals = []
    for one in scans:
        least = mine.scan.preference - RIVAL
        if one.preference < least and not (one.point and one.statistic > WORTH_ZOOMING * mine.scan.statistic):
            continue
        closer = zoomed(ground, residual, one)
        if closer.scan.preference >= least and closer.scan.evidence >= ground.threshold - RIVAL:
            rivals.append(Rival(closer.scan, refit(ground, [closer, *others])[0]))
    rivals.sort(key=lambda one: -one.scan.preference)
    return replace(mine, rivals=(*mine.rivals, *rivals))


def _periods(ground: Ground, causes: Sequence[Found], index: int, known: Sequence[Fitted]) -> list[_Period]:
    """Of one of the causes, first that which was found; none of a cause that is not periodic.

    known: the other causes and effects of the spec.
    """
    mine, others = causes[index], [*causes[:index], *causes[index + 1 :]]
    effect, name = mine.scan.effect, _period_of(mine.signature.kind)
    points = grid_of(mine.signature.kind, effect, ground.readings.rows, OF_RIVALS)
    if name is None or len(points) == 1:
        return []
    place = [one.name for one in mine.signature.kind.parameters].index(name)
    residual = ground.left(beside_causes(ground, others))
    signature = signature_of(ground.readings, effect, points)
    statistic, amplitudes = statistics(signature, prepared(signature, ground.inner), residual)

    span = FEWEST_PERIODS * points[0][name]

    def at_its_best(one: Found) -> tuple[Found, tuple[Fitted, ...]]:
        fitted = refit(ground, [one, *others])
        point = {name: float(fitted[0].values[place])}
        scan = with_tries(scan_at(ground, residual, effect, (point,)), mine.scan.tries)
        return Found(scan, signature_of(ground.readings, effect, (point,))), fitted

    def with_its_form(one: Found, fitted: tuple[Fitted, ...]) -> _Period:
        beside = beside_forms(ground, (*known, fitted[0]))
        fitted = refit(beside, [one, *others], fitted)
        rest = beside.wide.rest(ground.values - ground.whitening(np.sum([each.signal for each in fitted], axis=0)))
        return _Period(one, fitted[0], float(rest @ rest) - 2.0 * float(np.log1p(-beside.wide.shrink).sum()))

    found = [at_its_best(mine)]
    for peak in peaks_of(statistic, HELD * FORMED * float(statistic.max())):
        scan = replace(mine.scan, point=points[peak], amplitudes=amplitudes[peak])
        one = at_its_best(Found(scan, signature_of(ground.readings, effect, (scan.point,))))
        frequencies = [span / each.scan.point[name] for each, _ in (one, *found)]
        if all(abs(each - frequencies[0]) >= SAME for each in frequencies[1:]):
            found.append(one)
    most = max(one.scan.statistic for one, _ in found)
    return [
        with_its_form(one, fitted) for one, fitted in found if one is found[0][0] or one.scan.statistic >= FORMED * most
    ]


def _period_of(kind: Kind) -> str | None:
    """Its name, where it is all that is searched for."""
    searched = [one for one in kind.parameters if one.role == "grid"]
    return searched[0].name if len(searched) == 1 and searched[0].grid == "pitch" else None
