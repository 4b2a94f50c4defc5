"""Eqs. (44)-(48): polynomials of the motion errors and their least-squares fit, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import X_H, Definition, Entry, Formula, Printed, delta, eps

ORDER, SAMPLES = 2, 4
"""Powers and positions for which the matrices are written out."""
ERRORS_OF_X = (*(delta(d, "x") for d in "xyz"), *(eps(d, "x") for d in "xyz"))
"""Rows of B and of Eq. (44), in the printed order."""


def coefficient(first: int, second: int) -> sp.Symbol:
    """a_ij with its indices in the printed order."""
    return sp.Symbol(f"a_{first}{second}", real=True)


def value(component: int, sample: int) -> sp.Symbol:
    """B_ij: value of a component error at a position, both counted from 1."""
    return sp.Symbol(f"B_{component}{sample}", real=True)


def position(sample: int) -> sp.Symbol:
    """x_j, counted from 1."""
    return sp.Symbol(f"x_{sample}", real=True)


def solved(power: int, component: int) -> sp.Symbol:
    """Element of the solution A of Eq. (46), row and column counted from 1."""
    return sp.Symbol(f"A_{power}{component}", real=True)


def regressor(power: int, sample: int) -> sp.Symbol:
    """X_ij of Eq. (47)."""
    return sp.Symbol(f"X_{power}{sample}", real=True)


def beta(power: int) -> sp.Symbol:
    """Coefficient of Eq. (48)."""
    return sp.Symbol(f"beta_{power}", real=True)


# "A = [a_11 a_21 a_31 a_41 a_51 a_61; a_12 a_22 ...]": the first index is the column there.
A = sp.Matrix(ORDER, 6, lambda row, column: coefficient(column + 1, row + 1))
x = sp.Matrix(ORDER, SAMPLES, lambda row, column: position(column + 1) ** (row + 1))
B = sp.Matrix(6, SAMPLES, lambda row, column: value(row + 1, column + 1))
_LEFT = A.T * x
_NUMBERS = {position(j): j for j in range(1, SAMPLES + 1)}
_X = x.xreplace(_NUMBERS)
_SOLVED = (_X * _X.T).inv() * _X * B.T
X = sp.Matrix(ORDER, SAMPLES, lambda row, column: regressor(row + 1, column + 1))
_FITTED = X.T * sp.Matrix([beta(i) for i in range(1, ORDER + 1)])

POLYNOMIALS: tuple[Printed, ...] = (
    Printed(
        44,
        "polynomials of the X axis",
        "4.2",
        tuple(
            Definition(str(error), error, sp.Add(*(coefficient(i, j) * X_H**i for i in range(1, ORDER + 1))))
            for j, error in enumerate(ERRORS_OF_X, 1)
        ),
    ),
    Printed(
        45,
        "polynomials as matrices",
        "4.2",
        tuple(Formula(f"row {j + 1}", _LEFT[j, 0], B[j, 0], "samples of Eq. (44)") for j in range(6)),
    ),
    Printed(
        46,
        "least-squares coefficients",
        "4.2",
        tuple(
            Formula(f"power {i + 1}", solved(i + 1, 1), _SOLVED[i, 0], "least squares of Eq. (45)")
            for i in range(ORDER)
        ),
    ),
    Printed(
        47,
        "powers of the positions",
        "4.3",
        (
            Entry("matrix that it defines", "x"),
            # Below Eq. (47): X is got from x by letting X_ij be x_j to the power i.
            *(
                Definition(f"X_{i}{j}", regressor(i, j), position(j) ** i)
                for i in range(1, ORDER + 1)
                for j in range(1, SAMPLES + 1)
            ),
        ),
    ),
    Printed(
        48,
        "polynomial as a linear model",
        "4.3",
        tuple(
            Formula(f"Y_{j + 1}", sp.Symbol(f"Y_{j + 1}", real=True), _FITTED[j], "sums of Eq. (48)")
            for j in range(SAMPLES)
        ),
    ),
)
MODEL_NAMES = ("Y", "X", "beta")
"""What Eq. (48) calls its left-hand side, its matrix and its coefficients."""
