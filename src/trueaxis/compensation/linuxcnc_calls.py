# mypy: ignore-errors
# ruff: noqa: D102
"""Runs in LinuxCNC's own Python, apart from trueaxis: the motions that its interpreter makes of one program.

linuxcnc_calls.py PROGRAM VAR PACKAGES TOOLS START SKIPS: PACKAGES is where the module gcode is, TOOLS numbers and
lengths (mm) as JSON in the order of the table, START a block that puts the axes where they are to be taken to stand,
SKIPS is `skip` where / blocks are skipped. One line of JSON a motion: kind, line of the program, plane, turns, centre
(mm), positions X Y Z A B C in machine coordinates (mm, deg). The last line is the result.
"""

import ctypes
import json
import sys

MM = 25.4  # the module gives lengths in inches
PLANES = {1: (0, 1, 2), 2: (1, 2, 0), 3: (2, 0, 1)}


class Canon:
    """What the interpreter calls; positions are those of the program."""

    def __init__(self, var, tools, skips):
        self.parameter_file, self.tools, self.skips = var, tools, skips
        self.line, self.plane, self.motions, self.last = 0, 1, 0, None
        self.shifts = {"work": (0.0,) * 9, "set": (0.0,) * 9, "tool": (0.0,) * 9}

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *_: None

    def next_line(self, state):
        self.line = state.sequence_number

    def set_g5x_offset(self, _index, *values):
        self.shifts["work"] = values

    def set_g92_offset(self, *values):
        self.shifts["set"] = values

    def tool_offset(self, *values):
        self.shifts["tool"] = values

    def set_xy_rotation(self, angle):
        if angle:
            self.say("other", "the coordinates are turned (R of G10)")

    def set_plane(self, plane):
        self.plane = plane

    def say(self, kind, *values):
        print(json.dumps([kind, self.line, *values]))

    def machine(self, values):
        total = [sum(parts) for parts in zip(values, *self.shifts.values(), strict=True)]
        if any(total[6:]):
            self.say("other", "an axis U, V or W moves")
        return [value * (MM if row < 3 else 1.0) for row, value in enumerate(total[:6])]

    def change_tool(self, *_):
        """The module forgets what offsets have changed since the last motion: it goes on from the same words."""
        if self.last is None or self.last[0] == self.shifts:
            return
        if self.motions > 1:
            self.say("other", "a tool change after a change of offsets, without a motion between them,")
        else:  # the start alone
            self.say("stands", 0, 0, [], self.machine(self.last[1]))

    def moved(self, kind, values):
        self.motions += 1
        self.last = (dict(self.shifts), values)
        self.say(kind, 0, 0, [], self.machine(values))

    def straight_traverse(self, *values):
        self.moved("rapid", values)

    def straight_feed(self, *values):
        self.moved("feed", values)

    def arc_feed(self, first, second, first_centre, second_centre, turns, along, *others):
        rows = PLANES[self.plane]
        end, centre = [0.0] * 3, [0.0] * 9
        end[rows[0]], end[rows[1]], end[rows[2]] = first, second, along
        centre[rows[0]], centre[rows[1]] = first_centre, second_centre
        middle = self.machine(centre)
        self.motions += 1
        self.last = (dict(self.shifts), [*end, *others])
        self.say("arc", self.plane, turns, [middle[rows[0]], middle[rows[1]]], self.machine([*end, *others]))

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


def main(program, var, packages, tools, start, skips):
    """Run one program."""
    sys.path.insert(0, packages)
    import gcode  # noqa: PLC0415  # of LinuxCNC: nothing of it is there when this file is imported

    # the table of tools is memory shared by way of a file in HOME, which rs274 has made; without it the module crashes
    ctypes.CDLL("libtooldata.so.0", ctypes.RTLD_GLOBAL)._Z14tool_mmap_userv()
    # the start leaves no motion in force, as LinuxCNC has none when a program begins
    result, line = gcode.parse(program, Canon(var, json.loads(tools), skips == "skip"), f"G21 {start}", "G80")
    failed = result > gcode.MIN_ERROR
    print(json.dumps(["end", line, result if failed else 0, gcode.strerror(result) if failed else ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
