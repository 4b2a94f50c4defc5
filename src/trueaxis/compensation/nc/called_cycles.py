"""Cycles that a SINUMERIK program calls, CYCLE81, CYCLE82 and CYCLE83, written out as rapids and lines."""

from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.move_notes import DEEP_WRITTEN_OUT, WRITTEN_OUT
from trueaxis.compensation.moves import Item, Kind, Notes
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.canned_cycle import DrillingCall
from trueaxis.compensation.nc.cycle_blocks import DWELL, FEED, CycleWriter
from trueaxis.compensation.nc.drilling_call import DEEP, motions
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.lexer import Block, Meaning
from trueaxis.compensation.nc.modes import note_unfed
from trueaxis.compensation.nc.state import Commanded, NcState
from trueaxis.compensation.settings import Settings


class CallReader:
    """Reads the calls of one program."""

    def __init__(self, state: NcState, settings: Settings, logs: tuple[FaultLog, Notes], frames: FrameReader) -> None:
        self._state, self._frames = state, frames
        self._faults, self._notes = logs
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in state.axes]

    def take(self, number: int, line: str, body: str, call: DrillingCall, again: str) -> list[Item]:
        """A block with a call: the hole where the axes stand, or none yet; the call itself is left out."""
        self._state.call = call if call.modal else None
        if not call.depths:
            return [line]
        eol = line[len(body) :] or "\n"
        items: list[Item] = [f"; {body.strip()}{eol}"]
        return items if call.modal else [*items, *self._hole(number, eol, call, again)]

    def after(self, number: int, line: str, body: str, meaning: Meaning, again: str) -> list[Item]:
        """The hole behind a block that moves while a call is in force."""
        call = self._state.call
        if call is None or not meaning.positions or meaning.complaints:
            return []
        if meaning.in_machine_coordinates or m_codes.END.intersection(meaning.miscellaneous):
            self._faults.add(
                number,
                "machine coordinates, or the end of the program, while MCALL calls a cycle",
                "MCALL alone before",
            )
            return []
        eol = line[len(body) :]
        return [*([] if eol else ["\n"]), *self._hole(number, eol or "\n", call, again)]

    def _hole(self, number: int, eol: str, call: DrillingCall, again: str) -> list[Item]:
        """The motions of a cycle where the axes stand; the modes of the program are as before."""
        state = self._state
        axis = codes.PLANES[state.plane][2]
        if problem := self._problem(axis, call):
            self._faults.add(number, *problem)
            return []
        row = state.row[axis]
        shift, scale = (state.shift[row] if state.shift else 0.0), state.scale(axis)
        motion = state.motion
        note_unfed(number, state, self._notes)
        self._notes.add(number, WRITTEN_OUT)
        if call.name == DEEP:
            self._notes.add(number, DEEP_WRITTEN_OUT)
        self._frames.note_first(number)
        writer = CycleWriter(
            state, number, "", Block((), ""), eol, again, self._assumed, self._faults, with_return=False
        )
        for what, end, words in motions(call, scale):
            if what == DWELL:
                writer.say(f"G4 {words}")
            else:
                writer.go(Kind.LINE if what == FEED else Kind.RAPID, {axis: end * scale + shift})
        state.motion = motion
        return writer.finished()

    def _problem(self, axis: str, call: DrillingCall) -> tuple[str, str] | None:
        """What is wrong with a hole here; axis: which drills."""
        state = self._state
        across = [state.row[other] for other in "XYZ" if other in state.row and other != axis]
        problems = (
            (not {"X", "Y", "Z"} <= state.row.keys(), "a cycle on a machine without X, Y and Z", "write it out"),
            (
                call.axis not in ("", axis), f"a cycle along {call.axis} (_AXN) in a plane across {axis}",
                f"_AXN 0, or the plane across {call.axis}",
            ),
            (state.feed_mode == "time", "a cycle under G93", "G94"),
            (state.point_control, "a cycle under tool centre point control", "end it before"),
            (state.frames.system == "", "which work offset is in force here is not known", "G54 in the program"),
            (
                state.commanded.of(across) < Commanded.ABSOLUTE,
                "a cycle where the program has not commanded the axes across it", "command them by G90 G0 before",
            ),
        )  # fmt: skip
        return next(((problem, remedy) for wrong, problem, remedy in problems if wrong), None)
