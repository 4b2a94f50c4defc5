"""The modes of an NC program: units, distances, planes, how F counts, what numbers without a decimal point count, and
tool centre point control.
"""

import math
import re
from collections.abc import Sequence

from trueaxis.compensation.arcs import half_unit
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Item, Notes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.lexer import Meaning, decimals_of
from trueaxis.compensation.nc.state import NcState
from trueaxis.compensation.settings import MM_PER_INCH, Integers, Settings

UNFED = (
    "no F above 0 before this feed motion: a control on which none is in force from before stops here (LinuxCNC: "
    "zero feed rate; Fanuc: alarm 011; SINUMERIK: alarm 10860)"
)
GROUP_01 = "G80 ends the cycle: G{}, which was in force before it, is in force again"
_UNITS_IN_MARK = re.compile(r"\bG\d", re.IGNORECASE)  # some controls give the unit beside the program's name


EXACT = "LinuxCNC drills in exact path mode: G61 is put in before the holes, and the G64 of the program behind them"
EXACT_SINCE = (
    "the program does not say its path mode (G61, G64 P) before this cycle, which LinuxCNC drills in exact path mode: "
    "G61 stays in force after it, as the mode and tolerance of the control are not known"
)
MODE_NOTES = {
    "inch": "no G20 or G21 before this motion: it is read in mm, and is wrong on a control that starts in inches",
    "absolute": "no G90 or G91 before this motion: it is read as G90, and is wrong on a control that starts in G91",
}


class ModeReader:
    """Follows the modes of one program in its state."""

    def __init__(self, state: NcState, settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._state, self._settings, self._faults, self._notes = state, settings, faults, notes

    def mark(self, number: int, text: str) -> None:
        """A line that is empty or begins with %."""
        state = self._state
        if text.startswith("%"):
            state.percents += 1
            if state.percents == 2 and not state.ended:
                state.ended = number
            name = text[1:]
            if not re.fullmatch(r"[\w .\-()]*", name, re.ASCII) or _UNITS_IN_MARK.search(name):
                self._faults.add(number, f"{text[:20]!r} is no program mark")

    def take(self, number: int, meaning: Meaning) -> None:
        """Take in what a block sets."""
        state = self._state
        if meaning.motion is not None:
            state.motion, state.cycle = meaning.motion, None
        if meaning.cancel_cycle:
            self._end_cycle(number, meaning)
        if meaning.plane is not None:
            state.plane = meaning.plane
        if meaning.inch is not None:
            keep_rounding(state, meaning.inch, self._settings.undotted)
            state.inch = meaning.inch
            state.said.add("inch")
        if meaning.absolute is not None:
            state.absolute = meaning.absolute
            state.said.add("absolute")
        if meaning.at_initial_level is not None:
            state.at_initial_level = meaning.at_initial_level
        self._feed(meaning)
        if self._settings.dialect == "linuxcnc":
            state.path.take(meaning.codes, meaning.parameters, state.inch)
        if meaning.program_number and state.moved and not meaning.complaints:
            self._faults.add(number, "a program number after motions: subprograms are not followed")
        for code in meaning.miscellaneous:
            if m_codes.vouched_for(code, self._settings.pass_m):
                self._notes.pass_code(number, code)
            if code in m_codes.SPINDLE:
                state.spindle = m_codes.spindle_of(code)

    def _end_cycle(self, number: int, meaning: Meaning) -> None:
        """G80. On Fanuc it is of another group than G0 and G1, of which the one before the cycle is in force again; on
        LinuxCNC no motion is.
        """
        state = self._state
        motion = meaning.motion
        if motion is None and self._settings.dialect == "fanuc":
            motion = state.motion if state.cycle is None else state.before_cycle
            motion = motion if motion in (0, 1) else None
            if state.cycle is not None and motion is not None:
                self._notes.add(number, GROUP_01.format(motion))
        state.motion, state.in_force, state.cycle = motion, meaning.motion, None

    def _feed(self, meaning: Meaning) -> None:
        state = self._state
        if meaning.feed_mode and meaning.feed_mode != state.feed_mode:
            state.feed_mode, state.feed, state.fed = meaning.feed_mode, math.nan, meaning.feed_mode == "time"
        if meaning.feed is not None:
            state.feed = meaning.feed * (MM_PER_INCH if state.inch else 1.0)
            state.fed = state.fed or state.feed > 0.0

    @property
    def rounds(self) -> bool:
        """Whether the path mode that LinuxCNC drills in is not in force."""
        return self._settings.dialect == "linuxcnc" and self._state.path.rounds

    def drill_exactly(self, number: int) -> str:
        """The block that holes written out for LinuxCNC need before them, for the path mode that it drills in."""
        if not self.rounds:
            return ""
        path = self._state.path
        self._notes.add(number, EXACT if path.code else EXACT_SINCE)
        path.in_cycle = True
        return "G61"

    def known_numbers(self, number: int, meaning: Meaning) -> None:
        """See to what numbers without a decimal point count."""
        if not meaning.undotted:
            return
        if self._settings.undotted == "least-increment":
            meaning.count_in_least_increments(self._state.inch)
        elif self._settings.undotted is None:
            self._faults.add_undotted(number, meaning.undotted)

    def note_unsaid(self, number: int, feeds: bool) -> None:
        """Note modes that the program has not stated before its first motion; feeds: whether the block moves at F."""
        if feeds:
            note_unfed(number, self._state, self._notes)
        if not self._state.moved:
            for mode, text in MODE_NOTES.items():
                if mode not in self._state.said:
                    self._notes.warn(number, text)


def note_unfed(number: int, state: NcState, notes: Notes) -> None:
    """Note the first feed motion without F."""
    if not state.fed:
        state.fed = True
        notes.add(number, UNFED)


def codes_in_force(state: NcState) -> set[int]:
    """G codes (whole ones) of the plane, the distances, the units and of how F counts that change nothing now."""
    found = {state.plane // 10, {"minute": 94, "time": 93, "turn": 95}[state.feed_mode]}
    if "absolute" in state.said:
        found.add(90 if state.absolute else 91)
    if "inch" in state.said:
        found.add(20 if state.inch else 21)
    return found


def keep_rounding(state: NcState, inch: bool, integers: Integers | None) -> None:
    """Before a change of units: keep what is needed of the numbers written in the old ones."""
    if inch != state.inch:
        state.numbers = [half_unit_of([number], state.inch, integers) if number else None for number in state.numbers]


def undotted_decimals(inch: bool, integers: Integers | None) -> int:
    """Decimals that a number without a decimal point stands for."""
    return 0 if integers != "least-increment" else 4 if inch else 3


def half_unit_of(numbers: Sequence[str | float | None], inch: bool, integers: Integers | None) -> float:
    """Half a unit, mm, of the longest of the numbers that gave positions; 0 where no word did."""
    undotted = undotted_decimals(inch, integers)
    counts = [
        undotted if (count := decimals_of(number)) is None else count for number in numbers if isinstance(number, str)
    ]
    known = [number for number in numbers if isinstance(number, float)]
    return max([*known, *([float(half_unit(max(counts), inch))] if counts else [])], default=0.0)


NOTE = (
    "tool centre point control: X Y Z are those of the tip, in the workpiece frame that turns with the table, and the "
    "control's kinematics are taken to be the ideal ones of the spec"
)


def switch(
    number: int, wanted: bool | None, state: NcState, settings: Settings, faults: FaultLog, notes: Notes
) -> list[Item]:
    """Take in what a block says of point control; None: nothing. Returns what is not known any more.

    Positions before and after name the same place only where all rotary axes stand at 0.
    """
    if wanted is None or wanted == state.point_control:
        return []
    rotary = [row for row, axis in enumerate(state.axes) if axis not in LINEAR]
    if not rotary:
        faults.add(number, "tool centre point control, but this machine has no rotary axis")
    if settings.orientation == "correct":
        faults.add(
            number, "tool centre point control with --orientation correct is not followed", "say --orientation keep"
        )
    state.point_control = wanted
    notes.add(number, NOTE)
    if all(state.position[row] == 0.0 for row in rotary):
        return []
    return [state.lose([row for row, axis in enumerate(state.axes) if axis in LINEAR])]
