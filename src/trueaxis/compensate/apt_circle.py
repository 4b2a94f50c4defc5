"""CIRCLE of a cutter location file with the GOTOs that run along it."""

import math
from collections.abc import Sequence

from trueaxis.compensate.arcs import RADIUS_MISMATCH, Arc, ArcError, Vector, arc_about

_FULL = 2.0 * math.pi + 1e-6


def unit(vector: Sequence[float]) -> Vector:
    """A direction made a unit vector.

    Raises ArcError when it is not within 0.001 of one already.
    """
    length = math.hypot(*vector)
    if not abs(length - 1.0) <= 1e-3:
        raise ArcError("a direction must be a unit vector")
    return (vector[0] / length, vector[1] / length, vector[2] / length)


def on_circle(point: Vector, centre: Vector, axis: Vector, radius: float) -> bool:
    """Whether a point lies on the cylinder over the circle, to `RADIUS_MISMATCH` mm."""
    to_point = tuple(p - c for p, c in zip(point, centre, strict=True))
    along = sum(p * a for p, a in zip(to_point, axis, strict=True))
    across = math.hypot(*(p - along * a for p, a in zip(to_point, axis, strict=True)))
    return abs(across - radius) <= RADIUS_MISMATCH


def arcs_through(start: Vector, points: Sequence[Vector], centre: Vector, axis: Vector) -> list[Arc]:
    """One arc for each GOTO of a circle.

    The sense is counter-clockwise about the axis unless that takes more than a full turn to pass all points in order
    and the other way does not: some systems give the same axis for both senses.
    Raises ArcError when neither sense passes them in one turn.
    """
    problem = ""
    for sense in (1.0, -1.0):
        normal = (sense * axis[0], sense * axis[1], sense * axis[2])
        found = []
        place = start
        for point in points:
            found.append(arc_about(place, point, centre, normal))
            place = point
        total = sum(arc.sweep for arc in found)
        if total <= _FULL:
            return found
        problem = problem or f"the points of the circle take {math.degrees(total):.0f} deg to pass in order"
    raise ArcError(problem)
