"""What the G codes of milling controls do to positions and modes."""

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
# what one control means by a code that the others use otherwise
OTHERWISE_ON: dict[str, dict[int, str]] = {
    "siemens": {
        580: "shifts single axes (SINUMERIK)", 590: "shifts single axes (SINUMERIK)",
        430: "is not SINUMERIK's", 431: "is not SINUMERIK's", 100: "is a polar motion (SINUMERIK)",
        **dict.fromkeys((280, 300, *CYCLES), "is not SINUMERIK's"),
        520: "is not SINUMERIK's", 920: "limits the spindle (SINUMERIK)",
        **dict.fromkeys((1100, 1110, 1120), "sets the pole of polar positions (SINUMERIK)"),
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
OF_CYCLES = frozenset({80, 98, 99, *(code // 10 for code in CYCLES)})  # codes beside or behind the holes of a cycle
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


WITHOUT_IT = "have the positions written without it"
_MOTIONS = "have its motions written out as G0, G1, G2 and G3"
_OFFSET = Refused("gives the positions in a shifted frame", WITHOUT_IT)
_TOOL = Refused("shifts positions by a tool value that is not in the program", WITHOUT_IT)
_RADIUS = Refused(
    "compensates the cutter's radius, which is not in the program",
    "have the path of the cutter's centre written, or, on LinuxCNC, --via-linuxcnc with --tools "
    "(LinuxCNC installed here)",
)
_CYCLE = Refused("is a canned cycle: its motions are not in the program", _MOTIONS)
TAP_APART = "tap in a program of its own, which is run as it is: G0 and G1 would not turn with the spindle"
_TAPPING = Refused("is a canned cycle for tapping: its motions go with the spindle", TAP_APART)
_PATTERN = Refused("is a hole pattern or a thread: its motions are not in the program", _MOTIONS)
_HOME = Refused("moves by way of a position that is not in the program", "give the position by G0 (or G53 G0)")
_STORED = Refused("stores where the axes stand as a reference point", "take it out, and state the point in the spec")
_HAAS = Refused(
    "selects a further work offset (Haas) or sets the pole of polar positions (SINUMERIK)",
    "write G54 to G59 or G54.1 P, and say --offset",
)
_CURVE = Refused("is a curve that is not followed", _MOTIONS)
_PROBE = Refused("probes: where the axes stop is not in the program", "take it out before compensating")
_MACRO = Refused("calls a macro, which is not followed", _MOTIONS)
_POINT_CONTROL = Refused("moves the linear axes with the rotary ones (tool centre point control)", WITHOUT_IT)
_SPINDLE = Refused("couples the feed to the spindle (thread)", "take it out before compensating")
_DATA = Refused("changes parameters (Fanuc, LinuxCNC) or is a polar motion (Heidenhain)", WITHOUT_IT)

FAULTY: dict[int, Refused] = {
    50: Refused("is a curve, or a mode that may round the path (Fanuc)", "take it out, or have lines and arcs written"),
    51: Refused("is a curve, or a mode that may round the path (Fanuc)", "take it out, or have lines and arcs written"),
    52: _CURVE, 53: _CURVE, 60: _CURVE, 61: _CURVE, 62: _CURVE, 22: _CURVE, 23: _CURVE, 32: _CURVE, 33: _CURVE,
    70: Refused("reads diameters (LinuxCNC) or makes an axis imaginary (Fanuc)", WITHOUT_IT),
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
    281: _STORED, 290: _HOME, 301: _STORED,
    310: Refused("skips the rest of a motion on a signal (Fanuc), or defines the blank (Heidenhain)", "take it out"),
    330: _SPINDLE, 331: _SPINDLE, 340: _PATTERN, 350: _PATTERN, 360: _PATTERN,
    370: Refused("measures the tool (Fanuc) or defines a pocket (Heidenhain)", "take it out before compensating"),
    382: _PROBE, 383: _PROBE, 384: _PROBE, 385: _PROBE,
    410: _RADIUS, 411: _RADIUS, 420: _RADIUS, 421: _RADIUS, 432: _TOOL, 440: _TOOL,
    434: _POINT_CONTROL, 435: _POINT_CONTROL,
    450: _TOOL, 460: _TOOL, 470: _TOOL, 480: _TOOL,
    510: Refused("scales the positions", WITHOUT_IT), 511: Refused("mirrors the positions", WITHOUT_IT),
    521: _OFFSET, 522: _OFFSET, 523: _OFFSET,
    531: Refused("turns rotary axes to a tilted plane: where to is not in the program", WITHOUT_IT),
    542: _OFFSET, 544: _OFFSET,
    600: Refused("positions from one side by an amount that is not in the program (Fanuc), or stops exactly (Siemens)",
                 "take it out, or write G61"),
    650: _MACRO, 660: _MACRO, 661: _MACRO,
    680: Refused("turns the coordinates", WITHOUT_IT),
    682: Refused("tilts the coordinates", WITHOUT_IT), 683: Refused("tilts the coordinates", WITHOUT_IT),
    700: Refused("reads inches (Siemens, Heidenhain) or is a lathe cycle (Fanuc, LinuxCNC)", "write G20 for inches"),
    710: Refused("reads millimetres (Siemens, Heidenhain) or is a lathe cycle (Fanuc, LinuxCNC)",
                 "leave it out where it says millimetres, or write G21"),
    720: Refused("is a canned cycle (Fanuc) or scales (Heidenhain)", _MOTIONS),
    **{10 * code: _CYCLE for code in (75, 76, 77, 78, 79, 87, 88)},
    740: _TAPPING, 840: _TAPPING, 841: _CYCLE, 842: _TAPPING, 843: _TAPPING, 882: _CYCLE,
    901: Refused("makes I J K absolute, which is not handled", "have them written from the start of the arc"),
    SURFACE_SPEED: Refused("couples the spindle to an axis position, and may count F by revolutions (Siemens)",
                 "write G97 with a speed"),
    1070: Refused("interpolates on a cylinder", _MOTIONS),
    1121: Refused("interpolates in polar coordinates", _MOTIONS),
    **{10 * code: _HAAS for code in (*range(110, 130), 154)},
    1010: Refused("mirrors the positions (Haas)", WITHOUT_IT),
    1500: Refused("is a pocket cycle (Haas)", _MOTIONS),
    2340: Refused("switches tool centre point control on (Haas)", "write G43.4 H"),
    2540: Refused("turns positions with the rotary axes (Haas)", WITHOUT_IT),
}  # fmt: skip

# codes that are faults on most controls and followed on one
_FOLLOWED_ON = {
    on: KEPT_CYCLES_ON.get(on, frozenset()) | POINT_CONTROL_ON.get(on, frozenset()) | LOOK_AHEAD_ON.get(on, {}).keys()
    for on in KEPT_CYCLES_ON.keys() | POINT_CONTROL_ON.keys() | LOOK_AHEAD_ON.keys()
}

NOT_KNOWN = "only codes whose effect on positions is known are accepted"
PASS_G = "say --pass-g {} if it moves no axis and changes no mode on this control"


def refused(code: int, dialect: str | None) -> Refused:
    """Of a code of `FAULTY`. Where a control is known on which it is followed, and none is stated, it is named."""
    found = FAULTY[code]
    followed = [on for on, kept in _FOLLOWED_ON.items() if code in kept and not dialect]
    return (
        found._replace(remedy=f"say --dialect {followed[0]} if it is one; else {found.remedy}") if followed else found
    )


def numbers_for(dialect: str | None) -> str:
    """What to do about a macro, a variable or an expression."""
    here = "write the numbers, and the blocks that are run, themselves"
    return (
        f"--via-linuxcnc (LinuxCNC installed here) unrolls it, for a LinuxCNC control; else {here}"
        if dialect in (None, "linuxcnc")
        else here
    )
