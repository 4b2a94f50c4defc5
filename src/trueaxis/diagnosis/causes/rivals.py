"""What the readings cannot tell from a cause: other effects, and other periods of the same.

At targets that are nearly even a period and its aliases (one over the period, plus or minus one over the distance of
targets) do nearly the same. Every peak of the grid is fitted, with what its own form may lack, and judged by the
likelihood: those that are about as likely as the likeliest are rivals.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.imperfection import MODULATED, beside_forms
from trueaxis.diagnosis.causes.prepared import prepared
from trueaxis.diagnosis.causes.refit import refit, start_of
from trueaxis.diagnosis.causes.scan import HELD, Residual, Scanned, peaks_of, statistics
from trueaxis.diagnosis.causes.search import (
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
from trueaxis.diagnosis.causes.signature import Fitted, Signature
from trueaxis.diagnosis.causes.signatures import parameter_signature, signature_of
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Kind
from trueaxis.estimation.effects.grids import FEWEST_PERIODS, OF_RIVALS, ZOOMS, Point, finer
from trueaxis.estimation.tails import LN10

ALIKE = 2.0 * RIVAL * LN10  # of the sums of squares, within which another period remains in the running
FORM = 1.0 - MODULATED**2  # share of the squares of a cause, from where a difference is within what forms may lack
FORMED = 0.75  # share of the most that is explained, from which another period may do as well with what forms may lack
CLOSE = 4  # steps from a peak that is known to a thirtieth of its width: each leaves the square of what is wrong
SAME = 0.25  # periods over the range of the axis, by which two peaks differ at least


@dataclass(frozen=True, slots=True, eq=False)
class _Period:
    """A period of a cause. squares: minus twice the logarithm of its likelihood, but for what all have in common."""

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
        rivals = tuple(Rival(_at(ground, every, index, one.fitted).scan, one.fitted) for one in near if one is not best)
        fitted[best.fitted.effect] = best.fitted
        if best is not periods[0]:
            changed = True
            every[index] = _at(ground, every, index, best.fitted)
        every[index] = replace(every[index], rivals=rivals)
    if not changed:
        return ground, replace(found, causes=tuple(every)), tuple(fitted[one.effect] for one in causes)
    ground = beside_forms(ground, [*standing, *fitted.values()])
    found = search_of(ground, every, found.first)
    return ground, found, refit(ground, found.causes)


def of_rivals(found: Sequence[Found], causes: Sequence[Fitted], *, of_others: bool = False) -> list[FloatArray]:
    """(n,) each, mm: what readings would hold besides, were another period that of a cause; found: the causes.

    of_others: were another effect the cause, in place of that.
    """
    signal = {one.effect: one.signal for one in causes}
    return [
        rival.fitted.signal - signal[one.scan.effect]
        for one in found
        for rival in one.rivals
        if (rival.fitted.effect != one.scan.effect) == of_others
    ]


def with_rivals(ground: Ground, found: Search) -> Search:
    """The same causes, each with the other effects, too, that explain the readings about as well in its place."""
    causes = tuple(_with_rivals(ground, found, index) for index in range(len(found.causes)))
    return replace(found, causes=causes)


def _with_rivals(ground: Ground, found: Search, index: int) -> Found:
    mine, others = found.causes[index], [*found.causes[:index], *found.causes[index + 1 :]]
    residual = _beside_others(ground, found.causes, index)
    taken = {one.scan.effect for one in found.causes}
    if others:
        scans = scan_all(ground, residual, [one for one in ground.effects if one not in taken])
    else:
        scans = tuple(one for one in found.first if one.effect not in taken)
    rivals = []
    for one in scans:
        if not _near(one, mine.scan) and not (one.point and one.statistic > WORTH_ZOOMING * mine.scan.statistic):
            continue
        closer = zoomed(ground, residual, one)
        if _near(closer.scan, mine.scan) and closer.scan.evidence >= ground.threshold - RIVAL:
            rivals.append(Rival(closer.scan, refit(ground, [closer, *others])[0]))
    rivals.sort(key=lambda one: -one.scan.preference)
    return replace(mine, rivals=(*mine.rivals, *rivals))


def _near(one: Scanned, best: Scanned) -> bool:
    """Whether a candidate explains about as much as the best: as likely within RIVAL decades, or, with no more
    parameters, a share FORM of its squares.
    """
    no_freer = one.freedom <= best.freedom and len(one.point) <= len(best.point)
    return one.preference >= best.preference - RIVAL or (no_freer and one.statistic >= FORM * best.statistic)


def _periods(ground: Ground, causes: Sequence[Found], index: int, known: Sequence[Fitted]) -> list[_Period]:
    """Of one of the causes, first that which was found; none of a cause that is not periodic.

    known: the other causes and effects of the spec.
    """
    mine, others = causes[index], [*causes[:index], *causes[index + 1 :]]
    name = _period_of(mine.signature.kind)
    points = grid_of(mine.signature.kind, mine.scan.effect, ground.readings.rows, OF_RIVALS)
    if name is None or len(points) == 1:
        return []
    span, found = FEWEST_PERIODS * points[0][name], list[_Period]()
    for one in (mine, *_peaks(ground, causes, index, points)):
        values = start_of(one)
        signal, _ = parameter_signature(ground.readings, one.scan.effect, values)
        start = Fitted(
            effect=one.scan.effect,
            kind=one.signature.kind,
            values=values,
            u=np.full_like(values, np.nan),
            signal=signal,
        )
        beside = beside_forms(ground, (*known, start))
        both = refit(beside, [one, *others], CLOSE)
        frequency = span / _parameter(both[0], name)
        if any(abs(span / _parameter(each.fitted, name) - frequency) < SAME for each in found):
            continue
        rest = beside.wide.rest(ground.values - ground.whitening(np.sum([each.signal for each in both], axis=0)))
        found.append(_Period(both[0], float(rest @ rest) - 2.0 * float(np.log1p(-beside.wide.shrink).sum())))
    return found


def _peaks(ground: Ground, causes: Sequence[Found], index: int, points: Sequence[Point]) -> list[Found]:
    """A cause at every peak of a grid at which it explains nearly as much as at any other."""
    mine = causes[index]
    residual = _beside_others(ground, causes, index)

    def scan(points: Sequence[Point]) -> tuple[Signature, FloatArray, FloatArray]:
        signature = signature_of(ground.readings, mine.scan.effect, tuple(points))
        return signature, *statistics(signature, prepared(signature, ground.inner), residual)

    _, statistic, _ = scan(points)
    peaks = [(tuple(points), place) for place in peaks_of(statistic, HELD * FORMED * float(statistic.max()))]
    for _ in range(ZOOMS):  # all at once
        grids = [finer(*one) for one in peaks]
        signature, statistic, amplitudes = scan([point for grid in grids for point in grid])
        highest = np.argmax(statistic.reshape(len(grids), -1), axis=1)
        peaks = list(zip(grids, highest.tolist(), strict=True))
    each = np.arange(len(peaks)) * len(peaks[0][0]) + highest
    return [
        Found(replace(mine.scan, point=signature.points[k], amplitudes=amplitudes[k]), mine.signature)
        for k in each[statistic[each] >= FORMED * float(statistic.max())].tolist()
    ]


def _at(ground: Ground, causes: Sequence[Found], index: int, fitted: Fitted) -> Found:
    """A cause at the place where it was fitted."""
    effect, tries = fitted.effect, causes[index].scan.tries
    point = {name: _parameter(fitted, name) for name in causes[index].scan.point}
    scan = scan_at(ground, _beside_others(ground, causes, index), effect, (point,))
    return Found(with_tries(scan, tries), signature_of(ground.readings, effect, (point,)))


def _beside_others(ground: Ground, causes: Sequence[Found], index: int) -> Residual:
    return ground.left(beside_causes(ground, [*causes[:index], *causes[index + 1 :]]))


def _parameter(fitted: Fitted, name: str) -> float:
    return float(fitted.values[[one.name for one in fitted.kind.parameters].index(name)])


def _period_of(kind: Kind) -> str | None:
    """Its name, where it is all that is searched for."""
    searched = [one for one in kind.parameters if one.role == "grid"]
    return searched[0].name if len(searched) == 1 and searched[0].grid == "pitch" else None
