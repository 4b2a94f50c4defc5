"""What is known of the tools of a program, and where it is read from: LinuxCNC's tool.tbl, TOML."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from trueaxis.compensation.machine import LINEAR, ErrorModel, FloatArray
from trueaxis.io.faults import Faults
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import complainer, parse_toml
from trueaxis.machine.fields import Fields, shown


@dataclass(frozen=True, slots=True)
class Cutter:
    """What LinuxCNC's interpreter needs of a tool beside its length. diameter, mm, None: not known; angles: front and
    back, deg, and orientation of the edge, of lathe tools.
    """

    diameter: float | None = None
    angles: tuple[float, float] = (0.0, 0.0)
    orientation: int = 0


@dataclass(frozen=True, slots=True)
class Tool:
    """length: what G43 adds to Z, from the point that --tool-point names to the tip; offset: further X Y Z, as in a
    tool table of LinuxCNC. point: the point to be compensated, tool frame; None: what follows from both. mm.
    """

    length: float = 0.0
    offset: tuple[float, float, float] = (0.0, 0.0, 0.0)
    point: tuple[float, float, float] | None = None
    cutter: Cutter = Cutter()

    @property
    def shift(self) -> tuple[float, float, float]:
        """What is added to X Y Z of the program."""
        x, y, z = self.offset
        return (x, y, z + self.length)


@dataclass(frozen=True, slots=True)
class ToolTable:
    """Tools by number; names: the numbers of those that programs call by their names, in capitals."""

    tools: Mapping[int, Tool] = field(default_factory=dict)
    names: Mapping[str, int] = field(default_factory=dict)

    def number_of(self, name: str) -> int | None:
        """Of the tool with a name, whatever the case of its letters; None: there is none."""
        return self.names.get(name.upper())


def tool_point_of(model: ErrorModel, tool: Tool | None, otherwise: FloatArray) -> FloatArray:
    """The point of a tool that is compensated, (3, 1), mm, tool frame; otherwise: that without a tool.

    With what G43 adds, the axes bring this point where they would bring the other one without: at home, where all
    frames are parallel, it lies back by as much as the axes then move the tool.
    """
    if tool is None:
        return otherwise
    if tool.point is not None:
        return np.array(tool.point, dtype=np.float64)[:, np.newaxis]
    home = np.zeros((len(model.axes), 1))
    moved = home.copy()
    for row, axis in enumerate(model.axes):
        if axis in LINEAR:
            moved[row] = tool.shift[LINEAR.index(axis)]
    return np.asarray(otherwise - (model.ideal(moved, otherwise) - model.ideal(home, otherwise)))


@dataclass(frozen=True, slots=True)
class ToolUse:
    """A tool of a program and the point that was compensated, tool frame, mm."""

    number: int
    tool_point: tuple[float, float, float]


LONGEST = 2000.0  # mm; no tool is, and micrometres or a lost decimal point are more
_LINE = re.compile(r"[ \t]*(?:[A-Z][ \t]*[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[ \t]*)+", re.IGNORECASE)
_ENTRY = re.compile(r"([A-Z])[ \t]*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)", re.IGNORECASE)
_RIGHT = f"a length in mm, up to {LONGEST:g}"


def read_tools(path: Path) -> ToolTable:
    """The tools of a file: TOML, or LinuxCNC's tool.tbl, recognised by the name's extension.

    Raises InputError with every fault of the file.
    """
    text, faults = utf8_text(path, input_bytes(path)), Faults(str(path))
    toml = path.suffix.lower() == ".toml"
    table = _from_toml(text, faults) if toml else ToolTable(_from_table(text, faults))
    if not table.tools and not faults.found:
        faults.add("", "holds no tool", "lines like T1 P1 Z102.5, or TOML tables [tool.1] in a file .toml")
    faults.raise_if_any()
    return table


def _from_toml(text: str, faults: Faults) -> ToolTable:
    top = Fields(parse_toml(text, faults), (), complainer(text, faults))
    tables = top.table("tool", required=True)
    tools: dict[int, Tool] = {}
    names: dict[str, int] = {}
    for key in tables.raw:
        table = tables.table(key)
        if not re.fullmatch(r"[1-9]\d{0,7}", key):
            tables.fault(key, "is no number of a tool", "[tool.1]")
            continue
        offset, point = _lengths(table, "offset"), _lengths(table, "point")
        length = 0.0
        if "length" in table.raw or offset is None:
            length = table.number("length", _RIGHT) or 0.0
        if abs(length) > LONGEST:
            table.fault("length", f"is {length:g}", _RIGHT)
        diameter = table.number("diameter", _RIGHT) if "diameter" in table.raw else None
        if diameter is not None and not 0.0 <= diameter <= LONGEST:
            table.fault("diameter", f"is {diameter:g}", f"a diameter in mm, from 0 to {LONGEST:g}")
        name = (table.text("name") or "").upper() if "name" in table.raw else ""
        if name and names.setdefault(name, int(key)) != int(key):
            table.fault("name", f"is {name!r}, the name of another tool too", "a name of its own")
        table.refuse_others("length, offset, point, diameter, name")
        tools[int(key)] = Tool(length, offset or (0.0, 0.0, 0.0), point, Cutter(diameter))
    top.refuse_others("tool")
    return ToolTable(tools, names)


def _lengths(table: Fields, key: str) -> tuple[float, float, float] | None:
    values = table.numbers(key, 3)
    if values is None:
        return None
    if max(map(abs, values)) > LONGEST:
        table.fault(key, f"is {shown(list(values))}", f"three lengths in mm, up to {LONGEST:g}")
    return (values[0], values[1], values[2])


def _from_table(text: str, faults: Faults) -> dict[int, Tool]:
    """LinuxCNC's table, taken in mm: T is the number, X Y Z what G43 adds, D the diameter, 0 where it is not there."""
    tools: dict[int, Tool] = {}
    for number, line in enumerate(text.splitlines(), 1):
        said = line.partition(";")[0]
        if not said.strip():
            continue
        entries = {letter.upper(): float(value) for letter, value in _ENTRY.findall(said)}
        if not _LINE.fullmatch(said) or "T" not in entries or not 0 <= entries["T"] < 1e8 or entries["T"] % 1:
            faults.add(f"line {number}", f"{shown(line)} is no line of a tool table", "like T1 P1 Z102.5 D6.0")
            continue
        if int(entries["T"]) in tools:
            faults.add(f"line {number}", f"T{entries['T']:g} is there twice", "one line for each tool")
        for problem, right in _problems(entries):
            faults.add(f"line {number}", f"T{entries['T']:g} {problem}", right)
        x, y, z, diameter, front, back, edge = (entries.get(letter, 0.0) for letter in "XYZDIJQ")
        tools[int(entries["T"])] = Tool(z, (x, y, 0.0), cutter=Cutter(diameter, (front, back), int(edge)))
    return tools


def _problems(entries: Mapping[str, float]) -> Iterator[tuple[str, str]]:
    """What is wrong with a line of a table, and what would be right."""
    if max(abs(entries.get(axis, 0.0)) for axis in "XYZ") > LONGEST:
        yield f"is longer than {LONGEST:g} mm", "a table in mm"
    if abs(entries.get("D", 0.0)) > LONGEST:
        yield f"has a diameter of more than {LONGEST:g} mm", "a table in mm"
    if shifted := [axis for axis in "ABCUVW" if entries.get(axis)]:
        yield f"has an offset in {' '.join(shifted)}, which is not followed", "offsets in X, Y and Z"
    if not (0.0 <= entries.get("Q", 0.0) <= 9.0 and entries.get("Q", 0.0) % 1 == 0.0):
        yield f"has the orientation Q{entries['Q']:g}", "Q0 to Q9"
