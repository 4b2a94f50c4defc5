"""The covariance of what the point-by-point method found, and what its readings leave open."""

import numpy as np
from scipy.sparse import csr_array, vstack

from trueaxis.identification.paper.grid import IntArray
from trueaxis.identification.paper.result import PaperResult
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import HatBasis, unmeasured_basis
from trueaxis.model.covariance import Covariance


def covariance_of(result: PaperResult) -> Covariance:
    """Of the tables of every component that was found, zero nodes included, and of the location errors.

    Open are the combinations that no step sees, and each location error with the curves that can take its place: the
    rule that chooses among these is no measurement, and matters where it moves the tool.
    """
    grid, response, machine = result.grid, result.response, result.machine
    kept = result.steps.reached | grid.fixed
    names, bases, rows = [], [], []
    for index, name in enumerate(grid.components):
        nodes = grid.nodes(index)
        if name in result.given.motion_errors or not result.steps.reached[nodes].any():
            continue
        nodes = nodes[kept[nodes]]
        names.append(name)
        bases.append(HatBasis(tuple(grid.knots[grid.axis[index]][nodes - grid.offset[index]].tolist())))
        rows.append(nodes)
    order = np.concatenate([*rows, np.zeros(0, dtype=np.int64)])
    free = np.flatnonzero(result.free)
    root = None
    if result.noise.sigma is not None:
        nodes_by_cell = (response.nodes + response.along @ csr_array(response.located))[order]
        by_cell = vstack([nodes_by_cell, csr_array(response.located[free])], format="csr")
        root = csr_array(by_cell.multiply(result.noise.sigma / np.sqrt(result.cells.repeats)[np.newaxis]))
    unmeasured = [name for name in grid.components if name not in names and name not in result.given.motion_errors]
    found = Covariance(
        machine=machine.name,
        components=tuple(names),
        bases=tuple(bases),
        locations=tuple(machine.location_errors[index] for index in free),
        root=root,
        open=_open(result, order, free),
        of_prior=0,
    )
    return found.with_open_components({name: unmeasured_basis(machine.travel, name) for name in unmeasured})


def _open(result: PaperResult, order: IntArray, free: IntArray) -> FloatArray:
    """(n_values, d): what no step sees, then each free location error with the nodes that go along with it."""
    response = result.response
    unseen = np.vstack([response.null.toarray()[order], response.null_located[free]])
    along = np.vstack([response.along.toarray()[np.ix_(order, free)], np.eye(free.size)])
    return np.hstack([unseen, along])
