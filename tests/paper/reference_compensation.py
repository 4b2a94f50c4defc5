"""What follows for Eqs. (44)-(48) and (53)-(54): samples, normal equations and the compensated machine."""

from __future__ import annotations

import sympy as sp

from . import chain
from .notation import DIRECTIONS
from .printed.compensation import ball, bar_vector, ideal_ball
from .printed.polynomials import ERRORS_OF_X, ORDER, SAMPLES, beta, position, regressor, solved, value

Known = dict[sp.Symbol, sp.Expr]


def sampled() -> Known:
    """B of Eq. (45) where the errors are the polynomials of Eq. (44): sum over the powers i of a_ij x^i."""
    powers = range(1, ORDER + 1)
    return {
        value(j, sample): sp.Add(*(sp.Symbol(f"a_{i}{j}", real=True) * position(sample) ** i for i in powers))
        for j in range(1, len(ERRORS_OF_X) + 1)
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


def linear_model() -> Known:
    """Y_j = sum over i of X_ij beta_i, the sum in the text below Eq. (48)."""
    return {
        sp.Symbol(f"Y_{j}", real=True): sp.Add(*(regressor(i, j) * beta(i) for i in range(1, ORDER + 1)))
        for j in range(1, SAMPLES + 1)
    }


def compensated() -> Known:
    """P_D of Eq. (53) where the tool ball is where it should be in the workpiece frame: [SBW] of both balls."""
    ends = (
        chain.carried(chain.workpiece_branch("y"), [make(d) + sp.Symbol(f"q_w{d}", real=True) for d in DIRECTIONS])
        for make in (ideal_ball, ball)
    )
    tool, workpiece = ends
    return {bar_vector(d): chain.exact(tool[n] - workpiece[n]) for n, d in enumerate(DIRECTIONS)}


SETTINGS = {
    "samples of Eq. (44)": sampled,
    "least squares of Eq. (45)": least_squares,
    "sums of Eq. (48)": linear_model,
    "compensated": compensated,
}
