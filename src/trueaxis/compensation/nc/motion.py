"""The motion of an NC block: rapid, line or arc, in the frame in force or in machine coordinates; G28 and G30."""

import math

from trueaxis.compensation.arcs import (
    Arc,
    ArcError,
    Vector,
    allowed_about,
    allowed_beyond_radius,
    arc_about,
    arc_of_radius,
    rounding_of,
)
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.machine import LINEAR
from trueaxis.compensation.moves import Item, Kind, Move, Notes, Round, Start
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.lexer import REPLACED, Block, Meaning, block_text
from trueaxis.compensation.nc.modes import ModeReader, half_unit_of
from trueaxis.compensation.nc.rotary_ways import turned_round
from trueaxis.compensation.nc.state import Commanded, NcState, missing_axes, starts_elsewhere, unknown_position
from trueaxis.compensation.nc.tool_codes import ToolReader
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_STRAIGHT = (Kind.RAPID, Kind.LINE)
MACHINE_COORDINATES = (
    "a block in machine coordinates: the other blocks are read so too, and no work offset may be active"
)
MACHINE_FEED = "some controls make a block in machine coordinates at rapid even under G1"


KEPT = "a motion in machine coordinates is left as it is (--keep-g53)"


def in_its_frame(move: Move, text: str, settings: Settings, frames: FrameReader, notes: Notes) -> list[Item]:
    """A move with what is to be said of machine coordinates around it; text: its block where it stays as it is, and the
    axes that it names then stand uncompensated.
    """
    if not move.in_machine:
        return [move]
    if not settings.keep_g53:
        return frames.apart([move])
    notes.add(move.line, KEPT)
    notes.kept += 1
    return [text, Start(tuple(end if named else None for end, named in zip(move.end, move.written, strict=True)))]


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

    def block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """The move of a block in its frame, or its text if it has none; again: the switch of an optional block."""
        if meaning.in_machine_coordinates:
            self._state.enter_frame(machine=True)
        before = self._state.position
        move = self._move(number, line, body, block, meaning, again)
        if meaning.in_machine_coordinates:
            self._state.enter_frame()
        if move is None:
            return [line]
        words = [body[word.start : word.end] for word in block.words if word.letter in meaning.axes]
        text = move.source or f"{move.lead}{move.gap.join(words)}{move.tail}{move.eol}"
        turned = turned_round(number, before, self._state, meaning.turning, self._faults)
        if meaning.turning and self._settings.orientation == "correct":
            self._faults.add(number, "DC, ACP or ACN with --orientation correct", "say --orientation keep")
        return [*turned, *in_its_frame(move, text, self._settings, self._frames, self._notes)]

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
        self._modes.note_unsaid(number, feeds=bool(state.motion))
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
        elif sum(word.letter in REPLACED for word in block.words) > 1:
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
            meaning.in_machine_coordinates,
            tuple(meaning.turning.get(axis, "") for axis in self._axes) if meaning.turning else (),
        )  # fmt: skip

    def _may_move(self, number: int, meaning: Meaning) -> bool:
        """Whether positions mean a motion here; a fault if they do not."""
        state = self._state
        if state.motion is None:
            self._faults.add(
                number, "a position, but no motion (G0 G1 G2 G3) is in force", "put the G code in the block"
            )
        elif meaning.in_machine_coordinates and (state.motion > 1 or not state.absolute):
            words = "G53, G153 and SUPA go" if self._settings.dialect == "siemens" else "G53 goes"
            self._faults.add(number, f"{words} with G0 or G1 and G90 only", "write the block so")
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
                self._notes.warn(number, MACHINE_COORDINATES)
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
        self._faults.add(number, *unknown_position(self._state, missing))
        self._state.position = [0.0 if value is None else value for value in end]  # said once


_CENTRE_OF = dict(zip("XYZ", "IJK", strict=True))


def arc_of_block(
    state: NcState, start: tuple[float, ...], end: tuple[float, ...], meaning: Meaning, settings: Settings
) -> Arc:
    """The arc from start to end (axis positions, mm and deg) in the plane in force.

    state: before the block but for its modes. settings: what numbers without a decimal point count, and
    whether an interpreter has judged the arc.
    Raises ArcError when the words make none.
    """
    integers, judged = settings.undotted, settings.judged
    first, second, across = codes.PLANES[state.plane]
    if not {first, second} <= set(state.axes):
        raise ArcError(f"the plane {first}{second} of the arc is not one of this machine's")
    turns = meaning.parameters.get("P", 1.0)
    if set(meaning.parameters) - ({"P"} if meaning.turns else set()) or turns < 1.0 or turns != int(turns):
        raise ArcError(f"{' '.join(sorted(meaning.parameters))} in the block of an arc: turns of it are not followed")
    sense = 1.0 if state.motion == 3 else -1.0
    normal = (sense * (across == "X"), sense * (across == "Y"), sense * (across == "Z"))
    a, b = _linear(state, start), _linear(state, end)
    x, y, z = (p if axis == across else q for p, q, axis in zip(a, b, LINEAR, strict=True))
    flat: Vector = (x, y, z)
    given = [state.numbers[state.row[axis]] for axis in (first, second)]
    before = half_unit_of(given, state.inch, integers)
    in_plane = [axis != across for axis in LINEAR]
    rounding = rounding_of(in_plane, max(meaning.decimals.values(), default=0), before, state.absolute, state.inch)
    scale = MM_PER_INCH if state.inch else 1.0
    if meaning.radius is not None:
        if meaning.centre:
            raise ArcError("an arc has either R or I J K")
        return arc_of_radius(a, b, meaning.radius * scale, normal, allowed_beyond_radius(a, flat, rounding))
    if meaning.centre.get(_CENTRE_OF[across]) or meaning.ways.get(_CENTRE_OF[across]):
        raise ArcError(f"{_CENTRE_OF[across]} points out of the plane {first}{second} in force")
    if not meaning.centre:
        raise ArcError("an arc without I J K or R")
    if turns > 1.0 and meaning.radius is not None:
        raise ArcError("turns of an arc by R")
    x, y, z = (_centre(state, meaning, axis, p, scale) for p, axis in zip(a, LINEAR, strict=True))
    allowed = math.inf if judged else allowed_about(a, flat, (x, y, z), rounding)
    arc = arc_about(a, b, (x, y, z), normal, allowed)
    return arc._replace(sweep=arc.sweep + 2.0 * math.pi * (turns - 1.0))


def _centre(state: NcState, meaning: Meaning, axis: str, start: float, scale: float) -> float:
    """Position of the centre along an axis, mm; start: that of the start."""
    letter = _CENTRE_OF[axis]
    if not meaning.ways.get(letter):
        return start + scale * meaning.centre.get(letter, 0.0)
    shift = state.shift[state.row[axis]] if state.shift and axis in state.row else 0.0
    return scale * meaning.centre[letter] + shift


def _linear(state: NcState, position: tuple[float, ...]) -> Vector:
    x, y, z = (position[state.row[axis]] if axis in state.row else 0.0 for axis in LINEAR)
    return (x, y, z)


AS_IT_IS = (
    "is left as it is: the point that it passes is not compensated, and each axis gets words again only once the "
    "program has commanded it"
)
BLANK = ", and it defines the blank (Heidenhain)"
NO_POINT = "where it leads is not known; the table [reference_points] of the spec can say"
_FIRST_OF_G30 = 2.0  # P of the second reference point, which G30 without P means too


def to_reference(
    number: int, meaning: Meaning, state: NcState, settings: Settings, faults: FaultLog, notes: Notes
) -> list[Start]:
    """Take in a motion to a reference point, whose text stays; returns where the axes then stand."""
    name = f"G{(meaning.data_code or 0) // 10}"
    axes = [axis for axis in state.axes if axis in meaning.data]
    if not axes and settings.dialect == "linuxcnc":
        axes = list(state.axes)
    if not axes:
        blank = BLANK if meaning.data_code == codes.TO_SECOND_REFERENCE else ""
        faults.add(
            number, f"{name} without axis words: which axes move differs by control{blank}", f"{name} Z0 under G91"
        )
        return []
    other = (
        meaning.data_code == codes.TO_SECOND_REFERENCE and meaning.parameters.get("P", _FIRST_OF_G30) != _FIRST_OF_G30
    )
    point = {} if other else settings.reference_points.get(name, {})
    lost = [state.row[axis] for axis in axes if axis not in point]
    notes.add(number, f"{name} {AS_IT_IS}")
    notes.kept += 1
    if lost:
        notes.add(number, f"{name} {' '.join(state.axes[row] for row in lost)}: {NO_POINT}")
    stands: list[float | None] = [None] * len(state.axes)
    position = state.position.copy()
    for axis in axes:
        row = state.row[axis]
        position[row] = point.get(axis)
        stands[row] = point.get(axis, math.nan)
    state.position = position
    state.lost.update(lost)
    state.commanded.lose(lost)
    state.commanded.name([state.row[axis] for axis in axes if axis in point], Commanded.BY_INCREMENTS)
    return [Start(tuple(stands))]
