"""Sums and products put together, sorted, renamed and counted as SymPy does it, at a small part of what it takes.

SymPy works out every sum and product that it is given, and sorts it by comparing all pairs of arguments. What a
routine is made of are sums and products of symbols and of unlike parts, in which there is nothing to work out.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import cmp_to_key, lru_cache
from typing import Any

import sympy as sp
from sympy.core.basic import ordering_of_classes

_RANKS = {name: rank for rank, name in enumerate(ordering_of_classes)}
_compared = cmp_to_key(sp.Basic.compare)


def put_together(func: type[sp.Expr], args: Sequence[sp.Expr]) -> sp.Expr:
    """func(*args), where like terms of a sum and like factors of a product stand together already."""
    numbers = [arg for arg in args if arg.is_Number]
    if func not in (sp.Add, sp.Mul) or len(numbers) > 1 or any(isinstance(arg, func) or arg.is_Pow for arg in args):
        return func(*args)
    if func is sp.Mul and numbers and len(args) == 2 and any(arg.is_Add for arg in args):
        return func(*args)  # the number is multiplied in
    others = [arg for arg in args if not arg.is_Number]
    key: Callable[[sp.Expr], Any] = _compared if None in map(_place, others) else _place
    others.sort(key=key)
    return func._from_args(numbers + others, is_commutative=True)


@lru_cache(maxsize=1 << 15)
def _place(value: sp.Expr) -> tuple[Any, ...] | None:
    """A key that sorts as SymPy compares arguments; None of what only that can compare."""
    rank = _RANKS.get(type(value).__name__)
    if value.is_Symbol:
        return rank, 1, value.name
    if value.is_Rational:
        return rank, 2, value.p, value.q
    places = [_place(arg) for arg in value.args]
    return (rank, len(places), *places) if rank and places and None not in places else None


def renamed(value: sp.Expr, names: Mapping[sp.Symbol, sp.Symbol]) -> sp.Expr:
    """The value under other names, each of which stands for one."""
    if not value.args:
        return names.get(value, value)
    args = [renamed(arg, names) for arg in value.args]
    if all(one is other for one, other in zip(args, value.args, strict=True)):
        return value
    return put_together(value.func, args)


def is_negative(value: sp.Expr) -> bool:
    """Whether a number, or the number of a product, is negative."""
    first = value.args[0] if value.is_Mul else value
    return bool(first.is_Number and first.is_negative)


def opposite(value: sp.Expr) -> sp.Expr:
    """-value."""
    if value.is_Add:
        return put_together(sp.Add, [opposite(term) for term in value.args])
    if value.is_Number or (value.is_Mul and value.args[0].is_Number and value.args[0] is not sp.S.NegativeOne):
        return -value
    factors = sp.Mul.make_args(value)
    factors = factors[1:] if factors[0] is sp.S.NegativeOne else (sp.S.NegativeOne, *factors)
    return sp.Mul._from_args(factors, is_commutative=True)


@lru_cache(maxsize=1 << 14)
def simpler_opposite(value: sp.Expr) -> sp.Expr | None:
    """-value, where that has fewer minus signs, or of as many none in front; else None."""
    if value.is_Mul:
        return opposite(value) if is_negative(value) else None
    if not value.is_Add:
        return None
    minus = sum(map(is_negative, value.args))
    if 2 * minus != len(value.args):
        return opposite(value) if 2 * minus > len(value.args) else None
    if _powers(value) is None or value.args[0].is_Number:
        return opposite(value) if value.could_extract_minus_sign() else None
    return opposite(value) if is_negative(ordered_terms(value)[0]) else None


@lru_cache(maxsize=1 << 14)
def ordered_terms(total: sp.Add) -> tuple[sp.Expr, ...]:
    """The terms of a sum in the order of SymPy's printers: by the powers of the symbols, a to z."""
    powers = _powers(total)
    if powers is None or (total.args[0].is_Number and total.args[0].is_positive and len(total.args) == 2):
        return tuple(total.as_ordered_terms())  # 1 - 2*x begins with the 1
    names = sorted({name for power in powers for name in power})
    order = sorted(range(len(powers)), key=lambda k: [-powers[k].get(name, 0) for name in names])
    return tuple(total.args[k] for k in order)


def _powers(total: sp.Add) -> list[dict[str, int]] | None:
    """The powers of the symbols in each term; None where a term has other factors."""
    found: list[dict[str, int]] = []
    for term in total.args:
        factors = [factor.as_base_exp() for factor in sp.Mul.make_args(term) if not factor.is_Number]
        if not all(base.is_Symbol and exponent.is_Integer for base, exponent in factors):
            return None
        found.append({base.name: int(exponent) for base, exponent in factors})
    return found


@lru_cache(maxsize=1 << 14)
def ordered_factors(product: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of a product in the order of SymPy's printers."""
    numbers = [factor for factor in sp.Mul.make_args(product) if factor.is_Number]
    others = [factor for factor in sp.Mul.make_args(product) if not factor.is_Number]
    others.sort(key=(lambda one: one.name) if all(one.is_Symbol for one in others) else sp.default_sort_key)
    return (*numbers, *others)


@lru_cache(maxsize=1 << 14)
def called(value: sp.Expr) -> frozenset[type[sp.Expr]]:
    """The functions that an expression calls."""
    own = [value.func] if isinstance(value, sp.Function) else []
    return frozenset(own).union(*(called(arg) for arg in value.args if arg.args))


def operations(value: sp.Expr) -> int:
    """Arithmetic operations and calls of functions, as `sympy.count_ops` counts them."""
    if not value.args:
        return int(value.is_Rational and (value.is_negative + (value.q != 1)))
    if value.is_Add:
        negative = [is_negative(term) for term in value.args]
        terms = [opposite(term) if minus else term for term, minus in zip(value.args, negative, strict=True)]
        return len(terms) - 1 + all(negative) + sum(map(operations, terms))
    if value.is_Mul and all(factor.is_Symbol or factor.is_Add or factor.is_Integer for factor in value.args):
        first = value.args[0]
        count = len(value.args) - 1 - (first is sp.S.NegativeOne) + is_negative(value)
        return count + sum(map(operations, value.args[1:] if first.is_Number else value.args))
    return int(sp.count_ops(value))
