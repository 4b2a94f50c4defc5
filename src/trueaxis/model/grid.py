"""A grid over the volume of a machine, and slices of what is known on it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import home_of


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Slice:
    """Two axes that move to (n,) and (m,), mm or deg; values: (m, n), mm; at: where the other axes stand."""

    axes: tuple[str, str]
    first: FloatArray
    second: FloatArray
    values: FloatArray
    at: dict[str, float]


@dataclass(frozen=True, slots=True)
class Grid:
    """Positions at even distances over the travels, both ends included.

    counts: how many, by the letter of an axis, 2 or more of each; axes that are left out stand at home.
    """

    counts: Mapping[str, int]

    def positions(self, machine: Machine) -> FloatArray:
        """(n_axes, n), mm or deg, the last axis of the machine fastest."""
        nodes = [
            np.linspace(*machine.travel[axis], self.counts[axis]) if axis in self.counts else home
            for axis, home in zip(machine.axes, home_of(machine), strict=True)
        ]
        return np.array([one.ravel() for one in np.meshgrid(*nodes, indexing="ij")])

    @property
    def has_slices(self) -> bool:
        """Whether it has two axes or more."""
        return len(self.counts) > 1

    def slices(self, axes: Sequence[str], positions: FloatArray, values: FloatArray) -> tuple[Slice, ...]:
        """Through its middle, one for each pair of its axes, of linear ones where it has two. axes: of the machine;
        positions: (n_axes, n), of the grid; values: (n,).
        """
        shape = tuple(self.counts.get(axis, 1) for axis in axes)
        nodes = [np.unique(row) for row in positions]
        own = [axis for axis in axes if axis in self.counts]
        linear = [axis for axis in own if axis in LINEAR]
        found = []
        for pair in combinations(linear if len(linear) > 1 else own, 2):
            rows = [axes.index(axis) for axis in pair]
            index = tuple(slice(None) if row in rows else shape[row] // 2 for row in range(len(axes)))
            at = {axis: float(nodes[row][shape[row] // 2]) for row, axis in enumerate(axes) if row not in rows}
            first, second = (nodes[row] for row in rows)
            found.append(Slice(axes=pair, first=first, second=second, values=values.reshape(shape)[index].T, at=at))
        return tuple(found)
