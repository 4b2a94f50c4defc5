"""What the drilling cycles of Heidenhain Klartext ask for: CYCL DEF 200 (drilling), 201 (reaming), 203 (universal
drilling), 205 (universal pecking) and the older 1 (pecking) with numbers, and the blocks that call them.

Names of Q202, Q256, Q257 and Q258 are those of HEIDENHAIN's User's Manual TNC 426/430, page 244. Which Q a cycle has is
as CAM systems write them; in which order pecks and broken chips come was not compared with a manual.
"""

import re
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import NamedTuple

from trueaxis.compensation.klartext.blocks import head_of
from trueaxis.compensation.nc.cycle_blocks import MOST_PECKS
from trueaxis.compensation.nc.g_codes import TAP_APART
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER

_DEFINITION = re.compile(r"CYCLE?[ \t]+DEF[ \t]+(\d+)(?:\.\d+)?", re.IGNORECASE)
_VALUE = re.compile(rf"Q(\d+)[ \t]*=[ \t]*({NUMBER}|\S+)", re.IGNORECASE)
_CALL = re.compile(r"[ \t]*(?:CYCLE?[ \t]+CALL(?=[ \t]*(?:$|;|~|M))|(?<![\w.])M[ \t]*99(?![\w.]))", re.IGNORECASE)
_CALL_AT = re.compile(r"CYCLE?[ \t]+CALL[ \t]+POS\b(.*)", re.IGNORECASE)
_PLACE = re.compile(rf"[ \t]*([XYZ])[ \t]*({NUMBER})", re.IGNORECASE)
_BESIDE = re.compile(r"(?:[ \t]*(?:R0|FMAX|M[ \t]*\d+))*[ \t]*", re.IGNORECASE)
_BARE = re.compile(r"(?:L[ \t]*)?(?:R0[ \t]*)?(?:FMAX[ \t]*)?", re.IGNORECASE)
# what acts where it is defined leaves the cycle that is called as it was: datum, mirror, dwell, rotation, scaling,
# spindle, contours, tilt, tolerance, preset
_AT_ONCE = frozenset({7, 8, 9, 10, 11, 13, 14, 19, 20, 26, 32, 247})
_RAPID = 99999.0  # of a feed: FMAX
PECKING = 1  # the older cycle: from where Z stands, with its values in blocks of their own
_OLDER = re.compile(rf"CYCLE?[ \t]+DEF[ \t]+1\.([1-5])[^-+\d]*({NUMBER})[ \t]*$", re.IGNORECASE | re.MULTILINE)
_ABOVE, _SHALLOW, _MOST_ABOVE = 0.6, 30.0, 7.0  # mm: where its feed begins again, see Drilling; 1/50 of deeper holes
_BACK = frozenset({208, 253, 373})  # feeds out of the hole and back to the depth
_ALWAYS = frozenset({200, 201, 203, 206})
# Q that each cycle has, and may have
_PARTS = {
    200: (_ALWAYS | {202}, frozenset({204, 210, 211, 395})),
    201: (_ALWAYS, frozenset({204, 208, 211})),
    203: (_ALWAYS | {202}, frozenset({204, 205, 208, 210, 211, 212, 213, 256, 395})),
    205: (_ALWAYS | {202}, frozenset({204, 205, 208, 211, 212, 253, 256, 257, 258, 259, 373, 379, 395})),
}
_NAMES = [str(number) for number in (PECKING, *_PARTS)]
PLAIN_CYCLES = (
    f"CYCL DEF {', '.join(_NAMES[:-1])} and {_NAMES[-1]} with numbers are followed; have others written out as L"
)
# Q that must be 0: what they do otherwise
_PLAIN = {379: "begins in a hole", 395: "counts the depth from the edge of the drill"}
SAME = 1e-9  # of depths: what doubles lose


class Drilling(NamedTuple):
    """Lengths as written, in the frame in force. surface: of the part; clearance: how far above it the feed begins;
    clear: where the hole ends. peck: 0 for the whole depth; smaller: by how much each is less than the one before, but
    not below least; above: how far above the depth of the first and of the last peck the feed goes on; again: the feed
    to there, 0: rapid. breaks: how many pecks end with a broken chip before one ends outside the hole; broken: how deep
    the tool goes within a peck until it breaks the chip, 0: it does not; back: how far it goes back for that.
    feed: mm/min or 0.1 inch/min, retract: back to the clearance at the end, between: between pecks, 0: rapid;
    dwells (s) at the clearance between pecks, and at the bottom. number: of the cycle.
    """

    number: int
    surface: float
    clearance: float
    bottom: float
    clear: float
    peck: float
    smaller: float
    least: float
    above: tuple[float, float]
    again: float
    breaks: int
    broken: float
    back: float
    feed: float
    retract: float
    between: float
    dwell_above: float
    dwell: float

    def raised(self, by: float) -> "Drilling":
        """The same elsewhere along the axis that drills."""
        return self._replace(surface=self.surface + by, bottom=self.bottom + by, clear=self.clear + by)

    def depths(self) -> Iterator[float]:
        """Where each peck ends; the last is the bottom. Without end where the pecks come to nothing."""
        depth, peck = self.surface, self.peck
        while self.peck and (depth := depth - peck) > self.bottom + SAME:
            yield depth
            peck = max(peck - self.smaller, self.least, 0.0) if self.smaller else peck
        yield self.bottom


_TAPPING = frozenset({2, 17, 18, 206, 207, 209})


class NotFollowed(NamedTuple):
    """A cycle that is defined and may not be called: what of it is not followed, and what would be right. given: of
    CYCL DEF 1, by number.
    """

    problem: str
    given: tuple[tuple[int, float], ...] = ()
    remedy: str = PLAIN_CYCLES


def defined(text: str, before: Drilling | NotFollowed | None) -> Drilling | NotFollowed | None:
    """The cycle that a call means after this block; None: none. text: with its comments."""
    plain = re.sub(r";[^\n]*", "", text)
    definition = _DEFINITION.search(plain)
    if definition is None or int(definition[1]) in _AT_ONCE:
        return before
    number, name = int(definition[1]), f"CYCL DEF {definition[1]}"
    if number == PECKING:
        return _pecking(plain, before)
    if number in _TAPPING:
        return NotFollowed(f"{name} is called, which taps: its motions go with the spindle", remedy=TAP_APART)
    if number not in _PARTS:
        return NotFollowed(f"{name} is called, whose motions are not followed")
    values = {int(q): value for q, value in _VALUE.findall(plain)}
    needed, may = _PARTS[number]
    wrong = [f"with Q{q}, which is not followed" for q in values if q not in needed | may]
    wrong += [
        f"with Q{q}={value}, which is no number"
        for q, value in values.items() if not re.fullmatch(NUMBER, value) and not _is_rapid(q, value)
    ]  # fmt: skip
    wrong += [f"without Q{q}" for q in sorted(needed - values.keys())]
    given = {} if wrong else {q: _RAPID if _is_rapid(q, value) else float(value) for q, value in values.items()}
    wrong += _problems(given) if given else []
    return NotFollowed(f"{name} is called {wrong[0]}") if wrong else _drilling(number, given)


def _pecking(plain: str, before: Drilling | NotFollowed | None) -> Drilling | NotFollowed:
    """CYCL DEF 1, whose values stand in five blocks, as far as this one; lengths from where Z stands when called."""
    found = _OLDER.search(plain)
    given = {} if found is None or not isinstance(before, NotFollowed) else dict(before.given)
    if found is not None:
        given[int(found[1])] = float(found[2])
    clearance, depth, peck, dwell, feed = (given.get(number) for number in range(1, 6))
    if None in (clearance, depth, peck, dwell, feed):
        return NotFollowed("CYCL DEF 1 is called without its five values as numbers", tuple(given.items()))
    q = {200: abs(clearance or 0.0), 201: depth or 0.0, 202: abs(peck or 0.0), 203: -abs(clearance or 0.0),
         206: feed or 0.0, 211: dwell or 0.0}  # fmt: skip
    if wrong := _problems(q):
        return NotFollowed(f"CYCL DEF 1 is called {wrong[0]}".replace("Q201", "1.2").replace("Q206", "1.5"))
    size = abs(depth or 0.0)
    above = _ABOVE if size <= _SHALLOW else min(size / 50.0, _MOST_ABOVE)
    made = _drilling(PECKING, q)
    return made if isinstance(made, NotFollowed) else made._replace(above=(above, above))


def _is_rapid(q: int, value: str) -> bool:
    return q in _BACK and value.upper() in {"FMAX", "MAX"}


def _problems(q: Mapping[int, float]) -> list[str]:
    """What of the values is not followed."""
    lengths = [name for name in (200, 202, 205, 206, 208, 212, 213, 256, 257, 258, 259, 373) if q.get(name, 0.0) < 0.0]
    problems = (
        (any(not abs(value) < LARGEST for value in q.values()), "with a value beyond all travel"),
        (not q[201] < 0.0, "with a depth Q201 that is not below 0"),
        (not q[206] > 0.0, "with Q206, the feed, not above 0"),
        (bool(lengths), f"with Q{lengths[0]} below 0" if lengths else ""),
        (q.get(213, 0.0) % 1.0 != 0.0, "with Q213, a number of breaks, that is not whole"),
        *((bool(q.get(name)), f"with Q{name}, which {does}: not followed") for name, does in _PLAIN.items()),
    )
    return [problem for wrong, problem in problems if wrong]


def _drilling(number: int, q: Mapping[int, float]) -> Drilling | NotFollowed:
    retract = 0.0 if q.get(208, _RAPID) == _RAPID else q[208] or q[206]
    first = q.get(258, 0.0) if number == 205 else q[200]
    found = Drilling(
        number=number, surface=q[203], clearance=q[200], bottom=q[203] + q[201],
        clear=q[203] + max(q[200], q.get(204, 0.0)), peck=q.get(202, 0.0), smaller=q.get(212, 0.0),
        least=q.get(205, 0.0), above=(first, q.get(259, first)),
        again=0.0 if q.get(373, _RAPID) == _RAPID else q[373], breaks=round(q.get(213, 0.0)), broken=q.get(257, 0.0),
        back=q.get(256, 0.0), feed=q[206], retract=retract, between=retract if number == 203 else 0.0,
        dwell_above=q.get(210, 0.0), dwell=q.get(211, 0.0),
    )  # fmt: skip
    most = len(list(islice(found.depths(), MOST_PECKS + 1)))
    if most > MOST_PECKS or (found.broken and -q[201] > MOST_PECKS * found.broken):
        return NotFollowed(f"CYCL DEF {number} is called with more than {MOST_PECKS} pecks: Q202, Q212, Q205 or Q257")
    return found


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
