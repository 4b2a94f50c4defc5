"""First order: what each error, alone and small, does to a point (the pair of error-free part and first-order part).

What the location errors make of the right angles between the linear axes is of first order, too.

An error factor met at the ideal point p displaces it by delta + epsilon x p (its generators applied to p); the
factors that follow only turn that displacement. Met inverted, the displacement is the opposite, at the point after
the factor, which to first order is the same. So the sensitivity of a view to every error is one product.

A branch is multiplied out body by body as such a pair: [SBk] = (1 + N_k) [SBk]^0, where N_k is the 4x4 matrix of a
small rotation Theta_k about the origin of the bed frame and a displacement D_k. An error factor (delta, epsilon) that
is met behind the error-free product (R, p) adds R epsilon to Theta and R delta + p x R epsilon to D; nothing is
expanded and nothing of second order arises.

The direction of an axis is that in which its body's frame moves, seen from the bed, turned by the position errors
below it. The angle between two axes departs from 90 deg by the scalar product of their directions.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import (
    ZERO,
    Error,
    Joint,
    Shift,
    Turn,
    Vector,
    added,
    cross,
    cross_matrix,
    expanded,
    joint,
    matrix,
    rotation,
    times,
    turned,
)
from trueaxis.derivation.expressions import renamed
from trueaxis.derivation.products import NOTHING, ONE, Sum, polynomial
from trueaxis.derivation.views import ViewWalk
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.machine.topology import branch

Columns = Mapping[str, Vector]
Sums = tuple[Sum, Sum, Sum]


@dataclass(frozen=True)
class FirstOrder:
    """Ideal point (mm) and the columns of d(point)/d(error), by error name in the order met from the bed outwards."""

    ideal: Vector
    columns: dict[str, Vector]

    def deviation(self) -> Vector:
        """The first-order deviation: sum of sensitivity times error, mm."""
        x, y, z = (
            sp.Add(*(column[row] * symbols.named(name) for name, column in self.columns.items())) for row in range(3)
        )
        return x, y, z


@cache
def first_order(view: ViewWalk, point: Vector) -> FirstOrder:
    """Walk a point through a view to first order; `point` in the frame of the seen body, mm."""
    generic = symbols.point()
    if point != generic and all(coordinate.is_Symbol for coordinate in point):
        return _of_point(first_order(view, generic), dict(zip(generic, point, strict=True)))
    at = _sums(point)
    columns: dict[str, Sums] = {}
    for factor in view.walk:
        sign = -1 if factor.inverted else 1
        match factor.step:
            case Shift(by):
                at = added(at, _sums(by), sign)
            case Turn(axis, cosine, sine):
                cosine, sine, _ = _sums((cosine, sign * sine, sp.S.Zero))
                at = turned(axis, cosine, sine, at)
                columns = {name: turned(axis, cosine, sine, column) for name, column in columns.items()}
            case Error(_, _, names):
                for name, effect in zip(names, _generators(at), strict=True):
                    if name is not None:
                        # A body below both ends is met twice: both effects add.
                        columns[name] = added(columns.get(name, _sums(ZERO)), effect, sign)
    return FirstOrder(_told(at), {name: _told(column) for name, column in columns.items()})


def _of_point(found: FirstOrder, names: Mapping[sp.Symbol, sp.Symbol]) -> FirstOrder:
    def told(vector: Vector) -> Vector:
        x, y, z = (renamed(value, names) for value in vector)
        return x, y, z

    return FirstOrder(told(found.ideal), {name: told(column) for name, column in found.columns.items()})


def _sums(vector: Vector) -> Sums:
    x, y, z = map(polynomial, vector)
    return x, y, z


def _told(vector: Sums) -> Vector:
    x, y, z = (value.expression() for value in vector)
    return x, y, z


def _generators(at: Sums) -> tuple[Sums, ...]:
    """What a unit of each of the six errors does to a point: displacements, then rotations about X, Y and Z."""
    x, y, z = at
    one, zero = ONE, NOTHING
    return (one, zero, zero), (zero, one, zero), (zero, zero, one), (zero, -z, y), (z, zero, -x), (-y, x, zero)


@dataclass(frozen=True)
class Squareness:
    """A pair of linear axes and the scalar product of their directions (rad): pi/2 minus the angle between them."""

    axes: tuple[str, str]
    product: sp.Expr


@cache
def squarenesses(machine: Machine) -> tuple[Squareness, ...]:
    """Every pair of linear axes, at home of the rotary axes."""
    linear = [axis for axis in machine.axes if axis in LINEAR]
    directions = {axis: _direction(machine, axis) for axis in linear}
    return tuple(
        Squareness((a, b), _linear((directions[a].T * directions[b])[0]))
        for index, a in enumerate(linear)
        for b in linear[index + 1 :]
    )


def _direction(machine: Machine, axis: str) -> sp.Matrix:
    mover = machine.mover(axis)
    frame = sp.eye(3)
    for body in branch(machine, mover.number):
        part = joint(body)
        for step in (part.position_error, part.motion):
            match step:
                case Error(_, angles, _):
                    frame = frame * (sp.eye(3) + cross_matrix(angles))
                case Turn(letter, _, _):
                    frame = frame * rotation(letter, sp.S.One, sp.S.Zero)
    way = sp.Matrix([mover.sense if axis == letter else 0 for letter in LINEAR])
    return frame * way


def _linear(value: sp.Expr) -> sp.Expr:
    """The terms of first order of a polynomial in the location errors."""
    numbers = polynomial(value).numbers
    return Sum({factors: number for factors, number in numbers.items() if len(factors) == 1}).expression()


@dataclass(frozen=True)
class BranchStep:
    """What one joint adds to its branch.

    ideal: [SBk]^0, 4x4, mm. rotation, displacement: for each error of the joint, by its name, the vector by which a
    unit of it changes Theta (rad per mm or rad) and D (mm per mm or rad), bed frame.
    """

    joint: Joint
    ideal: sp.Matrix
    rotation: Columns
    displacement: Columns


def branch_steps(joints: tuple[Joint, ...]) -> tuple[BranchStep, ...]:
    """The steps of a branch from the bed outwards."""
    at = sp.eye(4)
    steps: list[BranchStep] = []
    for part in joints:
        rotations: dict[str, Vector] = {}
        displacements: dict[str, Vector] = {}
        for factor in part.steps:
            if not isinstance(factor, Error):
                at = times(at, matrix(factor))
                continue
            for index, name in enumerate(factor.names):
                if name is None:
                    continue
                way = expanded(at[:3, index % 3])
                if index < 3:
                    displacements[name] = way
                else:
                    rotations[name] = way
                    displacements[name] = cross(expanded(at[:3, 3]), way)
        steps.append(BranchStep(part, at, rotations, displacements))
    return tuple(steps)
