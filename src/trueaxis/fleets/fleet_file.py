"""FLEET.toml: the machines, where their specs, error values and measured data are, what is to be done with them.

Folders of measured data of a machine come in order of their dates.
"""

import re
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Literal, get_args

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import complainer, parse_toml
from trueaxis.machine.fields import Fields, shown

FleetTask = Literal["identify", "diagnose", "report"]
TASKS: tuple[FleetTask, ...] = get_args(FleetTask)
DEFAULT_TASKS: tuple[FleetTask, ...] = ("identify",)
OF_DATA = ("identify", "diagnose")
SCHEMA = 1
MOST_MACHINES = 1_000_000
LONGEST_ID = 100  # characters: it is the name of a folder
_ID = r"[A-Za-z0-9][A-Za-z0-9._-]*"
_RIGHT_ID = f"letters, digits, `.`, `_`, `-`, up to {LONGEST_ID}, the first a letter or a digit: it names a folder"
_RIGHT_DATA = 'a folder, a list of folders, or a pattern such as "data/M17/2026-*"'
_PATTERN = re.compile(r"[*?\[]")
# 2026-11-03, 20261103, 2026-11, with whatever before and behind; not a part of a longer number
_DATE = re.compile(r"(?<!\d)(\d{4})(?:-(\d{2})(?:-(\d{2}))?|(\d{2})(\d{2}))(?!\d)")


@dataclass(frozen=True, slots=True, kw_only=True)
class FleetMachine:
    """A machine of the file. spec, errors: paths, relative to the folder of the file; errors: the values that its
    control has now, None: not given; data: folders or patterns of folders; tasks: in the order in which they are done.
    """

    id: str
    spec: str
    errors: str | None
    data: tuple[str, ...]
    tasks: tuple[FleetTask, ...]


@dataclass(frozen=True, slots=True)
class Fleet:
    """The machines of a fleet file, and the folder that their paths are relative to."""

    folder: Path
    machines: tuple[FleetMachine, ...]


def read_fleet(path: Path) -> Fleet:
    """Read a fleet file. Raises InputError with every fault of it, and then with the specs that are not there; else the
    files that it names are not looked at: a machine without its spec is a row that says so.
    """
    text, faults = utf8_text(path, input_bytes(path)), Faults(str(path))
    top = Fields(parse_toml(text, faults), (), complainer(text, faults))
    if top.integer("schema", SCHEMA) != SCHEMA:
        top.fault("schema", f"is {shown(top.raw['schema'])}", f"this version reads schema {SCHEMA}")
    machines: list[FleetMachine] = []
    places: dict[str, str] = {}
    specless: dict[str, Fields] = {}
    for table in top.tables("machine", required=True, most=MOST_MACHINES):
        machine = _machine(table)
        spec = table.raw.get("spec")
        if isinstance(spec, str) and not (path.parent / spec).is_file():
            specless.setdefault(spec, table)
        if machine is None:
            continue
        if before := places.get(machine.id.casefold()):
            remedy = "one machine for each id; ids that differ in capitals alone are one folder on some systems"
            table.fault("id", f"is {shown(machine.id)}, and {before} is there already", remedy)
        places[machine.id.casefold()] = machine.id
        machines.append(machine)
    if "machine" in top.raw and not machines and not faults.found:
        top.fault("machine", "holds no machine", "one table [[machine]] or more")
    top.refuse_others("schema, machine")
    for spec, table in specless.items() if faults.found else ():
        table.fault("spec", f"there is no file {shown(spec)}", "a spec, from the folder of the fleet file")
    faults.raise_if_any()
    return Fleet(path.parent, tuple(machines))


def _machine(table: Fields) -> FleetMachine | None:
    name = table.text("id", pattern=_ID, meaning=_RIGHT_ID)
    if name is not None and len(name) > LONGEST_ID:
        table.fault("id", f"has {len(name)} characters", _RIGHT_ID)
    spec = table.text("spec")
    errors = table.text("errors", "") or None
    tasks = _tasks(table)
    wanted = any(task in OF_DATA for task in tasks)
    data = _data(table, wanted)
    if data and not wanted:
        table.fault("data", "is of no use: report alone shows `errors`", "leave it out, or add identify or diagnose")
    if not wanted and errors is None:
        table.fault("errors", "is missing", "the error values that report alone is to show")
    table.refuse_others("id, spec, errors, data, tasks")
    return (
        None
        if name is None or spec is None
        else FleetMachine(id=name, spec=spec, errors=errors, data=data, tasks=tasks)
    )


def _tasks(table: Fields) -> tuple[FleetTask, ...]:
    given = table.texts("tasks")
    if given is None:
        return DEFAULT_TASKS
    if unknown := [task for task in given if task not in TASKS]:
        table.fault("tasks", f"has {', '.join(map(shown, unknown))}", f"of {', '.join(TASKS)}")
        return DEFAULT_TASKS
    return tuple(task for task in TASKS if task in given)


def _data(table: Fields, required: bool) -> tuple[str, ...]:
    """Each once, in order."""
    if isinstance(table.raw.get("data"), list):
        return table.texts("data", required) or ()
    if "data" not in table.raw and not required:
        return ()
    if "data" not in table.raw:
        table.known.add("data")
        table.fault("data", "is missing", _RIGHT_DATA)
        return ()
    text = table.text("data", meaning=_RIGHT_DATA)
    return () if text is None else (text,)


@dataclass(frozen=True, slots=True)
class DatedFolder:
    """A folder of measured data. name: as paths in the fleet file are written; date: that its name holds, None: it
    holds none; of a month, its first day.
    """

    name: str
    path: Path
    date: date | None


def data_folders(base: Path, given: tuple[str, ...]) -> tuple[DatedFolder, ...]:
    """Those without a date first, in the order given, then the others by date and name.

    given: folders, or patterns of folders, relative to `base`. A folder that is named outright need not exist. Raises
    InputError where a pattern matches no folder, or two folders have one name.
    """
    faults: list[Fault] = []
    found: dict[str, DatedFolder] = {}
    for text in given:
        matched = _matched(base, text)
        if not matched:
            faults.append(Fault(text, "", "matches no folder", "folders with setup.toml, from the fleet file"))
        for name in matched:
            folder = DatedFolder(name, base / name, date_of(Path(name).name))
            if folder.path.name in ("", ".."):
                faults.append(Fault(name, "", "has no name of its own, which results go by", "the folder by its name"))
                continue
            other = found.setdefault(folder.path.name.casefold(), folder)
            if other.path != folder.path:
                problem = f"has the name of {other.name}, which results go by"
                faults.append(Fault(name, "", problem, "a name of its own for each folder of a machine"))
    if faults:
        raise InputError(faults)
    undated = [one for one in found.values() if one.date is None]
    dated = [one for one in found.values() if one.date is not None]
    return (*undated, *sorted(dated, key=lambda one: (one.date or date.min, one.path.name)))


def date_of(name: str) -> date | None:
    """The first date that the name of a folder holds."""
    for year, month, day, short_month, short_day in _DATE.findall(name):
        try:
            return date(int(year), int(month or short_month), int(day or short_day or 1))
        except ValueError:  # 2026-99: no date
            continue
    return None


def _matched(base: Path, text: str) -> list[str]:
    if not _PATTERN.search(text):
        return [Path(text).as_posix()]
    whole = Path(text)
    root = Path(whole.anchor) if whole.is_absolute() else base
    pattern = str(whole.relative_to(root)) if whole.is_absolute() else text
    try:
        folders = sorted(path for path in root.glob(pattern) if path.is_dir())
    except (ValueError, NotImplementedError, OSError):  # a pattern such as "", or a folder that cannot be read
        return []
    return [path.as_posix() if whole.is_absolute() else path.relative_to(base).as_posix() for path in folders]
