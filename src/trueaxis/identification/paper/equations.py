"""The first-order equations of the cells: coefficient of each node and of each location error."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csr_array

from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import IdentifiedMachine, scales
from trueaxis.estimation.observations import Observations
from trueaxis.identification.paper.grid import BoolArray, Cells, Grid
from trueaxis.measurement.machine import FloatArray

NEGLIGIBLE = 1e-11  # mm per mm: a coefficient below it is rounding


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
