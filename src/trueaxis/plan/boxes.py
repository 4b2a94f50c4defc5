"""Where candidate points may lie: boxes around the points that a plan gives."""

from collections.abc import Iterable, Sequence
from itertools import product
from typing import cast

import numpy as np

from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Carrier, Run, Vector

LEAST_SIDE = 100.0  # mm: where given points share a coordinate, candidates may leave it by half of this


def box(runs: Sequence[Run], carrier: Carrier) -> FloatArray | None:
    """(3, 2): lowest and highest coordinates of the points given on a body, mm, each side LEAST_SIDE at least.

    None where no point is given on it.
    """
    points = [end.point for run in runs for end in (run.target, run.reference) if end.on == carrier]
    if not points:
        return None
    low, high = np.min(points, axis=0), np.max(points, axis=0)
    more = np.maximum(LEAST_SIDE - (high - low), 0.0) / 2.0
    return np.stack([low - more, high + more], axis=1)


def corners_and_centre(around: FloatArray) -> list[Vector]:
    """The eight corners of a box and its centre."""
    return [*_points(product(*around.tolist())), cast(Vector, tuple(around.mean(axis=1).tolist()))]


def lattice(around: FloatArray, own: Vector) -> list[Vector]:
    """Points with each coordinate as given, lowest, middle or highest; that given itself is left out."""
    sides = [
        dict.fromkeys((given, float(low), float((low + high) / 2.0), float(high)))
        for given, (low, high) in zip(own, around, strict=True)
    ]
    return [point for point in _points(product(*sides)) if point != own]


def told(around: FloatArray) -> str:
    """`x -100 to 232, y ..., z ... mm`."""
    return ", ".join(f"{axis} {low:g} to {high:g}" for axis, (low, high) in zip("xyz", around, strict=True)) + " mm"


def _points(points: Iterable[Sequence[float]]) -> list[Vector]:
    return [cast(Vector, tuple(round(float(part), 3) for part in point)) for point in points]
