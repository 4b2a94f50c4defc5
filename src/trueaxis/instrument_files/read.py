"""An instrument file of whichever format, known by its content; positioning tests of ISO 230-2 as runs of a laser."""

from pathlib import Path
from typing import Literal

import numpy as np

from trueaxis.evaluation.positioning_dat_file import read_dat
from trueaxis.evaluation.positioning_table_file import COLUMNS, TABLES, read_positioning_test
from trueaxis.instrument_files.csv_file import is_ball_bar, read_csv
from trueaxis.instrument_files.rtl_file import is_rtl, read_rtl
from trueaxis.instrument_files.user_keys import UserKeys
from trueaxis.io.input_files import input_bytes
from trueaxis.measurement.delimited import heading, read_delimited
from trueaxis.measurement.instrument_run import InstrumentRun

Format = Literal["rtl", "iso230-2", "ballbar-csv", "csv"]
FORMATS: tuple[Format, ...] = ("rtl", "iso230-2", "ballbar-csv", "csv")
_START = 100_000  # bytes in which a format shows
ORDER = "the targets were approached cycle by cycle, all in the positive direction and then all in the negative one"


def read_instrument_file(path: Path, of: Format | None, keys: UserKeys) -> tuple[InstrumentRun, ...]:
    """The runs of a file. `of`: its format, None: as its content shows.

    Raises InputError with every fault of the file; what a table of columns does not say is a question in `keys`.
    """
    of = of or recognised(path)
    if of == "rtl":
        return (read_rtl(path),)
    if of == "iso230-2":
        return (_read_positioning(path),)
    return read_csv(path, keys, ballbar=of == "ballbar-csv")


def recognised(path: Path) -> Format:
    """The format that the content shows. Raises InputError where it shows none."""
    data = input_bytes(path)
    if is_rtl(data):
        return "rtl"
    start = data[:_START]
    if path.suffix == ".parquet" or b"TGT_DATA[" in start:
        return "iso230-2"
    first = start.removeprefix(b"\xef\xbb\xbf").lstrip().split(b"\n", 1)[0].replace(b" ", b"").strip()
    if sorted(first.split(b",")) == sorted(name.encode() for name in COLUMNS):
        return "iso230-2"
    header = read_delimited(path).header
    if sorted(heading(name).name for name in header) == sorted(COLUMNS):
        return "iso230-2"
    return "ballbar-csv" if is_ball_bar(header) else "csv"


def _read_positioning(path: Path) -> InstrumentRun:
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
