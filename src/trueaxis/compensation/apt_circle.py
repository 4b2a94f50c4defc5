"""CIRCLE of a cutter location file with the GOTOs that run along it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from trueaxis.compensation.arcs import Arc, ArcError, Vector, arc_about

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
