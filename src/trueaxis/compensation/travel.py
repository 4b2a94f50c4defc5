"""Positions outside the travel of their axes: programmed ones are faults, words that lead there stop at its end."""

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.lattice import Lattice
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.move_table import MoveTable
from trueaxis.compensation.path import Path
from trueaxis.compensation.point_control import PointControlled
from trueaxis.compensation.subdivide import probe_count

_ROUNDING = 1e-9  # mm, deg: what doubles lose


def note_outside(moves: MoveTable, path: Path, model: ErrorModel, tool_point: FloatArray, faults: FaultLog) -> None:
    """Faults of programmed positions, those along arcs too, that are outside the travel; once a block, and where an
    axis comes to such a position, not where it stays there. None where it is not known where positions are.

    tool_point: (3, 1), which says where the axes are under tool centre point control. Their way is no straight line
    then, and is looked at all along.
    """
    positions, owner = path.points, path.owner
    if isinstance(model, PointControlled):
        positions, owner = _passed(path, model, tool_point)
        model = model.base
    low, high = _limits(model)
    outside = (positions < low - _ROUNDING) | (positions > high + _ROUNDING)
    if positions is path.points:
        outside &= path.points != path.origins
    points = np.flatnonzero(outside.any(axis=0))
    for point in points[np.unique(owner[points], return_index=True)[1]]:
        row = int(np.argmax(outside[:, point]))
        axis, line = model.axes[row], moves[int(owner[point])].line
        if faults.unplaced is not None and line >= faults.unplaced:
            return
        faults.add(
            line,
            f"{axis} = {positions[row, point]:g} is outside its travel",
            f"from {low[row, 0]:g} to {high[row, 0]:g}",
        )


def inside_travel(
    positions: FloatArray, lattice: Lattice, model: ErrorModel, tool_point: FloatArray
) -> FloatArray:  # fmt: skip
    """Positions of words, (n_axes, n), those that lead out of the travel moved to where all axes are inside.

    Under tool centre point control the tip goes to where the control puts the axes at the end of their travel.
    """
    low, high = _limits(model)
    positions = lattice.within(positions, low, high)
    if not isinstance(model, PointControlled):
        return positions
    low, high = _limits(model.base)
    at = model.axis_positions(positions, tool_point)
    out = ((at < low - _ROUNDING) | (at > high + _ROUNDING)).any(axis=0)
    if not out.any():
        return positions
    rows = list(linear_rows(model.axes))
    room = np.zeros_like(low)
    room[rows] = 0.5 * np.sqrt((lattice.step[rows] ** 2).sum())  # what rounding of words moves an axis by at most
    tips = lattice.nearest(model.tip_positions(np.clip(at, low + room, high - room), tool_point))
    inside = positions.copy()
    inside[rows] = np.where(out, tips[rows], positions[rows])
    return inside


def _limits(model: ErrorModel) -> tuple[FloatArray, FloatArray]:
    """Lowest and highest positions, each (n_axes, 1)."""
    limits = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64)
    return limits[:, :1], limits[:, 1:]


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
