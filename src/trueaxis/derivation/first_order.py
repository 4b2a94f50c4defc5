"""First order: what each error, alone and small, does to a point (the pair of error-free part and first-order part).

What the location errors make of the right angles between the linear axes is of first order, too.

An error factor met at the ideal point p displaces it by delta + epsilon x p (its generators applied to p); the
factors that follow only turn that displacement. Met inverted, the displacement is the opposite, at the point after
the factor, which to first order is the same. So the sensitivity of a view to every error is one product.

The direction of an axis is that in which its body's frame moves, seen from the bed, turned by the position errors
below it. The angle between two axes departs from 90 deg by the scalar product of their directions.
"""

from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Error, Shift, Turn, Vector, cross_matrix, joint, rotation
from trueaxis.derivation.views import ViewWalk
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.machine.topology import branch


@dataclass(frozen=True)
class FirstOrder:
    """Ideal point (mm) and the columns of d(point)/d(error), by error name in the order met from the bed outwards."""

    ideal: Vector
    columns: dict[str, Vector]

    def deviation(self) -> Vector:
        """The first-order deviation: sum of sensitivity times error, mm."""
        x, y, z = (
            sp.Add(*(column[row] * sp.Symbol(name, real=True) for name, column in self.columns.items()))
            for row in range(3)
        )
        return x, y, z


def first_order(view: ViewWalk, point: Vector) -> FirstOrder:
    """Walk a point through a view to first order; `point` in the frame of the seen body, mm."""
    at = sp.Matrix(point)
    columns: dict[str, sp.Matrix] = {}
    for factor in view.walk:
        sign = -1 if factor.inverted else 1
        match factor.step:
            case Shift(by):
                at += sign * sp.Matrix(by)
            case Turn(axis, cosine, sine):
                turn = rotation(axis, cosine, sign * sine)
                at = turn * at
                columns = {name: turn * column for name, column in columns.items()}
            case Error(_, _, names):
                generators = sp.Matrix.hstack(sp.eye(3), -cross_matrix(tuple(at)))
                for index, name in enumerate(names):
                    if name is not None:
                        # A body below both ends is met twice: both effects add.
                        columns[name] = columns.get(name, sp.zeros(3, 1)) + sign * generators[:, index]
    return FirstOrder(_vector(at), {name: _vector(column) for name, column in columns.items()})


def _vector(column: sp.Matrix) -> Vector:
    x, y, z = (sp.expand(entry) for entry in column)
    return x, y, z


@dataclass(frozen=True)
class Squareness:
    """A pair of linear axes and the scalar product of their directions (rad): pi/2 minus the angle between them."""

    axes: tuple[str, str]
    product: sp.Expr


def squarenesses(machine: Machine) -> tuple[Squareness, ...]:
    """Every pair of linear axes, at home of the rotary axes."""
    linear = [axis for axis in machine.axes if axis in LINEAR]
    directions = {axis: _direction(machine, axis) for axis in linear}
    return tuple(
        Squareness((a, b), _linear(machine, (directions[a].T * directions[b])[0]))
        for index, a in enumerate(linear)
        for b in linear[index + 1 :]
    )


def _direction(machine: Machine, axis: str) -> sp.Matrix:
    mover = machine.mover(axis)
    turned = sp.eye(3)
    for body in branch(machine, mover.number):
        part = joint(body)
        for step in (part.position_error, part.motion):
            match step:
                case Error(_, angles, _):
                    turned = turned * (sp.eye(3) + cross_matrix(angles))
                case Turn(letter, _, _):
                    turned = turned * rotation(letter, sp.S.One, sp.S.Zero)
    way = sp.Matrix([mover.sense if axis == letter else 0 for letter in LINEAR])
    return turned * way


def _linear(machine: Machine, value: sp.Expr) -> sp.Expr:
    names = [symbols.named(name) for name in machine.location_errors]
    zero = dict.fromkeys(names, sp.S.Zero)
    return sp.Add(*(sp.diff(value, name).subs(zero) * name for name in names))
