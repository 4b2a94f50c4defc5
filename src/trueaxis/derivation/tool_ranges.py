"""From where to where the commands of an axis take the tool, as a person checks it who knows the machine."""

import math

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.first_order import first_order
from trueaxis.derivation.views import view
from trueaxis.machine.machine import LINEAR, ROTARY, Machine


def tool_ranges(machine: Machine) -> dict[str, tuple[float, float]]:
    """Coordinate of the workpiece, mm, from the lowest to the highest position of each linear axis that has a travel:
    of the origin of the tool frame, all other axes where they are nearest to 0, named dimensions 0.
    """
    ideal = first_order(view(machine, "tool_in_workpiece"), symbols.point()).ideal
    rest = dict.fromkeys((*map(symbols.named, machine.dimensions), *symbols.point()), 0.0)
    for axis in machine.axes:
        low, high = machine.travel[axis]
        at = min(max(0.0, low), high)
        rest[symbols.position(axis)] = at
        if axis in ROTARY:
            turn = math.radians(at)
            rest |= {symbols.cosine(axis): math.cos(turn), symbols.sine(axis): math.sin(turn)}
    found = {}
    for axis in machine.axes:
        if axis in LINEAR and machine.mover(axis).travel is not None:
            coordinate = ideal[LINEAR.index(axis)]
            low, high = (_value(coordinate, rest | {symbols.position(axis): end}) for end in machine.travel[axis])
            found[axis] = low, high
    return found


def _value(expression: sp.Expr, at: dict[sp.Symbol, float]) -> float:
    return float(expression.xreplace({symbol: sp.Float(value, 17) for symbol, value in at.items()}))
