"""Circular moves: from words, or a CIRCLE of a cutter location file with the GOTOs along it, to an arc; how far
rounding alone can put its ends at different radii; from an arc to chords.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.settings import MM_PER_INCH

Vector = tuple[float, float, float]

SAME_POINT = 1e-7  # mm; far below any word, far above the accumulated rounding of incremental positions
MOST_CHORDS = 200_000
NEGLIGIBLE = (
    1e-4  # mm: a tenth of what is asked for; radii that differ by less are those of one arc, whatever its words
)


class ArcError(ValueError):
    """The words of a circular block do not make an arc."""


class Arc(NamedTuple):
    """Counter-clockwise about `normal` (unit vector) through `sweep` rad round `centre` (mm, X Y Z).

    The radius runs linearly from the start's to the end's and so does the position along the normal (helix).
    """

    centre: Vector
    normal: Vector
    sweep: float


def _cross(a: Vector, b: Vector) -> Vector:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a: Vector, b: Vector) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _minus(a: Vector, b: Vector) -> Vector:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _across(a: Vector, normal: Vector) -> Vector:
    """The part of `a` in the plane across `normal`."""
    along = _dot(a, normal)
    return (a[0] - along * normal[0], a[1] - along * normal[1], a[2] - along * normal[2])


def sweep_between(start: Vector, end: Vector, centre: Vector, normal: Vector) -> float:
    """Angle in (0, 2 pi] from start to end, counter-clockwise about `normal`; a full turn if they coincide."""
    a = _across(_minus(start, centre), normal)
    b = _across(_minus(end, centre), normal)
    if math.dist(a, b) <= SAME_POINT:
        return 2.0 * math.pi
    angle = math.atan2(_dot(normal, _cross(a, b)), _dot(a, b))
    return angle if angle > 0.0 else angle + 2.0 * math.pi


def arc_about(start: Vector, end: Vector, centre: Vector, normal: Vector, allowed: float) -> Arc:
    """Arc from start to end about a centre (I, J, K words; CIRCLE); allowed: what rounding explains, see arc_rounding.

    Raises ArcError when there is no radius or the radii of the ends differ by more than `allowed` mm.
    """
    first = math.hypot(*_across(_minus(start, centre), normal))
    last = math.hypot(*_across(_minus(end, centre), normal))
    if min(first, last) <= SAME_POINT:
        raise ArcError("an arc of radius 0")
    if not abs(first - last) <= max(allowed, NEGLIGIBLE):
        raise ArcError(
            f"start and end of the arc lie at different radii, {first:.5f} and {last:.5f} mm; "
            f"rounding of its words explains {allowed:.5f} mm"
        )
    return Arc(centre, normal, sweep_between(start, end, centre, normal))


def arc_of_radius(start: Vector, end: Vector, radius: float, normal: Vector, allowed: float) -> Arc:
    """Arc from start to end by an R word: at most half a turn for R > 0, at least half for R < 0.

    allowed: what half the chord may be longer than R by rounding, mm; the arc is then half a turn about its middle.
    Raises ArcError for a full circle (its centre is not determined), R = 0, or ends further apart than that.
    """
    chord = _across(_minus(end, start), normal)
    half = math.hypot(*chord) / 2.0
    if half <= SAME_POINT:
        raise ArcError("start and end of an arc by R coincide: its centre is not determined")
    if radius == 0.0:
        raise ArcError("an arc of R = 0")
    if not half - abs(radius) <= allowed:
        raise ArcError(
            f"the ends of the arc are {2 * half:.5f} mm apart, more than 2 R = {2 * abs(radius):.5f}; "
            f"rounding of its words explains {2 * allowed:.5f} mm"
        )
    rise = math.copysign(math.sqrt(max(radius * radius - half * half, 0.0)), radius) / (2.0 * half)
    left = _cross(normal, chord)
    centre = (
        start[0] + chord[0] / 2.0 + rise * left[0],
        start[1] + chord[1] / 2.0 + rise * left[1],
        start[2] + chord[2] / 2.0 + rise * left[2],
    )
    return Arc(centre, normal, sweep_between(start, end, centre, normal))


def chord_counts(radius: FloatArray, sweep: FloatArray, tolerance: float) -> NDArray[np.int64]:
    """Equal chords that stay within `tolerance` mm of arcs: sagitta r (1 - cos(step / 2)), at most a quarter turn."""
    ratio = np.minimum(tolerance / np.maximum(radius, SAME_POINT), 1.0)
    step = np.minimum(2.0 * np.arccos(1.0 - ratio), math.pi / 2.0)
    return np.maximum(np.ceil(sweep / np.maximum(step, 1e-9) - 1e-9), 1.0).astype(np.int64)


class Chords(NamedTuple):
    """Ends of the chords of many arcs, one after another: arc index (n,), share of the arc (n,), X Y Z (3, n)."""

    arc: NDArray[np.int64]
    share: FloatArray
    points: FloatArray


def chords(starts: FloatArray, ends: FloatArray, arcs: Sequence[Arc], tolerance: float) -> Chords:
    """Cut arcs into chords whose ends lie on them; starts and ends are X Y Z, mm, (3, n_arcs)."""
    centre = np.array([arc.centre for arc in arcs]).T.reshape(3, -1)
    normal = np.array([arc.normal for arc in arcs]).T.reshape(3, -1)
    sweep = np.array([arc.sweep for arc in arcs])
    rise0 = np.einsum("in,in->n", starts - centre, normal)
    rise1 = np.einsum("in,in->n", ends - centre, normal)
    across0 = starts - centre - rise0 * normal
    across1 = ends - centre - rise1 * normal
    radius0 = np.sqrt(np.einsum("in,in->n", across0, across0))
    radius1 = np.sqrt(np.einsum("in,in->n", across1, across1))
    first = across0 / radius0
    second = np.cross(normal, first, axis=0)
    count = chord_counts(np.maximum(radius0, radius1), sweep, tolerance)

    arc = np.repeat(np.arange(len(arcs)), count)
    number = np.arange(arc.size) - np.repeat(np.cumsum(count) - count, count) + 1
    share = number / count[arc]
    angle = share * sweep[arc]
    radius = radius0[arc] + share * (radius1 - radius0)[arc]
    rise = rise0[arc] + share * (rise1 - rise0)[arc]
    points = (
        centre[:, arc]
        + radius * (np.cos(angle) * first[:, arc] + np.sin(angle) * second[:, arc])
        + rise * normal[:, arc]
    )
    last = number == count[arc]
    points[:, last] = ends
    return Chords(arc, share, points)


# Coarser rounding than this is not believed: whole numbers and tenths are what somebody has written exactly.
FEWEST_DECIMALS, FEWEST_DECIMALS_INCH = 2, 3
_SECOND_ORDER = 1.0  # of (rounding)^2 / radius, on either radius
_DOUBLES = 1e-9  # mm; what positions lose in doubles, far below any word


class WordRounding(NamedTuple):
    """Half a unit of the last decimal, mm, of the words of an arc: start and end by axis X Y Z, centre or radius.

    The axis across the plane has 0.
    """

    start: Vector
    end: Vector
    centre: float


def half_unit(decimals: int, inch: bool) -> float:
    """Half a unit of the last decimal, mm."""
    if inch:
        return 0.5 * MM_PER_INCH * 10.0 ** -max(decimals, FEWEST_DECIMALS_INCH)
    return 0.5 * 10.0 ** -max(decimals, FEWEST_DECIMALS)


def rounding_of(
    in_plane: Sequence[bool], decimals: Mapping[str, int], before: float, absolute: bool, inch: bool
) -> WordRounding:
    """Rounding of an arc's words; in_plane: for X Y Z whether the axis is one of the arc's plane; decimals: of its
    words; before: half a unit of the words that gave the start, mm.
    """
    unit = half_unit(max(decimals.values(), default=0), inch)
    x, y, z = (float(inside) for inside in in_plane)
    first = before if absolute else 0.0
    return WordRounding((first * x, first * y, first * z), (unit * x, unit * y, unit * z), unit)


def allowed_about(start: Vector, end: Vector, centre: Vector, rounding: WordRounding) -> float:
    """Largest difference of the radii of start and end that rounding explains, mm."""
    first, first_radius = _direction(start, centre)
    last, last_radius = _direction(end, centre)
    size = sum(
        rounding.centre * abs(b - a) + (ds + de) * abs(b)
        for a, b, ds, de in zip(first, last, rounding.start, rounding.end, strict=True)
    )
    both = max(rounding.start) + max(rounding.end) + 2.0 * rounding.centre
    return size + _SECOND_ORDER * both * both / max(min(first_radius, last_radius), both) + _DOUBLES


def allowed_beyond_radius(start: Vector, end: Vector, rounding: WordRounding) -> float:
    """Largest amount, mm, by which rounding explains that half the chord of an arc by R is longer than R."""
    along, length = _direction(end, start)
    size = sum(0.5 * (ds + de) * abs(u) for u, ds, de in zip(along, rounding.start, rounding.end, strict=True))
    both = max(rounding.start) + max(rounding.end)
    return rounding.centre + size + _SECOND_ORDER * both * both / max(length, both, _DOUBLES) + _DOUBLES


def _direction(point: Vector, centre: Vector) -> tuple[Vector, float]:
    x, y, z = (p - c for p, c in zip(point, centre, strict=True))
    length = math.hypot(x, y, z)
    if length == 0.0:
        return (0.0, 0.0, 0.0), 0.0
    return (x / length, y / length, z / length), length


_ROUNDED_AXIS = 1e-6  # a direction of unit length as CL files give it, six decimals
_FULL = 2.0 * math.pi + 1e-6


def unit(vector: Sequence[float]) -> Vector:
    """A direction made a unit vector.

    Raises ArcError when it is not within 0.001 of one already.
    """
    length = math.hypot(*vector)
    if not abs(length - 1.0) <= 1e-3:
        raise ArcError("a direction must be a unit vector")
    return (vector[0] / length, vector[1] / length, vector[2] / length)


@dataclass(frozen=True, slots=True)
class Circle:
    """Centre (mm), axis (unit vector), radius (mm); rounding: half a unit of the last decimal of these numbers, mm."""

    centre: Vector
    axis: Vector
    radius: float
    rounding: float

    def distance(self, point: Vector) -> float:
        """Distance of a point from the cylinder over the circle, mm."""
        to_point = tuple(p - c for p, c in zip(point, self.centre, strict=True))
        along = sum(p * a for p, a in zip(to_point, self.axis, strict=True))
        across = math.hypot(*(p - along * a for p, a in zip(to_point, self.axis, strict=True)))
        return abs(across - self.radius)

    def allowed(self, rounding: float) -> float:
        """Distance that rounding explains, mm, of a point whose coordinates are rounded by so much.

        Three coordinates of either point, the radius, and what a rounded axis moves a point at the end of the radius.
        """
        return math.sqrt(3.0) * (rounding + self.rounding) + self.rounding + _ROUNDED_AXIS * self.radius

    def holds(self, point: Vector, rounding: float) -> bool:
        """Whether a point lies on the circle as far as rounding lets one know."""
        return self.distance(point) <= self.allowed(rounding)


def arcs_through(start: Vector, points: Sequence[Vector], circle: Circle) -> list[Arc]:
    """One arc for each GOTO of a circle; start and points lie on it (`Circle.holds`).

    The sense is counter-clockwise about the axis unless that takes more than a full turn to pass all points in order
    and the other way does not: some systems give the same axis for both senses.
    Raises ArcError when neither sense passes them in one turn.
    """
    problem = ""
    for sense in (1.0, -1.0):
        normal = (sense * circle.axis[0], sense * circle.axis[1], sense * circle.axis[2])
        found = []
        place = start
        for point in points:
            found.append(arc_about(place, point, circle.centre, normal, math.inf))
            place = point
        total = sum(arc.sweep for arc in found)
        if total <= _FULL:
            return found
        problem = problem or f"the points of the circle take {math.degrees(total):.0f} deg to pass in order"
    raise ArcError(problem)
