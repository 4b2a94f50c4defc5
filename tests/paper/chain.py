"""The paper's machine composed here from 4x4 matrices by Eq. (1), exactly; nothing of the project is imported.

Tool branch: bed - X (squareness eps_xy about Z) - Z (eps_yz about X, eps_xz about Y); workpiece branch: bed - Y.
Points r_k are in the frame of the Z carriage (body 6), points r_l in that of the Y carriage (body 2).
"""

from __future__ import annotations

import sympy as sp

from .notation import (
    DIRECTIONS,
    EPS_XY,
    EPS_XZ,
    EPS_YZ,
    MOTION_ERRORS,
    POSITION,
    SQUARENESS,
    delta,
    eps,
    r,
)

SCALE = sp.Symbol("t", real=True)
"""All errors are multiplied by it: the derivative at 0 is the first order."""


def _translation(vector: list[sp.Expr]) -> sp.Matrix:
    matrix = sp.eye(4)
    matrix[:3, 3] = sp.Matrix(vector)
    return matrix


def _small_rotation(about: list[sp.Expr]) -> sp.Matrix:
    """Identity plus the matrix of the vector product with `about`, column by column."""
    matrix = sp.eye(4)
    for column in range(3):
        unit = sp.Matrix([int(row == column) for row in range(3)])
        matrix[:3, column] += sp.Matrix(about).cross(unit)
    return matrix


def motion(axis: str, moving: str) -> list[sp.Matrix]:
    """Ideal motion and motion error of an axis; both identity where it stands at home."""
    if axis not in moving:
        return []
    ideal = _translation([POSITION[axis] if d == axis else sp.Integer(0) for d in DIRECTIONS])
    error = _small_rotation([SCALE * eps(d, axis) for d in DIRECTIONS])
    error[:3, 3] = sp.Matrix([SCALE * delta(d, axis) for d in DIRECTIONS])
    return [ideal, error]


def tool_branch(moving: str) -> list[sp.Matrix]:
    """Factors from the bed to the Z carriage."""
    x_error = _small_rotation([sp.Integer(0), sp.Integer(0), SCALE * EPS_XY])
    z_error = _small_rotation([SCALE * EPS_YZ, SCALE * EPS_XZ, sp.Integer(0)])
    return [x_error, *motion("x", moving), z_error, *motion("z", moving)]


def workpiece_branch(moving: str) -> list[sp.Matrix]:
    """Factors from the bed to the Y carriage, the reference of squareness."""
    return motion("y", moving)


def carried(factors: list[sp.Matrix], point: list[sp.Expr]) -> list[sp.Expr]:
    """The point in the bed's frame, the product of the factors applied to it."""
    vector = sp.Matrix([*point, 1])
    for matrix in reversed(factors):
        vector = matrix * vector
    return list(vector[:3])


def at_point(name: str) -> list[sp.Expr]:
    """Coordinates r_name of a measuring point."""
    return [r(name, d) for d in DIRECTIONS]


def first_order(expression: sp.Expr) -> sp.Expr:
    """Value and first derivative in the scale of errors."""
    return sp.expand(expression.subs(SCALE, 0) + sp.diff(expression, SCALE).subs(SCALE, 0))


def exact(expression: sp.Expr) -> sp.Expr:
    """The expression with errors at their full size."""
    return sp.expand(expression.subs(SCALE, 1))


def displacement(moving: str, tool_point: str | None, work_point: str | None) -> list[sp.Expr]:
    """What a run measures, not yet truncated: displacement since home of the measured point.

    The tool point's where only X and Z move, the worktable point's where only Y moves, and by Eq. (11)
    worktable minus tool where both do.
    """
    sides = []
    for branch, point, sign in ((tool_branch, tool_point, -1), (workpiece_branch, work_point, 1)):
        if point is not None:
            moved, home = (carried(branch(axes), at_point(point)) for axes in (moving, ""))
            sides.append([sign * (a - b) for a, b in zip(moved, home, strict=True)])
    if len(sides) == 1:
        sign = 1 if work_point else -1
        return [sign * d for d in sides[0]]
    return [a + b for a, b in zip(*sides, strict=True)]


UNKNOWNS = (*MOTION_ERRORS, *SQUARENESS)
