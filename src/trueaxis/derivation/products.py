"""Sums of products of symbols: polynomials, multiplied out at a small part of what `sympy.expand` takes."""

from collections.abc import Iterable, Mapping
from functools import lru_cache

import sympy as sp

from trueaxis.derivation.expressions import put_together

Factors = tuple[sp.Symbol, ...]  # a to z


class Sum:
    """A polynomial as it is multiplied out: the number before each product of symbols, none of them 0."""

    __slots__ = ("numbers",)

    def __init__(self, numbers: Mapping[Factors, sp.Number]) -> None:
        self.numbers = numbers

    def __add__(self, other: "Sum") -> "Sum":
        result = dict(self.numbers)
        for factors, number in other.numbers.items():
            total = result.pop(factors, sp.S.Zero) + number
            if total:
                result[factors] = total
        return Sum(result)

    def __neg__(self) -> "Sum":
        return Sum({factors: -number for factors, number in self.numbers.items()})

    def __sub__(self, other: "Sum") -> "Sum":
        return self + -other

    def __mul__(self, other: "Sum") -> "Sum":
        result = NOTHING
        for more, number in other.numbers.items():
            times = {_sorted(own + more): one * number for own, one in self.numbers.items()}
            result = result + Sum(times)
        return result

    def expression(self) -> sp.Expr:
        """In SymPy."""
        return put_together(sp.Add, [_product(*item) for item in self.numbers.items()])


NOTHING = Sum({})
ONE = Sum({(): sp.S.One})


def sum_of(value: sp.Expr) -> Sum | None:
    """A polynomial as a sum; None of what is none."""
    if value.is_Symbol:
        return Sum({(value,): sp.S.One})
    if value.is_Number:
        return Sum({(): value}) if value else NOTHING
    if value.is_Mul and all(factor.is_Symbol for factor in value.args[1:]):
        number, rest = value.as_coeff_Mul()
        if all(factor.is_Symbol for factor in sp.Mul.make_args(rest)):
            return Sum({_sorted(sp.Mul.make_args(rest)): number})
    power = value.is_Pow and value.exp.is_Integer and value.exp.is_positive
    if not (value.is_Add or value.is_Mul or power):
        return None
    total = NOTHING if value.is_Add else ONE
    for arg in [value.base] * int(value.exp) if power else value.args:
        part = sum_of(arg)
        if part is None:
            return None
        total = total + part if value.is_Add else total * part
    return total


def polynomial(value: sp.Expr) -> Sum:
    """A polynomial as a sum. Raises ValueError for what is none."""
    found = sum_of(value)
    if found is None:
        raise ValueError(f"{value} is no polynomial")
    return found


def multiplied_out(value: sp.Expr) -> sp.Expr:
    """The same as a sum of products."""
    if all(factor.is_Atom for term in sp.Add.make_args(value) for factor in sp.Mul.make_args(term)):
        return value
    total = sum_of(value)
    return sp.expand(value) if total is None else total.expression()


def linear_form(value: sp.Expr, names: Iterable[sp.Symbol]) -> dict[sp.Symbol, sp.Expr]:
    """The factor of each of the symbols, by which the value is linear, in their order; of those that it has."""
    found: dict[sp.Symbol, list[sp.Expr]] = {name: [] for name in names}
    for term in filter(None, sp.Add.make_args(multiplied_out(value))):  # zero has no terms
        factors = sp.Mul.make_args(term)
        (name,) = (factor for factor in factors if factor in found)
        found[name].append(sp.Mul(*(factor for factor in factors if factor is not name)))
    return {name: sp.Add(*terms) for name, terms in found.items() if terms}


@lru_cache(maxsize=1 << 14)
def _sorted(factors: Factors) -> Factors:
    return tuple(sorted(factors, key=lambda symbol: str(symbol.name)))


@lru_cache(maxsize=1 << 14)
def _product(factors: Factors, number: sp.Number) -> sp.Expr:
    if len(set(factors)) < len(factors):
        return sp.Mul(number, *factors)
    return put_together(sp.Mul, factors if number is sp.S.One else (number, *factors))
