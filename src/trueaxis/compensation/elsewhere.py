"""What it may cost that an axis stands elsewhere than it is taken to stand: a rapid before its first word, or after a
tool change.

The words of the other axes take back errors that depend on it too. How much they would change if it stood anywhere
else within its travel is what is left, at most, of the error that they could have taken back.
"""

from collections.abc import Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.placed import of_points

# Places along the travel of each such axis, by how many there are: error curves bend a few times over the travel, and
# all combinations are looked at.
_PLACES = {1: 33, 2: 9, 3: 5}
_FEWEST_PLACES = 3
_AT_ONCE = 16384


def change_of_words(
    model: ErrorModel, points: FloatArray, elsewhere: NDArray[np.bool_], tool_point: FloatArray
) -> FloatArray:
    """Largest change of the words of the linear axes that are known, (n,), mm, over the travel of the others.

    points: (n_axes, n), mm and deg, for which the words are; elsewhere: (n_axes, n), axes that may stand anywhere;
    model: the machine at those points.
    """
    largest = np.zeros(points.shape[1])
    for pattern in np.unique(elsewhere, axis=1).T:
        if pattern.any():
            index = np.flatnonzero((elsewhere == pattern[:, None]).all(axis=0))
            for part in np.array_split(index, -(-index.size // _AT_ONCE)):
                largest[part] = _change(of_points(model, part), points[:, part], np.flatnonzero(pattern), tool_point)
    return largest


def _change(model: ErrorModel, points: FloatArray, rows: NDArray[np.int64], tool_point: FloatArray) -> FloatArray:
    known = [row for row in linear_rows(model.axes) if row not in rows]
    taken = _words(model, points, tool_point)[known]
    largest = np.zeros(points.shape[1])
    for places in _places(model, rows):
        there = points.copy()
        there[rows] = np.array(places)[:, None]
        change = _words(model, there, tool_point)[known] - taken
        largest = np.maximum(largest, np.sqrt((change**2).sum(axis=0)))
    return largest


def _places(model: ErrorModel, rows: NDArray[np.int64]) -> Iterator[tuple[float, ...]]:
    count = _PLACES.get(rows.size, _FEWEST_PLACES)
    yield from product(*(np.linspace(*model.travel[model.axes[row]], count).tolist() for row in rows))


def _words(model: ErrorModel, points: FloatArray, tool_point: FloatArray) -> FloatArray:
    """First correction of the axes, Eq. (55)."""
    return model.correction(points, -model.deviation(points, tool_point))
