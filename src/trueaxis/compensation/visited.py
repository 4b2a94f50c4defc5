"""Which parts of the travel a program visits, and how far it is corrected there: bounded, however long it is."""

from collections.abc import Sequence
from itertools import product

import numpy as np

from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows, rotary_rows
from trueaxis.model.volume import quasi_random

LEAST_SAMPLES = 2000  # within the cells
MOST_CELLS = 20_000  # of the whole travel: 27 along each of three axes, 7 along each of five


class Visited:
    """The cells of the travel that a program comes to or passes through, with the largest correction in each.

    tool_point: the one that came there, (3, 1), mm, tool frame. largest_turn: the largest correction of a rotary axis,
    deg, at the programmed position `turned_at`, (n_axes,).
    """

    def __init__(self, model: ErrorModel, tool_point: FloatArray) -> None:
        self.tool_point = tool_point
        self._linear, self._rotary = list(linear_rows(model.axes)), list(rotary_rows(model.axes))
        self._each = int(MOST_CELLS ** (1.0 / len(model.axes)))
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._low = low[:, np.newaxis]
        self._width = np.maximum(high - low, 1e-9)[:, np.newaxis] / self._each
        self._strides = self._each ** np.arange(len(model.axes))
        self._cells: dict[int, tuple[FloatArray, float]] = {}
        self._lowest = np.full(len(model.axes), np.inf)
        self._highest = np.full(len(model.axes), -np.inf)
        self.largest_turn, self.turned_at = 0.0, low

    def add(self, origins: FloatArray, positions: FloatArray, moved: FloatArray) -> None:
        """Note motions from origins to positions, (n_axes, n), mm or deg, and what their ends are corrected by.

        An origin that is not known is NaN.
        """
        if positions.shape[1] == 0:
            return
        self._lowest = np.minimum(self._lowest, positions.min(axis=1))
        self._highest = np.maximum(self._highest, positions.max(axis=1))
        turns = np.abs(moved[self._rotary]).max(axis=0, initial=0.0)
        if turns.max() > self.largest_turn:
            self.largest_turn, self.turned_at = float(turns.max()), positions[:, int(np.argmax(turns))]
        corrections = np.sqrt((moved[self._linear] ** 2).sum(axis=0))
        way = np.where(np.isnan(origins), 0.0, positions - origins)
        # two samples to a cell's width: none is passed through unseen
        parts = np.maximum(np.ceil(2.0 * np.abs(way / self._width).max(axis=0)), 1.0).astype(np.int64)
        source = np.repeat(np.arange(parts.size), parts)
        share = (np.arange(source.size) - np.repeat(np.cumsum(parts) - parts, parts)) / parts[source]
        self._note(positions[:, source] - share * way[:, source], np.where(share == 0.0, corrections[source], 0.0))

    def _note(self, positions: FloatArray, corrections: FloatArray) -> None:
        place = np.clip(((positions - self._low) / self._width).astype(np.int64), 0, self._each - 1)
        every = self._strides @ place
        order = np.lexsort((-corrections, every))  # of each cell the largest correction first
        keys, first = np.unique(every[order], return_index=True)
        for key, at in zip(keys.tolist(), order[first].tolist(), strict=True):
            correction = float(corrections[at])
            position, before = self._cells.get(key, (positions[:, at], 0.0))
            if correction > before:
                position = positions[:, at]
            self._cells[key] = (position, max(before, correction))

    @property
    def positions(self) -> FloatArray:
        """(n_axes, m): for each cell where its largest correction is, in the order of the first visits, mm or deg."""
        return np.array([position for position, _ in self._cells.values()]).reshape(-1, self._lowest.size).T

    @property
    def corrections(self) -> FloatArray:
        """(m,): the largest correction in each cell, mm."""
        return np.array([correction for _, correction in self._cells.values()])

    @property
    def ends(self) -> FloatArray:
        """(n_axes, 2): lowest and highest position of each axis, mm or deg; nothing visited: (n_axes, 0)."""
        if not self._cells:
            return np.zeros((self._lowest.size, 0))
        return np.stack([self._lowest, self._highest], axis=1)

    def samples(self, nodes: Sequence[Sequence[float]]) -> FloatArray:
        """(n_axes, k), mm or deg: corners of the visited cells, points within, and every node in their middle.

        nodes: of each axis, rising: positions at which curves may have what they have nowhere else.
        """
        keys = np.array(list(self._cells), dtype=np.int64)
        cells = keys[np.newaxis] // self._strides[:, np.newaxis] % self._each
        corners = [cells + np.array(step)[:, np.newaxis] for step in product((0, 1), repeat=self._lowest.size)]
        unique = np.unique(np.hstack(corners), axis=1)
        found = [self._low + unique * self._width]
        each = -(-LEAST_SAMPLES // keys.size)
        within = quasi_random(self._lowest.size, each * keys.size)  # corners may all lie at targets of a measurement
        found.append(self._low + (np.repeat(cells, each, axis=1) + within) * self._width)
        low, middle = self._low + cells * self._width, self._low + (cells + 0.5) * self._width
        for row, of_axis in enumerate(nodes):
            for node in of_axis:
                inside = (low[row] <= node) & (node <= low[row] + self._width[row])
                at = middle[:, inside]
                at[row] = node
                found.append(at)
        return np.hstack(found)
