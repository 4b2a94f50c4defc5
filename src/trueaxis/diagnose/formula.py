"""The term of an effect as a formula, in LaTeX, bound to its place."""

from trueaxis.effects.kind import Effect
from trueaxis.effects.latex import effect_latex
from trueaxis.spec.machine import Machine


def formula_of(machine: Machine, effect: Effect) -> str:
    """What an effect adds, and to what, values not filled in; as the generated equations have it."""
    return effect_latex(machine.kinds[effect.kind], effect)
