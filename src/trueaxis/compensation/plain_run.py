"""Runs of blocks that are axis words alone, which make most of a long program: read and written all at once.

What a run is, and what it means, is what `plain_move` makes of its blocks one by one: a test holds both against each
other. A block that differs in anything is left to it, and to the general reader.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.nc_lexer import LARGEST, NUMBER
from trueaxis.compensation.nc_plain import goes_on_plainly
from trueaxis.compensation.nc_state import NcState
from trueaxis.compensation.settings import MM_PER_INCH

FEWEST = 12  # blocks: below, arrays cost more than they save
_NUMBER_WITH_DOT = r"[-+]?+(?:\d++\.\d*+|\.\d++)"
_SPACES = bytes.maketrans(b"XYZ", b"   ")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainRun:
    """Blocks of axis words, each an item like `Move`, whose fields it shares but for these.

    line: of the first block. ends: (n_axes, n), mm and deg. written: (n_axes, n), whether a block has the word.
    text: of all blocks as in the source.
    """

    line: int
    kind: Kind
    ends: FloatArray
    written: NDArray[np.bool_]
    absolute: bool
    inch: bool
    gap: str
    eol: str
    text: str
    feed: float
    held: tuple[bool, ...]
    shift: tuple[float, ...]

    @property
    def count(self) -> int:
        """Number of blocks."""
        return int(self.ends.shape[1])

    def sources(self) -> list[str]:
        """The text of each block."""
        return [f"{line}\n" for line in self.text.split("\n")[:-1]]

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
        sources = self.sources()
        for first in range(0, self.count, most):
            part = slice(first, first + most)
            yield replace(
                self, line=self.line + first, ends=self.ends[:, part], written=self.written[:, part],
                text="".join(sources[part]),
            )  # fmt: skip

    def move(self, index: int) -> Move:
        """One block."""
        return Move(
            self.line + index, self.kind, tuple(self.ends[:, index].tolist()),
            tuple(self.written[:, index].tolist()), self.absolute, self.inch, "", "", self.gap, self.eol,
            self.sources()[index], feed=self.feed, held=self.held, shift=self.shift,
        )  # fmt: skip


@cache
def _pattern(gap: str, eol: str, undotted: bool) -> re.Pattern[str]:
    """Of as many blocks as there are with this gap between words and this line end."""
    number, between = NUMBER if undotted else _NUMBER_WITH_DOT, " ++" if gap else ""
    y, z = (f"(?:{between}{letter}{number})?" for letter in "YZ")
    return re.compile(rf"(?:(?:X{number}{y}{z}|Y{number}{z}|Z{number}){eol})+")


class RunReader:
    """Finds runs in the text of one program."""

    def __init__(self, state: NcState, undotted_mm: bool) -> None:
        self._state, self._undotted_mm = state, undotted_mm
        self._known = all(axis in state.row for axis in LINEAR)
        self._looked: tuple[str, int] = ("", 0)  # text, and the place in it up to which no run begins

    def read(self, number: int, text: str, place: int) -> PlainRun | None:
        """The run that begins at a place of the text, in line `number`; None, and nothing changed, if none does."""
        state = self._state
        if not self._known or not goes_on_plainly(state, state.motion) or state.in_force != state.motion:
            return None
        if text is self._looked[0] and place < self._looked[1]:
            return None
        end = text.find("\n", place)
        eol = "\r\n" if text[end - 1 : end] == "\r" else "\n"
        found = _pattern(state.gap, eol, self._undotted_mm).match(text, place)
        blocks = text.count("\n", place, found.end()) if found else 0
        if found is None or blocks < FEWEST:
            self._looked = (text, found.end() if found else end + 1)
            return None
        run = self._run(number, found[0], blocks, eol)
        if run is None:
            self._looked = (text, found.end())
            return None
        self._take(run)
        return run

    def _run(self, number: int, text: str, blocks: int, eol: str) -> PlainRun | None:
        state = self._state
        source = text.encode("latin-1")
        values = np.fromstring(source.translate(_SPACES), sep=" ") * (MM_PER_INCH if state.inch else 1.0)
        if not (np.abs(values) <= LARGEST).all():
            return None
        signs = np.frombuffer(source, dtype=np.uint8)
        letters = np.flatnonzero((signs >= ord("X")) & (signs <= ord("Z")))
        axis = signs[letters] - ord("X")
        block = np.repeat(np.arange(blocks), 3) if letters.size == 3 * blocks else (
            np.searchsorted(np.flatnonzero(signs == ord("\n")), letters)
        )  # fmt: skip
        row = np.array([state.row[letter] for letter in LINEAR])[axis]
        written = np.zeros((len(state.axes), blocks), dtype=bool)
        written[row, block] = True
        given = np.zeros((len(state.axes), blocks))
        given[row, block] = values
        start = np.array([0.0 if value is None else value for value in state.position])[:, np.newaxis]
        if not state.absolute:
            ends = np.cumsum(np.concatenate([start, given], axis=1), axis=1)[:, 1:]
        else:
            if state.shift:
                given += np.array(state.shift)[:, np.newaxis]
            ends = np.concatenate([start, given], axis=1)
            if not written.all():
                last = np.maximum.accumulate(np.where(written, np.arange(1, blocks + 1), 0), axis=1)
                ends = np.take_along_axis(ends, np.concatenate([np.zeros_like(last[:, :1]), last], axis=1), axis=1)
            ends = np.ascontiguousarray(ends[:, 1:])
        return PlainRun(
            line=number, kind=Kind.LINE if state.motion else Kind.RAPID, ends=ends, written=written,
            absolute=state.absolute, inch=state.inch, gap=state.gap, eol=eol, text=text, feed=state.feed_in_minutes,
            held=state.commanded.held[state.absolute], shift=state.shift,
        )  # fmt: skip

    def _take(self, run: PlainRun) -> None:
        """What the blocks of a run leave behind."""
        state = self._state
        state.position, state.moved = run.ends[:, -1].tolist(), True
        for letter in LINEAR:
            if (at := run.text.rfind(letter)) >= 0:
                state.numbers[state.row[letter]] = re.match(NUMBER, run.text[at + 1 :])[0]  # type: ignore[index]
