"""Programmed positions outside the travel of their axes."""

import numpy as np

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.move_table import MoveTable
from trueaxis.compensation.path import Path
from trueaxis.compensation.point_control import PointControlled

_ROUNDING = 1e-9  # mm, deg: what doubles lose


def note_outside(moves: MoveTable, path: Path, model: ErrorModel, tool_point: FloatArray, faults: FaultLog) -> None:
    """Faults of programmed positions, those along arcs too, that are outside the travel; once a block.

    tool_point: (3, 1), which says where the axes are under tool centre point control.
    """
    positions = path.points
    if isinstance(model, PointControlled):
        positions, model = model.axis_positions(positions, tool_point), model.base
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
    outside = (positions < low[:, None] - _ROUNDING) | (positions > high[:, None] + _ROUNDING)
    points = np.flatnonzero(outside.any(axis=0))
    for point in points[np.unique(path.owner[points], return_index=True)[1]]:
        row = int(np.argmax(outside[:, point]))
        axis = model.axes[row]
        faults.add(
            moves[path.owner[point]].line,
            f"{axis} = {positions[row, point]:g} is outside its travel",
            f"from {low[row]:g} to {high[row]:g}",
        )
