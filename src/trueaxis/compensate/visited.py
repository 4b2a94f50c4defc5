"""Which parts of the travel a program visits, and how far it is corrected there: bounded, however long it is."""

import numpy as np

from trueaxis.compensate.machine import ErrorModel, FloatArray

MOST_CELLS = 20_000  # of the whole travel: 27 along each of three axes, 7 along each of five


class Visited:
    """One position and the largest correction for every cell of the travel that a program comes to.

    Errors are smooth over a cell, so that what is judged at one of its positions holds for all of it, nearly.
    """

    def __init__(self, model: ErrorModel) -> None:
        self._each = int(MOST_CELLS ** (1.0 / len(model.axes)))
        low, high = np.array([model.travel[axis] for axis in model.axes], dtype=np.float64).T
        self._low = low[:, np.newaxis]
        self._width = np.maximum(high - low, 1e-9)[:, np.newaxis] / self._each
        self._strides = self._each ** np.arange(len(model.axes))
        self._cells: dict[int, tuple[FloatArray, float]] = {}
        self._lowest = np.full(len(model.axes), np.inf)
        self._highest = np.full(len(model.axes), -np.inf)

    def add(self, positions: FloatArray, corrections: FloatArray) -> None:
        """Note programmed positions (n_axes, n), mm or deg, and the lengths of their corrections (n,), mm."""
        if positions.shape[1] == 0:
            return
        self._lowest = np.minimum(self._lowest, positions.min(axis=1))
        self._highest = np.maximum(self._highest, positions.max(axis=1))
        place = np.clip(((positions - self._low) / self._width).astype(np.int64), 0, self._each - 1)
        keys, first, inverse = np.unique(self._strides @ place, return_index=True, return_inverse=True)
        largest = np.zeros(keys.size)
        np.maximum.at(largest, inverse, corrections)
        for key, at, correction in zip(keys.tolist(), first.tolist(), largest.tolist(), strict=True):
            position, before = self._cells.get(key, (positions[:, at], 0.0))
            self._cells[key] = (position, max(before, correction))

    @property
    def positions(self) -> FloatArray:
        """(n_axes, m): one for each cell, in the order in which they were first visited, mm or deg."""
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
