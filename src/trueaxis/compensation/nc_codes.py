"""What the G and M codes of milling controls do to positions and modes, and when M codes act."""

from collections.abc import Collection
from enum import IntEnum
from typing import NamedTuple

MOTION = {0: "rapid", 10: "line", 20: "clockwise arc", 30: "counter-clockwise arc"}
PLANES = {170: ("X", "Y", "Z"), 180: ("Z", "X", "Y"), 190: ("Y", "Z", "X")}

EXACT_STOP = 90  # G9, once: belongs to the end of its block
DWELL = 40
CANCEL_CYCLE = 800
SURFACE_SPEED = 960  # G96
MACHINE_COORDINATES = 530  # G53, for its block
WITH_D = frozenset({SURFACE_SPEED, 410, 411, 420, 421})  # the largest speed; which radius, which is a fault by itself

# no influence on where the axes go: cancels of what is a fault to start, path and feed modes
HARMLESS = frozenset(
    {90, 131, 400, 401, 490, 500, 501, 530, 610, 611, 640, 670, 690, 911, 921, 922, 970, 980, 990}
)  # fmt: skip
# work offsets; 541 takes its number from P
SYSTEMS = {540: "G54", 541: "G54.1", 550: "G55", 560: "G56", 570: "G57", 580: "G58", 590: "G59", 591: "G59.1",
           592: "G59.2", 593: "G59.3"}  # fmt: skip
WRITE_DATA, LOCAL_SHIFT, SET_POSITION, RESTORE_SHIFT = 100, 520, 920, 923  # G10, G52, G92, G92.3
END_SHIFT, SUSPEND_SHIFT = 921, 922  # G92.1, G92.2
TAKE_LENGTH, GIVE_LENGTH, END_LENGTH = 430, 431, 490  # G43, G43.1, G49
# codes whose axis words are data, not where to go
TO_REFERENCE, TO_SECOND_REFERENCE = 280, 300  # G28, G30
SHIFT_TO, SHIFT_BY = -1, -2  # TRANS and ATRANS of SINUMERIK
MACHINE_FRAME = "G500"  # no work offset (SINUMERIK)
FURTHER_SYSTEMS = 5000  # G505 to G599 are further work offsets there
WITH_DATA = frozenset({WRITE_DATA, LOCAL_SHIFT, SET_POSITION, GIVE_LENGTH, TO_REFERENCE, TO_SECOND_REFERENCE})
CYCLES = frozenset({730, 810, 820, 830, 850, 860, 890})  # drilling and boring, followed
# tapping (G74 left, G84 right, G84.2 G84.3 rigid) and fine boring: motions that depend on the spindle and on parameters
KEPT_CYCLES_ON = {"fanuc": frozenset({740, 760, 840, 842, 843})}
RIGID_TAPPING = 29
# what one control means by a code that the others use otherwise
OTHERWISE_ON: dict[str, dict[int, str]] = {
    "siemens": {
        580: "shifts single axes (SINUMERIK)", 590: "shifts single axes (SINUMERIK)",
        430: "is not SINUMERIK's", 431: "is not SINUMERIK's", 100: "is a polar motion (SINUMERIK)",
        **dict.fromkeys((280, 300, *CYCLES), "is not SINUMERIK's"),
        520: "is not SINUMERIK's", 920: "limits the spindle (SINUMERIK)",
        740: "moves to the reference point (SINUMERIK)", 750: "moves to a fixed point (SINUMERIK)",
    },
    "heidenhain": {
        **dict.fromkeys(SYSTEMS, "shifts the datum by its axis words (Heidenhain)"),
        280: "mirrors (Heidenhain)", 300: "defines the blank (Heidenhain)", 930: "is not Heidenhain's",
        **dict.fromkeys(CYCLES, "is a cycle of other words (Heidenhain)"),
        430: "lengthens the path by the radius (Heidenhain)", 431: "is not Heidenhain's",
        100: "is a polar motion (Heidenhain)", 520: "is not Heidenhain's", 920: "is not Heidenhain's",
    },
}  # fmt: skip

# cancels whose axis words only name axes; they must be 0 where they could be a shift
CANCELS_WITH_AXES = frozenset({501, 921})
# cancels beside which axis words are a motion on one control and parameters or another code on the next
CANCELS_ALONE = frozenset({131, 150, 500, 690, 922})
# what only one control's users can mean by it
# path modes and corners (G60 G601-G603 G641-G645 G450 G451) of SINUMERIK
HARMLESS_ON = {
    "fanuc": frozenset({150}),
    "linuxcnc": frozenset({SURFACE_SPEED}),
    "siemens": frozenset({600, 6010, 6020, 6030, 6410, 6420, 6430, 6440, 6450, 4500, 4510, 1530}),
}
INCH_ON = {"siemens": {700: True, 710: False, 7000: True, 7100: False}, "heidenhain": {700: True, 710: False}}
SAME_ON = {"siemens": {1530: MACHINE_COORDINATES}}  # G153

# tool centre point control, with the length of H
POINT_CONTROL_ON = {"fanuc": frozenset({434})}

# looking ahead on Fanuc: G5 P10000 and P0, G5.1 Q0 to Q3, G8 P0 and P1: the letter, and the values that are no more
LOOK_AHEAD_ON: dict[str, dict[int, tuple[str, frozenset[float]]]] = {
    "fanuc": {50: ("P", frozenset({0.0, 10000.0})), 51: ("Q", frozenset({0.0, 1.0, 2.0, 3.0})),
              80: ("P", frozenset({0.0, 1.0}))},
}  # fmt: skip
ROUNDS = "the control may round the path within a tolerance of its own here"

EXACT_PATH, EXACT_STOPS, CONTINUOUS = 610, 611, 640  # G61, G61.1, G64: may take a tolerance or a number of blocks
PATH_MODES = (EXACT_PATH, EXACT_STOPS, CONTINUOUS)

# codes (whole ones) that change nothing where the mode that they set is in force: those of modes that this is asked of
WITHOUT_MODE = frozenset({40, 61, 64})
_SETTING_MODES = frozenset({17, 18, 19, 20, 21, 54, 55, 56, 57, 58, 59, 90, 91, 94, 95}) | WITHOUT_MODE


def modes_on(dialect: str | None) -> frozenset[int]:
    """The codes of modes that may stand again where they are in force."""
    otherwise = set(OTHERWISE_ON.get(dialect or "", {}))
    if dialect == "linuxcnc":  # it matters to its cycles which is in force
        otherwise.update(PATH_MODES)
    return frozenset(code for code in _SETTING_MODES if 10 * code not in otherwise)


class Refused(NamedTuple):
    """Why a code is a fault, as what follows its name, and what would be right."""

    why: str
    remedy: str


_MACHINE = "write the program in machine coordinates without it before compensating"
_MOTIONS = "have its motions written out as G0, G1, G2 and G3"
_OFFSET = Refused("gives the positions in a shifted frame", _MACHINE)
_TOOL = Refused("shifts positions by a tool value that is not in the program", _MACHINE)
_RADIUS = Refused(
    "compensates the cutter's radius, which is not in the program",
    "have the path of the cutter's centre written, or, on LinuxCNC, --via-linuxcnc with --tools",
)
_CYCLE = Refused("is a canned cycle: its motions are not in the program", _MOTIONS)
_PATTERN = Refused("is a hole pattern or a thread: its motions are not in the program", _MOTIONS)
_HOME = Refused("moves by way of a position that is not in the program", "give the position by G0 (or G53 G0)")
_CURVE = Refused("is a curve that is not followed", _MOTIONS)
_PROBE = Refused("probes: where the axes stop is not in the program", "take it out before compensating")
_MACRO = Refused("calls a macro, which is not followed", _MOTIONS)
_POINT_CONTROL = Refused("moves the linear axes with the rotary ones (tool centre point control)", _MACHINE)
_SPINDLE = Refused("couples the feed to the spindle (thread)", "take it out before compensating")
_DATA = Refused("changes parameters (Fanuc, LinuxCNC) or is a polar motion (Heidenhain)", _MACHINE)

FAULTY: dict[int, Refused] = {
    50: Refused("is a curve, or a mode that may round the path (Fanuc)", "take it out, or have lines and arcs written"),
    51: Refused("is a curve, or a mode that may round the path (Fanuc)", "take it out, or have lines and arcs written"),
    52: _CURVE, 53: _CURVE, 60: _CURVE, 61: _CURVE, 62: _CURVE, 22: _CURVE, 23: _CURVE, 32: _CURVE, 33: _CURVE,
    70: Refused("reads diameters (LinuxCNC) or makes an axis imaginary (Fanuc)", _MACHINE),
    71: Refused("interpolates on a cylinder", _MOTIONS),
    80: Refused("reads radii (LinuxCNC) or changes look-ahead (Fanuc)", "take it out before compensating"),
    101: _DATA, 110: _DATA,
    120: Refused("is a circular pocket cycle or a polar motion", _MOTIONS),
    130: Refused("is a circular pocket cycle or a polar motion", _MOTIONS),
    121: Refused("interpolates in polar coordinates", _MOTIONS),
    150: Refused("ends polar coordinates (Fanuc), is a polar circle (Heidenhain) or selects a zero point (Okuma)",
                 "leave it out, or say --dialect fanuc"),
    160: Refused("gives positions in polar coordinates", "have them written as X, Y and Z"),
    220: Refused("limits the stroke (Fanuc), reads radii (Siemens) or starts a cycle", "take it out"),
    230: Refused("ends a limit of the stroke (Fanuc) or reads diameters (Siemens)", "take it out"),
    270: Refused("moves to a reference position (Fanuc), or departs tangentially (Heidenhain)", _MOTIONS),
    281: _HOME, 290: _HOME, 301: _HOME,
    310: Refused("skips the rest of a motion on a signal (Fanuc), or defines the blank (Heidenhain)", "take it out"),
    330: _SPINDLE, 331: _SPINDLE, 340: _PATTERN, 350: _PATTERN, 360: _PATTERN,
    370: Refused("measures the tool (Fanuc) or defines a pocket (Heidenhain)", "take it out before compensating"),
    382: _PROBE, 383: _PROBE, 384: _PROBE, 385: _PROBE,
    410: _RADIUS, 411: _RADIUS, 420: _RADIUS, 421: _RADIUS, 432: _TOOL, 440: _TOOL,
    434: _POINT_CONTROL, 435: _POINT_CONTROL,
    450: _TOOL, 460: _TOOL, 470: _TOOL, 480: _TOOL,
    510: Refused("scales the positions", _MACHINE), 511: Refused("mirrors the positions", _MACHINE),
    521: _OFFSET, 522: _OFFSET, 523: _OFFSET,
    531: Refused("turns rotary axes to a tilted plane: where to is not in the program", _MACHINE),
    542: _OFFSET, 544: _OFFSET,
    600: Refused("positions from one side by an amount that is not in the program (Fanuc), or stops exactly (Siemens)",
                 "take it out, or write G61"),
    650: _MACRO, 660: _MACRO, 661: _MACRO,
    680: Refused("turns the coordinates", _MACHINE),
    682: Refused("tilts the coordinates", _MACHINE), 683: Refused("tilts the coordinates", _MACHINE),
    700: Refused("reads inches (Siemens, Heidenhain) or is a lathe cycle (Fanuc, LinuxCNC)", "write G20 for inches"),
    710: Refused("reads millimetres (Siemens, Heidenhain) or is a lathe cycle (Fanuc, LinuxCNC)",
                 "leave it out where it says millimetres, or write G21"),
    720: Refused("is a canned cycle (Fanuc) or scales (Heidenhain)", _MOTIONS),
    **{10 * code: _CYCLE for code in (74, 75, 76, 77, 78, 79, 84, 87, 88)},
    841: _CYCLE, 842: _CYCLE, 843: _CYCLE, 882: _CYCLE,
    901: Refused("makes I J K absolute, which is not handled", "have them written from the start of the arc"),
    SURFACE_SPEED: Refused("couples the spindle to an axis position, and may count F by revolutions (Siemens)",
                 "write G97 with a speed"),
    1070: Refused("interpolates on a cylinder", _MOTIONS),
    1121: Refused("interpolates in polar coordinates", _MOTIONS),
}  # fmt: skip

NOT_KNOWN = "only codes whose effect on positions is known are accepted"
MACHINE_REMEDY = _MACHINE


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
SPINDLE, SPINDLE_STOP = frozenset({3, 4, 5}), 5
PALLETS, TOOL_NUMBER = 60, 61  # of LinuxCNC
END = frozenset(code for code, known in KNOWN.items() if known.ends)
STOPS = frozenset(code for code, known in KNOWN.items() if not known.axes_kept and code != TOOL_CHANGE) | {PALLETS}
# no more than on or off of what is no axis, everywhere
SWITCHES = frozenset(code for code, known in KNOWN.items() if known.axes_kept and not known.ends)
AFTER = frozenset(code for code, known in KNOWN.items() if known.timing == Timing.AFTER)
OF_CERTAIN_TIMING = frozenset(code for code, known in KNOWN.items() if known.timing != Timing.EITHER)

_SUBPROGRAM = "calls, ends or repeats a subprogram, which is not followed"
IN_PLACE = "write the blocks of the subprogram in place of each call, which gets its own words"
_UNROLLED = "--via-linuxcnc expands it, for a LinuxCNC control; for others " + IN_PLACE
_FRAME = "gives the positions of its block in another frame (Heidenhain)"
_COUPLES = "moves the linear axes with the rotary ones"
_MODES = "saves or restores modes, so that later blocks read differently"

# never passed, whoever vouches for them
HARMFUL: dict[int, str] = {
    91: _FRAME, 92: _FRAME,
    96: _SUBPROGRAM, 97: _SUBPROGRAM, 98: _SUBPROGRAM, 99: _SUBPROGRAM, 198: _SUBPROGRAM,
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
    "siemens": {17: _SUBPROGRAM},
    "heidenhain": {
        89: "calls a cycle at every position",
        94: "changes what positions of rotary axes mean",
        99: "calls the cycle that is defined before",
        118: "lets the handwheel shift positions",
        136: "makes F count by turns of the spindle",
        140: "retracts along the tool axis; where it stops is not in the program",
        150: "lets axes leave the travel",
    },
}

NOT_PASSED = "--pass-m does not pass it; write the program without it before compensating"


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
    if harm:
        remedy = _UNROLLED if dialect in (None, "linuxcnc") else IN_PLACE
        return f"M{code} {harm}", f"--pass-m does not pass it; {remedy}" if harm is _SUBPROGRAM else NOT_PASSED
    if code in passed:
        return None
    known = "; ".join(f"{control}: {harmful[code]}" for control, harmful in HARMFUL_ON.items() if code in harmful)
    return (
        f"M{code} does not mean the same on every control{f' ({known})' if known else ''}",
        f"say --pass-m {code} if it moves no axis and changes no mode on this one",
    )
