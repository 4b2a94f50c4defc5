"""Effects of a machine beside the point-by-point method: those known are taken off the readings."""

from dataclasses import replace

from trueaxis.estimation.effects.faults import check_columns
from trueaxis.estimation.effects.signature import added_by, all_rows, ground_of
from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.io.faults import Faults
from trueaxis.model.effect_values import identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel


def without_effects(machine: IdentifiedMachine, observed: Observations, given: ErrorValues) -> Observations:
    """The readings less what effects of known values add to them.

    Raises InputError where the machine has effects of unknown values: a table of one component tells nothing of them;
    and where the readings lack a column that an effect depends on.
    """
    if not isinstance(machine, MachineModel) or not machine.effects:
        return observed
    faults = Faults(observed.source)
    known = {identity(one.effect) for one in given.effects}
    for effect in machine.effects:
        if identity(effect) not in known:
            problem = f"the machine has the effect {effect.label}, whose values the point-by-point method cannot find"
            faults.add("", problem, "use --method global, or give its values with --known")
    faults.raise_if_any()
    ground = ground_of(machine, observed)
    pairs = [(effect, machine.kinds[effect.kind]) for effect in machine.effects]
    check_columns(ground, pairs, all_rows(observed, ground))
    ground = ground_of(machine, replace(observed, context=ground.context.filled()))
    return replace(observed, reading=observed.reading - added_by(ground, given.effects))
