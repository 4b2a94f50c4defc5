"""Axes that get no word: they stay where the words before have put them."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray
from trueaxis.compensation.moves import Move

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


def held_axes(moves: Sequence[Move], count: int) -> Held:
    """Which axes are held in which moves, (count, n_moves)."""
    return _flags([move.held for move in moves], count)


def axes_elsewhere(moves: Sequence[Move], count: int) -> Held:
    """Which axes may stand anywhere in which moves, (count, n_moves)."""
    return _flags([move.elsewhere for move in moves], count)


def axes_unnamed(moves: Sequence[Move], count: int) -> Held:
    """Which axes nothing in the program has moved by the end of each move, (count, n_moves)."""
    return _flags([move.unnamed for move in moves], count)


def _flags(of_moves: Sequence[tuple[bool, ...]], count: int) -> Held:
    if not any(of_moves):
        return np.zeros((count, len(of_moves)), dtype=bool)
    none = (False,) * count
    return np.array([flags or none for flags in of_moves], dtype=bool).T.reshape(count, len(of_moves))


def standing(positions: FloatArray, held: Held, previous: FloatArray) -> FloatArray:
    """Positions (n_axes, n) with those of held axes as they were last; previous: (n_axes,), before the first."""
    if not held.any():
        return positions
    last = np.maximum.accumulate(np.where(held, -1, np.arange(positions.shape[1])), axis=1)
    before = np.take_along_axis(positions, np.maximum(last, 0), axis=1)
    return np.where(last >= 0, before, previous[:, None])
