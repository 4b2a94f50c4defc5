"""What the G and M codes of a milling control do to positions.

Keys are ten times the number, so that G54.1 is 541. A code in none of the tables is a fault: a code that is not known
may move anything.
"""

MOTION = {0: "rapid", 10: "line", 20: "clockwise arc", 30: "counter-clockwise arc"}
PLANES = {170: ("X", "Y", "Z"), 180: ("Z", "X", "Y"), 190: ("Y", "Z", "X")}

EXACT_STOP = 90  # G9, once: belongs to the end of its block
DWELL = 40
CANCEL_CYCLE = 800

# no influence on where the axes go: cancels of what is a fault to start, path and feed modes, stored stroke checks off
HARMLESS = frozenset({90, 131, 150, 230, 400, 401, 490, 500, 501, 610, 611, 640, 670, 690, 911, 970, 980, 990})
# cancels whose axis words, if any, are parameters and not positions
CANCELS_WITH_AXES = frozenset({500, 501, 690, 150, 131})

_OFFSET = "gives the positions in a shifted frame"
_TOOL = "shifts positions by a tool value that is not in the program"
_CYCLE = "is a canned cycle: its motions are not in the program"
_HOME = "moves by way of a position that is not in the program"
_CURVE = "is a curve that is not followed"

# exact path modes that take a tolerance or a number of blocks
WITH_PARAMETERS = frozenset({610, 611, 640})

FAULTY: dict[int, str] = {
    50: _CURVE, 51: _CURVE, 52: _CURVE, 53: _CURVE, 61: _CURVE, 62: _CURVE,
    22: _CURVE, 23: _CURVE, 32: _CURVE, 33: _CURVE,
    70: "switches to diameters or imaginary axes", 71: "interpolates on a cylinder",
    80: "switches lathe diameters or look-ahead by a table that is not in the program",
    100: "changes offsets or parameters", 110: "changes offsets or parameters", 101: "changes offsets or parameters",
    120: "is a circular pocket cycle", 121: "interpolates in polar coordinates", 130: "is a circular pocket cycle",
    160: "gives positions in polar coordinates",
    220: "limits the stroke or starts a cycle",
    270: _HOME, 280: _HOME, 290: _HOME, 300: _HOME, 301: _HOME, 310: "skips the rest of a motion on a signal",
    330: "couples the feed to the spindle (thread)",
    340: _CYCLE, 350: _CYCLE, 360: _CYCLE, 370: "measures the tool",
    382: _TOOL, 383: _TOOL, 384: _TOOL, 385: _TOOL,
    410: _TOOL, 411: _TOOL, 420: _TOOL, 421: _TOOL, 430: _TOOL, 431: _TOOL, 434: _TOOL, 435: _TOOL, 440: _TOOL,
    450: _TOOL, 460: _TOOL, 470: _TOOL, 480: _TOOL,
    510: "scales the positions", 511: "mirrors the positions",
    520: _OFFSET, 521: _OFFSET, 522: _OFFSET, 523: _OFFSET, 530: _OFFSET, 531: _OFFSET,
    540: _OFFSET, 541: _OFFSET, 542: _OFFSET, 544: _OFFSET, 550: _OFFSET, 560: _OFFSET, 570: _OFFSET, 580: _OFFSET,
    590: _OFFSET, 591: _OFFSET, 592: _OFFSET, 593: _OFFSET,
    600: "positions from one side by an amount that is not in the program",
    650: "calls a macro", 660: "calls a macro", 661: "calls a macro",
    680: "turns the coordinates", 682: "tilts the coordinates", 683: "tilts the coordinates",
    **{10 * code: _CYCLE for code in (70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 81, 82, 83, 84, 85, 86, 87, 88, 89)},
    841: _CYCLE, 842: _CYCLE, 843: _CYCLE, 882: _CYCLE,
    901: "makes I J K absolute, which is not handled",
    920: _OFFSET, 921: _OFFSET, 922: _OFFSET, 923: _OFFSET,
    930: "makes F an inverse time, which changes when a block is cut",
    960: "couples the spindle to an axis position",
    1070: "interpolates on a cylinder", 1121: "interpolates in polar coordinates",
}  # fmt: skip

FAULTY_M: dict[int, str] = {
    91: "gives the positions of its block in a shifted frame",
    92: "gives the positions of its block in a shifted frame",
    96: "calls or repeats parts of programs",
    97: "calls or repeats parts of programs",
    98: "calls a subprogram",
    99: "returns or repeats from the start",
    114: "moves the linear axes with the rotary ones",
    126: "changes the way on which rotary axes turn",
    128: "moves the linear axes with the rotary ones",
    130: "gives positions in an untilted frame",
    144: "changes positions by kinematics that are not in the program",
    198: "calls a subprogram",
}
M_END_OF_PROGRAM = frozenset({2, 30})
M_TOOL_CHANGE = 6
# due before the motion of their block (spindle and coolant on, tool change) and after it (stops, off)
M_BEFORE = frozenset({3, 4, 6, 7, 8, 13, 14, 48, 49, 50, 51})
M_AFTER = frozenset({0, 1, 2, 5, 9, 30, 60})

OFFSET_REMEDY = "write the program in machine coordinates without it before compensating"
