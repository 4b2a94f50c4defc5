"""Canned cycles of an NC program, written out as rapids and lines."""

from collections.abc import Hashable, Iterator
from dataclasses import replace

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.move_notes import KEPT, OF_PECKS, STORED, notes_of_cycle
from trueaxis.compensation.moves import Item, KeptHole, Kind, Notes
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.canned_cycle import MOST_REPEATS, Cycle, peck_in_doubt, repeats_of, z_and_r
from trueaxis.compensation.nc.cycle_blocks import (
    DWELL,
    DWELLING,
    FEED,
    MOST_PECKS,
    RAPID,
    SPINDLE_START,
    SPINDLE_STOP,
    CycleError,
    CycleWriter,
    steps,
)
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.lexer import REPLACED, Block, Meaning, block_text
from trueaxis.compensation.nc.modes import ModeReader
from trueaxis.compensation.nc.run_holes import Hole
from trueaxis.compensation.nc.state import Commanded, NcState
from trueaxis.compensation.settings import Settings

OWN_WORDS = "G80 before it, or P and Q (0 for none) in the block"
WHOLE_PECK = "Q with a decimal point: without one some controls count it in steps of 0.001 mm whatever --integers says"


class CycleReader:
    """Reads the canned cycles of one program."""

    def __init__(
        self, state: NcState, settings: Settings, logs: tuple[FaultLog, Notes], modes: ModeReader, frames: FrameReader
    ) -> None:
        self._state, self._settings = state, settings
        self._faults, self._notes = logs
        self._modes, self._frames = modes, frames
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in state.axes]
        self._kept = codes.KEPT_CYCLES_ON.get(settings.dialect or "", frozenset[int]())
        self._begun = False  # whether a hole of the kept cycle in force has been made
        self._gone = frozenset[str]()  # P and Q of cycles that are written out: Fanuc has them in force until G80
        self._began_at: float | None = None  # Z before the first, to which the control goes back under G98

    def block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """The motions of a block while a canned cycle is in force; its text where it drills nothing."""
        cycle = self._cycle(body, block, meaning)
        if self._state.cycle is None:
            self._state.before_cycle, self._gone = self._state.motion, frozenset()
        said = frozenset("PQ") & {word.letter for word in block.words}
        self._gone = self._gone - said if cycle.code in self._kept else self._gone | said
        if self._state.cycle is None or self._state.cycle.code not in self._kept:
            self._begun = False
        self._state.cycle, self._state.motion = cycle, None
        named = set(meaning.axes)
        meaning.axes.pop(self._depth, None)
        nothing = not named and meaning.cycle is None and not (meaning.data or meaning.parameters or meaning.positions)
        if nothing or meaning.complaints:
            return [line]
        if problem := self._problem(cycle, named, meaning):
            self._faults.add(number, *problem)
            return [line]
        self._modes.note_unsaid(number, feeds=True)
        self._frames.note_first(number)
        if repeats_of(meaning.parameters, self._settings) == 0:
            return self._stored(number, line, body, block, meaning, again)
        if cycle.code in self._kept:
            return self._kept_hole(number, line, body, block, meaning, cycle)
        self.note_holes(number)
        writer = self._writer(number, line, body, block, again)
        if exact := self._modes.drill_exactly(number):
            writer.say(exact)
        self._holes(cycle, meaning, writer)
        return writer.finished()

    def _writer(self, number: int, line: str, body: str, block: Block, again: str) -> CycleWriter:
        text = (number, body, block, line[len(body) :], again)
        return CycleWriter(self._state, *text, self._assumed, self._faults, with_return=bool(self._kept))

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
        if (cycle.absolute, cycle.inch) != (state.absolute, state.inch) and not self._stay(cycle, meaning):
            cycle = replace(cycle, z=None, r=None, peck=0.0, absolute=state.absolute, inch=state.inch)
        texts = {word.letter: body[word.start + 1 : word.end].strip() for word in block.words}
        return replace(
            cycle,
            z=meaning.axes.get(self._depth, cycle.z),
            r=meaning.data.get("R", cycle.r),
            peck=meaning.parameters.get("Q", cycle.peck),
            whole_peck="Q" in meaning.undotted if "Q" in meaning.parameters else cycle.whole_peck,
            dwell=texts.get("P", cycle.dwell),
        )

    def _stay(self, cycle: Cycle, meaning: Meaning) -> bool:
        """Whether Z and R that were given under G90 keep their meaning under G91, as on Fanuc: G91 X20. K3 makes a row
        of holes. Elsewhere what they mean then differs by control.
        """
        given = self._depth in meaning.axes or "R" in meaning.data or "Q" in meaning.parameters
        return self._settings.dialect == "fanuc" and cycle.absolute and cycle.inch == self._state.inch and not given

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
        state, repeats, name = self._state, repeats_of(meaning.parameters, self._settings), cycle.name
        problems = (
            (not {"X", "Y", "Z"} <= state.row.keys(), f"{name} on a machine without X, Y and Z", "write it out"),
            (state.feed_mode == "time", f"{name} under G93", "G94"),
            (meaning.in_machine_coordinates, f"{name} in a block with G53", "the words of a cycle alone"),
            (bool(set(meaning.axes) - set("XYZ")), f"{name} with a rotary axis", "turn it in a block before"),
            (bool(meaning.centre), f"I or J in a block of {name}", "the words of a cycle alone"),
            (bool(meaning.uncertain_codes), f"{meaning.uncertain_codes} in a block of {name}", "a block of its own"),
            (not named, f"{name} without X, Y or Z: whether it drills differs by control", "X or Y in the block"),
            (
                cycle.z is None or cycle.r is None,
                f"{name} without Z and R",
                z_and_r(self._settings, state.absolute or state.cycle is None),
            ),
            (cycle.pecks and not cycle.peck > 0.0, f"{name} without Q above 0", "the depth of a peck"),
            (peck_in_doubt(cycle, self._settings), f"{name} Q{cycle.peck:g} is deeper than the hole", WHOLE_PECK),
            (repeats is None, f"L or K of {name} is no number of repeats", f"from 1 to {MOST_REPEATS}"),
            *self._kept_problems(cycle, repeats),
            (cycle.code == 860 and not state.spindle, "G86 while the spindle is not known to turn", "M3 or M4 before"),
            (state.frames.system == "", "which work offset is in force here is not known", "G54 in the program"),
        )
        return next(((problem, remedy) for wrong, problem, remedy in problems if wrong), None)

    def _kept_problems(self, cycle: Cycle, repeats: int | None) -> Iterator[tuple[bool, str, str]]:
        """What is wrong with a hole of a cycle that stays one."""
        if cycle.code in self._kept:
            state, name = self._state, cycle.name
            yield bool(self._gone), f"{name} after a cycle with P or Q, still in force", OWN_WORDS
            yield bool(repeats and repeats > 1), f"{name} with repeats", "a block for each hole"
            yield not state.absolute, f"{name} under G91", "G90, and a block for each hole"
            yield state.plane != 170, f"{name} in another plane than G17", "G17"
            yield state.point_control, f"{name} under tool centre point control", "end it before"
        elif self._kept and cycle.code in DWELLING and not cycle.dwell:
            yield "P" in self._gone, f"{cycle.name} after a cycle with P, still in force", OWN_WORDS

    def _levels(self, cycle: Cycle, meaning: Meaning) -> tuple[float, float, float]:
        """R, Z and where the cycle ends, machine coordinates, mm. Raises CycleError where they are not certain."""
        state, row = self._state, self._state.row[self._depth]
        scale = state.scale(self._depth)
        initial = cycle.initial if cycle.frame == self._frame() else None
        if cycle.absolute:
            shift = state.shift[row] if state.shift else 0.0
            r, bottom = (cycle.r or 0.0) * scale + shift, (cycle.z or 0.0) * scale + shift
        else:
            on_linuxcnc = self._settings.dialect == "linuxcnc"
            base = state.position[row] if on_linuxcnc else initial
            if base is None or state.commanded.of([row]) < Commanded.BY_INCREMENTS:
                raise CycleError(f"{cycle.name} under G91 from a Z that is not known", "G90, or command Z before")
            if meaning.cycle is None and not state.at_initial_level and not on_linuxcnc:
                raise CycleError(
                    f"{cycle.name} goes on under G91 and G99: what R counts from differs by control", "G98"
                )
            r = base + (cycle.r or 0.0) * scale
            bottom = r + (cycle.z or 0.0) * scale
        if not bottom < r or (cycle.pecks and (r - bottom) / (cycle.peck * scale) > MOST_PECKS):
            raise CycleError(f"{cycle.name}: Z is not below R, or Q is too small", "R above Z")
        if state.at_initial_level and initial is None:
            raise CycleError(
                f"{cycle.name} goes back to a Z that the program has not commanded here (G98)",
                "command Z by G90 before, or G99",
            )
        return r, bottom, max(initial or r, r) if state.at_initial_level else r

    def _holes(self, cycle: Cycle, meaning: Meaning, writer: CycleWriter) -> None:
        """Write the motions of a block."""
        try:
            r, bottom, clear = self._levels(cycle, meaning)
        except CycleError as error:
            writer.fault(*error.args)
            return
        for _ in range(repeats_of(meaning.parameters, self._settings) or 1):
            if (level := self._level()) is not None and level < r:
                writer.go(Kind.RAPID, {self._depth: r})
            if not writer.across(meaning):
                return
            if self._level() != r:
                writer.go(Kind.RAPID, {self._depth: r})
            for what, z in self._steps(cycle, r, bottom, clear):
                if isinstance(what, str):
                    writer.say(what)
                else:
                    writer.go(what, {self._depth: z})

    def _stored(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """A block with K0 or L0: its words are stored, and nothing is drilled."""
        self._notes.add(number, STORED)
        rows = [self._state.row[axis] for axis in meaning.axes]
        writer = self._writer(number, line, body, block, again)
        items: list[Item] = [line] if self._state.cycle and self._state.cycle.code in self._kept else writer.alone()
        if not rows:
            return items
        return [*items, self._state.lose(rows)]  # whether they are gone to differs by control

    def _kept_hole(self, number: int, line: str, body: str, block: Block, meaning: Meaning, cycle: Cycle) -> list[Item]:
        """A hole that the control makes by its own cycle, at corrected words."""
        state, row = self._state, self._state.row[self._depth]
        end = state.after(meaning.axes)
        rows = [state.row[axis] for axis in "XYZ"]
        known = state.commanded.of(one for one in rows if state.axes[one] not in meaning.axes)
        if known < Commanded.ABSOLUTE or None in end:
            self._faults.add(number, f"{cycle.name} where X, Y or Z is not certain", "command all by G90 G0 before")
            return [line]
        try:
            r, bottom, clear = self._levels(cycle, meaning)
            level = self._began_at if self._begun else self._level()
            if clear not in (r, level):
                raise CycleError(f"{cycle.name} goes back to where another cycle began", "G80 before it, and Z")
        except CycleError as error:
            self._faults.add(number, *error.args)
            return [line]
        at = [value or 0.0 for value in end]
        begins, self._begun, self._began_at = not self._begun, True, level
        if " " in body or "\t" in body:
            state.gap = " "
        elif sum(word.letter in REPLACED for word in block.words) > 1:
            state.gap = ""
        text = block_text(body, block.words, state.gap, False, False)
        state.position = [clear if one == row else value for one, value in enumerate(at)]
        state.commanded.command([one in rows for one in range(len(at))], True)
        state.moved, state.in_force = True, None
        self._notes.add(number, KEPT.format(cycle.name))
        at[row] = bottom
        return [
            KeptHole(
                number, tuple(at), r, clear, begins, clear != r, state.shift, state.inch, text.lead, text.tail,
                state.gap, line[len(body) :],
            )
        ]  # fmt: skip

    def _steps(self, cycle: Cycle, r: float, bottom: float, clear: float) -> Iterator[tuple[Kind | str, float]]:
        """What is done in a hole from R on: motions of the axis that drills, with their ends, and blocks between."""
        said = {DWELL: f"G4{self._state.gap}P{cycle.dwell}", SPINDLE_STOP: "M5", SPINDLE_START: self._state.spindle}
        peck = (cycle.peck * self._state.scale(self._depth), self._settings.peck_return)
        for what, z in steps(cycle.code, r, bottom, clear, peck, bool(cycle.dwell)):
            yield (Kind.LINE if what == FEED else Kind.RAPID if what == RAPID else said[what]), z

    def further(self) -> Hole | None:
        """What further holes of the cycle are, by X and Y; None where each is to be looked at."""
        state, cycle = self._state, self._state.cycle
        if (
            cycle is None
            or cycle.code in self._kept
            or self._modes.rounds
            or not state.absolute
            or not cycle.absolute
            or cycle.inch != state.inch
            or self._problem(cycle, {"X"}, Meaning())
        ):
            return None
        try:
            r, bottom, clear = self._levels(cycle, Meaning())
        except CycleError:
            return None
        if self._level() != clear:
            return None
        down: list[tuple[Kind | str, float]] = [(Kind.RAPID, r)] if clear != r else []
        words = {self._depth: cycle.z or 0.0, "R": cycle.r or 0.0}
        if cycle.peck > 0.0 and not cycle.whole_peck:
            words["Q"] = cycle.peck
        return Hole(
            depth=state.row[self._depth], level=clear, steps=(*down, *self._steps(cycle, r, bottom, clear)),
            code=cycle.code // 10, words=words, returns=98 if state.at_initial_level else 99,
            says_return=bool(self._kept),
            begins_again="P" not in self._gone and not (cycle.dwell or state.path.in_cycle or cycle.whole_peck),
        )  # fmt: skip

    def note_holes(self, number: int, holes: int = 1) -> None:
        """Note holes that are written out, from a line on."""
        if (cycle := self._state.cycle) is not None:
            for text in notes_of_cycle(cycle, self._settings):
                (self._notes.warn if text in OF_PECKS else self._notes.add)(number, text, holes)
