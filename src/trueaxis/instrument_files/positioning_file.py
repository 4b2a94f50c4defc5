"""Positioning tests of ISO 230-2 (.dat files and tables) as runs of a laser."""

from pathlib import Path

import numpy as np

from trueaxis.evaluation.iso230_2.dat_file import read_dat
from trueaxis.evaluation.iso230_2.read import TABLES, read_positioning_test
from trueaxis.measurement.instrument_run import InstrumentRun

ORDER = "the targets were approached cycle by cycle, all in the positive direction and then all in the negative one"


def read_positioning(path: Path) -> InstrumentRun:
    """Read such a file. Raises InputError with every fault of the file."""
    test = read_positioning_test(path) if path.suffix in TABLES else read_dat(path)
    up = np.argsort(test.targets)
    down = up[::-1]
    cycles = test.positive.shape[1]
    targets = np.tile(np.concatenate([test.targets[up], test.targets[down]]), cycles)
    measured = np.concatenate([part for k in range(cycles) for part in (test.positive[up, k], test.negative[down, k])])
    return InstrumentRun(
        file=str(path),
        id=path.stem,
        targets=targets,
        reading=measured - targets,
        directions=np.tile(np.repeat(np.array([1, -1], dtype=np.int8), up.size), cycles),
        assumed=(ORDER,),
    )
