"""The value of an expression at one point, in plain numbers, and what is asked of it wherever it will be evaluated.

Whether it has a value is tried out at many points; whether it is proportional to its linear parameters is told from its
syntax tree.
"""

import math
import random
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from trueaxis.effects.expression import Binary, Call, Expression, Function, Name, Negative, Number, Pi, Power, names
from trueaxis.effects.kind import Parameter
from trueaxis.effects.placement import FARTHEST

TRIES = 1000

# Values that matter of every context variable but the position: both ends, zero, something between.
_CONTEXT: Mapping[str, Sequence[float]] = {
    "s": (0.0, 0.3, 1.0),
    "direction": (-1.0, 0.0, 1.0),
    "v": (-200.0, 0.0, 200.0),
    "d": (0.0, 20.0, FARTHEST),
    "d_time": (0.0, 2.0, FARTHEST),
    "d_path": (0.0, 20.0, FARTHEST),
    "t": (0.0, 60.0, 1e5),
    "T": (-10.0, 0.0, 10.0),
}


def evaluate(expression: Expression, values: Mapping[str, float]) -> float:
    """The value where every name has the value given; NaN where there is none (1/0, sqrt(-1), beyond doubles).

    Raises KeyError for a name without a value.
    """
    try:
        return _value(expression, values)
    except (ArithmeticError, ValueError):
        return math.nan


def _value(expression: Expression, values: Mapping[str, float]) -> float:
    match expression:
        case Number(value=value):
            result = value
        case Pi():
            result = math.pi
        case Name(name=name):
            result = values[name]
        case Negative(operand=operand):
            result = -_value(operand, values)
        case Power(base=base, exponent=exponent):
            result = float(_value(base, values) ** exponent)
        case Call(function=function, argument=argument):
            result = value_of(function, _value(argument, values))
        case Binary(operator=operator, left=left, right=right):
            result = _combined(operator, _value(left, values), _value(right, values))
    return result


def _combined(operator: str, left: float, right: float) -> float:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
    return left / right


def value_of(function: Function, x: float) -> float:
    """The value of a function. Raises ArithmeticError or ValueError where it has none."""
    match function:
        case "abs":
            return abs(x)
        case "sign":
            return math.copysign(1.0, x) if x else x
        case "step":
            return float(x >= 0)
        case _:
            return float(getattr(math, function)(x))


def undefined_at(
    expression: Expression, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]
) -> dict[str, float] | None:
    """Values of the names of an expression at which it has no finite value; None where none were met."""
    for values in samples(expression, positions, parameters):
        if not math.isfinite(evaluate(expression, values)):
            return values
    return None


def samples(
    expression: Expression, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]
) -> Iterator[dict[str, float]]:
    """TRIES values of the names of an expression, drawn at random and always the same.

    positions: of the axes, mm or deg; parameters: values of each.
    """
    choices = {name.name: _choices(name.name, positions, parameters) for name in names(expression)}
    draw = random.Random(0)
    for _ in range(TRIES):
        yield {name: draw.choice(among) for name, among in choices.items()}


def sampled_positions(travels: Iterable[tuple[float, float]]) -> list[float]:
    """Both ends of each travel and a point between; 0 and 1 where there is none."""
    return [position for low, high in travels for position in (low, 0.7 * low + 0.3 * high, high)] or [0.0, 1.0]


def sampled_parameters(parameters: Iterable[Parameter]) -> dict[str, Sequence[float]]:
    """The grid of each parameter, or a value of either sign."""
    return {one.name: one.values or (-1.0, 1.0) for one in parameters}


def _choices(name: str, positions: Sequence[float], parameters: Mapping[str, Sequence[float]]) -> Sequence[float]:
    if name in parameters:
        return parameters[name]
    variable = name.removesuffix("_b")
    return positions if variable == "q" else _CONTEXT[variable]


def is_linear(expression: Expression, parameters: Collection[str]) -> bool:
    """Whether it is, as it is written, a sum of terms each proportional to one of the parameters.

    Goes by the form: (a*s)^2/(a*s) is none, although its value is.
    """
    return _degree(expression, parameters) == 1


def _degree(expression: Expression, parameters: Collection[str]) -> int | None:
    """0: without the parameters; 1: a linear form in them; None: anything else."""
    degree: int | None = None
    match expression:
        case Number() | Pi():
            degree = 0
        case Name(name=name):
            degree = int(name in parameters)
        case Negative(operand=inner):
            degree = _degree(inner, parameters)
        case Call(argument=inner) | Power(base=inner):
            degree = 0 if _degree(inner, parameters) == 0 else None
        case Binary(operator=operator, left=left, right=right):
            degree = _combined_degree(operator, _degree(left, parameters), _degree(right, parameters))
    return degree


def _combined_degree(operator: str, left: int | None, right: int | None) -> int | None:
    if left is None or right is None:
        return None
    match operator:
        case "*":
            return left + right if left + right < 2 else None
        case "/":
            return left if right == 0 else None
    return left if left == right else None
