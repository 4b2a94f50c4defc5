"""Where effects act: component errors by their direction, and the context variables that an expression uses."""

from typing import Literal

from trueaxis.effects.expression import names, parse
from trueaxis.effects.kind import Kind
from trueaxis.effects.variables import OF_COMPONENT_TERMS, OF_READING_TERMS, VARIABLES, Variable

Direction = Literal["along", "across", "turn"]


def direction_of(component: str) -> Direction:
    """Whether a component error (ISO 230-1 name) is along the motion of its axis, across it, or turns.

    Along is the positioning error: EXX of a linear axis, ECC of a rotary one.
    """
    if component[1] == component[2]:
        return "along"
    return "across" if component[1] in "XYZ" else "turn"


def allows(kind: Kind, component: str) -> bool:
    """Whether effects of a kind may act on a component error."""
    return component in kind.components or direction_of(component) in kind.directions


def variables_of(kind: Kind) -> tuple[Variable, ...]:
    """The context variables that the expression of a kind may use."""
    if kind.place != "component":
        return OF_READING_TERMS if kind.place == "reading" else ()
    return tuple(one for one in OF_COMPONENT_TERMS if kind.other_axis or not one.name.endswith("_b"))


def context_of(kind: Kind) -> tuple[str, ...]:
    """Rows of the context that the kernel of a kind takes, in the order of VARIABLES.

    Those that its expression uses; where it uses none, the one that every reading of its place has: a kernel takes the
    number of points from it. Empty for a kind without an expression. Raises ExpressionError.
    """
    if not kind.expression:
        return ()
    used = {name.name for name in names(parse(kind.expression))}
    always = {"laser": "along", "ballbar": "theta"}.get(kind.instrument, "q")
    return tuple(name for name in VARIABLES if name in used) or (always,)
