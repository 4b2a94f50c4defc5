"""Eqs. (27)-(34): X and Y together, as printed; r_11z, r_12z stand there with the digit 1 for the letter l."""

from __future__ import annotations

import sympy as sp

from ..notation import DIRECTIONS, EPS_XY, X_H, Y_H, Formula, Printed, delta, eps, r, reading
from .linkage_xz import along
from .single_axis import displacement, rotation, system_rows

_R_L = sp.Matrix([r("l", d) for d in DIRECTIONS])
_R_K = sp.Matrix([r("k", d) for d in DIRECTIONS])
_Y_PART = sp.Matrix([delta("x", "y"), delta("y", "y") + Y_H, delta("z", "y")]) + rotation("y") * _R_L
_X_PART = sp.Matrix([delta("x", "y") + X_H, delta("y", "x") + X_H * EPS_XY, delta("z", "x")]) + rotation("x") * _R_K


def _in_x(on_y: str, on_x: str) -> sp.Expr:
    return (
        delta("x", "y")
        - delta("x", "x")
        - X_H
        - r(on_y, "y") * eps("z", "y")
        + r(on_y, "z") * eps("y", "y")
        + r(on_x, "y") * eps("z", "x")
        - r(on_x, "z") * eps("y", "x")
    )


def _rhs(i: int) -> sp.Expr:
    """Right-hand side of Eq. (31), row i."""
    on_y, on_x = f"1{i}", f"k{i}"
    return (
        reading(str(i), "x")
        + delta("x", "x")
        + X_H
        + r(on_y, "y") * eps("z", "y")
        - r(on_x, "y") * eps("z", "x")
        + r(on_x, "z") * eps("y", "x")
    )


_ANGLES_IN_Y = (
    r("11", "z") * eps("z", "y")
    - r("11", "z") * eps("x", "y")
    - r("k1", "x") * eps("z", "x")
    + r("k1", "z") * eps("x", "x")
)
_ONE = sp.Integer(1)

LINKAGE_XY: tuple[Printed, ...] = (
    Printed(
        27,
        "motion equation, X and Y",
        "3.4",
        tuple(
            Formula(d, displacement("i", d) - displacement("k", d), _Y_PART[n] - _X_PART[n], "XY")
            for n, d in enumerate(DIRECTIONS)
        ),
    ),
    Printed(28, "projections of the XY line", "3.4", along("i", -1, "x", "y", "line XY")),
    Printed(
        29,
        "readings of X and Y",
        "3.4",
        (
            Formula("L_ixh", reading("i", "x"), _in_x("li", "ki"), "XY"),
            Formula(
                "L_iyh",
                reading("i", "y"),
                delta("y", "y")
                - delta("y", "x")
                + Y_H
                - X_H * EPS_XY
                + r("li", "x") * eps("z", "y")
                - r("li", "z") * eps("x", "y")
                - r("ki", "x") * eps("z", "x")
                + r("ki", "z") * eps("x", "x"),
                "XY",
            ),
        ),
    ),
    Printed(
        30,
        "readings of X and Y at two points",
        "3.4",
        (
            Formula("L_1xh", reading("1", "x"), _in_x("1l", "k1"), "XY"),
            Formula("L_2xh", reading("2", "x"), _in_x("2l", "k2"), "XY"),
            along("1", -1, "x", "y", "line XY", "where ")[0],
            along("2", -1, "x", "y", "line XY", "where ")[0],
        ),
    ),
    Printed(
        31,
        "system of X and Y",
        "3.4",
        system_rows(
            [[_ONE, r("11", "z")], [_ONE, r("12", "z")]],
            [delta("x", "y"), eps("y", "y")],
            [_rhs(1), _rhs(2)],
            "XY",
        ),
    ),
    Printed(
        32,
        "solution of X and Y",
        "3.4",
        (
            Formula(
                "epsilon_y(y)",
                eps("y", "y"),
                (
                    reading("1", "x") * reading("2", "z")
                    + (r("11", "y") - r("12", "y")) * eps("z", "y")
                    + (r("k2", "y") - r("k1", "y")) * eps("z", "x")
                    + (r("k2", "z") - r("k1", "z")) * eps("y", "x")
                )
                / (r("11", "z") - r("12", "z")),
                "XY",
            ),
            Formula("delta_x(y)", delta("x", "y"), _rhs(1) - r("11", "z") * eps("y", "y"), "XY"),
        ),
    ),
    Printed(
        33,
        "Y reading of X and Y",
        "3.4",
        (
            Formula(
                "L_1yh",
                reading("1", "y"),
                delta("y", "y") - delta("y", "x") + Y_H - X_H * EPS_XY + _ANGLES_IN_Y,
                "XY",
            ),
            along("1", -1, "x", "y", "line XY", "where ")[1],
        ),
    ),
    Printed(
        34,
        "straightness of X in Y",
        "3.4",
        (
            Formula(
                "delta_y(x)",
                delta("y", "x"),
                -reading("1", "y") + delta("y", "y") + Y_H - X_H * EPS_XY + _ANGLES_IN_Y,
                "XY",
            ),
        ),
    ),
)
