"""What is known of a control's work offsets before a program runs, and where it is read from: the option --offset,
LinuxCNC's .var files, TOML.
"""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import complainer, parse_toml
from trueaxis.machine.fields import Fields, shown

# of G54 to G59.3 of LinuxCNC in the order of their numbers; G54.1 P1 and on are Fanuc's
NUMBERED = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
_NAME = re.compile(r"G0*(5[4-9](?:\.[1-3])?)(?:\s*P0*(\d{1,3}))?", re.IGNORECASE)
_FURTHER = re.compile(r"G5(?:0[5-9]|[1-9]\d)", re.IGNORECASE)  # of SINUMERIK
RIGHT_NAME = "G54 to G59, G59.1 to G59.3, G54.1P1 and on, or G505 to G599"
LARGEST = 1e5  # mm, deg: as positions
NOT_KNOWN = "where its zero lies is not known"

Range = tuple[float, float]  # lowest and highest value, mm or deg; the same where it is known


@dataclass(frozen=True, slots=True)
class Offsets:
    """systems: for each work offset (`G54`, `G54.1 P3`) the position of its zero in machine coordinates, mm and deg, by
    axis. shift: of G92 and G52 on top of all. active: the work offset that is in force at first, None: not known.
    parameters: all that a .var file of LinuxCNC has, by number, mm and deg.
    """

    systems: Mapping[str, Mapping[str, Range]] = field(default_factory=dict)
    shift: Mapping[str, float] = field(default_factory=dict)
    active: str | None = None
    parameters: Mapping[int, float] = field(default_factory=dict)

    @property
    def first(self) -> str | None:
        """The work offset that a program begins with; None: machine coordinates."""
        return self.active or ("G54" if "G54" in self.systems else None)


def system_name(text: str) -> str | None:
    """The name of a work offset as `G54`, `G59.1` or `G54.1 P3`; None if it is none."""
    match = _NAME.fullmatch(text.strip())
    if _FURTHER.fullmatch(text.strip()):
        return text.strip().upper()
    if match is None:
        return None
    number, place = match.groups()
    if number == "54.1" and place and int(place):
        return f"G54.1 P{int(place)}"
    return f"G{number}" if f"G{number}" in NUMBERED and place is None else None


def middle(values: Range) -> float:
    """What an offset is taken to be."""
    return 0.5 * (values[0] + values[1])


def half_width(values: Range) -> float:
    """By how much it may differ from that."""
    return 0.5 * (values[1] - values[0])


def problem_of(values: Range) -> str:
    """What is wrong with a value or range; empty if nothing is."""
    low, high = values
    if not (math.isfinite(low) and math.isfinite(high)):
        return "is not finite"
    if low > high:
        return f"goes from {low:g} down to {high:g}"
    return "" if max(-low, high) <= LARGEST else f"is beyond {LARGEST:g}"


_AXES = "XYZABC"
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_VALUE = re.compile(rf"([{_AXES}])({_NUMBER})(?::({_NUMBER}))?", re.IGNORECASE)
_OPTION = "like G54=X1.0,Y2.0,Z3.0, a range like X0:500"
# LinuxCNC's numbered parameters: G92 (on or off, then axes), the work offset in force, and nine work offsets
_G92_ON, _G92, _IN_FORCE, _SYSTEMS, _EACH, _TURN = 5210, 5211, 5220, 5221, 20, 9


def offset_of_option(text: str) -> tuple[str, dict[str, Range]]:
    """`G54=X1.0,Y2.0,Z0:500` as the name of the work offset and its values.

    Raises ValueError where it is something else.
    """
    name, equals, values = text.partition("=")
    system = system_name(name)
    if not equals or system is None:
        raise ValueError(f"{text!r} is not {_OPTION}; the name is one of {RIGHT_NAME}")
    found: dict[str, Range] = {}
    for part in re.split(r"[,\s]+", values.strip()):
        match = _VALUE.fullmatch(part)
        if match is None or match[1].upper() in found:
            raise ValueError(f"{text!r} is not {_OPTION}")
        low = float(match[2])
        value = (low, low if match[3] is None else float(match[3]))
        if problem := problem_of(value):
            raise ValueError(f"{text!r}: {match[1].upper()} {problem}")
        found[match[1].upper()] = value
    return system, found


def read_offsets(path: Path) -> Offsets:
    """The work offsets of a file: TOML, or LinuxCNC's .var, recognised by the name's extension.

    Raises InputError with every fault of the file.
    """
    text, faults = utf8_text(path, input_bytes(path)), Faults(str(path))
    offsets = _from_toml(text, faults) if path.suffix.lower() == ".toml" else _from_var(text, faults)
    faults.raise_if_any()
    return offsets


def with_options(offsets: Offsets, given: Iterable[tuple[str, dict[str, Range]]]) -> Offsets:
    """The offsets with those of options, which come first.

    Raises InputError where one is given twice.
    """
    systems, named = dict(offsets.systems), set[str]()
    for system, values in given:
        if system in named:
            raise InputError([Fault("--offset", "", f"{system} is given twice")])
        named.add(system)
        systems[system] = {**systems.get(system, {}), **values}
    return replace(offsets, systems=systems)


def _from_toml(text: str, faults: Faults) -> Offsets:
    top = Fields(parse_toml(text, faults), (), complainer(text, faults))
    tables = top.table("offset", required=True)
    systems: dict[str, dict[str, Range]] = {}
    for key in tables.raw:
        table = tables.table(key)
        name = system_name(key)
        if name is None:
            tables.fault(key, "is no work offset", RIGHT_NAME)
            continue
        values = {axis: _value(table, axis) for axis in _AXES if axis in table.raw}
        table.refuse_others(", ".join(_AXES))
        systems[name] = {axis: value for axis, value in values.items() if value is not None}
    top.refuse_others("offset")
    return Offsets(systems)


def _value(table: Fields, axis: str) -> Range | None:
    table.known.add(axis)
    raw = table.raw[axis]
    pair = raw if isinstance(raw, list) else [raw, raw]
    ends = [Fields.finite(end) for end in pair]
    if len(ends) != 2 or ends[0] is None or ends[1] is None:
        table.fault(axis, f"is {shown(raw)}", "a number (mm, deg), or [lowest, highest]")
        return None
    if problem := problem_of((ends[0], ends[1])):
        table.fault(axis, problem, "a number (mm, deg), or [lowest, highest]")
        return None
    return ends[0], ends[1]


def _from_var(text: str, faults: Faults) -> Offsets:
    """LinuxCNC's parameters, taken in mm and deg."""
    values: dict[int, float] = {}
    for number, line in enumerate(text.splitlines(), 1):
        match = re.fullmatch(rf"\s*(\d{{1,5}})\s+({_NUMBER}(?:[eE][-+]?\d+)?)\s*", line)
        if match:
            values[int(match[1])] = float(match[2])
        elif line.strip():
            faults.add(
                f"line {number}", f"{shown(line)} is no parameter of LinuxCNC", "a number and its value, or TOML"
            )
    systems = _systems(values, faults)
    shift = {axis: values.get(_G92 + row, 0.0) for row, axis in enumerate(_AXES)} if values.get(_G92_ON) else {}
    ranges = {"G92": {axis: (v, v) for axis, v in shift.items()}, **systems}
    for name, axis, value in ((name, axis, value) for name, of in ranges.items() for axis, value in of.items()):
        if problem := problem_of(value):
            faults.add("", f"{name} {axis} {problem}")
    in_force = values.get(_IN_FORCE, 1.0)
    if in_force not in range(1, 1 + len(NUMBERED)):
        faults.add("", f"parameter {_IN_FORCE} is {in_force:g}, no work offset", f"1 to {len(NUMBERED)}")
        return Offsets()
    return Offsets(systems, shift, NUMBERED[int(in_force) - 1], values)


def _systems(values: dict[int, float], faults: Faults) -> dict[str, dict[str, Range]]:
    """The work offsets of LinuxCNC's parameters."""
    systems: dict[str, dict[str, Range]] = {}
    for place, name in enumerate(NUMBERED):
        first = _SYSTEMS + _EACH * place
        if values.get(first + _TURN):
            faults.add("", f"{name} is turned (parameter {first + _TURN})", "turned frames are not followed")
        if any(first + row in values for row in range(len(_AXES))):
            systems[name] = {axis: (v, v) for row, axis in enumerate(_AXES) for v in [values.get(first + row, 0.0)]}
    if not systems:
        faults.add("", "holds no work offset", f"LinuxCNC's parameters {_SYSTEMS} and on, or TOML in a file .toml")
    return systems
