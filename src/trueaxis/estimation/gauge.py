"""What is straightness and what squareness: no reading since home tells, a convention does.

A straight line of a straightness curve and a squareness move every tool point alike, seen from home. By convention the
least-squares line of every straightness over the travel is level (ISO 230-1) and the squareness takes its slope: to
first order a linear map of values and covariance. What the exact model makes of the squares of errors, some tenths of a
nanometre, is then taken back by the other values, as little of each as there is of it.
"""

import numpy as np

from trueaxis.estimation.layout import Layout
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import home_of
from trueaxis.model.uncertainty import derivative

POSITIONS, SEED = 40, 3
# mm: what moves none of these points of the tool frame moves no other. Where a rotary axis turns the tool behind the
# axes that are not square, the two errors move its tip and its origin apart, and are told from one another.
TOOLS = ((0.0, 0.0, 0.0), (100.0, 0.0, 0.0), (0.0, 100.0, 0.0), (0.0, 0.0, 100.0))
STEPS = 4  # of Newton's method: from tens of nanometres to rounding
# Of the largest singular value: combinations that move the tip less are left alone. What they take back of rounding
# would show at other points of the tool.
REACHED = 1e-6
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
    slopes = _slopes(layout)
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


def exactly_level(
    layout: Layout, before: ErrorValues, given: ErrorValues, unknowns: FloatArray, scale: FloatArray
) -> FloatArray:
    """(n_unknowns,): unknowns after `levelling` with which the exact model moves the tool tip as it did before.

    Against the workpiece, seen from home, a rotation of the workpiece aside. before: all values without the convention,
    given: those of them that are no unknowns; unknowns, scale: (n_unknowns,), mm or rad; scale: sizes to expect of the
    unknowns. The slopes stay as they are. Newton's steps with the derivative of the error-free machine: each leaves a
    thousandth or so. The convention turns the tool, too: points off the tip keep some tenths of a nanometre.
    """
    free = np.setdiff1d(np.arange(layout.of_machine), _slopes(layout))
    model, tip, draw = layout.model, np.zeros((3, 1)), np.random.default_rng(SEED)
    positions = np.array([draw.uniform(*model.travel[axis], layout.of_machine) for axis in model.axes])
    known, home = covariance_of(layout, np.zeros((layout.count, 0))), home_of(model)

    def from_home(values: ErrorValues) -> FloatArray:
        at = model.with_values(values)
        return at.deviation(positions, tip) - at.deviation(home, tip)

    wanted = from_home(before)
    by_values = derivative(model, known, positions, tip) - derivative(model, known, home, tip)
    points = model.ideal(positions, tip) - model.ideal(home, tip)
    turned = np.cross(np.eye(3)[:, np.newaxis, :], points.T[np.newaxis]).transpose(2, 0, 1)  # of w x p, by w
    turned /= max(float(np.abs(points).max()), 1.0)
    columns = np.concatenate([by_values[:, free] * scale[free, np.newaxis], turned], axis=1)
    inverse = np.linalg.pinv(columns.transpose(0, 2, 1).reshape(-1, columns.shape[1]), rcond=REACHED)
    found = unknowns.copy()
    for _ in range(STEPS):
        off = wanted - from_home(layout.values(found, given))
        found[free] += scale[free] * (inverse @ off.ravel())[: free.size]
    return found


def _slopes(layout: Layout) -> list[int]:
    """Unknowns: the slope of each straightness."""
    return [
        int(first)
        for name, first in zip(layout.components, layout.offsets[:-1].tolist(), strict=True)
        if name.is_straightness
    ]
