"""Reads work offsets: from the option --offset, from LinuxCNC's .var files, from TOML."""

import re
from collections.abc import Iterable
from pathlib import Path

from trueaxis.compensation.offsets import NUMBERED, RIGHT_NAME, Offsets, Range, problem_of, system_name
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.input_files import input_bytes, utf8_text
from trueaxis.io.toml_lines import complainer, parse_toml
from trueaxis.machine.fields import Fields, shown

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
    return Offsets(systems, offsets.shift, offsets.active)


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
    return Offsets(systems, shift, NUMBERED[int(in_force) - 1])


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
