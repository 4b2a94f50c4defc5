"""Instrument files to a folder of measured data."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import get_args

import polars as pl

from trueaxis.instrument_files.data_folder import readings_bytes, renamed, setup_text
from trueaxis.instrument_files.data_run import DataRun, ToolView, data_run
from trueaxis.instrument_files.read import Format, read_instrument_file
from trueaxis.instrument_files.user_keys import Question, UserKeys
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering, input_bytes
from trueaxis.io.safe_text import shown
from trueaxis.jobs.given import kernels_of
from trueaxis.jobs.load import DataFolder, load_data
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.jobs.printed import Printed
from trueaxis.jobs.tables import Tabular
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine import Machine
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.instrument_run import InstrumentRun
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

COMPENSATION = "compensation"
LONGEST_LIST = 200  # characters of the columns that were not read
HELD = "holds other measured data, which would be lost"
REPLACED = "another folder, or --replace (in Python replace=True)"
KeyValue = str | float | Sequence[float]
Ask = Callable[[Question, Mapping[str, str], Sequence[Fault]], str]


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedRun:
    """A run of the new folder. file: that it comes from; readings: how many; assumed: what the file does not say;
    unused: heads of its columns that were not read.
    """

    id: str
    file: Path
    readings: int
    assumed: tuple[str, ...]
    unused: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Imported(Printed, Tabular):
    """folder: of measured data, written; runs: that it holds. Printed, it is what `trueaxis import` says."""

    folder: Path
    runs: tuple[ImportedRun, ...]
    machine: Machine

    @property
    def data(self) -> DataFolder:
        """The folder, read. Raises InputError where it has been made wrong since."""
        return load_data(self.folder, self.machine)

    def to_polars(self) -> pl.DataFrame:
        """The readings as in readings.csv."""
        return self.data.to_polars()

    def __str__(self) -> str:
        lines = []
        for one in self.runs:
            lines.append(f"{shown(one.id)}: {one.readings} readings of {shown(one.file.name)}")
            if one.assumed:
                lines.append(f"  not in the file: {', '.join(one.assumed)}")
            if one.unused:
                lines.append(f"  columns not read (--map column.NAME): {shown(', '.join(one.unused), LONGEST_LIST)}")
        what = f"{len(self.runs)} runs; {setup_file.FILE_NAME} marks what is assumed: check it"
        return "\n".join([*lines, f"{named(self.folder)}: {what}"]) + "\n"


@typed
def import_readings(
    files: AnyPath | Sequence[AnyPath],
    machine: Machine | MachineModel,
    out: AnyPath,
    *,
    format: Format | None = None,  # noqa: A002  the word of the command
    keys: Mapping[str, KeyValue] | None = None,
    replace: bool = False,
) -> Imported:
    """Convert files of instruments to the folder `out` of measured data: setup.toml and readings.csv, both or none.

    format: of all files, "rtl", "iso230-2", "ballbar-csv" or "csv"; None: by their content. keys: what the files
    do not say, such as {"axis": "X", "target.point": (0, 0, -150), "X1:at.Y": 200}, mm and deg, for all runs or as
    RUN:KEY for one; docs/import.md lists them. replace: whether other data that `out` holds may be lost. machine: with
    its kernels (`load_model`) where a ball bar is among them, and with values of the dimensions that its spec names.
    Raises InputError with every fault of every file and what is missing; ValueError for arguments of another form.
    """
    if format is not None and format not in get_args(Format):
        raise ValueError(f"format: expected one of {', '.join(get_args(Format))}; given {format!r}")
    spec = machine.machine if isinstance(machine, MachineModel) else machine
    paths = [Path(one) for one in ([files] if isinstance(files, str | PathLike) else files)]
    if not paths:
        raise ValueError("files: expected a file or several; given none")
    given = {key: key_text(key, value) for key, value in (keys or {}).items()}

    def model() -> MachineModel:
        if not isinstance(machine, MachineModel):
            raise ValueError("machine: expected a model (load_model), for where the ball stands; given a machine alone")
        return machine

    errors = machine.errors if isinstance(machine, MachineModel) else None
    inputs = {"the spec": spec.source, **{f"file {number}": path for number, path in enumerate(paths, 1)}}
    kernels = kernels_of(machine) if isinstance(machine, MachineModel) else None
    found = faults_of_out(Path(out), inputs, kernels)
    return imported(
        paths, spec, Path(out), tool_view(spec, errors, model), given, format=format, found=found, replace=replace
    )


def tool_view(machine: Machine, errors: ErrorValues | None, model: Callable[[], MachineModel]) -> ToolView:
    """Where points of the tool are on the workpiece. model: is asked for where a file does not say where a ball stands;
    errors: its values.
    """
    given = () if errors is None else errors.parameters
    zero = tuple(name for name in machine.dimensions if name not in given)
    return ToolView(lambda positions, point: model().ideal(positions, point), zero)


def key_text(key: str, value: KeyValue) -> str:
    """The value of a key as --map has it. Raises ValueError where it is no text, number or row of numbers."""
    if isinstance(value, str):
        return value
    try:
        numbers = [float(value)] if isinstance(value, int | float) else [float(one) for one in value]
    except (TypeError, ValueError):
        raise ValueError(f"keys[{key!r}]: expected a text, a number or numbers; given {value!r}") from None
    return ",".join(repr(one).removesuffix(".0") for one in numbers)


def imported(
    files: Sequence[Path],
    machine: Machine,
    out: Path,
    view: ToolView,
    given: dict[str, str],
    *,
    format: Format | None = None,  # noqa: A002
    found: Sequence[Fault] = (),
    ask: Ask | None = None,
    replace: bool = False,
) -> Imported:
    """As `import_readings`. found: faults so far, told with those of the files; ask: gives what a run lacks, from a
    person; given takes it in. An answer that is wrong is asked for again, with its faults.
    """
    unknown = UserKeys(given=given).unknown()
    asked: Question | None = None
    while True:
        runs, keys = _runs(files, machine, view, given, format, found)
        wrong: Sequence[Fault] = ()
        if ask is not None and asked is not None and asked.name in keys.wrong:
            wrong, question = keys.faults, asked
            del given[asked.name]
        elif ask is None or found or unknown or keys.faults or not keys.questions:
            break
        else:
            question = keys.questions[0]
        given[question.name] = ask(question, given, wrong)
        asked = question
    faults = [*unknown, *keys.faults, *(question.fault for question in keys.questions)]
    if not faults:
        faults = keys.unused()
    if found or faults:
        raise InputError([*found, *faults])
    ready = renamed(tuple(runs))
    made: dict[Path, bytes | str] = {
        out / setup_file.FILE_NAME: setup_text(ready, machine.name, given.get(COMPENSATION)),
        out / readings_files.FILE_NAME: readings_bytes(ready, machine.axes),
    }
    if not replace and (lost := [path for path, text in made.items() if _differs(path, text)]):
        raise InputError([Fault(str(path), "", HELD, REPLACED) for path in lost])
    write_files(made)
    return Imported(folder=out, runs=tuple(map(_run, ready)), machine=machine)


def _differs(path: Path, text: bytes | str) -> bool:
    """Whether a file is there that holds something else."""
    data = text.encode() if isinstance(text, str) else text
    return path.exists() and input_bytes(path) != data


def faults_of_out(out: Path, inputs: Mapping[str, Path | None], kernels: Path | None = None) -> list[Fault]:
    """Faults of a folder that is to be written."""
    other = out / readings_files.PARQUET_NAME
    if other.exists():
        return [Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it")]
    outputs: dict[str, Path | None] = {
        f"{name} of --out": out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)
    }
    return overwritten(inputs, outputs, kernels)


def _run(item: DataRun) -> ImportedRun:
    assumed = sorted({key for key in item.assumed.sources if key != "id"})
    return ImportedRun(
        id=item.run.id,
        file=Path(item.source.file),
        readings=int(item.reading.size),
        assumed=tuple(assumed),
        unused=item.source.unused,
    )


def _runs(
    files: Sequence[Path],
    machine: Machine,
    view: ToolView,
    given: dict[str, str],
    of: Format | None,
    found: Sequence[Fault],
) -> tuple[list[DataRun], UserKeys]:
    """The runs that can be made with these keys; what else is needed is noted in the keys.

    Raises InputError where a file is wrong, with the faults of all files and those found before.
    """
    keys = UserKeys(given=given, used={COMPENSATION})
    faults: list[Fault] = list(found)
    sources: list[InstrumentRun] = []
    for path in files:
        with gathering(faults):
            sources += read_instrument_file(path, of, keys)
    if faults:
        raise InputError([*faults, *keys.unknown()])
    runs = [data_run(source, machine, keys, view) for source in sources]
    return [item for item in runs if item is not None], keys
