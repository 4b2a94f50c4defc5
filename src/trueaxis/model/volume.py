"""Positions in the volume of a machine: spread over its travels, its corners, planes through the middle.

Spread they are on no grid, which could hit the targets of a measurement and miss what is between.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product

import numpy as np

from trueaxis.machine.machine import LINEAR
from trueaxis.model.curves import FloatArray
from trueaxis.model.grid import Slice
from trueaxis.model.model import MachineModel, home_of


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


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Plane:
    """Two axes over their travels, (steps,) each, mm; positions: (n_axes, steps * steps), the first axis fastest; at:
    where the other axes stand.
    """

    axes: tuple[str, str]
    first: FloatArray
    second: FloatArray
    positions: FloatArray
    at: dict[str, float]

    def slice(self, values: FloatArray) -> "Slice":
        """Of values (n,) at its positions."""
        shaped = values.reshape(self.second.size, self.first.size)
        return Slice(axes=self.axes, first=self.first, second=self.second, values=shaped, at=self.at)


def middle_planes(model: MachineModel, steps: int) -> Iterator[Plane]:
    """One for each pair of linear axes, other linear axes in the middle, rotary axes at home."""
    home = dict(zip(model.axes, home_of(model)[:, 0].tolist(), strict=True))
    middle = {axis: 0.5 * sum(model.travel[axis]) if axis in LINEAR else home[axis] for axis in model.axes}
    for one, other in combinations([axis for axis in model.axes if axis in LINEAR], 2):
        first, second = (np.linspace(*model.travel[axis], steps) for axis in (one, other))
        grid = dict(zip((one, other), np.meshgrid(first, second), strict=True))
        rows = [grid[axis].ravel() if axis in grid else np.full(steps**2, middle[axis]) for axis in model.axes]
        at = {axis: value for axis, value in middle.items() if axis not in grid}
        yield Plane(axes=(one, other), first=first, second=second, positions=np.array(rows), at=at)
