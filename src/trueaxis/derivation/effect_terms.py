"""The terms of effects: their expressions in SymPy, and the routines that compute them with their derivatives.

Their functions of a real argument stay as they were written, with the derivatives that a fit needs.

SymPy's own turn into other functions: the derivative of its sign is a delta function, that of its absolute value is
spelt out for complex arguments, and sqrt(x**2*y) becomes Abs(x)*sqrt(y).
"""

from typing import Any

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.routine import Argument, Routine, build
from trueaxis.effects.evaluate import value_of
from trueaxis.effects.expression import Binary, Call, Expression, Function, Name, Negative, Number, Pi, Power, parse
from trueaxis.effects.kind import Kind
from trueaxis.effects.library import BY_NAME
from trueaxis.effects.placement import VARIABLES, context_of
from trueaxis.machine.machine import Machine

_DIGITS = 17  # of a constant that is not kept as a fraction: those of a double


class Absolute(sp.Function):  # type: ignore[misc]
    """The absolute value; its derivative is the sign."""

    is_real = True

    def fdiff(self, argindex: int = 1) -> sp.Expr:  # noqa: ARG002  SymPy's signature
        """Derivative by the argument."""
        return Sign(self.args[0])

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raised(rf"\left|{printer._print(self.args[0])}\right|", exp)


class Sign(sp.Function):  # type: ignore[misc]
    """-1, 0 or 1; its derivative is taken as 0 everywhere."""

    is_real = True

    def fdiff(self, argindex: int = 1) -> sp.Expr:  # noqa: ARG002
        """Derivative by the argument."""
        return sp.S.Zero

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raised(rf"\mathrm{{sgn}}\left({printer._print(self.args[0])}\right)", exp)


class Step(sp.Function):  # type: ignore[misc]
    """1 from 0 upwards, 0 below; its derivative is taken as 0 everywhere."""

    is_real = True

    def fdiff(self, argindex: int = 1) -> sp.Expr:  # noqa: ARG002
        """Derivative by the argument."""
        return sp.S.Zero

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raised(rf"H\left({printer._print(self.args[0])}\right)", exp)


class Root(sp.Function):  # type: ignore[misc]
    """The square root."""

    is_real = True

    def fdiff(self, argindex: int = 1) -> sp.Expr:  # noqa: ARG002
        """Derivative by the argument."""
        return 1 / (2 * self)

    def _latex(self, printer: Any, exp: str = "") -> str:
        return _raised(rf"\sqrt{{{printer._print(self.args[0])}}}", exp)


_FUNCTIONS = {
    "sin": sp.sin,
    "cos": sp.cos,
    "exp": sp.exp,
    "tanh": sp.tanh,
    "sqrt": Root,
    "abs": Absolute,
    "sign": Sign,
    "step": Step,
}


def term(kind: Kind) -> sp.Expr:
    """The expression of a kind in SymPy. Raises ExpressionError."""
    return symbolic(parse(kind.expression))


def symbolic(expression: Expression) -> sp.Expr:
    """An expression in SymPy, its names as real symbols; whole numbers and their quotients stay exact.

    Powers and functions of numbers alone are worked out in floating point: exactly, they may have any number of digits.
    """
    match expression:
        case Number(value=value):
            result = sp.Integer(int(value)) if value.is_integer() and value < 1e15 else sp.Float(value, _DIGITS)
        case Pi():
            result = sp.pi
        case Name(name=name):
            result = symbols.named(name)
        case Negative(operand=operand):
            result = -symbolic(operand)
        case Power(base=inner, exponent=exponent):
            base = symbolic(inner)
            result = (base.evalf(_DIGITS) if base.is_number else base) ** exponent
        case Call(function=function, argument=inner):
            result = _called(function, symbolic(inner))
        case Binary(operator=operator, left=left, right=right):
            result = _combined(operator, symbolic(left), symbolic(right))
    return result


def _called(function: Function, argument: sp.Expr) -> sp.Expr:
    """A function of an argument; its value where the argument is a number, or has become one: 0*s, s - s + 2."""
    if not argument.is_number:
        return _FUNCTIONS[function](argument)
    try:
        return sp.Float(value_of(function, float(argument)), _DIGITS)
    except (ArithmeticError, ValueError, TypeError):  # TypeError: SymPy's infinity of no sign is no float
        return sp.nan


def _combined(operator: str, left: sp.Expr, right: sp.Expr) -> sp.Expr:
    match operator:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
    return left / right


def effect_name(kind: Kind) -> str:
    """`effect_backlash`."""
    return f"effect_{kind.name}"


def effect_routines(machine: Machine) -> tuple[Routine, ...]:
    """A routine for every kind with an expression that the spec has an effect of or defines itself.

    Those of the rest of the library are `library_routines`: no machine needs them in its own kernels.
    """
    return tuple(effect_routine(kind) for kind in emitted_kinds(machine).values() if kind.expression)


def emitted_kinds(machine: Machine) -> dict[str, Kind]:
    """The kinds of the spec's effects and those that it defines, in the library's order."""
    named = {effect.kind for effect in machine.effects} | {kind.name for kind in machine.effect_kinds}
    return {name: kind for name, kind in machine.kinds.items() if name in named}


def library_routines() -> tuple[Routine, ...]:
    """A routine for every kind of the library that has an expression."""
    return tuple(effect_routine(kind) for kind in BY_NAME.values() if kind.expression)


def effect_routine(kind: Kind) -> Routine:
    """The routine of a kind with an expression: the term and its derivatives by the parameters."""
    value = term(kind)
    context, parameters = context_of(kind), tuple(parameter.name for parameter in kind.parameters)
    rows = ("term", *(f"term_by_{name}" for name in parameters))
    values = (value, *(value.diff(symbols.named(name)) for name in parameters))
    unit = "u" if kind.place == "component" else "mm"
    legend = " (u: unit of the component, axis: of its axis)" if kind.place == "component" else ""
    inputs = (
        Argument(
            name="context",
            rows=context,
            shape=(len(context),),
            per_point=True,
            unit=", ".join(VARIABLES[name].unit for name in context),
            description="; ".join(f"{name}: {VARIABLES[name].meaning}" for name in context) + legend,
        ),
        Argument(
            name="parameters",
            rows=parameters,
            shape=(len(parameters),),
            per_point=False,
            unit=", ".join(parameter.unit for parameter in kind.parameters),
            description="; ".join(f"{parameter.name}: {parameter.meaning}" for parameter in kind.parameters) + legend,
        ),
    )
    output = Argument(
        name="term",
        rows=rows,
        shape=(len(rows),),
        per_point=True,
        unit=unit,
        description=f"the term in {unit}, then its derivative by {', '.join(parameters)}",
    )
    return build(
        effect_name(kind),
        f"Term of the effect {kind.name}: {kind.sentence}.",
        f"{kind.name} = {kind.expression}",
        inputs,
        (output,),
        dict(zip(rows, values, strict=True)),
    )


def _raised(text: str, exponent: str) -> str:
    return f"{{{text}}}^{{{exponent}}}" if exponent else text
