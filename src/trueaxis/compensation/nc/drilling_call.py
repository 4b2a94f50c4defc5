"""CYCLE81 and CYCLE82 of SINUMERIK: what their arguments ask for."""

import re

from trueaxis.compensation.nc.canned_cycle import DrillingCall
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER

DRILLING = {"CYCLE81": 810, "CYCLE82": 820}  # with the canned cycles (times ten) that make the same motions in a hole
MODAL = "MCALL"
END_OF_CALLS = DrillingCall(code=0)
_ARGUMENT = re.compile(rf"[ \t]*+({NUMBER})?[ \t]*+")
_MOST = 9  # RTP RFP SDIS DP DPR DTB _GMODE _DMODE _AMODE
# _GMODE, _DMODE and _AMODE that change neither depth nor plane; posts leave DTB out before them in CYCLE81, so that
# each may stand one place further to the left
_MODES = ((0.0,), (0.0, 1.0, 10.0, 12.0), (0.0, 2.0, 10.0, 12.0))
PLAIN_ARGUMENTS = "RTP, RFP, SDIS, DP or DPR, DTB as numbers, 0 for further ones"


class CallError(Exception):
    """What is wrong with the arguments of a cycle."""


def drilling_call(name: str, arguments: str | None, modal: bool) -> DrillingCall:
    """The cycle that a call asks for. Raises CallError."""
    given = _numbers(arguments or "()")
    retract, reference, clearance, depth, relative, dwell, *modes = given + [None] * (_MOST - len(given))
    if any(mode not in (None, *right) for mode, right in zip(modes, _MODES, strict=True)):
        raise CallError(f"{name} with a mode (_GMODE, _DMODE, _AMODE) that is not followed")
    if retract is None or reference is None or (depth is None) == (relative is None):
        raise CallError(f"{name} without RTP, RFP and one of DP and DPR")
    top = reference + abs(clearance or 0.0)
    bottom = depth if depth is not None else reference - abs(relative or 0.0)
    if not bottom < top <= retract:
        raise CallError(f"{name}: the depth is not below RFP + SDIS, or RTP not above it")
    return DrillingCall(
        code=DRILLING[name], top=top, bottom=bottom, clear=retract, dwell=_dwell(dwell or 0.0), modal=modal
    )


def _dwell(count: float) -> str:
    """DTB counts seconds, below 0 turns of the spindle."""
    return f"F{count:g}" if count > 0.0 else f"S{-count:g}" if count else ""


def _numbers(arguments: str) -> list[float | None]:
    """The arguments, None where one is left out."""
    found: list[float | None] = []
    for text in arguments[1:-1].split(","):
        match = _ARGUMENT.fullmatch(text)
        if match is None or (match[1] and abs(float(match[1])) > LARGEST):
            raise CallError(f"the argument {text.strip()[:20]!r} is no number that is followed")
        found.append(float(match[1]) if match[1] else None)
    if len(found) > _MOST:
        raise CallError("more arguments than are followed")
    return found
