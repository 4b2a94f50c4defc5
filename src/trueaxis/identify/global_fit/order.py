"""The degree of each component by readings held out: as low as they do as well, within one standard error.

Readings at one place (a run's position, all its repeats, and the same position of other runs along the same way) are
held out together, every tenth place in turn. Degrees change one component at a time, from the full polynomials on,
until none changes. Of a component's degrees the lowest is taken whose squared held-out errors exceed those of the best
by no more than the standard error of that difference over the parts held out (L. Breiman et al., Classification and
Regression Trees, 1984, Sect. 3.4.3, with the errors paired). The readings are predicted to first order.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import scipy.linalg

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.repeats import DECIMALS
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.measure.machine import FloatArray

MOST_PARTS = 10
MOST_SWEEPS = 10
LEAST = 1  # without a slope, a location error would seem determined that is not
RIDGE = 1e-11  # of the mean diagonal of all readings: what they do not determine stays finite, predicted as small
BoolArray = npt.NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class Orders:
    """Degrees by component, and the rms of held-out readings (um): with all at the highest degree, as chosen, and
    without any motion error; parts: into how many the readings were split; highest: the highest degree.
    """

    degrees: Mapping[str, int]
    parts: int
    highest: int
    held_out_full_um: float
    held_out_um: float
    held_out_none_um: float


@dataclass(frozen=True, slots=True, eq=False)
class _Part:
    """Normal equations of the readings outside a part: normal (n, n), right (n,); ridge: added to the diagonal, so that
    what these readings leave open stays finite; and the part itself.
    """

    normal: FloatArray
    right: FloatArray
    ridge: float
    rows: FloatArray
    readings: FloatArray


def choose_orders(design: Design, residual: FloatArray, highest: int) -> Orders:
    """residual: (n_readings,), mm, of the machine without the unknowns; the layout has the highest degrees."""
    plan = design.layout
    parts = _parts(design, residual)
    degrees = np.diff(plan.offset)
    full = _errors(parts, _kept(plan, degrees))
    for _ in range(MOST_SWEEPS):
        before = degrees.copy()
        for place in range(plan.components.size):
            degrees[place] = _best(parts, plan, degrees, place)
        if (degrees == before).all():
            break
    chosen = _errors(parts, _kept(plan, degrees))
    none = _errors(parts, _kept(plan, np.zeros_like(degrees)))
    names = plan.names()
    return Orders(
        {names[place]: int(degree) for place, degree in enumerate(degrees)},
        len(parts),
        highest,
        *(float(np.sqrt(errors.sum() / residual.size)) * 1e3 for errors in (full, chosen, none)),
    )


def places_held_out(design: Design) -> IntArray:
    """(n_readings,): the part with which each reading is held out; the order of rows and runs does not matter."""
    observed = design.observed
    at = np.round(observed.positions, DECIMALS) + 0.0
    part = np.zeros(observed.reading.size, dtype=np.int64)
    for index in range(len(observed.runs)):
        rows = np.flatnonzero(observed.run == index)
        if rows.size:
            _, place = np.unique(at[:, rows], axis=1, return_inverse=True)
            part[rows] = np.asarray(place).ravel() % MOST_PARTS
    return part


def _best(parts: list[_Part], plan: Layout, degrees: IntArray, place: int) -> int:
    """Of one component, the others being as they are."""
    mine = plan.of_component(place)
    tried = []
    for degree in range(LEAST, mine.stop - mine.start + 1):
        changed = degrees.copy()
        changed[place] = degree
        tried.append(_errors(parts, _kept(plan, changed)))
    errors = np.array(tried)
    best = int(errors.sum(axis=1).argmin())
    excess = errors - errors[best]
    spread = excess.std(axis=1, ddof=1) * np.sqrt(len(parts)) if len(parts) > 1 else np.zeros(len(tried))
    within = excess.sum(axis=1) <= spread
    within[best] = True
    return LEAST + int(np.argmax(within))


def _errors(parts: list[_Part], kept: BoolArray) -> FloatArray:
    """(n_parts,): sum of squared errors of each part, predicted from the others, mm^2."""
    found = np.zeros(len(parts))
    for index, part in enumerate(parts):
        own = part.readings
        if kept.any():
            normal = part.normal[np.ix_(kept, kept)]
            normal[np.diag_indices_from(normal)] += part.ridge
            factor = scipy.linalg.cho_factor(normal, check_finite=False)
            own = own - part.rows[:, kept] @ scipy.linalg.cho_solve(factor, part.right[kept], check_finite=False)
        found[index] = float(own @ own)
    return found


def _parts(design: Design, residual: FloatArray) -> list[_Part]:
    """Normal equations by part; the rows held out are kept as a triangle, so that memory does not grow with them."""
    part, n = places_held_out(design), design.layout.count
    numbers = np.unique(part).tolist()
    folded = {number: np.zeros((0, n + 1)) for number in numbers}
    for rows, piece in design.pieces():
        roots = 1.0 if design.roots is None else design.roots[rows]
        right = (roots * residual[rows])[:, np.newaxis]
        for number in numbers:
            mine = part[rows] == number
            if mine.any():
                stacked = np.vstack([folded[number], np.hstack([piece[mine], right[mine]])])
                folded[number] = np.asarray(np.linalg.qr(stacked, mode="r")) if stacked.shape[0] > n + 1 else stacked
    blocks = list(folded.values())
    squares = [block.T @ block for block in blocks]
    ridge = RIDGE * float(sum(np.trace(square[:n, :n]) for square in squares)) / n
    found = []
    for index, block in enumerate(blocks):
        # the sum of the others, not the total less this one: what is left of that may be negative by rounding
        rest = sum((square for other, square in enumerate(squares) if other != index), np.zeros((n + 1, n + 1)))
        found.append(_Part(rest[:n, :n], rest[:n, n], ridge, block[:, :n], block[:, n]))
    return found


def _kept(plan: Layout, degrees: IntArray) -> BoolArray:
    kept = np.ones(plan.count, dtype=bool)
    for place, degree in enumerate(degrees.tolist()):
        mine = plan.of_component(place)
        kept[mine.start + degree : mine.stop] = False
    return kept
