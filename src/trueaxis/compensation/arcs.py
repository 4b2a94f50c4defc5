"""Circular moves: from words to an arc, or to many at once, and from a CIRCLE of a cutter location file with the GOTOs
along it; how far rounding alone can put its ends at different radii.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.settings import MM_PER_INCH

Vector = tuple[float, float, float]

SAME_POINT = 1e-7  # mm; far below any word, far above the accumulated rounding of incremental positions
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


# In what follows a coordinate may be one number or those of many arcs, (n,).
Numbers = float | FloatArray
Point = tuple[Numbers, Numbers, Numbers]


def _cross(a: Point, b: Point) -> Point:
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _dot(a: Point, b: Point) -> Numbers:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _minus(a: Point, b: Point) -> Point:
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _size(a: Point) -> Numbers:
    return np.hypot(np.hypot(a[0], a[1]), a[2])


def _across(a: Point, normal: Point) -> Point:
    """The part of `a` in the plane across `normal`."""
    along = _dot(a, normal)
    return (a[0] - along * normal[0], a[1] - along * normal[1], a[2] - along * normal[2])


def sweep_between(start: Point, end: Point, centre: Point, normal: Point) -> FloatArray:
    """Angle in (0, 2 pi] from start to end, counter-clockwise about `normal`; a full turn if they coincide."""
    a = _across(_minus(start, centre), normal)
    b = _across(_minus(end, centre), normal)
    angle = np.arctan2(_dot(normal, _cross(a, b)), _dot(a, b))
    angle = np.where(angle > 0.0, angle, angle + 2.0 * math.pi)
    return np.where(_size(_minus(a, b)) <= SAME_POINT, 2.0 * math.pi, angle)


def end_radii(start: Point, end: Point, centre: Point, normal: Point) -> tuple[Numbers, Numbers]:
    """Distance of start and end from the line through the centre."""
    return _size(_across(_minus(start, centre), normal)), _size(_across(_minus(end, centre), normal))


def radii_fit(first: Numbers, last: Numbers, allowed: Numbers) -> NDArray[np.bool_]:
    """Whether the radii of both ends are those of one arc; allowed: what rounding explains, see allowed_about."""
    return (np.minimum(first, last) > SAME_POINT) & (np.abs(first - last) <= np.maximum(allowed, NEGLIGIBLE))


def arc_about(start: Vector, end: Vector, centre: Vector, normal: Vector, allowed: Numbers) -> Arc:
    """Arc from start to end about a centre (I, J, K words; CIRCLE); allowed: what rounding explains, see allowed_about.

    Raises ArcError when there is no radius or the radii of the ends differ by more than `allowed` mm.
    """
    first, last = end_radii(start, end, centre, normal)
    if min(first, last) <= SAME_POINT:
        raise ArcError("an arc of radius 0")
    if not radii_fit(first, last, allowed):
        raise ArcError(
            f"start and end of the arc lie at different radii, {first:.5f} and {last:.5f} mm; "
            f"rounding of its words explains {allowed:.5f} mm"
        )
    return Arc(centre, normal, float(sweep_between(start, end, centre, normal)))


def half_chord(start: Point, end: Point, normal: Point) -> Numbers:
    """Half of the way from start to end in the plane of an arc."""
    return _size(_across(_minus(end, start), normal)) / 2.0


def radius_fits(half: Numbers, radius: Numbers, allowed: Numbers) -> NDArray[np.bool_]:
    """Whether an R word makes an arc over half a chord; allowed: what rounding explains, see allowed_beyond_radius."""
    return np.asarray(
        (np.asarray(half) > SAME_POINT) & (np.asarray(radius) != 0.0) & (half - np.abs(radius) <= allowed)
    )


def centre_of_radius(start: Point, end: Point, radius: Numbers, normal: Point) -> Point:
    """Centre of the arc by an R word: at most half a turn for R > 0, at least half for R < 0; half a turn about the
    middle where the ends are too far apart.
    """
    chord = _across(_minus(end, start), normal)
    half = _size(chord) / 2.0
    rise = np.copysign(np.sqrt(np.maximum(radius * radius - half * half, 0.0)), radius) / (2.0 * half)
    left = _cross(normal, chord)
    return (
        start[0] + chord[0] / 2.0 + rise * left[0],
        start[1] + chord[1] / 2.0 + rise * left[1],
        start[2] + chord[2] / 2.0 + rise * left[2],
    )


def arc_of_radius(start: Vector, end: Vector, radius: float, normal: Vector, allowed: Numbers) -> Arc:
    """Arc from start to end by an R word; allowed: what half the chord may be longer than R by rounding, mm.

    Raises ArcError for a full circle (its centre is not determined), R = 0, or ends further apart than that.
    """
    half = half_chord(start, end, normal)
    if half <= SAME_POINT:
        raise ArcError("start and end of an arc by R coincide: its centre is not determined")
    if radius == 0.0:
        raise ArcError("an arc of R = 0")
    if not radius_fits(half, radius, allowed):
        raise ArcError(
            f"the ends of the arc are {2 * half:.5f} mm apart, more than 2 R = {2 * abs(radius):.5f}; "
            f"rounding of its words explains {2 * allowed:.5f} mm"
        )
    x, y, z = (float(one) for one in centre_of_radius(start, end, radius, normal))
    return Arc((x, y, z), normal, float(sweep_between(start, end, (x, y, z), normal)))


# Coarser rounding than this is not believed: whole numbers and tenths are what somebody has written exactly.
FEWEST_DECIMALS, FEWEST_DECIMALS_INCH = 2, 3
_SECOND_ORDER = 1.0  # of (rounding)^2 / radius, on either radius
_DOUBLES = 1e-9  # mm; what positions lose in doubles, far below any word


class WordRounding(NamedTuple):
    """Half a unit of the last decimal, mm, of the words of an arc: start and end by axis X Y Z, centre or radius.

    The axis across the plane has 0.
    """

    start: Point
    end: Point
    centre: Numbers


def half_unit(decimals: int | NDArray[np.int64], inch: bool) -> Numbers:
    """Half a unit of the last decimal, mm."""
    if inch:
        return 0.5 * MM_PER_INCH * 10.0 ** -np.maximum(decimals, FEWEST_DECIMALS_INCH)
    return 0.5 * 10.0 ** -np.maximum(decimals, FEWEST_DECIMALS)


def rounding_of(
    in_plane: Sequence[bool], decimals: int | NDArray[np.int64], before: Numbers, absolute: bool, inch: bool
) -> WordRounding:
    """Rounding of an arc's words; in_plane: for X Y Z whether the axis is one of the arc's plane; decimals: the most of
    its words; before: half a unit of the words that gave the start, mm.
    """
    unit = half_unit(decimals, inch)
    x, y, z = (float(inside) for inside in in_plane)
    first = before if absolute else 0.0
    return WordRounding((first * x, first * y, first * z), (unit * x, unit * y, unit * z), unit)


def allowed_about(start: Point, end: Point, centre: Point, rounding: WordRounding) -> Numbers:
    """Largest difference of the radii of start and end that rounding explains, mm."""
    first, first_radius = _direction(start, centre)
    last, last_radius = _direction(end, centre)
    size = sum(
        rounding.centre * np.abs(b - a) + (ds + de) * np.abs(b)
        for a, b, ds, de in zip(first, last, rounding.start, rounding.end, strict=True)
    )
    both = _largest(rounding.start) + _largest(rounding.end) + 2.0 * rounding.centre
    nearest = np.maximum(np.minimum(first_radius, last_radius), both)
    return size + _SECOND_ORDER * both * both / nearest + _DOUBLES


def allowed_beyond_radius(start: Point, end: Point, rounding: WordRounding) -> Numbers:
    """Largest amount, mm, by which rounding explains that half the chord of an arc by R is longer than R."""
    along, length = _direction(end, start)
    size = sum(0.5 * (ds + de) * np.abs(u) for u, ds, de in zip(along, rounding.start, rounding.end, strict=True))
    both = _largest(rounding.start) + _largest(rounding.end)
    least = np.maximum(np.maximum(length, both), _DOUBLES)
    return rounding.centre + size + _SECOND_ORDER * both * both / least + _DOUBLES


def _largest(of: Point) -> Numbers:
    return np.maximum(np.maximum(of[0], of[1]), of[2])


def _direction(point: Point, centre: Point) -> tuple[Point, Numbers]:
    """Unit vector from the centre to a point, and the distance; 0 where they coincide."""
    off = _minus(point, centre)
    length = _size(off)
    least = np.where(np.asarray(length) > 0.0, length, 1.0)
    return (off[0] / least, off[1] / least, off[2] / least), length


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
