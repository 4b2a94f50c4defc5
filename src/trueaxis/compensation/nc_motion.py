"""The motion of an NC block: rapid, line or arc, in the frame in force or in machine coordinates."""

from trueaxis.compensation import nc_codes as codes
from trueaxis.compensation.arcs import ArcError
from trueaxis.compensation.commanded import Commanded
from trueaxis.compensation.fault_log import FaultLog
from trueaxis.compensation.moves import Item, Kind, Move, Notes, Round
from trueaxis.compensation.nc_arc import arc_of_block
from trueaxis.compensation.nc_frames import FrameReader
from trueaxis.compensation.nc_lexer import Block
from trueaxis.compensation.nc_meaning import Meaning
from trueaxis.compensation.nc_modes import ModeReader
from trueaxis.compensation.nc_start import missing_axes, starts_elsewhere, unknown_position
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.nc_text import block_text
from trueaxis.compensation.nc_tools import ToolReader
from trueaxis.compensation.settings import Settings

_STRAIGHT = (Kind.RAPID, Kind.LINE)
MACHINE_COORDINATES = (
    "a G53 block: the blocks without G53 are read in machine coordinates too, so no offset may be active"
)
MACHINE_FEED = "some controls make a G53 block at rapid even under G1"


class MotionReader:
    """Reads the motions of one program."""

    def __init__(
        self,
        state: NcState,
        settings: Settings,
        logs: tuple[FaultLog, Notes],
        readers: tuple[ModeReader, ToolReader, FrameReader],
    ) -> None:
        self._axes, self._state, self._settings = state.axes, state, settings
        self._faults, self._notes = logs
        self._modes, self._tools, self._frames = readers
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in state.axes]  # where axes are until they are known

    def block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> Item:
        """The move of a block in its frame, or its text if it has none; again: the switch of an optional block."""
        if meaning.in_machine_coordinates:
            self._state.enter_frame(machine=True)
        move = self._move(number, line, body, block, meaning, again)
        if meaning.in_machine_coordinates:
            self._state.enter_frame()
        return line if move is None else move

    def _move(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> Move | None:
        if not meaning.positions or meaning.complaints or not self._may_move(number, meaning):
            self._stay(meaning)
            return None
        state = self._state
        start, end = state.position, state.after(meaning.axes, meaning.ways)
        moved = {*meaning.axes, *(codes.PLANES[state.plane][:2] if state.motion in (2, 3) else ())}
        if missing := missing_axes(state, start, end, moved):
            self._unknown(number, missing, end)
            return None
        self._modes.note_unsaid(number)
        commands = tuple(axis in moved for axis in self._axes)  # an arc puts both axes of its plane where it ends
        own_block = f"and give {meaning.uncertain_codes} a block of its own" if meaning.changes_tool else ""
        elsewhere = starts_elsewhere(number, state, commands, own_block or self._tools.remedy, self._faults)
        state.position = end
        known_end = tuple(self._assumed[row] if value is None else value for row, value in enumerate(end))
        arc = None
        if state.motion in (2, 3):
            try:
                known_start = tuple(self._assumed[row] if value is None else value for row, value in enumerate(start))
                arc = arc_of_block(state, known_start, known_end, meaning, self._settings)
            except ArcError as problem:
                self._faults.add(number, str(problem))
                return None
        motion = 0 if state.motion == 0 else 1
        in_force = meaning.motion if meaning.motion is not None else state.in_force
        insert = meaning.motion is None and in_force != motion
        if " " in body or "\t" in body:
            state.gap = " "
        elif len(block.words) > 1:
            state.gap = ""
        timed = state.feed_mode == "time" and motion == 1
        text = block_text(body, block.words, state.gap, insert, motion == 1, timed, turns=arc is not None)
        rounded = None
        if arc is not None and self._settings.arcs == "keep":
            code = f"G{state.motion}"
            kept = block_text(body, block.words, state.gap, meaning.motion is None, True, timed, code, turns=True)
            by_radius = meaning.radius is not None
            rounded = Round(
                kept.lead, kept.split.lead if kept.split else kept.lead, code + state.gap, "G1" + state.gap,
                "radius" if by_radius else "centre", "CR=" if self._settings.dialect == "siemens" else "R",
            )  # fmt: skip
        # an arc that stays one is in force afterwards, and lines that it becomes are not
        state.in_force, state.moved = None if arc else motion, True
        for word in block.words:
            if word.letter in meaning.axes:
                state.numbers[state.row[word.letter]] = body[word.start + 1 : word.end].strip()
        written = tuple(axis in meaning.axes for axis in self._axes)
        return Move(
            number, Kind.ARC if arc else _STRAIGHT[motion], known_end, written, state.absolute, state.inch,
            text.lead, text.tail, state.gap, line[len(body) :], "" if arc or insert else line,
            again + (f"G53{state.gap}" if meaning.in_machine_coordinates else ""), text.split, arc,
            not meaning.miscellaneous and not meaning.exact_stop, state.feed_in_minutes,
            state.commanded.command(commands, state.absolute), state.commanded.elsewhere, state.commanded.unnamed,
            state.shift, elsewhere, meaning.uncertain_codes, (meaning.feed or 0.0) if timed else 0.0, rounded,
        )  # fmt: skip

    def _may_move(self, number: int, meaning: Meaning) -> bool:
        """Whether positions mean a motion here; a fault if they do not."""
        state = self._state
        if state.motion is None:
            self._faults.add(
                number, "a position, but no motion (G0 G1 G2 G3) is in force", "put the G code in the block"
            )
        elif meaning.in_machine_coordinates and (state.motion > 1 or not state.absolute):
            self._faults.add(number, "G53 goes with G0 or G1 and G90 only", "write the block so")
        elif state.frames.system == "" and not meaning.in_machine_coordinates:
            self._faults.add(
                number,
                "which work offset is in force here is not known",
                "G54 in the program, or --offset G54=X..,Y..,Z..",
            )
        elif self._other_way(meaning):
            self._faults.add(
                number, "AC or IC, other than G90 or G91 in force, of an axis whose position is not certain here",
                "command the axis by G90 first",
            )  # fmt: skip
        elif state.motion and state.feed_mode == "time" and not (meaning.feed or 0.0) > 0.0:
            self._faults.add(number, "a feed motion under G93 without F above 0", "F in each block")
        elif state.motion < 2 and (meaning.centre or meaning.radius is not None):
            self._faults.add(number, f"I J K R belong to arcs, but G{state.motion} is in force")
        else:
            if not meaning.in_machine_coordinates:
                self._frames.note_first(number)
            elif state.motion:
                self._notes.add(number, MACHINE_FEED)
            elif state.frames.system is None and not state.frames.shift:
                self._notes.add(number, MACHINE_COORDINATES)
            return True
        return False

    def _other_way(self, meaning: Meaning) -> bool:
        """Whether a word counts otherwise than the mode in force, and its axis may stand elsewhere."""
        state = self._state
        other = [state.row[axis] for axis, way in meaning.ways.items() if axis in state.row and way != state.absolute]
        return bool(other) and state.commanded.of(other) < Commanded.ABSOLUTE

    def _stay(self, meaning: Meaning) -> None:
        """After a block without a usable move: what it sets, and where it would have gone, to read on sensibly."""
        if meaning.motion is not None:
            self._state.in_force = meaning.motion
        if meaning.axes and meaning.complaints and self._state.absolute:
            self._state.position = self._state.after(meaning.axes)

    def _unknown(self, number: int, missing: list[int], end: list[float | None]) -> None:
        self._faults.add(number, *unknown_position(" ".join(self._axes[row] for row in missing)))
        self._state.position = [0.0 if value is None else value for value in end]  # said once
