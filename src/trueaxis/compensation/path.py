"""The moves of a batch, by columns, and the points of their path: arcs cut into chords, every point with its block."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from typing import overload

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.arcs import chords
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.nc_plain import PlainRun

Held = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Places:
    """What is known of where axes stand, each (n_axes, n_points): held, axes that got no word although compensation
    would move them; elsewhere, axes that may stand anywhere; unnamed, linear axes that the program has not moved yet.
    """

    held: Held
    elsewhere: Held
    unnamed: Held

    @property
    def uncounted(self) -> Held:
        """Axes of which the program does not say where they are to be."""
        return self.held & self.unnamed


def standing(positions: FloatArray, held: Held, previous: FloatArray) -> FloatArray:
    """Positions (n_axes, n) with those of held axes as they were last; previous: (n_axes,), before the first."""
    if not held.any():
        return positions
    last = np.maximum.accumulate(np.where(held, -1, np.arange(positions.shape[1])), axis=1)
    before = np.take_along_axis(positions, np.maximum(last, 0), axis=1)
    return np.where(last >= 0, before, previous[:, None])


class MoveTable(Sequence[Move]):
    """Moves one by one and in runs, in order; `axes` of them. items: as they came."""

    def __init__(self, items: Sequence[Move | PlainRun], axes: int) -> None:
        self.items, self._axes = items, axes
        self._parts: list[list[Move] | PlainRun] = []
        for single, group in groupby(items, lambda item: isinstance(item, Move)):
            of_kind = list(group)
            self._parts += [of_kind] if single else of_kind  # type: ignore[arg-type,list-item]  # all of them are
        self._counts = [len(part) if isinstance(part, list) else part.count for part in self._parts]
        self._firsts = np.concatenate([[0], np.cumsum(self._counts)]).astype(np.int64)

    def __len__(self) -> int:
        return int(self._firsts[-1])

    @overload
    def __getitem__(self, index: int) -> Move: ...
    @overload
    def __getitem__(self, index: slice) -> list[Move]: ...
    def __getitem__(self, index: int | slice) -> Move | list[Move]:
        if isinstance(index, slice):
            return [self[at] for at in range(*index.indices(len(self)))]
        at = range(len(self))[index]
        number = int(np.searchsorted(self._firsts, at, side="right")) - 1
        part, within = self._parts[number], at - int(self._firsts[number])
        return part[within] if isinstance(part, list) else part.move(within)

    def __iter__(self) -> Iterator[Move]:
        for part in self._parts:
            yield from part if isinstance(part, list) else map(part.move, range(part.count))

    def singles(self) -> Iterator[tuple[int, Move]]:
        """Moves that came one by one, with their indices: arcs, and all that is not plain, are among them."""
        for first, part in zip(self._firsts.tolist(), self._parts, strict=False):
            if isinstance(part, list):
                yield from enumerate(part, first)

    def without_arcs(self) -> "MoveTable":
        """The same with lines instead of arcs."""
        straight = [item._replace(arc=None) if isinstance(item, Move) else item for item in self.items]
        return MoveTable(straight, self._axes)

    @property
    def ends(self) -> FloatArray:
        """(n_axes, n), mm and deg."""
        parts = [
            np.array([move.end for move in part], dtype=np.float64).T if isinstance(part, list) else part.ends
            for part in self._parts
        ]
        return np.concatenate(parts, axis=1)

    @property
    def lines(self) -> NDArray[np.int64]:
        """(n,), of the source."""
        parts = [
            np.array([move.line for move in part]) if isinstance(part, list) else part.line + np.arange(part.count)
            for part in self._parts
        ]
        return np.concatenate(parts)

    @property
    def rapid(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.kind == Kind.RAPID, lambda run: run.kind == Kind.RAPID)

    @property
    def absolute(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.absolute, lambda run: run.absolute)

    @property
    def inch(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.inch, lambda run: run.inch)

    @property
    def start_stated(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.start_stated, lambda _: False)

    @property
    def passable(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.passable, lambda _: True)

    @property
    def held(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda move: move.held, lambda run: run.held)

    @property
    def elsewhere(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda move: move.elsewhere, lambda _: ())

    @property
    def unnamed(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda move: move.unnamed, lambda _: ())

    @property
    def shift(self) -> FloatArray:
        """Position minus word, (n_axes, n), mm and deg."""
        return self._rows(lambda move: move.shift, lambda run: run.shift)

    def _column(self, of_move: Callable[[Move], bool], of_run: Callable[[PlainRun], bool]) -> NDArray[np.bool_]:
        parts = [
            np.array([of_move(move) for move in part], dtype=bool)
            if isinstance(part, list)
            else np.full(part.count, of_run(part))
            for part in self._parts
        ]
        return np.concatenate(parts)

    def _flags(
        self, of_move: Callable[[Move], tuple[bool, ...]], of_run: Callable[[PlainRun], tuple[bool, ...]]
    ) -> Held:
        return self._rows(of_move, of_run).astype(bool)

    def _rows(
        self, of_move: Callable[[Move], tuple[float, ...]], of_run: Callable[[PlainRun], tuple[float, ...]]
    ) -> FloatArray:
        """(n_axes, n); 0 where a move says nothing."""
        out = np.zeros((self._axes, len(self)))
        for first, count, part in zip(self._firsts.tolist(), self._counts, self._parts, strict=False):
            if not isinstance(part, list):
                if values := of_run(part):
                    out[:, first : first + count] = np.array(values)[:, np.newaxis]
                continue
            of_moves = [of_move(move) for move in part]
            if any(of_moves):
                none = (0,) * self._axes
                out[:, first : first + count] = np.array([values or none for values in of_moves]).T
        return out


def follows_at_once(batch: Sequence[str | Move | PlainRun], moves: MoveTable, after: bool) -> NDArray[np.bool_]:
    """For each move of a batch whether another follows at once and the tool may run through the end between them.

    after: whether a move follows the batch at once that may be run into.
    """
    passable = moves.passable
    follows = np.append(passable[1:], after) & passable
    last = -1
    for item, behind in pairwise(batch):
        if not isinstance(item, str):
            last += item.count if isinstance(item, PlainRun) else 1
            if isinstance(behind, str):
                follows[last] = False
    if isinstance(batch[-1], str):
        follows[-1] = False
    return follows


@dataclass(frozen=True, slots=True, kw_only=True)
class Path:
    """Points to be reached one after another, each by a straight motion of the axes from `origins`.

    points, origins: (n_axes, n), mm and deg. owner: (n,), index of the move that a point belongs to, ascending.
    rapid: (n,), where only the end counts. halts: (n,), motions of no length in which an axis takes up what its
    reversal changes.
    """

    points: FloatArray
    origins: FloatArray
    owner: NDArray[np.int64]
    rapid: NDArray[np.bool_]
    halts: NDArray[np.bool_]

    @property
    def size(self) -> int:
        """Number of points."""
        return int(self.owner.size)


def path_of(moves: MoveTable, start: FloatArray, axes: tuple[str, ...], chord_tolerance: float) -> Path:
    """Points of the moves; `start` (n_axes,) is the position before them, NaN where it is not known.

    Where a move starts is not known either where its axes stand only where the program has not commanded them to.
    """
    ends = moves.ends
    starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
    rapid, stated = moves.rapid, moves.start_stated
    of_index = {index: move.arc for index, move in moves.singles() if move.arc is not None}
    arcs = np.array(list(of_index), dtype=np.int64)
    if arcs.size == 0:
        starts[:, stated] = np.nan
        return Path(points=ends, origins=starts, owner=np.arange(len(moves)), rapid=rapid, halts=np.zeros_like(rapid))

    def xyz(positions: FloatArray) -> FloatArray:
        out = np.zeros((3, positions.shape[1]))
        for row, axis in enumerate(axes):
            if axis in LINEAR:
                out[LINEAR.index(axis)] = positions[row]
        return out

    cut = chords(
        xyz(starts[:, arcs]),
        xyz(ends[:, arcs]),
        list(of_index.values()),
        chord_tolerance,
    )
    of_arc = arcs[cut.arc]
    on_arcs = np.empty((len(axes), of_arc.size))
    for row, axis in enumerate(axes):
        if axis in LINEAR:
            on_arcs[row] = cut.points[LINEAR.index(axis)]
        else:
            on_arcs[row] = starts[row, of_arc] + cut.share * (ends[row, of_arc] - starts[row, of_arc])
    straight = np.setdiff1d(np.arange(len(moves)), arcs, assume_unique=True)
    owner = np.concatenate([straight, of_arc])
    order = np.argsort(owner, kind="stable")
    points = np.concatenate([ends[:, straight], on_arcs], axis=1)[:, order]
    owner = owner[order]
    origins = np.concatenate([start[:, None], points[:, :-1]], axis=1)
    origins[:, stated[owner]] = np.nan  # such a move is no arc in G90: it has one point
    return Path(points=points, origins=origins, owner=owner, rapid=rapid[owner], halts=np.zeros(owner.size, dtype=bool))
