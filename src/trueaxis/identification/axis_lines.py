"""The directions of the linear axes and what location errors make of the right angles between them."""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray
from trueaxis.view import View


@dataclass(frozen=True, slots=True, eq=False)
class AxisLine:
    """Direction in which an axis moves its body, seen from the bed, to first order: ideal + by_location @ values.

    ideal: (3,); by_location: (3, n_location_errors), 1/rad.
    """

    axis: str
    ideal: FloatArray
    by_location: FloatArray


def axis_lines(machine: IdentifiedMachine) -> tuple[AxisLine, ...]:
    """The lines of the linear axes, each moved from 0 to its farthest position, rotary axes at 0."""
    return tuple(_line(machine, axis) for axis in machine.axes if axis in LINEAR)


def angle_matrix(lines: tuple[AxisLine, ...]) -> FloatArray:
    """(pairs, n_location_errors): what each location error adds to the scalar product of two axes' directions.

    The scalar product is pi/2 minus the angle. Pairs in the order of `itertools.combinations`.
    """
    rows = [a.by_location.T @ b.ideal + b.by_location.T @ a.ideal for a, b in combinations(lines, 2)]
    return np.array(rows).reshape(len(rows), lines[0].by_location.shape[1] if lines else 0)


def _line(machine: IdentifiedMachine, axis: str) -> AxisLine:
    far = max(machine.travel[axis], key=abs) or 1.0
    positions = np.zeros((len(machine.axes), 2))
    positions[machine.axes.index(axis), 1] = far
    origin = np.zeros((3, 1))
    views: tuple[View, ...] = ("tool_in_bed", "workpiece_in_bed")
    for view in views:
        ideal = machine.view_ideal(view, positions, origin)
        moved = (ideal[:, 1] - ideal[:, 0]) / far
        if moved.any():
            by_error = machine.view_sensitivity(view, positions, origin)[:, len(machine.components) :]
            return AxisLine(axis, moved, (by_error[:, :, 1] - by_error[:, :, 0]) / far)
    return AxisLine(axis, np.zeros(3), np.zeros((3, len(machine.location_errors))))
