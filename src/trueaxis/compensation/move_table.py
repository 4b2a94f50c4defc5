"""The moves of a batch, by columns."""

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby, pairwise
from typing import overload

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.held import Held
from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.moves import Kind, Move
from trueaxis.compensation.plain_run import PlainRun


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
