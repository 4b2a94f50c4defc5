# mypy: ignore-errors
# ruff: noqa: D102
"""Runs in LinuxCNC's own Python, apart from trueaxis: the motions that its interpreter makes of one program.

linuxcnc_calls.py PROGRAM VAR PACKAGES TOOLS START SKIPS MOVED: PACKAGES is where the module gcode is, TOOLS numbers
and lengths (mm) as JSON in the order of the table, START a block that puts the axes where they are taken to stand,
SKIPS is `skip` where / blocks are skipped, MOVED how far X Y Z A B C (mm, deg; JSON) stand elsewhere after a tool
change. One line of JSON a motion: kind, line of the program, plane, turns, centre (mm), positions X Y Z A B C in
machine coordinates (mm, deg); `stands` is where the next motion starts. The last line is the result.
"""

import ctypes
import json
import sys

MM = 25.4  # the module gives lengths in inches
PLANES = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}


class Held:
    """Where the module takes the axes to stand: it forgets arcs and changes of units and of the frame, and the
    interpreter asks it after a tool change.
    """

    def __init__(self, module):
        # the call by which the interpreter tells the module of a rapid, as C++ names it
        self._traverse = ctypes.PyDLL(module)._Z17STRAIGHT_TRAVERSEiddddddddd
        self._traverse.argtypes = [ctypes.c_int] + [ctypes.c_double] * 9
        self.telling, self._told = False, None

    def rapid(self, values):
        """The module has taken in what it was told."""
        self._told = values

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

    def __init__(self, var, tools, skips, moved, held):
        self.parameter_file, self.tools, self.skips = var, tools, skips
        self.moved_by, self.held = [*(value / MM for value in moved[:3]), *moved[3:], 0.0, 0.0, 0.0], held
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

    def set_g5x_offset(self, _index, *values):
        self.shift("work", values)

    def set_g92_offset(self, *values):
        self.shift("set", values)

    def tool_offset(self, *values):
        self.shift("tool", values)

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
        print(json.dumps([kind, self.line, *values]))

    def total(self, values):
        return [sum(parts) for parts in zip(values, *self.shifts.values(), strict=True)]

    def machine(self, values):
        if any(values[6:]):
            self.say("other", "an axis U, V or W moves")
        return [value * (MM if row < 3 else 1.0) for row, value in enumerate(values[:6])]

    def change_tool(self, *_):
        """A tool change may move the axes anywhere."""
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

    def get_tool(self, place):
        tool, length = self.tools[place] if place < len(self.tools) else (-1, 0.0)
        return (tool, 0.0, 0.0, length, *(0.0,) * 9, 0)

    def get_block_delete(self):
        return self.skips

    def check_abort(self):
        return False


def main(program, var, packages, tools, start, skips, moved):
    """Run one program."""
    sys.path.insert(0, packages)
    import gcode  # noqa: PLC0415  # of LinuxCNC: nothing of it is there when this file is imported

    # the table of tools is memory shared by way of a file in HOME, which rs274 has made; without it the module crashes
    ctypes.CDLL("libtooldata.so.0", ctypes.RTLD_GLOBAL)._Z14tool_mmap_userv()
    # the start leaves no motion in force, as LinuxCNC has none when a program begins
    canon = Canon(var, json.loads(tools), skips == "skip", json.loads(moved), Held(gcode.__file__))
    result, line = gcode.parse(program, canon, f"G21 {start}", "G80")
    failed = result > gcode.MIN_ERROR
    print(json.dumps(["end", line, result if failed else 0, gcode.strerror(result) if failed else ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
