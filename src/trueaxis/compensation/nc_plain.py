"""Most blocks: N, G0 or G1, X Y Z and F, in this order, read at once, and runs of them all together.

What a run is, and what it means, is what `plain_move` makes of its blocks one by one: a test holds both against each
other. A block that differs in anything is left to it, and to the general reader.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.nc_lexer import LARGEST, NUMBER
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.plain_text import plain_text
from trueaxis.compensation.settings import MM_PER_INCH

# the groups are lead, G, X, Y, Z, tail, F, line end
PLAIN = re.compile(
    rf"((?:N\d{{1,9}}+)?[ \t]*+(?:G0?([01]))?[ \t]*+)"
    rf"(?:X({NUMBER}))?(?:[ \t]*+Y({NUMBER}))?(?:[ \t]*+Z({NUMBER}))?"
    rf"([ \t]*+(?:F[ \t]*+(\d++\.?+\d*+|\.\d++))?[ \t]*+)(\r*+\n?+)"
)
_STRAIGHT = (Kind.RAPID, Kind.LINE)


def goes_on_plainly(state: NcState, motion: int | None) -> bool:
    """Whether a block of axis words alone, under this motion, is a straight move from where all axes are known."""
    return (
        motion in (0, 1)
        and state.commanded.linear_complete
        and None not in state.position
        and state.cycle is None
        and state.feed_mode != "time"
        and not state.ended
    )


def plain_move(number: int, line: str, match: re.Match[str], state: NcState, undotted_mm: bool) -> Move | None:
    """The move of a plain block; None, and nothing changed, if it needs a closer look.

    match: of `PLAIN`. undotted_mm: whether a number without a decimal point counts mm (or inch).
    """
    lead, code, x, y, z, tail, feed, eol = match.groups()
    motion = state.motion if code is None else int(code)
    if (
        motion is None
        or (code is None and state.in_force != motion)
        or not goes_on_plainly(state, motion)
        or (x is None and y is None and z is None)
        or (feed is not None and float(feed) > LARGEST)
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
    if " " in line:
        state.gap = " "
    elif sum(written) > 1:
        state.gap = ""
    state.motion = state.in_force = motion
    state.position, state.moved = position, True
    if feed is not None:
        state.feed = float(feed) * scale
    return Move(
        number, _STRAIGHT[motion], tuple(position), tuple(written), absolute, state.inch,  # type: ignore[arg-type]
        lead, tail, state.gap, eol, line, feed=state.feed_in_minutes, held=state.commanded.held[absolute], shift=shift,
    )  # fmt: skip


FEWEST = 12  # blocks: below, arrays cost more than they save


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainRun:
    """Plain blocks, each an item like `Move`, whose fields it shares but for these.

    line: of the first block. ends: (n_axes, n), mm and deg. written: (n_axes, n), whether a block has the word.
    source: the bytes of all blocks. starts: (n + 1,), where they begin in it, and the end of the last. lead, tail:
    (n,), characters before and after the axis words, without the line end.
    """

    line: int
    kind: Kind
    ends: FloatArray
    written: NDArray[np.bool_]
    absolute: bool
    inch: bool
    gap: str
    eol: str
    source: NDArray[np.uint8]
    starts: NDArray[np.int64]
    lead: NDArray[np.int64]
    tail: NDArray[np.int64]
    feed: float
    held: tuple[bool, ...]
    shift: tuple[float, ...]

    @property
    def count(self) -> int:
        """Number of blocks."""
        return int(self.ends.shape[1])

    def sources(self) -> list[str]:
        """The text of each block."""
        return [f"{line}\n" for line in self.source.tobytes().decode("latin-1").split("\n")[:-1]]

    def ways(self, start: Sequence[float] | None = None) -> FloatArray:
        """Length of the feed motions, (n,), mm; start: of the first, whose length is 0 where that is not given."""
        before = self.ends[:, :1] if start is None else np.array(start)[:, np.newaxis]
        if self.kind == Kind.RAPID:
            return np.zeros(self.count)
        return np.asarray(np.sqrt((np.diff(self.ends, axis=1, prepend=before) ** 2).sum(axis=0)))

    def parts(self, most: int) -> Iterator["PlainRun"]:
        """The run in parts of no more than so many blocks."""
        if self.count <= most:
            yield self
            return
        for first in range(0, self.count, most):
            part, ends = slice(first, first + most), self.starts[first : first + most + 1]
            yield replace(
                self, line=self.line + first, ends=self.ends[:, part], written=self.written[:, part],
                source=self.source[ends[0] : ends[-1]], starts=ends - ends[0],
                lead=self.lead[part], tail=self.tail[part],
            )  # fmt: skip

    def move(self, index: int) -> Move:
        """One block."""
        block = self.source[self.starts[index] : self.starts[index + 1]].tobytes().decode("latin-1")
        end = len(block) - len(self.eol)
        return Move(
            self.line + index, self.kind, tuple(self.ends[:, index].tolist()),
            tuple(self.written[:, index].tolist()), self.absolute, self.inch,
            block[: int(self.lead[index])], block[end - int(self.tail[index]) : end], self.gap, self.eol, block,
            feed=self.feed, held=self.held, shift=self.shift,
        )  # fmt: skip


class RunReader:
    """Finds runs in the text of one program."""

    def __init__(self, state: NcState, undotted_mm: bool) -> None:
        self._state, self._undotted_mm = state, undotted_mm
        self._known = all(axis in state.row for axis in LINEAR)
        self._text, self._first = "", 0  # the text read last, and the number of its first line
        self._lines = plain_text("", undotted_mm)
        self._others = np.zeros(1, dtype=np.int64)  # its lines that are not plain, and its end
        self._looked = 0  # line of it up to which no run begins

    def read(self, number: int, text: str) -> PlainRun | None:
        """The run that begins at line `number`, which is in this text; None, and nothing changed, if none does."""
        if not self._known or len(text) < FEWEST:
            return None
        if text is not self._text:
            self._text, self._first, self._looked = text, number, 0
            self._lines = plain_text(text, self._undotted_mm)
            self._others = np.append(np.flatnonzero(~self._lines.plain), self._lines.plain.size)
        first = number - self._first
        if first < self._looked or not goes_on_plainly(self._state, self._code(first)):
            return None
        last = int(self._others[np.searchsorted(self._others, first)])
        if last - first >= FEWEST:
            last = self._alike(first, last)
        run = self._run(number, first, last) if last - first >= FEWEST else None
        if run is None:
            self._looked = max(last, first + 1)
        return run

    def _alike(self, first: int, last: int) -> int:
        """Up to which of these plain lines all move as the first does."""
        lines, part = self._lines, slice(first, last)
        code, feed, spaced = lines.code[part], lines.feed[part], lines.spaced[part]
        differs = (code >= 0) & (code != self._code(first))
        differs |= (feed == feed) & (feed != feed[0])  # noqa: PLR0124  # those that have an F
        differs |= lines.returned[part] != lines.returned[first]
        differs |= (spaced != (self._gap(first) == " ")) & (spaced | (lines.words[part] > 1))
        return first + int(np.argmax(differs)) if differs.any() else last

    def _code(self, line: int) -> int | None:
        """The motion of a line: its own code, else the one in force, if that is in force in what is written too."""
        if (own := int(self._lines.code[line])) >= 0:
            return own
        return self._state.motion if self._state.in_force == self._state.motion else None

    def _gap(self, line: int) -> str:
        """What is between words from this line on."""
        if self._lines.spaced[line]:
            return " "
        return "" if self._lines.words[line] > 1 else self._state.gap

    def _run(self, number: int, first: int, last: int) -> PlainRun | None:
        state, lines, motion = self._state, self._lines, self._code(first)
        scale, of_run = MM_PER_INCH if state.inch else 1.0, slice(*lines.first[[first, last]].tolist())
        values, feed = lines.value[of_run] * scale, float(lines.feed[first])
        if not (np.abs(values) <= LARGEST).all() or feed > LARGEST:
            return None
        written, given = self._table(first, last, of_run, values)
        ends = _positions(state, written, given)
        state.motion = state.in_force = motion
        state.gap, state.position, state.moved = self._gap(first), ends[:, -1].tolist(), True
        if feed == feed:  # noqa: PLR0124  # there is an F
            state.feed = feed * scale
        self._keep_numbers(of_run)
        starts = lines.starts[first : last + 1]
        return PlainRun(
            line=number, kind=Kind.LINE if motion else Kind.RAPID, ends=ends, written=written, absolute=state.absolute,
            inch=state.inch, gap=state.gap, eol="\r\n" if lines.returned[first] else "\n",
            source=lines.source[starts[0] : starts[-1]], starts=starts - starts[0], lead=lines.lead[first:last],
            tail=lines.tail[first:last], feed=state.feed_in_minutes, held=state.commanded.held[state.absolute],
            shift=state.shift,
        )  # fmt: skip

    def _table(self, first: int, last: int, of_run: slice, values: FloatArray) -> tuple[NDArray[np.bool_], FloatArray]:
        """Which axes the lines name, and their numbers, each (n_axes, n)."""
        row = np.array([self._state.row[letter] for letter in LINEAR])
        shape = len(self._state.axes), last - first
        written, given = np.zeros(shape, dtype=bool), np.zeros(shape)
        if values.size == 3 * shape[1]:  # every line has all three
            written[row], given[row] = True, values.reshape(-1, 3).T
            return written, given
        place = row[self._lines.axis[of_run]], np.repeat(np.arange(shape[1]), self._lines.words[first:last])
        written[place], given[place] = True, values
        return written, given

    def _keep_numbers(self, of_run: slice) -> None:
        """The last number of each axis as it is written."""
        axis = self._lines.axis[of_run]
        for index, letter in enumerate(LINEAR):
            at = np.flatnonzero(axis == index)
            if at.size:
                place = int(self._lines.place[of_run][at[-1]]) + 1
                found = re.compile(NUMBER).match(self._text, place)
                self._state.numbers[self._state.row[letter]] = found[0]  # type: ignore[index]


def _positions(state: NcState, written: NDArray[np.bool_], given: FloatArray) -> FloatArray:
    """Where the blocks of a run end, (n_axes, n); written, given: which axes they name, and their numbers."""
    start = np.array([0.0 if value is None else value for value in state.position])[:, np.newaxis]
    if not state.absolute:
        return np.cumsum(np.concatenate([start, given], axis=1), axis=1)[:, 1:]
    if state.shift:
        given += np.array(state.shift)[:, np.newaxis]
    if written.all():
        return given
    ends = np.concatenate([start, given], axis=1)
    last = np.maximum.accumulate(np.where(written, np.arange(1, ends.shape[1]), 0), axis=1)
    return np.take_along_axis(ends, last, axis=1)
