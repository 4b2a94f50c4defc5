"""The blocks that a run becomes, as `BlockWriter` writes them one by one: words from numbers, and texts put together
from places in one store of characters.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import BlockPlaces, PlainRun, columns_of
from trueaxis.compensation.kept_arcs import Pieces
from trueaxis.compensation.settings import MM_PER_INCH

Characters = NDArray[np.uint8]
Segment = tuple[NDArray[np.int64], NDArray[np.int64]]  # where a part of each text begins in a store, and its length
_BEFORE = 3  # characters before the digits: blank, letter, sign
_CODES = np.frombuffer(b" G0  G1  G2  G3 ", dtype=np.uint8)  # of a motion, with the gaps around it
_CODE = 4  # characters of each
_LINE = 1


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Words:
    """Words of n blocks with one letter, one in each at most.

    decimals: at least one. counts: (n,), in units of the last decimal. named: (n,), which there are. blank: (n,),
    whether a blank stands before those that are there.
    """

    letter: str
    decimals: int
    counts: NDArray[np.int64]
    named: NDArray[np.bool_]
    blank: NDArray[np.bool_]

    def texts(self, place: int) -> tuple[Characters, Segment]:
        """The characters of all words, and where each is; place: where they begin in the store."""
        named = np.flatnonzero(self.named)
        counts = self.counts[named]
        size = np.abs(counts)
        most = int(size.max(initial=0))
        width = max(len(str(most)), self.decimals + 1) + _BEFORE + 1
        table = np.empty((size.size, width), dtype=np.uint8)
        rest: NDArray[np.unsignedinteger] = size.astype(np.uint32 if most < 2**32 else np.uint64)
        dot = width - self.decimals - 1
        first = np.full(size.size, dot - 1)  # column of the first digit that is written
        table[:, dot] = ord(".")
        for column in (*range(width - 1, dot, -1), *range(dot - 1, _BEFORE - 1, -1)):
            before = rest // 10
            table[:, column] = rest - before * 10 + ord("0")
            if column < dot - 1:
                first -= rest > 0
            rest = before
        first += np.arange(0, table.size, width)
        flat = table.reshape(-1)
        negative = np.flatnonzero(counts < 0)
        first[negative] -= 1
        flat[first[negative]] = ord("-")
        flat[first - 1] = ord(self.letter)
        flat[first - 2] = ord(" ")
        begin, length = np.zeros((2, self.named.size), dtype=np.int64)
        begin[named] = first - 1 - self.blank[named]
        length[named] = np.arange(width, table.size + 1, width) - begin[named]
        return flat, (begin + place, length)


def put_together(store: Sequence[Characters], segments: Sequence[Segment]) -> str:
    """The texts of n blocks, each of them its segments of the store one after another."""
    begin, length = (np.stack(of, axis=1, dtype=np.int32).reshape(-1) for of in zip(*segments, strict=True))
    before = np.cumsum(length, dtype=np.int32) - length
    place = np.repeat(begin - before, length)
    place += np.arange(place.size, dtype=np.int32)
    return bytes(np.take(np.concatenate(store), place)).decode("latin-1")


@dataclass(frozen=True, eq=False, kw_only=True)
class RunBlocks:
    """A run of n blocks in p pieces, each a block to be written.

    pieces: (n,), into how many each block is cut. counts: (n_axes, p), what words count, in units of their last
    decimal; stay: (n_axes, p), whether an axis is where the words before have put it; unchanged: (p,), whether the
    words of the block as it was read would do. cut: (n,), whether a block becomes several. arcs: of the pieces.
    """

    run: PlainRun
    pieces: NDArray[np.int64]
    counts: NDArray[np.int64]
    stay: NDArray[np.bool_]
    unchanged: NDArray[np.bool_]
    cut: NDArray[np.bool_]
    arcs: Pieces

    def text(self, axes: tuple[str, ...], decimals: list[int], step: float) -> str:
        """What is written. decimals: of each axis; step: of words of centres, mm or inch."""
        kept = self._first | self._named.any(axis=0)
        if not kept.all():
            return self._some(kept).text(axes, decimals, step)
        store = [self.run.source, _CODES, self._eol]
        codes = store[0].size
        leads, tails = self._leads(codes), self._tails(codes + _CODES.size)
        segments, place = leads, codes + _CODES.size + self._eol.size
        for words in self._words(axes, decimals, step):
            characters, segment = words.texts(place)
            store.append(characters)
            segments.append(segment)
            place += characters.size
        return put_together(store, segments + tails)

    def _some(self, kept: NDArray[np.bool_]) -> "RunBlocks":
        """Without some pieces: of those without words nothing is written."""
        return replace(
            self,
            pieces=np.add.reduceat(kept.astype(np.int64), np.cumsum(self.pieces) - self.pieces),
            counts=columns_of(self.counts, kept),
            stay=columns_of(self.stay, kept),
            unchanged=self.unchanged[kept],
            arcs=self.arcs.some(np.flatnonzero(kept[self.arcs.at]))._replace(
                at=(np.cumsum(kept) - 1)[self.arcs.at[kept[self.arcs.at]]]
            ),
        )

    @property
    def _eol(self) -> Characters:
        return np.frombuffer(self.run.eol.encode("latin-1"), dtype=np.uint8)

    @cached_property
    def _block(self) -> NDArray[np.int64] | slice:
        """The block of each piece."""
        return np.repeat(np.arange(self.pieces.size), self.pieces) if self.cut.any() else slice(None)

    @cached_property
    def _first(self) -> NDArray[np.bool_]:
        """Whether each piece is the first of its block."""
        if not self.cut.any():
            return np.ones(self.pieces.size, dtype=bool)
        return np.diff(np.repeat(np.arange(self.pieces.size), self.pieces), prepend=-1) > 0

    @cached_property
    def _named(self) -> NDArray[np.bool_]:
        """Axis words that are written, (n_axes, p)."""
        return (columns_of(self.run.written, self._block) & self._first) | ~self.stay

    @cached_property
    def _places(self) -> BlockPlaces:
        """Of each piece."""
        return self.run.places.of(self._block)

    @cached_property
    def _round(self) -> NDArray[np.bool_]:
        """Which pieces are arcs."""
        found = np.zeros(self.unchanged.size, dtype=bool)
        found[self.arcs.at] = True
        return found

    @cached_property
    def _as_it_is(self) -> NDArray[np.bool_]:
        """Whether a block stays as it was read."""
        added = (self._named & ~columns_of(self.run.written, self._block)).any(axis=0)
        straight = self.run.motion[self._block] <= _LINE
        return self.unchanged & ~self.cut[self._block] & straight & ~added & self.run.stays[self._block]

    def _words(self, axes: tuple[str, ...], decimals: list[int], step: float) -> Iterator[Words]:
        """Axis words, then those of centres."""
        blank, before = self.run.blank[self._block], np.zeros(self.unchanged.size, dtype=bool)
        for row, axis in enumerate(axes):
            named = self._named[row] & ~self._as_it_is
            if named.any():
                yield Words(
                    letter=axis, decimals=decimals[row], counts=self.counts[row], named=named, blank=before & blank
                )
                before |= named
        arcs = self.arcs
        if not arcs.at.size:
            return
        digits = decimals[axes.index("X")]
        by_radius = np.zeros(self.run.count, dtype=bool)
        by_radius[self.run.arcs.index] = self.run.arcs.by_radius
        by_radius = by_radius[self._block][arcs.at]
        values = np.vstack([arcs.centre, arcs.radius]) / (MM_PER_INCH if self.run.inch else 1.0)
        counts = np.zeros((3, before.size), np.int64)
        counts[:, arcs.at] = np.rint(values / step) * round(step * 10**digits)
        rows = arcs.rows[:, 0].tolist()  # the plane is the same for all of a run
        order = sorted(((rows[0], 0), (rows[1], 1)))
        for letter, number in (*(("IJK"[row], number) for row, number in order), ("R", 2)):
            named = np.zeros_like(before)
            named[arcs.at] = by_radius == (letter == "R")
            if named.any():
                yield Words(letter=letter, decimals=digits, counts=counts[number], named=named, blank=blank)

    def _leads(self, codes: int) -> list[Segment]:
        """What stands before the words of each piece; codes: where those of motions begin in the store."""
        run, block, first, places, as_it_is = self.run, self._block, self._first, self._places, self._as_it_is
        begin = places.begin
        if not (len(run.arcs) or run.inserts.any()):
            return [(begin, np.where(as_it_is, places.after, np.where(first, places.first, begin)) - begin)]
        turns = run.motion[block] > _LINE
        replaced = first & turns & ~self._round & ~run.inserts[block]  # G2 and G3 of what has become lines
        before = np.where(replaced, places.code, np.where(first, places.first, begin))
        lead = begin, np.where(as_it_is, places.after, before) - begin
        behind = (
            np.where(replaced, places.code_end, places.first),
            np.where(replaced, places.first - places.code_end, 0),
        )
        inserted = (first & run.inserts[block]) | (~first & (self._round | np.append(False, self._round[:-1])))
        motion = np.where(turns & ~self._round, _LINE, run.motion[block])
        blank = run.blank[block]
        last = run.source[np.maximum(places.first - 1, 0)]
        parted = inserted & first & blank & (places.first > begin) & (last != ord(" ")) & (last != ord("\t"))
        length = np.where(inserted | replaced, 2 + parted + (inserted & blank), 0)
        return [lead, (codes + _CODE * motion + 1 - parted, length), behind]

    def _tails(self, eol: int) -> list[Segment]:
        """What stands behind the words of each piece; eol: where the line end begins in the store."""
        run, block, places, as_it_is = self.run, self._block, self._places, self._as_it_is
        if not self.cut.any():
            return [(places.last, np.where(as_it_is, 0, places.after - places.last))]
        cut, size = self.cut[block], len(run.eol)
        last = np.append(self._first[1:], True)
        tail = np.where(cut, np.where(self._first, places.end - places.last, 0), places.after - places.last)
        behind = places.end + size
        return [
            (places.last, np.where(as_it_is, 0, tail)),
            (np.full(cut.size, eol), np.where(cut, size, 0)),
            (behind, np.where(cut & last, places.after - behind, 0)),
        ]
