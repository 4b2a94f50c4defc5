"""Programmed positions outside the travel of their axes."""

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.machine import ErrorModel, FloatArray
from trueaxis.compensation.move_table import MoveTable
from trueaxis.compensation.path import Path
from trueaxis.compensation.point_control import PointControlled
from trueaxis.compensation.subdivide import probe_count

_ROUNDING = 1e-9  # mm, deg: what doubles lose


def note_outside(moves: MoveTable, path: Path, model: ErrorModel, tool_point: FloatArray, faults: FaultLog) -> None:
    """Faults of programmed positions, those along arcs too, that are outside the travel; once a block.

    tool_point: (3, 1), which says where the axes are under tool centre point control. Their way is no straight line
    then, and is looked at all along.
    """
    positions, owner = path.points, path.owner
    if isinstance(model, PointControlled):
        positions, owner = _passed(path, model, tool_point)
        model = model.base
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
    outside = (positions < low[:, None] - _ROUNDING) | (positions > high[:, None] + _ROUNDING)
    points = np.flatnonzero(outside.any(axis=0))
    for point in points[np.unique(owner[points], return_index=True)[1]]:
        row = int(np.argmax(outside[:, point]))
        axis = model.axes[row]
        faults.add(
            moves[int(owner[point])].line,
            f"{axis} = {positions[row, point]:g} is outside its travel",
            f"from {low[row]:g} to {high[row]:g}",
        )


def _passed(path: Path, model: PointControlled, tool_point: FloatArray) -> tuple[FloatArray, NDArray[np.int64]]:
    """Axis positions along the motions and where an axis turns on its way, (n_axes, m), and the move of each."""
    origins = np.where(np.isfinite(path.origins).all(axis=0), path.origins, path.points)
    span = path.points - origins
    count = probe_count(np.sqrt((span**2).sum(axis=0))) + 1
    motion = np.repeat(np.arange(path.size), count)
    share = (np.arange(motion.size) - (np.cumsum(count) - count)[motion] + 1) / count[motion]
    at = model.axis_positions(origins[:, motion] + share * span[:, motion], tool_point)
    inner = np.flatnonzero((motion[:-2] == motion[1:-1]) & (motion[1:-1] == motion[2:])) + 1
    before, here, after = (at[:, inner + step] for step in (-1, 0, 1))
    # the vertex of the parabola through three samples, where the middle one is the farthest of them
    turns = (here - before) * (here - after) > 0.0
    bend = np.where(turns, 2.0 * here - before - after, 1.0)
    vertex = np.where(turns, here + (after - before) ** 2 / (8.0 * bend), here)
    return np.concatenate([at, vertex], axis=1), path.owner[np.concatenate([motion, motion[inner]])]
