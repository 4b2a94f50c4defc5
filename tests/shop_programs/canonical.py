# mypy: ignore-errors
"""Runs in LinuxCNC's own Python: prints what its interpreter makes of one program.

canonical.py PROGRAM VAR PACKAGES TOOLS [START]: one line a motion, `rapid|feed LINE X Y Z A B C` or
`arc LINE PLANE TURNS CX CY X Y Z A B C` (mm, deg, machine coordinates of the point from which lengths count; CX, CY the
centre in the first two axes of the plane), `tool LINE T`, `length LINE Z`, and at the end `end RESULT LINE TEXT`.
START is a block that puts the axes where they are to stand at first; it is the first motion.
"""

import ctypes
import json
import os
import re
import sys
from pathlib import Path

PROGRAM, VAR, PACKAGES = sys.argv[1:4]
START = sys.argv[5] if len(sys.argv) > 5 else ""
TOOLS = json.loads(sys.argv[4])  # number, length and diameter (mm) in the order of the table, the spindle first
# M61, which the module passes over
SAID = [re.search(r"(?i)^[^(;]*m\s*0*61\s*q\s*(\d+)", text) for text in Path(PROGRAM).read_text("latin-1").split("\n")]
sys.path.insert(0, PACKAGES)
sys.setdlopenflags(os.RTLD_LAZY | os.RTLD_GLOBAL)  # what is loaded before it calls it
import gcode  # noqa: E402

# the table of tools is memory shared by way of a file in HOME, which rs274 has made; without it the module crashes
ctypes.CDLL("libtooldata.so.0", ctypes.RTLD_GLOBAL)._Z14tool_mmap_userv()

MM = 25.4
TELL = ctypes.PyDLL(gcode.__file__)._Z17STRAIGHT_TRAVERSEiddddddddd
TELL.argtypes = [ctypes.c_int] + [ctypes.c_double] * 9
ORDER = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}


class Canon:
    """What the interpreter calls; positions come in inches, in the frame of the program."""

    def __init__(self):
        self.parameter_file, self.line, self.plane = VAR, 0, 1
        self.g5x = self.g92 = self.tool = (0.0,) * 9
        self.at = [0.0] * 9  # machine coordinates in inches
        self.told = None  # what the module has been told of where the axes stand
        self.changing, self.spindle = False, TOOLS[0]  # changing: in the block of a tool change

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: None

    def next_line(self, state):
        self.changing = False
        self.line = state.sequence_number
        if 0 < self.line <= len(SAID) and (said := SAID[self.line - 1]):
            numbers = [tool for tool, *_ in TOOLS[1:]]
            self.change_tool(1 + numbers.index(int(said[1])) if int(said[1]) else 0)

    def set_g5x_offset(self, _index, *values):
        self.g5x = values
        self.stand()

    def set_g92_offset(self, *values):
        self.g92 = values
        self.stand()

    def stand(self):
        """After a tool change the interpreter asks the module where the axes are, which forgets arcs and offsets."""
        if not self.changing:
            return
        words = [at - sum(of) for at, *of in zip(self.at, self.g5x, self.g92, self.tool, strict=True)]
        self.told = ()
        TELL(self.line, 1.0, *(0.0,) * 8)
        unit = 1.0 / self.told[0]  # 25.4 in mm
        TELL(self.line, *[value if row in (3, 4, 5) else value * unit for row, value in enumerate(words)])
        self.told = None

    def set_xy_rotation(self, angle):
        if angle:
            print("turned", self.line)

    def set_plane(self, plane):
        self.plane = plane

    def tool_offset(self, *values):
        self.tool = values
        self.stand()
        print("length", self.line, f"{values[2] * MM:.9f}")

    def change_tool(self, pocket):
        self.spindle = TOOLS[pocket] if pocket else (0, 0.0, 0.0)
        print("tool", self.line, self.spindle[0])
        self.changing = True
        self.stand()

    def user_defined_function(self, number, *_):
        print("user", self.line, 100 + number)

    def machine(self, values):
        """Machine coordinates, mm and deg."""
        total = [sum(parts) for parts in zip(values, self.g5x, self.g92, self.tool, strict=True)]
        if any(total[6:]):
            print("uvw", self.line)
        return [f"{value * (MM if row < 3 else 1.0):.9f}" for row, value in enumerate(total[:6])]

    def moved(self, kind, values):
        self.at = [sum(parts) for parts in zip(values, self.g5x, self.g92, self.tool, strict=True)]
        print(kind, self.line, *self.machine(values))

    def straight_traverse(self, *values):
        if self.told is not None:
            self.told = values
        else:
            self.moved("rapid", values)

    def straight_feed(self, *values):
        self.moved("feed", values)

    def straight_probe(self, *_):
        print("probe", self.line)

    def rigid_tap(self, *_):
        print("tap", self.line)

    def arc_feed(self, first, second, c1, c2, turns, along, *rest):
        rows = ORDER[self.plane]
        end, centre = [0.0] * 3, [0.0] * 9
        end[rows[0]], end[rows[1]], end[rows[2]] = first, second, along
        centre[rows[0]], centre[rows[1]] = c1, c2
        middle, there = self.machine(centre), self.machine([*end, *rest])
        print("arc", self.line, self.plane, turns, middle[rows[0]], middle[rows[1]], *there)
        self.at = [sum(parts) for parts in zip([*end, *rest], self.g5x, self.g92, self.tool, strict=True)]
        self.stand()

    def get_external_length_units(self):
        return 1.0

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 0o777

    def get_tool(self, pocket):
        tool = self.spindle if pocket == 0 else TOOLS[pocket] if pocket < len(TOOLS) else (-1, 0.0, 0.0)
        return (tool[0], 0.0, 0.0, tool[1], *(0.0,) * 6, tool[2], 0.0, 0.0, 0)

    def get_block_delete(self):
        return True

    def check_abort(self):
        return False


canon = Canon()
result, line = gcode.parse(PROGRAM, canon, f"G21 {START}", "G90 G94 G17 G40 G49 G80")
print("end", result, line, gcode.strerror(result) if result > gcode.MIN_ERROR else "")
