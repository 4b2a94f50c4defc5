"""Axes that get no word: they stay where the words before have put them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray

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
