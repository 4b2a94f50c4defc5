"""The file of a positioning test, whichever form it has."""

from pathlib import Path

from trueaxis.evaluation.iso230_2.dat_file import read_dat
from trueaxis.evaluation.iso230_2.positioning_test import PositioningTest, Unit
from trueaxis.evaluation.iso230_2.table_file import read_positioning_table
from trueaxis.io.faults import Fault, InputError

TABLES = (".csv", ".txt", ".parquet")


def read_positioning_test(path: Path, unit: Unit = "mm") -> PositioningTest:
    """Read a .dat, .csv, .txt or .parquet file; unit: of its positions. Raises InputError with every fault."""
    if path.suffix == ".dat":
        return read_dat(path, unit)
    if path.suffix in TABLES:
        return read_positioning_table(path, unit)
    raise InputError([Fault(str(path), "", "is of no known kind", "a name that ends in .dat, .csv, .txt or .parquet")])
