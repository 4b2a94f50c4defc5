"""Point by point: the positions at which errors are unknowns, the readings gathered there, and their equations.

To first order each equation has a coefficient for every node and every location error; `points_remark` says what is
wrong with the measuring points of runs that give fewer values than they should.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_array, csr_array

from trueaxis.error_name import ErrorName
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import IdentifiedMachine, component_axes, scales
from trueaxis.estimation.observations import Observations
from trueaxis.identification.words import enumerated
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions
from trueaxis.measurement.setup import Run

IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]
DECIMALS = 6  # positions that agree to 1e-6 mm or deg are the same position
NEGLIGIBLE = 1e-11  # mm per mm: a coefficient below it is rounding
SAME = 1e-9  # relative to the distance of the points


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


@dataclass(frozen=True, slots=True, eq=False)
class Equations:
    """reading = nodes @ errors + located @ location errors, to first order, in scaled unknowns.

    nodes: (n_cells, n_nodes); located: (n_cells, n_location_errors); node_scale, location_scale: mm or rad that one
    unit of an unknown is. Nodes that are zero or given have no entries.
    """

    nodes: csr_array
    located: csr_array
    node_scale: FloatArray
    location_scale: FloatArray


def equations(
    machine: IdentifiedMachine, observed: Observations, grid: Grid, cells: Cells, given: BoolArray
) -> Equations:
    """The equations of all cells. given: (n_components,), components whose values are known beforehand."""
    n_components = len(grid.components)
    scale = scales(machine)
    rows, columns, values = [], [], []
    located = np.zeros((cells.run.size, len(machine.location_errors)))
    component_offset = grid.offset[:-1, np.newaxis]
    for index, run in enumerate(observed.runs):
        chosen = np.flatnonzero(cells.run == index)
        if chosen.size == 0:
            continue
        here = sensed(machine, run, cells.positions[:, chosen]) * scale[:, np.newaxis]
        home = np.repeat(sensed_at_home(machine, run) * scale[:, np.newaxis], chosen.size, axis=1)
        located[chosen] = (here - home)[n_components:].T
        node_here = component_offset + cells.knot[grid.axis][:, chosen]
        node_home = np.repeat(component_offset + grid.home[grid.axis, index][:, np.newaxis], chosen.size, axis=1)
        for node, value in ((node_here, here), (node_home, -home)):
            rows.append(np.broadcast_to(chosen, node.shape).ravel())
            columns.append(node.ravel())
            values.append(value[:n_components].ravel())
    shape = (cells.run.size, grid.count)
    place = (np.concatenate(rows), np.concatenate(columns))
    matrix = coo_array((np.concatenate(values), place), shape=shape).tocsr()  # entries of one place are added
    known = grid.fixed | np.repeat(given, np.diff(grid.offset))
    matrix.data[(np.abs(matrix.data) < NEGLIGIBLE) | known[matrix.indices]] = 0.0
    matrix.eliminate_zeros()
    located[np.abs(located) < NEGLIGIBLE] = 0.0
    node_scale = np.repeat(scale[:n_components], np.diff(grid.offset))
    return Equations(matrix, csr_array(located), node_scale, scale[n_components:])


def points_remark(runs: Sequence[Run]) -> str:
    """A sentence where the points, seen along the common direction of the runs, coincide or lie on a line; else empty.

    Runs along one direction see a point through its two coordinates across that direction: three rotations and
    translations need three points that form a triangle when seen so.
    """
    directions = {run.direction for run in runs}
    carriers = {(run.target.on, run.reference.on) for run in runs}
    if len(runs) < 2 or len(directions) != 1 or len(carriers) != 1 or None in directions:
        return ""
    direction = np.array(runs[0].direction)
    points = np.array([run.target.point for run in runs])
    across = points - np.outer(points @ direction, direction)
    size = max(float(np.ptp(points, axis=0).max()), 1.0)
    along = f"seen along the direction ({', '.join(f'{part:g}' for part in direction)})"
    same = [
        f"{a.id} and {b.id}"
        for (a, at), (b, other) in combinations(zip(runs, across, strict=True), 2)
        if np.linalg.norm(at - other) <= SAME * size
    ]
    names = enumerated([run.id for run in runs])
    if same:
        rest = f", so that those of {names} lie on a line" if len(runs) > 2 else ""
        return f"the points of runs {enumerated(same)} are one point {along}{rest}"
    if len(runs) > 2 and np.linalg.matrix_rank(across - across[0], tol=SAME * size) < 2:
        return f"the points of runs {names} lie on a line {along}"
    return ""
