"""Planes through the middle of the travels of a machine, as grids of positions."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from trueaxis.machine.machine import LINEAR
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of

FloatArray = NDArray[np.float64]


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
