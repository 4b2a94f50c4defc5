"""How large the amplitudes of a candidate can be: what no machine has explains nothing."""

import numpy as np

from trueaxis.diagnosis.null_model.base import LARGEST
from trueaxis.effects.kind import Kind
from trueaxis.effects.placement import SINCE_REVERSAL, used_variables
from trueaxis.error_name import DISPLACEMENTS, ErrorName
from trueaxis.machine.machine import LINEAR, ROTARY
from trueaxis.model.model import MachineModel

EXPANSION = 25e-6  # 1/K: of aluminium; other metals of machines grow less
BENDING = 4.0  # times what a rod as long as the travels grows, or that over its length: structures that bend


def most_of_component(model: MachineModel, component: ErrorName, kind: Kind) -> float:
    """In the unit of the amplitude: where an axis turns, since of an error that has decayed for long any size would
    explain a little; and per kelvin, since a temperature that hardly changes goes with anything that happens once. Of
    others infinite.
    """
    turns = component.direction not in DISPLACEMENTS
    if decays(kind):
        return LARGEST * (model.prior.rotation if turns else model.prior.translation)
    unit = next((one.unit for one in kind.parameters if one.role == "linear"), "")
    if not unit.endswith("/K"):
        return np.inf
    of_axis = np.pi / 180.0 if component.axis in ROTARY else 1.0  # its positions are in deg
    of_a_rod = 1.0 if turns else of_axis if "/axis" in unit else extent(model)
    return BENDING * EXPANSION * of_a_rod


def decays(kind: Kind) -> bool:
    """Whether it decays from a reversal on."""
    return not set(SINCE_REVERSAL).isdisjoint(used_variables(kind))


def extent(model: MachineModel) -> float:
    """mm, of the linear travels together: no point of a machine is farther from where it is said to be."""
    spans = [model.travel[axis][1] - model.travel[axis][0] for axis in model.axes if axis in LINEAR]
    return float(np.linalg.norm(spans)) or np.inf
