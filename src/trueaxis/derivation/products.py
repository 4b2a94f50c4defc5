"""Sums of products: polynomials multiplied out, as `sympy.expand` does it, at a small part of what it takes.

A product is the tuple of its factors, sorted; a sum the numbers before its products.
"""

from collections.abc import Iterable

import sympy as sp

from trueaxis.derivation.expressions import put_together

_Sum = dict[tuple[sp.Symbol, ...], sp.Number]


def multiplied_out(value: sp.Expr) -> sp.Expr:
    """The same as a sum of products."""
    if all(factor.is_Atom for term in sp.Add.make_args(value) for factor in sp.Mul.make_args(term)):
        return value
    total = _sum(value)
    return sp.expand(value) if total is None else _expression(total)


def linear_form(value: sp.Expr, names: Iterable[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The factor of each of the symbols, by which the value is linear, in their order; of those that it has."""
    found: dict[sp.Symbol, list[sp.Expr]] = {name: [] for name in names}
    for term in filter(None, sp.Add.make_args(multiplied_out(value))):  # zero has no terms
        factors = sp.Mul.make_args(term)
        (name,) = (factor for factor in factors if factor in found)
        found[name].append(sp.Mul(*(factor for factor in factors if factor is not name)))
    return {name: sp.Add(*terms) for name, terms in found.items() if terms}


def _sum(value: sp.Expr) -> _Sum | None:
    """None of what is no polynomial."""
    if value.is_Symbol:
        return {(value,): sp.S.One}
    if value.is_Number:
        return {(): value} if value else {}
    power = value.is_Pow and value.exp.is_Integer and value.exp.is_positive
    if not (value.is_Add or value.is_Mul or power):
        return None
    parts = [_sum(part) for part in ([value.base] * int(value.exp) if power else value.args)]
    if value.is_Add:
        return None if None in parts else _added(parts)
    result: _Sum = {(): sp.S.One}
    for part in parts:
        if part is None:
            return None
        result = _added(
            {tuple(sorted((*one, *other), key=_name)): a * b for one, a in result.items()} for other, b in part.items()
        )
    return result


def _added(parts: Iterable[_Sum]) -> _Sum:
    result: _Sum = {}
    for part in parts:
        for factors, number in part.items():
            result[factors] = result[factors] + number if factors in result else number
    return {factors: number for factors, number in result.items() if number}


def _name(symbol: sp.Symbol) -> str:
    return symbol.name


def _expression(total: _Sum) -> sp.Expr:
    return put_together(sp.Add, [_product(factors, number) for factors, number in total.items()])


def _product(factors: tuple[sp.Symbol, ...], number: sp.Number) -> sp.Expr:
    if len(set(factors)) < len(factors):
        return sp.Mul(number, *factors)
    return put_together(sp.Mul, list(factors) if number is sp.S.One else [number, *factors])
