"""What effects do to the deviation of a tool point, differentiated by their parameters."""

from collections.abc import Sequence

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.identify.effects.faults import filled
from trueaxis.identify.machine import IdentifiedMachine
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.context import Context
from trueaxis.runtime.effect_terms import component_term
from trueaxis.runtime.effect_values import EffectValues, identity
from trueaxis.runtime.model import MachineModel


def by_effects(
    machine: IdentifiedMachine, by_error: FloatArray, positions: FloatArray, labels: Sequence[str]
) -> list[FloatArray]:
    """(3, m, n) for each of the effects, at the machine's values of them, axes standing.

    by_error: (3, n_components + n_location_errors, n), derivative of the deviation by each error. Effects on readings
    and points of a set-up move no tool: theirs is zero; a squareness is a location error.
    """
    if not isinstance(machine, MachineModel):
        raise ValueError(f"{machine.name} has no effects")
    by_label = {effect.label: effect for effect in machine.effects}
    return [_by_effect(machine, by_error, positions, by_label[label]) for label in labels]


def _by_effect(machine: MachineModel, by_error: FloatArray, positions: FloatArray, effect: Effect) -> FloatArray:
    kind = machine.kinds[effect.kind]
    count = positions.shape[1]
    found = np.zeros((3, len(kind.parameters), count))
    if kind.place == "component":
        values = next((one for one in machine.errors.effects if identity(one.effect) == identity(effect)), None)
        vector = (values or EffectValues(effect, {})).vector(kind)
        still = filled(Context.at_rest(len(machine.axes), count))
        term = component_term(machine.kernels, machine.machine, effect, vector, positions, still)
        found += by_error[:, machine.components.index(effect.component or "")][:, np.newaxis] * term[np.newaxis, 1:]
    return found
