"""Text files of columns: any separator, comma or point decimals, text before the header, units in its names."""

import csv
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
import polars as pl

from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import decoded, input_bytes
from trueaxis.measurement.instrument_run import MOST_ROWS
from trueaxis.measurement.limits import MOST_COLUMNS
from trueaxis.measurement.table import Table

SEPARATORS = (";", "\t", ",", "|")  # in the order in which they are tried: a comma may be that of decimals
MOST_PREAMBLE = 200  # lines before the header: a page of text
Dimension = Literal["length", "angle", "time", "feed", "temperature"]

# name -> dimension and what one of it is in mm, deg, s, mm/min, degC
UNITS: dict[str, tuple[Dimension, float]] = {
    "mm": ("length", 1.0), "um": ("length", 1e-3), "µm": ("length", 1e-3), "μm": ("length", 1e-3),
    "micron": ("length", 1e-3), "microns": ("length", 1e-3), "nm": ("length", 1e-6), "m": ("length", 1e3),
    "in": ("length", 25.4), "inch": ("length", 25.4),
    "deg": ("angle", 1.0), "°": ("angle", 1.0), "rad": ("angle", math.degrees(1.0)),
    "mrad": ("angle", math.degrees(1e-3)), "urad": ("angle", math.degrees(1e-6)), "µrad": ("angle", math.degrees(1e-6)),
    "μrad": ("angle", math.degrees(1e-6)), "arcmin": ("angle", 1.0 / 60.0), "arcsec": ("angle", 1.0 / 3600.0),
    # slopes, as levels show them: of a milliradian the tangent is 3e-10 more than the angle
    "mm/m": ("angle", math.degrees(1e-3)), "um/m": ("angle", math.degrees(1e-6)), "µm/m": ("angle", math.degrees(1e-6)),
    "μm/m": ("angle", math.degrees(1e-6)),
    "s": ("time", 1.0), "ms": ("time", 1e-3), "min": ("time", 60.0), "h": ("time", 3600.0),
    "mm/min": ("feed", 1.0), "m/min": ("feed", 1e3), "mm/s": ("feed", 60.0),
    "degc": ("temperature", 1.0), "°c": ("temperature", 1.0), "c": ("temperature", 1.0),
}  # fmt: skip
_WITH_UNIT = re.compile(r"(.*?)\s*(?:\[(?P<square>[^\[\]]*)\]|\((?P<round>[^()]*)\)|\s*/\s*(?P<slash>\S+))")
_SUFFIX = re.compile(r"(.+)_(mm|um|nm|deg|rad|mrad|urad|arcsec|s|c|mm_min)", re.IGNORECASE)
_NO_UNIT = ("", "-")  # in a line of units
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]{1,3})?")


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
        if not lines:
            problem = "is empty"
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
    width = len(_cells(lines[start][1], separator))
    above = [_of_width(_cells(line, separator), width) for _, line in lines[:start]]
    header, units = above[-1], tuple[str, ...]()
    if len(above) > 1 and len(above[-2]) == width == len(above[-1]) and _are_units(above[-1]):
        header, units = above[-2], tuple("" if cell in _NO_UNIT else cell for cell in above[-1])
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
        above = _of_width(_cells(lines[index - 1][1], separator), len(cells))
        if len(above) == len(cells) and not any(decimal(cell) is not None for cell in above):
            return index
    return None


def _are_units(cells: tuple[str, ...]) -> bool:
    return all(cell in _NO_UNIT or cell.strip("[]()").strip().lower() in UNITS for cell in cells)


def _of_width(cells: tuple[str, ...], width: int) -> tuple[str, ...]:
    """A line of units whose last columns have none, with as many cells as the others."""
    return cells + ("",) * (width - len(cells)) if _are_units(cells) else cells


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


@dataclass(frozen=True, slots=True)
class Heading:
    """The head of a column: its name in small letters without the unit, and the unit, empty where there is none."""

    text: str
    name: str
    unit: str


def heading(text: str) -> Heading:
    """`Error [um]`, `Error (um)`, `Error / um` and `error_um` as name and unit."""
    text = text.strip()
    if parts := _WITH_UNIT.fullmatch(text):
        unit = parts["square"] or parts["round"] or parts["slash"] or ""
        return Heading(text, parts[1].strip().lower(), unit.strip().lower())
    if parts := _SUFFIX.fullmatch(text):
        return Heading(text, parts[1].lower(), parts[2].lower().replace("mm_min", "mm/min"))
    return Heading(text, text.lower(), "")


def called(name: str, heads: Sequence[Heading]) -> list[int]:
    """Which columns have a name: by their whole head or, where none has, without its unit."""
    whole = [index for index, head in enumerate(heads) if head.text == name]
    return whole or [index for index, head in enumerate(heads) if head.name == name.lower()]


def factor(unit: str, dimension: Dimension) -> float | None:
    """What one of the unit is in mm, deg, s, mm/min or degC; None where it is no unit of that dimension."""
    found = UNITS.get(unit.strip().lower())
    return found[1] if found is not None and found[0] == dimension else None


def units_of(*dimensions: Dimension) -> str:
    """The units of dimensions as a message lists them."""
    return ", ".join(name for name, (of, _) in UNITS.items() if of in dimensions and name.isascii())


def decimal(text: str) -> float | None:
    """The number, None where the text is none or too large: no thousands separators, no second comma."""
    if not _NUMBER.fullmatch(text):
        return None
    value = float(text.replace(",", "."))
    return value if math.isfinite(value) else None
