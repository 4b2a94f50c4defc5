"""Products of whitened signatures, base and runs' own unknowns taken away, for whole grids.

By far most of the time of a search goes here. So run by run, row by row in memory, and each product once: the base and
what is taken away in a run are a few directions there, whose products with the signature are all that is needed.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from trueaxis.diagnosis.projection import Projection
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.rows import runs_among
from trueaxis.diagnosis.signatures import Signature
from trueaxis.diagnosis.whiten import Whitening
from trueaxis.estimation.effects.variable_projection import UNOBSERVABLE

ENTRIES = 1 << 17  # of a run's columns at a time: 1 MB, which stay in the processor's cache
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


@dataclass(frozen=True, slots=True, eq=False)
class Inner:
    """Whitening and base, without causes. few: (m, r + s) of each run: its directions of the base, r, and those in which
    readings vary by chance, s, as they are before anything is taken away in the run; aside: (m, a), that; ends: of each
    run's r among the weights; weights: (sum of r, rank); chance: (s,), how much of each direction is taken away.
    """

    whitening: Whitening
    few: tuple[FloatArray, ...]
    aside: tuple[FloatArray, ...]
    ends: tuple[int, ...]
    weights: FloatArray
    chance: FloatArray


def inner_of(whitening: Whitening, base: Projection) -> Inner:
    """Once for all candidates."""
    few, aside = [], []
    soft = base.soft if base.soft.size else np.zeros((int(whitening.starts[-1]), 0))
    for place, (first, last) in enumerate(pairwise(whitening.starts.tolist())):
        basis, root = whitening.aside(place)
        aside.append(basis * np.sqrt(root * (2.0 - root)))
        both = np.hstack([base.basis.few[place], soft[first:last]])
        few.append(both - basis @ (root[:, np.newaxis] * (basis.T @ both)))
    chance = np.sqrt(1.0 - (1.0 - base.shrink) ** 2) if soft.shape[1] else np.zeros(0)
    return Inner(whitening, tuple(few), tuple(aside), tuple(base.basis.ends.tolist()), base.basis.weights, chance)


def prepared(signature: Signature, inner: Inner) -> Prepared:
    """The candidate's signature whitened and the base taken away.

    The cost grows with the readings that it reaches times rank of the base in a run times points of the grid.
    """
    points, k = len(signature.points), signature.terms.shape[2]
    whole, gram, cross = np.zeros(points), np.zeros((points, k, k)), np.zeros((max(points - 1, 0), k, k))
    runs = list(runs_among(inner.whitening.starts, signature.support))
    size = max([inner.few[place].shape[0] for place, _ in runs], default=1)
    step = max(ENTRIES // max(size * k, 1), 1)
    for start in range(0, points, step):
        # with the first of the next, for the products of neighbours
        chosen = slice(start, min(start + step + 1, points))
        squares, products, beside = _of_points(signature, inner, runs, chosen)
        own = slice(start, min(start + step, points))
        whole[own], gram[own] = squares[:step], products[:step]
        cross[start : start + len(beside)] = beside
    # what the base and the runs hold is rounding, and what dies away before the first reading is nothing
    held = np.trace(gram, axis1=1, axis2=2) <= np.maximum(UNOBSERVABLE * whole, NOTHING)
    gram = np.where(held[:, np.newaxis, np.newaxis], 0.0, gram)
    return Prepared(whole, gram, _length(gram, cross))


def _of_points(
    signature: Signature, inner: Inner, runs: list[tuple[int, slice]], points: slice
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """(points,) and (points, k, k), whole and gram, and (points - 1, k, k), the gram of each point with the next."""
    count, k = points.stop - points.start, signature.terms.shape[2]
    whole, gram, cross = np.zeros(count), np.zeros((count, k, k)), np.zeros((count - 1, k, k))
    by_base, by_chance = [np.zeros((0, count * k))], np.zeros((inner.chance.size, count * k))
    weights = [inner.weights[:0]]
    for place, here in runs:
        columns = signature.rows_of(here, points)
        whole += np.einsum("ij,ij->j", columns, columns).reshape(count, k).sum(axis=1) / (
            inner.whitening.runs[place].sigma ** 2
        )
        white = inner.whitening.by_rows(place, columns)
        first, last = inner.ends[place : place + 2]
        inside = inner.few[place].T @ white
        by_base.append(inside[: last - first])
        by_chance += inside[last - first :]
        weights.append(inner.weights[first:last])
        _add(gram, cross, white, 1.0)
        _add(gram, cross, inner.aside[place].T @ white, -1.0)
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
    inverse = np.linalg.pinv(gram, rcond=UNOBSERVABLE, hermitian=True)
    shared = np.einsum("pij,pjk,plk,pli->p", inverse[:-1], cross, inverse[1:], cross)
    angle = np.arccos(np.sqrt(np.clip(shared / gram.shape[1], 0.0, 1.0)))
    return float(np.sum(angle))
