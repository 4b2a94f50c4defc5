"""The folders of measured data of a machine, in order of their dates."""

import re
from dataclasses import dataclass
from datetime import date
from pathlib import Path

from trueaxis.io.faults import Fault, InputError

_PATTERN = re.compile(r"[*?\[]")
# 2026-11-03, 20261103, 2026-11, with whatever before and behind; not a part of a longer number
_DATE = re.compile(r"(?<!\d)(\d{4})(?:-(\d{2})(?:-(\d{2}))?|(\d{2})(\d{2}))(?!\d)")


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
