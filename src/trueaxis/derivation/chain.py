"""The chain of a machine, kept factored: the four steps of each joint (Eq. 1), their matrices and their products.

[SIJ] = [SIJ]_p [SIJ]_pe [SIJ]_s [SIJ]_se: ideal position, position error, ideal motion, motion error.
"""

from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.products import multiplied_out
from trueaxis.error_name import DIRECTIONS
from trueaxis.machine.machine import LINEAR, Body, Machine
from trueaxis.machine.topology import branches

Vector = tuple[sp.Expr, sp.Expr, sp.Expr]
_PLANES = {"A": (1, 2), "B": (2, 0), "C": (0, 1)}  # places of the coordinates that a rotation mixes
ZERO: Vector = (sp.S.Zero, sp.S.Zero, sp.S.Zero)


@dataclass(frozen=True)
class Shift:
    """An ideal translation, mm: home position or motion of a linear axis."""

    by: Vector


@dataclass(frozen=True)
class Turn:
    """An ideal rotation of a rotary body about its own axis `axis` (A about X ...), counter-clockwise if positive."""

    axis: str
    cosine: sp.Expr
    sine: sp.Expr


@dataclass(frozen=True)
class Error:
    """A small displacement (mm) and rotation (rad): the contract's small-rotation matrix.

    Names are those of the error symbols, None where the spec has no such error.
    """

    displacement: Vector
    rotation: Vector
    names: tuple[str | None, ...]


Step = Shift | Turn | Error


@dataclass(frozen=True, kw_only=True)
class Joint:
    """The four factors of Eq. (1) between a body and its lower body."""

    body: Body
    position: Shift
    position_error: Error
    motion: Shift | Turn
    motion_error: Error

    @property
    def steps(self) -> tuple[Step, ...]:
        """The factors in the order of Eq. (1)."""
        return self.position, self.position_error, self.motion, self.motion_error


def joint(body: Body) -> Joint:
    """The joint of a body: ideal position, position error, ideal motion, motion error."""
    x, y, z = (symbols.named(part) if isinstance(part, str) else _number(part) for part in body.position)
    location = dict(body.position_errors)
    components = {name.direction: name for name in body.motion_errors}
    return Joint(
        body=body,
        position=Shift((x, y, z)),
        position_error=_error([location.get(direction) for direction in DIRECTIONS]),
        motion=_motion(body),
        motion_error=_error([components.get(direction) for direction in DIRECTIONS]),
    )


def chains(machine: Machine) -> tuple[tuple[Joint, ...], tuple[Joint, ...]]:
    """The joints from the bed to the workpiece (Eq. 2) and to the tool (Eq. 3)."""
    workpiece, tool = branches(machine)
    return tuple(joint(body) for body in workpiece), tuple(joint(body) for body in tool)


def matrix(step: Step) -> sp.Matrix:
    """The 4x4 matrix of one factor (Table 2 of the paper)."""
    result = sp.eye(4)
    match step:
        case Shift(by):
            result[:3, 3] = sp.Matrix(by)
        case Turn(axis, cosine, sine):
            result[:3, :3] = rotation(axis, cosine, sine)
        case Error(displacement, angles, _):
            result[:3, :3] += cross_matrix(angles)
            result[:3, 3] = sp.Matrix(displacement)
    return result


def times(left: sp.Matrix, right: sp.Matrix) -> sp.Matrix:
    """The product of two matrices, mostly of zeros, its elements multiplied out."""
    columns = right.T.tolist()
    return sp.Matrix(
        [
            [
                multiplied_out(sp.Add(*(a * b for a, b in zip(row, column, strict=True) if a and b)))
                for column in columns
            ]
            for row in left.tolist()
        ]
    )


def product(joints: tuple[Joint, ...]) -> sp.Matrix:
    """[SB.]: the exact product along a branch (Eqs. 2, 3), multiplied but never expanded."""
    result = sp.eye(4)
    for part in joints:
        for step in part.steps:
            result = result * matrix(step)
    return result


def rotation(axis: str, cosine: sp.Expr, sine: sp.Expr) -> sp.Matrix:
    """3x3 rotation about X (A), Y (B) or Z (C)."""
    first, second = _PLANES[axis]
    result = sp.eye(3)
    result[first, first] = result[second, second] = cosine
    result[second, first], result[first, second] = sine, -sine
    return result


def turned(axis: str, cosine: sp.Expr, sine: sp.Expr, vector: Vector) -> Vector:
    """The vector after a rotation about X (A), Y (B) or Z (C)."""
    result = list(vector)
    first, second = _PLANES[axis]
    result[first] = cosine * vector[first] - sine * vector[second]
    result[second] = sine * vector[first] + cosine * vector[second]
    x, y, z = result
    return x, y, z


def cross_matrix(vector: Vector) -> sp.Matrix:
    """The matrix of v x ."""
    a, b, c = vector
    return sp.Matrix([[0, -c, b], [c, 0, -a], [-b, a, 0]])


def cross(left: Vector, right: Vector) -> Vector:
    """The vector product."""
    (a, b, c), (x, y, z) = left, right
    return b * z - c * y, c * x - a * z, a * y - b * x


def added(left: Vector, right: Vector, sign: int = 1) -> Vector:
    """The left vector plus sign times the right one."""
    x, y, z = (a if b is sp.S.Zero else a + b if sign == 1 else a - b for a, b in zip(left, right, strict=True))
    return x, y, z


def expanded(vector: Vector) -> Vector:
    """The same as sums of products."""
    x, y, z = map(multiplied_out, vector)
    return x, y, z


def _error(names: list[str | None]) -> Error:
    ex, ey, ez, ea, eb, ec = (symbols.named(name) if name else sp.S.Zero for name in names)
    return Error((ex, ey, ez), (ea, eb, ec), tuple(names))


def _motion(body: Body) -> Shift | Turn:
    if body.moves is None:
        return Shift(ZERO)
    if body.moves in LINEAR:
        way = body.sense * symbols.position(body.moves)
        x, y, z = (way if axis == body.moves else sp.S.Zero for axis in LINEAR)
        return Shift((x, y, z))
    return Turn(body.moves, symbols.cosine(body.moves), body.sense * symbols.sine(body.moves))


def _number(value: float | str) -> sp.Expr:
    # Whole millimetres stay integers, so that zeros vanish; others keep every digit.
    return sp.Integer(int(value)) if float(value).is_integer() else sp.Float(value, 17)
