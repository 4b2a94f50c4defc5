"""What is straightness and what squareness: no reading since home tells, a convention does.

A straight line of a straightness curve and a squareness move every tool point alike, seen from home. By convention the
least-squares line of every straightness over the travel is level (ISO 230-1) and the squareness takes its slope: a
linear map of values and covariance.
"""

import numpy as np

from trueaxis.estimation.layout import Layout
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.covariance import Covariance
from trueaxis.runtime.uncertainty import derivative, home_of
from trueaxis.spec.machine import LINEAR

POSITIONS, SEED = 40, 3
# mm: what moves none of these points of the tool frame moves no other. Where a rotary axis turns the tool behind the
# axes that are not square, the two errors move its tip and its origin apart, and are told from one another.
TOOLS = ((0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (0.0, 100.0, 0.0), (0.0, 0.0, 100.0))
NOTHING = 1e-9  # of the largest singular value: combinations that move no tool point


def covariance_of(layout: Layout, root: FloatArray, of_prior: int | None = None) -> Covariance:
    """Of the machine's values alone; root: (n_unknowns, r) or (of_machine, r); of_prior: of its columns, the last ones,
    are the prior's part.
    """
    return Covariance(
        machine=layout.model.name,
        components=layout.components,
        bases=layout.bases,
        locations=layout.locations,
        root=root[: layout.of_machine],
        open=np.zeros((layout.of_machine, 0)),
        of_prior=of_prior,
    )


def levelling(layout: Layout) -> FloatArray:
    """(n_unknowns, n_unknowns): the map to values whose straightness lines are level.

    The first Legendre coefficient is the slope of the least-squares line: the polynomials are orthogonal.
    """
    n = layout.count
    offsets = layout.offsets
    slopes = [
        int(first)
        for name, first in zip(layout.components, offsets[:-1].tolist(), strict=True)
        if name[1] in LINEAR and name[2] in LINEAR and name[1] != name[2]
    ]
    angles = [
        int(offsets[-1]) + place
        for place, name in enumerate(layout.locations)
        if layout.model.machine.parameter_unit(name) == "rad"
    ]
    chosen = [*slopes, *angles]
    if not slopes or not angles:
        return np.eye(n)
    model, draw = layout.model, np.random.default_rng(SEED)
    positions = np.array([draw.uniform(*model.travel[axis], POSITIONS) for axis in model.axes])
    known = covariance_of(layout, np.zeros((n, 0)))
    rows = []
    for tool in TOOLS:
        end = np.array(tool)[:, np.newaxis]
        moved = derivative(model, known, positions, end) - derivative(model, known, home_of(model), end)
        rows.append(moved[:, chosen].transpose(0, 2, 1).reshape(-1, len(chosen)))
    columns = np.vstack(rows) * layout.sizes[chosen]
    _, singular, right = np.linalg.svd(columns, full_matrices=True)
    null = np.zeros((n, 0))
    rank = int(np.count_nonzero(singular > NOTHING * singular.max(initial=0.0)))
    if rank < len(chosen):
        null = np.zeros((n, len(chosen) - rank))
        null[chosen] = right[rank:].T * layout.sizes[chosen][:, np.newaxis]
    in_units = null[slopes] / layout.sizes[slopes][:, np.newaxis]
    found = np.eye(n)
    found[:, slopes] -= null @ np.linalg.pinv(in_units, rcond=NOTHING) / layout.sizes[slopes]
    return found
