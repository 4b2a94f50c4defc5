"""CSV and Parquet files as tables of cells whose places can be named.

Polars parses; what it would pass over in silence (short lines, repeated columns, stray quotes) is checked first.
"""

import csv
import io
import re
from dataclasses import dataclass
from pathlib import Path
from subprocess import DEVNULL, PIPE

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.measurement.limits import MOST_COLUMNS
from trueaxis.own_python import own_python

IntArray = npt.NDArray[np.int64]

MOST_FAULTS = 20  # of one kind in one column: a wrong column of a million cells need not fill the screen

_PARQUET_TO_IPC = """
import io, sys, polars
polars.read_parquet(io.BytesIO(sys.stdin.buffer.read())).write_ipc(sys.stdout.buffer)
"""
_BLANK_LINE = re.compile(r"(?:\A|\n)[ \t]*(?:\n|\Z)")
_QUOTE, _COMMA, _NEWLINE = b'",\n'


@dataclass(frozen=True, slots=True)
class Table:
    """The cells of a table file.

    frame: the columns under their names, as text (CSV) or as they are typed (Parquet); lines: line number of
    each row in a CSV file, None for Parquet, whose rows have no lines.
    """

    frame: pl.DataFrame
    lines: IntArray | None

    def place(self, row: int, column: str = "") -> str:
        """`line 12, column X`."""
        where = f"row {row + 1}" if self.lines is None else f"line {self.lines[row]}"
        return f"{where}, column {column}" if column else where


def read_table(path: Path) -> Table:
    """Read a CSV file with a header line, or a Parquet file where the name ends in .parquet.

    Raises InputError where the file is no such table.
    """
    data = input_bytes(path)
    faults = Faults(str(path))
    table = _parquet(data, faults) if path.suffix == ".parquet" else _csv(path, data, faults)
    if table is not None and table.frame.width > MOST_COLUMNS:
        faults.add("", *_too_many(table.frame.width))
    if table is None or faults.found:
        raise InputError(faults.found)
    return table


def table_bytes(frame: pl.DataFrame, suffix: str) -> bytes:
    """The content of a table file: Parquet for `.parquet`, else CSV with the shortest digits that read back exactly."""
    if suffix == ".parquet":
        buffer = io.BytesIO()
        frame.write_parquet(buffer)
        return buffer.getvalue()
    return frame.write_csv().encode()


def _parquet(data: bytes, faults: Faults) -> Table | None:
    """Parse in a process of its own: on some damaged files Polars does not raise but aborts the process."""
    with own_python("-c", _PARQUET_TO_IPC, stdin=PIPE, stdout=PIPE, stderr=DEVNULL) as child:
        try:
            told, _ = child.communicate(data)
        finally:
            child.kill()
    if child.returncode != 0:
        faults.add("", "is not Parquet, or is damaged")
        return None
    return Table(pl.read_ipc(io.BytesIO(told)), None)


def _csv(path: Path, data: bytes, faults: Faults) -> Table | None:
    text = utf8_text(path, data).replace("\r\n", "\n").replace("\r", "\n").rstrip("\n")
    lines = np.arange(1, text.count("\n") + 2, dtype=np.int64)
    if _BLANK_LINE.search(text):
        kept = [(number, line) for number, line in enumerate(text.split("\n"), start=1) if line.strip()]
        lines = np.array([number for number, _ in kept], dtype=np.int64)
        text = "\n".join(line for _, line in kept)
    if not text:
        faults.add("", "is empty", "a header line and a line per row")
        return None
    header, _, body = text.partition("\n")
    names = _header(header, f"line {lines[0]}", faults)
    _check_shape(text.encode(), len(names), lines, faults)
    if faults.found:
        return None
    schema = dict.fromkeys(names, pl.String)
    if not body:
        return Table(pl.DataFrame(schema=schema), lines[1:])
    try:
        frame = pl.read_csv(body.encode(), has_header=False, schema=schema)
    except (pl.exceptions.PolarsError, pl.exceptions.PanicException) as error:
        faults.add("", f"is not CSV: {_first_line(error)}")
        return None
    if frame.height != len(lines) - 1:
        faults.add("", "is not CSV: its quotes do not match")
        return None
    return Table(frame, lines[1:])


def _too_many(columns: int) -> tuple[str, str]:
    return f"has {columns} columns", f"{MOST_COLUMNS} at most"


def _header(line: str, place: str, faults: Faults) -> list[str]:
    try:
        names = [name.strip() for name in next(csv.reader([line]))]
    except (csv.Error, StopIteration):
        names = [line]
    if len(names) > MOST_COLUMNS:
        faults.add(place, *_too_many(len(names)))
        return names
    seen: set[str] = set()
    for name in names:
        if not name:
            faults.add(place, "a column has no name", "a name for each column")
        elif name in seen:
            faults.add(place, f"column {name} is given more than once", "keep one")
        seen.add(name)
    if len(names) == 1 and (";" in line or "\t" in line):
        faults.add(place, "columns are not separated by commas", "commas between columns, points in numbers")
    return names


def _check_shape(data: bytes, width: int, lines: IntArray, faults: Faults) -> None:
    """Every line must have as many cells as the header and close the quotes that it opens (RFC 4180)."""
    cells = np.frombuffer(data, dtype=np.uint8)
    ends = np.append(np.flatnonzero(cells == _NEWLINE), len(cells))
    commas = np.flatnonzero(cells == _COMMA)
    quotes = np.flatnonzero(cells == _QUOTE)
    if len(quotes):
        before = np.searchsorted(quotes, ends)
        odd = np.flatnonzero(np.diff(before, prepend=0) % 2)
        _report(odd, lines, "a quote is not closed", 'a quote within a cell is doubled: ""', faults)
        if len(odd):
            return
        padded = np.concatenate(([_NEWLINE], cells, [_NEWLINE]))
        beside = np.where(np.arange(len(quotes)) % 2, padded[quotes + 2], padded[quotes])
        stray = quotes[~np.isin(beside, (_QUOTE, _COMMA, _NEWLINE))]
        rows = np.unique(np.searchsorted(ends, stray))
        _report(rows, lines, "a quote stands inside a cell", "quotes enclose a whole cell", faults)
        commas = commas[np.searchsorted(quotes, commas) % 2 == 0]
    counts = np.diff(np.searchsorted(commas, ends), prepend=0) + 1
    wrong = np.flatnonzero(counts != width)
    for row in wrong[:MOST_FAULTS]:
        faults.add(f"line {lines[row]}", f"has {counts[row]} cells", f"{width} as in the header")
    _more(len(wrong), faults)


def _report(rows: IntArray, lines: IntArray, problem: str, remedy: str, faults: Faults) -> None:
    for row in rows[:MOST_FAULTS]:
        faults.add(f"line {lines[row]}", problem, remedy)
    _more(len(rows), faults)


def _more(count: int, faults: Faults) -> None:
    if count > MOST_FAULTS:
        faults.add("", f"and so {count - MOST_FAULTS} more lines")


def _first_line(error: BaseException) -> str:
    return (str(error).strip() or type(error).__name__).splitlines()[0]
