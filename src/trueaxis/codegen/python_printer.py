"""Expressions as NumPy code: every digit of a constant, powers as products."""

import math
from collections.abc import Mapping

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter

from trueaxis.codegen.horner import horner_coefficients


class PythonPrinter(PythonCodePrinter):  # type: ignore[misc]
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
