"""Eqs. (39)-(43): squareness from pitch and yaw, as printed."""

from __future__ import annotations

import sympy as sp

from ..notation import EPS_XY, EPS_XZ, EPS_YZ, Definition, Formula, Printed

COUNT = sp.Symbol("n", integer=True, positive=True)
"""Upper limit of the sums: h in Eq. (39), n in Eq. (41)."""
INDEX = sp.Symbol("i", integer=True)
OFFSETS = ("yx", "zx", "xy", "zy", "yz", "xz")
"""The pairs uv of P_uv: offset of axis v in direction u."""
PRINTED_ANGLE = {"yx": "z", "zx": "y", "xy": "z", "zy": "x", "yz": "x", "xz": "y"}


def angles(direction: str, axis: str) -> sp.IndexedBase:
    """Sampled rotational error epsilon_direction(axis_i)."""
    return sp.IndexedBase(f"epsilon_{direction}({axis})", real=True)


def positions(axis: str) -> sp.IndexedBase:
    """Sampled positions axis_i."""
    return sp.IndexedBase(axis, real=True)


def offset(pair: str) -> sp.Symbol:
    """P_uv at the last sampled position."""
    return sp.Symbol(f"P_{pair}", real=True)


def intercept(pair: str) -> sp.Symbol:
    """c_uv0."""
    return sp.Symbol(f"c_{pair}0", real=True)


def slope(pair: str) -> sp.Symbol:
    """c_uv1."""
    return sp.Symbol(f"c_{pair}1", real=True)


def fitted(pair: str) -> sp.Symbol:
    """P'_uv."""
    return sp.Symbol(f"P'_{pair}", real=True)


def total(term: sp.Expr) -> sp.Sum:
    """Sum of an indexed term from 1 to COUNT."""
    return sp.Sum(term, (INDEX, 1, COUNT))


def _offset_curve(pair: str) -> Formula:
    axis = pair[1]
    term = angles(PRINTED_ANGLE[pair], axis)[INDEX] * positions(axis)[INDEX]
    return Formula(f"P_{pair}", offset(pair), total(term), "offset curve")


V, P = positions("v"), sp.IndexedBase("P_uv", real=True)
DENOMINATOR = COUNT * total(V[INDEX] ** 2) - total(V[INDEX]) ** 2


def _ratio(pair: str) -> Formula:
    axis = sp.Symbol(pair[1], real=True)
    return Formula(f"P'_{pair}", axis, (fitted(pair) - intercept(pair)) / slope(pair), "fitted lines")


def _cosine(dot: sp.Expr, first: tuple[str, str], second: tuple[str, str]) -> sp.Expr:
    lengths = [sp.sqrt(1 + slope(a) ** 2 + slope(b) ** 2) for a, b in (first, second)]
    return dot / (lengths[0] * lengths[1])


_XY = _cosine(slope("xy") + slope("yx") + slope("zx") * slope("zy"), ("yx", "zx"), ("xy", "zy"))
_XZ = _cosine(slope("xz") + slope("zx") + slope("yx") * slope("yz"), ("yx", "zx"), ("xz", "yz"))
_YZ = _cosine(slope("yz") + slope("zy") + slope("xy") * slope("xz"), ("xy", "zy"), ("xz", "yz"))

SQUARENESS_SECTION: tuple[Printed, ...] = (
    Printed(
        39,
        "offset curves of the axis lines",
        "3.6",
        tuple(_offset_curve(pair) for pair in OFFSETS),
    ),
    Printed(
        40,
        "best fitting line",
        "3.6",
        (
            Definition(
                "P'_uv",
                fitted("uv"),
                intercept("uv") + slope("uv") * sp.Symbol("v", real=True),
            ),
        ),
    ),
    Printed(
        41,
        "coefficients of the line",
        "3.6",
        (
            Formula(
                "c_uv0",
                intercept("uv"),
                (total(V[INDEX] ** 2) * total(P[INDEX]) - total(V[INDEX]) * total(V[INDEX] * P[INDEX])) / DENOMINATOR,
                "least squares",
            ),
            Formula(
                "c_uv1",
                slope("uv"),
                (COUNT * total(V[INDEX] * P[INDEX]) - total(V[INDEX]) * total(V[INDEX] * P[INDEX])) / DENOMINATOR,
                "least squares",
            ),
        ),
    ),
    Printed(42, "the three axis lines", "3.6", tuple(_ratio(pair) for pair in OFFSETS)),
    Printed(
        43,
        "squareness from the lines",
        "3.6",
        (
            Formula("epsilon_xy", EPS_XY, sp.pi / 2 - sp.acos(_XY), "directions"),
            Formula("epsilon_xz", EPS_XZ, sp.acos(_XZ) - sp.pi / 2, "directions"),
            Formula("epsilon_yz", EPS_YZ, sp.acos(_YZ) - sp.pi / 2, "directions"),
        ),
    ),
)
