"""The positions that an NC program commands."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.mark import MARK
from trueaxis.compensation.move_table import MoveTable
from trueaxis.compensation.moves import Move, Notes
from trueaxis.compensation.nc_reader import NcReader
from trueaxis.compensation.plain_run import PlainRun
from trueaxis.compensation.settings import Settings


def commanded_ends(program: Path, axes: tuple[str, ...]) -> NDArray[np.float64]:
    """Ends of the moves of a program without arcs: positions (n_axes, n), mm or deg.

    Raises InputError with every fault of the program, OSError when it cannot be read.
    """
    faults = FaultLog(str(program))
    reader = NcReader(axes, Settings(), faults, Notes())
    with program.open(encoding="latin-1", newline="") as file:
        text = "".join("\n" if MARK in line else line for line in file)
        moves = MoveTable([item for item in reader.items([text]) if isinstance(item, Move | PlainRun)], len(axes))
    for _, move in moves.singles():
        if move.arc is not None:
            faults.add(move.line, "is an arc", "chords, as compensate writes them")
    faults.raise_if_any()
    return moves.ends if len(moves) else np.zeros((len(axes), 0))
