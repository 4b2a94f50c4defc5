"""The term of an effect as a formula, in LaTeX, bound to its place."""

from trueaxis.effects.kind import Effect
from trueaxis.spec.machine import Machine


def formula_of(machine: Machine, effect: Effect) -> str:
    """Such as `E_{XX} \\mathrel{+}= ...`, from the expression of its kind."""
    return machine.kinds[effect.kind].expression
