"""The words of what LinuxCNC's interpreter asks of the machine beside motions: modes, spindle, tools, outputs."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from trueaxis.compensation.settings import MM_PER_INCH
from trueaxis.compensation.tools import Tool

FOOT = 0.3048  # m
SAME_LENGTH = 1e-6  # mm
NO_LIMIT = 1e9  # revolutions a minute: LinuxCNC has 1e30 where G96 has no D
NOT_SAID, EXACT_PATH, CONTINUOUS = 0, 2, 3  # CANON_MOTION_MODE; 1: exact stop
INCHES = 1  # CANON_UNITS
_WORDS = {
    "START_SPINDLE_CLOCKWISE": "M3", "START_SPINDLE_COUNTERCLOCKWISE": "M4", "STOP_SPINDLE_TURNING": "M5",
    "FLOOD_ON": "M8", "MIST_ON": "M7", "FLOOD_OFF": "M9", "MIST_OFF": "M9", "OPTIONAL_PROGRAM_STOP": "M1",
    "ENABLE_FEED_OVERRIDE": "M50 P1", "DISABLE_FEED_OVERRIDE": "M50 P0", "ENABLE_SPEED_OVERRIDE": "M51 P1",
    "DISABLE_SPEED_OVERRIDE": "M51 P0", "ENABLE_ADAPTIVE_FEED": "M52 P1", "DISABLE_ADAPTIVE_FEED": "M52 P0",
    "ENABLE_FEED_HOLD": "M53 P1", "DISABLE_FEED_HOLD": "M53 P0",
}  # fmt: skip
_WITH_VALUES = {
    "SELECT_TOOL": "T{0}", "DWELL": "G4 P{0}", "SET_MOTION_OUTPUT_BIT": "M62 P{0}", "CLEAR_MOTION_OUTPUT_BIT":
    "M63 P{0}", "SET_AUX_OUTPUT_BIT": "M64 P{0}", "CLEAR_AUX_OUTPUT_BIT": "M65 P{0}",
    "SET_MOTION_OUTPUT_VALUE": "M67 E{0} Q{1}", "SET_AUX_OUTPUT_VALUE": "M68 E{0} Q{1}", "MESSAGE": "(MSG,{0})",
}  # fmt: skip
_STOPS = {"PALLET_SHUTTLE": ("", ""), "PROGRAM_STOP": ("M0", "M60"), "PROGRAM_END": ("M2", "M30")}
PASSED = (50, 51, 52, 53, 62, 63, 64, 65, 67, 68)  # the M codes of these
# what says nothing that the words do not hold
_SILENT = frozenset({"SET_G5X_OFFSET", "COMMENT", "START_CHANGE"})
_NOT_WRITTEN = {
    "WAIT": "M66 waits for an input: what the program does then is not known",
    "ORIENT_SPINDLE": "turning the spindle to an angle (M19) is not unrolled",
    "SET_TOOL_TABLE_ENTRY": "a change of the tool table (G10 L1, L10, L11) is not unrolled",
    "START_SPEED_FEED_SYNCH": "motion by the turns of the spindle (G33, G76: threads) is not unrolled",
}


@dataclass(frozen=True, slots=True)
class Call:
    """A call of the interpreter: line of the source, name, arguments."""

    line: int
    name: str
    given: Sequence[float | str]


def written(number: float) -> str:
    """A number as a word has it, to a millionth."""
    text = f"{number:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


class Modes:
    """What is in force: unit, feed, whether the spindle turns by G96, whether F counts by turns."""

    def __init__(self, tools: Mapping[int, Tool], first_tool: int | None) -> None:
        self._tools, self._changed = tools, False
        self.first_tool = first_tool
        self._unit, self._rate, self._by_turns = 1.0, 0.0, False
        self._surface, self._speed_mode = False, ""
        self._tolerance, self._flat = math.nan, 0.0  # mm, of a G64 that is due, and of the last one
        self.exact_since = 0  # line of the first cycle in a path mode that the program does not say
        self._shuttle, self._dry = False, 0

    def feed(self, turns: bool) -> float:
        """F, mm/min or by turns mm; of a motion of rotary axes alone deg."""
        return self._rate / self._unit if turns else self._rate

    def words(self, call: Call) -> Iterator[str]:
        """The blocks of a call. Raises ValueError with the line and what is wrong where it has none."""
        name, given = call.name, call.given
        numbers = [one for one in given if not isinstance(one, str)]
        if name != "SET_NAIVECAM_TOLERANCE":
            yield from self.due()
        if name in _NOT_WRITTEN:
            raise ValueError(call.line, _NOT_WRITTEN[name])
        if name in _WORDS:
            if _WORDS[name] != "M9" or self._dry != call.line:
                yield _WORDS[name]
            self._dry = call.line if _WORDS[name] == "M9" else 0
        elif name in _WITH_VALUES:
            yield _WITH_VALUES[name].format(*(one if isinstance(one, str) else written(one) for one in given))
        elif name in _STOPS:
            yield from self._stop(name)
        elif name.startswith("SET_SPINDLE"):
            yield from self._spindle(name, numbers[-1])
        elif name in ("SET_MOTION_CONTROL_MODE", "SET_NAIVECAM_TOLERANCE"):
            yield from self._path(call, numbers)
        elif name in ("CHANGE_TOOL", "CHANGE_TOOL_NUMBER", "USE_TOOL_LENGTH_OFFSET"):
            yield from self._tool(call, numbers)
        else:
            yield from self._feed_mode(call, numbers)

    def _stop(self, name: str) -> Iterator[str]:
        """LinuxCNC says first whether pallets are changed: M60, M30."""
        self._shuttle |= name == "PALLET_SHUTTLE"
        if name != "PALLET_SHUTTLE":
            yield _STOPS[name][self._shuttle]
            self._shuttle = False

    def _spindle(self, name: str, number: float) -> Iterator[str]:
        """G96 stands before the S that follows: LinuxCNC wants both in one block."""
        if name == "SET_SPINDLE_SPEED":  # with G96 a speed along the surface, m/min or ft/min
            foot = FOOT if self._surface and self._unit != 1.0 else 1.0
            yield f"{self._speed_mode}S{written(abs(number) * foot)}"
            self._speed_mode = ""
            return
        if number:
            self._speed_mode = f"G96 D{written(number)} " if number < NO_LIMIT else "G96 "
        elif self._surface:
            yield "G97"
        self._surface = bool(number)

    def due(self) -> Iterator[str]:
        """G64 that is due before anything else: it waits for its second tolerance, which a cycle does not say when it
        puts the mode in force again.
        """
        if not math.isnan(self._tolerance):
            words = f"G64 P{written(self._tolerance)}" if self._tolerance or self._flat else "G64"
            yield words + (f" Q{written(self._flat)}" if self._flat != self._tolerance else "")
            self._tolerance = math.nan

    def _path(self, call: Call, numbers: Sequence[float]) -> Iterator[str]:
        """G61, G61.1, or G64 with its tolerances, which LinuxCNC says one after another."""
        if call.name == "SET_NAIVECAM_TOLERANCE":
            self._flat = numbers[0] * self._unit
            yield from self.due()
        elif numbers[0] == CONTINUOUS:
            self._tolerance = numbers[1] * self._unit
        elif numbers[0] == NOT_SAID:
            self.exact_since = self.exact_since or call.line
        else:
            yield "G61" if numbers[0] == EXACT_PATH else "G61.1"

    def _feed_mode(self, call: Call, numbers: Sequence[float]) -> Iterator[str]:
        if call.name == "USE_LENGTH_UNITS":
            self._unit = MM_PER_INCH if numbers[0] == INCHES else 1.0
        elif call.name == "SET_FEED_RATE":
            self._rate = numbers[0]
        elif call.name == "SET_FEED_MODE":
            if bool(numbers[1]) != self._by_turns:
                self._by_turns = bool(numbers[1])
                yield "G95" if self._by_turns else "G94"
        elif call.name not in _SILENT:
            raise ValueError(call.line, f"the program calls {call.name}, which is not unrolled")

    def _tool(self, call: Call, numbers: Sequence[float]) -> Iterator[str]:
        if call.name == "CHANGE_TOOL":
            self._changed = True
            yield "M6"
            return
        if call.name == "CHANGE_TOOL_NUMBER":
            self._changed = True
            yield f"M61 Q{written(numbers[0])}"
            return
        length = numbers[2]
        if not self._tools or self._changed or self.first_tool is not None or abs(length) < SAME_LENGTH:
            return
        same = [number for number, tool in self._tools.items() if abs(tool.shift[2] - length) < SAME_LENGTH]
        alike = {(self._tools[number].shift, self._tools[number].point) for number in same}
        if len(alike) != 1:
            problem = f"a length of {length:.4f} mm is in force before a tool change: of which tool is not known"
            raise ValueError(call.line, problem)
        self.first_tool = same[0]
