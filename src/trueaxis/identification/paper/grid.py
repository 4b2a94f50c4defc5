"""Point by point: the positions at which errors are unknowns, and the readings gathered there."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trueaxis.error_name import ErrorName
from trueaxis.estimation.machine import IdentifiedMachine, component_axes
from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions

IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

DECIMALS = 6  # positions that agree to 1e-6 mm or deg are the same position


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Grid:
    """Knots: the different positions of each axis. A node is a component at a knot of its axis.

    knots: per axis (n_knots,), rising; reference: per axis the knot at which every component is zero: position 0
    where it occurs, else the home of the first run; home: (n_axes, n_runs), knots; offset: (n_components + 1,),
    first node of each component; axis: (n_components,), its axis.
    """

    axes: tuple[str, ...]
    components: tuple[ErrorName, ...]
    knots: tuple[FloatArray, ...]
    reference: IntArray
    home: IntArray
    offset: IntArray
    axis: IntArray

    @property
    def count(self) -> int:
        """How many nodes there are."""
        return int(self.offset[-1])

    def nodes(self, component: int) -> IntArray:
        """The nodes of a component, in the order of the knots of its axis."""
        return np.arange(self.offset[component], self.offset[component + 1])

    def component_of(self, nodes: IntArray) -> IntArray:
        """The component of each node."""
        return np.searchsorted(self.offset, nodes, side="right") - 1

    def position_of(self, node: int) -> float:
        """Where a node is, mm or deg."""
        component = int(self.component_of(np.array([node]))[0])
        return float(self.knots[self.axis[component]][node - self.offset[component]])

    @property
    def fixed(self) -> BoolArray:
        """(count,): nodes that are zero by definition."""
        found = np.zeros(self.count, dtype=bool)
        found[self.offset[:-1] + self.reference[self.axis]] = True
        return found


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Cells:
    """Readings of one run at one position, averaged: the least-squares solution is the same, and memory is bounded.

    run: (n,); knot: (n_axes, n); positions: (n_axes, n), mm or deg; mean: (n,), mm; repeats: (n,), how many readings;
    scatter:
    (n,), sums of squares about the means, mm^2; readings: how many there are in all.
    """

    run: IntArray
    knot: IntArray
    positions: FloatArray
    mean: FloatArray
    repeats: FloatArray
    scatter: FloatArray
    readings: int


def grid_and_cells(machine: IdentifiedMachine, observed: Observations) -> tuple[Grid, Cells]:
    """The knots of a set of readings and the readings gathered at them."""
    homes = np.zeros((len(machine.axes), len(observed.runs)))
    for index, run in enumerate(observed.runs):
        home = home_positions(run, machine.axes)
        homes[:, index] = 0.0 if home is None else home[:, 0]
    knots, reference, home_knots, at = [], [], [], []
    for of_axis, home_of_axis in zip(observed.positions, homes, strict=True):
        every = np.concatenate([of_axis, home_of_axis])
        rounded = np.round(every, DECIMALS) + 0.0  # + 0.0: no negative zero
        values, first, inverse = np.unique(rounded, return_index=True, return_inverse=True)
        knots.append(every[first])
        at.append(inverse[: of_axis.size])
        home_knots.append(inverse[of_axis.size :])
        zero = np.flatnonzero(values == 0.0)
        reference.append(zero[0] if zero.size else home_knots[-1][0])
    axis = component_axes(machine)
    offset = np.concatenate([[0], np.cumsum([knots[a].size for a in axis])]).astype(np.int64)
    grid = Grid(
        axes=machine.axes,
        components=machine.components,
        knots=tuple(knots),
        reference=np.array(reference),
        home=np.array(home_knots),
        offset=offset,
        axis=axis,
    )
    return grid, _cells(observed, np.array(at), grid)


def _cells(observed: Observations, knot: IntArray, grid: Grid) -> Cells:
    keys, inverse = np.unique(np.vstack([observed.run, knot]), axis=1, return_inverse=True)
    repeats = np.bincount(inverse).astype(np.float64)
    mean = np.bincount(inverse, weights=observed.reading) / repeats
    scatter = np.bincount(inverse, weights=(observed.reading - mean[inverse]) ** 2).astype(np.float64)
    positions = np.array([of_axis[at] for of_axis, at in zip(grid.knots, keys[1:], strict=True)])
    return Cells(
        run=keys[0],
        knot=keys[1:],
        positions=positions,
        mean=mean,
        repeats=repeats,
        scatter=scatter,
        readings=observed.reading.size,
    )
