"""Canned cycles of an NC program, written out as rapids and lines."""

from collections.abc import Hashable
from dataclasses import replace

from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.canned_cycles import (
    CLEARANCE,
    DWELL,
    FEED,
    MOST_PECKS,
    RAPID,
    SPINDLE_START,
    SPINDLE_STOP,
    Cycle,
    steps,
)  # fmt: skip
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.moves import Item, Kind, Move, Notes
from trueaxis.compensation.nc_frames import FrameReader
from trueaxis.compensation.nc_lexer import Block, Meaning, due_at_end
from trueaxis.compensation.nc_modes import ModeReader
from trueaxis.compensation.nc_state import Commanded, NcState, missing_axes, starts_elsewhere, unknown_position
from trueaxis.compensation.settings import Settings

MOST_REPEATS = 10_000
_OF_CYCLE = frozenset("XYZRQPLK")
_OUT = frozenset({*codes.CYCLES, 980, 990})  # codes that are not written with the motions
WRITTEN_OUT = "a canned cycle is written out as G0 and G1"
PECKS = f"pecks go back by {CLEARANCE:g} mm, as on LinuxCNC; on other controls a parameter says by how much"


class CycleReader:
    """Reads the canned cycles of one program."""

    def __init__(
        self, state: NcState, settings: Settings, logs: tuple[FaultLog, Notes], modes: ModeReader, frames: FrameReader
    ) -> None:
        self._state, self._settings = state, settings
        self._faults, self._notes = logs
        self._modes, self._frames = modes, frames
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in state.axes]

    def block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """The motions of a block while a canned cycle is in force; its text where it drills nothing."""
        cycle = self._cycle(body, block, meaning)
        self._state.cycle, self._state.motion = cycle, None
        named = set(meaning.axes)
        meaning.axes.pop(self._depth, None)
        if not named and meaning.cycle is None and not (meaning.data or meaning.parameters or meaning.positions):
            return [line]
        if meaning.complaints:
            return [line]
        if problem := self._problem(cycle, named, meaning):
            self._faults.add(number, *problem)
            return [line]
        self._modes.note_unsaid(number)
        self._frames.note_first(number)
        self._notes.add(number, WRITTEN_OUT)
        if cycle.pecks:
            self._notes.add(number, PECKS)
        writer = _Writer(self._state, number, body, block, line[len(body) :], again, self._assumed, self._faults)
        self._holes(cycle, meaning, writer)
        return writer.finished()

    @property
    def _depth(self) -> str:
        """The axis that drills: across the plane in force."""
        return codes.PLANES[self._state.plane][2]

    def _cycle(self, body: str, block: Block, meaning: Meaning) -> Cycle:
        """The cycle in force with the words of a block taken in."""
        state = self._state
        before = state.cycle or Cycle(code=0, z=None, r=None, initial=self._level(), frame=self._frame())
        cycle = before
        if meaning.cycle is not None and meaning.cycle != before.code:
            cycle = Cycle(code=meaning.cycle, z=before.z, r=before.r, initial=before.initial, frame=before.frame)
        if (cycle.absolute, cycle.inch) != (state.absolute, state.inch):  # what the words of before mean now differs
            cycle = replace(cycle, z=None, r=None, peck=0.0, absolute=state.absolute, inch=state.inch)
        texts = {word.letter: body[word.start + 1 : word.end].strip() for word in block.words}
        return replace(
            cycle,
            z=meaning.axes.get(self._depth, cycle.z),
            r=meaning.data.get("R", cycle.r),
            peck=meaning.parameters.get("Q", cycle.peck),
            dwell=texts.get("P", cycle.dwell),
        )

    def _level(self) -> float | None:
        """Where the drilling axis stands, mm, machine coordinates; None where no word could name that for certain."""
        row = self._state.row.get(self._depth)
        if row is None or self._state.commanded.of([row]) < Commanded.STOPPED:
            return None
        return self._state.position[row]

    def _frame(self) -> Hashable:
        """The frame of the axis that drills."""
        row = self._state.row.get(self._depth)
        return None if row is None else self._state.frames.ids[row]

    def _problem(self, cycle: Cycle, named: set[str], meaning: Meaning) -> tuple[str, str] | None:
        """What is wrong with a block of a cycle."""
        state = self._state
        repeats = self._repeats(meaning)
        name = cycle.name
        problems = (
            (not {"X", "Y", "Z"} <= state.row.keys(), f"{name} on a machine without X, Y and Z", "write it out"),
            (state.feed_mode == "time", f"{name} under G93", "G94"),
            (bool(set(meaning.axes) - set("XYZ")), f"{name} with a rotary axis", "turn it in a block before"),
            (bool(meaning.centre), f"I or J in a block of {name}", "the words of a cycle alone"),
            (bool(meaning.uncertain_codes), f"{meaning.uncertain_codes} in a block of {name}", "a block of its own"),
            (not named, f"{name} without X, Y or Z: whether it drills differs by control", "X or Y in the block"),
            (cycle.z is None or cycle.r is None, f"{name} without Z and R", "both where the cycle begins"),
            (cycle.pecks and not cycle.peck > 0.0, f"{name} without Q above 0", "the depth of a peck"),
            (repeats is None, f"L or K of {name} is no number of repeats", f"from 1 to {MOST_REPEATS}"),
            (cycle.code == 860 and not state.spindle, "G86 while the spindle is not known to turn", "M3 or M4 before"),
            (state.frames.system == "", "which work offset is in force here is not known", "G54 in the program"),
        )
        return next(((problem, remedy) for wrong, problem, remedy in problems if wrong), None)

    def _repeats(self, meaning: Meaning) -> int | None:
        count = meaning.parameters.get("L", meaning.parameters.get("K", 1.0))
        right = {"L", "K"} - meaning.parameters.keys() and count % 1 == 0 and 1 <= count <= MOST_REPEATS
        return int(count) if right else None

    def _levels(self, cycle: Cycle, meaning: Meaning, writer: "_Writer") -> tuple[float, float, float] | None:
        """R, Z and where the cycle ends, machine coordinates, mm; None after a fault."""
        state, row = self._state, self._state.row[self._depth]
        scale = state.scale(self._depth)
        initial = cycle.initial if cycle.frame == self._frame() else None
        if state.absolute:
            shift = state.shift[row] if state.shift else 0.0
            r, bottom = (cycle.r or 0.0) * scale + shift, (cycle.z or 0.0) * scale + shift
        else:
            on_linuxcnc = self._settings.dialect == "linuxcnc"
            base = state.position[row] if on_linuxcnc else initial
            if base is None or state.commanded.of([row]) < Commanded.BY_INCREMENTS:
                writer.fault(f"{cycle.name} under G91 from a Z that is not known", "G90, or command Z before")
                return None
            if meaning.cycle is None and not state.at_initial_level and not on_linuxcnc:
                writer.fault(f"{cycle.name} goes on under G91 and G99: what R counts from differs by control", "G98")
                return None
            r = base + (cycle.r or 0.0) * scale
            bottom = r + (cycle.z or 0.0) * scale
        if not bottom < r or (cycle.pecks and (r - bottom) / (cycle.peck * scale) > MOST_PECKS):
            writer.fault(f"{cycle.name}: Z is not below R, or Q is too small", "R above Z")
            return None
        if state.at_initial_level and initial is None:
            writer.fault(f"{cycle.name} goes back to a Z that the program has not commanded here (G98)",
                         "command Z by G90 before, or G99")  # fmt: skip
            return None
        return r, bottom, max(initial or r, r) if state.at_initial_level else r

    def _holes(self, cycle: Cycle, meaning: Meaning, writer: "_Writer") -> None:
        """Write the motions of a block."""
        state = self._state
        levels = self._levels(cycle, meaning, writer)
        if levels is None:
            return
        r, bottom, clear = levels
        peck = cycle.peck * state.scale(self._depth)
        for _ in range(self._repeats(meaning) or 1):
            level = self._level()
            if level is not None and level < r:
                writer.go(Kind.RAPID, {self._depth: r})
            if not writer.across(meaning):
                return
            if self._level() != r:
                writer.go(Kind.RAPID, {self._depth: r})
            for what, z in steps(cycle.code, r, bottom, clear, peck, bool(cycle.dwell)):
                if what in (RAPID, FEED):
                    writer.go(Kind.LINE if what == FEED else Kind.RAPID, {self._depth: z})
                else:
                    dwell = f"G4{state.gap}P{cycle.dwell}"
                    writer.say({DWELL: dwell, SPINDLE_STOP: "M5", SPINDLE_START: state.spindle}[what])


class _Writer:
    """Makes the blocks of one block of a cycle."""

    def __init__(
        self,
        state: NcState,
        number: int,
        body: str,
        block: Block,
        eol: str,
        again: str,
        assumed: list[float],
        faults: FaultLog,
    ) -> None:
        self._state, self._number, self._assumed, self._faults = state, number, assumed, faults
        self._eol, self._again = eol or "\n", again
        if " " in body or "\t" in body:
            state.gap = " "
        elif len(block.words) > 1:
            state.gap = ""
        self._lead, self._comment, self._last = _kept(body, block, state.gap, again)
        self._items: list[Item] = []
        self._wrong = False

    def fault(self, problem: str, remedy: str) -> None:
        """Note what is wrong."""
        self._wrong = True
        self._faults.add(self._number, problem, remedy)

    def finished(self) -> list[Item]:
        """The blocks."""
        if self._last and not self._wrong:
            self.say(self._last)
        return self._items

    def say(self, text: str) -> None:
        """A block that moves nothing."""
        self._items.append(f"{self._again}{text}{self._eol}")

    def across(self, meaning: Meaning) -> bool:
        """Over the hole, by the X and Y of the block; False after a fault."""
        if not meaning.axes:
            return True
        end = self._state.after(meaning.axes)
        if None in [end[self._state.row[axis]] for axis in meaning.axes]:
            self.fault(f"the position of {' '.join(meaning.axes)} is not known here", "G90 G0 in the program first")
            return False
        return self.go(Kind.RAPID, {axis: end[self._state.row[axis]] or 0.0 for axis in meaning.axes})

    def go(self, kind: Kind, ends: dict[str, float]) -> bool:
        """A straight motion of some axes, to machine positions, mm; False after a fault."""
        state = self._state
        end = list(state.position)
        for axis, value in ends.items():
            end[state.row[axis]] = value
        written = tuple(axis in ends for axis in state.axes)
        before = self._faults.count
        state.motion = int(kind)
        if kind != Kind.RAPID and (missing := missing_axes(state, state.position, end, set(ends))):
            state.motion = None
            if not self._wrong:
                self.fault(*unknown_position(" ".join(state.axes[row] for row in missing)))
            return False
        elsewhere = starts_elsewhere(self._number, state, written, "", self._faults)
        state.motion = None
        state.position, state.in_force, state.moved = end, int(kind), True
        lead = self._lead + ("G1" if kind else "G0") + state.gap
        held = state.commanded.command(written, state.absolute)
        self._items.append(
            Move(
                self._number,
                kind,
                tuple(self._assumed[row] if v is None else v for row, v in enumerate(end)),
                written,
                state.absolute,
                state.inch,
                lead,
                self._comment,
                state.gap,
                self._eol,
                "",
                self._again,
                passable=False,
                feed=state.feed_in_minutes,
                held=held,
                elsewhere=state.commanded.elsewhere,
                unnamed=state.commanded.unnamed,
                shift=state.shift,
                start_stated=elsewhere,
            )
        )
        self._lead, self._comment = self._again, ""
        return self._faults.count == before


def _kept(body: str, block: Block, gap: str, again: str) -> tuple[str, str, str]:
    """What stays of a block of a cycle: text before its first motion, comments behind it, words due at the end."""
    lead: list[str] = []
    last: list[str] = []
    comment, place = "", 0
    for word in block.words:
        between, place = body[place : word.start].strip(" \t").removeprefix(again), word.end
        comment += f" {between.strip()}" if between.strip() else ""
        if word.letter in _OF_CYCLE or (word.letter == "G" and round(word.value * 10) in _OUT):
            continue
        (last if due_at_end(word) else lead).append(body[word.start : word.end])
    comment += f" {body[place:].strip()}" if body[place:].strip() else ""
    head = gap.join(lead)
    return again + head + (gap if head else ""), comment, gap.join(last)
