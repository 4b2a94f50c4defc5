"""The file of a positioning test, whichever form it has, and its form as a plain table.

Its columns are target, cycle, direction and measured (the position) or deviation; a row per reading, in any order.
"""

from collections.abc import Mapping
from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path

import numpy as np
import numpy.typing as npt

from trueaxis.evaluation.positioning_dat_file import read_dat
from trueaxis.evaluation.positioning_test import (
    FARTHEST_TARGET,
    FEWEST_CYCLES,
    LARGEST_DEVIATION,
    MOST_CYCLES,
    MOST_TARGETS,
    PositioningTest,
    Unit,
    too_few,
)
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import decoded, gathering, input_bytes
from trueaxis.measurement.columns import note, numbers, shortened, texts, whole_numbers
from trueaxis.measurement.delimited import Dimension, as_table, factor, heading, read_delimited, units_of
from trueaxis.measurement.table import MOST_FAULTS, Table, read_table

TABLES = (".csv", ".txt", ".parquet")
FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]
COLUMNS = ("target", "cycle", "direction", "measured")
DEVIATION = "deviation"  # in place of the last one
RUN = "run"  # of a table of several tests
POSITIVE = ("+1", "1", "+", "forward", "fwd", "positive", "pos")
NEGATIVE = ("-1", "-", "backward", "bwd", "negative", "neg")
_NAMES = ("forward", "backward")
# Share of the range of targets below which positions that are far off are deviations: positions follow their targets
STILL = 0.2


def read_positioning_test(path: Path, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> PositioningTest:
    """Read a .dat, .csv, .txt or .parquet file; unit: of its positions. Raises InputError with every fault."""
    if path.suffix == ".dat":
        return read_dat(path, unit, fewest_cycles)
    if path.suffix in TABLES:
        return read_positioning_table(path, unit, fewest_cycles)
    raise InputError(
        [
            Fault(
                str(path), "", "is of no known kind", "a .rtl file, or a name that ends in .dat, .csv, .txt or .parquet"
            )
        ]
    )


def read_positioning_table(path: Path, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> PositioningTest:
    """Read a table of readings, in `unit` where its header names no other; targets are put in ascending order. Columns
    are separated by commas or, numbers with a comma or a point, by semicolons, tabs or spaces; or Parquet.

    Raises InputError with every fault, each with its line and column.
    """
    return _test(path, *_named(_table(path)), unit, fewest_cycles)


def read_runs(path: Path, fewest_cycles: int = FEWEST_CYCLES) -> dict[str, PositioningTest]:
    """The tests of a file, mm, by the names in its column `run`, or one by the name of the file without its suffix.

    Raises InputError with every fault.
    """
    table, units = _named(_table(path)) if path.suffix in TABLES else (None, {})
    if table is None or RUN not in table.frame.columns:
        return {path.stem: read_positioning_test(path, fewest_cycles=fewest_cycles)}
    faults = Faults(str(path))
    names = texts(table, RUN, faults)
    _check_names(replace(table, frame=table.frame.drop(RUN)), faults)
    faults.raise_if_any()
    lines = np.arange(1, table.frame.height + 1) if table.lines is None else table.lines
    found = {}
    for name in names.unique(maintain_order=True):
        rows = (names == name).to_numpy()
        part = Table(table.frame.filter(rows).drop(RUN), lines[rows])
        own: list[Fault] = []
        with gathering(own):
            found[name] = _test(path, part, units, "mm", fewest_cycles)
        for fault in own:
            faults.add(", ".join(filter(None, (f"run {name}", fault.place))), fault.problem, fault.remedy)
    faults.raise_if_any()
    return found


def _test(path: Path, table: Table, units: Mapping[str, str], unit: Unit, fewest_cycles: int) -> PositioningTest:
    """The test of a table whose columns have small letters, with their units beside."""
    faults = Faults(str(path))
    _check_names(table, faults)
    faults.raise_if_any()
    factors = {name: _factor(name, units.get(name, ""), unit, faults) for name in ("target", _reading(table))}
    faults.raise_if_any()
    if table.frame.height == 0:
        faults.add("", "has no rows", "a row per reading")
    targets = numbers(table, "target", faults) * factors["target"]
    far = np.abs(targets) > FARTHEST_TARGET
    note(table, "target", far, faults, "is too far", remedy=f"{unit}, at most {FARTHEST_TARGET:g}")
    cycles = whole_numbers(table, "cycle", faults)
    directions = _directions(table, faults)
    keys_read = not faults.found  # else readings would be missing only because their row could not be placed
    measured = _measured(table, np.where(far, np.nan, targets), factors, unit, faults)
    if not keys_read:
        faults.raise_if_any()
    _check_counts(targets, cycles, faults, unit, fewest_cycles)
    return _gridded(table, targets, cycles, directions, measured, faults, unit)


def _table(path: Path) -> Table:
    """Strictly as CSV where the first line names columns between commas."""
    if path.suffix != ".parquet":
        first = decoded(input_bytes(path)).lstrip().split("\n", 1)[0]
        names = [heading(name).name for name in first.split(",")]
        if not {*COLUMNS, DEVIATION} & set(names):
            text = read_delimited(path)
            units = text.units or ("",) * len(text.header)
            header = (
                f"{name} [{of.strip('[]()')}]" if of else name for name, of in zip(text.header, units, strict=True)
            )
            return as_table(replace(text, header=tuple(header)))
    return read_table(path)


def _named(table: Table) -> tuple[Table, dict[str, str]]:
    """The table with the names of its columns in small letters and without units, and these."""
    heads = [heading(name) for name in table.frame.columns]
    if len({head.name for head in heads}) < len(heads):
        return table, {}
    return replace(table, frame=table.frame.rename({head.text: head.name for head in heads})), {
        head.name: head.unit for head in heads
    }


def _reading(table: Table) -> str:
    return DEVIATION if DEVIATION in table.frame.columns else COLUMNS[-1]


def _check_names(table: Table, faults: Faults) -> None:
    names = table.frame.columns
    for name in COLUMNS[:-1]:
        if name not in names:
            faults.add(f"column {name}", "is missing", f"columns {', '.join(COLUMNS)}")
    readings = [name for name in (COLUMNS[-1], DEVIATION) if name in names]
    if len(readings) != 1:
        problem = "is there beside deviation" if readings else "is missing"
        faults.add(f"column {COLUMNS[-1]}", problem, "positions as measured, or deviation in its place")
    for name in names:
        if name not in (*COLUMNS, DEVIATION):
            close = get_close_matches(name, (*COLUMNS, DEVIATION), n=1)
            remedy = f"did you mean {close[0]}?" if close else f"columns {', '.join(COLUMNS)}"
            faults.add(f"column {name}", "is not a known column", remedy)


def _factor(name: str, given: str, unit: Unit, faults: Faults) -> float:
    """What one of the unit of a column is in `unit`. A deviation may be of any size: its unit is asked for."""
    dimension: Dimension = "length" if unit == "mm" else "angle"
    if not given and name != DEVIATION:
        return 1.0
    scale = factor(given, dimension)
    if scale is None:
        problem = f"has the unit {shortened(given)}" if given else "does not say its unit"
        example = "um" if unit == "mm" else "arcsec"
        faults.add(f"column {name}", problem, f"a head such as {name} [{example}]: {units_of(dimension)}")
    return scale or 1.0


def _measured(
    table: Table, targets: FloatArray, factors: Mapping[str, float], unit: Unit, faults: Faults
) -> FloatArray:
    """(rows,), positions; those far off their targets are noted, all as one where they do not follow these."""
    name = _reading(table)
    values = numbers(table, name, faults) * factors[name]
    measured = targets + values if name == DEVIATION else values
    off = np.abs(measured - targets) > LARGEST_DEVIATION
    known = np.isfinite(measured) & np.isfinite(targets)
    if name != DEVIATION and 2 * int(off.sum()) > int(known.sum()):
        ranges = [(float(one[known].min()), float(one[known].max())) for one in (values, targets)]
        (low, high), (first, last) = ranges
        if high - low < STILL * (last - first):
            problem = (
                f"goes from {low:g} to {high:g} where targets go from {first:g} to {last:g}: are these deviations?"
            )
            faults.add(
                f"column {name}", problem, f"name the column deviation, with its unit, or give positions, {unit}"
            )
            return measured
    remedy = f"at most {LARGEST_DEVIATION:g} {unit} off"
    note(table, name, off, faults, "is far off its target", remedy=remedy)
    return measured


def _directions(table: Table, faults: Faults) -> IntArray:
    """0 positive, 1 negative, -1 where a cell is wrong, which is noted; (rows,)."""
    found = texts(table, "direction", faults)
    number = {**dict.fromkeys(POSITIVE, 0), **dict.fromkeys(NEGATIVE, 1)}
    codes = np.array([number.get(text.lower(), -1) for text in found.to_list()], dtype=np.int64)
    wrong = (codes < 0) & (found != "").to_numpy()
    note(table, "direction", wrong, faults, "is not a direction", remedy="+1 or forward, -1 or backward")
    return codes


def _check_counts(targets: FloatArray, cycles: IntArray, faults: Faults, unit: Unit, fewest_cycles: int) -> None:
    """Note too few targets or cycles. Raises InputError for too many: the cells of these are not looked at."""
    span = float(np.ptp(targets)) if targets.size else 0.0
    for what, column, most in (("target", targets, MOST_TARGETS), ("cycle", cycles, MOST_CYCLES)):
        count = len(np.unique(column))
        if problem := too_few(what, count, span, unit, fewest_cycles):
            faults.add(f"column {what}", problem)
        if count > most:
            faults.add(f"column {what}", f"has {count} different values", f"at most {most} {what}s")
            faults.raise_if_any()


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
