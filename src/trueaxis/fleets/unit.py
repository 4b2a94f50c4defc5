"""The units of a fleet, each one machine and one folder of its data: what is done, where it is read and written."""

import hashlib
import json
import tomllib
from dataclasses import dataclass
from pathlib import Path

from trueaxis import __version__
from trueaxis.fleets.fleet_file import Fleet, FleetMachine, data_folders
from trueaxis.fleets.rows import SCHEMA, Row, read_row
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.toml_lines import LARGEST_TEXT
from trueaxis.measurement import readings, setup

_DATA = (setup.FILE_NAME, readings.FILE_NAME, readings.PARQUET_NAME)
MACHINES, KERNELS = "machines", "kernels"  # folders of the results: of each machine, and of the kernels of each spec
GIVEN = "given"  # folder of a machine whose values are shown as they are given


@dataclass(frozen=True, slots=True, kw_only=True)
class Unit:
    """machine: id; data, date: as in a row; tasks; base: folder of the fleet file; spec, errors (None: not given),
    folder (of the data, None: there are none): absolute paths; out: absolute folder of its results; before: that of the
    machine's folder of data before this one, None: it is the first; kernels: folder that has one for each spec;
    version: of the program that gives the work away.
    """

    machine: str
    data: str
    date: str | None
    tasks: tuple[str, ...]
    base: Path
    spec: Path
    errors: Path | None
    folder: Path | None
    out: Path
    before: Path | None
    kernels: Path
    version: str


def values_before(unit: Unit) -> Path | None:
    """The newest error values of the machine before this folder of data: identified, or given; None: there are none."""
    row = None if unit.before is None else read_row(unit.before)
    if unit.before is not None and row is not None and row.newest is not None:
        return unit.before / row.newest
    return unit.errors


def inputs_digest(unit: Unit) -> str:
    """SHA-256 of all that the results come from: the files' content, the tasks, the version of the program."""
    files: dict[str, Path | None] = {"spec": unit.spec, **_named_in(unit.spec, "runs")}
    for name, values in (("errors", unit.errors), ("before", values_before(unit))):
        if values is not None:
            files |= {name: values, f"covariance of {name}": _covariance_of(values)}
    if unit.folder is not None:
        files |= {name: unit.folder / name for name in _DATA}
        files |= _named_in(unit.folder / setup.FILE_NAME, "compensation")
    asked = [SCHEMA, unit.version, unit.machine, unit.data, unit.tasks]
    digests = {name: None if path is None else _digest(path) for name, path in files.items()}
    return hashlib.sha256(json.dumps([asked, digests], sort_keys=True).encode()).hexdigest()


def kept_row(unit: Unit, digest: str) -> Row | None:
    """The row that was made of the same inputs, where all of its files are there still."""
    row = read_row(unit.out)
    if row is None or row.inputs != digest or not all((unit.out / name).is_file() for name in row.files):
        return None
    return row


def _named_in(file: Path, key: str) -> dict[str, Path]:
    """The file, or the set-up in the folder, that a key at the top of a TOML file names."""
    try:
        named = tomllib.loads(_text(file)).get(key)
    except ValueError:
        return {}
    if not isinstance(named, str) or named == "none":
        return {}
    path = file.parent / named
    return {key: path / setup.FILE_NAME if path.is_dir() else path}


def _covariance_of(values: Path) -> Path | None:
    """The file that error values name as that of their covariance."""
    try:
        return values.parent / str(json.loads(_text(values))["covariance"]["file"])
    except (ValueError, KeyError, TypeError):
        return None


def _text(path: Path) -> str:
    """Empty where it is no file of a size that is read."""
    try:
        if path.is_file() and path.stat().st_size <= LARGEST_TEXT:
            return path.read_text(encoding="utf-8-sig")
    except (OSError, ValueError):
        pass
    return ""


def _digest(path: Path) -> str | None:
    """SHA-256 of a file; None where it is none. A device or a pipe may have no end, and is for the worker to meet."""
    try:
        if not path.is_file():
            return None
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except (OSError, ValueError):
        return None


@dataclass(frozen=True, slots=True)
class Chain:
    """The units of a machine in the order of their dates; or the one row that says why it has none."""

    units: tuple[Unit, ...]
    row: Row | None = None


def chains_of(fleet: Fleet, out: Path) -> tuple[Chain, ...]:
    """One for each machine. out: folder of the results. Raises InputError where an input lies among the results."""
    base, out = fleet.folder.resolve(), out.resolve()
    chains = tuple(_chain(base, machine, out) for machine in fleet.machines)
    if faults := _among_results(chains, out):
        raise InputError(faults)
    return chains


def _chain(base: Path, machine: FleetMachine, out: Path) -> Chain:
    own = out / MACHINES / machine.id
    try:
        folders = data_folders(base, machine.data)
    except InputError as error:
        told, data = tuple(map(str, error.faults)), ", ".join(machine.data)
        return Chain((), Row(machine=machine.id, data=data, date=None, inputs="", tasks=machine.tasks, faults=told))
    errors = None if machine.errors is None else base / machine.errors
    units: list[Unit] = []
    for folder in folders or (None,):
        name = GIVEN if folder is None else folder.path.name
        units.append(
            Unit(
                machine=machine.id, data="" if folder is None else folder.name,
                date=None if folder is None or folder.date is None else folder.date.isoformat(), tasks=machine.tasks,
                base=base, spec=base / machine.spec, errors=errors, folder=None if folder is None else folder.path,
                out=own / name, before=units[-1].out if units else None, kernels=out / KERNELS, version=__version__,
            )
        )  # fmt: skip
    return Chain(tuple(units))


def _among_results(chains: tuple[Chain, ...], out: Path) -> list[Fault]:
    """Inputs that lie where results are written: they would be written over while they are read."""
    written = [out / MACHINES, out / KERNELS]
    found: dict[Path, Fault] = {}
    for unit in (unit for chain in chains for unit in chain.units):
        for path in (unit.spec, unit.errors, unit.folder):
            if path is None or path in found:
                continue
            real = path.resolve()
            if any(real.is_relative_to(folder) for folder in written):
                problem = "lies among the results of --out, which are written"
                found[path] = Fault(str(path), "", problem, "a copy of it elsewhere, or another folder for --out")
    return list(found.values())
