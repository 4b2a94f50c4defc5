"""Eqs. (12)-(20): single-axis motion, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import (
    DIRECTIONS,
    EPS_XY,
    EPS_XZ,
    EPS_YZ,
    X_H,
    Y_H,
    Z_H,
    Formula,
    Printed,
    delta,
    eps,
    place,
    r,
    reading,
)


def rotation(axis: str) -> sp.Matrix:
    """The 3x3 part of the printed matrix of rotational errors; its last row and column are zero."""
    ex, ey, ez = (eps(d, axis) for d in DIRECTIONS)
    return sp.Matrix([[0, -ez, ey], [ez, 0, -ex], [-ey, ex, 0]])


def shift(axis: str) -> sp.Matrix:
    """The printed column of translational errors."""
    return sp.Matrix([delta(d, axis) for d in DIRECTIONS])


def displacement(point: str, direction: str) -> sp.Expr:
    """Printed left-hand side, such as x_kh - x_k0."""
    return place(direction, point, "h") - place(direction, point, "0")


def motion_rows(point: str, rhs: sp.Matrix, run: str) -> tuple[Formula, ...]:
    """The three rows of a printed single-axis motion equation."""
    return tuple(Formula(d, displacement(point, d), rhs[i], run) for i, d in enumerate(DIRECTIONS))


def system_rows(
    matrix: list[list[sp.Expr]], unknowns: list[sp.Expr], rhs: list[sp.Expr], run: str
) -> tuple[Formula, ...]:
    """Rows of a printed linear system; `unknowns = matrix^-1 rhs` states the same rows."""
    return tuple(
        Formula(f"row {i + 1}", sum((a * u for a, u in zip(row, unknowns, strict=True)), sp.Integer(0)), b, run)
        for i, (row, b) in enumerate(zip(matrix, rhs, strict=True))
    )


_R_K = sp.Matrix([r("k", d) for d in DIRECTIONS])
_R_L = sp.Matrix([r("l", "x"), sp.Symbol("l_ly", real=True), r("l", "z")])

_X_UNKNOWNS = [delta("x", "x"), eps("z", "x"), eps("y", "x")]
_Y_UNKNOWNS = [delta("y", "y"), eps("z", "y"), eps("x", "y")]
_Z_UNKNOWNS = [delta("z", "z"), eps("y", "z"), eps("x", "z")]
_ONE = sp.Integer(1)

SINGLE_AXIS: tuple[Printed, ...] = (
    Printed(
        12,
        "motion equation, X alone",
        "3.2",
        motion_rows("k", shift("x") + sp.Matrix([X_H, X_H * EPS_XY, 0]) + rotation("x") * _R_K, "X"),
    ),
    Printed(
        13,
        "motion equation, Y alone",
        "3.2",
        motion_rows("l", shift("y") + sp.Matrix([0, Y_H, 0]) + rotation("y") * _R_L, "Y"),
    ),
    Printed(
        14,
        "motion equation, Z alone",
        "3.2",
        motion_rows("k", shift("z") + sp.Matrix([Z_H * EPS_XZ, -Z_H * EPS_YZ, Z_H]) + rotation("z") * _R_K, "Z"),
    ),
    Printed(
        15,
        "system of X alone",
        "3.2",
        system_rows(
            [[_ONE, -r(f"k{i}", "y"), r(f"k{i}", "z")] for i in (1, 2, 3)],
            _X_UNKNOWNS,
            [reading(str(i), "x") - X_H for i in (1, 2, 3)],
            "X",
        ),
    ),
    Printed(
        16,
        "system of Y alone",
        "3.2",
        system_rows(
            [[_ONE, r(f"l{i}", "x"), -r(f"l{i}", "z")] for i in (4, 5, 6)],
            _Y_UNKNOWNS,
            [reading(str(i), "y") - Y_H for i in (4, 5, 6)],
            "Y",
        ),
    ),
    Printed(
        17,
        "system of Z alone",
        "3.2",
        system_rows(
            [[_ONE, -r(f"k{i}", "x"), r(f"k{i}", "y")] for i in (7, 8, 9)],
            _Z_UNKNOWNS,
            [reading(str(i), "z") - Z_H for i in (7, 8, 9)],
            "Z",
        ),
    ),
    Printed(
        18,
        "solution of X alone",
        "3.2",
        system_rows(
            [
                [_ONE, -r("k1", "x"), r("kl", "z")],
                [_ONE, -r("k2", "y"), r("k2", "z")],
                [_ONE, -r("k3", "y"), r("k3", "y")],
            ],
            _X_UNKNOWNS,
            [reading(str(i), "x") - X_H for i in (1, 2, 3)],
            "X",
        ),
    ),
    Printed(
        19,
        "solution of Y alone",
        "3.2",
        system_rows(
            [[_ONE, r(f"l{i}", "x"), -r(f"l{i}", "z")] for i in (1, 2, 3)],
            _Y_UNKNOWNS,
            [reading(str(i), "y") - Y_H for i in (1, 2, 3)],
            "Y",
        ),
    ),
    Printed(
        20,
        "solution of Z alone",
        "3.2",
        system_rows(
            [[_ONE, -r(f"k{i}", "x"), r(f"k{i}", "y")] for i in (4, 5, 6)],
            _Z_UNKNOWNS,
            [reading(str(i), "z") - Z_H for i in (4, 5, 6)],
            "Z",
        ),
    ),
)
