"""Words whose rounding error lies across the ball bar (Eqs. 5 and 6), and points passed amid short blocks."""

from dataclasses import dataclass
from functools import cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.lattice import Lattice
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
    return np.asarray(length(bar + error) - length(bar))


def length(vectors: FloatArray) -> FloatArray:
    """Of vectors (3, ...)."""
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
        value[length(at) > limit] = np.inf
        best = np.argmin(value, axis=1)[:, None] if kept == 1 else np.argpartition(value, kept, axis=1)[:, :kept]
        found = np.take_along_axis(value, best, axis=1).T
        least[:, part] = found
        out[:, :, part] = np.where(np.isfinite(found), tried[:, best.T], 0.0)
    return out, least


def across(vectors: FloatArray, direction: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The part of vectors (3, n, ...) across unit directions of the same shape, and the length along them."""
    along = vectors[0] * direction[0] + vectors[1] * direction[1] + vectors[2] * direction[2]
    return vectors - along * direction, along


HALF_LENGTH = 0.02  # mm
CORNER = 0.25
LEAST_STEPS = 4.0  # half length in steps below which direction is lost to rounding
ENDS_WEIGHT = 0.5  # of the larger |E| at the ends of the short block beside |E| in its middle
LINEAR_MARGIN = 0.995  # of the limit for errors at the ends, which are extrapolated from P
_MIDDLES = 6  # middles for which ends are sought
_SHARES = (1.0, 0.9, 0.8, 0.7, 0.6)  # of the half length; a step of 0.001 mm apart by 2 steps, +-1 is tried about each


@dataclass(frozen=True, slots=True, kw_only=True)
class Passage:
    """Ends of the short blocks: commands of the linear axes (3, n), mm, and the way along the path, mm, from P."""

    before: FloatArray
    after: FloatArray
    way_before: FloatArray
    way_after: FloatArray
    possible: NDArray[np.bool_]


def passages_allowed(
    points: FloatArray, passable: NDArray[np.bool_], rotary_still: NDArray[np.bool_], resolution: float
) -> tuple[NDArray[np.bool_], FloatArray, FloatArray]:
    """Which points may be passed in a short block, the direction of the path there (3, n), and the half length (n,).

    points: (3, n), commands of the linear axes. The first and last point may not: they have one neighbour here.
    """
    count = points.shape[1]
    allowed = np.zeros(count, dtype=bool)
    direction = np.zeros((3, count))
    half = np.zeros(count)
    if count < 3:
        return allowed, direction, half
    steps = np.diff(points, axis=1)
    length = np.sqrt((steps**2).sum(axis=0))
    unit = steps / np.maximum(length, 1e-12)
    mean = unit[:, :-1] + unit[:, 1:]
    norm = np.sqrt((mean**2).sum(axis=0))
    direction[:, 1:-1] = mean / np.maximum(norm, 1e-12)
    sine = np.sqrt(np.maximum(1.0 - (norm / 2.0) ** 2, 0.0))  # of half the corner's angle
    half[1:-1] = np.minimum(HALF_LENGTH, CORNER * resolution / np.maximum(sine, 1e-12))
    room = np.minimum(length[:-1], length[1:]) >= 4.0 * half[1:-1]
    allowed[1:-1] = room & (half[1:-1] >= LEAST_STEPS * resolution) & passable[1:-1] & rotary_still[1:-1]
    return allowed, direction, half


def passages(
    commands: FloatArray,
    half_error: FloatArray,
    target: FloatArray,
    ball: FloatArray,
    jacobian: FloatArray,
    direction: FloatArray,
    half: FloatArray,
    lattice: Lattice,
    limit: float,
) -> Passage:
    """Choose A and B for every point.

    All arrays are of the points to be passed: commands (3, n) of the linear axes; half_error (3, n), actual minus
    wanted tool point at the nearest point of the half lattice; jacobian (3, 3, n); direction (3, n) and half length
    (n,) of the short block in axis space; lattice of the linear axes; limit, mm, for every error vector.
    """
    step = lattice.step
    near = lattice.nearest(commands, 2)
    moves = jacobian * (step[None, :, :] / 2.0)
    chosen, middle_error = choose(half_error, target, ball, moves, 2, limit, _MIDDLES)
    residual = half_error - np.einsum("ijn,jn->in", jacobian, near - commands)
    bar = target - ball
    bar = bar / np.maximum(np.sqrt((bar**2).sum(axis=0)), 1e-12)
    wanted = (commands - lattice.base) / step
    on_half = np.rint(2.0 * (near - lattice.base) / step)
    count = commands.shape[1]
    least = np.full(count, np.inf)
    start, end = np.zeros((3, count)), np.zeros((3, count))
    for first in range(0, count, CHUNK):
        part = slice(first, first + CHUNK)
        for number in range(_MIDDLES):
            twice = on_half[:, part] + chosen[:, number, part]  # A + B in steps
            before, worst = _ends_of_short_block(
                twice, wanted[:, part], residual[:, part], step, bar[:, part], jacobian[:, :, part],
                direction[:, part], half[part], LINEAR_MARGIN * limit,
            )  # fmt: skip
            cost = middle_error[number, part] + ENDS_WEIGHT * worst
            better = cost < least[part]
            least[part] = np.where(better, cost, least[part])
            start[:, part] = np.where(better, before, start[:, part])
            end[:, part] = np.where(better, twice - before, end[:, part])
    start, end = lattice.base + start * step, lattice.base + end * step
    way_before = ((start - commands) * direction).sum(axis=0)
    way_after = ((end - commands) * direction).sum(axis=0)
    return Passage(before=start, after=end, way_before=way_before, way_after=way_after, possible=np.isfinite(least))


def _ends_of_short_block(
    twice: FloatArray,
    wanted: FloatArray,
    residual: FloatArray,
    step: FloatArray,
    bar: FloatArray,
    jacobian: FloatArray,
    direction: FloatArray,
    half: FloatArray,
    limit: float,
) -> tuple[FloatArray, FloatArray]:
    """A in steps, (3, n), with the least of max(|E| at A, |E| at B), and that, (n,), mm; infinite if none may be."""
    shift = np.concatenate(
        [
            np.rint(twice / 2.0 - share * half * direction / step)[:, :, None] + offsets(1)[:, None, :]
            for share in _SHARES
        ],
        axis=2,
    )
    # sums over three terms written out: several times faster than einsum on arrays of this shape
    along_bar = np.einsum("in,ijn->jn", bar, jacobian)
    bar_residual = (bar * residual).sum(axis=0)[:, None]
    worst = np.zeros(shift.shape[1:])
    for sign, end in ((-1.0, shift), (1.0, twice[:, :, None] - shift)):
        off, way = across((end - wanted[:, :, None]) * step[:, :, None], direction[:, :, None])
        value = np.abs(bar_residual + _product(along_bar, off))
        square = sum((residual[i, :, None] + _product(jacobian[i], off)) ** 2 for i in range(3))
        value[(square > limit * limit) | (sign * way <= 0.0)] = np.inf
        np.maximum(worst, value, out=worst)
    best = np.argmin(worst, axis=1)
    found = np.take_along_axis(shift, best[None, :, None], axis=2)[:, :, 0]
    return found, np.take_along_axis(worst, best[:, None], axis=1)[:, 0]


def _product(row: FloatArray, vectors: FloatArray) -> FloatArray:
    """Product of row vectors (3, n) with vectors (3, n, c), (n, c)."""
    return np.asarray(row[0, :, None] * vectors[0] + row[1, :, None] * vectors[1] + row[2, :, None] * vectors[2])
