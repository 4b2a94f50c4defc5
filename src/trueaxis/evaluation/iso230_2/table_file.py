"""A positioning test as a plain table: columns target, cycle, direction, measured; a row per reading, in any order."""

from difflib import get_close_matches
from pathlib import Path

import numpy as np
import numpy.typing as npt

from trueaxis.evaluation.iso230_2.positioning_test import (
    FARTHEST_TARGET,
    LARGEST_DEVIATION,
    MOST_CYCLES,
    MOST_TARGETS,
    PositioningTest,
    Unit,
    too_few,
)
from trueaxis.io.faults import Faults
from trueaxis.measurement.columns import note, numbers, texts, whole_numbers
from trueaxis.measurement.table import MOST_FAULTS, Table, read_table

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]

COLUMNS = ("target", "cycle", "direction", "measured")
POSITIVE, NEGATIVE = ("+1", "1", "+", "forward"), ("-1", "-", "backward")
_NAMES = ("forward", "backward")


def read_positioning_table(path: Path, unit: Unit = "mm") -> PositioningTest:
    """Read a .csv or .parquet table of readings, in `unit`; targets are put in ascending order.

    Raises InputError with every fault, each with its line and column.
    """
    table = read_table(path)
    faults = Faults(str(path))
    _check_names(table, faults)
    faults.raise_if_any()
    if table.frame.height == 0:
        faults.add("", "has no rows", "a row per reading")
    targets = numbers(table, "target", faults)
    far = np.abs(targets) > FARTHEST_TARGET
    note(table, "target", far, faults, "is too far", remedy=f"{unit}, at most {FARTHEST_TARGET:g}")
    cycles = whole_numbers(table, "cycle", faults)
    directions = _directions(table, faults)
    keys_read = not faults.found  # else readings would be missing only because their row could not be placed
    measured = numbers(table, "measured", faults)
    off = np.abs(np.where(far, np.nan, measured - targets)) > LARGEST_DEVIATION
    remedy = f"at most {LARGEST_DEVIATION:g} {unit} off"
    note(table, "measured", off, faults, "is far off its target", remedy=remedy)
    if not keys_read:
        faults.raise_if_any()
    return _gridded(table, targets, cycles, directions, measured, faults, unit)


def _check_names(table: Table, faults: Faults) -> None:
    names = table.frame.columns
    for name in COLUMNS:
        if name not in names:
            faults.add(f"column {name}", "is missing", f"columns {', '.join(COLUMNS)}")
    for name in names:
        if name not in COLUMNS:
            close = get_close_matches(name, COLUMNS, n=1)
            remedy = f"did you mean {close[0]}?" if close else f"columns {', '.join(COLUMNS)}"
            faults.add(f"column {name}", "is not a known column", remedy)


def _directions(table: Table, faults: Faults) -> IntArray:
    """0 positive, 1 negative, -1 where a cell is wrong, which is noted; (rows,)."""
    found = texts(table, "direction", faults)
    number = {**dict.fromkeys(POSITIVE, 0), **dict.fromkeys(NEGATIVE, 1)}
    codes = np.array([number.get(text.lower(), -1) for text in found.to_list()], dtype=np.int64)
    wrong = (codes < 0) & (found != "").to_numpy()
    note(table, "direction", wrong, faults, "is not a direction", remedy="+1 or forward, -1 or backward")
    return codes


def _gridded(
    table: Table,
    targets: FloatArray,
    cycles: IntArray,
    directions: IntArray,
    measured: FloatArray,
    faults: Faults,
    unit: Unit,
) -> PositioningTest:
    positions, i = np.unique(targets, return_inverse=True)
    runs, j = np.unique(cycles, return_inverse=True)
    for what, count, most in (("target", len(positions), MOST_TARGETS), ("cycle", len(runs), MOST_CYCLES)):
        if problem := too_few(what, count, float(np.ptp(positions)) if positions.size else 0.0, unit):
            faults.add(f"column {what}", problem)
        if count > most:
            faults.add(f"column {what}", f"has {count} different values", f"at most {most} {what}s")
            faults.raise_if_any()
    shape = (2, len(positions), len(runs))
    cell = (directions * shape[1] + i) * shape[2] + j
    again = np.ones(len(cell), dtype=np.bool_)
    again[np.unique(cell, return_index=True)[1]] = False
    note(table, "cycle", again, faults, "is given already for this target and direction", remedy="keep one row")
    given = np.zeros(shape, dtype=np.bool_)
    given.flat[cell] = True
    _check_complete(given, positions, runs, faults)
    faults.raise_if_any()
    grid = np.empty(shape)
    grid.flat[cell] = measured
    return PositioningTest(positions, grid[0], grid[1], unit)


def _check_complete(given: npt.NDArray[np.bool_], positions: FloatArray, runs: IntArray, faults: Faults) -> None:
    for name, of_direction in zip(_NAMES, given, strict=True):
        if not of_direction.any():
            faults.add("column direction", f"there is no row {name}", "a bidirectional test has both directions")
            continue
        missing = np.argwhere(~of_direction)
        for i, j in missing[:MOST_FAULTS]:
            faults.add("", f"there is no row of target {positions[i]:.12g}, cycle {runs[j]}, {name}")
        if len(missing) > MOST_FAULTS:
            faults.add("", f"and so {len(missing) - MOST_FAULTS} more rows {name}")
