"""What a compensation changed, point by point, for who asks for it: it grows with the program."""

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray


class Changes:
    """Gathers programmed and compensated positions, batch by batch."""

    def __init__(self, n_axes: int) -> None:
        self._lines: list[NDArray[np.int64]] = [np.zeros(0, dtype=np.int64)]
        self._programmed, self._compensated = [np.zeros((n_axes, 0))], [np.zeros((n_axes, 0))]

    def add(self, lines: NDArray[np.int64], programmed: FloatArray, compensated: FloatArray) -> None:
        """Note points (n,) with their lines; programmed, compensated: (n_axes, n), mm and deg."""
        self._lines.append(np.array(lines, dtype=np.int64))
        self._programmed.append(np.array(programmed))
        self._compensated.append(np.array(compensated))

    @property
    def lines(self) -> NDArray[np.int64]:
        """(n,): the line of the program that each point belongs to."""
        return np.concatenate(self._lines)

    @property
    def programmed(self) -> FloatArray:
        """(n_axes, n): ends of motions with those of chords and cuts, mm and deg."""
        return np.hstack(self._programmed)

    @property
    def compensated(self) -> FloatArray:
        """(n_axes, n): where the words that were written name them."""
        return np.hstack(self._compensated)
