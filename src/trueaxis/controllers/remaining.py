"""What a compensation leaves: the machine as the control would drive it, with the tables as they are written.

A control sees positions and at best directions: effects of these it can know of.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.controllers.axis_tables import AxisTable, approached
from trueaxis.effects.placement import SINCE_REVERSAL, context_of
from trueaxis.model.context import Context
from trueaxis.model.curves import FloatArray
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel, home_of

# (n_axes, n) from positions (n_axes, n) and directions of approach (n_axes,): by how much the control takes each axis
# to be off, mm or deg
TakenOff = Callable[[FloatArray, FloatArray], FloatArray]
ROUNDING = 1e-6  # mm: tables have steps of 1e-6 mm and more, and so has a machine without errors with them
# what effects may depend on that no control is told of here: see effects/placement.py
UNTABLED = {"v", *SINCE_REVERSAL, "t", "T"}


@dataclass(frozen=True, slots=True)
class Remaining:
    """RMS over positions of the length of the tool point's deviation from home, mm: before, and with the tables."""

    before: float
    after: float

    @property
    def worse(self) -> bool:
        """Whether the tables do harm, beyond what rounding makes."""
        return self.after > self.before + ROUNDING


def remaining(model: MachineModel, tool: FloatArray, positions: FloatArray, taken: TakenOff) -> Remaining:
    """Over positions (n_axes, n), approached by all axes forward and backward; tool: (3, 1), mm."""
    square_before, square_after, count = 0.0, 0.0, 0
    axes, n = len(model.axes), positions.shape[1]
    home = home_of(model)
    zero = model.in_context(Context.at_rest(axes, 1)).deviation(home, tool)
    home_moved = home - taken(home, np.zeros(axes))
    zero_moved = _off(model.in_context(Context.at_rest(axes, 1)), tool, home, home_moved)
    signs = (1.0, -1.0) if model.effect_values else (0.0,)
    for sign in signs:
        directions = np.full(axes, sign)
        here = model.in_context(approached(model, n, directions))
        before = here.deviation(positions, tool) - zero
        after = _off(here, tool, positions, positions - taken(positions, directions)) - zero_moved
        square_before += float((before**2).sum())
        square_after += float((after**2).sum())
        count += n
    return Remaining(float(np.sqrt(square_before / count)), float(np.sqrt(square_after / count)))


def taken_by_tables(model: MachineModel, tables: Sequence[AxisTable], *, both_directions: bool) -> TakenOff:
    """What a control takes off that interpolates the tables on a straight line and holds their ends.

    both_directions: whether it has the error of an axis along itself for each direction of approach, or their mean.
    """

    def taken(positions: FloatArray, directions: FloatArray) -> FloatArray:
        total = np.zeros_like(positions)
        for table in tables:
            row = model.axes.index(table.by)
            sign = directions[row] if both_directions and table.of == table.by else 0.0
            values = table.forward if sign > 0.0 else table.backward if sign < 0.0 else table.mean
            total[model.axes.index(table.of)] += np.interp(positions[row], table.positions, values)
        return total

    return taken


def _off(model: MachineModel, tool: FloatArray, wanted: FloatArray, commanded: FloatArray) -> FloatArray:
    """(3, n): where the tool is at the positions commanded, less where it should be at those wanted."""
    return model.ideal(commanded, tool) - model.ideal(wanted, tool) + model.deviation(commanded, tool)


def held_effects(model: MachineModel) -> tuple[EffectValues, ...]:
    """Effects on error components that depend on positions and directions alone."""
    return tuple(one for one in _on_components(model) if not UNTABLED & _variables(model, one))


def untabled_effects(model: MachineModel) -> tuple[str, ...]:
    """Labels of effects of the error values on more than positions and directions: no table holds them."""
    return tuple(one.effect.label for one in _on_components(model) if UNTABLED & _variables(model, one))


def directed_effects(model: MachineModel) -> tuple[str, ...]:
    """Labels of effects of the direction of approach."""
    return tuple(one.effect.label for one in held_effects(model) if "direction" in _variables(model, one))


def _on_components(model: MachineModel) -> list[EffectValues]:
    return [one for one in model.effect_values if model.kinds[one.effect.kind].place == "component"]


def _variables(model: MachineModel, values: EffectValues) -> set[str]:
    return {name.removesuffix("_b") for name in context_of(model.kinds[values.effect.kind])}
