"""Expressions as code, NumPy and C: every digit of a constant, powers as products, no call but those that kernels need.

Polynomials in Horner's form, as the derivation leaves them, are found again; variables are named as the symbols are.
"""

import math
from collections.abc import Collection, Mapping
from functools import cache, lru_cache
from typing import Any

import sympy as sp
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import precedence
from sympy.printing.pycode import PythonCodePrinter

from trueaxis.derivation.effect_terms import Absolute, Root, Sign, Step
from trueaxis.derivation.routine import Argument, Routine

_FUNCTIONS = (sp.cos, sp.sin, sp.exp, sp.tanh, Absolute, Root, Sign, Step)
Polynomial = tuple[sp.Symbol, tuple[sp.Expr, ...]]


@lru_cache(maxsize=1 << 14)
def _ordered_terms(expr: sp.Expr) -> tuple[sp.Expr, ...]:
    """In the order of SymPy's printers, which takes as long as all else; NumPy and C print the same sums."""
    return tuple(expr.as_ordered_terms())


@cache
def _method(printer: type, kind: type) -> str:
    """The name of the method of a printer for a kind of expression, as SymPy finds it: by the type or what it is of."""
    return next(name for base in kind.__mro__ if hasattr(printer, name := f"_print_{base.__name__}"))


class _Plain:
    """Before one of SymPy's printers of code: the expressions of routines have nothing that it looks for first."""

    def doprint(self, expr: sp.Expr) -> str:
        """The code of an expression. Raises ValueError for a function that no kernel needs."""
        return self._print(expr)

    def _print_Add(self, expr: sp.Expr) -> str:
        first, *others = map(self._print, _ordered_terms(expr))
        return first + "".join(f" - {text[1:]}" if text[0] == "-" else f" + {text}" for text in others)

    def parenthesize(self, item: sp.Expr, level: float, strict: bool = False) -> str:  # noqa: ARG002  SymPy's signature
        """The code of a factor, in brackets where it would be read otherwise."""
        text = self._print(item)
        return text if item.is_Symbol or precedence(item) > level else f"({text})"

    def _print(self, expr: sp.Expr) -> str:
        if isinstance(expr, sp.Function) and expr.func not in _FUNCTIONS:
            raise ValueError(f"no kernel needs {expr}")
        kinds: tuple[Any, Any] = type(self), type(expr)
        return str(getattr(self, _method(*kinds))(expr))


class PythonPrinter(_Plain, PythonCodePrinter):  # type: ignore[misc]
    """SymPy's own NumPy printer rounds constants to 15 digits and writes powers as calls."""

    def __init__(self, names: Mapping[str, str]) -> None:
        super().__init__({"fully_qualified_modules": False})
        self._names = names

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self._names.get(expr.name, expr.name)

    def _print_Float(self, expr: sp.Float) -> str:
        return repr(float(expr))

    def _print_Rational(self, expr: sp.Rational) -> str:
        return repr(float(expr))

    def _print_cos(self, expr: sp.Expr) -> str:
        return f"np.cos({self._print(expr.args[0])})"

    def _print_sin(self, expr: sp.Expr) -> str:
        return f"np.sin({self._print(expr.args[0])})"

    def _print_Pi(self, expr: sp.Expr) -> str:  # noqa: ARG002  SymPy's signature
        return repr(math.pi)

    def _print_exp(self, expr: sp.Expr) -> str:
        return f"np.exp({self._print(expr.args[0])})"

    def _print_tanh(self, expr: sp.Expr) -> str:
        return f"np.tanh({self._print(expr.args[0])})"

    def _print_Absolute(self, expr: sp.Expr) -> str:
        return f"np.abs({self._print(expr.args[0])})"

    def _print_Sign(self, expr: sp.Expr) -> str:
        return f"np.sign({self._print(expr.args[0])})"

    def _print_Step(self, expr: sp.Expr) -> str:
        return f"np.heaviside({self._print(expr.args[0])}, 1.0)"

    def _print_Root(self, expr: sp.Expr) -> str:
        return f"np.sqrt({self._print(expr.args[0])})"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:  # noqa: ARG002  SymPy's signature
        base = self.parenthesize(expr.base, 99)
        if expr.exp == sp.Rational(1, 2):
            return f"np.sqrt({self._print(expr.base)})"
        if expr.exp.is_Integer and expr.exp > 1:
            return "(" + "*".join([base] * int(expr.exp)) + ")"
        if expr.exp == -1:
            return f"1.0/{base}"
        if expr.exp.is_Integer:
            return f"1.0/{self._print(sp.Pow(expr.base, -expr.exp, evaluate=False))}"
        raise ValueError(f"no kernel needs {expr}")

    def code(self, value: sp.Expr) -> str:
        """The value as a Python expression; constants as doubles, polynomials as calls of `_polynomial`."""
        if value.is_Integer:
            return repr(float(value))
        if polynomial := horner_coefficients(value):
            at, coefficients = polynomial
            return f"_polynomial({', '.join(self.doprint(part) for part in (at, *coefficients))})"
        return str(self.doprint(value))


class CPrinter(_Plain, C99CodePrinter):  # type: ignore[misc]
    """SymPy's own C printer writes x**2 as pow(x, 2), 1/2 as 1.0/2.0 and pi as a macro that ISO C does not have."""

    def __init__(self, names: Mapping[str, str]) -> None:
        super().__init__()
        self._names = names

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self._names.get(expr.name, expr.name)

    def _print_Number(self, expr: sp.Expr) -> str:
        return repr(float(expr) if expr.is_Integer else float(expr.evalf(30)))

    # SymPy finds the method by the type's name.
    _print_Float = _print_Integer = _print_Rational = _print_NumberSymbol = _print_Number  # noqa: N815
    _print_Zero = _print_One = _print_Half = _print_NegativeOne = _print_Pi = _print_Number  # noqa: N815

    def _print_Absolute(self, expr: sp.Expr) -> str:
        return f"fabs({self._print(expr.args[0])})"

    def _print_Root(self, expr: sp.Expr) -> str:
        return f"sqrt({self._print(expr.args[0])})"

    def _print_Sign(self, expr: sp.Expr) -> str:
        return f"sign({self._print(expr.args[0])})"

    def _print_Step(self, expr: sp.Expr) -> str:
        return f"step({self._print(expr.args[0])})"

    def _print_Mul(self, expr: sp.Mul) -> str:
        constants = [factor for factor in expr.args if factor.is_number]
        number = sp.Mul(*constants)
        if number in (1, -1) or constants == list(expr.args):
            return str(super()._print_Mul(expr))
        # One constant instead of several: pi*b/180 is one multiplication.
        rest = sp.Mul(*(factor for factor in expr.args if not factor.is_number))
        return str(super()._print_Mul(sp.Mul(sp.Float(number.evalf(30), 30), rest, evaluate=False)))

    def _print_Pow(self, expr: sp.Pow) -> str:
        base = self._print(expr.base)
        if expr.exp == sp.Rational(1, 2):
            return f"sqrt({base})"
        if expr.exp == sp.Rational(-1, 2):
            return f"(1.0/sqrt({base}))"
        if not expr.exp.is_Integer:
            raise ValueError(f"no kernel needs {expr}")
        factor = base if expr.base.is_Symbol else f"({base})"
        product = "*".join([factor] * abs(int(expr.exp)))
        if expr.exp > 1:
            return f"({product})"
        return f"(1.0/({product}))" if expr.exp < -1 else f"(1.0/{product})"


def horner_coefficients(value: sp.Expr) -> Polynomial | None:
    """(s, (c1, c2, ..)) of s*(c1 + s*(c2 + ..)); None where the value is something else or has one coefficient."""
    if not value.is_Mul or len(value.args) != 2:
        return None
    candidates = [factor for factor in value.args if factor.is_Symbol]
    return next(filter(None, (_nested(at, value) for at in candidates)), None)


def _nested(at: sp.Symbol, value: sp.Expr) -> Polynomial | None:
    coefficients: list[sp.Expr] = []
    while value.has(at):
        inner = value / at
        if not inner.has(at):
            coefficients.append(inner)
            break
        constants, leading = inner.as_independent(at, as_Add=True)
        if not inner.is_Add or leading.is_Add:
            return None
        coefficients.append(constants)
        value = leading
    return (at, tuple(coefficients)) if len(coefficients) > 1 else None


def variable_names(routine: Routine, taken: Collection[str]) -> Mapping[str, str]:
    """Every symbol's variable: its own name, with `_` added where that is an argument's name or one of `taken`."""
    kept = {*taken, *(a.name for a in routine.inputs + routine.outputs)}
    symbols = [row for a in routine.inputs + routine.outputs for row in a.rows]
    symbols += [target.name for stage in (routine.batch, routine.preparation, routine.body) for target, _ in stage]
    names: dict[str, str] = {}
    for symbol in symbols:
        name = symbol
        while name in kept or (name != symbol and name in symbols):
            name += "_"
        names[symbol] = name
    return names


def rows_text(argument: Argument) -> str:
    """The names of an argument's rows in their order, where they are few enough to be read."""
    if len(argument.rows) <= 40:
        return " ".join(argument.rows)
    return f"{argument.rows[0]} {argument.rows[1]} .. {argument.rows[-1]}, last index fastest"
