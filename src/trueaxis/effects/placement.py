"""Where effects act: component errors by their direction, and the context variables that an expression may use."""

from dataclasses import dataclass
from functools import cache
from typing import Literal, Protocol

from trueaxis.effects.expression import names, parse
from trueaxis.effects.kind import Effect, Kind
from trueaxis.error_name import ErrorName

REFERENCE_TEMPERATURE = 20.0  # degC, ISO 1
# What d, d_time, d_path are before the first reversal: exp(-d/w) and its derivatives are then 0, an infinite d would
# make them NaN.
FARTHEST = 1e9
SINCE_REVERSAL = ("d", "d_time", "d_path")
Way = Literal["along", "across", "turn"]


@dataclass(frozen=True, slots=True)
class Variable:
    """A context variable; unit: `axis` stands for mm or deg, as the axis has it."""

    name: str
    unit: str
    latex: str
    meaning: str


OF_AXIS = (
    Variable("q", "axis", "q", "commanded position of the axis"),
    Variable("s", "1", "s", "share of its travel, 0 at the lower end and 1 at the upper"),
    Variable("direction", "1", r"\sigma", "direction of the last motion of the axis: +1, -1, 0 before it has moved"),
    Variable("v", "axis/s", "v", "velocity of the axis while the reading is taken, 0 where it stands"),
    Variable("d", "axis", "d", "distance since its last reversal, 1e9 before the first"),
    Variable("d_time", "s", r"\Delta t", "time since its last reversal, 1e9 before the first"),
    Variable(
        "d_path", "mm", "p", "distance along the path of all linear axes since its last reversal, 1e9 before the first"
    ),
)
OF_OTHER_AXIS = tuple(
    Variable(f"{one.name}_b", one.unit, f"{one.latex}_b", f"{one.meaning} (the other axis)") for one in OF_AXIS
)

OF_TIME = (
    Variable("t", "s", "t", "time of the reading"),
    Variable("T", "K", "T", "temperature minus 20 degC"),
)

OF_READING = (
    Variable("along", "mm", r"\ell", "ideal displacement in the sensitive direction, since home"),
    Variable("theta", "rad", r"\theta", "polar angle of a ball bar in the plane of its circle"),
    Variable("along_line", "mm", "w", "ideal displacement of laser or probe along the line of the motion, since home"),
)
OF_COMPONENT_TERMS = (*OF_AXIS, *OF_OTHER_AXIS, *OF_TIME)
OF_READING_TERMS = (*OF_READING, *OF_TIME)
VARIABLES = {one.name: one for one in (*OF_AXIS, *OF_OTHER_AXIS, *OF_TIME, *OF_READING)}


class ReadRun(Protocol):
    """A run of readings."""

    @property
    def id(self) -> str:
        """Its id."""
        ...

    @property
    def instrument(self) -> str:
        """By what it was read."""
        ...


def way_of(component: ErrorName) -> Way:
    """Whether a component error (ISO 230-1 name) is along the motion of its axis, across it, or turns.

    Along is the positioning error: EXX of a linear axis, ECC of a rotary one.
    """
    if component.is_positioning:
        return "along"
    return "turn" if component.is_rotation else "across"


def allows(kind: Kind, component: ErrorName) -> bool:
    """Whether effects of a kind may act on a component error."""
    return component in kind.components or way_of(component) in kind.directions


def reads(kind: Kind, instrument: str) -> bool:
    """Whether readings of an instrument may hold effects of a kind; of a component error, those of any may."""
    return not kind.instruments or instrument in kind.instruments


def concerns(kind: Kind, effect: Effect, run: ReadRun) -> bool:
    """Whether the readings of a run may hold an effect: one of its instrument, of all runs or of this one."""
    return reads(kind, run.instrument) and (not effect.runs or run.id in effect.runs)


def variables_of(kind: Kind) -> tuple[Variable, ...]:
    """The context variables that the expression of a kind may use."""
    if kind.place != "component":
        return OF_READING_TERMS if kind.place == "reading" else ()
    return tuple(one for one in OF_COMPONENT_TERMS if kind.other_axis or not one.name.endswith("_b"))


def context_of(kind: Kind) -> tuple[str, ...]:
    """Rows of the context that the kernel of a kind takes, in the order of VARIABLES.

    Those that its expression uses; where it uses none, one whose values do not matter: a kernel takes the number of
    points from it. Empty for a kind without an expression. Raises ExpressionError.
    """
    if not kind.expression:
        return ()
    of_none = "q" if kind.place == "component" else "theta" if kind.instruments == ("ballbar",) else "along"
    return used_variables(kind) or (of_none,)


@cache
def used_variables(kind: Kind) -> tuple[str, ...]:
    """The context variables that the expression of a kind uses, in the order of VARIABLES. Raises ExpressionError."""
    used = {name.name for name in names(parse(kind.expression))} if kind.expression else set()
    return tuple(name for name in VARIABLES if name in used)
