"""The search for causes: one after another, each with everything that explains the readings about as well."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Protocol, TypeVar

import numpy as np

from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.largest import decays
from trueaxis.diagnosis.causes.prepared import Inner, Prepared, inner_of, prepared
from trueaxis.diagnosis.causes.scan import Residual, Scanned, residual_of, scanned
from trueaxis.diagnosis.causes.signature import Fitted, Readings, Signature
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.null_model.freedom import Freedom
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.roughness import Roughness
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.effects.kind import Effect
from trueaxis.estimation.effects.grids import ZOOMS, Point, finer

FALSE_ALARMS = 1e-4  # share of clean data in which a candidate reaches the threshold, were noise just as assumed
RIVAL = 2.0  # decades of evidence within which a candidate remains in the running
MOST_CAUSES = 4
FURTHER = 2.0  # decades more that a further cause needs: what the first one leaves is not noise alone
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
class Rival:
    """What explains the readings about as well as a cause in its place: another effect, or the same of another period.

    scan: given all other causes; fitted: beside them.
    """

    scan: Scanned
    fitted: Fitted


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """One cause: scan of it given all other causes, its signature there (n_support, 1, k), and its rivals."""

    scan: Scanned
    signature: Signature
    rivals: tuple[Rival, ...] = ()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Search:
    """causes, in order of what they explain; first: every candidate's scan before any cause was taken; last: that of
    the others beside the causes; projection: base and causes; residual: (n,), whitened, what they leave; threshold: of
    the evidence; rough: a component whose rougher curve explains more than another cause would: the search is of use
    again once the base has it.
    """

    causes: tuple[Found, ...]
    first: tuple[Scanned, ...]
    last: tuple[Scanned, ...] = ()
    projection: Projection
    residual: FloatArray
    threshold: float
    rough: str = ""


@dataclass(frozen=True, eq=False, kw_only=True)
class Ground:
    """What is searched on: candidates, whitened readings less what is expected, noise and base.

    plain: the base before anything is known of causes; wide: the base with all that the forms of the causes leave open,
    for their sizes; rough: components of which the base has rougher curves; roughness: of the others, where it is
    looked at; each: `map`, or one that works on several candidates at once; known: of candidates scanned before.
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
    rough: tuple[str, ...] = ()
    roughness: Roughness | None = None
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
    scans: tuple[Scanned, ...] = ()
    causes = settled(ground, start)
    if start:
        first = scan_all(ground, ground.left(ground.base), ground.effects)
    while len(causes) < MOST_CAUSES:
        residual = ground.left(beside_causes(ground, causes))
        scans = scan_all(ground, residual, [one for one in ground.effects if not _told(ground, one, causes)])
        first = first or scans
        best = best_of(ground, residual, scans)
        least = ground.threshold + FURTHER * bool(causes)
        if rough := _rougher(ground, causes, best, least):
            return replace(search_of(ground, causes, first), rough=rough)
        if best is None or best.scan.evidence < least:
            break
        causes = settled(ground, [*causes, best])
    for index, one in enumerate(causes):
        if rough := _rougher(ground, causes[:index] + causes[index + 1 :], one, ground.threshold):
            return replace(search_of(ground, causes, first), rough=rough)
    return replace(search_of(ground, causes, first), last=scans)


def _told(ground: Ground, effect: Effect, causes: Sequence[Found]) -> bool:
    """Whether one of the causes says as much already: of an error that decays from a reversal no second decay is told
    from what its own form lacks.
    """
    others = [one.scan.effect for one in causes]
    same = [one.signature.kind for one in causes if effect.component and one.scan.effect.component == effect.component]
    return effect in others or (any(map(decays, same)) and decays(ground.readings.model.machine.kinds[effect.kind]))


def _rougher(ground: Ground, causes: Sequence[Found], rival: Found | None, least: float) -> str:
    """The component whose rougher curve explains about as much beside causes as the rival, or more; else empty.

    What a periodic error leaves in its own component is a period that is not quite right, and no rougher curve.
    """
    if ground.roughness is None:
        return ""
    # one that would have no name is not in doubt
    periodic = rival is not None and rival.scan.evidence >= least and _is_periodic(rival)
    projection = beside_causes(ground, causes)
    rough = ground.roughness.roughest(projection, ground.values, ground.freedom, local=periodic)
    if rough is None or rough.evidence < least or (rival and rival.scan.preference > rough.preference + RIVAL):
        return ""
    waves = {one.scan.effect.component for one in causes if _is_periodic(one)}
    return "" if rough.component in waves else rough.component


def _is_periodic(one: Found) -> bool:
    """Whether a pitch is among its parameters."""
    return any(parameter.grid == "pitch" for parameter in one.signature.kind.parameters)


def search_of(ground: Ground, causes: Sequence[Found], first: tuple[Scanned, ...]) -> Search:
    """What causes leave, these in order of what they explain."""
    projection = beside_causes(ground, causes)
    return Search(
        causes=tuple(sorted(causes, key=lambda one: -one.scan.statistic)),
        first=first,
        projection=projection,
        residual=projection.rest(ground.values),
        threshold=ground.threshold,
    )


def without(ground: Ground, found: Search, index: int) -> Search:
    """The search without one of its causes, the others looked at again."""
    causes = settled(ground, [one for place, one in enumerate(found.causes) if place != index])
    return search_of(ground, causes, found.first)


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
    for peak in scan.peaks if len(grid) > 1 and len(grid[0]) == 1 else ():
        points, place = grid, peak
        for _ in range(ZOOMS):
            points = finer(points, place)
            closer = scan_at(ground, residual, scan.effect, points)
            place = closer.peaks[0]
            if closer.statistic >= best.statistic:
                best = with_tries(closer, scan.tries)
    signature = signature_of(ground.readings, scan.effect, (best.point,))
    return Found(best, signature)


def scan_at(ground: Ground, residual: Residual, effect: Effect, points: tuple[Point, ...]) -> Scanned:
    """A candidate at points of its own."""
    signature = signature_of(ground.readings, effect, points)
    return scanned(signature, prepared(signature, ground.inner), residual)


def with_tries(scan: Scanned, tries: float) -> Scanned:
    """The scan as one of a grid with so many places."""
    lower = float(np.log10(tries / scan.tries))
    return replace(
        scan,
        tries=tries,
        evidence=scan.evidence - lower,
        preference=scan.preference - lower,
        p_value=min(1.0, scan.p_value * 10.0**lower),
    )


def beside_causes(ground: Ground, causes: Sequence[Found]) -> Projection:
    """The base and causes."""
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


def settled(ground: Ground, start: Sequence[Found]) -> list[Found]:
    """Each cause looked at again given the others, until all reach what they have to; the weakest goes first."""
    causes = list(start)
    while causes:
        for index in range(len(causes)):
            residual = ground.left(beside_causes(ground, causes[:index] + causes[index + 1 :]))
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
