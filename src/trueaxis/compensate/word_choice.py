"""Words whose rounding error lies across the ball bar (Eqs. 5 and 6).

E of Eq. (6) is, to the rounding errors' size, the error vector's component along the bar. Among the lattice points within
`limit` of the wanted position some have their error nearly across it. In the unit lattice a ball of radius 1 holds 4.2
points on average, which bounds what choosing a block's end can do: about half the mean |E| of plain rounding.
"""

from itertools import product

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensate.machine import FloatArray

CHUNK = 4096


def offsets(reach: int) -> FloatArray:
    """All (dx, dy, dz) of whole numbers from -reach to reach, (3, m), the shortest first."""
    found = np.array(list(product(range(-reach, reach + 1), repeat=3)), dtype=np.float64)
    order = np.argsort((found**2).sum(axis=1), kind="stable")
    return np.ascontiguousarray(found[order].T)


def bar_error(target: FloatArray, error: FloatArray, ball: FloatArray) -> FloatArray:
    """E of Eq. (6), mm: |target + error - ball| - |target - ball|; arrays (3, ...), ball (3, 1 ...)."""
    bar = target - ball
    return np.asarray(_length(bar + error) - _length(bar))


def _length(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(vectors[0] ** 2 + vectors[1] ** 2 + vectors[2] ** 2))


def choose(
    error: FloatArray, target: FloatArray, ball: FloatArray, moves: FloatArray, reach: int, limit: float
) -> FloatArray:
    """Offset (3, n), in steps, of the candidate with the least |E| among those with an error of at most `limit` mm.

    error: (3, n), mm, at the nearest lattice point (offset 0). moves: (3, 3, n), tool motion in mm per step of each
    linear axis. All offsets up to `reach` steps are tried: 1 covers every candidate within one step of the target, 2 every
    one within a step of twice the size. Offset 0 where no candidate is within the limit.
    """
    tried = offsets(reach)
    out = np.zeros_like(error)
    for first in range(0, error.shape[1], CHUNK):
        part = slice(first, first + CHUNK)
        at = error[:, part, None] + np.einsum("ijn,jc->inc", moves[:, :, part], tried)
        value = np.abs(bar_error(target[:, part, None], at, ball[:, :, None]))
        value[_length(at) > limit] = np.inf
        best = np.argmin(value, axis=1)
        possible = np.isfinite(np.take_along_axis(value, best[:, None], axis=1)[:, 0])
        out[:, part] = np.where(possible, tried[:, best], 0.0)
    return out


def across(vectors: FloatArray, direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The part of vectors (3, n, ...) across unit directions of the same shape, and the length along them."""
    along = (vectors * direction).sum(axis=0)
    return vectors - along * direction, along


def possible_count(error: FloatArray, moves: FloatArray, reach: int, limit: float) -> NDArray[np.int64]:
    """Number of candidates that `choose` has for each point."""
    at = error[:, :, None] + np.einsum("ijn,jc->inc", moves, offsets(reach))
    return np.asarray((_length(at) <= limit).sum(axis=1))
