"""The search for causes: one after another, each with everything that explains the readings about as well."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Protocol, TypeVar

import numpy as np

from trueaxis.diagnosis.freedom import Freedom
from trueaxis.diagnosis.grids import grid_of
from trueaxis.diagnosis.prepared import Inner, Prepared, inner_of, prepared
from trueaxis.diagnosis.projection import Projection
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.scan import Residual, Scanned, residual_of, scanned
from trueaxis.diagnosis.signature import Readings, Signature
from trueaxis.diagnosis.signatures import signature_of
from trueaxis.diagnosis.whiten import Whitening
from trueaxis.effects.kind import Effect

FALSE_ALARMS = 1e-4  # share of clean data in which a candidate reaches the threshold, were noise just as assumed
RIVAL = 2.0  # decades of evidence within which a candidate remains in the running
MOST_CAUSES = 4
LIKELIEST = 3  # candidates below the threshold, beside which the noise is estimated anew
FURTHER = 2.0  # decades more that a further cause needs: what the first one leaves is not noise alone
ZOOM = 7  # points per zoom of a grid, twice
MOST_PEAKS = 8  # of a grid that are looked at more closely: aliases of a period, for targets that are nearly even
WORTH_ZOOMING = 0.6  # share of the best statistic from which a candidate's grid is looked at more closely

Progress = Callable[[str], None]


T = TypeVar("T")
R = TypeVar("R")


class Each(Protocol):
    """`map`, that of a pool of threads, or another that gives the same results in the same order."""

    def __call__(self, function: Callable[[T], R], things: Iterable[T], /) -> Iterable[R]:
        """The function of everything."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """One cause: scan of it given all other causes, its signature there (n_support, 1, k), and its rivals."""

    scan: Scanned
    signature: Signature
    rivals: tuple[Scanned, ...] = ()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Search:
    """causes, in order of what they explain; first: every candidate's scan before any cause was taken; projection:
    base and causes; residual: (n,), whitened, what they leave; threshold: of the evidence.
    """

    causes: tuple[Found, ...]
    first: tuple[Scanned, ...]
    projection: Projection
    residual: FloatArray
    threshold: float


@dataclass(frozen=True, eq=False, kw_only=True)
class Ground:
    """What is searched on: candidates, whitened readings less what is expected, noise and base.

    plain: the base before anything is known of causes; wide: the base with all that the forms of the causes leave open,
    for their sizes; each: `map`, or one that works on several candidates at once; known: of candidates scanned before.
    """

    readings: Readings
    effects: tuple[Effect, ...]
    whitening: Whitening
    plain: Projection
    base: Projection
    wide: Projection
    values: FloatArray
    freedom: Freedom
    progress: Progress
    each: Each = map
    known: dict[Effect, Prepared] = field(default_factory=dict, repr=False)

    @cached_property
    def inner(self) -> Inner:
        """Whitening and base, as signatures are multiplied by them."""
        return inner_of(self.whitening, self.base)

    @property
    def threshold(self) -> float:
        """Evidence that a candidate has to reach: Bonferroni over the candidates."""
        return float(np.log10(max(len(self.effects), 1) / FALSE_ALARMS))

    def left(self, base: Projection) -> Residual:
        """What the base, with the causes that were found, leaves to be explained."""
        return residual_of(self.whitening, base, self.values, self.freedom)

    def knows(self, signature: Signature) -> Prepared:
        """Of a candidate on its grid, prepared once."""
        if signature.effect not in self.known:
            self.known[signature.effect] = prepared(signature, self.inner)
        return self.known[signature.effect]


def search(ground: Ground, start: Sequence[Found] = ()) -> Search:
    """Forward, with all causes looked at anew given the others, until no candidate reaches the threshold."""
    first: tuple[Scanned, ...] = ()
    causes = list(start)
    if causes:
        first = scan_all(ground, ground.left(ground.base), ground.effects)
        causes = _settled(ground, causes)
    while len(causes) < MOST_CAUSES:
        residual = ground.left(_with(ground, causes))
        taken = {one.scan.effect for one in causes}
        scans = scan_all(ground, residual, [one for one in ground.effects if one not in taken])
        first = first or scans
        best = best_of(ground, residual, scans)
        if best is None or best.scan.evidence < ground.threshold + FURTHER * bool(causes):
            break
        causes = _settled(ground, [*causes, best])
    causes.sort(key=lambda one: -one.scan.statistic)
    projection = _with(ground, causes)
    return Search(
        causes=tuple(causes),
        first=first,
        projection=projection,
        residual=projection.rest(ground.values),
        threshold=ground.threshold,
    )


def likeliest(ground: Ground, found: Search) -> list[Found]:
    """The few candidates with the best evidence, none of which reached the threshold: the noise may hold them."""
    scans = sorted(found.first, key=lambda one: -one.evidence)[:LIKELIEST]
    residual = ground.left(ground.base)
    return [zoomed(ground, residual, one) for one in scans if one.evidence > 0.0]


def without(ground: Ground, found: Search, index: int) -> Search:
    """The search without one of its causes, the others looked at again."""
    causes = _settled(ground, [one for place, one in enumerate(found.causes) if place != index])
    causes.sort(key=lambda one: -one.scan.statistic)
    projection = _with(ground, causes)
    return replace(found, causes=tuple(causes), projection=projection, residual=projection.rest(ground.values))


def with_rivals(ground: Ground, found: Search) -> Search:
    """The same causes, each with what explains the readings about as well in its place."""
    causes = tuple(_with_rivals(ground, found.causes, index, found.first) for index in range(len(found.causes)))
    return replace(found, causes=causes)


def scan_all(ground: Ground, residual: Residual, effects: Sequence[Effect]) -> tuple[Scanned, ...]:
    """Every candidate on its grid."""

    def scan(effect: Effect) -> Scanned:
        signature = signature_of(ground.readings, effect)
        return scanned(signature, ground.knows(signature), residual)

    found = []
    for number, one in enumerate(ground.each(scan, effects)):
        ground.progress(f"scan {number + 1} of {len(effects)}: {one.effect.label}")
        found.append(one)
    return tuple(found)


def zoomed(ground: Ground, residual: Residual, scan: Scanned) -> Found:
    """The candidate with its searched parameters between the points of the grid; tries remain those of the grid."""
    kind = ground.readings.model.machine.kinds[scan.effect.kind]
    grid, best = grid_of(kind, scan.effect, ground.readings.rows), scan
    if len(grid) > 1 and len(grid[0]) == 1:
        for peak in scan.peaks[:MOST_PEAKS]:
            points, place = grid, peak
            for _ in range(2):
                points = _between(points, place)
                signature = signature_of(ground.readings, scan.effect, points)
                closer = scanned(signature, prepared(signature, ground.inner), residual)
                place = closer.place
                if closer.statistic >= best.statistic:
                    best = _with_tries(closer, scan.tries)
    signature = signature_of(ground.readings, scan.effect, (best.point,))
    return Found(best, signature)


def _between(points: Sequence[Mapping[str, float]], place: int) -> tuple[Mapping[str, float], ...]:
    """A finer grid between the neighbours of a point; in its inverse, in which frequencies are even."""
    (name,) = points[0]
    ends = [points[max(place - 1, 0)][name], points[min(place + 1, len(points) - 1)][name]]
    if min(ends) > 0.0:
        values = 1.0 / np.linspace(1.0 / ends[0], 1.0 / ends[1], ZOOM)
    else:
        values = np.linspace(ends[0], ends[1], ZOOM)
    return tuple({name: float(value)} for value in values)


def _with_tries(scan: Scanned, tries: float) -> Scanned:
    lower = float(np.log10(tries / scan.tries))
    return replace(
        scan,
        tries=tries,
        evidence=scan.evidence - lower,
        preference=scan.preference - lower,
        p_value=min(1.0, scan.p_value * 10.0**lower),
    )


def _with(ground: Ground, causes: Sequence[Found]) -> Projection:
    return ground.base.extended(cause_columns(ground, causes)) if causes else ground.base


def cause_columns(ground: Ground, causes: Sequence[Found]) -> FloatArray:
    """(n, k): the signatures of all causes, whitened."""
    nothing = np.zeros((ground.values.size, 0))
    return np.hstack([nothing, *(whitened_columns(ground, one.signature) for one in causes)])


def whitened_columns(ground: Ground, signature: Signature) -> FloatArray:
    """(n, k): the signature at its one point, over all rows, whitened."""
    return ground.whitening(signature.over_all())


def best_of(ground: Ground, residual: Residual, scans: Sequence[Scanned]) -> Found | None:
    """The candidate that explains most, closely looked at; None where none explains anything."""
    most = max((one.preference for one in scans), default=0.0)
    if most <= 0.0:
        return None
    strongest = max(one.statistic for one in scans)
    close = [
        one
        for one in scans
        if one.preference >= most - RIVAL or (len(one.point) and one.statistic > WORTH_ZOOMING * strongest)
    ]
    found = [zoomed(ground, residual, one) for one in close]
    return max(found, key=lambda one: one.scan.preference)


def _settled(ground: Ground, causes: list[Found]) -> list[Found]:
    """Each cause looked at again given the others, until all reach what they have to; the weakest goes first."""
    while causes:
        for index in range(len(causes)):
            residual = ground.left(_with(ground, causes[:index] + causes[index + 1 :]))
            again = scan_all(ground, residual, [causes[index].scan.effect])[0]
            causes[index] = zoomed(ground, residual, again)
        strongest = max(range(len(causes)), key=lambda index: causes[index].scan.statistic)
        excess = [
            one.scan.evidence - ground.threshold - FURTHER * (index != strongest) for index, one in enumerate(causes)
        ]
        weakest = min(range(len(causes)), key=excess.__getitem__)
        if excess[weakest] >= 0.0:
            break
        causes = causes[:weakest] + causes[weakest + 1 :]
    return causes


def _with_rivals(ground: Ground, causes: Sequence[Found], index: int, first: tuple[Scanned, ...]) -> Found:
    """The cause with what explains the readings about as well in its place, the others staying."""
    mine, others = causes[index], [*causes[:index], *causes[index + 1 :]]
    residual = ground.left(_with(ground, others))
    taken = {one.scan.effect for one in causes}
    if others:
        scans = scan_all(ground, residual, [one for one in ground.effects if one not in taken])
    else:
        scans = tuple(one for one in first if one.effect not in taken)
    rivals = []
    for one in scans:
        least = mine.scan.preference - RIVAL
        if one.preference < least and not (one.point and one.statistic > WORTH_ZOOMING * mine.scan.statistic):
            continue
        closer = zoomed(ground, residual, one).scan
        if closer.preference >= least and closer.evidence >= ground.threshold - RIVAL:
            rivals.append(closer)
    rivals.sort(key=lambda one: -one.preference)
    return replace(mine, rivals=tuple(rivals))
