"""The value of an expression at one point, in plain numbers."""

import math
from collections.abc import Mapping

from trueaxis.effects.expression import Binary, Call, Expression, Function, Name, Negative, Number, Pi, Power


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
