"""Products of whitened signatures, base and runs' own unknowns taken away, for whole grids.

By far most of the time of a search goes here. So run by run, row by row in memory, and each product once: the base and
what is taken away in a run are a few directions there, whose products with the signature are all that is needed.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trueaxis.diagnosis.causes.signature import Signature
from trueaxis.diagnosis.null_model.projection import Projection
from trueaxis.diagnosis.null_model.rows import runs_among
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray
from trueaxis.estimation.effects.amplitudes import UNOBSERVABLE
from trueaxis.estimation.noise import BLOCK

ENTRIES = 1 << 17  # of a run's columns at a time: 1 MB, which stay in the processor's cache
FEW = BLOCK  # columns, below which all runs are whitened at once
NOTHING = 1e-200  # squares, in units of the noise, whose inverse would leave the range of numbers


@dataclass(frozen=True, slots=True, eq=False)
class Prepared:
    """What of a candidate stays the same whatever the readings are and whichever causes are found.

    whole: (points,), sum of squares of the signature in standard deviations of the readings; gram: (points, k, k), the
    signature times itself, whitened, base and unknowns of all runs taken away; length: of the curve along the grid.
    """

    whole: FloatArray
    gram: FloatArray
    length: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Inner:
    """Whitening and base, without causes. taken: (m, r + s + a) of each run: directions of the base, r, those in which
    readings vary by chance, s, as they are before anything is taken away in the run, and that, a; ends: of each run's r
    among the weights; weights: (sum of r, rank); chance: (s,), how much of each direction is taken away.
    """

    whitening: Whitening
    taken: tuple[FloatArray, ...]
    ends: tuple[int, ...]
    weights: FloatArray
    chance: FloatArray

    def parts(self, place: int) -> tuple[slice, slice, slice]:
        """Base, chance and the run's own among what is taken away in a run."""
        first, last = self.ends[place : place + 2]
        r, s = last - first, self.chance.size
        return slice(0, r), slice(r, r + s), slice(r + s, None)


def inner_of(whitening: Whitening, base: Projection) -> Inner:
    """Once for all candidates."""
    taken = []
    soft = base.soft if base.soft.size else np.zeros((int(whitening.starts[-1]), 0))
    for place, (first, last) in enumerate(pairwise(whitening.starts.tolist())):
        basis, root = whitening.aside(place)
        both = np.hstack([base.basis.few[place], soft[first:last]])
        both -= basis @ (root[:, np.newaxis] * (basis.T @ both))
        taken.append(np.hstack([both, basis * np.sqrt(root * (2.0 - root))]))
    chance = np.sqrt(1.0 - (1.0 - base.shrink) ** 2) if soft.shape[1] else np.zeros(0)
    return Inner(
        whitening=whitening,
        taken=tuple(taken),
        ends=tuple(base.basis.ends.tolist()),
        weights=base.basis.weights,
        chance=chance,
    )


def prepared(signature: Signature, inner: Inner) -> Prepared:
    """The candidate's signature whitened and the base taken away.

    The cost grows with the readings that it reaches times rank of the base in a run times points of the grid.
    """
    points, k = len(signature.points), signature.terms.shape[2]
    whole, gram, cross = np.zeros(points), np.zeros((points, k, k)), np.zeros((max(points - 1, 0), k, k))
    runs = list(runs_among(inner.whitening.starts, signature.support))
    # of a few columns all runs at once: the calls would take longer than the work; of many those of a run
    few = points * k < FEW
    size = signature.support.size if few else max([here.stop - here.start for _, here in runs], default=1)
    groups = [runs] if few else [[one] for one in runs]
    step = max(ENTRIES // max(size * k, 1), 1)
    for start in range(0, points, step):
        # with the first of the next, for the products of neighbours
        chosen = slice(start, min(start + step + 1, points))
        squares, products, beside = _of_points(signature, inner, groups, chosen)
        own = slice(start, min(start + step, points))
        whole[own], gram[own] = squares[:step], products[:step]
        cross[start : start + len(beside)] = beside
    # what the base and the runs hold is rounding, and what dies away before the first reading is nothing
    held = np.trace(gram, axis1=1, axis2=2) <= np.maximum(UNOBSERVABLE * whole, NOTHING)
    gram = np.where(held[:, np.newaxis, np.newaxis], 0.0, gram)
    return Prepared(whole, gram, _length(gram, cross))


def _of_points(
    signature: Signature, inner: Inner, groups: list[list[tuple[int, slice]]], points: slice
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """(points,) and (points, k, k), whole and gram, and (points - 1, k, k), the gram of each point with the next.

    groups: of runs that are whitened at once, by their places and their rows in the support.
    """
    count, k = points.stop - points.start, signature.terms.shape[2]
    whole, gram, cross = np.zeros(count), np.zeros((count, k, k)), np.zeros((count - 1, k, k))
    nothing = np.zeros((0, count * k))
    by_base, own, by_chance = [nothing], [nothing], np.zeros((inner.chance.size, count * k))
    weights = [inner.weights[:0]]
    for runs in filter(None, groups):
        rows = slice(runs[0][1].start, runs[-1][1].stop)
        columns = signature.rows_of(rows, points)
        places = [place for place, _ in runs]
        sigma = np.repeat([inner.whitening.runs[place].sigma for place in places], [h.stop - h.start for _, h in runs])
        whole += np.einsum("ij,ij,i->j", columns, columns, sigma**-2.0).reshape(count, k).sum(axis=1)
        white = inner.whitening.alone(places, columns)
        _add(gram, cross, white, 1.0)
        for place, here in runs:
            inside = inner.taken[place].T @ white[here.start - rows.start : here.stop - rows.start]
            of_base, of_chance, of_run = inner.parts(place)
            by_base.append(inside[of_base])
            by_chance += inside[of_chance]
            own.append(inside[of_run])
            weights.append(inner.weights[inner.ends[place] : inner.ends[place + 1]])
    _add(gram, cross, np.vstack(own), -1.0)
    _add(gram, cross, np.vstack(weights).T @ np.vstack(by_base), -1.0)
    _add(gram, cross, inner.chance[:, np.newaxis] * by_chance, -1.0)
    return whole, gram, cross


def _add(gram: FloatArray, cross: FloatArray, columns: FloatArray, sign: float) -> None:
    """Products of columns (m, points k), at every point, and of each point with the next."""
    points, k = gram.shape[:2]
    each = columns.reshape(-1, points, k)
    for i in range(k):
        for j in range(k):
            if j >= i:
                found = sign * np.einsum("mp,mp->p", each[:, :, i], each[:, :, j])
                gram[:, i, j] += found
                if j > i:
                    gram[:, j, i] += found
            cross[:, i, j] += sign * np.einsum("mp,mp->p", each[:, :-1, i], each[:, 1:, j])


def _length(gram: FloatArray, cross: FloatArray) -> float:
    """Length of the curve that the signature, base projected out, draws on the unit sphere along the grid.

    gram: (points, k, k); cross: (points - 1, k, k), of each point with the next.
    """
    if not cross.size:
        return 0.0
    inverse = np.linalg.pinv(gram, rcond=UNOBSERVABLE, hermitian=True)
    shared = np.einsum("pij,pjk,plk,pli->p", inverse[:-1], cross, inverse[1:], cross)
    angle = np.arccos(np.sqrt(np.clip(shared / gram.shape[1], 0.0, 1.0)))
    return float(np.sum(angle))
