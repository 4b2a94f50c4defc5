"""What a convention settles: slopes of straightness that readings cannot part from squareness, or from their own line.

A convention is a rule "this slope of each straightness is zero": the slope of the least-squares line (ISO 230-1), or
that of the line through the end points. It applies where the readings leave slopes and location errors alone open.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.straightness import is_straightness, slope_weights
from trueaxis.measure.machine import FloatArray

Convention = Literal["least-squares", "end-point"]
CONVENTIONS: tuple[Convention, ...] = ("least-squares", "end-point")
ALONE = (
    1e-4  # share of other unknowns up to which a null vector is one of slopes and location errors: rounded positions
)
# make null spaces exact to some 1e-6 only
TILTS = 1e-6
ROUNDING = 1e-5
CLEARLY = 1e-2  # of a unit vector: what must be left of a row for it to lead


@dataclass(frozen=True, slots=True, eq=False)
class Settled:
    """Null space parted by a convention, all vectors in scaled unknowns.

    projector: (n, n), from any solution to that of the convention; settled: (n, g), what the convention fixes; open:
    (n, d), what stays open, the convention kept; plain: (n, d), the same but for shares of what is settled, which can
    be read more easily.
    """

    projector: FloatArray
    settled: FloatArray
    open: FloatArray
    plain: FloatArray


def settle(layout: Layout, null: FloatArray, convention: Convention) -> Settled:
    """Apply a convention to a null space (n, d)."""
    n = layout.count
    slopes = _slopes(layout, convention)
    outside = np.ones(n, dtype=bool)
    outside[layout.offset[-1] :] = False
    for place in _straight(layout):
        outside[layout.offset[place]] = False  # the first order is the slope
    _, size, right = np.linalg.svd(null[outside], full_matrices=True)
    sizes = np.zeros(null.shape[1])
    sizes[: size.size] = size
    alone, mixed = null @ right[sizes <= ALONE].T, null @ right[sizes > ALONE].T
    moved = slopes @ alone
    _, size, turn = np.linalg.svd(moved, full_matrices=True)
    sizes = np.zeros(alone.shape[1])
    sizes[: size.size] = size
    tilting = sizes > TILTS * np.abs(slopes).max(initial=0.0)
    inverse = np.linalg.pinv(moved, rcond=TILTS) if tilting.any() else np.zeros(moved.T.shape)
    projector = np.eye(n) - alone @ inverse @ slopes
    start = int(layout.offset[-1])
    order = [*range(start, n), *range(start)]
    settled, leads = echelon(alone @ turn[tilting].T, order)
    left = np.hstack([alone @ turn[~tilting].T, mixed])
    left = left - settled @ left[leads]
    return Settled(projector, settled, echelon(projector @ left, order)[0], echelon(left, order)[0])


def echelon(vectors: FloatArray, order: Sequence[int]) -> tuple[FloatArray, list[int]]:
    """The same space (n, d) with the basis whose vectors are 1 at one row of `leads` each and 0 at the others'.

    The leads are the first rows in `order` that are clearly independent, so that the basis is the same whatever
    basis the space was given in. Entries below ROUNDING times the largest of their vector are set to zero.
    """
    basis, _ = np.linalg.qr(vectors)
    count = basis.shape[1]
    leads: list[int] = []
    for tolerance in (CLEARLY, 0.0):
        taken, _ = np.linalg.qr(basis[leads].T)
        for row in order:
            left = basis[row] - taken @ (taken.T @ basis[row])
            size = float(np.linalg.norm(left))
            if len(leads) < count and row not in leads and size > tolerance:
                leads.append(row)
                taken, _ = np.linalg.qr(basis[leads].T)
    found = basis @ np.linalg.inv(basis[leads]) if count else basis
    found[np.abs(found) < ROUNDING * np.abs(found).max(axis=0, initial=0.0)] = 0.0
    return found, leads


def _straight(layout: Layout) -> list[int]:
    return [
        place
        for place, component in enumerate(layout.components)
        if is_straightness(layout.machine.components[component])
    ]


def _slopes(layout: Layout, convention: Convention) -> FloatArray:
    """(straightness components, n_unknowns): the slope that the convention speaks of, by every scaled unknown."""
    rows = np.zeros((len(_straight(layout)), layout.count))
    for row, place in zip(rows, _straight(layout), strict=True):
        mine, knots = layout.of_component(place), layout.knots[layout.axis[place]]
        row[mine] = layout.basis_of(place)(knots) @ _weights(knots, convention) * layout.scale[mine]
    return rows


def _weights(knots: FloatArray, convention: Convention) -> FloatArray:
    if convention == "least-squares":
        return slope_weights(knots)
    weights = np.zeros_like(knots)
    if knots.size > 1:
        weights[[0, -1]] = np.array([-1.0, 1.0]) / (knots[-1] - knots[0])
    return weights
