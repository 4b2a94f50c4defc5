"""The paper's symbols: one place where `delta_x(x)`, `r_k1y` or `L_1xh` become SymPy symbols."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

DIRECTIONS = ("x", "y", "z")


def delta(direction: str, axis: str) -> sp.Symbol:
    """Translational motion error of `axis` in `direction`, mm: delta_direction(axis)."""
    return sp.Symbol(f"delta_{direction}({axis})", real=True)


def eps(direction: str, axis: str) -> sp.Symbol:
    """Rotational motion error of `axis` about `direction`, rad: epsilon_direction(axis)."""
    return sp.Symbol(f"epsilon_{direction}({axis})", real=True)


EPS_XY, EPS_XZ, EPS_YZ = sp.symbols("epsilon_xy epsilon_xz epsilon_yz", real=True)
SQUARENESS = (EPS_XY, EPS_XZ, EPS_YZ)
MOTION_ERRORS = tuple(error(d, axis) for axis in DIRECTIONS for error in (delta, eps) for d in DIRECTIONS)
"""The 18 motion errors, axis by axis, delta before epsilon: the order of every vector of them here."""

X_H, Y_H, Z_H = sp.symbols("x_h y_h z_h", real=True)
POSITION = {"x": X_H, "y": Y_H, "z": Z_H}


def r(point: str, direction: str) -> sp.Symbol:
    """Coordinate of a measuring point: r("k1", "y") is r_k1y."""
    return sp.Symbol(f"r_{point}{direction}", real=True)


def reading(label: str, direction: str) -> sp.Symbol:
    """Measured displacement: reading("1", "x") is L_1xh."""
    return sp.Symbol(f"L_{label}{direction}h", real=True)


def place(direction: str, point: str, pose: str) -> sp.Symbol:
    """Coordinate of a point in the bed's frame: place("x", "k", "h") is x_kh."""
    return sp.Symbol(f"{direction}_{point}{pose}", real=True)


@dataclass(frozen=True, slots=True)
class Formula:
    """A printed equality lhs = rhs, to hold in `run` (which axes move, or which other setting)."""

    label: str
    lhs: sp.Expr
    rhs: sp.Expr
    run: str

    def residual(self, known: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
        """lhs - rhs once the readings, positions and definitions in `known` are put in; zero where it holds."""
        return sp.expand((self.lhs - self.rhs).xreplace(dict(known)))


@dataclass(frozen=True, slots=True)
class Definition:
    """A printed equality that defines its left-hand side: transcribed and used by other parts, nothing to compare."""

    label: str
    lhs: sp.Expr
    rhs: sp.Expr


@dataclass(frozen=True, slots=True)
class Entry:
    """A printed item that is compared as it stands: a table cell, a matrix, an index, a word."""

    label: str
    printed: object


@dataclass(frozen=True, slots=True)
class Printed:
    """One numbered equation (int) or table ("Table 2") with its place in the paper and its parts."""

    number: int | str
    title: str
    section: str
    parts: tuple[Formula | Definition | Entry, ...]
