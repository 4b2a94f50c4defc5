"""The unit of work: one machine and one folder of its data; what it reads, and whether that was done before."""

import hashlib
import json
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from trueaxis import __version__
from trueaxis.fleets.row import SCHEMA, Row, read_row
from trueaxis.measurement import readings, setup

_DATA = (setup.FILE_NAME, readings.FILE_NAME, readings.PARQUET_NAME)


@dataclass(frozen=True, slots=True, kw_only=True)
class Unit:
    """machine: id; data, date: as in a row; tasks; base: folder of the fleet file; spec, errors (None: not given),
    folder (of the data, None: there are none): absolute paths; out: absolute folder of its results; before: that of the
    machine's folder of data before this one, None: it is the first; kernels: folder that has one for each spec.
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


def values_before(unit: Unit) -> Path | None:
    """The newest error values of the machine before this folder of data: identified, or given; None: there are none."""
    row = None if unit.before is None else read_row(unit.before)
    if unit.before is not None and row is not None and row.newest is not None:
        return unit.before / row.newest
    return unit.errors


def inputs_digest(unit: Unit) -> str:
    """SHA-256 of all that the results come from: the files' content, the tasks, the version of the program."""
    spec = _content(unit.spec)
    contents = {f"spec/{name}": one for name, one in _named_in(spec, unit.spec.parent, "runs")} | {"spec": spec}
    for name, values in (("errors", unit.errors), ("before", values_before(unit))):
        if values is not None:
            contents[name] = _content(values)
            contents[f"covariance of {name}"] = _covariance_of(values, contents[name])
    if unit.folder is not None:
        contents |= {name: _content(unit.folder / name) for name in _DATA}
        contents |= dict(_named_in(contents[setup.FILE_NAME], unit.folder, "compensation"))
    asked = [SCHEMA, __version__, unit.machine, unit.data, unit.tasks]
    digests = {name: None if one is None else hashlib.sha256(one).hexdigest() for name, one in contents.items()}
    return hashlib.sha256(json.dumps([asked, digests], sort_keys=True).encode()).hexdigest()


def kept_row(unit: Unit, digest: str) -> Row | None:
    """The row that was made of the same inputs, where all of its files are there still."""
    row = read_row(unit.out)
    if row is None or row.inputs != digest or not all((unit.out / name).is_file() for name in row.files):
        return None
    return row


def _named_in(text: bytes | None, folder: Path, key: str) -> Iterator[tuple[str, bytes | None]]:
    """The file, or the set-up in the folder, that a key at the top of a TOML text names."""
    try:
        named = tomllib.loads((text or b"").decode("utf-8-sig")).get(key)
        path = folder / named if isinstance(named, str) else None
    except ValueError:
        return
    if path is not None and named != "none":
        yield key, _content(path / setup.FILE_NAME if path.is_dir() else path)


def _covariance_of(values: Path, text: bytes | None) -> bytes | None:
    """The content of the file that error values name as that of their covariance."""
    try:
        file = json.loads(text or b"")["covariance"]["file"]
        return _content(values.parent / file)
    except (ValueError, KeyError, TypeError):
        return None


def _content(path: Path) -> bytes | None:
    try:
        return path.read_bytes()
    except (OSError, ValueError):
        return None
