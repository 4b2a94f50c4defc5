"""Eqs. (21)-(26): X and Z together, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import (
    DIRECTIONS,
    EPS_XY,
    EPS_XZ,
    EPS_YZ,
    X_H,
    Z_H,
    Formula,
    Printed,
    delta,
    eps,
    r,
    reading,
)
from .single_axis import motion_rows, system_rows

THETA = sp.Symbol("theta", real=True)


def ideal_length(label: str) -> sp.Symbol:
    """L^l_ih, "the ideal displacement distance"."""
    return sp.Symbol(f"L^l_{label}h", real=True)


def straightness(label: str) -> sp.Symbol:
    """delta_ih, "the straightness error" of the linkage line."""
    return sp.Symbol(f"delta_{label}h", real=True)


def component(direction: str) -> sp.Symbol:
    """Component of the unit vector along a linkage line OH."""
    return sp.Symbol(f"n_{direction}", real=True)


def along(label: str, sign: int, first: str, second: str, run: str, prefix: str = "") -> tuple[Formula, ...]:
    """L_first = L^l sin(theta) + delta cos(theta) and L_second = L^l cos(theta) + sign delta sin(theta)."""
    length, offset = ideal_length(label), straightness(label)
    return (
        Formula(
            f"{prefix}L_{label}{first}h",
            reading(label, first),
            length * sp.sin(THETA) + offset * sp.cos(THETA),
            run,
        ),
        Formula(
            f"{prefix}L_{label}{second}h",
            reading(label, second),
            length * sp.cos(THETA) + sign * offset * sp.sin(THETA),
            run,
        ),
    )


def _both(direction: str) -> sp.Expr:
    """epsilon(x) + epsilon(z) about one direction."""
    return eps(direction, "x") + eps(direction, "z")


def _in_x(point: str) -> sp.Expr:
    known = delta("x", "x") + delta("x", "z") + X_H + Z_H * eps("y", "x") + Z_H * EPS_XZ
    return known - r(point, "y") * _both("z") + r(point, "z") * _both("y")


def _in_z(point: str, last_sign: int) -> sp.Expr:
    known = delta("z", "x") + delta("z", "z") + Z_H
    return known - r(point, "x") * _both("y") + last_sign * r(point, "y") * _both("x")


_COLUMN = sp.Matrix(
    [
        delta("x", "x") + delta("x", "z") + X_H + Z_H * eps("y", "x") + Z_H * EPS_XZ,
        delta("y", "x") + delta("y", "z") + X_H * EPS_XY - Z_H * eps("x", "x") - Z_H * EPS_YZ,
        delta("z", "x") + delta("z", "z") + Z_H,
    ]
)
_ROTATION = sp.Matrix(
    [
        [0, -eps("z", "x") - eps("z", "z"), eps("y", "x") - eps("y", "z")],
        [eps("z", "x") + eps("z", "z"), 0, -eps("x", "x") - eps("x", "z")],
        [-eps("y", "x") - eps("y", "z"), eps("x", "x") - eps("x", "z"), 0],
    ]
)


def _rhs_x(i: int) -> sp.Expr:
    """Rows 1 and 2 of the right-hand side of Eq. (25)."""
    k = f"k{i}"
    known = -reading(str(i), "x") + delta("x", "x") + X_H + Z_H * eps("y", "x") + Z_H * EPS_XZ
    return known - r(k, "y") * eps("z", "x") + r(k, "z") * _both("y")


def _rhs_z(i: int) -> sp.Expr:
    """Rows 3 and 4 of the right-hand side of Eq. (25)."""
    k = f"k{i}"
    known = reading(str(i), "z") - delta("z", "x") - delta("z", "z") - Z_H
    return known + r(k, "x") * _both("y") - r(k, "y") * eps("x", "z")


_ZERO, _ONE = sp.Integer(0), sp.Integer(1)
BASE = r("k1", "y") - r("k2", "y")
"""The printed denominator of Eq. (26)."""

LINKAGE_XZ: tuple[Printed, ...] = (
    Printed(
        21,
        "motion equation, X and Z",
        "3.3",
        motion_rows("k", _COLUMN + _ROTATION * sp.Matrix([r("k", d) for d in DIRECTIONS]), "XZ"),
    ),
    Printed(22, "projections of the XZ line", "3.3", along("i", 1, "x", "z", "line XZ")),
    Printed(
        23,
        "readings of X and Z",
        "3.3",
        (
            Formula("L_ixh", reading("i", "x"), _in_x("ki"), "XZ"),
            Formula("L_izh", reading("i", "z"), _in_z("ki", -1), "XZ"),
        ),
    ),
    Printed(
        24,
        "readings of X and Z at two points",
        "3.3",
        (
            Formula("L_1xh", reading("1", "x"), _in_x("k1"), "XZ"),
            Formula("L_2xh", reading("2", "x"), _in_x("k2"), "XZ"),
            Formula("L_1zh", reading("1", "z"), _in_z("k1", 1), "XZ"),
            Formula("L_2zh", reading("2", "z"), _in_z("k2", 1), "XZ"),
            *along("1", 1, "x", "z", "line XZ", "where "),
            *along("2", 1, "x", "z", "line XZ", "where "),
        ),
    ),
    Printed(
        25,
        "system of X and Z",
        "3.3",
        system_rows(
            [
                [_ONE, -r("k1", "y"), _ZERO, _ZERO],
                [_ONE, -r("k2", "y"), _ZERO, _ZERO],
                [_ZERO, _ZERO, _ONE, r("k1", "y")],
                [_ZERO, _ZERO, _ONE, r("k2", "y")],
            ],
            [delta("x", "z"), eps("z", "z"), delta("z", "x"), eps("x", "x")],
            [_rhs_x(1), _rhs_x(2), _rhs_z(1), _rhs_z(2)],
            "XZ",
        ),
    ),
    Printed(
        26,
        "solution of X and Z",
        "3.3",
        (
            Formula(
                "epsilon_z(z)",
                eps("z", "z"),
                (
                    reading("2", "x")
                    - reading("1", "x")
                    - BASE * eps("z", "x")
                    + (r("k1", "z") - r("k2", "z")) * _both("y")
                )
                / BASE,
                "XZ",
            ),
            Formula(
                "delta_x(z)",
                delta("x", "z"),
                (
                    reading("1", "x")
                    - delta("x", "x")
                    - X_H
                    - Z_H * eps("y", "x")
                    - Z_H * EPS_XZ
                    + r("k1", "y") * _both("z")
                    - r("k1", "z") * _both("y")
                )
                / BASE,
                "XZ",
            ),
            Formula(
                "epsilon_x(x)",
                eps("x", "x"),
                (
                    reading("1", "z")
                    - reading("2", "z")
                    - (r("k1", "x") - r("k2", "x")) * _both("y")
                    - BASE * eps("x", "z")
                )
                / BASE,
                "XZ",
            ),
            Formula(
                "delta_z(x)",
                delta("z", "x"),
                (reading("1", "z") - delta("z", "z") - Z_H + r("k1", "x") * _both("y") - r("k1", "y") * _both("x"))
                / BASE,
                "XZ",
            ),
        ),
    ),
)
