"""Whether an expression is proportional to its linear parameters, told from its syntax tree."""

from collections.abc import Collection

from trueaxis.effects.expression import Binary, Call, Expression, Name, Negative, Number, Pi, Power


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
            degree = _combined(operator, _degree(left, parameters), _degree(right, parameters))
    return degree


def _combined(operator: str, left: int | None, right: int | None) -> int | None:
    if left is None or right is None:
        return None
    match operator:
        case "*":
            return left + right if left + right < 2 else None
        case "/":
            return left if right == 0 else None
    return left if left == right else None
