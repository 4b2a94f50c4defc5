"""The kinematics module as a model: what it takes off, to be judged by the model of the machine."""

from dataclasses import replace

import numpy as np

from trueaxis.controllers.axis_tables import approached
from trueaxis.controllers.remaining import TakenOff, held_effects
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel

# mm or deg. The positions that a pose asks for lie beyond the travel by as much as the machine is off there: curves go
# on so far and hold their values beyond. A machine that is off by more is to be mended first.
BEYOND = 5.0
_STEPS = 20  # MOST_STEPS of trueaxiskins.c
_TOLERANCE = 1e-11  # mm: TOLERANCE there


def taken_by_module(model: MachineModel, tool: FloatArray) -> TakenOff:
    """By how much the module moves the axes; tool: (3, 1), mm. The direction of approach it cannot know."""

    def taken(positions: FloatArray, _: FloatArray) -> FloatArray:
        total = np.zeros_like(positions)
        for _step in range(_STEPS):
            moved = positions - total
            off = model.view_deviation_of(
                "tool_in_workpiece", moved, errors_known(model, moved), model.parameter_values, tool
            )
            before, total = total, model.correction(moved, off)
            if float(np.abs(total - before).max(initial=0.0)) <= _TOLERANCE:
                break
        return total

    return taken


def errors_known(model: MachineModel, positions: FloatArray) -> FloatArray:
    """(n_components, n): the error components that positions (n_axes, n) tell, mm and rad: curves, and effects of
    positions; those of the direction of approach as the mean of both.
    """
    low = np.array([model.travel[axis][0] - BEYOND for axis in model.axes])[:, np.newaxis]
    high = np.array([model.travel[axis][1] + BEYOND for axis in model.axes])[:, np.newaxis]
    at = np.clip(positions, low, high)
    model = model.with_values(replace(model.errors, effects=held_effects(model)))
    if not model.effect_values:
        return model.component_errors(at)
    found = np.zeros((len(model.components), at.shape[1]))
    for row, axis in enumerate(model.axes):
        own = [index for index, name in enumerate(model.components) if name.axis == axis]
        for sign in (1.0, -1.0):
            directions = np.zeros(len(model.axes))
            directions[row] = sign
            there = model.in_context(approached(model, at.shape[1], directions))
            found[own] += 0.5 * there.component_errors(at)[own]
    return found
