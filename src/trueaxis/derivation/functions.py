"""Functions of a real argument that stay as they were written, with the derivatives that a fit needs.

SymPy's own turn into other functions: the derivative of its sign is a delta function, that of its absolute value is
spelt out for complex arguments, and sqrt(x**2*y) becomes Abs(x)*sqrt(y).
"""

from typing import Any

import sympy as sp


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


def _raised(text: str, exponent: str) -> str:
    return f"{{{text}}}^{{{exponent}}}" if exponent else text
