"""Reads NC programs (ISO 6983-1, RS-274) block by block, following every mode that bears on positions.

What it does not follow is a fault of its line; nothing that could move an axis is passed over. What numbers without a
decimal point count is for `--integers` to say. A program says where its modes begin: until it does, G90 G21 G17.
"""

import math
import re
from collections.abc import Iterable, Iterator

from trueaxis.compensate import m_codes
from trueaxis.compensate import nc_codes as codes
from trueaxis.compensate.arcs import ArcError
from trueaxis.compensate.fault_log import FaultLog
from trueaxis.compensate.mark import COMPENSATED_ALREADY, is_marked
from trueaxis.compensate.moves import STOP, Item, Kind, Move, Notes, Start
from trueaxis.compensate.nc_arc import arc_of_block, keep_rounding
from trueaxis.compensate.nc_block import Meaning, interpret
from trueaxis.compensate.nc_frames import FrameReader
from trueaxis.compensate.nc_lexer import Block, lex
from trueaxis.compensate.nc_plain import PLAIN, plain_move
from trueaxis.compensate.nc_start import starts_elsewhere
from trueaxis.compensate.nc_state import MODE_NOTES, NcState
from trueaxis.compensate.nc_text import block_text
from trueaxis.compensate.nc_tools import ToolReader
from trueaxis.compensate.settings import MM_PER_INCH, Settings

_STRAIGHT = (Kind.RAPID, Kind.LINE)
_ALIGNMENT = re.compile(r":\d*+")  # ISO 6983-1: a block number that may stand alone as a program number
_OPTIONAL = re.compile(r"/[0-9]?")  # with the number of its switch: every piece of the block keeps it
_UNITS_IN_MARK = re.compile(r"\bG\d", re.IGNORECASE)  # some controls give the unit beside the program's name
MACHINE_COORDINATES = (
    "a G53 block: the blocks without G53 are read in machine coordinates too, so no offset may be active"
)
MACHINE_FEED = "some controls make a G53 block at rapid even under G1"
BYTE_ORDER_MARK = "\xef\xbb\xbf"  # of UTF-8, as latin-1


class NcReader:
    """Turns the lines of one program into items; faults and notes are gathered in the logs given."""

    def __init__(self, axes: tuple[str, ...], settings: Settings, faults: FaultLog, notes: Notes) -> None:
        self._axes = axes
        self._settings = settings
        self._faults = faults
        self._notes = notes
        self._undotted_said = False  # whether the fault of numbers without a decimal point is in the log
        self._assumed = [settings.assumed.get(axis, 0.0) for axis in axes]  # where axes are taken to stand until known
        self._state = NcState(axes, [settings.start.get(axis) for axis in axes], offsets=settings.offsets)
        self._tools = ToolReader(self._state, settings, faults, notes)
        self._frames = FrameReader(self._state, settings, faults, notes)

    def items(self, lines: Iterable[str]) -> Iterator[Item]:
        """Items of a program, in order; lines carry their ends, bytes as latin-1 characters."""
        if self._settings.start:
            yield Start(tuple(math.nan if value is None else value for value in self._state.position))
        yield from self._frames.changed()
        plain, state, undotted_mm = PLAIN.fullmatch, self._state, self._settings.undotted == "mm"
        for number, line in enumerate(lines, 1):
            match = plain(line)
            move = plain_move(number, line, match, state, undotted_mm) if match else None
            if move is not None:
                yield move
            else:
                yield from self._any(number, line)

    def _any(self, number: int, line: str) -> list[Item]:
        """Any block: what it sets, and its move if it has one."""
        if is_marked(line):
            self._faults.add(number, *COMPENSATED_ALREADY)
        body = line.rstrip("\r\n")
        begin = 3 if number == 1 and body.startswith(BYTE_ORDER_MARK) else 0
        text = body[begin:].strip()
        if not text or text[0] == "%":
            self._mark(number, text)
            return [line]
        lead = len(body) - len(body[begin:].lstrip(" \t"))
        aligned = _ALIGNMENT.match(body, lead)
        if aligned:
            lead = aligned.end()
        optional = _OPTIONAL.match(body, lead)
        if optional:
            if self._settings.block_delete == "skip":
                return [line]
            lead = optional.end()
        block = lex(body, lead)
        meaning = interpret(block, self._axes, self._settings)
        meaning.program_number |= aligned is not None and not block.words
        if optional and self._settings.block_delete == "fault" and (meaning.positions or meaning.changes_modes):
            meaning.complain(
                "whether this block with / is run depends on a switch", "say --block-delete run or --block-delete skip"
            )
        for problem, remedy in meaning.complaints:
            self._faults.add(number, problem, remedy)
        self._modes(number, meaning)
        self._known_numbers(number, meaning)
        self._tools.length(number, meaning)
        items = self._frames.select(number, meaning)
        if meaning.data_code == codes.GIVE_LENGTH:
            self._tools.data(number, meaning)
            items += [line, *self._frames.changed()]
        elif meaning.data_code is not None:
            items += self._frames.data(number, line, body, block, meaning)
        else:
            items.append(self._block(number, line, body, block, meaning, optional[0] if optional else ""))
        if meaning.changes_tool:  # after the motion too: controls do not agree which comes first
            self._state.commanded.displace()
        if m_codes.STOPS.intersection(meaning.miscellaneous):
            self._state.commanded.stop()
            self._notes.add(number, STOP)
        if not self._state.ended and m_codes.END.intersection(meaning.miscellaneous):
            self._state.ended = number
        return items

    def _block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> Item:
        """The move of a block in its frame, or its text if it has none."""
        if meaning.in_machine_coordinates:
            self._state.enter_frame(machine=True)
        move = self._move(number, line, body, block, meaning, again)
        if meaning.in_machine_coordinates:
            self._state.enter_frame()
        return line if move is None else move

    def _mark(self, number: int, text: str) -> None:
        state = self._state
        if text.startswith("%"):
            state.percents += 1
            if state.percents == 2 and not state.ended:
                state.ended = number
            name = text[1:]
            if not re.fullmatch(r"[\w .\-()]*", name, re.ASCII) or _UNITS_IN_MARK.search(name):
                self._faults.add(number, f"{text[:20]!r} is no program mark")

    def _modes(self, number: int, meaning: Meaning) -> None:
        state = self._state
        if meaning.motion is not None:
            state.motion = meaning.motion
        if meaning.cancel_cycle:
            state.motion = state.in_force = meaning.motion
        if meaning.plane is not None:
            state.plane = meaning.plane
        if meaning.inch is not None:
            keep_rounding(state, meaning.inch, self._settings.undotted)
            state.inch = meaning.inch
            state.said.add("inch")
        if meaning.absolute is not None:
            state.absolute = meaning.absolute
            state.said.add("absolute")
        state.per_turn = state.per_turn if meaning.per_turn is None else meaning.per_turn
        if meaning.feed is not None:
            state.feed = meaning.feed * (MM_PER_INCH if state.inch else 1.0)
        if meaning.program_number and state.moved and not state.ended:
            self._faults.add(number, "a program number after motions: subprograms are not followed")
        self._tools.change(number, meaning)
        for code in meaning.miscellaneous:
            if code in self._settings.pass_m and code not in m_codes.KNOWN:
                self._notes.pass_code(number, code)

    def _known_numbers(self, number: int, meaning: Meaning) -> None:
        """See to what numbers without a decimal point count."""
        if not meaning.undotted:
            return
        if self._settings.undotted == "least-increment":
            meaning.count_in_least_increments(self._state.inch)
        elif self._settings.undotted is None and not self._undotted_said:
            self._undotted_said = True
            letters = " ".join(sorted(meaning.undotted))
            self._faults.add(
                number,
                f"{letters} without a decimal point: X100 is 100 mm on some controls and 0.1 mm on others",
                "say --integers mm (or inch, deg) or --integers least-increment (0.001 mm, 0.0001 inch, 0.001 deg)",
            )

    def _move(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> Move | None:
        if not meaning.positions or meaning.complaints or not self._may_move(number, meaning):
            self._stay(meaning)
            return None
        state = self._state
        start, end = state.position, state.after(meaning.axes)
        needed = start + end if state.motion in (2, 3) else end
        if None in needed and (state.motion or None in [end[state.row[axis]] for axis in meaning.axes]):
            self._unknown(number, needed, end)
            return None
        self._note_modes(number)
        moved = {*meaning.axes, *(codes.PLANES[state.plane][:2] if state.motion in (2, 3) else ())}
        commands = tuple(axis in moved for axis in self._axes)  # an arc puts both axes of its plane where it ends
        own_block = f"and give {meaning.uncertain_codes} a block of its own" if meaning.changes_tool else ""
        elsewhere = starts_elsewhere(number, state, commands, own_block or self._tools.remedy, self._faults)
        state.position = end
        known_end = tuple(self._assumed[row] if value is None else value for row, value in enumerate(end))
        arc = None
        if state.motion in (2, 3):
            try:
                known_start = tuple(value for value in start if value is not None)
                arc = arc_of_block(state, known_start, known_end, meaning, self._settings.undotted)
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
        text = block_text(body, block.words, state.gap, insert, motion == 1)
        state.in_force, state.moved = motion, True
        for word in block.words:
            if word.letter in meaning.axes:
                state.numbers[state.row[word.letter]] = body[word.start + 1 : word.end].strip()
        written = tuple(axis in meaning.axes for axis in self._axes)
        return Move(
            number, Kind.ARC if arc else _STRAIGHT[motion], known_end, written, state.absolute, state.inch,
            text.lead, text.tail, state.gap, line[len(body) :], "" if arc or insert else line,
            again + (f"G53{state.gap}" if meaning.in_machine_coordinates else ""), text.split, arc,
            not meaning.miscellaneous and not meaning.exact_stop, state.feed_in_minutes,
            state.commanded.command(commands, state.absolute), state.commanded.elsewhere, state.shift, elsewhere,
            meaning.uncertain_codes,
        )  # fmt: skip

    def _note_modes(self, number: int) -> None:
        """Note modes that the program has not stated before its first motion."""
        if not self._state.moved:
            for mode, text in MODE_NOTES.items():
                if mode not in self._state.said:
                    self._notes.add(number, text)

    def _may_move(self, number: int, meaning: Meaning) -> bool:
        """Whether positions mean a motion here; a fault if they do not."""
        state = self._state
        if state.ended:
            self._faults.add(number, f"a motion after the end of the program in line {state.ended}")
        elif state.motion is None:
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

    def _stay(self, meaning: Meaning) -> None:
        """After a block without a usable move: what it sets, and where it would have gone, to read on sensibly."""
        if meaning.motion is not None:
            self._state.in_force = meaning.motion
        if meaning.axes and meaning.complaints and self._state.absolute:
            self._state.position = self._state.after(meaning.axes)

    def _unknown(self, number: int, needed: list[float | None], end: list[float | None]) -> None:
        missing = {row % len(end) for row, value in enumerate(needed) if value is None}
        names = " ".join(self._axes[row] for row in sorted(missing))
        self._faults.add(
            number,
            f"the position of {names} is not known here, and the errors depend on it",
            f"give it in the program or by --start {''.join(f'{axis}0' for axis in names.split())} (with its value)",
        )
        self._state.position = [0.0 if value is None else value for value in end]  # said once
