"""What a machine model expects an instrument to read: the one definition of a reading.

Laser and probe sense, along their direction, the displacement of the target minus that of the reference since home,
minus the same of the error-free machine. The ideal displacements cancel, so that with D = actual - ideal coordinates
in the frame of the run

    reading = direction . ((D_target(h) - D_target(home)) - (D_reference(h) - D_reference(home)))

without a difference of large numbers. A point that rests in the frame has D = 0. A ball bar reads |P| - length
with P the target seen from the reference: Eqs. (5) and (6) of the paper.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
import numpy.typing as npt

from trueaxis.measure.machine import FloatArray, MeasuredMachine, View
from trueaxis.measure.setup import Frame, PointOn, Run, Vector


@dataclass(frozen=True, slots=True)
class Term:
    """One term of a reading: sign * (coordinates of the point in the view)."""

    view: View
    sign: float
    point: Vector


def measuring_frame(run: Run) -> Frame:
    """The frame whose coordinates a reading is made of; for a ball bar the workpiece where a ball is on it."""
    if run.instrument == "ballbar":
        on_tool = "tool" in (run.target.on, run.reference.on)
        on_workpiece = "workpiece" in (run.target.on, run.reference.on)
        return "workpiece" if on_tool and on_workpiece else "bed"
    return run.frame


def run_terms(run: Run) -> tuple[Term, ...]:
    """The views and points whose deviations make up the readings of a run, target first.

    With d the sensed direction, the first-order reading is d . sum(sign * D(view, point)), minus the same at home
    for laser and probe. Points that rest in the measuring frame contribute nothing and are left out.
    """
    frame = measuring_frame(run)
    return tuple(
        Term(cast(View, f"{end.on}_in_{frame}"), sign, end.point)
        for end, sign in ((run.target, 1.0), (run.reference, -1.0))
        if end.on != frame
    )


def home_positions(run: Run, axes: Sequence[str]) -> FloatArray | None:
    """Where the reading was zeroed, (n_axes, 1), mm or deg; None for a ball bar, whose readings have no zero point."""
    if run.instrument == "ballbar":
        return None
    return np.array([[run.home[axis]] for axis in axes])


def sensed_directions(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """Unit vectors along which deviations count to first order, (3, n); for a ball bar the ideal bar's direction.

    positions: (n_axes, n), mm or deg.
    """
    if run.direction is not None:
        return np.repeat(column(run.direction), positions.shape[1], axis=1)
    vector = ideal_bar(machine, run, positions)
    size = np.linalg.norm(vector, axis=0)
    return cast(FloatArray, np.divide(vector, size, out=np.zeros_like(vector), where=size > 0.0))


def ideal_bar(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """The target ball seen from the reference ball on the error-free machine, (3, n), mm, measuring frame."""
    ends = [_ideal(machine, end, measuring_frame(run), positions) for end in (run.target, run.reference)]
    return ends[0] - ends[1]


def ideal_reading(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """What is read on the error-free machine, (n,), mm: zero for laser and probe, distance - length for a ball bar."""
    if run.length is None:
        return np.zeros(positions.shape[1])
    return cast(FloatArray, np.linalg.norm(ideal_bar(machine, run, positions), axis=0) - run.length)


def expected_reading(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """What is read on the exact model at axis positions (n_axes, n): (n,), mm."""
    deviation = _deviation(machine, run, positions)
    home = home_positions(run, machine.axes)
    if home is not None:
        sensed = deviation - _deviation(machine, run, home)
        return cast(FloatArray, np.einsum("in,in->n", sensed_directions(machine, run, positions), sensed))
    ideal = ideal_bar(machine, run, positions)
    # |P + D| - |P| as (2P + D).D / (|P + D| + |P|): nothing cancels
    stretch = np.einsum("in,in->n", 2.0 * ideal + deviation, deviation)
    total = np.linalg.norm(ideal + deviation, axis=0) + np.linalg.norm(ideal, axis=0)
    stretched = np.divide(stretch, total, out=np.zeros_like(stretch), where=total > 0.0)
    return cast(FloatArray, ideal_reading(machine, run, positions) + stretched)


def expected_readings(
    machine: MeasuredMachine, runs: Sequence[Run], run: npt.NDArray[np.int64], positions: FloatArray
) -> FloatArray:
    """What is read in the rows of several runs, (n,), mm.

    run: (n,), index into runs; positions: (n_axes, n).
    """
    found = np.full(positions.shape[1], np.nan)
    for index, one in enumerate(runs):
        rows = run == index
        if rows.any():
            found[rows] = expected_reading(machine, one, np.ascontiguousarray(positions[:, rows]))
    return found


def column(point: Vector) -> FloatArray:
    """A point as the (3, 1) array that views take."""
    return np.array(point)[:, np.newaxis]


def _deviation(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    total = np.zeros((3, positions.shape[1]))
    for term in run_terms(run):
        total += term.sign * machine.view_deviation(term.view, positions, column(term.point))
    return total


def _ideal(machine: MeasuredMachine, end: PointOn, frame: Frame, positions: FloatArray) -> FloatArray:
    if end.on == frame:
        return np.repeat(column(end.point), positions.shape[1], axis=1)
    return machine.view_ideal(cast(View, f"{end.on}_in_{frame}"), positions, column(end.point))
