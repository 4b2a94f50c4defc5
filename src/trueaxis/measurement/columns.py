"""Columns of a table as arrays, with every bad cell noted at its place."""

from collections.abc import Sequence
from difflib import get_close_matches

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import Faults
from trueaxis.measurement.limits import COLDEST, FASTEST, LONGEST_TIME, WARMEST
from trueaxis.measurement.machine import FloatArray, MachineAxes
from trueaxis.measurement.table import MOST_FAULTS, Table

BoolArray = npt.NDArray[np.bool_]
IntArray = npt.NDArray[np.int64]

SAME = 3  # cells for each text that is wrong: from there on few slips of whoever wrote the file
MOST_NAMED = 5  # of the other lines
DECIMAL_COMMA = r"^[+-]?\d*,\d+$"
LONGEST_SHOWN = 40  # characters of a cell in a message
AXIS_LETTERS = ("X", "Y", "Z", "A", "B", "C")


def check_columns(
    table: Table, machine: MachineAxes, faults: Faults, *, required: Sequence[str], optional: Sequence[str]
) -> None:
    """Note missing and unknown columns. The axes of the machine are required besides `required`."""
    names, axes = table.frame.columns, machine.axes
    for axis in axes:
        if axis not in names:
            faults.add(f"column {axis}", "is missing", f"machine {machine.name} has axis {axis}: give its position")
    for name in required:
        if name not in names:
            faults.add(f"column {name}", "is missing")
    known = (*required, *axes, *optional)
    for name in names:
        letter = name.removeprefix("dir_")
        if name in known:
            continue
        if letter in AXIS_LETTERS and letter not in axes:
            faults.add(f"column {name}", f"machine {machine.name} has no axis {letter}", f"axes {' '.join(axes)}")
        else:
            close = get_close_matches(name, known, n=1)
            remedy = f"did you mean {close[0]}?" if close else f"known: {', '.join(known)}"
            faults.add(f"column {shortened(name)}", "is not a known column", remedy)


def numbers(table: Table, name: str, faults: Faults, *, may_be_empty: bool = False) -> FloatArray:
    """A column as finite numbers, (n,), NaN where a cell is empty or wrong; wrong cells are noted."""
    column = table.frame[name]
    commas = np.zeros(len(column), dtype=bool)
    if column.dtype == pl.String:
        text = column.str.strip_chars().fill_null("")
        empty = (text == "").to_numpy()
        cast = text.cast(pl.Float64, strict=False)
        commas = text.str.contains(DECIMAL_COMMA).to_numpy()
    elif column.dtype.is_numeric() or column.dtype == pl.Null:
        empty = column.is_null().to_numpy()
        cast = column.cast(pl.Float64, strict=False)
    else:
        faults.add(f"column {name}", f"holds {column.dtype}", "numbers")
        return np.full(len(column), np.nan)
    unread = cast.is_null().to_numpy() & ~empty
    values = np.array(cast.fill_null(np.nan), dtype=np.float64)
    infinite = ~np.isfinite(values) & ~empty & ~unread
    note(table, name, unread & ~commas, faults, "is not a number")
    if commas.any():
        first = int(np.flatnonzero(commas)[0])
        also = f", and so have {commas.sum() - 1} more cells of the column" if commas.sum() > 1 else ""
        problem = f"{_quoted(column[first])}has a decimal comma{also}"
        faults.add(table.place(first, name), problem, "decimal points; the command import reads tables with commas")
    note(table, name, infinite, faults, "is not a finite number")
    if not may_be_empty:
        note(table, name, empty, faults, "is empty", remedy="a number")
    values[infinite] = np.nan
    return values


def whole_numbers(table: Table, name: str, faults: Faults) -> IntArray:
    """A column as whole numbers, (n,), 0 where a cell is wrong; wrong cells are noted."""
    values = numbers(table, name, faults)
    known = np.isfinite(values)
    wrong = known & ((values != np.round(values)) | (np.abs(values) > 2.0**53))
    note(table, name, wrong, faults, "is not a whole number")
    return np.where(known & ~wrong, values, 0.0).astype(np.int64)


def texts(table: Table, name: str, faults: Faults) -> pl.Series:
    """A column as text without surrounding spaces; empty cells are noted."""
    column = table.frame[name]
    if column.dtype in (pl.Categorical, pl.Enum) or column.dtype.is_integer():
        column = column.cast(pl.String)
    if column.dtype != pl.String:
        faults.add(f"column {name}", f"holds {column.dtype}", "texts")
        return pl.Series(name, [""] * len(column), dtype=pl.String)
    found = column.str.strip_chars().fill_null("")
    note(table, name, (found == "").to_numpy(), faults, "is empty", remedy="a text")
    return found


def within(table: Table, name: str, faults: Faults, low: float, high: float, unit: str) -> FloatArray:
    """A column as numbers, (n,), NaN where a cell is empty or wrong; those beyond the limits are noted."""
    values = numbers(table, name, faults, may_be_empty=True)
    remedy = f"{unit}, from {low:g} to {high:g}"
    note(table, name, (values < low) | (values > high), faults, "is outside what can be", remedy=remedy)
    return values


def time_feed_temperature(table: Table, faults: Faults) -> dict[str, FloatArray]:
    """Those of the columns time_s, feed and temperature_c that are there, (n,) each, NaN where a cell is empty."""
    limits = {
        "time_s": (-LONGEST_TIME, LONGEST_TIME, "s"),
        "feed": (0.0, FASTEST, "mm/min"),
        "temperature_c": (COLDEST, WARMEST, "degC"),
    }
    return {name: within(table, name, faults, *limits[name]) for name in limits if name in table.frame.columns}


def approaches(table: Table, name: str, faults: Faults) -> FloatArray:
    """A column of approach directions, (n,): +1, -1 or 0, NaN where a cell is empty or wrong; wrong ones are noted."""
    values = numbers(table, name, faults, may_be_empty=True)
    wrong = ~np.isnan(values) & ~np.isin(values, (-1.0, 0.0, 1.0))
    note(table, name, wrong, faults, "is not a direction", remedy="+1, -1 or 0")
    return values


def positions(table: Table, machine: MachineAxes, faults: Faults) -> FloatArray:
    """Commanded axis positions, (n_axes, n), mm or deg; of those outside the travel the first is noted, and how many
    more: data of another machine have little else.
    """
    found = np.zeros((len(machine.axes), table.frame.height))
    for row, axis in enumerate(machine.axes):
        if axis in table.frame.columns:  # else noted already
            found[row] = values = numbers(table, axis, faults)
            low, high = machine.travel[axis]
            outside = np.flatnonzero((values < low) | (values > high))
            if outside.size:
                first, least, most = int(outside[0]), values[outside].min(), values[outside].max()
                also = f", and so in {outside.size - 1} more, from {least:g} to {most:g}" if outside.size > 1 else ""
                problem = f"{_quoted(table.frame[axis][first])}is outside the travel{also}"
                faults.add(table.place(first, axis), problem, f"from {low!r} to {high!r}")
    return found


def note(table: Table, name: str, wrong: BoolArray, faults: Faults, problem: str, *, remedy: str = "") -> None:
    """Note the cells that are wrong in one way, the first ones each and the rest as a count; a text that is wrong in
    many cells is one fault.
    """
    rows = np.flatnonzero(wrong)
    if not rows.size:
        return
    same = _rows_of_texts(table.frame[name].gather(rows), rows)
    for first, *others in same:
        named = ", ".join(table.place(row) for row in others[:MOST_NAMED])
        also = f", and so in {len(others)} more: {named}{' ...' if len(others) > MOST_NAMED else ''}" if others else ""
        faults.add(table.place(first, name), f"{_quoted(table.frame[name][first])}{problem}{also}", remedy)
    if same:
        return
    for row in rows[:MOST_FAULTS]:
        cell = table.frame[name][int(row)]
        faults.add(table.place(int(row), name), f"{_quoted(cell)}{problem}", remedy)
    if len(rows) > MOST_FAULTS:
        faults.add(f"column {name}", f"and so {len(rows) - MOST_FAULTS} more cells")


def _rows_of_texts(cells: pl.Series, rows: IntArray) -> list[list[int]]:
    """By text the rows whose cells have it, where there are few texts for many cells; else empty."""
    if cells.dtype != pl.String:
        return []
    texts_of = cells.fill_null("")
    if texts_of.n_unique() * SAME > len(cells) or texts_of.n_unique() > MOST_FAULTS:
        return []
    return [rows[(texts_of == text).to_numpy()].tolist() for text in texts_of.unique(maintain_order=True)]


def _quoted(cell: object) -> str:
    if cell is None or not str(cell).strip():
        return ""
    return f'"{shortened(cell)}" ' if isinstance(cell, str) else f"{shortened(str(cell))} "


def shortened(text: str) -> str:
    """A text of a cell as a message shows it."""
    return text if len(text) <= LONGEST_SHOWN else f"{text[: LONGEST_SHOWN - 4]} ..."
