"""CYCLE81, CYCLE82 and CYCLE83 of SINUMERIK: what their arguments ask for, and the motions of a hole.

The order of the arguments is that in which Autodesk's posts for SINUMERIK 840D write them, _GMODE, _DMODE and _AMODE
last.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from trueaxis.compensation.nc.canned_cycle import DrillingCall
from trueaxis.compensation.nc.cycle_blocks import DWELL, FEED, MOST_PECKS, RAPID
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER

DEEP = "CYCLE83"
DRILLING = frozenset({"CYCLE81", "CYCLE82", DEEP})
MODAL = "MCALL"
END_OF_CALLS = DrillingCall()
_ARGUMENT = re.compile(rf"[ \t]*+({NUMBER})?[ \t]*+")
_MOST = 9  # RTP RFP SDIS DP DPR DTB _GMODE _DMODE _AMODE
_MOST_DEEP = 20  # RTP RFP SDIS DP DPR FDEP FDPR _DAM DTB DTS FRF VARI _AXN _MDEP _VRT _DTD _DIS1 _GMODE _DMODE _AMODE
# _GMODE, _DMODE and _AMODE that change neither depth nor plane; posts leave DTB out before them in CYCLE81, so that
# each may stand one place further to the left
_MODES = ((0.0,), (0.0, 1.0, 10.0, 12.0), (0.0, 2.0, 10.0, 12.0))
_PLAIN = (
    "RTP, RFP, SDIS, DP or DPR, DTB as numbers, of CYCLE83 FDEP or FDPR, VARI, and _DAM, DTS, _AXN, _MDEP, _VRT, _DTD, "
    "_DIS1; 0 for further ones"
)
# of the control, mm: how far it goes back to break chips (_VRT 0), and stays above the depth before (_DIS1 0)
_BACK = 1.0
_LEAST_PECK = 0.001  # mm or inch: the least increment of most controls
_AXES = {1.0: "X", 2.0: "Y", 3.0: "Z"}  # _AXN
_AHEAD, _DEPTH_OF_AHEAD, _MOST_AHEAD = 0.6, 30.0, 7.0


class CallError(Exception):
    """What is wrong with the arguments of a cycle, and what would be right."""

    def __init__(self, problem: str, remedy: str = _PLAIN) -> None:
        super().__init__(problem)
        self.remedy = remedy


def drilling_call(name: str, arguments: str | None, modal: bool) -> DrillingCall:
    """The cycle that a call asks for. Raises CallError."""
    most = _MOST_DEEP if name == DEEP else _MOST
    given = _numbers(arguments or "()", most)
    given += [None] * (most - len(given))
    retract, reference, clearance, depth, relative = given[:5]
    if problem := _problem_of_modes(name, given):
        raise CallError(f"{name} with {problem}")
    if retract is None or reference is None:
        raise CallError(f"{name} without RTP and RFP")
    bottom = _depth(name, ("DP", depth), ("DPR", relative), reference)
    top = reference + abs(clearance or 0.0)
    if not bottom < top <= retract:
        raise CallError(f"{name}: the depth is not below RFP + SDIS, or RTP not above it", "as (50,0,2,-20)")
    if name == DEEP:
        return _deep(given, reference, DrillingCall(name=name, depths=(bottom,), top=top, clear=retract, modal=modal))
    dwell = _dwell(given[5])
    return DrillingCall(name=name, depths=(bottom,), top=top, clear=retract, dwells=(dwell, "", dwell), modal=modal)


def _deep(given: list[float | None], reference: float, plain: DrillingCall) -> DrillingCall:
    """CYCLE83: in pecks, chips broken (VARI 0) or taken out (1)."""
    first, first_relative, smaller, dwell, dwell_above, share, way, axis, least, back, dwell_last, ahead = given[5:17]
    first = _depth(DEEP, ("FDEP", first), ("FDPR", first_relative), reference)
    factor, smaller = (-smaller, 0.0) if smaller and smaller < 0.0 else (1.0, smaller or 0.0)
    problems = (
        (not plain.depths[0] <= first < plain.top, "with a first depth that is not between RFP + SDIS and the depth"),
        (factor > 1.0 or (least or 0.0) < 0.0, "with _DAM below -1, or _MDEP below 0"),
        (share not in (None, 0.0, 1.0), "with FRF other than 1 (another feed to the first depth)"),
        (way not in (0.0, 1.0), "without VARI 0 or 1"),
        (axis not in (None, 0.0, *_AXES), "with _AXN that is none of 1, 2 and 3"),
        (min(back or 0.0, ahead or 0.0) < 0.0, "with _VRT or _DIS1 below 0"),
    )
    for wrong, problem in problems:
        if wrong:
            raise CallError(f"{DEEP} {problem}")
    return DrillingCall(
        name=DEEP, axis=_AXES.get(axis or 0.0, ""), top=plain.top,
        depths=tuple(_depths(reference, first, plain.depths[0], _Pecks(smaller, factor, least or 0.0))),
        clear=plain.clear, back=0.0 if way else back or None, ahead=ahead or None,
        dwells=(_dwell(dwell), _dwell(dwell_above), _dwell(dwell_last or dwell)), modal=plain.modal,
    )  # fmt: skip


def _depth(
    name: str, absolute: tuple[str, float | None], relative: tuple[str, float | None], reference: float
) -> float:
    """A depth that is given as a position or below the reference plane, or both ways alike."""
    (word, depth), (other, below) = absolute, relative
    if depth is None and below is None:
        raise CallError(f"{name} without one of {word} and {other}")
    by_other = depth if below is None else reference - abs(below)
    if depth is not None and by_other != depth:
        raise CallError(f"{name} with {word} and {other} that are different depths", f"leave {other} empty, also 0")
    return by_other if by_other is not None else reference


def _problem_of_modes(name: str, given: list[float | None]) -> str:
    """What is not followed of _GMODE, _DMODE and _AMODE."""
    *modes, last = given[-3:]
    if name != DEEP or not last:
        modes.append(last)
    right = all(mode in (None, *may) for mode, may in zip(modes, _MODES, strict=False))
    if right and name == DEEP and last:
        right = last % 1.0 == 0.0 and last >= 0.0 and _deep_mode(f"{last:010.0f}"[::-1], given)
    return "" if right else "a mode (_GMODE, _DMODE, _AMODE) that is not followed"


def _deep_mode(digits: str, given: list[float | None]) -> bool:
    """Whether the digits of _AMODE, the last first, say of CYCLE83 what the arguments say without them: how depths are
    given, that dwells are seconds, and, of no matter where all pecks are alike, what _DAM and FRF are.
    """
    _, reference, _, depth, relative, first, first_relative, smaller = given[:8]
    depths = (digits[0], depth, relative), (digits[4], first, first_relative)
    as_given = all(
        digit in "0" + "2" * (absolute is not None) + "1" * (absolute is None and below is not None)
        for digit, absolute, below in depths
    )
    peck = first_relative if first is None else (reference or 0.0) - first
    alike = not smaller or (given[13] or 0.0) >= abs(peck or 0.0)
    return as_given and set(digits[1:4]) <= {"0", "1"} and (alike or set(digits[5:]) <= {"0"})


class _Pecks(NamedTuple):
    """By how much each peck is smaller than the one before, and no smaller than that; or what share of it, and no
    smaller than `least`, which matters with a share alone.
    """

    smaller: float
    share: float
    least: float


def _depths(reference: float, first: float, bottom: float, pecks: _Pecks) -> Iterator[float]:
    """Depths one after another; what is left of twice the amount of _DAM is halved."""
    depth, peck, smaller = first, reference - first, pecks.smaller
    for _ in range(MOST_PECKS):
        yield depth
        if depth <= bottom:
            return
        peck = max(peck - smaller, smaller) if pecks.share == 1.0 else max(peck * pecks.share, pecks.least)
        if pecks.share < 1.0 and peck < _LEAST_PECK:
            raise CallError(f"{DEEP} with pecks that come to nothing: _DAM is a share, and _MDEP is 0")
        left = depth - bottom
        halved = smaller and smaller < left <= 2.0 * smaller
        depth = depth - 0.5 * left if halved else max(depth - peck, bottom) if peck > 0.0 else bottom
        if halved:
            yield depth
            depth = bottom
    raise CallError(f"{DEEP} with more than {MOST_PECKS} pecks")


def motions(call: DrillingCall, scale: float) -> Iterator[tuple[int, float, str]]:
    """What is done in a hole: rapids and feed motions with their ends, as written, and dwells with their words; scale:
    mm of a unit.
    """
    each, above, at_last = call.dwells
    bottom, size = call.depths[-1], scale * (call.top - call.depths[-1])
    back = _BACK / scale if call.back is None else call.back
    of_control = _AHEAD if size <= _DEPTH_OF_AHEAD else min(size / 50.0, _MOST_AHEAD)
    ahead = of_control / scale if call.ahead is None else call.ahead
    yield RAPID, call.top, ""
    for depth in call.depths[:-1]:
        yield FEED, depth, ""
        if each:
            yield DWELL, depth, each
        if back:
            yield FEED, min(depth + back, call.top), ""
            continue
        yield RAPID, call.top, ""
        if above:
            yield DWELL, call.top, above
        yield RAPID, min(depth + ahead, call.top), ""
    yield FEED, bottom, ""
    if at_last:
        yield DWELL, bottom, at_last
    yield RAPID, call.clear, ""


def _dwell(count: float | None) -> str:
    """DTB counts seconds, below 0 turns of the spindle."""
    return "" if not count else f"F{count:g}" if count > 0.0 else f"S{-count:g}"


def _numbers(arguments: str, most: int) -> list[float | None]:
    """The arguments, None where one is left out; most: how many there may be."""
    found: list[float | None] = []
    for text in arguments[1:-1].split(","):
        match = _ARGUMENT.fullmatch(text)
        if match is None or (match[1] and abs(float(match[1])) > LARGEST):
            raise CallError(f"the argument {text.strip()[:20]!r} is no number that is followed")
        found.append(float(match[1]) if match[1] else None)
    if len(found) > most:
        raise CallError("more arguments than are followed")
    return found
