"""Runs of many blocks, lines and arcs, read all together.

What a run is, and what it means, is what the general reader makes of its blocks one by one: a test holds both against
each other. A block that differs in anything ends a run, and is left to it.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import BlockPlaces, PlainRun, carried
from trueaxis.compensation.machine import LINEAR, ROTARY, FloatArray
from trueaxis.compensation.nc import g_codes as codes
from trueaxis.compensation.nc import m_codes
from trueaxis.compensation.nc.cycles import CycleReader
from trueaxis.compensation.nc.frame_codes import FrameReader
from trueaxis.compensation.nc.modes import codes_in_force
from trueaxis.compensation.nc.plain_text import LETTERS, PlainText, plain_text
from trueaxis.compensation.nc.run_arcs import ArcReader
from trueaxis.compensation.nc.run_holes import Part, begin_again, holes_alike, holes_run, several_words
from trueaxis.compensation.nc.state import Commanded, NcState
from trueaxis.compensation.settings import MM_PER_INCH, Settings

FEWEST = 12  # blocks: below, arrays cost more than they save
FEWEST_HOLES = 4
_LAST_LINEAR, _LAST_AXIS, _PECK = (LETTERS.index(letter) for letter in "ZCQ")


class Run(NamedTuple):
    """A run, and how many lines and characters it takes: text may stand between its moves and behind them."""

    moves: PlainRun
    lines: int
    size: int


@dataclass(slots=True, kw_only=True)
class Reading:
    """A text that is being read, and how far. number: of its first line. others: its lines that are not plain, and its
    end. none_before: the line of it up to which no run begins. ahead: lines that are taken together at most: few after
    an arc that is none, twice as many after each run of as many, so that none is looked at many times.
    """

    text: str
    number: int
    lines: PlainText
    others: NDArray[np.int64]
    ahead: int
    none_before: int = 0


class RunReader:
    """Finds runs in the text of one program."""

    def __init__(self, state: NcState, settings: Settings, frames: FrameReader, cycles: CycleReader) -> None:
        self._state, self._settings, self._frames, self._cycles = state, settings, frames, cycles
        self._modes = codes.modes_on(settings.dialect) | codes.OF_CYCLES
        self._arcs = ArcReader(state, settings)
        self._known = all(axis in state.row for axis in LINEAR)
        self._assumed = np.array([settings.assumed.get(axis, 0.0) for axis in state.axes])
        self._row = np.array([state.row.get(letter, -1) for letter in LETTERS])
        self._read = self._reading(0, "")

    def read(self, number: int, text: str) -> Run | None:
        """The run that begins at line `number`, which is in this text; None, and nothing changed, if none does."""
        if not self._known or len(text) < FEWEST:
            return None
        if text is not self._read.text:
            self._read = self._reading(number, text)
        read, state = self._read, self._state
        first = number - read.number
        moves = read.lines.first[first + 1] > read.lines.first[first]
        if first < read.none_before or not moves or not_to_name(state) is None:
            return None
        end = self._plain_up_to(first)
        if end - first < (FEWEST if state.cycle is None else FEWEST_HOLES):
            read.none_before = end
            return None
        if state.cycle is not None:
            return self._holes(number, first, end) if state.goes_on_plainly else None
        last = min(self._alike(first, end), first + read.ahead)
        if last - first < FEWEST:
            read.none_before = max(last, first + 1)
            return None
        run = self._run(number, first, last)
        if run is None:
            read.ahead, read.none_before = 2 * FEWEST, last
        else:
            read.ahead = 2 * (read.ahead if run.lines == last - first else max(run.lines, FEWEST))
        return run

    def _reading(self, number: int, text: str) -> Reading:
        """Of a text that begins with line `number`."""
        siemens = self._settings.dialect == "siemens"  # R is a variable there, and only ; begins a comment
        lines = plain_text(text, self._settings.undotted == "mm", not siemens, self._modes, m_codes.SWITCHES)
        foreign = [axis for axis in ROTARY if axis not in self._state.row] + ["R"] * siemens
        plain = np.append(lines.plain, False)  # what is behind the last line end is no line
        for letter in foreign:
            plain[lines.line[lines.letter == LETTERS.index(letter)]] = False
        return Reading(text=text, number=number, lines=lines, others=np.flatnonzero(~plain), ahead=plain.size)

    def _holes(self, number: int, first: int, end: int) -> Run | None:
        """The run of holes that begins at this line; end: of the plain lines there."""
        state, lines = self._state, self._read.lines
        before = state.gap
        if lines.blank[first] or several_words(lines, slice(first, first + 1))[0]:
            state.gap = " " if lines.blank[first] else ""
        hole = self._cycles.further()
        last = end if hole is None else holes_alike(Part(lines, first, end), state, hole)
        if hole is None or last - first < FEWEST_HOLES:
            self._read.none_before, state.gap = max(last, first + 1), before
            return None
        moves, _ = self._motions(first, last)
        drills = moves & (lines.code[first:last] < 0)
        written, given = self._table(first, last, moves)
        written[hole.depth, drills[moves]] = False
        feed, in_minutes = self._feed(first, last)
        table = written, _positions(state, self._start(), written, given), in_minutes[moves]
        run = holes_run(Part(lines, first, last), number, table, state, hole)
        state.position, state.in_force = run.ends[:, -1].tolist(), int(run.motion[-1])
        state.feed = float(feed[-1])
        self._cycles.note_holes(number, int(drills.sum()))
        if not drills[moves].all():  # the cycle has ended and begun again
            begin_again(state, hole)
            self._keep_numbers(first, first + 1 + int(np.flatnonzero(moves & ~drills)[-1]), placing=True)
        return Run(run, last - first, int(lines.starts[last] - lines.starts[first]))

    def _alike(self, first: int, last: int) -> int:
        """Up to which of these plain lines those that move can be taken together; the first itself if it cannot."""
        state, lines, part = self._state, self._read.lines, slice(first, last)
        words = slice(*lines.first[[first, last]].tolist())
        letter, line = lines.letter[words], lines.line[words] - first
        moves, motion = self._motions(first, last)
        centred = np.zeros(moves.size, dtype=bool)
        centred[line[letter > _LAST_AXIS]] = True
        wrong = moves & ((motion < 0) | (centred != (motion > 1)) | (lines.returned[part] != lines.returned[first]))
        wrong[line[letter == _PECK]] = True
        if rows := not_to_name(state):
            wrong[line[np.isin(letter, [LETTERS.index(state.axes[row]) for row in rows])]] = True
            plane = [state.row[axis] for axis in codes.PLANES[state.plane][:2]]
            wrong |= moves & (motion > 1) & bool(set(plane) & set(rows))
        if not state.fed:  # the first feed motion without F is noted
            wrong |= moves & (motion > 0) & ~np.logical_or.accumulate(lines.feed[part] > 0.0)
        begins_otherwise = lines.code[first] < 0 and state.motion in (0, 1) and state.in_force != state.motion
        wrong[0] |= not moves[0] or begins_otherwise
        return first + int(np.argmax(wrong)) if wrong.any() else last

    def _plain_up_to(self, first: int) -> int:
        """Up to which line, from this one on, all are plain and change no mode."""
        read = self._read
        end = int(read.others[np.searchsorted(read.others, first)])
        modes = read.lines.modes.of(first, end)
        if not modes.number.size:
            return end
        changing = np.flatnonzero(~np.isin(modes.number, [*self._in_force()]))
        return first + int(modes.line[changing[0]]) if changing.size else end

    def _start(self) -> FloatArray:
        """Where the axes stand, or are taken to stand, (n_axes, 1)."""
        each = zip(self._state.position, self._assumed, strict=True)
        return np.array([[assumed if known is None else known] for known, assumed in each], dtype=np.float64)

    def _in_force(self) -> set[int]:
        """Codes of modes that change nothing now."""
        selected = self._frames.selected
        system = {int(selected[1:])} if selected[1:].isdecimal() else set()
        drilling = frozenset[int]() if self._state.cycle is None else codes.OF_CYCLES
        return codes_in_force(self._state) | codes.WITHOUT_MODE | system | drilling

    def _motions(self, first: int, last: int) -> tuple[NDArray[np.bool_], NDArray[np.int64]]:
        """Which of these lines move, and the motion in force in each, -1 where none is."""
        code, before = self._read.lines.code[first:last], self._state.motion
        moves = np.diff(self._read.lines.first[first : last + 1]) > 0
        return moves, carried(code, code >= 0, -1 if before is None else before)

    def _feed(self, first: int, last: int) -> tuple[FloatArray, FloatArray]:
        """F in force in each of these lines; the same in mm/min or deg/min, NaN where it counts otherwise."""
        state, given = self._state, self._read.lines.feed[first:last]
        feed = carried(given * (MM_PER_INCH if state.inch else 1.0), np.isfinite(given), state.feed)
        return feed, feed if state.feed_mode == "minute" else np.full(feed.size, math.nan)

    def _run(self, number: int, first: int, last: int) -> Run | None:
        """The run of these lines, as far as their arcs are arcs."""
        state, lines = self._state, self._read.lines
        moves, motion = self._motions(first, last)
        index = first + np.flatnonzero(moves)
        if index.size < FEWEST:
            return None
        motion = motion[moves]
        written, given = self._table(first, last, moves)
        start = self._start()
        ends = _positions(state, start, written, given)
        arcs, right = self._arcs.read(lines, index, motion, start, ends)
        if right < index.size:
            if right < FEWEST:
                return None
            last = int(index[right])
            index, motion, written, ends = index[:right], motion[:right], written[:, :right], ends[:, :right]
        feed, in_minutes = self._feed(first, last)
        several = lines.first[index + 1] - lines.first[index] > 1
        blank = carried(lines.blank[index], lines.blank[index] | several, state.gap == " ")
        run = PlainRun(
            line=number + index - first, motion=motion, ends=ends, written=written, absolute=state.absolute,
            inch=state.inch, blank=blank, eol="\r\n" if lines.returned[first] else "\n",
            source=lines.source[lines.starts[first] : lines.starts[last]], places=self._places(first, last, index),
            inserts=(motion > 1) & (lines.code[index] < 0), arcs=arcs, feed=in_minutes[index - first],
            held=state.commanded.held[state.absolute], elsewhere=state.commanded.elsewhere,
            unnamed=state.commanded.unnamed, shift=state.shift, stays=np.ones(motion.size, dtype=bool),
        )  # fmt: skip
        self._keep(run, first, last, int(index[-1]), float(feed[-1]))
        return Run(run, last - first, int(lines.starts[last] - lines.starts[first]))

    def _table(self, first: int, last: int, moves: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], FloatArray]:
        """Which axes the lines that move name, and their numbers, mm and deg, each (n_axes, n)."""
        lines, of_text = self._read.lines, slice(*self._read.lines.first[[first, last]].tolist())
        letter = lines.letter[of_text]
        axes = letter <= _LAST_AXIS
        letter, line = letter[axes], lines.line[of_text][axes] - first
        place = self._row[letter], (np.cumsum(moves) - 1)[line]
        shape = len(self._state.axes), int(moves.sum())
        written, given = np.zeros(shape, dtype=bool), np.zeros(shape)
        values = lines.value[of_text][axes]
        written[place] = True
        given[place] = np.where(letter <= _LAST_LINEAR, values * MM_PER_INCH, values) if self._state.inch else values
        return written, given

    def _places(self, first: int, last: int, index: NDArray[np.int64]) -> BlockPlaces:
        """Where the text of these lines is, in that from the first to the last."""
        lines = self._read.lines
        own = lines.code[index] >= 0
        places = BlockPlaces(
            begin=lines.starts[index], first=lines.lead[index], last=lines.tail[index],
            end=lines.starts[index + 1] - 1 - lines.returned[index],
            after=np.append(lines.starts[index[1:]], lines.starts[last]),
            code=np.where(own, lines.code_at[index], lines.lead[index]),
            code_end=np.where(own, lines.code_end[index], lines.lead[index]),
        )  # fmt: skip
        return places.moved(-int(lines.starts[first]))

    def _keep(self, run: PlainRun, first: int, last: int, moved: int, feed: float) -> None:
        """Take into the state what a run has set; moved: its last line that moves."""
        state, lines = self._state, self._read.lines
        motions = np.flatnonzero(lines.code[first:last] >= 0)
        state.motion = int(run.motion[-1])
        state.in_force = None if state.motion > 1 else state.motion  # an arc may have become lines
        if motions.size and first + motions[-1] > moved:
            state.motion = state.in_force = int(lines.code[first + motions[-1]])
        state.gap, state.moved, state.feed = " " if run.blank[-1] else "", True, feed
        state.fed = state.fed or feed > 0.0
        last_end = run.ends[:, -1].tolist()
        state.position = [None if before is None else end for before, end in zip(state.position, last_end, strict=True)]
        spindle = [code for code in lines.switches.of(first, last).number.tolist() if code in m_codes.SPINDLE]
        if spindle:
            state.spindle = m_codes.spindle_of(spindle[-1])
        self._keep_numbers(first, last)

    def _keep_numbers(self, first: int, last: int, placing: bool = False) -> None:
        """Take into the state the numbers of the axes; placing: of lines alone that have the G code of a motion."""
        state, lines = self._state, self._read.lines
        words = slice(*lines.first[[first, last]].tolist())
        may = lines.code[lines.line[words]] >= 0 if placing else np.ones(words.stop - words.start, dtype=bool)
        for axis, row in state.row.items():
            at = np.flatnonzero(may & (lines.letter[words] == LETTERS.index(axis)))
            if at.size:
                place, end = (int(of[words][at[-1]]) for of in (lines.place, lines.end))
                state.numbers[row] = self._read.text[place + 1 : end].strip()


def not_to_name(state: NcState) -> list[int] | None:
    """Rows of the axes that the program has not commanded, where blocks of axis words alone are moves as long as they
    name none of these; None where they are none even then.
    """
    found = state.commanded.below(Commanded.ABSOLUTE)
    apart = state.ended or state.due or state.call or state.shorter_way
    if state.feed_mode == "time" or apart or (state.point_control and found):
        return None
    unnamed = state.commanded.unnamed or (False,) * len(state.axes)
    for row, axis in enumerate(state.axes):
        if not unnamed[row] and (state.position[row] is None or (row in found and axis in LINEAR)):
            return None
    return found


def _positions(state: NcState, start: FloatArray, written: NDArray[np.bool_], given: FloatArray) -> FloatArray:
    """Where the blocks of a run that begins at `start` (n_axes, 1) end, (n_axes, n); written, given: which axes they
    name, and their numbers.
    """
    if not state.absolute:
        return np.cumsum(np.concatenate([start, given], axis=1), axis=1)[:, 1:]
    if state.shift:
        given += np.array(state.shift)[:, np.newaxis]
    if written.all():
        return given
    ends = np.concatenate([start, given], axis=1)
    last = np.maximum.accumulate(np.where(written, np.arange(1, ends.shape[1]), 0), axis=1)
    return np.take_along_axis(ends, last, axis=1)
