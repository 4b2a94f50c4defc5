"""Renishaw .rtl and .rta files: sections of text with targets in mm or deg and deviations in um or of angles, a row per
run and target.

    HEADER::                       DEVIATIONS::
    TARGET DATA::                  Run Target Data:
    Target-count: 11                  1     1      0.000000
    Targets :                         1     2     -0.270000
      0.0000  10.0000  20.0000     ...
    Flags: 0 0 2 0                 EOF::
    RUNS::
    Run-count: 4

The layout is that of files and of programs that read and write them (docs/import.md); other sections and keys are
passed over. Texts are in UTF-8, else in GB 2312.
"""

import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import decoded, input_bytes
from trueaxis.io.safe_text import shown
from trueaxis.measurement.delimited import decimal
from trueaxis.measurement.instrument_run import MOST_ROWS, FloatArray, InstrumentRun, approach_of_passes

MOST_FAULTS = 20  # of one kind: a file of another kind is wrong in every line
LONGEST_SHOWN = 40  # characters of the file in a message
UM = 1e-3  # mm
ANGLES = ".rta"

_SECTION = re.compile(r"([A-Z][A-Z0-9 -]*)::", re.IGNORECASE)
_KEY = re.compile(r"([A-Za-z][\w -]*?)\s*:(.*)")
_AXIS = re.compile(r"([XYZABC])(?:[ -]?axis)?", re.IGNORECASE)
_REPORT = {"machine": "machine", "serial no": "serial", "date": "date", "by": "operator", "location": "location",
           "title": "title"}  # fmt: skip
ORDER = "rows were read in the order of the file; each run approaches all its targets from the side it comes from"


@dataclass(slots=True, kw_only=True)
class _Content:
    """What was read: counts as stated, targets in mm, rows of run, target, deviation and line, texts by their key."""

    target_count: int | None = None
    run_count: int | None = None
    targets: list[float] = field(default_factory=list)
    rows: list[tuple[int, int, float, int]] = field(default_factory=list)
    texts: dict[str, str] = field(default_factory=dict)
    sections: set[str] = field(default_factory=set)


def read_rtl(path: Path) -> InstrumentRun:
    """Read a .rtl file, or by its suffix a .rta file, whose deviations are angles and stay as they are.

    Raises InputError with every fault, each with its line.
    """
    angles = path.suffix.lower() == ANGLES
    faults = Faults(str(path))
    content = _content(decoded(input_bytes(path)), faults)
    _check(content, faults)
    faults.raise_if_any()
    runs, numbers, deviations, _ = (np.array(column) for column in zip(*content.rows, strict=True))
    targets: FloatArray = np.array(content.targets)[numbers.astype(np.int64) - 1]
    axis = _AXIS.fullmatch(content.texts.get("axis", ""))
    return InstrumentRun(
        file=str(path),
        id=path.stem,
        axis=axis[1].upper() if axis else None,
        targets=targets,
        instrument="angle" if angles else None,
        reading=deviations if angles else deviations * UM,
        unit_open=angles,
        directions=approach_of_passes(runs.astype(np.int64), targets),
        report={name: content.texts[key] for key, name in _REPORT.items() if content.texts.get(key)},
        assumed=(ORDER,),
    )


def is_rtl(data: bytes) -> bool:
    """Whether the bytes begin as such a file does."""
    return data.removeprefix(b"\xef\xbb\xbf").lstrip()[:8].upper() == b"HEADER::"


def _content(text: str, faults: Faults) -> _Content:
    content, section, key = _Content(), "", ""
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    for number, line in enumerate(map(str.strip, lines), start=1):
        if not line:
            continue
        if header := _SECTION.fullmatch(line):
            section, key = header[1].strip().upper(), ""
            content.sections.add(section)
        elif pair := _KEY.fullmatch(line):
            key = pair[1].lower()
            _take_pair(content, section, key, pair[2].strip(), f"line {number}", faults)
        elif section == "TARGET DATA" and key == "targets":
            _take_targets(content, line, f"line {number}", faults)
        elif section == "DEVIATIONS" and key == "run target data":
            _take_row(content, line, number, faults)
        if len(faults.found) >= MOST_FAULTS:
            faults.add(f"line {number}", "reading stopped here: too much is wrong")
            raise InputError(faults.found)
    return content


def _take_pair(content: _Content, section: str, key: str, value: str, place: str, faults: Faults) -> None:
    if section == "USER-TEXT":
        content.texts[key] = value
    elif (section, key) == ("TARGET DATA", "target-count"):
        content.target_count = _count(value, key, place, faults)
    elif (section, key) == ("RUNS", "run-count"):
        content.run_count = _count(value, key, place, faults)
    elif (section, key) == ("TARGET DATA", "targets") and value:
        _take_targets(content, value, place, faults)


def _count(value: str, key: str, place: str, faults: Faults) -> int | None:
    if re.fullmatch(r"[0-9]{1,7}", value):
        return int(value)
    faults.add(place, f'{key}: "{shown(value, LONGEST_SHOWN)}" is not a count', "a whole number")
    return None


def _take_targets(content: _Content, line: str, place: str, faults: Faults) -> None:
    for word in line.split():
        value = decimal(word)
        if value is None:
            faults.add(place, f'target "{shown(word, LONGEST_SHOWN)}" is not a number', "positions in mm")
        content.targets.append(value or 0.0)


def _take_row(content: _Content, line: str, number: int, faults: Faults) -> None:
    words = line.split()
    deviation = decimal(words[2]) if len(words) == 3 else None
    if deviation is None or not all(re.fullmatch(r"[0-9]{1,7}", word) for word in words[:2]):
        right = "run, target, deviation in um (of a .rta an angle), such as `1  2  -0.27`"
        faults.add(f"line {number}", f'"{shown(line, LONGEST_SHOWN)}" is not a deviation', right)
        return
    if len(content.rows) >= MOST_ROWS:
        faults.add(f"line {number}", f"has more than {MOST_ROWS} deviations")
        raise InputError(faults.found)
    content.rows.append((int(words[0]), int(words[1]), deviation, number))


def _check(content: _Content, faults: Faults) -> None:
    for section in ("HEADER", "TARGET DATA", "RUNS", "DEVIATIONS"):
        if section not in content.sections:
            faults.add("", f"there is no section {section}::", "a .rtl file has HEADER, TARGET DATA, RUNS, DEVIATIONS")
    if faults.found:
        return
    targets, runs = len(content.targets), {row[0] for row in content.rows}
    if not content.rows:
        faults.add("", "has no deviations", "rows of run, target, deviation behind `Run Target Data:`")
    if content.target_count is not None and targets != content.target_count:
        faults.add("", f"has {targets} targets, but Target-count is {content.target_count}", "a whole file")
    if content.run_count is not None and content.rows and len(runs) != content.run_count:
        faults.add("", f"has deviations of {len(runs)} runs, but Run-count is {content.run_count}", "a whole file")
    if len(set(content.targets)) != targets:
        faults.add("", "has a target twice", "each target once")
    lines: dict[tuple[int, int], int] = {}
    for run, target, _, line in content.rows:
        if not 1 <= target <= targets:
            faults.add(f"line {line}", f"there is no target {target}", f"1 to {targets}")
        elif (earlier := lines.setdefault((run, target), line)) != line:
            faults.add(f"line {line}", f"run {run}, target {target} is given already in line {earlier}", "keep one")
        if len(faults.found) >= MOST_FAULTS:
            return
    if not faults.found and len(lines) != targets * len(runs):
        missing = next((r, t) for r in sorted(runs) for t in range(1, targets + 1) if (r, t) not in lines)
        count = targets * len(runs) - len(lines)
        faults.add("", f"{count} deviations are missing, first that of run {missing[0]}, target {missing[1]}")
