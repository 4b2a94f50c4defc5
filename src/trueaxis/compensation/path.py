"""The moves of a batch, by columns, and the points of their path: arcs cut into chords, every point with its block."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import NO_ARCS, Arcs, PlainRun, chords, columns_of
from trueaxis.compensation.machine import LINEAR, FloatArray
from trueaxis.compensation.moves import Kind, Move

Held = NDArray[np.bool_]


@dataclass(frozen=True, slots=True, kw_only=True)
class Places:
    """What is known of where axes stand, each (n_axes, n_points): held, axes that got no word although compensation
    would move them; elsewhere, axes that may stand anywhere; unnamed, linear axes that the program has not moved yet.
    parking: (n_points,), rapids in machine coordinates (G53). allowed: (n_points,), largest tool point error, mm.
    unplaced: (n_points,), see `unplaced_tips`.
    """

    held: Held
    elsewhere: Held
    unnamed: Held
    parking: NDArray[np.bool_]
    allowed: FloatArray
    unplaced: NDArray[np.bool_]

    @property
    def uncounted(self) -> Held:
        """Axes of which the program does not say where they are to be."""
        return self.held & self.unnamed


def alike(flags: Held) -> list[NDArray[np.int64]]:
    """Indices of the columns (k, n) that have the same flags, in the order of the first of each; not of those that have
    none.
    """
    kinds = (1 << np.arange(flags.shape[0])) @ flags
    some = np.flatnonzero(kinds)
    _, first, number = np.unique(kinds[some], return_index=True, return_inverse=True)
    return [some[number == kind] for kind in np.argsort(first)]


def standing(positions: FloatArray, held: Held, previous: FloatArray) -> FloatArray:
    """Positions (n_axes, n) with those of held axes as they were last; previous: (n_axes,), before the first."""
    if not held.any():
        return positions
    last = np.maximum.accumulate(np.where(held, -1, np.arange(positions.shape[1])), axis=1)
    before = np.take_along_axis(positions, np.maximum(last, 0), axis=1)
    return np.where(last >= 0, before, previous[:, None])


def holds_arc(held: Sequence[bool], normal: Sequence[float]) -> bool:
    """Whether an axis without a word keeps an arc from staying one: any but the linear one across its plane.

    held: of each axis, X Y Z first; normal: of the arc.
    """
    across = max(range(len(LINEAR)), key=lambda row: abs(normal[row]))
    return any(one for row, one in enumerate(held) if row != across)


class MoveTable:
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

    def singles(self) -> Iterator[tuple[int, Move]]:
        """Moves that came one by one, with their indices: all that is not plain is among them."""
        for first, part in zip(self._firsts.tolist(), self._parts, strict=False):
            if isinstance(part, list):
                yield from enumerate(part, first)

    def without_arcs(self) -> "MoveTable":
        """The same with lines instead of arcs."""
        straight = [
            item._replace(arc=None) if isinstance(item, Move) else replace(item, arcs=NO_ARCS) for item in self.items
        ]
        return MoveTable(straight, self._axes)

    @property
    def arcs(self) -> Arcs:
        """Those that are arcs."""
        found = NO_ARCS
        for first, part in zip(self._firsts.tolist(), self._parts, strict=False):
            if isinstance(part, list):
                round_ones = [(index, move, move.arc) for index, move in enumerate(part) if move.arc is not None]
                of_part = Arcs.of(
                    [arc for _, _, arc in round_ones],
                    [index for index, _, _ in round_ones],
                    [move.round is not None and move.round.centre == "radius" for _, move, _ in round_ones],
                    [move.round is not None and not holds_arc(move.held, arc.normal) for _, move, arc in round_ones],
                )
            else:
                of_part = part.arcs
            if len(of_part):
                found = found.and_then(of_part.moved(first))
        return found

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
        return self._column(lambda move: move.line, lambda run: run.line, np.int64)

    @property
    def motion(self) -> NDArray[np.int64]:
        """(n,), `Kind` of each."""
        return self._column(lambda move: move.kind, lambda run: np.minimum(run.motion, Kind.ARC), np.int64)

    @property
    def feed(self) -> FloatArray:
        """(n,), as in Move."""
        return self._column(lambda move: move.feed, lambda run: run.feed, np.float64)

    @property
    def absolute(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.absolute, lambda run: run.absolute, np.bool_)

    @property
    def inch(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.inch, lambda run: run.inch, np.bool_)

    @property
    def start_stated(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.start_stated, lambda _: False, np.bool_)

    @property
    def passable(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.passable, lambda run: run.passable, np.bool_)

    @property
    def in_machine(self) -> NDArray[np.bool_]:
        """(n,)."""
        return self._column(lambda move: move.in_machine, lambda _: False, np.bool_)

    @property
    def run_through(self) -> NDArray[np.bool_]:
        """(n,): the same of their ends, as far as each item says."""
        return self._column(lambda move: move.passable, lambda run: run.run_through, np.bool_)

    @property
    def held(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda item: item.held)

    @property
    def elsewhere(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda item: item.elsewhere)

    @property
    def unnamed(self) -> Held:
        """(n_axes, n)."""
        return self._flags(lambda item: item.unnamed)

    @property
    def shift(self) -> FloatArray:
        """Position minus word, (n_axes, n), mm and deg."""
        return self._rows(lambda item: item.shift)

    def _column(
        self, of_move: Callable[[Move], object], of_run: Callable[[PlainRun], object], kind: type
    ) -> NDArray[Any]:
        out: NDArray[Any] = np.empty(len(self), dtype=kind)
        for first, count, part in zip(self._firsts.tolist(), self._counts, self._parts, strict=False):
            out[first : first + count] = [of_move(move) for move in part] if isinstance(part, list) else of_run(part)
        return out

    def _flags(self, of: Callable[[Move | PlainRun], tuple[bool, ...]]) -> Held:
        return self._rows(of).astype(bool)

    def _rows(self, of: Callable[[Move | PlainRun], tuple[float, ...]]) -> FloatArray:
        """(n_axes, n); 0 where a move says nothing."""
        out = np.zeros((self._axes, len(self)))
        for first, count, part in zip(self._firsts.tolist(), self._counts, self._parts, strict=False):
            if not isinstance(part, list):
                if values := of(part):
                    out[:, first : first + count] = np.array(values)[:, np.newaxis]
                continue
            of_moves = [of(move) for move in part]
            if any(of_moves):
                none = (0,) * self._axes
                out[:, first : first + count] = np.array([values or none for values in of_moves]).T
        return out


def follows_at_once(batch: Sequence[str | Move | PlainRun], moves: MoveTable, after: bool) -> NDArray[np.bool_]:
    """For each move of a batch whether another follows at once and the tool may run through the end between them.

    after: whether a move follows the batch at once that may be run into.
    """
    follows = np.append(moves.passable[1:], after) & moves.run_through
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


def xyz_of(positions: FloatArray, axes: tuple[str, ...]) -> FloatArray:
    """X Y Z, mm, (3, n), of positions (n_axes, n); 0 where there is no such axis."""
    out = np.zeros((len(LINEAR), positions.shape[1]))
    for row, axis in enumerate(axes):
        if axis in LINEAR:
            out[LINEAR.index(axis)] = positions[row]
    return out


def path_of(
    moves: MoveTable, start: FloatArray, axes: tuple[str, ...], round_ones: Arcs, chord_count: NDArray[np.int64]
) -> Path:
    """Points of the moves; `start` (n_axes,) is the position before them, NaN where it is not known. round_ones: those
    that are arcs, with the number of chords of each.

    Where a move starts is not known either where its axes stand only where the program has not commanded them to.
    """
    ends = moves.ends
    starts = np.concatenate([start[:, None], ends[:, :-1]], axis=1)
    rapid, stated = moves.motion == Kind.RAPID, moves.start_stated
    arcs = round_ones.index
    if arcs.size == 0:
        starts[:, stated] = np.nan
        return Path(points=ends, origins=starts, owner=np.arange(len(moves)), rapid=rapid, halts=np.zeros_like(rapid))
    first, last = (xyz_of(columns_of(of, arcs), axes) for of in (starts, ends))
    cut = chords(first, last, round_ones, chord_count)
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
    points = columns_of(np.concatenate([columns_of(ends, straight), on_arcs], axis=1), order)
    owner = owner[order]
    origins = np.concatenate([start[:, None], points[:, :-1]], axis=1)
    origins[:, stated[owner]] = np.nan  # such a move is no arc in G90: it has one point
    return Path(points=points, origins=origins, owner=owner, rapid=rapid[owner], halts=np.zeros(owner.size, dtype=bool))
