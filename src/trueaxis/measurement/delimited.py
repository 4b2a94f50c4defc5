"""Text files of columns: any separator, comma or point decimals, lines of text before the header."""

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polars as pl

from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import decoded, input_bytes
from trueaxis.measurement.decimals import decimal
from trueaxis.measurement.instrument_run import MOST_ROWS
from trueaxis.measurement.limits import MOST_COLUMNS
from trueaxis.measurement.table import Table
from trueaxis.measurement.units import UNITS

SEPARATORS = (";", "\t", ",", "|")  # in the order in which they are tried: a comma may be that of decimals
MOST_PREAMBLE = 200  # lines before the header: a page of text


@dataclass(frozen=True, slots=True, kw_only=True)
class DelimitedText:
    """The cells of such a file.

    header: texts of the line before the numbers; units: those of a line between header and numbers, empty where there
    is none; rows: cells without spaces around them, as many as the header has; lines: line number of each row;
    header_line: that of the header.
    """

    header: tuple[str, ...]
    units: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    lines: tuple[int, ...]
    header_line: int


def read_delimited(path: Path) -> DelimitedText:
    """Read such a file. Raises InputError with every fault, each with its line."""
    faults = Faults(str(path))
    text = decoded(input_bytes(path)).replace("\r\n", "\n").replace("\r", "\n")
    lines = [(number, line) for number, line in enumerate(text.split("\n"), start=1) if line.strip()]
    for separator in (*SEPARATORS, None):
        table = _table(lines, separator, faults)
        if table is not None or faults.found:
            break
    else:
        problem = "is of no known format: neither .rtl nor a positioning test nor columns of numbers under names"
        faults.add("", problem, "a line of names over lines of numbers, separated by ; or tabs or , or | or spaces")
    if faults.found or table is None:
        raise InputError(faults.found)
    return table


def as_table(text: DelimitedText) -> Table:
    """The cells under their names as a table, numbers with points."""
    rows = [[cell.replace(",", ".") if decimal(cell) is not None else cell for cell in row] for row in text.rows]
    schema = dict.fromkeys(text.header, pl.String)
    return Table(pl.DataFrame(rows, schema=schema, orient="row"), np.array(text.lines, dtype=np.int64))


def _table(lines: list[tuple[int, str]], separator: str | None, faults: Faults) -> DelimitedText | None:
    """The table where this separator makes one; faults of its rows are noted."""
    start = _first_numbers(lines, separator)
    if start is None or start == 0:
        return None
    above = [_cells(line, separator) for _, line in lines[:start]]
    width = len(_cells(lines[start][1], separator))
    header, units = above[-1], tuple[str, ...]()
    if len(above) > 1 and len(above[-2]) == width == len(above[-1]) and _are_units(above[-1]):
        header, units = above[-2], above[-1]
    if len(header) != width or len(header) > MOST_COLUMNS:
        return None
    number = lines[start - 1][0] if not units else lines[start - 2][0]
    for index, name in enumerate(header):
        if not name:
            faults.add(f"line {number}", f"column {index + 1} has no name", "a name for each column")
        elif name in header[:index]:
            faults.add(f"line {number}", f"column {name} is given more than once", "keep one")
    rows, at = [], []
    for line, text in lines[start:]:
        cells = _cells(text, separator)
        if len(cells) != width:
            faults.add(f"line {line}", f"has {len(cells)} cells", f"{width} as in the header")
        rows.append(cells)
        at.append(line)
        if len(faults.found) >= MOST_COLUMNS or len(rows) > MOST_ROWS:
            faults.add(f"line {line}", "reading stopped here", f"{MOST_ROWS} rows at most")
            break
    return DelimitedText(header=header, units=units, rows=tuple(rows), lines=tuple(at), header_line=number)


def _first_numbers(lines: list[tuple[int, str]], separator: str | None) -> int | None:
    """Index of the first line with two numbers or more, after a line that has as many cells and no number."""
    for index, (_, line) in enumerate(lines[: MOST_PREAMBLE + 1]):
        cells = _cells(line, separator)
        if sum(decimal(cell) is not None for cell in cells) < 2 or index == 0:
            continue
        above = _cells(lines[index - 1][1], separator)
        if len(above) == len(cells) and not any(decimal(cell) is not None for cell in above):
            return index
    return None


def _are_units(cells: tuple[str, ...]) -> bool:
    return all(not cell or cell.strip("[]()").strip().lower() in UNITS for cell in cells)


def _cells(line: str, separator: str | None) -> tuple[str, ...]:
    if separator is None:
        return tuple(line.split())
    try:
        cells = next(csv.reader([line], delimiter=separator))
    except (csv.Error, StopIteration):
        cells = line.split(separator)
    if len(cells) > 1 and not cells[-1].strip():
        cells = cells[:-1]  # a separator at the end of the line
    return tuple(cell.strip() for cell in cells)
