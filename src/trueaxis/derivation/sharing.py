"""Common subexpressions as `sympy.cse` shares them, under the same names, at a small part of what it takes.

SymPy compares, hashes and sorts an expression anew wherever it stands, and works out every sum and product of which a
name becomes a part. Here each part of the expressions is one object, which is told apart by being itself, and what a
name becomes a part of is put together as it is, since nothing cancels in it.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cmp_to_key, lru_cache
from itertools import pairwise
from typing import Any, TypeAlias

import sympy as sp
from sympy.core.basic import ordering_of_classes
from sympy.simplify.cse_main import Unevaluated, match_common_args

Assignment = tuple[sp.Symbol, sp.Expr]
_RANKS = {name: rank for rank, name in enumerate(ordering_of_classes)}
_compared = cmp_to_key(sp.Basic.compare)


class _Tree:
    """A part of the expressions, the same object wherever it stands."""

    __slots__ = ("args", "func", "size", "value")

    def __init__(self, value: sp.Expr, args: tuple["_Tree", ...]) -> None:
        self.value, self.func, self.args = value, value.func, args
        self.size: float = (
            0.5 if value.is_Float else 1 + sum([arg.size for arg in args])
        )  # as SymPy counts, which sorts by it


_Form: TypeAlias = Any  # a _Tree, or SymPy's Unevaluated: what a part is made of, by other arguments than it has
_Forms = dict[_Form, _Form]


def shared(values: Sequence[sp.Expr], names: Iterator[sp.Symbol]) -> tuple[list[Assignment], list[sp.Expr]]:
    """Assignments of what the values share, each behind those that it needs, and what is left of the values.

    names: for the assignments; the values have none of them.
    """
    trees: dict[sp.Expr, _Tree] = {}

    def tree(value: sp.Expr) -> _Tree:
        found = trees.get(value)
        if found is None:
            found = trees[value] = _Tree(value, tuple([tree(arg) for arg in value.args]))
        return found

    roots = [tree(value) for value in values]
    forms = _forms(roots, tree)
    repeated = _repeated(roots, forms)
    done: dict[_Form, sp.Symbol] = {}
    assignments: list[Assignment] = []

    def made(part: _Form) -> sp.Expr:
        if not part.args:
            return part.value
        if part in done:
            return done[part]
        form = forms.get(part, part)
        args = [made(arg) for arg in _in_order(form)]
        value = _put_together(form, args)
        if part not in repeated:
            return value
        done[part] = name = next(names)
        assignments.append((name, value))
        return name

    left = [made(root) for root in roots]
    return assignments, left


def _forms(roots: Iterable[_Tree], tree: Callable[[sp.Expr], _Tree]) -> _Forms:
    """Parts that are the opposite of a simpler one, divisions, and parts of sums and products that others have, too."""
    forms: _Forms = {}
    sums: dict[_Tree, None] = {}
    products: dict[_Tree, None] = {}
    minus_one = tree(sp.S.NegativeOne)
    seen: set[_Tree] = set()

    def look(part: _Tree) -> None:
        if not part.args or part in seen:
            return
        seen.add(part)
        for arg in part.args:
            look(arg)
        opposite = _opposite(part.value)
        if opposite is not None and opposite.args:
            forms[part] = Unevaluated(sp.Mul, (minus_one, tree(opposite)))
            part = tree(opposite)
            seen.add(part)
        if part.func is sp.Mul:
            products[part] = None
        elif part.func is sp.Add:
            sums[part] = None
        elif part.func is sp.Pow and part.value.exp.could_extract_minus_sign():
            forms[part] = Unevaluated(sp.Pow, (tree(1 / part.value), minus_one))

    for root in roots:
        look(root)
    match_common_args(sp.Add, sums, forms)
    match_common_args(sp.Mul, products, forms)
    return forms


@lru_cache(maxsize=1 << 14)
def _opposite(value: sp.Expr) -> sp.Expr | None:
    """The opposite of a sum or product, where that has fewer minus signs; else None."""
    if value.is_Mul:
        return -value if value.args[0].is_Number and value.args[0].is_negative else None
    if not value.is_Add or not value.could_extract_minus_sign():
        return None
    return sp.Add(*(-term for term in value.args))


def _repeated(roots: Iterable[_Tree], forms: _Forms) -> set[_Form]:
    """The parts that stand in more than one place."""
    seen: set[_Form] = set()
    repeated: set[_Form] = set()

    def look(part: _Form) -> None:
        if not part.args:
            return
        if part in seen:
            repeated.add(part)
            return
        seen.add(part)
        form: _Form = forms.get(part, part)
        for arg in form.args:
            look(arg)

    for root in roots:
        look(root)
    return repeated


def _in_order(form: _Form) -> Sequence[_Form]:
    """The arguments of a sum or product in the order in which they get their names: smaller ones first."""
    if isinstance(form, Unevaluated) or form.func not in (sp.Add, sp.Mul):
        return tuple(form.args)
    args = sorted(form.args, key=lambda arg: arg.size)
    if any(one.size == other.size and one.args for one, other in pairwise(args)):
        args.sort(key=lambda arg: (arg.size, sp.default_sort_key(arg.value)))
    return args


def _put_together(form: _Form, args: list[sp.Expr]) -> sp.Expr:
    if isinstance(form, _Tree) and all(one is other.value for one, other in zip(args, _in_order(form), strict=True)):
        return form.value
    return put_together(form.func, args)


def put_together(func: type[sp.Expr], args: list[sp.Expr]) -> sp.Expr:
    """func(*args); nothing is worked out of a sum or product of symbols and unlike parts."""
    if func not in (sp.Add, sp.Mul) or any(isinstance(arg, func) or arg.is_Pow for arg in args):
        return func(*args)
    if func is sp.Mul and len(args) == 2 and any(arg.is_Add for arg in args) and any(arg.is_Number for arg in args):
        return func(*args)  # the number is multiplied in
    numbers = [arg for arg in args if arg.is_Number]
    if len(numbers) > 1:
        return func(*args)
    others = [arg for arg in args if not arg.is_Number]
    others.sort(key=_compared if None in map(_place, others) else _place)
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
    return (
        value
        if all(one is other for one, other in zip(args, value.args, strict=True))
        else put_together(value.func, args)
    )


def operations(value: sp.Expr) -> int:
    """Arithmetic operations and calls of functions, as `sympy.count_ops` counts them."""
    if not value.args:
        return int(value.is_Rational and (value.is_negative + (value.q != 1)))
    if value.is_Add:
        negative = [is_negative(term) for term in value.args]
        terms = [-term if minus else term for term, minus in zip(value.args, negative, strict=True)]
        return len(terms) - 1 + all(negative) + sum(map(operations, terms))
    if value.is_Mul and all(factor.is_Symbol or factor.is_Add or factor.is_Integer for factor in value.args):
        first = value.args[0]
        count = len(value.args) - 1 - (first is sp.S.NegativeOne) + is_negative(value)
        return count + sum(map(operations, value.args if not first.is_Number else value.args[1:]))
    return int(sp.count_ops(value))


def is_negative(value: sp.Expr) -> bool:
    """Whether a number, or the number of a product, is negative."""
    first = value.args[0] if value.is_Mul else value
    return bool(first.is_Number and first.is_negative)
