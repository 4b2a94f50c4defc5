"""Random expressions, drawn as text beside their value in another program's arithmetic."""

from dataclasses import dataclass

import sympy as sp
from hypothesis import strategies as st

NAMES = ("s", "q", "direction", "T", "k", "p")
SYMBOLS = {name: sp.Symbol(name, real=True) for name in NAMES}
FUNCTIONS = {
    "sin": sp.sin,
    "cos": sp.cos,
    "exp": sp.exp,
    "tanh": sp.tanh,
    "abs": sp.Abs,
    "sign": sp.sign,
    "step": lambda x: sp.Heaviside(x, 1),
    "sqrt": sp.sqrt,
}


@dataclass(frozen=True)
class Drawn:
    """A text, fully bracketed, and what it means, built beside it and never read from it."""

    text: str
    value: sp.Expr


def _binary(operator: str, left: Drawn, right: Drawn) -> Drawn:
    a, b = left.value, right.value
    value = {"+": sp.Add(a, b), "-": sp.Add(a, -b), "*": sp.Mul(a, b)}[operator]
    return Drawn(f"({left.text} {operator} {right.text})", value)


def _quotient(left: Drawn, right: Drawn) -> Drawn:
    # A divisor of 1 and more: where a quotient has no value is not the question here.
    return Drawn(f"({left.text}/(1 + ({right.text})^2))", left.value / (1 + right.value**2))


def _called(function: str, inner: Drawn) -> Drawn:
    if function == "exp":  # of what does not grow
        return Drawn(f"exp(-abs({inner.text}))", sp.exp(-sp.Abs(inner.value)))
    if function == "sqrt":
        return Drawn(f"sqrt(2 + sin({inner.text}))", sp.sqrt(2 + sp.sin(inner.value)))
    return Drawn(f"{function}({inner.text})", FUNCTIONS[function](inner.value))


def expressions() -> st.SearchStrategy[Drawn]:
    leaves = st.one_of(
        st.sampled_from(NAMES).map(lambda name: Drawn(name, SYMBOLS[name])),
        st.just(Drawn("pi", sp.pi)),
        st.integers(0, 20).map(lambda n: Drawn(str(n), sp.Integer(n))),
        st.integers(1, 999).map(lambda n: Drawn(f"{n / 1000!r}", sp.Rational(n, 1000))),
    )
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            st.builds(_binary, st.sampled_from("+-*"), inner, inner),
            st.builds(_quotient, inner, inner),
            st.builds(lambda one: Drawn(f"(-{one.text})", -one.value), inner),
            st.builds(lambda one, n: Drawn(f"({one.text})^{n}", one.value**n), inner, st.integers(1, 3)),
            st.builds(_called, st.sampled_from(sorted(FUNCTIONS)), inner),
        ),
        max_leaves=8,
    )
