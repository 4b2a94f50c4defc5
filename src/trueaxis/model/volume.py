"""Points in the volume of a machine: no grid, which could hit the targets of a measurement and miss what is between."""

from collections.abc import Mapping, Sequence
from itertools import product

import numpy as np

from trueaxis.model.curves import FloatArray


def quasi_random(dimensions: int, count: int) -> FloatArray:
    """(dimensions, count), 0 to 1: evenly spread, no coordinate twice, always the same, the first ones evenly, too.

    Shares of the powers of the root of x^(d+1) = x + 1, the golden ratio for one dimension (M. Roberts, The
    unreasonable effectiveness of quasirandom sequences, 2018). scipy.stats.qmc, which has others, takes half a second
    to import in every command.
    """
    root = 2.0
    for _ in range(64):
        root = (1.0 + root) ** (1.0 / (dimensions + 1))
    steps = root ** -np.arange(1.0, dimensions + 1.0)
    return np.asarray((0.5 + steps[:, np.newaxis] * np.arange(1.0, count + 1.0)) % 1.0)


def volume_points(travel: Mapping[str, tuple[float, float]], axes: Sequence[str], count: int) -> FloatArray:
    """(n_axes, count), mm or deg, spread over the travels."""
    low, high = np.array([travel[axis] for axis in axes], dtype=np.float64).T[:, :, np.newaxis]
    return np.asarray(low + (high - low) * quasi_random(len(axes), count))


def corners(travel: Mapping[str, tuple[float, float]], axes: Sequence[str]) -> FloatArray:
    """(n_axes, 2**n_axes), mm or deg."""
    return np.array(list(product(*(travel[axis] for axis in axes))), dtype=np.float64).T
