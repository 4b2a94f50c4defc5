"""A folder of measured data: its setup and its readings, read together."""

from dataclasses import dataclass
from pathlib import Path

from trueaxis.io.faults import Fault, InputError
from trueaxis.io.input_files import gathering
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.machine import MachineAxes
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.readings_reader import read_readings
from trueaxis.measurement.setup import Setup
from trueaxis.measurement.setup_reader import read_setup


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
