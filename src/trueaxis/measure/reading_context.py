"""What effects on readings depend on: the displacement that is sensed, the polar angle of a ball bar."""

from collections.abc import Sequence
from typing import cast

import numpy as np
import numpy.typing as npt

from trueaxis.measure.context import Rows
from trueaxis.measure.machine import FloatArray, MeasuredMachine
from trueaxis.measure.reading_geometry import column, home_positions, ideal_bar, ideal_displacement
from trueaxis.measure.setup import Run
from trueaxis.runtime.context import ReadingContext

__all__ = ["ReadingContext", "along", "polar_angle", "reading_context_of", "run_reading_context", "theta"]

STILL = 1e-4  # of its length, by which the ends of a bar that does not turn may move in rounded positions


def reading_context_of(machine: MeasuredMachine, runs: Sequence[Run], rows: Rows) -> ReadingContext:
    """The reading context of every row; `along` is NaN for ball bars, `theta` for laser and probe."""
    count = rows.positions.shape[1]
    nothing = np.full(count, np.nan)
    found = ReadingContext(
        nothing.copy(),
        nothing.copy(),
        nothing if rows.time is None else rows.time,
        nothing if rows.temperature is None else rows.temperature,
    )
    order = np.argsort(rows.run, kind="stable")
    starts = np.flatnonzero(np.diff(rows.run[order], prepend=-1))
    for mine in np.split(order, starts[1:]):
        if mine.size:
            run = runs[rows.run[mine[0]]]
            here = run_reading_context(machine, run, rows.positions[:, mine], found.time[mine], found.temperature[mine])
            found.along[mine], found.theta[mine] = here.along, here.theta
    return found


def run_reading_context(
    machine: MeasuredMachine, run: Run, positions: FloatArray, time: FloatArray, temperature: FloatArray
) -> ReadingContext:
    """The reading context of rows of one run. positions: (n_axes, n), mm or deg; time (s), temperature (degC): (n,)."""
    nothing = np.full(positions.shape[1], np.nan)
    if run.instrument == "ballbar":
        return ReadingContext(nothing, theta(machine, run, positions), time, temperature)
    return ReadingContext(along(machine, run, positions), nothing, time, temperature)


def along(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Ideal displacement of target minus reference since home, along the sensed direction, (n,), mm.

    For laser and probe; positions: (n_axes, n), mm or deg.
    """
    home = home_positions(run, machine.axes)
    if home is None or run.direction is None:
        raise ValueError(f"run {run.id} senses no direction")
    away = ideal_displacement(machine, run, np.ascontiguousarray(positions), home)
    return cast(FloatArray, (column(run.direction) * away).sum(axis=0))


def theta(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Polar angle of the ideal bar, target seen from reference, in the plane of the run's circle, (n,), rad.

    positions: (n_axes, n), mm or deg, of enough of the circle to tell its plane.
    """
    return polar_angle(ideal_bar(machine, run, np.ascontiguousarray(positions)))


def polar_angle(bar: npt.NDArray[np.float64]) -> FloatArray:
    """Polar angle of vectors (3, n) in the plane of two frame axes along which they extend most, (n,), rad.

    Right-handed: from X to Y, from Y to Z, from Z to X. A bar that stands still, but for rounded positions, has one
    angle: its own in XY, or 0 where it is upright.
    """
    extent, length = np.ptp(bar, axis=1), float(np.linalg.norm(bar, axis=0).max(initial=0.0))
    if extent.max() < STILL * length:
        x, y, _ = bar.mean(axis=1)
        still = float(np.arctan2(y, x)) if np.hypot(x, y) > STILL * length else 0.0
        return np.full(bar.shape[1], still)
    across = 2 - int(np.argmin(extent[::-1]))  # the last one of equals, so that a single point lies in XY
    one, other = (across + 1) % 3, (across + 2) % 3
    angle: FloatArray = np.arctan2(bar[other], bar[one])
    return angle
