"""Blocks of Heidenhain Klartext programs that are no path function: which leave the positions alone, which shift them.

Source: HEIDENHAIN, User's Manuals Klartext Programming and Cycle Programming (TNC 640, iTNC 530).
"""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from trueaxis.compensation.nc_lexer import NUMBER

_CYCLE = re.compile(r"CYCLE?[ \t]+DEF[ \t]+(\d+)(?:\.(\d+))?[ \t]*(.*)", re.IGNORECASE)
_SHIFT = re.compile(rf"(I?)([XYZABC])[ \t]*({NUMBER})[ \t]*", re.IGNORECASE)
_NUMBERS = re.compile(r"[-+]?\d+\.?\d*|[-+]?\.\d+")
# begin and end, blank, headings, messages; a label marks a place, and only a call makes something of it
_TEXT = re.compile(
    r"(?:BEGIN PGM|BLK FORM|\*|LBL[ \t]*(?:\d+|\".*\")[ \t]*$|PLANE RESET|TOOL DEF[ \t]+\d+[ \t]*$|"
    r"FUNCTION MODE MILL|FUNCTION FEED|FUNCTION S-PULSE RESET|FUNCTION COUNT|FUNCTION DWELL|PATTERN DEF|"
    r"SEL TABLE|CALL SELECTED TABLE|\? )",
    re.IGNORECASE,
)
# the tip follows the program, rotary axes turn evenly along each block
_CONTROL = re.compile(r"FUNCTION[ \t]+(?:(RESET[ \t]+TCPM)|TCPM F TCP AXIS POS PATHCTRL AXIS)", re.IGNORECASE)
_FAULTY = (
    (r"CALL LBL", "calls a part of the program"), (r"CALL PGM|PGM CALL|SEL PGM", "calls a program"),
    (r"CYCLE? CALL", "calls a cycle"), (r"RND", "rounds a corner"), (r"CHF", "bevels a corner"),
    (r"APPR|DEP", "approaches or leaves a contour"), (r"F[LPC][T]?[ \t]", "is free contour programming"),
    (r"PLANE", "tilts the plane"), (r"FUNCTION[ \t]*TCPM", "moves the linear axes with the rotary ones"),
    (r"FN|Q[LRS]?\d", "is a parameter"), (r"TCH PROBE|MEASURE", "probes"), (r"TRANS", "changes the frame"),
    (r"POLARKIN|FUNCTION PARAXCOMP|FUNCTION PARAXMODE", "changes the kinematics"),
    (r"LN|LT|CTP|CT", "is a path that is not followed"), (r"TOOL DEF", "gives tool data, which --tools is to give"),
)  # fmt: skip
# cycles that move nothing where they are defined: drilling, pockets and the like (called later), dwell, spindle, path
# tolerance
_LATER = frozenset({
    *range(1, 7), 9, 13, 14, 17, 18, *range(20, 26), 27, 28, 29, 32, *range(200, 210), 225, *range(230, 234), 240, 241,
    *range(251, 259), *range(262, 268), *range(270, 278),
})  # fmt: skip
# cycles that change the frame unless all their values are 0 (11: 1)
_FRAMES = {8: "mirrors", 10: "turns the coordinates", 11: "scales", 26: "scales", 19: "tilts the plane"}
_DATUM, _PRESET = 7, 247
_WRITTEN_OUT = "have its motions written out as L and C"


class Other(NamedTuple):
    """What a block asks for. shift: axes and values of a shift of the datum, added where their letter is in added;
    reset: no shift any more; preset: a point of the preset table; point_control: of the tool, on or off; ends: whether
    the program ends here; stops: whether the operator may act here. problem, remedy: of a fault.
    """

    shift: Mapping[str, float] = MappingProxyType({})
    added: frozenset[str] = frozenset()
    reset: bool = False
    preset: str = ""
    point_control: bool | None = None
    ends: bool = False
    stops: bool = False
    problem: str = ""
    remedy: str = ""


def other_block(text: str) -> Other:
    """What a block does that is no path function and no TOOL CALL; text: its lines joined, no number, no comment."""
    text = text.strip()
    if cycle := _CYCLE.match(text):
        return _cycle(int(cycle[1]), cycle[3].strip(), text)
    if halt := re.match(r"(END PGM)|STOP\b", text, re.IGNORECASE):
        return Other(ends=bool(halt[1]), stops=not halt[1])
    if match := re.fullmatch(r"TRANS DATUM (RESET|AXIS[ \t]+(.*))", text, re.IGNORECASE):
        return _shift(match[2]) if match[2] else Other(reset=True)
    control = _CONTROL.fullmatch(text)
    if control or not text or _TEXT.match(text):
        return Other(point_control=control[1] is None if control else None)
    known = next((what for pattern, what in _FAULTY if re.match(pattern, text, re.IGNORECASE)), "")
    if known:
        return Other(problem=f"{text[:20]!r} {known}, which is not followed", remedy=_WRITTEN_OUT)
    return Other(problem=f"{text[:20]!r} is not known", remedy="only blocks whose effect is known are accepted")


def _cycle(number: int, values: str, text: str) -> Other:
    if number == _DATUM and re.match(r"#|Q|\d", values):
        return Other(problem=f"{text[:24]!r} takes a shift from a table", remedy="give its values in the block")
    if number == _DATUM:
        return _shift(values)
    if number == _PRESET:
        preset = re.search(r"Q339[ \t]*=[ \t]*\+?(\d+)", text)
        return Other(preset=preset[1] if preset else "?")
    neutral = 1.0 if number in (11, 26) else 0.0
    changed = re.search(r"Q", values) or (number == 8 and re.search(r"[XYZ]", values))
    if number in _FRAMES and (changed or any(float(value) != neutral for value in _NUMBERS.findall(values))):
        return Other(problem=f"{text[:24]!r} {_FRAMES[number]}", remedy=_WRITTEN_OUT)
    if number in _FRAMES or number in _LATER:
        return Other()
    return Other(problem=f"{text[:24]!r} is a cycle that is not followed", remedy=_WRITTEN_OUT)


def _shift(values: str) -> Other:
    """Values of a datum shift, as `X+10` or `IX+10`; words that are no axis name the cycle."""
    shift, added, place = {}, set(), 0
    while match := _SHIFT.match(values, place):
        shift[match[2].upper()] = float(match[3])
        if match[1]:
            added.add(match[2].upper())
        place = match.end()
    rest = values[place:].strip()
    if rest and (shift or re.search(r"\d", rest)):
        return Other(problem=f"{rest[:20]!r} is no value of a datum shift", remedy="as X+10.5")
    return Other(shift=shift, added=frozenset(added))
