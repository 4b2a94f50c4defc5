"""Which effects a control can know of, that sees positions and at best directions."""

from trueaxis.effects.placement import SINCE_REVERSAL, context_of
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel

# what effects may depend on that no control is told of here: see effects/placement.py
UNTABLED = {"v", *SINCE_REVERSAL, "t", "T"}


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
