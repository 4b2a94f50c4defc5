"""What the M codes of milling controls do to positions and modes, and when they act."""

from collections.abc import Collection
from enum import IntEnum
from typing import NamedTuple


class Timing(IntEnum):
    """When a code acts in a block that moves."""

    BEFORE = 0
    AFTER = 1
    EITHER = 2  # controls do not agree


class MCode(NamedTuple):
    """A code with the same meaning everywhere. ends: it ends the program. axes_kept: whether every axis is certain to
    stand where it stood before: an operator may move one during a stop, and a tool change often does.
    """

    meaning: str
    timing: Timing
    ends: bool = False
    axes_kept: bool = True


KNOWN: dict[int, MCode] = {
    0: MCode("program stop", Timing.AFTER, axes_kept=False),
    1: MCode("optional stop", Timing.AFTER, axes_kept=False),
    2: MCode("end of program", Timing.AFTER, ends=True),
    3: MCode("spindle on, clockwise", Timing.BEFORE),
    4: MCode("spindle on, counter-clockwise", Timing.BEFORE),
    5: MCode("spindle stop", Timing.AFTER),
    6: MCode("tool change", Timing.EITHER, axes_kept=False),
    7: MCode("coolant 2 on", Timing.BEFORE),
    8: MCode("coolant 1 on", Timing.BEFORE),
    9: MCode("coolant off", Timing.AFTER),
    30: MCode("end of program, rewind", Timing.AFTER, ends=True),
}
TOOL_CHANGE = 6
RIGID_TAPPING = 29
SPINDLE, SPINDLE_STOP = frozenset({3, 4, 5}), 5
PALLETS, TOOL_NUMBER = 60, 61  # of LinuxCNC
END = frozenset(code for code, known in KNOWN.items() if known.ends)
STOPS = frozenset(code for code, known in KNOWN.items() if not known.axes_kept and code != TOOL_CHANGE) | {PALLETS}
# no more than on or off of what is no axis, everywhere
SWITCHES = frozenset(code for code, known in KNOWN.items() if known.axes_kept and not known.ends)
AFTER = frozenset(code for code, known in KNOWN.items() if known.timing == Timing.AFTER)
OF_CERTAIN_TIMING = frozenset(code for code, known in KNOWN.items() if known.timing != Timing.EITHER)

_RETURNS = "ends a subprogram, or begins the program anew, which is not followed"
_SUBPROGRAM = "calls, ends or repeats a subprogram, which is not followed"
IN_PLACE = "write the blocks of the subprogram in place of each call, which gets its own words"
_UNROLLED = "--via-linuxcnc (LinuxCNC installed here) expands it, for a LinuxCNC control; for others " + IN_PLACE
_FRAME = "gives the positions of its block in another frame (Heidenhain)"
_COUPLES = "moves the linear axes with the rotary ones"
_CALLS_CYCLE, _EACH_POSITION = "calls the cycle that is defined before", "calls a cycle at every position"
_MODES = "saves or restores modes, so that later blocks read differently"

# never passed, whoever vouches for them
HARMFUL: dict[int, str] = {
    91: _FRAME, 92: _FRAME,
    96: _SUBPROGRAM, 97: _SUBPROGRAM, 98: _SUBPROGRAM, 99: _RETURNS, 198: _SUBPROGRAM,
    114: _COUPLES, 128: _COUPLES, 428: _COUPLES,
    126: "changes the way on which rotary axes turn (Heidenhain)",
    130: "gives positions in an untilted frame (Heidenhain)",
    144: "changes positions by kinematics that are not in the program (Heidenhain)",
}  # fmt: skip
# known on one control: no axis moves; what it does and when
KNOWN_ON: dict[str, dict[int, MCode]] = {
    "fanuc": {RIGID_TAPPING: MCode("rigid tapping from the next G74 or G84 on", Timing.BEFORE)},
    "heidenhain": {
        13: MCode("spindle on, clockwise, and coolant", Timing.BEFORE),
        14: MCode("spindle on, counter-clockwise, and coolant", Timing.BEFORE),
        107: MCode("tools of a length that differs are no fault", Timing.BEFORE),
        108: MCode("end of M107", Timing.BEFORE),
        109: MCode("F at the contour of inside and outside arcs", Timing.BEFORE),
        110: MCode("F at the contour of inside arcs", Timing.BEFORE),
        111: MCode("end of M109 and M110", Timing.BEFORE),
        126: MCode("rotary axes turn on the shorter way", Timing.BEFORE),
        127: MCode("rotary axes turn on the way that their positions give", Timing.BEFORE),
        137: MCode("end of M136", Timing.BEFORE),
    },
    "linuxcnc": {
        PALLETS: MCode("change of pallets, and stop", Timing.AFTER, axes_kept=False),
        TOOL_NUMBER: MCode("number of the tool in the spindle", Timing.BEFORE),
    },
}
# tool centre point control on and off; LinuxCNC: as its sample machines with switchable kinematics have it
POINT_CONTROL: dict[str, dict[int, bool]] = {
    "heidenhain": {128: True, 129: False},
    "linuxcnc": {428: True, 429: False},
}
# harmful on one control and the builder's on the others: passed unless --dialect names that control
HARMFUL_ON: dict[str, dict[int, str]] = {
    "linuxcnc": dict.fromkeys((70, 71, 72, 73), _MODES) | {430: "selects kinematics that are not in the program"},
    "siemens": {17: _RETURNS},
    "heidenhain": {
        89: _EACH_POSITION,
        94: "changes what positions of rotary axes mean",
        99: _CALLS_CYCLE,
        118: "lets the handwheel shift positions",
        136: "makes F count by turns of the spindle",
        140: "retracts along the tool axis; where it stops is not in the program",
        150: "lets axes leave the travel",
    },
}

NOT_PASSED = "--pass-m does not pass it"


def spindle_of(code: int) -> str:
    """The code with which the spindle turns on after one of `SPINDLE`; empty: it stands."""
    return "" if code == SPINDLE_STOP else f"M{code}"


def may_move(code: int, passed: Collection[int]) -> bool:
    """Whether axes may stand elsewhere after a stop or a tool change: unless `passed` vouches that they do not."""
    return (code == PALLETS or (code in KNOWN and not KNOWN[code].axes_kept)) and code not in passed


def vouched_for(code: int, passed: Collection[int]) -> bool:
    """Whether a code passes, or moves no axis, only because the user says so."""
    return code in passed and (code not in KNOWN or not KNOWN[code].axes_kept)


def problem_of(code: int, passed: Collection[int], dialect: str | None) -> tuple[str, str] | None:
    """What is wrong with a code, and what would be right; None if it is known or `passed` names it."""
    if code in KNOWN or code in KNOWN_ON.get(dialect or "", {}):
        return None
    harm = HARMFUL_ON.get(dialect or "", {}).get(code) or HARMFUL.get(code)
    harmless = {control: codes[code].meaning for control, codes in KNOWN_ON.items() if code in codes and not dialect}
    named = "".join(f"--dialect {control} if it is one; else " for control in harmless)
    if harm:
        return f"M{code} {harm}", f"say {named}{_remedy(harm, dialect)}" if named else _remedy(harm, dialect)
    if code in passed:
        return None
    known = [f"{control}: {harmful[code]}" for control, harmful in HARMFUL_ON.items() if code in harmful]
    known += [f"{control}: {meaning}" for control, meaning in harmless.items()]
    said = f" ({'; '.join(known)})" if known else ""
    return (
        f"M{code} does not mean the same on every control{said}",
        f"say {named}--pass-m {code} if it moves no axis and changes no mode on this one",
    )


def _remedy(harm: str, dialect: str | None) -> str:
    if harm not in (_SUBPROGRAM, _RETURNS):
        return f"{NOT_PASSED}; write the program without it before compensating"
    end = "M30 or M2 where the program ends; else " if harm == _RETURNS else ""
    return f"{NOT_PASSED}; {end}{_UNROLLED if dialect in (None, 'linuxcnc') else IN_PLACE}"
