"""The positioning test of a real linear axis (../shared/data/ess_iso230_2) as a data folder of the contract.

Five cycles of nine targets, up and down: one laser run of 90 readings in the order of the standard's test, with the
directions of approach as the .dat labels them. The report made from it labels them the other way round; with its labels
the axis would overshoot wherever it turns back, which is not what lost motion does.

No times were recorded. With `clock` the converter writes time_s = 0, 1, 2 ...: one reading counts for a second, an
assumption of equal time steps, and every time that comes out is a number of readings.
"""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polars as pl

from trueaxis.evaluation.positioning_table_file import read_positioning_test
from trueaxis.evaluation.positioning_test import PositioningTest

FILE = Path(__file__).parents[3] / "shared" / "data" / "ess_iso230_2" / "axis_x.dat"
SPEC = Path(__file__).with_name("linear_axis.toml")
ERRORS = '{"schema": 1, "machine": "linear_axis", "parameters": {}, "motion_errors": {}}\n'
SETUP = """\
schema = 1
machine = "linear_axis"

[[run]]
id = "X"
instrument = "laser"
direction = [1.0, 0.0, 0.0]
target = { on = "tool", point = [0.0, 0.0, 0.0] }
reference = { on = "bed" }
home = { X = 0.0 }
"""


@dataclass(frozen=True)
class Folder:
    """What was written: folder of setup.toml and readings.csv, and error values that are all zero."""

    data: Path
    errors: Path


def readings(test: PositioningTest, *, clock: bool = True, without: int = 0) -> pl.DataFrame:
    """One row a reading: cycle by cycle, up the targets and down again; mm. without: a cycle (1 to 5) left out."""
    targets = test.targets
    cycles = [k for k in range(test.positive.shape[1]) if k + 1 != without]
    up = np.argsort(targets)
    down = up[::-1]
    at = np.tile(np.concatenate([targets[up], targets[down]]), len(cycles))
    way = np.tile(np.repeat([1, -1], targets.size), len(cycles))
    found = np.concatenate([part for k in cycles for part in (test.positive[up, k], test.negative[down, k])])
    order = np.arange(at.size)
    table = {"run": ["X"] * at.size, "seq": order + 1, "X": at, "dir_X": way, "reading": found - at}
    if clock:
        table["time_s"] = order.astype(np.float64)
    return pl.DataFrame(table)


def write(folder: Path, *, swapped: bool = False, clock: bool = True, without: int = 0) -> Folder:
    """Write the data folder; swapped: with the labels of the report; without: a cycle left out."""
    test = read_positioning_test(FILE)
    data = folder / "readings"
    data.mkdir(parents=True)
    (data / "setup.toml").write_text(SETUP)
    table = readings(test.swapped() if swapped else test, clock=clock, without=without)
    table.write_csv(data / "readings.csv")
    errors = folder / "zero.json"
    errors.write_text(ERRORS)
    return Folder(data, errors)
