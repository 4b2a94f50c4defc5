"""The uncertainty of the tool point on slices through the middle of the volume."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.estimation.result import Estimate
from trueaxis.estimation.tool_point import tool_point
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Vector
from trueaxis.runtime.uncertainty import home_of
from trueaxis.spec.machine import LINEAR

STEPS = 25  # along either side of a slice


@dataclass(frozen=True, slots=True, eq=False)
class Slice:
    """Two axes that move to (n,) and (m,), mm; u: (m, n), mm, of the tool point; at: where the other axes stand."""

    axes: tuple[str, str]
    first: FloatArray
    second: FloatArray
    u: FloatArray
    at: dict[str, float]


def slices(found: Estimate, tools: Sequence[Vector]) -> tuple[Slice, ...]:
    """One for each pair of linear axes, other linear axes in the middle, rotary axes at home."""
    model = found.layout.model
    home = dict(zip(model.axes, home_of(model)[:, 0].tolist(), strict=True))
    middle = {axis: 0.5 * sum(model.travel[axis]) if axis in LINEAR else home[axis] for axis in model.axes}
    made = []
    for one, other in combinations([axis for axis in model.axes if axis in LINEAR], 2):
        first, second = (np.linspace(*model.travel[axis], STEPS) for axis in (one, other))
        grid = dict(zip((one, other), np.meshgrid(first, second), strict=True))
        rows = [grid[axis].ravel() if axis in grid else np.full(STEPS**2, middle[axis]) for axis in model.axes]
        u = tool_point(found, np.array(rows), tools).u.reshape(STEPS, STEPS)
        at = {axis: value for axis, value in middle.items() if axis not in grid}
        made.append(Slice((one, other), first, second, u, at))
    return tuple(made)
