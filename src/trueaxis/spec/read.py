"""Read machines/NAME.toml: types and keys here, what the bodies make together in `structure`."""

import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

from trueaxis.faults import Faults, InputError
from trueaxis.spec.fields import Fields, shown
from trueaxis.spec.machine import AXES, DIRECTIONS, Body, Machine
from trueaxis.spec.structure import check_structure
from trueaxis.toml_lines import KeyPath, error_line, key_lines, place

_NAME = r"[A-Za-z][A-Za-z0-9_-]*"
# Titles and names of bodies stand in docstrings, comments and tables of Markdown.
_PROSE, _PROSE_MEANING = r"[\w .,:;()/&'+#-]+", "letters, digits, spaces and . , : ; ( ) / & ' + # - _"
_LABEL = r"motion_[XYZABC]+|system_[1-9][0-9]*|squareness"


def read_machine(path: Path) -> Machine:
    """The machine that a spec describes.

    Raises InputError with every fault found, each with key and line and what would be right.
    """
    faults = Faults(str(path))
    try:
        data = path.read_bytes()
    except OSError as error:
        faults.add("", f"cannot be read: {error.strerror}", "name a machine spec")
        raise InputError(faults.found) from None
    except ValueError as error:  # a NUL character in the name
        faults.add("", f"is not a file name: {error}")
        raise InputError(faults.found) from None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        faults.add(f"line {line}", f"byte {data[error.start]:#04x} is not UTF-8", "save the file as UTF-8")
        raise InputError(faults.found) from None
    return parse_machine(text, faults)


def parse_machine(text: str, faults: Faults) -> Machine:
    """The machine described by the text of a spec; raises InputError with every fault."""
    try:
        tree = tomllib.loads(text)
    except RecursionError:
        faults.add("", "is not TOML: nested too deeply")
        raise InputError(faults.found) from None
    except ValueError as error:  # bad syntax, or a number of thousands of digits
        faults.add(error_line(error), f"is not TOML: {error}")
        raise InputError(faults.found) from None
    lines: dict[KeyPath, int] = {}

    def complain(key: KeyPath, problem: str, remedy: str = "") -> None:
        if not lines:
            lines.update(key_lines(text))
        faults.add(place(key, lines) if key else "", problem, remedy)

    machine = _machine(Fields(tree, (), complain), complain)
    faults.raise_if_any()
    return machine


def _machine(top: Fields, complain: Callable[[KeyPath, str, str], None]) -> Machine:
    if (schema := top.integer("schema")) not in (1, None):
        complain(("schema",), f"{schema} is not a schema that this version reads", "schema = 1")
    name = top.text("name", pattern=_NAME, meaning="a letter, then letters, digits, _ and -") or "unnamed"
    title = top.text("title", default=name, pattern=_PROSE, meaning=_PROSE_MEANING) or name
    indexed = [(index, _body(fields)) for index, fields in enumerate(top.tables("body", required=True))]
    bodies = [(index, body) for index, body in indexed if body is not None]
    ends = top.table("ends", required=True)
    workpiece, tool = ends.integer("workpiece"), ends.integer("tool")
    ends.refuse_others()
    for index, effect in enumerate(top.tables("effect")):
        kind = shown(effect.raw.get("kind"))
        complain(("effect", index), f"no effect {kind} is known to this version", "a machine without [[effect]]")
    curves = top.table("curves")
    degree = curves.integer("degree", default=7)
    if degree is not None and not 1 <= degree <= 15:
        complain(("curves", "degree"), f"{degree} is out of range", "a degree from 1 to 15")
    curves.refuse_others()
    runs = top.text("runs", default="")
    references = top.table("references")
    said = tuple(
        (key, text)
        for key in references.raw
        if re.fullmatch(_LABEL, key) and (text := references.text(key)) is not None
    )
    references.refuse_others("motion_X, motion_XY, ..., system_1, ..., squareness")
    top.refuse_others()
    check_structure(bodies, workpiece, tool, len(bodies) == len(indexed), complain)
    return Machine(
        name,
        title,
        tuple(body for _, body in bodies),
        workpiece or 0,
        tool or 0,
        degree or 7,
        runs or None,
        said,
    )


def _body(fields: Fields) -> Body | None:
    number, lower = fields.integer("number"), fields.integer("lower")
    name = fields.text("name", default=f"body {number}", pattern=_PROSE, meaning=_PROSE_MEANING)
    moves = fields.choice("moves", AXES)
    sense = fields.integer("sense", default=1)
    travel = _travel(fields, moves)
    position = _position(fields)
    motion_errors = _motion_errors(fields, moves)
    pairs = fields.table("position_errors")
    position_errors = tuple(
        (direction, parameter)
        for direction in DIRECTIONS
        if direction in pairs.raw and (parameter := pairs.text(direction)) is not None
    )
    pairs.refuse_others(f"the directions {' '.join(DIRECTIONS)}")
    fields.refuse_others()
    if sense not in (1, -1):
        fields.fault("sense", f"{sense} is no sense", "1, or -1 where a positive command moves the body the other way")
    if "moves" not in fields.raw and "sense" in fields.raw:
        fields.fault("sense", "a body that does not move has no sense", "leave it out, or say what moves it")
    if number is None or lower is None:
        return None
    return Body(number, name or "", lower, moves, sense or 1, travel, position, motion_errors, position_errors)


def _travel(fields: Fields, moves: str | None) -> tuple[float, float] | None:
    if "moves" not in fields.raw:
        if "travel" in fields.raw:
            fields.fault("travel", "a body that does not move has no travel", 'leave it out, or add moves = "X"')
        fields.known.add("travel")
        return None
    travel = fields.numbers("travel", 2, required=moves is not None)
    if travel is None:
        return None
    if not travel[0] < travel[1]:
        fields.fault(
            "travel",
            f"runs from {travel[0]:g} to {travel[1]:g}",
            "the lower end first, the upper end after it",
        )
    return travel[0], travel[1]


def _position(fields: Fields) -> tuple[float | str, float | str, float | str]:
    fields.known.add("position")
    value = fields.raw.get("position", [0.0, 0.0, 0.0])
    if not isinstance(value, list) or len(value) != 3:
        fields.fault("position", "is not a position", "three numbers (mm) or names of parameters")
        return (0.0, 0.0, 0.0)
    read: list[float | str] = []
    for index, part in enumerate(value):
        if isinstance(part, str):
            read.append(part)
        elif (number := fields.finite(part)) is not None:
            read.append(number)
        else:
            fields.fault(
                "position",
                f"entry {index + 1} is {shown(part)}",
                "a finite number (mm) or the name of a parameter",
            )
            read.append(0.0)
    return read[0], read[1], read[2]


def _motion_errors(fields: Fields, moves: str | None) -> tuple[str, ...]:
    fields.known.add("motion_errors")
    value: Any = fields.raw.get("motion_errors", "all" if moves else [])
    if moves is None and "moves" in fields.raw:
        return ()  # which errors it may have is unknown until its axis is
    allowed = tuple(direction + moves for direction in DIRECTIONS) if moves else ()
    if value == "all" and moves:
        return allowed
    if not isinstance(value, list):
        fields.fault("motion_errors", f"is {shown(value)}", '"all" for a moving body, or a list such as ["EXY", "ECY"]')
        return ()
    for index, entry in enumerate(value):
        if entry not in allowed:
            right = f"of {' '.join(allowed)}" if allowed else "no motion errors: the body does not move"
            fields.fault("motion_errors", f"{shown(entry)} is no motion error of this body", right)
        elif entry in value[:index]:
            fields.fault("motion_errors", f"{entry!r} stands there already", "each name once")
    return tuple(name for name in allowed if name in value)
