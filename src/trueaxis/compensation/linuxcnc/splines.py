"""The arcs that LinuxCNC makes of splines and NURBS (G5, G5.1, G5.2 and G5.3).

Its module `gcode` gives points of the curve, 15 for each control point, and `rs274` the number of control points.
On the machine LinuxCNC goes along other points, 4 for each control point, joined by two arcs each (a biarc). The curve
is therefore found from the points of the module, a linear problem because they lie on it, and cut as on the machine.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray

POINTS = 15  # of the module, for each control point
PIECES = 4  # of LinuxCNC's control, for each control point
LEAST_ORDER = 3
_DIFFERENCE = 1e-5  # of the parameter, to both sides: over which LinuxCNC takes differences for tangents
ON_CURVE = 1e-7  # mm: points are doubles that went through inches
# of a singular value to the largest: combinations of weights that move no point by more than ON_CURVE
_FREE = 1e-10
# 1 - cosine of the angle between the tangents at both ends of a piece: LinuxCNC divides by it, and rounding of doubles
# may turn its sign where it is smaller
_PARALLEL = 1e-14
_STRAIGHT = 1e-6  # mm2, or the square of the unit of the program: four times the area below which LinuxCNC makes a line


@dataclass(frozen=True, slots=True)
class Curve:
    """A rational spline: control points (n, 3) as weight, weight x, weight y; order; X and Y in mm."""

    control: FloatArray
    order: int

    @property
    def last(self) -> float:
        """The parameter at its end; it begins at 0."""
        return float(len(self.control) - self.order + 1)

    def at(self, parameter: FloatArray) -> FloatArray:
        """X and Y, (n, 2), at parameters (n,)."""
        weighted = _basis(parameter, len(self.control), self.order) @ self.control
        return np.asarray(weighted[:, 1:] / weighted[:, :1])

    def tangents(self, parameter: FloatArray) -> FloatArray:
        """Directions (n, 2), as differences over the short way over which LinuxCNC takes them."""
        low, high = np.maximum(parameter - _DIFFERENCE, 0.0), np.minimum(parameter + _DIFFERENCE, self.last)
        way = self.at(high) - self.at(low)
        return np.asarray(way / np.linalg.norm(way, axis=1, keepdims=True))


def parameters_of(count: int, order: int) -> list[float]:
    """Parameters of the points that the module gives of a spline with so many control points, but for its end."""
    end = float(count - order + 1)
    step, at, found = end / (POINTS * count), 0.0, []
    while at + step < end:
        at += step
        found.append(at)
    return found


def biarcs(curve: Curve) -> Iterator[tuple[tuple[float, float], tuple[float, float] | None, int]]:
    """Ends, centres (None: a line) and turns (1 counter-clockwise, -1) of the motions that LinuxCNC makes of a curve.

    Raises ValueError where it makes none that are right.
    """
    pieces = PIECES * len(curve.control)
    parameter = curve.last * np.arange(pieces + 1) / pieces
    points, tangents = curve.at(parameter), curve.tangents(parameter)
    if not np.isfinite(tangents).all():
        raise ValueError("a spline with a cusp, where it has no direction,")
    for (start, along), (end, onwards) in pairwise(zip(points, tangents, strict=True)):
        middle, between = _joint(start, along, end, onwards)
        yield _arc(start, middle, along)
        yield _arc(middle, end, between)


def _joint(start: FloatArray, along: FloatArray, end: FloatArray, onwards: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Where the two arcs of a piece join, and their direction there: both have tangents of the same length."""
    way = end - start
    apart, forth = 2.0 * (1.0 - along @ onwards), way @ (along + onwards)
    if apart < _PARALLEL:
        raise ValueError("a spline with a straight piece, on which LinuxCNC itself divides by zero,")
    # |way - size (along + onwards)| = 2 size
    square = way @ way
    size = square / (forth + np.sqrt(forth * forth + apart * square))
    first, last = start + size * along, end - size * onwards
    between = last - first
    return 0.5 * (first + last), between / np.linalg.norm(between)


def _arc(
    start: FloatArray, end: FloatArray, along: FloatArray
) -> tuple[tuple[float, float], tuple[float, float] | None, int]:
    """The arc from start to end that leaves along a direction."""
    way = end - start
    across = np.array([-along[1], along[0]])
    rise = 2.0 * float(way @ across)
    ends = (float(end[0]), float(end[1]))
    if abs(rise) <= _STRAIGHT:
        return ends, None, 0
    centre = start + float(way @ way) / rise * across  # as far from start and end, across the direction at the start
    return ends, (float(centre[0]), float(centre[1])), 1 if rise > 0.0 else -1


def curve_of(points: FloatArray, count: int) -> tuple[Curve, int]:
    """The spline with so many control points, and the number of points that belong to it.

    points: the module's, (n, 2), mm: the start of the spline, and those after it, of which the last may be of other
    motions. Raises ValueError where there is no such spline.
    """
    for order in range(LEAST_ORDER, count + 1):
        parameter = np.array([0.0, *parameters_of(count, order), count - order + 1.0])
        own = points[: len(parameter)]
        if len(own) < len(parameter):
            continue
        basis = _basis(parameter, count, order)
        for find in (_plain, _weighted):
            curve = Curve(find(basis, own), order)
            if curve.control[:, 0].min() > 0.0 and np.abs(curve.at(parameter) - own).max() < ON_CURVE:
                return curve, len(own)
    raise ValueError("a spline that is not found from its points")


def _plain(basis: FloatArray, points: FloatArray) -> FloatArray:
    """Control points of a spline without weights."""
    found, *_ = np.linalg.lstsq(basis / basis.sum(axis=1, keepdims=True), points, rcond=None)
    return np.column_stack([np.ones(len(found)), found])


def _weighted(basis: FloatArray, points: FloatArray) -> FloatArray:
    """Control points with weights: of all that give these points those with weights nearest to 1."""
    count = basis.shape[1]
    centre = points.mean(axis=0)
    size = max(float(np.abs(points - centre).max()), ON_CURVE)
    x, y = ((points - centre) / size).T
    none = np.zeros_like(basis)
    equations = np.block([[-x[:, None] * basis, basis, none], [-y[:, None] * basis, none, basis]])
    _, singular, rows = np.linalg.svd(equations, full_matrices=False)
    free = rows[singular <= max(_FREE * singular[0], singular[-1])]
    mix, *_ = np.linalg.lstsq(free[:, :count].T, np.ones(count), rcond=None)
    weight, wx, wy = (mix @ free).reshape(3, count)
    return np.column_stack([weight, size * wx + centre[0] * weight, size * wy + centre[1] * weight])


def _basis(parameter: FloatArray, count: int, order: int) -> FloatArray:
    """Values (n, count) of the basis splines of an order, knots at whole numbers, at parameters (n,)."""
    knots = np.clip(np.arange(count + order) - order + 1, 0, count - order + 1).astype(float)
    at = parameter[:, None]
    values: NDArray[np.float64] = ((at >= knots[:-1]) & (at <= knots[1:])).astype(float)
    for degree in range(1, order):
        width = knots[degree:] - knots[:-degree]
        share = np.divide(at - knots[:-degree], width, out=np.zeros((len(parameter), width.size)), where=width > 0.0)
        fall = np.where(width > 0.0, 1.0 - share, 0.0)
        values = share[:, :-1] * values[:, :-1] + fall[:, 1:] * values[:, 1:]
    return values
