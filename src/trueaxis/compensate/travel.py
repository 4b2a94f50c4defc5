"""Programmed positions outside the travel of their axes."""

from collections.abc import Sequence

import numpy as np

from trueaxis.compensate.fault_log import FaultLog
from trueaxis.compensate.machine import ErrorModel
from trueaxis.compensate.moves import Move
from trueaxis.compensate.path import Path

_ROUNDING = 1e-9  # mm, deg: what doubles lose


def note_outside(moves: Sequence[Move], path: Path, model: ErrorModel, faults: FaultLog) -> None:
    """Faults of programmed positions, those along arcs too, that are outside the travel; once a block."""
    low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
    outside = (path.points < low[:, None] - _ROUNDING) | (path.points > high[:, None] + _ROUNDING)
    points = np.flatnonzero(outside.any(axis=0))
    for point in points[np.unique(path.owner[points], return_index=True)[1]]:
        row = int(np.argmax(outside[:, point]))
        axis = model.axes[row]
        faults.add(
            moves[path.owner[point]].line,
            f"{axis} = {path.points[row, point]:g} is outside its travel",
            f"from {low[row]:g} to {high[row]:g}",
        )
