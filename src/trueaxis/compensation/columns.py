"""Many moves at once, in columns: arcs, which are cut into chords, and runs of blocks that were read together."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import SAME_POINT, Arc
from trueaxis.compensation.machine import FloatArray

MOST_CHORDS = 200_000
_Value = TypeVar("_Value", bound=np.generic)


def columns_of(table: NDArray[_Value], of: slice | NDArray[np.int64] | NDArray[np.bool_]) -> NDArray[_Value]:
    """Some columns of a table (k, n), with each row side by side in memory.

    Indexing would lay each column side by side: sixteen times slower itself, and so is what is done with the rows.
    """
    if isinstance(of, slice):
        return table[:, of]
    return table.take(np.flatnonzero(of) if of.dtype == np.bool_ else of, axis=1)


def carried(values: NDArray[_Value], known: NDArray[np.bool_], start: float) -> NDArray[_Value]:
    """The values (n,) that are known, each until the next is; start: before the first."""
    if known.all():
        return values
    last = np.maximum.accumulate(np.where(known, np.arange(known.size), -1))
    return np.where(last >= 0, values[np.maximum(last, 0)], start)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Arcs:
    """Arcs of moves, k of them, in columns.

    index: (k,), which moves, ascending. centre, normal: (3, k) and sweep: (k,), as in Arc. by_radius: (k,), whether the
    words are those of a radius. kept: (k,), whether it may stay an arc.
    """

    index: NDArray[np.int64]
    centre: FloatArray
    normal: FloatArray
    sweep: FloatArray
    by_radius: NDArray[np.bool_]
    kept: NDArray[np.bool_]

    @classmethod
    def of(cls, arcs: Sequence[Arc], index: Sequence[int], by_radius: Sequence[bool], kept: Sequence[bool]) -> "Arcs":
        """Arcs that were read one by one."""
        return cls(
            index=np.array(index, dtype=np.int64),
            centre=np.array([arc.centre for arc in arcs], dtype=np.float64).reshape(-1, 3).T,
            normal=np.array([arc.normal for arc in arcs], dtype=np.float64).reshape(-1, 3).T,
            sweep=np.array([arc.sweep for arc in arcs], dtype=np.float64),
            by_radius=np.array(by_radius, dtype=bool),
            kept=np.array(kept, dtype=bool),
        )

    def __len__(self) -> int:
        return int(self.index.size)

    def some(self, which: NDArray[np.bool_] | NDArray[np.int64]) -> "Arcs":
        """Some of them."""
        return Arcs(
            index=self.index[which], centre=columns_of(self.centre, which), normal=columns_of(self.normal, which),
            sweep=self.sweep[which], by_radius=self.by_radius[which], kept=self.kept[which],
        )  # fmt: skip

    def moved(self, by: int) -> "Arcs":
        """The same of moves that have so many before them."""
        return replace(self, index=self.index + by)

    def and_then(self, later: "Arcs") -> "Arcs":
        """With those of later moves."""
        return Arcs(
            index=np.concatenate([self.index, later.index]),
            centre=np.concatenate([self.centre, later.centre], axis=1),
            normal=np.concatenate([self.normal, later.normal], axis=1),
            sweep=np.concatenate([self.sweep, later.sweep]),
            by_radius=np.concatenate([self.by_radius, later.by_radius]),
            kept=np.concatenate([self.kept, later.kept]),
        )


NO_ARCS = Arcs.of([], [], [], [])


def chord_counts(radius: FloatArray, sweep: FloatArray, tolerance: float) -> NDArray[np.int64]:
    """Equal chords that stay within `tolerance` mm of arcs: sagitta r (1 - cos(step / 2)), at most a quarter turn."""
    ratio = np.minimum(tolerance / np.maximum(radius, SAME_POINT), 1.0)
    step = np.minimum(2.0 * np.arccos(1.0 - ratio), math.pi / 2.0)
    return np.maximum(np.ceil(sweep / np.maximum(step, 1e-9) - 1e-9), 1.0).astype(np.int64)


class Chords(NamedTuple):
    """Ends of the chords of many arcs, one after another: arc index (n,), share of the arc (n,), X Y Z (3, n)."""

    arc: NDArray[np.int64]
    share: FloatArray
    points: FloatArray


def arc_radii(starts: FloatArray, ends: FloatArray, arcs: Arcs) -> FloatArray:
    """Distances of both ends from the axes of arcs, (2, n_arcs), mm; starts and ends are X Y Z, mm, (3, n_arcs)."""
    offs = (places - arcs.centre for places in (starts, ends))
    across = (off - np.einsum("in,in->n", off, arcs.normal) * arcs.normal for off in offs)
    return np.stack([np.sqrt(np.einsum("in,in->n", off, off)) for off in across])


def chords(starts: FloatArray, ends: FloatArray, arcs: Arcs, count: NDArray[np.int64]) -> Chords:
    """Cut arcs into chords whose ends lie on them; starts and ends are X Y Z, mm, (3, n_arcs); count: (n_arcs,)."""
    centre, normal, sweep = arcs.centre, arcs.normal, arcs.sweep
    rise0 = np.einsum("in,in->n", starts - centre, normal)
    rise1 = np.einsum("in,in->n", ends - centre, normal)
    across0 = starts - centre - rise0 * normal
    across1 = ends - centre - rise1 * normal
    radius0 = np.sqrt(np.einsum("in,in->n", across0, across0))
    radius1 = np.sqrt(np.einsum("in,in->n", across1, across1))
    first = across0 / radius0
    second = np.cross(normal, first, axis=0)
    arc = np.repeat(np.arange(len(arcs)), count)
    number = np.arange(arc.size) - np.repeat(np.cumsum(count) - count, count) + 1
    share = number / count[arc]
    angle = share * sweep[arc]
    radius = radius0[arc] + share * (radius1 - radius0)[arc]
    rise = rise0[arc] + share * (rise1 - rise0)[arc]
    points = (
        columns_of(centre, arc)
        + radius * (np.cos(angle) * columns_of(first, arc) + np.sin(angle) * columns_of(second, arc))
        + rise * columns_of(normal, arc)
    )
    last = number == count[arc]
    points[:, last] = ends
    return Chords(arc, share, points)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class BlockPlaces:
    """Where the text of n blocks is in the bytes of a source, each (n,).

    begin; first: end of what stands before the axis and arc words; last: end of these words; end: of the block, without
    its line end; after: end of the text behind it that moves nothing. code, code_end: the G word of its motion, both
    `first` where it has none.
    """

    begin: NDArray[np.int64]
    first: NDArray[np.int64]
    last: NDArray[np.int64]
    end: NDArray[np.int64]
    after: NDArray[np.int64]
    code: NDArray[np.int64]
    code_end: NDArray[np.int64]

    def moved(self, by: int) -> "BlockPlaces":
        """In a source that begins elsewhere."""
        return BlockPlaces(
            begin=self.begin + by, first=self.first + by, last=self.last + by, end=self.end + by, after=self.after + by,
            code=self.code + by, code_end=self.code_end + by,
        )  # fmt: skip

    def of(self, of: slice | NDArray[np.int64]) -> "BlockPlaces":
        """Of some blocks."""
        return BlockPlaces(
            begin=self.begin[of], first=self.first[of], last=self.last[of], end=self.end[of], after=self.after[of],
            code=self.code[of], code_end=self.code_end[of],
        )  # fmt: skip


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PlainRun:
    """Blocks that move, n of them, each an item like `Move`, whose fields it shares but for these.

    line: (n,). motion: (n,), 0 to 3 as of G. ends: (n_axes, n), mm and deg. written: (n_axes, n), whether a block has
    the word. blank: (n,), whether a blank separates words. source: bytes; places: of the blocks in it. inserts: whether
    the G word of its motion is put into a block. arcs: of the blocks. feed: (n,).
    held, elsewhere, unnamed, shift: of all blocks. passable: whether the tool may run through ends behind which nothing
    stands. stays: (n,), whether a block whose words hold may stay as it is.
    """

    line: NDArray[np.int64]
    motion: NDArray[np.int64]
    ends: FloatArray
    written: NDArray[np.bool_]
    absolute: bool
    inch: bool
    blank: NDArray[np.bool_]
    eol: str
    source: NDArray[np.uint8]
    places: BlockPlaces
    inserts: NDArray[np.bool_]
    arcs: Arcs
    feed: FloatArray
    held: tuple[bool, ...]
    elsewhere: tuple[bool, ...]
    shift: tuple[float, ...]
    stays: NDArray[np.bool_]
    unnamed: tuple[bool, ...] = ()
    passable: bool = True

    @property
    def count(self) -> int:
        """Number of blocks."""
        return int(self.motion.size)

    @property
    def run_through(self) -> NDArray[np.bool_]:
        """(n,): whether the tool may run through the end of a block, as far as the run says."""
        return self.passable & (self.places.after - self.places.end <= len(self.eol))

    def loads(self, start: Sequence[float] | None, spacing: float, chords: FloatArray) -> FloatArray:
        """About how many points each block takes: one for each `spacing` of its way, and the chords of arcs.

        start: of the first block, which has no length where that is not given.
        """
        before = self.ends[:, :1] if start is None else np.array(start)[:, np.newaxis]
        way = np.sqrt((np.diff(self.ends, axis=1, prepend=before) ** 2).sum(axis=0))
        loads = 1.0 + np.where(self.motion > 0, way / spacing, 0.0)
        loads[self.arcs.index] += chords
        return np.asarray(loads)

    def radii(self, rows: Sequence[int]) -> FloatArray:
        """Radius of each arc at most, mm; rows: of X Y Z."""
        off = columns_of(self.ends[rows], self.arcs.index) - self.arcs.centre
        return np.asarray(np.sqrt((off**2).sum(axis=0)))

    def parts(self, loads: FloatArray, most: float, first: float) -> Iterator[tuple["PlainRun", float]]:
        """The run in parts that just reach `most` points, the first of them `first`, with their points."""
        edges, total = [0], np.cumsum(loads)
        while edges[-1] < self.count:
            before = total[edges[-1] - 1] if edges[-1] else first - most
            edges.append(min(int(np.searchsorted(total, before + most)) + 1, self.count))
        for begin, end in pairwise(edges):
            of_part = float(total[end - 1] - (total[begin - 1] if begin else 0.0))
            yield self.part(begin, end) if len(edges) > 2 else self, of_part

    def part(self, first: int, last: int) -> "PlainRun":
        """Some of the blocks."""
        of = slice(first, last)
        arcs = self.arcs.some((self.arcs.index >= first) & (self.arcs.index < last)).moved(-first)
        return replace(
            self, line=self.line[of], motion=self.motion[of], ends=self.ends[:, of], written=self.written[:, of],
            blank=self.blank[of], places=self.places.of(of), inserts=self.inserts[of], arcs=arcs, feed=self.feed[of],
            stays=self.stays[of],
        )  # fmt: skip
