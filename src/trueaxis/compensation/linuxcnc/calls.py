# mypy: ignore-errors
# ruff: noqa: D102
"""Runs in LinuxCNC's own Python, apart from trueaxis: all that its interpreter asks of the machine in one program.

calls.py TASK.json, whose keys are: program, its file; var, that of its parameters; table, that of its tools,
as LinuxCNC has it; packages, where the module gcode is; tools, in the order of the table, each its number, X Y Z
offset, diameter (mm), front and back angle, orientation, the first that in the spindle; start, a block that puts the
axes where they are taken to stand; skips, whether / blocks are skipped; moved, how far X Y Z A B C (mm, deg) stand
elsewhere after a tool change.

Written are lines of JSON, one for everything that is asked. A motion: kind, line of the program, plane, turns, centre
(mm), positions X Y Z A B C in machine coordinates (mm, deg); `stands` is where the next motion starts. A call: `call`,
line, name, arguments. `other`, line: what is not written. The last line is the result.
"""

import ctypes
import json
import os
import sys
from pathlib import Path

MM = 25.4  # the module gives lengths in inches
INCHES = 1  # CANON_UNITS
PLANES = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}
NO_TOOL = [-1, [0.0, 0.0, 0.0], 0.0, 0.0, 0.0, 0]


class Held:
    """Where the module takes the axes to stand: it forgets arcs and changes of units and of the frame, and the
    interpreter asks it after a tool change.
    """

    def __init__(self, module):
        # the calls by which the interpreter tells the module of rapids and their speed, as C++ names them
        library = ctypes.PyDLL(module)
        self._traverse, self._rate = library._Z17STRAIGHT_TRAVERSEiddddddddd, library._Z17SET_TRAVERSE_RATEd
        self._traverse.argtypes = [ctypes.c_int] + [ctypes.c_double] * 9
        self._rate.argtypes = [ctypes.c_double]
        self.telling, self._told = False, None

    def rapid(self, values):
        """The module has taken in what it was told."""
        self._told = values

    def ask_line(self):
        """Have the module tell the line that the interpreter is in: it does before any call."""
        self._rate(0.0)

    def put(self, line, words):
        """Tell the module a position: words of the program, in inches and deg."""
        self.telling = True
        self._traverse(line, MM, *(0.0,) * 8)
        unit = MM if abs(self._told[0] - 1.0) < 1e-9 else 1.0  # it takes the units of the program and gives inches
        scaled = [value if 3 <= row < 6 else value * unit for row, value in enumerate(words)]
        self._traverse(line, *scaled)
        self.telling = False


class Canon:
    """What the interpreter calls; positions are those of the program."""

    def __init__(self, task, held, out):
        self.parameter_file, self.tools, self.skips = task["var"], task["tools"], task["skips"]
        moved = task["moved"]
        self.moved_by, self.held = [*(value / MM for value in moved[:3]), *moved[3:], 0.0, 0.0, 0.0], held
        self.spindle, self.out = self.tools[0], out
        self.unit, self.tolerance = 1.0, {"MOTION_CONTROL": 0.0, "MOTION_CONTROL_NAIVECAM": 0.0}  # mm
        self.line, self.plane, self.changed_in, self.units = 0, 1, None, None
        self.at = (0.0,) * 9  # machine coordinates, inches and deg
        self.shifts = {"work": (0.0,) * 9, "set": (0.0,) * 9, "tool": (0.0,) * 9}

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: None

    def next_line(self, state):
        if self.changed_in is not None and state.units != self.units:
            self.say("other", "a tool change and a change of units in one block")
        self.line, self.changed_in, self.units = state.sequence_number, None, state.units

    def call(self, name, given):
        """A call of hooks."""
        if name == "USE_LENGTH_UNITS":
            self.unit = MM if given[0] == INCHES else 1.0
        elif name == "SET_MOTION_CONTROL_MODE":
            self.tolerance["MOTION_CONTROL"] = given[1] * self.unit
        elif name == "SET_NAIVECAM_TOLERANCE":
            self.tolerance["MOTION_CONTROL_NAIVECAM"] = given[0] * self.unit
        self.held.ask_line()
        if name == "CHANGE_TOOL_NUMBER":  # M61: the control takes the tool's data over, and moves no axis
            self.spindle = self.of_table(given[0])
            given = [max(self.spindle[0], 0)]
            self.changed_in = self.line
            self.hold()
        self.say("call", name, *(one.decode("latin-1") if isinstance(one, bytes) else one for one in given))

    def answers(self):
        """What hooks answers: as LinuxCNC's control does, in units of the program."""
        names = {f"GET_EXTERNAL_{name}_TOLERANCE": name for name in self.tolerance}
        return {call: lambda name=name: self.tolerance[name] / self.unit for call, name in names.items()}

    def set_feed_rate(self, rate):
        self.say("call", "SET_FEED_RATE", rate * MM)

    def dwell(self, seconds):
        self.say("call", "DWELL", seconds)

    def set_g5x_offset(self, index, *values):
        self.shift("work", values)
        self.say("call", "SET_G5X_OFFSET", index)

    def set_g92_offset(self, *values):
        self.shift("set", values)

    def tool_offset(self, *values):
        self.shift("tool", values)
        self.say("call", "USE_TOOL_LENGTH_OFFSET", *(value * MM for value in values[:3]))

    def shift(self, which, values):
        """Part of the frame; in the block of a tool change the axes stay where they are, whatever is in force after."""
        self.shifts[which] = values
        if self.changed_in is not None:
            self.hold()

    def set_xy_rotation(self, angle):
        if angle:
            self.say("other", "the coordinates are turned (R of G10)")

    def set_plane(self, plane):
        self.plane = plane

    def say(self, kind, *values):
        if self.line < 0:  # a motion of a cycle has no line of its own
            self.held.ask_line()
        print(json.dumps([kind, self.line, *values]), file=self.out)

    def total(self, values):
        return [sum(parts) for parts in zip(values, *self.shifts.values(), strict=True)]

    def machine(self, values):
        if any(values[6:]):
            self.say("other", "an axis U, V or W moves")
        return [value * (MM if row < 3 else 1.0) for row, value in enumerate(values[:6])]

    def change_tool(self, place):
        """A tool change may move the axes anywhere."""
        self.spindle = self.of_table(place)
        self.say("call", "CHANGE_TOOL", max(self.spindle[0], 0))
        self.at = [a + b for a, b in zip(self.at, self.moved_by, strict=True)]
        self.say("stands", 0, 0, [], self.machine(self.at))
        self.changed_in = self.line
        self.hold()

    def hold(self):
        shifts = zip(*self.shifts.values(), strict=True)
        self.held.put(self.line, [at - sum(parts) for at, parts in zip(self.at, shifts, strict=True)])

    def moved(self, kind, values):
        self.at = self.total(values)
        self.say(kind, 0, 0, [], self.machine(self.at))

    def straight_traverse(self, *values):
        if self.held.telling:
            self.held.rapid(values)
        else:
            self.moved("rapid", values)

    def straight_feed(self, *values):
        self.moved("feed", values)

    def arc_feed(self, first, second, first_centre, second_centre, turns, along, *others):
        rows = PLANES[self.plane]
        end, centre = [0.0] * 3, [0.0] * 9
        end[rows[0]], end[rows[1]], end[rows[2]] = first, second, along
        centre[rows[0]], centre[rows[1]] = first_centre, second_centre
        middle = self.machine(self.total(centre))
        self.at = self.total([*end, *others])
        self.say("arc", self.plane, turns, [middle[rows[0]], middle[rows[1]]], self.machine(self.at))
        if self.changed_in is not None:
            self.hold()

    def straight_probe(self, *_):
        self.say("other", "probing (G38)")

    def rigid_tap(self, *_):
        self.say("other", "rigid tapping (G33.1)")

    def user_defined_function(self, number, *_):
        self.say("other", f"a user's M code (M{100 + number})")

    def get_external_length_units(self):
        return 1.0

    def get_external_angular_units(self):
        return 1.0

    def get_axis_mask(self):
        return 0o777

    def of_table(self, place):
        return self.tools[place] if 0 < place < len(self.tools) else NO_TOOL

    def get_tool(self, place):
        """The tool of a place of the table; 0 is the spindle."""
        tool, offset, diameter, *angles = self.spindle if place == 0 else self.of_table(place)
        return (tool, *(value for value in offset), *(0.0,) * 6, diameter, *angles)

    def get_block_delete(self):
        return self.skips

    def check_abort(self):
        return False


def main(task):
    """Run one program."""
    sys.path.insert(0, task["packages"])
    # gcode is LinuxCNC's; hooks stands beside this file, which is no part of a package where it runs
    import gcode  # noqa: PLC0415
    import hooks  # noqa: PLC0415

    # the table of tools is memory shared by way of a file in HOME; without it the module crashes
    table = ctypes.CDLL("libtooldata.so.0", ctypes.RTLD_GLOBAL)
    table._Z17tool_mmap_creatorPK13EMC_TOOL_STATi(None, 0)
    table._Z13tooldata_loadPKcPPc(task["table"].encode(), None)
    with os.fdopen(os.dup(1), "w", encoding="utf-8") as out:
        os.dup2(2, 1)  # what the program prints, (PRINT, ..), goes elsewhere
        canon = Canon(task, Held(gcode.__file__), out)
        try:
            heard = hooks.hear(canon.call, canon.answers())
        except LookupError as missing:
            print(json.dumps(["end", 0, -1, str(missing)]), file=out)
            return None
        # the start leaves no motion in force, as LinuxCNC has none when a program begins
        result, _ = gcode.parse(task["program"], canon, f"G21 {task['start']}", "G80")
        failed = result > gcode.MIN_ERROR  # in the line that the module has told last: the one it returns may be later
        print(
            json.dumps(["end", canon.line, result if failed else 0, gcode.strerror(result) if failed else ""]), file=out
        )
        return heard  # until the process ends


if __name__ == "__main__":
    alive = main(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")))
