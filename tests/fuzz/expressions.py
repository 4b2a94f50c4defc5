"""Random texts in the language of expressions, and their values in many digits by Python's grammar and mpmath."""

import ast
import operator
import re
from collections.abc import Callable, Mapping
from random import Random
from typing import Any

import mpmath

NAMES = ("s", "q", "t", "T", "v", "d", "d_time", "d_path", "direction", "a", "p")
FUNCTIONS: Mapping[str, Callable[[Any], Any]] = {
    "sin": mpmath.sin,
    "cos": mpmath.cos,
    "exp": mpmath.exp,
    "sqrt": mpmath.sqrt,
    "abs": abs,
    # What is too small for a double is 0 to the program: both jump there.
    "sign": lambda x: mpmath.sign(float(x)),
    "step": lambda x: mpmath.mpf(float(x) >= 0),
    "tanh": mpmath.tanh,
}
OPERATORS: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
_CONSTANTS = ("0", "1", "2", "1/3", "0.1", "1e-3", "pi", "7", "1e9", "1e-300", "1e300", "1000", "0.0", "9", "1e-320")


def expression(draw: Random) -> bytes:
    """Proportional to `a`, mostly: a term with `a` as a factor, so that it is not refused for that alone."""
    term = f"a*({_sum(draw, 3)})" if draw.random() < 0.5 else f"a*p*{_factor(draw, 3)}"
    return (term if draw.random() < 0.9 else _sum(draw, 4)).encode()


def _sum(draw: Random, depth: int) -> str:
    parts = [_product(draw, depth) for _ in range(draw.choice((1, 1, 2, 3)))]
    return "".join(f"{draw.choice(('+', ' - ', '-'))}{part}" if index else part for index, part in enumerate(parts))


def _product(draw: Random, depth: int) -> str:
    parts = [_factor(draw, depth) for _ in range(draw.choice((1, 1, 2, 3)))]
    return "".join(f"{draw.choice('**/')}{part}" if index else part for index, part in enumerate(parts))


def _factor(draw: Random, depth: int) -> str:
    kind = draw.random()
    if depth == 0 or kind < 0.4:
        return draw.choice((draw.choice(NAMES[:-2]), draw.choice((*NAMES[:-2], "p")), draw.choice(_CONSTANTS)))
    if kind < 0.6:
        inner = _sum(draw, depth - 1)
        return f"{draw.choice(list(FUNCTIONS))}({inner})"
    if kind < 0.7:  # what folds to a constant
        name = draw.choice(NAMES[:-2])
        return draw.choice((f"(0*{name})", f"({name}-{name})", f"({name} - {name} + 2)", f"({name}/(1+{name}-{name}))"))
    if kind < 0.85:
        return f"({_sum(draw, depth - 1)})^{draw.choice('1223459')}"
    return f"({_sum(draw, depth - 1)})"


def value(text: str, values: Mapping[str, float], draw: Random | None = None) -> Any:
    """The value in 60 digits, an mpf, or None where there is none.

    draw: where it is given, every number and every name is off by up to 1e-12 of itself.
    """
    with mpmath.workdps(60):
        try:
            # Python takes no zeros before a whole number, which mean nothing here
            plain = re.sub(r"(?<![\w.])0+(?=\d)", "", text.replace("^", "**"))
            found = _value(ast.parse(plain, mode="eval").body, values, draw)
        except (ArithmeticError, ValueError):
            return None
        return None if isinstance(found, mpmath.mpc) or not mpmath.isfinite(found) else found


def _value(node: ast.expr, values: Mapping[str, float], draw: Random | None) -> Any:
    def off(x: Any) -> Any:
        return x if draw is None else x * (1 + mpmath.mpf(draw.uniform(-1e-12, 1e-12)))

    match node:
        case ast.Constant(value=number):
            return off(mpmath.mpf(number))
        case ast.Name(id=name):
            return off(mpmath.pi if name == "pi" else mpmath.mpf(values[name]))
        case ast.UnaryOp(operand=operand):
            return -_value(operand, values, draw)
        case ast.Call(func=ast.Name(id=function), args=[argument]):
            return FUNCTIONS[function](_value(argument, values, draw))
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=exponent)):
            return _value(left, values, draw) ** int(str(exponent))
        case ast.BinOp(left=left, op=operation, right=right):
            a, b = _value(left, values, draw), _value(right, values, draw)
            return OPERATORS[type(operation)](a, b)
    raise ValueError(ast.dump(node))
