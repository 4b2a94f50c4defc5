"""Expressions as C code: every digit of a constant, powers as products, no call but those that kernels need."""

from collections.abc import Mapping

import sympy as sp
from sympy.printing.c import C99CodePrinter

from trueaxis.derivation.functions import Absolute, Root, Sign, Step

_FUNCTIONS = (sp.cos, sp.sin, sp.exp, sp.tanh, Absolute, Root, Sign, Step)


class CPrinter(C99CodePrinter):  # type: ignore[misc]
    """SymPy's own C printer writes x**2 as pow(x, 2), 1/2 as 1.0/2.0 and pi as a macro that ISO C does not have."""

    def __init__(self, names: Mapping[str, str]) -> None:
        super().__init__()
        self._names = names

    def doprint(self, expr: sp.Expr) -> str:
        """The C expression. Raises ValueError for a function that no kernel needs."""
        for function in expr.atoms(sp.Function):
            if function.func not in _FUNCTIONS:
                raise ValueError(f"no kernel needs {function}")
        return str(super().doprint(expr))

    def _print_Symbol(self, expr: sp.Symbol) -> str:
        return self._names.get(expr.name, expr.name)

    def _print_Number(self, expr: sp.Expr) -> str:
        return repr(float(expr.evalf(30)))

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
