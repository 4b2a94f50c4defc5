"""All readings of a plan to first order: the machine's unknowns with those of the instruments eliminated."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.global_fit.least_squares import Factors, factors
from trueaxis.measure.machine import FloatArray
from trueaxis.plan.instruments import Unknowns

SAME = 1e-9  # relative singular value below which unknowns of one instrument are one


@dataclass(frozen=True, slots=True, eq=False)
class System:
    """The design matrix of a plan, folded.

    triangle: (n, n) triangular factor after the instruments' unknowns are eliminated; factors: of it; seen: (n,),
    unknowns that a reading holds at all; instruments: rank of the instruments' columns; given: components and
    location errors known beforehand.
    """

    layout: Layout
    design: Design
    unknowns: tuple[Unknowns, ...]
    triangle: FloatArray
    factors: Factors
    seen: npt.NDArray[np.bool_]
    instruments: int
    given: frozenset[str]


def system(design: Design, unknowns: Sequence[Unknowns], given: frozenset[str] = frozenset()) -> System:
    """Fold the design matrix; memory as bounded as its pieces, besides the columns of the instruments."""
    n = design.layout.count
    bases = [_orthonormal(one.columns) for one in unknowns]
    place = _places(design, unknowns)
    shares = [np.zeros((basis.shape[1], n)) for basis in bases]
    seen = np.zeros(n, dtype=bool)
    for rows, piece in design.pieces():
        seen |= piece.any(axis=0)
        group, local = place[0][rows[0]], place[1][rows]
        if group >= 0:
            shares[group] += bases[group][local].T @ piece
    triangle = np.zeros((n, n))
    for rows, piece in design.pieces():
        group, local = place[0][rows[0]], place[1][rows]
        left = piece - bases[group][local] @ shares[group] if group >= 0 else piece
        triangle = folded(triangle, left)
    rank = sum(basis.shape[1] for basis in bases)
    return System(design.layout, design, tuple(unknowns), triangle, factors(triangle), seen, rank, given)


def folded(triangle: FloatArray, rows: FloatArray) -> FloatArray:
    """The triangular factor of more rows."""
    return np.asarray(np.linalg.qr(np.vstack([triangle, rows]), mode="r"))[: triangle.shape[1]]


def eliminated(rows: FloatArray, columns: FloatArray) -> FloatArray:
    """Rows of a design matrix less what the columns of an instrument explain of them."""
    basis = _orthonormal(columns)
    return rows - basis @ (basis.T @ rows)


def answers(whole: System, vectors: FloatArray) -> tuple[FloatArray, ...]:
    """For each set-up (k, d): what its unknowns must be for vectors (n, d), scaled, to change its readings least."""
    place = _places(whole.design, whole.unknowns)
    inverses = [np.linalg.pinv(one.columns, rcond=SAME) for one in whole.unknowns]
    found = [np.zeros((one.columns.shape[1], vectors.shape[1])) for one in whole.unknowns]
    for rows, piece in whole.design.pieces():
        group = place[0][rows[0]]
        if group >= 0:
            found[group] -= inverses[group][:, place[1][rows]] @ (piece @ vectors)
    return tuple(found)


def _orthonormal(columns: FloatArray) -> FloatArray:
    size = np.linalg.norm(columns, axis=0)
    scaled = columns / np.where(size > 0.0, size, 1.0)
    left, singular, _ = np.linalg.svd(scaled, full_matrices=False)
    return left[:, singular > SAME * singular.max(initial=1.0)]


def _places(design: Design, unknowns: Sequence[Unknowns]) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    """(n,), (n,): for each reading the set-up that it belongs to (-1: none) and its row there."""
    group = np.full(design.observed.reading.size, -1, dtype=np.int64)
    local = np.zeros(design.observed.reading.size, dtype=np.int64)
    for index, one in enumerate(unknowns):
        group[one.rows] = index
        local[one.rows] = np.arange(one.rows.size)
    return group, local
