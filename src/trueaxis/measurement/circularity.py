"""Circular deviation of ball-bar readings (ISO 230-4)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Circularity:
    """Circular deviation G (mm) about the least-squares centre, that centre (mm), and the deviations from it (n,)."""

    deviation: float
    centre: tuple[float, float]
    radial: FloatArray


def circularity(angles: FloatArray, readings: FloatArray) -> Circularity:
    """Circular deviation of one direction of run: the greatest less the smallest radial deviation.

    angles: (n,) polar angles of the bar, rad; readings: (n,) distance minus nominal length, mm. The centre of the
    circle is that of least squares, since nobody can place a ball without an offset: readings = mean + a cos + b sin.
    Raises ValueError for fewer than four readings or readings at angles that do not fix a centre.
    """
    if angles.size < 4:
        raise ValueError(f"a circle needs four readings or more, there are {angles.size}")
    design = np.column_stack([np.ones_like(angles), np.cos(angles), np.sin(angles)])
    solution, _, rank, _ = np.linalg.lstsq(design, readings, rcond=None)
    if rank < 3:
        raise ValueError("the readings lie at too few different angles to fix a centre")
    radial = readings - design[:, 1:] @ solution[1:]
    return Circularity(float(np.ptp(radial)), (float(solution[1]), float(solution[2])), radial)
