"""Expressions as NumPy code: every digit of a constant, powers as products."""

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter


class PythonPrinter(PythonCodePrinter):  # type: ignore[misc]
    """SymPy's own NumPy printer rounds constants to 15 digits and writes powers as calls."""

    def _print_Float(self, expr: sp.Float) -> str:
        return repr(float(expr))

    def _print_Rational(self, expr: sp.Rational) -> str:
        return repr(float(expr))

    def _print_cos(self, expr: sp.Expr) -> str:
        return f"np.cos({self._print(expr.args[0])})"

    def _print_sin(self, expr: sp.Expr) -> str:
        return f"np.sin({self._print(expr.args[0])})"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:  # noqa: ARG002  SymPy's signature
        base = self.parenthesize(expr.base, 99)
        if expr.exp == sp.Rational(1, 2):
            return f"np.sqrt({self._print(expr.base)})"
        if expr.exp.is_Integer and 1 < expr.exp <= 4:
            return "(" + "*".join([base] * int(expr.exp)) + ")"
        if expr.exp == -1:
            return f"1.0/{base}"
        raise ValueError(f"no kernel needs {expr}")


_PRINTER = PythonPrinter({"fully_qualified_modules": False})


def python_code(value: sp.Expr) -> str:
    """The value as a Python expression; constants as doubles."""
    if value.is_Integer:
        return repr(float(value))
    return str(_PRINTER.doprint(value))
