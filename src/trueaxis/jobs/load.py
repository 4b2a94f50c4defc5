"""Files in, records out: a machine, its model, error values with their covariance, measured data."""

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

import polars as pl

from trueaxis.io.files import write_files
from trueaxis.jobs.derive import KERNELS
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import Tabular
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine import Machine, read_machine
from trueaxis.measurement import readings, setup
from trueaxis.measurement.active_compensation import active_values, moved_setup
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.model import model as models
from trueaxis.model.covariance import Covariance
from trueaxis.model.covariance_file import linked
from trueaxis.model.errors import ErrorValues, dump_errors
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import load_uncertainty
from trueaxis.reporting.error_table import errors_frame, errors_html, errors_text


@dataclass(frozen=True, slots=True, eq=False)
class Errors(Tabular):
    """Error values of a machine and what is known of their uncertainty, all values together. file: where they were
    read, which faults name, None where they are in no file; machine: they are of, for ranges and units of the table.
    """

    values: ErrorValues
    covariance: Covariance
    file: Path | None = None
    machine: Machine | None = None

    def to_polars(self) -> pl.DataFrame:
        """A row for each error: value (of a component its largest, at the position `at`), u, what determines it."""
        return errors_frame(self.values, self.covariance, self.machine)

    def __str__(self) -> str:
        return errors_text(self.values, self.covariance, self.machine)

    def _repr_html_(self) -> str:
        return errors_html(self.values, self.covariance, self.machine)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class DataFolder(Printed, Tabular):
    """Measured data or a measuring plan. folder: where it was read, which faults name; data: runs and readings; active:
    the error values that the control compensated with while measuring, None where none did or nothing is said of it.
    """

    folder: Path
    data: MeasuredData = field(repr=False)
    active: ErrorValues | None = field(default=None, repr=False)

    def __str__(self) -> str:
        runs = Counter(run.instrument for run in self.data.setup.runs)
        kinds = ", ".join(f"{count} of {kind}" for kind, count in runs.items())
        return f"{self.folder}: {self.data.readings.reading.size} readings in {sum(runs.values())} runs ({kinds})"

    def to_polars(self) -> pl.DataFrame:
        """The readings as in readings.csv: a row each; what is not measured yet has no reading."""
        return readings.readings_frame(self.data.readings, self.data.setup.runs)


@typed
def load_machine(path: AnyPath) -> Machine:
    """Read a machine spec. Raises InputError with every fault of the file."""
    return read_machine(Path(path))


@typed
def load_model(machine: AnyPath, kernels: AnyPath = KERNELS) -> MachineModel:
    """Read a machine spec and the kernels that `derive` wrote for it: the machine without errors.

    Raises InputError with every fault, kernels that were derived from another spec included.
    """
    return models.load_model(Path(machine), None, Path(kernels))


@typed
def load_errors(path: AnyPath, machine: Machine | MachineModel, covariance: AnyPath | None = None) -> Errors:
    """Read error values (errors.json) and the covariance that they name, or the file that is given.

    Raises InputError with every fault; values that were edited since they were identified have no covariance.
    """
    spec = _spec_of(machine)
    values = models.load_errors(Path(path), spec)
    file = None if covariance is None else Path(covariance)
    return Errors(values, load_uncertainty(Path(path), values, spec, file), Path(path), spec)


@typed
def save_errors(path: AnyPath, errors: Errors, machine: Machine | MachineModel) -> tuple[Path, ...]:
    """Write error values and, beside them with the ending .npz, their covariance: both whole or not at all.

    Returns both paths. Raises InputError where they cannot be written.
    """
    files = errors_files(Path(path), errors, _spec_of(machine))
    write_files(files)
    return tuple(files)


def errors_files(
    out: Path, errors: Errors, machine: Machine, covariance: Path | None = None
) -> dict[Path, str | bytes]:
    """Content of the file of the covariance (default: beside `out`, ending .npz) and of that of the values."""
    file = covariance or out.with_suffix(".npz")
    values, content = linked(errors.values, errors.covariance, out, file)
    text = dump_errors(values, components=machine.components, parameters=machine.parameters, effects=machine.effects)
    return {file: content, out: text}


@typed
def load_data(folder: AnyPath, machine: Machine | MachineModel) -> DataFolder:
    """Read a folder of measured data or a measuring plan: setup.toml, readings.csv, and what setup.toml names.

    Raises InputError with every fault of all files.
    """
    spec = _spec_of(machine)
    data = read_data(Path(folder), spec)
    return DataFolder(folder=Path(folder), data=data, active=active_values(Path(folder), data.setup, spec))


@typed
def save_data(folder: AnyPath, data: DataFolder) -> tuple[Path, ...]:
    """Write measured data into another folder: readings.csv and a copy of setup.toml, both whole or not at all.

    Raises InputError where they cannot be written.
    """
    files = data_files(Path(folder), data)
    write_files(files)
    return tuple(files)


def data_files(out: Path, data: DataFolder) -> dict[Path, str | bytes]:
    """Content of the files of a data folder."""
    return {
        out / setup.FILE_NAME: moved_setup(data.folder, out),
        out / readings.FILE_NAME: readings.dump_readings(data.data.readings, data.data.setup.runs),
    }


def _spec_of(machine: Machine | MachineModel) -> Machine:
    return machine.machine if isinstance(machine, MachineModel) else machine
