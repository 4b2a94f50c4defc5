"""Eqs. (35)-(38): Y and Z together, as printed; r_11x stands there with the digit 1 for the letter l."""

from __future__ import annotations

import sympy as sp

from ..notation import (
    DIRECTIONS,
    EPS_XZ,
    EPS_YZ,
    Y_H,
    Z_H,
    Entry,
    Formula,
    Printed,
    delta,
    eps,
    r,
    reading,
)
from .linkage_xz import THETA, along, component
from .single_axis import displacement, rotation

_R_L = sp.Matrix([r("l", d) for d in DIRECTIONS])
_R_K = sp.Matrix([r("k", d) for d in DIRECTIONS])
_Y_PART = sp.Matrix([delta("x", "y"), delta("y", "y") + Y_H, delta("z", "y")]) + rotation("y") * _R_L
_Z_PART = (
    sp.Matrix([delta("x", "z") + Z_H * EPS_XZ, delta("y", "z") + Z_H * EPS_YZ, delta("z", "z") + Z_H])
    + rotation("z") * _R_K
)
_ANGLES_IN_Y = (
    r("11", "x") * eps("z", "y")
    - r("11", "z") * eps("x", "y")
    - r("k1", "x") * eps("z", "z")
    + r("k1", "z") * eps("x", "z")
)
_ANGLES_IN_Z = (
    -r("11", "x") * eps("y", "y")
    + r("11", "y") * eps("x", "y")
    + r("k1", "x") * eps("y", "z")
    - r("k1", "y") * eps("x", "z")
)

LINKAGE_YZ: tuple[Printed, ...] = (
    Printed(
        35,
        "motion equation, Y and Z",
        "3.5",
        tuple(
            Formula(d, displacement("l", d) - displacement("k", d), _Y_PART[n] - _Z_PART[n], "YZ")
            for n, d in enumerate(DIRECTIONS)
        ),
    ),
    Printed(
        36,
        "projections of the YZ line",
        "3.5",
        (
            *along("i", 1, "y", "z", "line YZ"),
            # "theta denotes the included angle between the ideal linkage trajectory curve and Y axis"
            Formula("cosine of theta", sp.cos(THETA), component("y"), "line YZ"),
            Entry("projections named in the text", ("L_ixh", "L_iyh")),
        ),
    ),
    Printed(
        37,
        "readings of Y and Z",
        "3.5",
        (
            Formula(
                "L_1yh",
                reading("1", "y"),
                delta("y", "y") + Y_H - delta("y", "z") + Z_H * EPS_YZ + _ANGLES_IN_Y,
                "YZ",
            ),
            Formula(
                "L_1zh",
                reading("1", "z"),
                delta("z", "y") - delta("z", "z") - Z_H + _ANGLES_IN_Z,
                "YZ",
            ),
            *along("1", 1, "y", "z", "line YZ", "where "),
        ),
    ),
    Printed(
        38,
        "solution of Y and Z",
        "3.5",
        (
            Formula(
                "delta_z(y)",
                delta("z", "y"),
                reading("1", "z") + delta("z", "z") + Z_H - _ANGLES_IN_Z,
                "YZ",
            ),
            Formula(
                "delta_y(z)",
                delta("y", "z"),
                -reading("1", "y") + delta("y", "y") + Y_H + Z_H * EPS_YZ + _ANGLES_IN_Y,
                "YZ",
            ),
        ),
    ),
)
