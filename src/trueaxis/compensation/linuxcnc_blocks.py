"""The program that the calls and motions of LinuxCNC's interpreter make: lines and arcs in machine coordinates."""

import math
import re
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile

import numpy as np

from trueaxis.compensation.linuxcnc_splines import POINTS, biarcs, curve_of
from trueaxis.compensation.tools import Tool

AXES = "XYZABC"
_LARGEST_NUMBER = 99999  # of a block, in LinuxCNC
FOOT = 0.3048  # m
SAME_LENGTH = 0.003  # mm: rs274 prints four decimals, in inches
NO_LIMIT = 1e9  # revolutions a minute: LinuxCNC has 1e30 where G96 has no D
SAME = 1e-7  # mm, deg: what doubles lose on the way through inches
UNCERTAIN = "where the axes stand at first or after a tool change, or on a reference point that is not given"
_CALL = re.compile(r"\s*\d+\s+N(?:\.+|\d+)\s*([A-Z]\w*)\((.*)\)\s*$")  # no space behind long numbers
_MOTION = frozenset({"STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED"})
_WORDS = {
    "START_SPINDLE_CLOCKWISE": "M3", "START_SPINDLE_COUNTERCLOCKWISE": "M4", "STOP_SPINDLE_TURNING": "M5",
    "FLOOD_ON": "M8", "MIST_ON": "M7", "FLOOD_OFF": "M9", "MIST_OFF": "M9", "PROGRAM_STOP": "M0",
    "OPTIONAL_PROGRAM_STOP": "M1", "PROGRAM_END": "M2",
}  # fmt: skip
# M codes of LinuxCNC that move nothing, with their words: overrides, outputs
_OUTPUTS = {
    "ENABLE_FEED_OVERRIDE": "M50 P1", "DISABLE_FEED_OVERRIDE": "M50 P0", "ENABLE_SPEED_OVERRIDE": "M51 P1",
    "DISABLE_SPEED_OVERRIDE": "M51 P0", "SET_MOTION_OUTPUT_BIT": "M62 P{0:.0f}",
    "CLEAR_MOTION_OUTPUT_BIT": "M63 P{0:.0f}", "SET_AUX_OUTPUT_BIT": "M64 P{0:.0f}",
    "CLEAR_AUX_OUTPUT_BIT": "M65 P{0:.0f}",
    "SET_MOTION_OUTPUT_VALUE": "M67 E{0:.0f} Q{1:.6f}", "SET_AUX_OUTPUT_VALUE": "M68 E{0:.0f} Q{1:.6f}",
}  # fmt: skip
PASSED = (50, 51, 62, 63, 64, 65, 67, 68)  # the codes of these
# what says nothing that the motions do not hold
_SILENT = frozenset({
    "USE_LENGTH_UNITS", "SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION", "SET_FEED_REFERENCE", "ON_RESET",
    "SELECT_PLANE", "SELECT_TOOL", "START_CHANGE", "SET_CUTTER_RADIUS_COMPENSATION", "START_CUTTER_RADIUS_COMPENSATION",
    "STOP_CUTTER_RADIUS_COMPENSATION", "COMMENT", "MESSAGE", "LOG", "SET_NAIVECAM_TOLERANCE", "USE_TOOL_LENGTH_OFFSET",
    "ORIENT_SPINDLE_OFF", "PALLET_SHUTTLE",  # M30
    "FINISH",
})  # fmt: skip
HEAD = "G21 G90 G94 G17 G40 G49 G80\nG92.1\nG10 L2 P9 X0 Y0 Z0\nG59.3\n"


@dataclass(frozen=True, slots=True, kw_only=True)
class Motion:
    """kind: rapid, feed or arc; line: of the source; plane, turns, centre: of an arc; end: X Y Z A B C in machine
    coordinates, mm and deg, None where it depends on where the axes stand at first; way: from the end before, NaN where
    that depends on it.
    """

    kind: str
    line: int
    plane: int
    turns: int
    centre: tuple[float, ...]
    end: tuple[float | None, ...]
    way: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Unrolled:
    """text: the program; tool: in the spindle before it, None where it does not say."""

    text: str
    tool: int | None


def unrolled_program(
    calls: Sequence[str],
    motions: Sequence[Motion],
    tools: Mapping[int, Tool],
    axes: Sequence[str] = AXES,
    kept: bool = False,
) -> Unrolled:
    """The calls of rs274 in order, with the motions in their places; tools: in the order of the table, by which rs274
    names them; axes: those of the machine: others get no word while they stand at 0;
    kept: whether a tool change moves no axis.

    Raises ValueError with what a call does that is not written.
    """
    writer = _Writer(tools, axes, kept)
    blocks = "".join(f"{line}\n" for line in _blocks(writer, calls, motions))
    return Unrolled(HEAD + blocks, writer.first_tool)


def _blocks(writer: "_Writer", calls: Sequence[str], motions: Sequence[Motion]) -> Iterator[str]:
    remaining = deque(motions)
    for text in calls:
        call = _CALL.match(text)
        if call is None:
            continue
        function, arguments = call[1], call[2]
        if function in _MOTION:
            if not remaining:
                raise ValueError("rs274 makes more motions than the module")
            yield from writer.motion(remaining.popleft())
        elif function == "NURBS_FEED":
            for motion in spline_motions(remaining, int(_numbers(arguments)[0]), writer.at):
                yield from writer.motion(motion)
        else:
            yield from writer.modes(function, arguments)
    if remaining:
        raise ValueError("the module makes more motions than rs274")


def spline_motions(remaining: deque[Motion], count: int, at: Sequence[float | None]) -> Iterator[Motion]:
    """Arcs and lines of a spline with so many control points, for the module's motions, which are taken off; at: where
    it begins.
    """
    given = list(takewhile(lambda motion: motion.kind == "feed" and None not in motion.end[:2], remaining))
    if not given or None in at[:2]:
        raise ValueError(f"where a spline goes depends on {UNCERTAIN}")
    longest = given[: POINTS * count + 1]
    curve, used = curve_of(np.array([at[:2], *(motion.end[:2] for motion in longest)], dtype=np.float64), count)
    for _ in range(used - 1):
        remaining.popleft()
    for end, centre, turns in biarcs(curve):
        kind = "feed" if centre is None else "arc"
        others = given[0].end[2:]
        yield Motion(
            kind=kind, line=given[0].line, plane=1, turns=turns, centre=centre or (), end=(*end, *others),
            way=(math.nan, math.nan, *(0.0,) * len(others)),
        )  # fmt: skip


class _Writer:
    """What is in force: positions (at), unit and plane, feed, increments, and whether the spindle turns by G96."""

    def __init__(self, tools: Mapping[int, Tool], axes: Sequence[str], kept: bool) -> None:
        self._kept = kept
        self._tools, self._numbers, self._changed = tools, [0, *tools], False
        self.first_tool: int | None = None
        self._unknown: list[float | None] = [None if axis in axes else 0.0 for axis in AXES]
        self.at = self._unknown
        self._unit, self._plane, self._feed = 1.0, 1, ""
        self._absolute, self._surface, self._mode = True, False, ""

    def motion(self, motion: Motion) -> Iterator[str]:
        if motion.kind == "arc" and motion.plane != self._plane:
            self._plane = motion.plane
            yield f"G{(17, 19, 18)[self._plane - 1]}"
        by_ways = _counts_from_start(motion)
        if by_ways == self._absolute:
            self._absolute = not by_ways
            yield "G90" if self._absolute else "G91"
        fed = "" if motion.kind == "rapid" else self._feed
        yield _increments(motion, fed) if by_ways else _block(motion, self.at, fed)
        self.at = [before if value is None else value for before, value in zip(self.at, motion.end, strict=True)]

    def modes(self, function: str, arguments: str) -> Iterator[str]:
        if function == "USE_LENGTH_UNITS":
            self._unit = 25.4 if "INCH" in arguments else 1.0
        elif function == "SET_FEED_RATE":
            self._feed = f" F{float(arguments) * self._unit:.4f}"
        elif function == "SET_SPINDLE_MODE":
            yield from self._spindle_mode(_numbers(arguments)[-1])
        elif function == "SET_SPINDLE_SPEED":  # with G96 a speed along the surface, m/min or ft/min
            foot = FOOT if self._surface and self._unit != 1.0 else 1.0
            yield f"{self._mode}S{abs(_numbers(arguments)[-1]) * foot:.4f}"
            self._mode = ""
        elif function == "USE_TOOL_LENGTH_OFFSET":
            if self._tools and not self._changed:
                self._take_first(_numbers(arguments)[2] * self._unit)
        elif function == "CHANGE_TOOL":
            self._changed = True
            if not self._kept:  # axes may have moved, and get words again
                self.at = self._unknown
            yield f"T{self._numbers[int(float(arguments))]} M6"
        else:
            yield from _words(function, arguments)

    def _take_first(self, length: float) -> None:
        """Take the tool whose length is put in force before any tool change to be the one in the spindle."""
        if not length or self.first_tool is not None:
            return
        same = [number for number, tool in self._tools.items() if abs(tool.shift[2] - length) < SAME_LENGTH]
        if not same or len({self._tools[number] for number in same}) > 1:
            raise ValueError(
                f"a length of {length:.4f} mm is in force before a tool change: of which tool is not known,"
            )
        self.first_tool = same[0]

    def _spindle_mode(self, most: float) -> Iterator[str]:
        """G96 stands before the S that follows: LinuxCNC wants both in one block."""
        if most:
            self._mode = f"G96 D{most:.4f} " if most < NO_LIMIT else "G96 "
        elif self._surface:
            yield "G97"
        self._surface = bool(most)


def _numbers(arguments: str) -> list[float]:
    return [float(number) for number in re.findall(r"[-+]?\d+\.?\d*", arguments)]


def _words(function: str, arguments: str) -> Iterator[str]:
    numbers = _numbers(arguments)
    if function in _WORDS:
        yield _WORDS[function]
    elif function in _OUTPUTS:
        yield _OUTPUTS[function].format(*numbers)
    elif function == "SET_FEED_MODE":
        yield "G95" if numbers[-1] else "G94"
    elif function == "DWELL":
        yield f"G4 P{numbers[0]:.4f}"
    elif function == "SET_MOTION_CONTROL_MODE":
        mode = "G61" if "EXACT_STOP" in arguments else "G61.1" if "EXACT_PATH" in arguments else "G64"
        yield mode + (f" P{numbers[-1]:.4f}" if mode == "G64" and numbers and numbers[-1] else "")
    elif function not in _SILENT:
        raise ValueError(f"the program calls {function}({arguments[:30]})")


def _counts_from_start(motion: Motion) -> bool:
    """Whether a motion moves an axis by an increment from where it stands at first.

    Raises ValueError where its way depends on that, too.
    """
    moved = [way for end, way in zip(motion.end, motion.way, strict=True) if end is None and not abs(way) < SAME]
    if any(math.isnan(way) for way in moved):
        raise ValueError(f"where the motion of line {motion.line} goes depends on {UNCERTAIN}")
    return bool(moved) and motion.kind != "arc"


def _number(motion: Motion) -> str:
    """The line of the source as a block number; motions of a cycle have none (-1)."""
    return f"N{motion.line} " if 0 < motion.line <= _LARGEST_NUMBER else ""


def _increments(motion: Motion, feed: str) -> str:
    if any(end is not None and math.isnan(way) for end, way in zip(motion.end, motion.way, strict=True)):
        raise ValueError(f"line {motion.line} moves axes by increments and to positions, from an unknown start")
    ways = [f"{axis}{way:.7f}" for axis, way in zip(AXES, motion.way, strict=True) if abs(way) > SAME]
    return f"{_number(motion)}{'G0' if motion.kind == 'rapid' else 'G1'} {' '.join(ways)}{feed}"


def _block(motion: Motion, at: Sequence[float | None], feed: str) -> str:
    code = {"rapid": "G0", "feed": "G1"}.get(motion.kind) or ("G3" if motion.turns > 0 else "G2")
    words = [
        f"{axis}{value:.7f}"
        for axis, value, before in zip(AXES, motion.end, at, strict=True)
        if value is not None and (before is None or abs(value - before) > SAME)
    ]
    if motion.kind == "arc":
        rows = {1: (0, 1), 2: (1, 2), 3: (2, 0)}[motion.plane]
        start = [at[row] for row in rows]
        if None in start or None in [motion.end[row] for row in rows]:
            raise ValueError(f"where the arc of line {motion.line} begins depends on {UNCERTAIN}")
        words += [
            f"{'IJK'[row]}{centre - (begin or 0.0):.7f}"
            for row, centre, begin in sorted(zip(rows, motion.centre, start, strict=True))
        ]
        if abs(motion.turns) > 1:
            words.append(f"P{abs(motion.turns)}")
    if not words:  # a motion to where the axes are: nothing moves
        return _number(motion).rstrip()
    return f"{_number(motion)}{code} {' '.join(words)}{feed}"
