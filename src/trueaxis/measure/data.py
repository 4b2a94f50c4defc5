"""A folder of measured data: its setup and its readings, read together."""

from dataclasses import dataclass
from pathlib import Path

from trueaxis.faults import Fault, InputError
from trueaxis.input_files import gathering
from trueaxis.measure import readings as readings_files
from trueaxis.measure import setup as setup_file
from trueaxis.measure.machine import MachineAxes
from trueaxis.measure.readings import Readings
from trueaxis.measure.readings_reader import read_readings
from trueaxis.measure.setup import Setup
from trueaxis.measure.setup_reader import read_setup


@dataclass(frozen=True, slots=True)
class MeasuredData:
    """The setup of the runs and their readings."""

    setup: Setup
    readings: Readings


def read_data(folder: Path, machine: MachineAxes) -> MeasuredData:
    """Read setup.toml and readings.csv (or readings.parquet) of a folder.

    Raises InputError with every fault of both files.
    """
    found: list[Fault] = []
    runs = None
    with gathering(found):
        setup = read_setup(folder / setup_file.FILE_NAME, machine)
        runs = setup.runs
    with gathering(found):
        readings = read_readings(readings_path(folder), machine, runs)
    if found:
        raise InputError(found)
    return MeasuredData(setup, readings)


def readings_path(folder: Path) -> Path:
    """The readings file of a folder. Raises InputError where it has two of them."""
    csv, parquet = folder / readings_files.FILE_NAME, folder / readings_files.PARQUET_NAME
    if csv.exists() and parquet.exists():
        problem = f"has both {csv.name} and {parquet.name}"
        raise InputError([Fault(str(folder), "", problem, "keep one")])
    return parquet if parquet.exists() else csv
