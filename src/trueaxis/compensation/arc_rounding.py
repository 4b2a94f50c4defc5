"""How far rounding alone can put the ends of an arc at different radii.

Every word is right to half a unit of its last decimal. What the words of one arc may differ by follows to first order:
with unit vectors u1, u2 from the centre to start s and end e, and o = (I, J, K) from the start to the centre,
d|o| - d|e - s - o| = (u2 - u1) do + u2 (ds - de). The bound is the sum of the magnitudes. Zeros at the end of a number
are often left out, so the decimals of a block are those of its longest number. An axis of the plane without a word
counts as one with it: many post-processors leave out a word that rounds to the one before.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from trueaxis.compensation.arcs import Vector
from trueaxis.compensation.settings import MM_PER_INCH

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
