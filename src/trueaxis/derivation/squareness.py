"""What the location errors make of the right angles between the linear axes, to first order.

The direction of an axis is that in which its body's frame moves, seen from the bed, turned by the position errors
below it. The angle between two axes departs from 90 deg by the scalar product of their directions.
"""

from dataclasses import dataclass

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Error, Turn, cross_matrix, joint, rotation
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.machine.topology import branch


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
