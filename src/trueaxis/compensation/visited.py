"""Where a program came to: bounded, however long it is."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import numpy.typing as npt

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.machine import ErrorModel, FloatArray, Place, linear_rows, rotary_rows

MOST_CELLS = 8000  # of a program: u at so many positions takes about half a second
# Errors do not differ within a cell of these, half a millimetre of a travel of 500 mm.
FINEST = 1024  # cells along an axis; a power of two: halves are whole
MOST_SAMPLES = 500_000  # along the motions of one batch: 30 MB


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Cells:
    """keys: (m,), which cells; position: (n_axes, m), mm or deg, where the correction (m,) is largest in each; low,
    high: (n_axes, m), what the axes pass within it.
    """

    keys: npt.NDArray[np.int64]
    position: FloatArray
    correction: FloatArray
    low: FloatArray
    high: FloatArray

    @classmethod
    def none(cls, axes: int) -> "_Cells":
        """Nothing visited."""
        empty = np.zeros((axes, 0))
        return cls(keys=np.zeros(0, np.int64), position=empty, correction=np.zeros(0), low=empty, high=empty)

    def each_once(self) -> "_Cells":
        """With what was visited of the same cell together; of equal corrections the first stays."""
        if not self.keys.size:
            return self
        stays = 2 * np.count_nonzero(np.diff(self.keys)) < self.keys.size  # a while in each cell, as most programs do
        few = self._together(slice(None)) if stays else self
        return few._together(np.argsort(few.keys, kind="stable"))

    def _together(self, order: slice | npt.NDArray[np.int64]) -> "_Cells":
        """In an order, with what stands side by side of the same cell together."""
        keys, correction = self.keys[order], self.correction[order]
        low, high = columns_of(self.low, order), columns_of(self.high, order)
        first = np.flatnonzero(np.diff(keys, prepend=keys[0] - 1))
        largest = np.maximum.reduceat(correction, first)
        there = np.flatnonzero(correction == np.repeat(largest, np.diff(first, append=keys.size)))
        chosen = there[np.searchsorted(there, first)]
        return _Cells(
            keys=keys[first], correction=largest,
            position=columns_of(self.position, chosen if isinstance(order, slice) else order[chosen]),
            low=np.minimum.reduceat(low, first, axis=1), high=np.maximum.reduceat(high, first, axis=1),
        )  # fmt: skip

    def and_later(self, later: "_Cells") -> "_Cells":
        """Together with what was visited later."""
        names = ("keys", "position", "correction", "low", "high")
        return _Cells(**{name: np.hstack([getattr(self, name), getattr(later, name)]) for name in names}).each_once()


class Visited:
    """Cells that a program comes to or passes through, each with a position of the program in it. They are as small as
    their bounded number allows: axes that stand still make no cells.

    tool_point: the one that came there, (3, 1), mm, tool frame. largest_turn: the largest correction of a rotary axis,
    deg, at the programmed position `turned_at`, (n_axes,). first_fed: (n_axes,), where the first feed motion came to;
    None: none did. datum: from where corrections count; None: home.
    """

    def __init__(self, model: ErrorModel, tool_point: FloatArray, datum: Place | None = None) -> None:
        self.tool_point, self.datum = tool_point, datum
        self._linear, self._rotary = list(linear_rows(model.axes)), list(rotary_rows(model.axes))
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._low = low[:, np.newaxis]
        self._travel = np.maximum(high - low, 1e-9)[:, np.newaxis]
        self._each = FINEST
        count = len(model.axes)
        self._cells = _Cells.none(count)
        self._lowest, self._highest = np.full(count, np.inf), np.full(count, -np.inf)
        self._directions = np.array([*np.eye(count), *-np.eye(count), *product((-1.0, 1.0), repeat=count)])
        self._farthest = np.zeros((count, 0))
        self.largest_turn, self.turned_at = 0.0, low
        self.first_fed: FloatArray | None = None

    def add(
        self, origins: FloatArray, positions: FloatArray, moved: FloatArray, fed: npt.NDArray[np.bool_] | None = None
    ) -> None:
        """Note motions from origins to positions, (n_axes, n), mm or deg, and what their ends are corrected by.

        An origin that is not known is NaN. fed: (n,), which are feed motions; None: all.
        """
        if positions.shape[1] == 0:
            return
        if self.first_fed is None and (fed is None or fed.any()):
            self.first_fed = positions[:, 0 if fed is None else int(np.argmax(fed))].copy()
        self._lowest = np.minimum(self._lowest, positions.min(axis=1))
        self._highest = np.maximum(self._highest, positions.max(axis=1))
        candidates = np.hstack([self._farthest, positions])
        self._farthest = candidates[:, np.argmax(self._directions @ (candidates / self._travel), axis=1)]
        turns = np.abs(moved[self._rotary]).max(axis=0, initial=0.0)
        if turns.max() > self.largest_turn:
            self.largest_turn, self.turned_at = float(turns.max()), positions[:, int(np.argmax(turns))]
        corrections = np.sqrt((moved[self._linear] ** 2).sum(axis=0))
        way = np.where(np.isnan(origins), 0.0, positions - origins)
        while (parts := self._parts(way)).sum() > MOST_SAMPLES and self._each > 1:
            self._halve()
        if parts.max() > 1:
            begin = np.cumsum(parts) - parts
            share = (np.arange(parts.sum()) - np.repeat(begin, parts)) / np.repeat(parts, parts)
            ends, corrections = corrections, np.zeros(share.size)
            corrections[begin] = ends
            positions = np.repeat(positions, parts, axis=1) - share * np.repeat(way, parts, axis=1)
            way = np.repeat(way / parts, parts, axis=1)
        self._note(positions, way, corrections)
        while self._cells.keys.size > MOST_CELLS:
            self._halve()

    def _parts(self, way: FloatArray) -> npt.NDArray[np.int64]:
        """(n,): into how many motions are divided: each shorter than a cell, so that none is passed over along the axis
        that passes most of them.
        """
        return np.asarray(np.abs(way / self._travel).max(axis=0) * self._each, dtype=np.int64) + 1

    def _note(self, positions: FloatArray, step: FloatArray, corrections: FloatArray) -> None:
        """Note positions (n_axes, n) that are reached by a step (n_axes, n)."""
        before = positions - step
        place = np.clip(((positions - self._low) / self._travel * self._each).astype(np.int64), 0, self._each - 1)
        found = _Cells(
            keys=self._strides @ place, position=positions, correction=corrections,
            low=np.minimum(positions, before), high=np.maximum(positions, before),
        )  # fmt: skip
        self._cells = self._cells.and_later(found.each_once())

    def _halve(self) -> None:
        """Make cells twice as long along every axis."""
        place = self._cells.keys // self._strides[:, np.newaxis] % self._each // 2
        self._each //= 2
        self._cells = replace(self._cells, keys=self._strides @ place).each_once()

    @property
    def _strides(self) -> npt.NDArray[np.int64]:
        return self._each ** np.arange(self._lowest.size, dtype=np.int64)

    @property
    def positions(self) -> FloatArray:
        """(n_axes, m): for each cell where its largest correction is, mm or deg."""
        return self._cells.position

    @property
    def corrections(self) -> FloatArray:
        """(m,): the largest correction in each cell, mm."""
        return self._cells.correction

    @property
    def ends(self) -> FloatArray:
        """(n_axes, 2): lowest and highest position of each axis, mm or deg; nothing visited: (n_axes, 0)."""
        if not self._cells.keys.size:
            return np.zeros((self._lowest.size, 0))
        return np.stack([self._lowest, self._highest], axis=1)

    def samples(self, nodes: Sequence[Sequence[float]]) -> FloatArray:
        """(n_axes, k), mm or deg: positions of the program: one of each cell, those farthest out, and where it passes
        nodes: of each axis, positions at which curves may have what they have nowhere else.
        """
        return np.hstack([self.positions, self._farthest, *self._at_nodes(nodes)])

    def _at_nodes(self, nodes: Sequence[Sequence[float]]) -> Iterator[FloatArray]:
        for row, of_axis in enumerate(nodes):
            for node in of_axis:
                at = self.positions[:, (self._cells.low[row] <= node) & (node <= self._cells.high[row])]
                at[row] = node
                yield at
