"""Reads NC programs (ISO 6983-1, RS-274) block by block, following every mode that bears on positions.

What it does not follow is a fault of its line; nothing that could move an axis is passed over. What numbers without a
decimal point count is for `--integers` to say. A program says where its modes begin: until it does, G90 G21 G17.
"""

import math
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from trueaxis.compensation.columns import PlainRun
from trueaxis.compensation.dialects import BYTE_ORDER_MARK, COMPENSATED_ALREADY, is_marked
from trueaxis.compensation.logs import FaultLog
from trueaxis.compensation.move_notes import SWITCH
from trueaxis.compensation.moves import AFTER_END, STOP, Item, Kind, Move, Notes, Start
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.block import interpret
from trueaxis.compensation.nc.called_cycles import CallReader
from trueaxis.compensation.nc.cycles import CycleReader
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.leader import leader_of, take_leader
from trueaxis.compensation.nc.lexer import LARGEST, NUMBER, Block, Meaning, lex
from trueaxis.compensation.nc.mistyped import NOTHING, Slips, read_mended
from trueaxis.compensation.nc.modes import ModeReader, switch
from trueaxis.compensation.nc.motion import MotionReader, to_reference
from trueaxis.compensation.nc.rotary_ways import take_codes
from trueaxis.compensation.nc.runs import RunReader
from trueaxis.compensation.nc.siemens import lex_siemens, take_functions
from trueaxis.compensation.nc.state import NcState
from trueaxis.compensation.nc.tool_codes import ToolReader
from trueaxis.compensation.settings import MM_PER_INCH, Settings

_ALIGNMENT = re.compile(r":\d*+")  # ISO 6983-1: a block number that may stand alone as a program number
_OPTIONAL = re.compile(r"/[0-9]?")  # with the number of its switch: every piece of the block keeps it
_NAME = re.compile(r"[Oo]<[\w .+-]*+>\s*+(?:\([^()]*+\))?", re.ASCII)  # of a program, on newer Fanuc controls
_POSITION = re.compile(r"(?<![A-Za-z])[XYZABCUVW]\s*+[-+.\d]", re.IGNORECASE)
_MACHINE_DATA = frozenset({codes.TO_REFERENCE, codes.TO_SECOND_REFERENCE, codes.SET_POSITION, codes.WRITE_DATA})


# the groups are lead, G, X, Y, Z, tail, F, line end
_PLAIN = re.compile(
    rf"((?:N\d{{1,9}}+)?[ \t]*+(?:G0?([01]))?[ \t]*+)"
    rf"(?:X({NUMBER}))?(?:[ \t]*+Y({NUMBER}))?(?:[ \t]*+Z({NUMBER}))?"
    rf"([ \t]*+(?:F[ \t]*+(\d++\.?+\d*+|\.\d++))?[ \t]*+)(\r*+\n?+)"
)
_STRAIGHT = (Kind.RAPID, Kind.LINE)


class NcReader:
    """Turns the lines of one program into items; faults and notes are gathered in the logs given."""

    def __init__(
        self, axes: tuple[str, ...], settings: Settings, faults: FaultLog, notes: Notes, lines: Sequence[int] = ()
    ) -> None:
        """lines: by which each line of the text is named, where that is not its own number."""
        self._axes, self._named = axes, np.array(lines, dtype=np.int64)
        self._settings = settings
        self._faults = faults
        self._notes = notes
        self._state = NcState(axes=axes, position=[settings.start.get(axis) for axis in axes], offsets=settings.offsets)
        self._state.frames.machine_has_length = settings.dialect == "siemens"
        self._modes = ModeReader(self._state, settings, faults, notes)
        self._tools = ToolReader(self._state, settings, faults, notes)
        self._frames = FrameReader(self._state, settings, faults, notes)
        self._motions = MotionReader(
            self._state, settings, (faults, notes), (self._modes, self._tools, self._frames)
        )  # fmt: skip
        self._calls = CallReader(self._state, settings, (faults, notes), self._frames)
        self._cycles = CycleReader(self._state, settings, (faults, notes), self._modes, self._frames)

    def items(self, texts: Iterable[str]) -> Iterator[Item | PlainRun]:
        """Items of a program, in order; texts: whole lines with their ends, many at once, bytes as latin-1."""
        if self._settings.start:
            yield Start(tuple(math.nan if value is None else value for value in self._state.position))
        yield from self._frames.changed()
        plain, state, undotted_mm = _PLAIN.fullmatch, self._state, self._settings.undotted == "mm"
        runs, number = RunReader(state, self._settings, self._frames, self._cycles), 0
        for text in texts:
            if not number:
                leader = leader_of(text, self._settings.dialect)
                take_leader(leader, self._settings.dialect, self._faults, self._notes)
                yield from (f"{line}\n" for line in leader)
                number, text = len(leader), text[sum(map(len, leader)) + len(leader) :]  # noqa: PLW2901
            place = 0
            while place < len(text):
                run = runs.read(number + 1, text)
                if run is not None:
                    yield self._of_source(run.moves)
                    number, place = number + run.lines, place + run.size
                    continue
                end = text.find("\n", place) + 1 or len(text)
                line, number, place = text[place:end], number + 1, end
                match = plain(line)
                name = int(self._named[number - 1]) if self._named.size else number
                move = plain_move(name, line, match, state, undotted_mm) if match else None
                if move is not None:
                    yield move
                else:
                    yield from self._any(name, line)
        self._frames.note_end("M2, M30 or % again" if state.percents else "")

    def _of_source(self, run: PlainRun) -> PlainRun:
        """A run with the lines by which it is named."""
        return replace(run, line=self._named[run.line - 1]) if self._named.size else run

    def _any(self, number: int, line: str) -> list[Item]:
        """Any line: what it sets, and its moves if it has some."""
        if is_marked(line):
            self._faults.add(number, *COMPENSATED_ALREADY)
        body = line.rstrip("\r\n")
        begin = 3 if number == 1 and body.startswith(BYTE_ORDER_MARK) else 0
        text = body[begin:].strip()
        if self._state.ended:
            if _POSITION.search(re.sub(r"\([^()]*\)|;.*", "", text)):
                self._notes.warn(number, AFTER_END)
            return [line]
        if not text or text[0] == "%":
            self._modes.mark(number, text)
            return [line]
        lead = len(body) - len(body[begin:].lstrip(" \t"))
        aligned = _ALIGNMENT.match(body, lead)
        if aligned:
            lead = aligned.end()
        optional = _OPTIONAL.match(body, lead)
        if optional:
            if self._settings.block_delete == "skip":
                self._notes.add(number, SWITCH["skip"])
                return [line]
            lead = optional.end()
        named = _NAME.fullmatch(text)
        block, meaning, wrong = self._read(body, lead, named is not None)
        self._faults.add_mistyped(number, wrong)
        for text in meaning.notes:
            self._notes.add(number, text)
        meaning.program_number |= named is not None or (aligned is not None and not block.words)
        if optional and self._depends(meaning):
            if self._settings.block_delete == "fault":
                problem = "whether this block with / is run depends on a switch"
                meaning.complain(problem, "say --block-delete run or --block-delete skip")
            else:
                self._notes.add(number, SWITCH["run"])
        return self._block(number, line, body, block, meaning, optional[0] if optional else "")

    def _read(self, body: str, lead: int, named: bool) -> tuple[Block, Meaning, Slips]:
        """The words of a block, what they ask for, and what of them is mistyped."""
        started, wrong = Meaning(), NOTHING
        if named:
            block = Block((), "")
        elif self._settings.dialect == "siemens":
            found, wrong = read_mended(body, lambda text: lex_siemens(text, lead))
            take_functions(found, started)
            block = found.block
        else:
            block, wrong = read_mended(body, lambda text: lex(text, lead))
        return block, interpret(block, self._axes, self._settings, self._state.cycle is not None, started), wrong

    def _depends(self, meaning: Meaning) -> bool:
        """Whether it matters to what follows if a block is run."""
        tool = self._settings.tools is not None and (meaning.tool or m_codes.TOOL_CHANGE in meaning.miscellaneous)
        return meaning.positions or meaning.drilling or meaning.changes_modes or bool(tool)

    def _block(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """A block: what it sets, and its moves if it has some."""
        state = self._state
        self._faults.macros += block.macro
        for problem, remedy in meaning.complaints:
            self._faults.add(number, problem, remedy)
        self._modes.take(number, meaning)
        if self._settings.dialect == "heidenhain":
            take_codes(number, meaning.miscellaneous, meaning.positions, state, self._faults)
        self._tools.change(number, meaning)
        if not block.problem:
            self._modes.known_numbers(number, meaning)
        self._tools.length(number, meaning)
        state.due = self._tools.due
        items = switch(number, meaning.point_control, state, self._settings, self._faults, self._notes)
        items = self._path_again(line[len(body) :], meaning) + items + self._frames.select(number, meaning)
        if state.point_control and (meaning.in_machine_coordinates or meaning.data_code in _MACHINE_DATA):
            self._faults.add(number, "machine coordinates under tool centre point control", "end it before")
        if meaning.data_code is not None or meaning.drilling:
            items += self._data(number, line, body, block, meaning, again)
        elif meaning.call is not None:
            items += self._calls.take(number, line, body, meaning.call, again)
        else:
            items += self._motions.block(number, line, body, block, meaning, again)
            items += self._calls.after(number, line, body, meaning, again)
        if meaning.changes_tool and self._tools.moves(meaning):  # after the motion too: controls do not agree on it
            state.commanded.displace()
        stops = m_codes.STOPS.intersection(meaning.miscellaneous)
        if any(m_codes.may_move(code, self._settings.pass_m) for code in stops):
            state.commanded.stop()
            self._notes.add(number, STOP)
        if m_codes.END.intersection(meaning.miscellaneous):
            state.ended = number
        return items

    def _path_again(self, eol: str, meaning: Meaning) -> list[Item]:
        """The path mode of the program, where a cycle ends with this block; eol: the end of its line."""
        state = self._state
        if state.cycle is not None and m_codes.END.isdisjoint(meaning.miscellaneous):
            return []
        again = state.path.leave_cycle(state.inch)
        return [again + (eol or "\n")] if again else []

    def _data(self, number: int, line: str, body: str, block: Block, meaning: Meaning, again: str) -> list[Item]:
        """A block whose axis words are not simply where to go."""
        state = self._state
        if meaning.drilling:
            return self._cycles.block(number, line, body, block, meaning, again)
        if meaning.motion is not None:
            state.in_force = meaning.motion
        if meaning.complaints:
            return [line]
        if meaning.motion not in (None, 0, 1) or meaning.in_machine_coordinates or meaning.cycle is not None:
            self._faults.add(number, "axis words that are data, and a motion, in one block", "make it two blocks")
            return [line]
        if meaning.data_code == codes.GIVE_LENGTH:
            self._tools.data(number, meaning)
            return [line, *self._frames.changed()]
        if meaning.data_code in (codes.TO_REFERENCE, codes.TO_SECOND_REFERENCE):
            return [line, *to_reference(number, meaning, state, self._settings, self._faults, self._notes)]
        return self._frames.data(number, line, body, block, meaning)


def plain_move(number: int, line: str, match: re.Match[str], state: NcState, undotted_mm: bool) -> Move | None:
    """The move of a plain block; None, and nothing changed, if it needs a closer look.

    match: of `_PLAIN`. undotted_mm: whether a number without a decimal point counts mm (or inch).
    """
    lead, code, x, y, z, tail, feed, eol = match.groups()
    motion = state.motion if code is None else int(code)
    if (
        motion not in (0, 1)
        or (code is None and state.in_force != motion)
        or not state.goes_on_plainly
        or state.cycle is not None
        or (x is None and y is None and z is None)
        or (feed is not None and float(feed) > LARGEST)
        or (motion == 1 and not state.fed)
    ):
        return None
    position = state.position.copy()
    rows, numbers, scale, absolute = state.row, state.numbers, MM_PER_INCH if state.inch else 1.0, state.absolute
    shift = state.shift
    written = [False] * len(position)
    for axis, text in (("X", x), ("Y", y), ("Z", z)):
        if text is None:
            continue
        row = rows.get(axis)
        distance = float(text) * scale
        if row is None or abs(distance) > LARGEST:
            return None
        if "." not in text and distance and not undotted_mm:
            return None
        if absolute:
            position[row] = distance + shift[row] if shift else distance
        else:
            position[row] += distance  # type: ignore[operator]  # known, as all axes are
        written[row] = True
        numbers[row] = text
    if " " in line or "\t" in line:
        state.gap = " "
    elif sum(written) > 1:
        state.gap = ""
    state.motion = state.in_force = motion
    state.position, state.moved = position, True
    if feed is not None:
        state.feed = float(feed) * scale
    return Move(
        number, _STRAIGHT[motion], tuple(position), tuple(written), absolute, state.inch,  # type: ignore[arg-type]
        lead, tail, state.gap, eol, line, feed=state.feed_in_minutes, held=state.commanded.held[absolute],
        elsewhere=state.commanded.elsewhere, shift=shift,
    )  # fmt: skip
