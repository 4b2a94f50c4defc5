"""Effects on readings themselves and on the points of a set-up, and what they depend on.

That is the displacement that is sensed, the way along the line of the motion, and the polar angle of a circle.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal, cast

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Effect
from trueaxis.effects.placement import concerns
from trueaxis.measurement.context import Rows
from trueaxis.measurement.machine import FloatArray, MeasuredMachine
from trueaxis.measurement.reading_geometry import along_line, column, home_positions, ideal_bar, ideal_displacement
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.model import MachineModel

End = Literal["target", "reference"]
STILL = 1e-4  # of its length, by which the ends of a bar that does not turn may move in rounded positions


def reading_effects(machine: MachineModel, run: Run, positions: FloatArray, context: Context) -> FloatArray:
    """What effects add to the readings of a run as they are, (n,), mm: no zero point is subtracted.

    positions: (n_axes, n), mm or deg. NaN where the context lacks what an effect depends on.
    """
    total = np.zeros(positions.shape[1])
    mine = [
        values
        for values in machine.effect_values
        if (kind := machine.kinds[values.effect.kind]).place == "reading" and concerns(kind, values.effect, run)
    ]
    if mine:
        here = _run_reading_context(machine, run, positions, context.time, context.temperature)
        for values in mine:
            total += machine.reading_effect(values, here)
    return total


def placed_run(machine: MachineModel, run: Run) -> Run:
    """The run with its points where effects say that they are; the run itself where none says so.

    A point moves in the frame of its body by x, y, z (mm): the end that the effect names, else the target of a laser
    and the ball on the workpiece of a ball bar (the reference where no ball is on it).
    """
    for values in machine.effect_values:
        kind = machine.kinds[values.effect.kind]
        if kind.place == "point" and concerns(kind, values.effect, run):
            by = values.vector(kind)
            if moved_end(values.effect, run) == "target":
                run = replace(run, target=_moved(run.target, by))
            else:
                run = replace(run, reference=_moved(run.reference, by))
    return run


def moved_end(effect: Effect, run: Run) -> End:
    """Which point of a run an effect of the place `point` moves."""
    if effect.end is not None:
        return "reference" if effect.end == "reference" else "target"
    if run.instrument == "ballbar":
        return "target" if run.target.on == "workpiece" else "reference"
    return "target"


def _moved(end: PointOn, by: FloatArray) -> PointOn:
    x, y, z = (float(value) for value in np.array(end.point) + by)
    return PointOn(end.on, (x, y, z))


def reading_context_of(machine: MeasuredMachine, runs: Sequence[Run], rows: Rows) -> ReadingContext:
    """The reading context of every row; `along` and `_way` are NaN for ball bars, `theta` for laser and probe."""
    unknown = np.full(rows.positions.shape[1], np.nan)
    time, temperature = (unknown if values is None else values for values in (rows.time, rows.temperature))
    return reading_context(machine, runs, rows.run, rows.positions, time, temperature)


def reading_context(
    machine: MeasuredMachine,
    runs: Sequence[Run],
    run: npt.NDArray[np.int64],
    positions: FloatArray,
    time: FloatArray,
    temperature: FloatArray,
) -> ReadingContext:
    """The same. run: (n,), index into runs; positions: (n_axes, n), mm or deg; time (s), temperature (degC): (n,)."""
    unknown = np.full(run.size, np.nan)
    found = ReadingContext(along=unknown, theta=unknown.copy(), way=unknown.copy(), time=time, temperature=temperature)
    order = np.argsort(run, kind="stable")
    starts = np.flatnonzero(np.diff(run[order], prepend=-1))
    for mine in np.split(order, starts[1:]):
        if mine.size:
            here = _run_reading_context(machine, runs[run[mine[0]]], positions[:, mine], time[mine], temperature[mine])
            found.along[mine], found.theta[mine], found.way[mine] = here.along, here.theta, here.way
    return found


def _run_reading_context(
    machine: MeasuredMachine, run: Run, positions: FloatArray, time: FloatArray, temperature: FloatArray
) -> ReadingContext:
    """The reading context of rows of one run. positions: (n_axes, n), mm or deg; time (s), temperature (degC): (n,)."""
    nothing = np.full(positions.shape[1], np.nan)
    if run.instrument == "ballbar":
        return ReadingContext(
            along=nothing, theta=theta(machine, run, positions), way=nothing, time=time, temperature=temperature
        )
    return ReadingContext(
        along=along(machine, run, positions),
        theta=nothing,
        way=_way(machine, run, positions),
        time=time,
        temperature=temperature,
    )


def along(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Ideal displacement of target minus reference since home, along the sensed direction, (n,), mm.

    For laser and probe; positions: (n_axes, n), mm or deg.
    """
    if run.direction is None:
        raise ValueError(f"run {run.id} senses no direction")
    return cast(FloatArray, (column(run.direction) * _since_home(machine, run, positions)).sum(axis=0))


def _way(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Ideal way of target minus reference along the line of the motion, since home, towards growing coordinates.

    (n,), mm. For laser and probe; positions: (n_axes, n), mm or deg, of enough of the line to tell its direction.
    """
    return along_line(_since_home(machine, run, positions))


def _since_home(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    home = home_positions(run, machine.axes)
    if home is None:
        raise ValueError(f"run {run.id} has no home")
    return ideal_displacement(machine, run, np.ascontiguousarray(positions), home)


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
