"""What a machine model expects an instrument to read: the one definition of a reading.

Laser and probe sense, along their direction, the displacement of the target minus that of the reference since home,
minus the same of the error-free machine. The ideal displacements cancel, so that with D = actual - ideal coordinates
in the frame of the run

    reading = direction . ((D_target(h) - D_target(home)) - (D_reference(h) - D_reference(home)))

without a difference of large numbers. An angle instrument reads, times ARM, the rotation of the target's body about
its direction, minus that of the reference's, since home, minus the same of the error-free machine: a sum of the
deviations of points of these bodies (`sensed_points`). A displacement sensor reads as a probe, all at its home. A point
that rests in the frame has D = 0. A ball bar reads |P| - length with P the target seen from the reference: Eqs. (5) and
(6) of the paper.

Effects, where a machine has some, act in the context of the readings: on the component errors, here as at home; on the
points of the set-up, which then are elsewhere than said; on the reading itself.
"""

from collections.abc import Sequence
from typing import cast

import numpy as np
import numpy.typing as npt

from trueaxis.measurement.instrument_kinds import ANGLE
from trueaxis.measurement.machine import FloatArray, MeasuredMachine
from trueaxis.measurement.reading_effects import placed_run, reading_effects
from trueaxis.measurement.reading_geometry import (
    Term,
    column,
    home_positions,
    ideal_bar,
    ideal_displacement,
    measuring_frame,
    run_terms,
    sensed_directions,
    sensed_points,
)
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context
from trueaxis.model.model import MachineModel

__all__ = [
    "Term",
    "column",
    "expected_reading",
    "expected_readings",
    "home_positions",
    "ideal_bar",
    "ideal_reading",
    "measuring_frame",
    "run_terms",
    "sensed_directions",
    "sensed_points",
]


def ideal_reading(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """What is read on the error-free machine, (n,), mm: distance - length for a ball bar, zero for the others."""
    if run.length is None:
        return np.zeros(positions.shape[1])
    return cast(FloatArray, np.linalg.norm(ideal_bar(machine, run, positions), axis=0) - run.length)


def expected_reading(
    machine: MeasuredMachine, run: Run, positions: FloatArray, context: Context | None = None
) -> FloatArray:
    """What is read on the exact model at axis positions (n_axes, n): (n,), mm.

    context: of the positions, with that of home for laser and probe, as `context_of` makes it; a machine without
    effects needs none. NaN where it lacks what an effect depends on. Raises ValueError where it lacks the home.
    """
    if context is None or not isinstance(machine, MachineModel) or not machine.effect_values:
        return _expected(machine, machine, run, positions)
    if not positions.shape[1]:
        return np.zeros(0)
    at_home: MeasuredMachine = machine
    if run.instrument != "ballbar":
        if context.home is None:
            raise ValueError(f"the context of run {run.id} does not tell that of its home")
        at_home = machine.in_context(context.home.of(slice(0, 1)))
    placed = placed_run(machine, run)
    found = _expected(machine.in_context(context), at_home, placed, positions)
    home = home_positions(run, machine.axes)
    if placed is not run and home is not None:
        ends = [ideal_displacement(machine, one, positions, home) for one in (placed, run)]
        found += np.einsum("in,in->n", sensed_directions(machine, run, positions), ends[0] - ends[1])
    return found + reading_effects(machine, run, positions, context)


def expected_readings(
    machine: MeasuredMachine,
    runs: Sequence[Run],
    run: npt.NDArray[np.int64],
    positions: FloatArray,
    context: Context | None = None,
) -> FloatArray:
    """What is read in the rows of several runs, (n,), mm.

    run: (n,), index into runs; positions: (n_axes, n); context: of these rows, see `expected_reading`.
    """
    found = np.full(positions.shape[1], np.nan)
    for index, one in enumerate(runs):
        rows = run == index
        if rows.any():
            here = None if context is None else context.of(rows)
            found[rows] = expected_reading(machine, one, np.ascontiguousarray(positions[:, rows]), here)
    return found


def _expected(machine: MeasuredMachine, at_home: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """The reading, from component errors alone; at_home: the machine in the context of the run's home."""
    if run.instrument == ANGLE:
        zeroed = cast(FloatArray, home_positions(run, machine.axes))
        return _turned(machine, run, positions) - _turned(at_home, run, zeroed)
    home = home_positions(run, machine.axes)
    if home is not None:
        if at_home is machine:  # home as one more position: on the few of a run a call costs more than its arithmetic
            deviation = _deviation(machine, run, np.hstack([positions, home]))
            sensed = deviation[:, :-1] - deviation[:, -1:]
        else:
            sensed = _deviation(machine, run, positions) - _deviation(at_home, run, home)
        return cast(FloatArray, np.einsum("in,in->n", sensed_directions(machine, run, positions), sensed))
    deviation, ideal = _deviation(machine, run, positions), ideal_bar(machine, run, positions)
    # |P + D| - |P| as (2P + D).D / (|P + D| + |P|): nothing cancels
    stretch = np.einsum("in,in->n", 2.0 * ideal + deviation, deviation)
    size = np.linalg.norm(ideal, axis=0)
    total = np.linalg.norm(ideal + deviation, axis=0) + size
    stretched = np.divide(stretch, total, out=np.zeros_like(stretch), where=total != 0.0)  # NaN stays NaN
    return cast(FloatArray, stretched if run.length is None else (size - run.length) + stretched)


def _turned(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(n,): what the rotation of an angle run's bodies makes at ARM, mm, actual minus ideal."""
    total = np.zeros(positions.shape[1])
    points = sensed_points(machine, run, positions)
    each = machine.view_deviations([(one.view, column(one.point)) for one in points], positions)
    for one, found in zip(points, each, strict=True):
        total += np.einsum("in,in->n", one.direction, found)
    return total


def _deviation(machine: MeasuredMachine, run: Run, positions: FloatArray) -> FloatArray:
    terms = run_terms(run)
    each = machine.view_deviations([(term.view, column(term.point)) for term in terms], positions)
    total = np.zeros((3, positions.shape[1]))
    for term, found in zip(terms, each, strict=True):
        total += term.sign * found
    return total
