"""Motion equations (Eqs. 7-11): displacement of a point since home while some axes move and the others stand still.

As in the paper the motion errors are zero at home, so an axis that stands still at home has none.
"""

from collections.abc import Collection
from dataclasses import dataclass
from functools import cache

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import ZERO, Vector, added, expanded
from trueaxis.derivation.first_order import FirstOrder, first_order
from trueaxis.derivation.views import view
from trueaxis.machine.machine import LINEAR, ROTARY, Machine
from trueaxis.machine.topology import branches
from trueaxis.view import Carrier, Frame, view_of


@dataclass(frozen=True)
class MotionEquation:
    """First-order displacement since home (mm): ideal part, and a column per error.

    moves: the axes that move. terms: (sign, seen body, point symbols) whose displacements are added.
    """

    moves: tuple[str, ...]
    frame: Frame
    terms: tuple[tuple[int, Carrier, Vector], ...]
    motion: FirstOrder


@cache
def motion_equation(
    machine: Machine, moves: tuple[str, ...], terms: tuple[tuple[int, Carrier, Vector], ...], frame: Frame = "bed"
) -> MotionEquation:
    """Displacement of the signed sum of points, seen in `frame`, with the axes `moves` away from home."""
    ideal, columns = ZERO, dict[str, Vector]()
    for sign, seen, point in terms:
        if seen == frame:
            continue  # a point does not move in the frame of its own body
        moved = first_order(view(machine, view_of(seen, frame)), point)
        away, home = _still(machine, moves), _still(machine, ())
        ideal = added(ideal, _change(moved.ideal, away, home), sign)
        for name in machine.components:
            if name.axis in moves and name in moved.columns:
                at = _substituted(moved.columns[name], away)
                columns[name] = added(columns.get(name, ZERO), at, sign)
        for location in machine.location_errors:
            if location in moved.columns:
                change = _change(moved.columns[location], away, home)
                columns[location] = added(columns.get(location, ZERO), change, sign)
    kept = {name: expanded(column) for name, column in columns.items() if any(column)}
    ordered = {name: kept[name] for name in machine.components + machine.location_errors if name in kept}
    axes = tuple(axis for axis in machine.axes if axis in moves)
    return MotionEquation(axes, frame, terms, FirstOrder(expanded(ideal), ordered))


def standard_motions(machine: Machine) -> tuple[MotionEquation, ...]:
    """Every single axis and every pair of linear axes, seen from the bed.

    The point is on the tool where only axes of its branch move, on the workpiece where only axes of that branch do,
    else the workpiece point minus the tool point, as in Eq. (11).
    """
    linear = [axis for axis in machine.axes if axis in LINEAR]
    patterns = [(axis,) for axis in machine.axes]
    pairs = [(a, b) for index, a in enumerate(linear) for b in linear[index + 1 :]]
    workpiece = {body.moves for body in branches(machine)[0]}
    tool = {body.moves for body in branches(machine)[1]}
    equations: list[MotionEquation] = []
    for pattern in [*patterns, *pairs]:
        on_tool, on_workpiece = set(pattern) & tool, set(pattern) & workpiece
        terms: tuple[tuple[int, Carrier, Vector], ...] = ()
        if on_workpiece:
            terms += ((1, "workpiece", symbols.point("rW")),)
        if on_tool:
            terms += ((-1 if on_workpiece else 1, "tool", symbols.point("rT")),)
        equations.append(motion_equation(machine, pattern, terms))
    return tuple(equations)


def _still(machine: Machine, moves: Collection[str]) -> dict[sp.Symbol, sp.Expr]:
    """Positions of the axes that do not move."""
    still: dict[sp.Symbol, sp.Expr] = {}
    for axis in machine.axes:
        if axis in moves:
            continue
        if axis in ROTARY:
            still |= {symbols.cosine(axis): sp.S.One, symbols.sine(axis): sp.S.Zero}
        else:
            still[symbols.position(axis)] = sp.S.Zero
    return still


def _change(values: Vector, away: dict[sp.Symbol, sp.Expr], home: dict[sp.Symbol, sp.Expr]) -> Vector:
    return added(_substituted(values, away), _substituted(values, home), -1)


def _substituted(values: Vector, by: dict[sp.Symbol, sp.Expr]) -> Vector:
    x, y, z = (value.xreplace(by) for value in values)
    return x, y, z
