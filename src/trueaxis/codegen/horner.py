"""Polynomials in Horner's form, as the derivation leaves them, found again in an expression."""

import sympy as sp

Polynomial = tuple[sp.Symbol, tuple[sp.Expr, ...]]


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
