"""A null space with a basis that can be read: few entries each."""

from collections.abc import Sequence

import numpy as np

from trueaxis.measurement.machine import FloatArray

SMALLEST_LEAD = 1e-6
ROUNDING = 1e-9


def reduced(null: FloatArray, first: Sequence[int] = (), rounding: float = ROUNDING) -> tuple[FloatArray, int]:
    """The same space (n, d) with another basis: reduced echelon form of the transpose; entries below
    `rounding` times the largest are set to zero.

    first: rows that are to lead a basis vector each where they can; then the largest entry left leads the next one.
    Returns the basis, each vector 1 at its lead and 0 at the others', and how many of `first` lead one.
    """
    rows = null.T.copy()
    led = 0
    for column in first:
        if led < rows.shape[0]:
            row = led + int(np.abs(rows[led:, column]).argmax())
            if abs(rows[row, column]) >= SMALLEST_LEAD:
                _lead(rows, led, row, column)
                led += 1
    for place in range(led, rows.shape[0]):
        row, column = divmod(int(np.abs(rows[place:]).argmax()), rows.shape[1])
        _lead(rows, place, place + row, column)
    rows[np.abs(rows) < rounding * np.abs(rows).max(initial=0.0)] = 0.0
    return rows.T, led


def _lead(rows: FloatArray, place: int, row: int, column: int) -> None:
    """Let the row lead at the column, as the row of that place."""
    rows[[place, row]] = rows[[row, place]]
    rows[place] /= rows[place, column]
    others = np.delete(np.arange(rows.shape[0]), place)
    rows[others] -= np.outer(rows[others, column], rows[place])
