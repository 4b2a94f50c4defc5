"""One block of a Heidenhain Klartext program: its verb, its words and the text around them; what blocks that are no
path function do to positions.
"""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.lexer import NUMBER, decimals_of
from trueaxis.compensation.nc.mistyped import mistyped

_HEAD = re.compile(r"([ \t]*+(?:\d++[ \t]++)?)(/?)[ \t]*+")
_VERB = re.compile(r"(LP|LN|LT|L|CC|CP|CR|CTP|CT|C)(?=[ \t]|$|[XYZ][-+.0-9])", re.IGNORECASE)
_AXIS = re.compile(rf"(I?)(PR|PA|[XYZABC])[ \t]*+({NUMBER})(?![\w.])", re.IGNORECASE)
_DIRECTION = re.compile(r"DR([-+])", re.IGNORECASE)
_RADIUS = re.compile(r"R([-+](?:\d++\.?+\d*+|\.\d++))(?![\w.])", re.IGNORECASE)
_SIDE = re.compile(r"R[0LR](?![\w.])", re.IGNORECASE)
_FEED = re.compile(r"F[ \t]*+(?:(MAX|AUTO)|(\d++\.?+\d*+|\.\d++))(?![\w.])", re.IGNORECASE)
_CODE = re.compile(r"M[ \t]*+(\d++)(?![\w.])", re.IGNORECASE)
_RETRACTION = re.compile(r"MB[ \t]*+(?:MAX|\+?(?:\d++\.?+\d*+|\.\d++))(?![\w.])", re.IGNORECASE)
_LONG = re.compile(r"(?<![\d.])\d{10,}")
_BLANK = re.compile(r"[ \t]++")
MACHINE_COORDINATES, RETRACT = 91, 140
PRESET = "the preset that CYCL DEF 247 selects is taken to be the one that --offset G54 gives"


class Coordinate(NamedTuple):
    """value: mm (inch) or deg; incremental: whether it counts from where the axis stands; decimals: written."""

    value: float
    incremental: bool
    decimals: int


class KlartextBlock(NamedTuple):
    """A block of the path functions; empty verb: none.

    head: block number and blanks before it; optional: `/` of an optional block; others: the words that are no
    coordinates, as written; comment: from `;` on. direction: +1 for DR+, -1 for DR-, 0: none. radius: of CR, with sign.
    feed: mm/min or 0.1 inch/min, None: no F; rapid: FMAX. side: R0, RL, RR or empty. retracts: M140 MB
    MAX or MB+50: along the tool axis, out of what is cut. problem: what is wrong with it; mended: the text of the block
    with the number put right that this says to be mistyped.
    """

    verb: str = ""
    head: str = ""
    optional: str = ""
    coordinates: Mapping[str, Coordinate] = MappingProxyType({})
    direction: int = 0
    radius: float | None = None
    feed: float | None = None
    rapid: bool = False
    side: str = ""
    retracts: bool = False
    codes: tuple[int, ...] = ()
    others: tuple[str, ...] = ()
    comment: str = ""
    problem: str = ""
    mended: str = ""

    @property
    def feeds(self) -> bool:
        """Whether it says at which feed: by F, or by FAUTO that of the TOOL CALL."""
        return any(word[0] in "Ff" for word in self.others) and not self.rapid


def head_of(body: str) -> tuple[str, str, str]:
    """Number and blanks, `/`, and the rest of a block without its comment."""
    match = _HEAD.match(body)
    if match is None:
        return "", "", body
    return match[1], match[2], body[match.end() :]


def too_long(body: str) -> str:
    """What is wrong with a number of more digits than any machine's, block numbers too; empty if there is none."""
    found = _LONG.search(body.partition(";")[0])
    return f"{found[0][:20]}... is no machine's number" if found else ""


def lex_klartext(body: str) -> KlartextBlock:
    """A block of a path function; verb is empty where it is something else."""
    head, optional, rest = head_of(body)
    text, sign, comment = rest.partition(";")
    verb = _VERB.match(text)
    if verb is None:
        return KlartextBlock(head=head, optional=optional, comment=sign + comment)
    coordinates: dict[str, Coordinate] = {}
    codes: list[int] = []
    others: list[str] = []
    direction, radius, feed, rapid, side, retracts, problem, mended = 0, None, None, False, "", False, "", ""
    place = verb.end()
    while place < len(text) and not problem:
        if found := _BLANK.match(text, place):
            pass
        elif found := _AXIS.match(text, place):
            letter, value = found[2].upper(), float(found[3])
            if letter in coordinates:
                problem = f"{letter} occurs twice in the block"
            coordinates[letter] = Coordinate(value, bool(found[1]), decimals_of(found[3]) or 0)
        elif found := _DIRECTION.match(text, place):
            direction = 1 if found[1] == "+" else -1
        elif found := _SIDE.match(text, place):
            side = found[0].upper()
            others.append(found[0])
        elif found := _RADIUS.match(text, place):
            radius = float(found[1])
        elif found := _FEED.match(text, place):
            rapid = (found[1] or "").upper() == "MAX"
            feed = float(found[2]) if found[2] else None
            others.append(found[0])
        elif found := _CODE.match(text, place):
            codes.append(int(found[1]))
            others.append(found[0])
        elif RETRACT in codes and (found := _RETRACTION.match(text, place)):
            retracts = True
            others.append(found[0])
        else:
            slip = mistyped(text, place)
            problem = slip.problem if slip else f"{text[place : place + 20].strip()!r} is no word with its value"
            mended = f"{body[: -len(rest)]}{slip.mended}{sign}{comment}" if slip else ""
            break
        place = found.end()
    return KlartextBlock(
        verb[1].upper(), head, optional, coordinates, direction, radius, feed, rapid, side, retracts, tuple(codes),
        tuple(others), sign + comment, problem, mended,
    )  # fmt: skip


def codes_alone(content: str) -> KlartextBlock | None:
    """A block of M codes without a path function."""
    if (alone := content.strip().upper()).startswith(f"M{RETRACT} "):
        retracting = lex_klartext(f"L {alone}")
        return retracting._replace(verb="") if not retracting.coordinates else None
    words = content.split()
    if len(words) == 2 and words[0].upper() == "M128" and re.fullmatch(rf"[Ff]{NUMBER}", words[1]):
        words.pop()  # by how fast the linear axes follow the rotary ones at most
    if not words or not all(word[0] in "Mm" and word[1:].isdigit() for word in words):
        return None
    return KlartextBlock(codes=tuple(int(word[1:]) for word in words), others=tuple(words))


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
_AT_POINTS, _AT_EACH = "calls a cycle at the points of a pattern", "L X+10 Y+20 R0 FMAX M99 for each point"
_FAULTY = (
    (r"CALL LBL", "calls a part of the program"), (r"CALL PGM|PGM CALL|SEL PGM", "calls a program"),
    (r"CYCLE? CALL PAT|SEL PATTERN", _AT_POINTS),
    (r"CYCLE? CALL", "calls a cycle"), (r"RND", "rounds a corner"), (r"CHF", "bevels a corner"),
    (r"APPR|DEP", "approaches or leaves a contour"), (r"F[LPC][T]?[ \t]", "is free contour programming"),
    (r"PLANE", "tilts the plane"), (r"FUNCTION[ \t]*TCPM", "moves the linear axes with the rotary ones"),
    (r"FN|Q[LRS]?\d", "is a parameter"), (r"TCH PROBE|MEASURE", "probes"), (r"TRANS", "changes the frame"),
    (r"POLARKIN|FUNCTION PARAXCOMP|FUNCTION PARAXMODE", "changes the kinematics"),
    (r"LN|LT|CTP|CT", "is a path by its tangent or normal"), (r"TOOL DEF", "gives tool data, which --tools is to give"),
)  # fmt: skip
# cycles that move nothing where they are defined: drilling, pockets and the like (called later), dwell, spindle, path
# tolerance
_LATER = frozenset({
    *range(1, 7), 9, 13, 14, 17, 18, *range(20, 26), 27, 28, 29, 32, *range(200, 210), 225, *range(230, 234), 240, 241,
    *range(251, 259), *range(262, 268), *range(270, 278),
})  # fmt: skip
# cycles that change the frame unless all their values are 0 (11: 1)
_FRAMES = {8: "mirrors", 10: "turns the coordinates", 11: "scales", 26: "scales", 19: "tilts the plane"}
_DATUM, _PRESET, _TOLERANCE = 7, 247, 32
_PATTERNS = frozenset({220, 221})
_NOTES = {_TOLERANCE: f"CYCL DEF {_TOLERANCE} (tolerance): {codes.ROUNDS}"}
_WRITTEN_OUT = "have its motions written out as L and C"


class Other(NamedTuple):
    """What a block asks for. shift: axes and values of a shift of the datum, added where their letter is in added;
    reset: no shift any more; preset: a point of the preset table; point_control: of the tool, on or off; ends: whether
    the program ends here; stops: whether the operator may act here. note: a remark. problem, remedy: of a fault.
    """

    shift: Mapping[str, float] = MappingProxyType({})
    added: frozenset[str] = frozenset()
    reset: bool = False
    preset: str = ""
    point_control: bool | None = None
    ends: bool = False
    stops: bool = False
    note: str = ""
    problem: str = ""
    remedy: str = ""


def other_block(text: str) -> Other:
    """What a block does that is no path function and no TOOL CALL; text: its lines joined, no number, no comment."""
    text = text.strip()
    if cycle := _CYCLE.match(text):
        begins = int(cycle[2] or 0) == 0
        return _cycle(int(cycle[1]), cycle[3].strip(), text)._replace(
            note=_NOTES.get(int(cycle[1]), "") if begins else ""
        )
    if halt := re.match(r"(END PGM)|STOP\b", text, re.IGNORECASE):
        return Other(ends=bool(halt[1]), stops=not halt[1])
    if match := re.fullmatch(r"TRANS DATUM (RESET|AXIS[ \t]+(.*))", text, re.IGNORECASE):
        return _shift(match[2]) if match[2] else Other(reset=True)
    control = _CONTROL.fullmatch(text)
    if control or not text or _TEXT.match(text):
        return Other(point_control=control[1] is None if control else None)
    known = next((what for pattern, what in _FAULTY if re.match(pattern, text, re.IGNORECASE)), "")
    if known:
        remedy = _AT_EACH if known == _AT_POINTS else _WRITTEN_OUT
        return Other(problem=f"{text[:20]!r} {known}, which is not followed", remedy=remedy)
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
    what, remedy = (_AT_POINTS, _AT_EACH) if number in _PATTERNS else ("is a cycle", _WRITTEN_OUT)
    return Other(problem=f"{text[:24]!r} {what}, which is not followed", remedy=remedy)


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
