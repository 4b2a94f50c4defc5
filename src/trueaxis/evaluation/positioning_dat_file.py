"""The .dat files of a positioning test: one assignment a line, as motion loggers write them.

A file is data: nothing in it is ever evaluated.

TGT_DATA[i] is target i, REF_DATA_FWD[i,j] and REF_DATA_BWD[i,j] what the reference instrument read there in cycle j,
approached forward (positive) and backward (negative), all in mm. Indices count from 1 without gaps.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from trueaxis.evaluation.positioning_test import (
    FARTHEST_TARGET,
    FEWEST_CYCLES,
    LARGEST_DEVIATION,
    MOST_CYCLES,
    MOST_TARGETS,
    PositioningTest,
    Unit,
    too_few,
)
from trueaxis.io.faults import Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text

FloatArray = NDArray[np.float64]
TARGET, FORWARD, BACKWARD = "TGT_DATA", "REF_DATA_FWD", "REF_DATA_BWD"
INDEX = {TARGET: "[position]", FORWARD: "[position,cycle]", BACKWARD: "[position,cycle]"}
COUNTS = ("POSITIONS", "CYCLES")
TEXTS = ("TEST_DATA", "REF_PV", "TEST_PV", "TGT_SET_PV")  # said of the logger, not needed here
NAMES = (*INDEX, "UNIT", *COUNTS, "DEC", *TEXTS)
MOST_MISSING = 20
MOST_FAULTS = 1000  # a file of another kind is wrong in every line
_ASSIGNMENT = re.compile(r"([A-Za-z_][A-Za-z0-9_]*)[ \t]*(?:\[([^\[\]]*)\][ \t]*)?=(.*)")
_INDEX = re.compile(r"[ \t]*([0-9]{1,9})[ \t]*")
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


@dataclass(slots=True, kw_only=True)
class _Content:
    """What a file assigned: values by name and index, NaN where a value was wrong; lines where it did. unit and
    fewest_cycles: asked.
    """

    unit: Unit = "mm"
    fewest_cycles: int = FEWEST_CYCLES
    values: dict[str, dict[tuple[int, ...], float]] = field(default_factory=lambda: {name: {} for name in INDEX})
    counts: dict[str, int] = field(default_factory=dict)
    lines: dict[tuple[str, tuple[int, ...]], int] = field(default_factory=dict)


def read_dat(path: Path, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> PositioningTest:
    """Read a .dat file; unit: of its positions. Raises InputError with every fault, each with its line."""
    faults = Faults(str(path))
    content = _Content(unit=unit, fewest_cycles=fewest_cycles)
    for statement in _statements(utf8_text(path, input_bytes(path)), faults):
        _take(statement, content, faults)
    m = _size("POSITIONS", "position", 0, content, faults)
    n = _size("CYCLES", "cycle", 1, content, faults)
    grids = {
        TARGET: _grid(TARGET, (m,), content, faults),
        FORWARD: _grid(FORWARD, (m, n), content, faults),
        BACKWARD: _grid(BACKWARD, (m, n), content, faults),
    }
    _check_targets(content, faults)
    _check_deviations(content, faults)
    faults.raise_if_any()
    return PositioningTest(grids[TARGET], grids[FORWARD], grids[BACKWARD], unit)


@dataclass(frozen=True, slots=True)
class Statement:
    """`NAME=value` or `NAME[i,j]=value` in a line; index is empty without brackets."""

    line: int
    name: str
    index: tuple[int, ...]
    value: str

    @property
    def place(self) -> str:
        """`line 12`."""
        return f"line {self.line}"

    @property
    def target(self) -> str:
        """What is assigned to: `REF_DATA_FWD[1,2]`."""
        return self.name + (f"[{','.join(map(str, self.index))}]" if self.index else "")


def _take(statement: Statement, content: _Content, faults: Faults) -> None:
    name, index = statement.name, statement.index
    if name not in NAMES:
        close = get_close_matches(name, NAMES, n=1)
        remedy = f"did you mean {close[0]}?" if close else f"known: {', '.join(NAMES)}"
        faults.add(statement.place, f"{_shown(name)} is not a known name", remedy)
        return
    if len(index) != INDEX.get(name, "").count(",") + (name in INDEX):
        faults.add(statement.place, f"{statement.target} has another number of indices", name + INDEX.get(name, ""))
        return
    for value, most, what in zip(index, (MOST_TARGETS, MOST_CYCLES), ("position", "cycle"), strict=False):
        if value > most:
            faults.add(statement.place, f"{what} {value} is too high", f"at most {most}")
            return
    earlier = content.lines.setdefault((name, index), statement.line)
    if earlier != statement.line:
        faults.add(statement.place, f"{statement.target} is given already in line {earlier}", "keep one")
    elif name in INDEX:
        content.values[name][index] = _value(statement, faults)
    elif name in COUNTS:
        _take_count(statement, content, faults)
    elif name == "UNIT" and statement.value != content.unit:
        kind = "a linear axis, in mm (a rotary one: --rotary)" if content.unit == "mm" else "a rotary axis, in deg"
        faults.add(statement.place, f"unit {_shown(statement.value)} is not {content.unit}", kind)
    elif name == "DEC" and _whole_number(statement.value) is None:
        faults.add(statement.place, f"DEC: {_shown(statement.value)} is not a whole number")


def _value(statement: Statement, faults: Faults) -> float:
    found = number(statement.value)
    if found is None:
        problem = f"{_shown(statement.value)} is not a number" if statement.value else "is empty"
        faults.add(statement.place, f"{statement.target}: {problem}", "a number, mm")
    elif not math.isfinite(found):
        faults.add(statement.place, f"{statement.target}: {_shown(statement.value)} is not a finite number")
    elif statement.name == TARGET and abs(found) > FARTHEST_TARGET:
        problem = f"{statement.target}: {_shown(statement.value)} is too far"
        faults.add(statement.place, problem, f"mm, at most {FARTHEST_TARGET:g}")
    else:
        return found
    return math.nan


def _take_count(statement: Statement, content: _Content, faults: Faults) -> None:
    found = _whole_number(statement.value)
    most = MOST_TARGETS if statement.name == "POSITIONS" else MOST_CYCLES
    least = 2 if statement.name == "POSITIONS" else 1
    if found is None or not least <= found <= most:
        problem = f"{statement.name}: {_shown(statement.value)} is not a count"
        faults.add(statement.place, problem, f"a whole number from {least} to {most}")
    else:
        content.counts[statement.name] = found


def _size(name: str, what: str, axis: int, content: _Content, faults: Faults) -> int:
    """The number of positions or cycles: as declared, else the highest index."""
    indices = [index for values in content.values.values() for index in values if len(index) > axis]
    highest = max((index[axis] for index in indices), default=0)
    declared = content.counts.get(name)
    targets = [value for value in content.values[TARGET].values() if not math.isnan(value)]
    asked = max(targets) - min(targets) if targets else 0.0, content.unit, content.fewest_cycles
    if declared is None:
        if (name, ()) not in content.lines and (problem := too_few(what, highest, *asked)):
            faults.add("", problem)
        return highest
    if problem := too_few(what, declared, *asked):
        faults.add(f"line {content.lines[name, ()]}", problem)
    elif highest > declared:
        place = f"line {content.lines[name, ()]}"
        faults.add(place, f"{name} is {declared}, but there is a {what} {highest}", "the number that there are")
    return max(declared, highest)


def _grid(name: str, shape: tuple[int, ...], content: _Content, faults: Faults) -> FloatArray:
    """The values of a name as an array of a shape; those that no line gives are noted, the first ones each."""
    grid = np.full(shape, np.nan)
    given = np.zeros(shape, dtype=np.bool_)
    for index, value in content.values[name].items():
        at = tuple(i - 1 for i in index)
        grid[at], given[at] = value, True
    if not content.values[name]:
        faults.add("", f"there is no {name}{INDEX[name]}", "a bidirectional test has targets and both directions")
        return grid
    missing = np.argwhere(~given)
    for at in missing[:MOST_MISSING]:
        faults.add("", f"{name}[{','.join(str(i + 1) for i in at)}] is missing")
    if len(missing) > MOST_MISSING:
        faults.add("", f"and so {len(missing) - MOST_MISSING} more values of {name}")
    return grid


def _check_targets(content: _Content, faults: Faults) -> None:
    first: dict[float, int] = {}
    for index, value in content.values[TARGET].items():
        if math.isnan(value):
            continue
        earlier = first.setdefault(value, index[0])
        if earlier != index[0]:
            problem = f"{TARGET}[{index[0]}] is the same as {TARGET}[{earlier}]"
            faults.add(f"line {content.lines[TARGET, index]}", problem, "each target once")


def _check_deviations(content: _Content, faults: Faults) -> None:
    for name in (FORWARD, BACKWARD):
        for index, value in content.values[name].items():
            off = value - content.values[TARGET].get(index[:1], math.nan)
            if abs(off) > LARGEST_DEVIATION:  # false where a value is unknown
                problem = f"{name}[{index[0]},{index[1]}] is {off:.6g} mm off its target"
                remedy = f"at most {LARGEST_DEVIATION:g}: in mm, in the order of the targets"
                faults.add(f"line {content.lines[name, index]}", problem, remedy)


def _statements(text: str, faults: Faults) -> Iterator[Statement]:
    """The assignments of a file in order; lines that are none are noted. `#` begins a comment, anywhere.

    Raises InputError once there are MOST_FAULTS faults, whoever noted them.
    """
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1):
        if len(faults.found) >= MOST_FAULTS:
            faults.add(f"line {number}", "reading stopped here: too much is wrong")
            raise InputError(faults.found)
        content = line.partition("#")[0].strip()
        if not content:
            continue
        parts = _ASSIGNMENT.fullmatch(content)
        if parts is None:
            faults.add(f"line {number}", f"{_shown(content)} is not an assignment", "NAME=value or NAME[i,j]=value")
            continue
        name, inside, value = parts.groups()
        index = _index(inside)
        if index is None:
            faults.add(
                f"line {number}", f"{_shown(inside)} is not an index", "whole numbers from 1, as in [1] or [1,2]"
            )
        else:
            yield Statement(number, name, index, value.strip())


def _index(inside: str | None) -> tuple[int, ...] | None:
    if inside is None:
        return ()
    parts = [_INDEX.fullmatch(part) for part in inside.split(",")]
    index = tuple(int(part[1]) for part in parts if part is not None)
    return index if len(index) == len(parts) and 0 not in index else None


def number(text: str) -> float | None:
    """A decimal number, None where the text is none; infinite where it is too large."""
    return float(text) if _NUMBER.fullmatch(text) else None


def _whole_number(text: str) -> int | None:
    """A whole number of up to nine digits, None where the text is none."""
    found = _INDEX.fullmatch(text)
    return None if found is None else int(found[1])


def _shown(text: str | None) -> str:
    """A piece of the file in quotes, shortened, with nothing a terminal would obey."""
    plain = (text or "").encode("unicode_escape").decode("ascii") if not (text or "").isprintable() else text or ""
    return f'"{plain if len(plain) <= 40 else plain[:36] + " ..."}"'
