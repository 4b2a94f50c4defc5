"""Words whose rounding error lies across the ball bar (Eqs. 5 and 6).

E of Eq. (6) is, to the rounding errors' size, the error vector's component along the bar. Among the lattice points
within `limit` of the wanted position some have their error nearly across it. In the unit lattice a ball of radius 1
holds 4.2 points on average, which bounds what choosing the end of a block can do: half the mean |E| of plain rounding.
"""

from functools import cache
from itertools import product

import numpy as np

from trueaxis.compensation.machine import FloatArray

CHUNK = 64  # points at a time: larger temporaries leave the allocator's pool and the cache and take twice as long


@cache
def offsets(reach: int) -> FloatArray:
    """All (dx, dy, dz) of whole numbers from -reach to reach, (3, m), the shortest first."""
    found = np.array(list(product(range(-reach, reach + 1), repeat=3)), dtype=np.float64)
    order = np.argsort((found**2).sum(axis=1), kind="stable")
    shortest_first = np.ascontiguousarray(found[order].T)
    shortest_first.flags.writeable = False
    return shortest_first


def bar_error(target: FloatArray, error: FloatArray, ball: FloatArray) -> FloatArray:
    """E of Eq. (6), mm: |target + error - ball| - |target - ball|; arrays (3, ...), ball (3, 1 ...)."""
    bar = target - ball
    return np.asarray(_length(bar + error) - _length(bar))


def _length(vectors: FloatArray) -> FloatArray:
    return np.asarray(np.sqrt(vectors[0] ** 2 + vectors[1] ** 2 + vectors[2] ** 2))


def choose(
    error: FloatArray,
    target: FloatArray,
    ball: FloatArray,
    moves: FloatArray,
    reach: int,
    limit: float,
    kept: int = 1,
) -> tuple[FloatArray, FloatArray]:
    """Offsets (3, kept, n), in steps, of the candidates with the least |E|, and that |E|, mm, (kept, n).

    error: (3, n), mm, at the nearest lattice point (offset 0). moves: (3, 3, n), tool motion in mm per step of each
    linear axis. Candidates are the offsets up to `reach` steps whose error vector is at most `limit` mm long. Reach 1
    covers everything within one step of the target, reach 2 everything within two. Where candidates are fewer than
    `kept`, offset 0 fills up, with an |E| of infinity.
    """
    tried = offsets(reach)
    count = error.shape[1]
    out, least = np.zeros((3, kept, count)), np.full((kept, count), np.inf)
    for first in range(0, count, CHUNK):
        part = slice(first, first + CHUNK)
        at = error[:, part, None] + np.einsum("ijn,jc->inc", moves[:, :, part], tried)
        value = np.abs(bar_error(target[:, part, None], at, ball[:, :, None]))
        value[_length(at) > limit] = np.inf
        best = np.argmin(value, axis=1)[:, None] if kept == 1 else np.argpartition(value, kept, axis=1)[:, :kept]
        found = np.take_along_axis(value, best, axis=1).T
        least[:, part] = found
        out[:, :, part] = np.where(np.isfinite(found), tried[:, best.T], 0.0)
    return out, least


def across(vectors: FloatArray, direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The part of vectors (3, n, ...) across unit directions of the same shape, and the length along them."""
    along = vectors[0] * direction[0] + vectors[1] * direction[1] + vectors[2] * direction[2]
    return vectors - along * direction, along
