"""The arguments that routines of a machine share: what each is, its rows, shape and unit."""

import sympy as sp

from trueaxis.derivation.chain import Vector
from trueaxis.derivation.routine import Argument
from trueaxis.machine.machine import ROTARY, Machine

_XYZ = ("x", "y", "z")


def positions_argument(machine: Machine) -> Argument:
    """`positions` (n_axes, n): commanded axis positions."""
    unit = "mm, rotary axes deg" if any(axis in ROTARY for axis in machine.axes) else "mm"
    rows = tuple(axis.lower() for axis in machine.axes)
    return Argument(
        name="positions",
        rows=rows,
        shape=(len(rows),),
        per_point=True,
        unit=unit,
        description=f"commanded positions of {' '.join(machine.axes)}",
    )


def errors_argument(machine: Machine) -> Argument:
    """`errors` (n_components, n): component errors at the points."""
    return Argument(
        name="errors",
        rows=machine.components,
        shape=(len(machine.components),),
        per_point=True,
        unit="mm, rad",
        description="component errors at the point",
    )


def parameters_argument(machine: Machine) -> Argument:
    """`parameters` (n_parameters,): dimensions and location errors."""
    count = (len(machine.parameters),)
    return Argument(
        name="parameters",
        rows=machine.parameters,
        shape=count,
        per_point=False,
        unit="mm, rad",
        description="home positions and location errors",
    )


def point_argument(seen: str, *, per_point: bool = True, name: str = "point", prefix: str = "r") -> Argument:
    """`point` (3, n) or (3,): a point in the frame of its body."""
    return vector_argument(
        name, tuple(prefix + axis for axis in _XYZ), f"point in the {seen} frame", per_point=per_point
    )


def vector_argument(name: str, rows: tuple[str, ...], description: str, *, per_point: bool = True) -> Argument:
    """A vector of three lengths, mm."""
    return Argument(name=name, rows=rows, shape=(len(rows),), per_point=per_point, unit="mm", description=description)


def by_row(rows: tuple[str, ...], values: Vector) -> dict[str, sp.Expr]:
    """Row -> its value."""
    return dict(zip(rows, values, strict=True))
