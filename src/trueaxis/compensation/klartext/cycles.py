"""What the drilling cycles of Heidenhain Klartext ask for: CYCL DEF 200 (drilling), 201 (reaming), 203 (universal
drilling) and 205 (universal pecking) with numbers, and the blocks that call them.
"""

import re
from collections.abc import Mapping
from typing import NamedTuple

from trueaxis.compensation.klartext.blocks import head_of
from trueaxis.compensation.nc.cycle_blocks import MOST_PECKS
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER

_DEFINITION = re.compile(r"CYCLE?[ \t]+DEF[ \t]+(\d+)(?:\.\d+)?", re.IGNORECASE)
_VALUE = re.compile(rf"Q(\d+)[ \t]*=[ \t]*({NUMBER}|\S+)", re.IGNORECASE)
_CALL = re.compile(r"[ \t]*(?:CYCLE?[ \t]+CALL(?=[ \t]*(?:$|;|~|M))|(?<![\w.])M[ \t]*99(?![\w.]))", re.IGNORECASE)
_CALL_AT = re.compile(r"CYCLE?[ \t]+CALL[ \t]+POS\b(.*)", re.IGNORECASE)
_PLACE = re.compile(rf"[ \t]*([XYZ])[ \t]*({NUMBER})", re.IGNORECASE)
_BESIDE = re.compile(r"(?:[ \t]*(?:R0|FMAX|M[ \t]*\d+))*[ \t]*", re.IGNORECASE)
PLAIN_CYCLES = "CYCL DEF 200, 201, 203 and 205 with numbers are followed; have others written out as L"
_BARE = re.compile(r"(?:L[ \t]*)?(?:R0[ \t]*)?(?:FMAX[ \t]*)?", re.IGNORECASE)
# what acts where it is defined leaves the cycle that is called as it was: datum, mirror, dwell, rotation, scaling,
# spindle, contours, tilt, tolerance, preset
_AT_ONCE = frozenset({7, 8, 9, 10, 11, 13, 14, 19, 20, 26, 32, 247})
_RAPID = 99999.0  # of a feed: FMAX
_ALWAYS = frozenset({200, 201, 203, 206})
# Q that each cycle has, and may have
_PARTS = {
    200: (_ALWAYS | {202}, frozenset({204, 210, 211, 395})),
    201: (_ALWAYS, frozenset({204, 208, 211})),
    203: (_ALWAYS | {202}, frozenset({204, 205, 208, 210, 211, 212, 213, 256, 395})),
    205: (_ALWAYS | {202}, frozenset({204, 205, 208, 211, 212, 253, 256, 257, 258, 259, 379, 395})),
}
# Q that must be 0: what they do otherwise
_SMALLER = 212
_PLAIN = {
    _SMALLER: "makes each plunging depth smaller", 213: "breaks chips", 257: "breaks chips", 379: "begins in a hole",
    395: "counts the depth from the edge of the drill",
}  # fmt: skip


class Drilling(NamedTuple):
    """Lengths as written, in the frame in force. surface: of the part; clearance: how far above it the feed begins;
    clear: where the hole ends; peck: 0 for the whole depth; above: how far above the depth of the peck before the feed
    goes on; feed: mm/min or 0.1 inch/min, retract: back to the clearance at the end, between: between pecks, 0: rapid;
    dwells (s) at the clearance between pecks, and at the bottom. number: of the cycle.
    """

    number: int
    surface: float
    clearance: float
    bottom: float
    clear: float
    peck: float
    above: float
    feed: float
    retract: float
    between: float
    dwell_above: float
    dwell: float

    def raised(self, by: float) -> "Drilling":
        """The same elsewhere along the axis that drills."""
        return self._replace(surface=self.surface + by, bottom=self.bottom + by, clear=self.clear + by)


class NotFollowed(NamedTuple):
    """A cycle that is defined and may not be called: what of it is not followed."""

    problem: str


def defined(text: str, before: Drilling | NotFollowed | None) -> Drilling | NotFollowed | None:
    """The cycle that a call means after this block; None: none. text: with its comments."""
    plain = re.sub(r";[^\n]*", "", text)
    definition = _DEFINITION.search(plain)
    if definition is None or int(definition[1]) in _AT_ONCE:
        return before
    number, name = int(definition[1]), f"CYCL DEF {definition[1]}"
    if number not in _PARTS:
        return NotFollowed(f"{name} is called, whose motions are not followed")
    values = {int(q): value for q, value in _VALUE.findall(plain)}
    needed, may = _PARTS[number]
    wrong = [f"with Q{q}, which is not followed" for q in values if q not in needed | may]
    wrong += [
        f"with Q{q}={value}, which is no number"
        for q, value in values.items() if not re.fullmatch(NUMBER, value) and (q, value.upper()) != (208, "FMAX")
    ]  # fmt: skip
    wrong += [f"without Q{q}" for q in sorted(needed - values.keys())]
    given = {} if wrong else {q: _RAPID if value.upper() == "FMAX" else float(value) for q, value in values.items()}
    wrong += _problems(given) if given else []
    return NotFollowed(f"{name} is called {wrong[0]}") if wrong else _drilling(number, given)


def _problems(q: Mapping[int, float]) -> list[str]:
    """What of the values is not followed."""
    peck, back = q.get(202, 0.0), q.get(258, 0.0)
    one_peck = not 0.0 < peck < -q[201]
    problems = (
        (any(not abs(value) < LARGEST for value in q.values()), "with a value beyond all travel"),
        (not q[201] < 0.0, "with a depth Q201 that is not below 0"),
        (not q[206] > 0.0 or min(q[200], peck, q.get(208, 0.0)) < 0.0, "with Q200, Q202, Q206 or Q208 below 0"),
        (peck > 0.0 and -q[201] > MOST_PECKS * peck, f"with more than {MOST_PECKS} pecks"),
        (not one_peck and q.get(259, back) != back, "with Q259 other than Q258, which is not followed"),
        *(
            (bool(q.get(name)) and not (name == _SMALLER and one_peck), f"with Q{name}, which {does}: not followed")
            for name, does in _PLAIN.items()
        ),
    )
    return [problem for wrong, problem in problems if wrong]


def _drilling(number: int, q: Mapping[int, float]) -> Drilling:
    retract = 0.0 if q.get(208, _RAPID) == _RAPID else q[208] or q[206]
    return Drilling(
        number=number, surface=q[203], clearance=q[200], bottom=q[203] + q[201],
        clear=q[203] + max(q[200], q.get(204, 0.0)), peck=q.get(202, 0.0),
        above=q.get(258, 0.0) if number == 205 else q[200], feed=q[206], retract=retract,
        between=retract if number == 203 else 0.0, dwell_above=q.get(210, 0.0), dwell=q.get(211, 0.0),
    )  # fmt: skip


class Call(NamedTuple):
    """A call of the cycle that is defined before. rest: the block without it, empty if nothing remains; shift: by how
    much the cycle is raised; goes: whether the block goes to the hole (CYCL CALL POS); problem: what is wrong with it.
    """

    rest: str
    shift: float = 0.0
    goes: bool = False
    problem: str = ""


def call_of(text: str) -> Call | None:
    """The call in a block; None if it has none."""
    code, sign, comment = text.partition(";")
    end = f" {sign}{comment}" if sign else text[len(text.rstrip("\r\n")) :]
    code = code.rstrip("\r\n")
    if found := _CALL_AT.search(code):
        return _call_at(code[: found.start()], found[1], end)
    if not _CALL.search(code):
        return None
    rest = _CALL.sub("", code)
    if _BARE.fullmatch(head_of(f"{rest} ")[2].strip()):
        return Call("")
    return Call((rest.rstrip() if sign else rest) + end)


def _call_at(head: str, words: str, end: str) -> Call:
    """CYCL CALL POS with these words: goes there, its Z being a shift of the cycle."""
    given = _PLACE.findall(words)
    place, beside = {axis.upper(): value for axis, value in given}, _PLACE.sub("", words)
    if len(given) != 3 or len(place) != 3 or "FMAX" not in beside.upper() or not _BESIDE.fullmatch(beside):
        return Call("", problem="CYCL CALL POS with other words than X, Y, Z (absolute), FMAX, R0 and M")
    if any(abs(float(value)) >= LARGEST for value in place.values()):
        return Call("", problem="CYCL CALL POS beyond all travel")
    codes = "".join(f" {code}" for code in re.findall(r"M[ \t]*\d+", beside, re.IGNORECASE))
    return Call(f"{head}L X{place['X']} Y{place['Y']} R0 FMAX{codes}{end}", float(place["Z"]), goes=True)
