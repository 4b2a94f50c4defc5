"""Rank, condition and noise of the paper's systems at its published points, from the first-order readings."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np
import sympy as sp
from numpy.typing import NDArray

from . import reference
from .notation import DIRECTIONS, MOTION_ERRORS, SQUARENESS, X_H, Y_H, Z_H, r, reading
from .printed.tables import POINTS_LINKAGE, POINTS_SINGLE

FloatArray = NDArray[np.float64]
POSE = {X_H: 270.0, Y_H: 350.0, Z_H: 300.0}
"""Mid-travel, mm: where the numbers of the errata are worked out."""

PAPER_READINGS: tuple[tuple[str, str, str], ...] = (
    *(("X", label, "x") for label in "123"),
    *(("Y", label, "y") for label in "456"),
    *(("Z", label, "z") for label in "789"),
    ("XZ", "1", "x"),
    ("XZ", "2", "x"),
    ("XZ", "1", "z"),
    ("XZ", "2", "z"),
    ("XY", "1", "x"),
    ("XY", "2", "x"),
    ("XY", "1", "y"),
    ("YZ", "1", "y"),
    ("YZ", "1", "z"),
)
"""The 18 readings of Sects. 3.2-3.5: run, label, direction."""

SYSTEMS: tuple[tuple[str, str, tuple[tuple[str, str, str], ...], tuple[str, ...]], ...] = (
    ("(15), (18)", "X", PAPER_READINGS[0:3], ("delta_x(x)", "epsilon_z(x)", "epsilon_y(x)")),
    ("(16), (19)", "Y", PAPER_READINGS[3:6], ("delta_y(y)", "epsilon_z(y)", "epsilon_x(y)")),
    ("(17), (20)", "Z", PAPER_READINGS[6:9], ("delta_z(z)", "epsilon_y(z)", "epsilon_x(z)")),
    (
        "(25), (26)",
        "XZ",
        PAPER_READINGS[9:13],
        ("delta_x(z)", "epsilon_z(z)", "delta_z(x)", "epsilon_x(x)"),
    ),
    ("(31), (32)", "XY", PAPER_READINGS[13:15], ("delta_x(y)", "epsilon_y(y)")),
    ("(34)", "XY", PAPER_READINGS[15:16], ("delta_y(x)",)),
    ("(38)", "YZ", PAPER_READINGS[16:18], ("delta_y(z)", "delta_z(y)")),
)
"""Equation, run, readings, unknowns in the paper's order of solution."""

Points = dict[str, tuple[float, float, float]]


def points_of(run: str, single: Points | None = None) -> dict[sp.Symbol, float]:
    """Coordinates of the points of a run; `single` stands for Table 4."""
    table = (POINTS_SINGLE if single is None else single) if len(run) == 1 else POINTS_LINKAGE[run]
    return {r(name, d): float(table[name][n]) for name in table for n, d in enumerate(DIRECTIONS)}


def with_mended_z_point() -> Points:
    """Table 4 with y and z of P_k9 exchanged: an assumption, to have a regular system at all."""
    x, y, z = POINTS_SINGLE["k9"]
    return POINTS_SINGLE | {"k9": (x, z, y)}


@cache
def _row(run: str, label: str, direction: str) -> tuple[sp.Expr, ...]:
    expression = reference.readings(run)[reading(label, direction)]
    return tuple(sp.diff(expression, error) for error in (*MOTION_ERRORS, *SQUARENESS))


def jacobian(single: Points | None = None, pose: dict[sp.Symbol, float] | None = None) -> FloatArray:
    """d(reading)/d(18 motion errors, 3 squareness), shape (18, 21), at a pose; mm per mm and mm per rad."""
    rows = [
        [float(e.subs(points_of(run, single) | (pose or POSE))) for e in _row(run, label, d)]
        for run, label, d in PAPER_READINGS
    ]
    return np.array(rows)


def single_axis_matrices() -> dict[str, FloatArray]:
    """The 3x3 matrices of Eqs. (15)-(17) at Table 4's points."""
    return {run: matrix for (_, run, _, _), matrix in zip(SYSTEMS[:3], system_matrices()[:3], strict=True)}


def system_matrices(single: Points | None = None) -> list[FloatArray]:
    """The matrix of each of `SYSTEMS`."""
    whole = jacobian(single)
    names = [str(e) for e in MOTION_ERRORS]
    return [
        whole[np.ix_([PAPER_READINGS.index(q) for q in rows], [names.index(u) for u in unknowns])]
        for _, _, rows, unknowns in SYSTEMS
    ]


def condition(matrix: FloatArray) -> float:
    """Condition number; infinite where the rank is deficient, whatever rounding leaves of the last singular value."""
    singular = np.linalg.matrix_rank(matrix) < min(matrix.shape)
    return float("inf") if singular else float(np.linalg.cond(matrix))


def scaled(matrix: FloatArray) -> FloatArray:
    """Columns of length one: lengths and angles made comparable."""
    return np.asarray(matrix / np.linalg.norm(matrix, axis=0), dtype=np.float64)


@dataclass(frozen=True, slots=True)
class Amplification:
    """What independent noise of 1 micrometre in every reading does to one error (micrometre or microradian)."""

    name: str
    standard: float
    from_earlier: float
    """Share of the variance that enters through runs solved before."""


def amplification(single: Points) -> list[Amplification]:
    """Noise of all 18 errors at `POSE` with squareness known; the order is that of the paper's solution."""
    inverse = np.linalg.inv(jacobian(single)[:, :18])
    names = [str(e) for e in MOTION_ERRORS]
    result = []
    for _, _, rows, unknowns in SYSTEMS:
        own = [PAPER_READINGS.index(q) for q in rows]
        for unknown in unknowns:
            # The error itself in mm or rad per mm of reading; 1000 mm of arm make mrad of um, hence the factor.
            unit = 1e3 if unknown.startswith("epsilon") else 1.0
            share = (inverse[names.index(unknown)] * unit) ** 2
            total = float(share.sum())
            result.append(Amplification(unknown, float(np.sqrt(total)), max(0.0, 1 - float(share[own].sum()) / total)))
    return result


def null_space(matrix: FloatArray, tolerance: float = 1e-9) -> FloatArray:
    """Orthonormal columns that the matrix takes to zero, found with columns scaled."""
    lengths = np.linalg.norm(matrix, axis=0)
    _, values, right = np.linalg.svd(matrix / lengths)
    rank = int((values > tolerance * values[0]).sum())
    return np.asarray((right[rank:] / lengths).T, dtype=np.float64)


def undetermined(single: Points | None = None) -> list[str]:
    """Motion errors that the 18 readings leave open even with squareness known."""
    space = null_space(jacobian(single)[:, :18])
    relative = np.abs(space) * np.linalg.norm(jacobian(single)[:, :18], axis=0)[:, None]
    return [str(e) for e, row in zip(MOTION_ERRORS, relative, strict=True) if row.size and row.max() > 1e-9]


def stacked(count: int, single: Points) -> FloatArray:
    """All readings at `count` positions against 18 errors at each and the three constant squareness errors."""
    matrix = np.zeros((18 * count, 18 * count + 3))
    for h in range(count):
        pose = {symbol: (h + 1) / count * 2 * value for symbol, value in POSE.items()}
        rows = slice(18 * h, 18 * (h + 1))
        whole = jacobian(single, pose)
        matrix[rows, rows] = whole[:, :18]
        matrix[rows, -3:] = whole[:, 18:]
    return matrix
