"""What follows for Eqs. (44)-(48) and (53)-(54): samples, normal equations and the compensated machine.

The printed definitions (40), (44), (47), (53) are put into the equations that rest on them, (42), (45), (48), (54).
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from . import chain
from .notation import DIRECTIONS, X_H, Definition
from .printed.compensation import COMPENSATION, ball, ball_in_bed, ideal_ball
from .printed.model import in_bed
from .printed.polynomials import (
    ERRORS_OF_X,
    ORDER,
    POLYNOMIALS,
    SAMPLES,
    beta,
    coefficient,
    position,
    solved,
    value,
)
from .printed.squareness import OFFSETS, SQUARENESS_SECTION, fitted, intercept, slope

Known = dict[sp.Symbol, sp.Expr]


def definitions(number: int) -> Known:
    """Left-hand side -> right-hand side of the definitions of an equation, as printed."""
    parts = next(item.parts for item in (*SQUARENESS_SECTION, *POLYNOMIALS, *COMPENSATION) if item.number == number)
    return {part.lhs: part.rhs for part in parts if isinstance(part, Definition)}


def fitted_lines(lines: Known | None = None) -> Known:
    """P'_uv of Eq. (40), as printed, for every axis v and direction u of Eq. (42)."""
    ((line, right),) = (lines or definitions(40)).items()
    assert line == fitted("uv")
    return {
        fitted(pair): right.xreplace(
            {
                intercept("uv"): intercept(pair),
                slope("uv"): slope(pair),
                sp.Symbol("v", real=True): sp.Symbol(pair[1], real=True),
            }
        )
        for pair in OFFSETS
    }


def sampled(polynomials: Known | None = None) -> Known:
    """B of Eq. (45) where the errors are the polynomials of Eq. (44), as printed, at each position."""
    printed = polynomials or definitions(44)
    return {
        value(j, sample): printed[error].xreplace({X_H: position(sample)})
        for j, error in enumerate(ERRORS_OF_X, 1)
        for sample in range(1, SAMPLES + 1)
    }


def least_squares() -> Known:
    """Coefficients at which the sum of squares has no slope, at the positions 1, 2 ... (its derivatives solved)."""
    unknowns = [solved(i, 1) for i in range(1, ORDER + 1)]
    squares = [
        (sp.Add(*(a * sp.Integer(j) ** i for i, a in enumerate(unknowns, 1))) - value(1, j)) ** 2
        for j in range(1, SAMPLES + 1)
    ]
    slopes = [sp.diff(sp.Add(*squares), a) for a in unknowns]
    return dict(zip(unknowns, next(iter(sp.linsolve(slopes, unknowns))), strict=True))


def linear_model(powers: Known | None = None) -> Known:
    """Y_j is the polynomial of Eq. (44) at x_j, with coefficients beta; X_ij are the powers of Eq. (47), as printed."""
    first = definitions(44)[ERRORS_OF_X[0]].xreplace({coefficient(i, 1): beta(i) for i in range(1, ORDER + 1)})
    values = {sp.Symbol(f"Y_{j}", real=True): first.xreplace({X_H: position(j)}) for j in range(1, SAMPLES + 1)}
    return values | (powers or definitions(47))


def compensated(vectors: Known | None = None) -> Known:
    """P_D of Eq. (53), as printed, of a tool ball that is where it should be in the workpiece frame: [SBW] of both."""
    ends = (
        chain.carried(chain.workpiece_branch("y"), [make(d) + sp.Symbol(f"q_w{d}", real=True) for d in DIRECTIONS])
        for make in (ideal_ball, ball)
    )
    at: Known = {}
    for make, coordinates in zip((in_bed, ball_in_bed), ends, strict=True):
        at |= {make(d): coordinates[n] for n, d in enumerate(DIRECTIONS)}
    return {vector: chain.exact(right.xreplace(at)) for vector, right in (vectors or definitions(53)).items()}


SETTINGS: dict[str, Callable[..., Known]] = {
    "fitted lines": fitted_lines,
    "samples of Eq. (44)": sampled,
    "least squares of Eq. (45)": least_squares,
    "sums of Eq. (48)": linear_model,
    "compensated": compensated,
}
