"""Common subexpressions as `sympy.cse` shares them, under the same names, at a small part of what it takes.

SymPy compares, hashes and sorts an expression anew wherever it stands. Here each part of the expressions is one object,
which is told apart by being itself.
"""

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import pairwise

import sympy as sp

from trueaxis.derivation.expressions import is_negative, put_together, simpler_opposite

Assignment = tuple[sp.Symbol, sp.Expr]


class _Part:
    """A part of the expressions, the same object wherever it stands; value: None of what is but a form of another."""

    __slots__ = ("args", "func", "size", "value")

    def __init__(self, func: type[sp.Expr], args: Sequence["_Part"], value: sp.Expr | None = None) -> None:
        self.func, self.args, self.value = func, args, value
        # as SymPy counts, which sorts by it
        self.size: float = 0.5 if value is not None and value.is_Float else 1 + sum([arg.size for arg in args])

    def ordered(self) -> Sequence["_Part"]:
        """The arguments of a sum or product in the order in which they get their names: smaller ones first."""
        if self.value is None or self.func not in (sp.Add, sp.Mul):
            return self.args
        args = sorted(self.args, key=lambda arg: arg.size)
        if any(one.size == other.size and one.args for one, other in pairwise(args)):
            args.sort(key=lambda arg: (arg.size, sp.default_sort_key(arg.value)))
        return args


Forms = dict[_Part, _Part]  # what a part is made of, instead of its arguments


def shared(values: Sequence[sp.Expr], names: Iterator[sp.Symbol]) -> tuple[list[Assignment], list[sp.Expr]]:
    """Assignments of what the values share, each behind those that it needs, and what is left of the values.

    names: for the assignments; the values have none of them.
    """
    parts: dict[sp.Expr, _Part] = {}

    def part_of(value: sp.Expr) -> _Part:
        found = parts.get(value)
        if found is None:
            found = parts[value] = _Part(value.func, [part_of(arg) for arg in value.args], value)
        return found

    roots = [part_of(value) for value in values]
    forms = _forms(roots, part_of)
    repeated = _repeated(roots, forms)
    done: dict[_Part, sp.Symbol] = {}
    assignments: list[Assignment] = []

    def made(part: _Part) -> sp.Expr:
        if not part.args:
            return part.value
        if part in done:
            return done[part]
        form = forms.get(part, part)
        args = form.ordered()
        values = [made(arg) for arg in args]
        unchanged = form.value is not None and all(one is arg.value for one, arg in zip(values, args, strict=True))
        value = form.value if unchanged else put_together(form.func, values)
        if part not in repeated:
            return value
        done[part] = name = next(names)
        assignments.append((name, value))
        return name

    left = [made(root) for root in roots]
    return assignments, left


def _forms(roots: Iterable[_Part], part_of: Callable[[sp.Expr], _Part]) -> Forms:
    """Of parts that are the opposite of a simpler one, of divisions, and of sums and products that have more than one
    argument in common.
    """
    forms: Forms = {}
    sums: dict[_Part, None] = {}
    products: dict[_Part, None] = {}
    minus_one = part_of(sp.S.NegativeOne)
    seen: set[_Part] = set()

    def look(part: _Part) -> None:
        if not part.args or part in seen:
            return
        seen.add(part)
        for arg in part.args:
            look(arg)
        simpler = simpler_opposite(part.value)
        if simpler is not None and simpler.args:
            forms[part] = _Part(sp.Mul, (minus_one, part_of(simpler)))
            part = part_of(simpler)
            seen.add(part)
        if part.func is sp.Mul:
            products[part] = None
        elif part.func is sp.Add:
            sums[part] = None
        elif part.func is sp.Pow and is_negative(part.args[1].value):
            forms[part] = _Part(sp.Pow, (part_of(sp.Pow(part.value, -1)), minus_one))

    for root in roots:
        look(root)
    forms |= _matched(sp.Add, sums)
    forms |= _matched(sp.Mul, products)
    return forms


def _matched(func: type[sp.Expr], wholes: Iterable[_Part]) -> Forms:
    """Forms of the sums, or of the products, in which what two have in common is one argument, few arguments first."""
    wholes = sorted(wholes, key=lambda whole: len(whole.args))
    numbers: dict[_Part, int] = {}  # of the arguments
    held = [{numbers.setdefault(arg, len(numbers)) for arg in whole.args} for whole in wholes]
    holders: dict[int, set[int]] = {number: set() for number in numbers.values()}
    for k, own in enumerate(held):
        for number in own:
            holders[number].add(k)
    changed: set[int] = set()

    def replace(k: int, common: set[int], by: int) -> None:
        held[k] = held[k] - common | {by}
        for number in common:
            holders[number].discard(k)
        holders[by].add(k)
        changed.add(k)

    def form(own: set[int]) -> _Part:
        arguments = list(numbers)
        return _Part(func, [arguments[number] for number in sorted(own)])

    forms: Forms = {}
    for i, whole in enumerate(wholes):
        counts = Counter(k for number in held[i] for k in holders[number] if k > i)
        candidates = sorted((k for k, count in counts.items() if count > 1), key=lambda k: (counts[k], k))
        for place, j in enumerate(candidates):
            common = held[i] & held[j]
            if len(common) < 2:
                continue  # in one already
            all_of_it = common == held[i]
            number = numbers.setdefault(whole if all_of_it else form(common), len(numbers))
            holders.setdefault(number, set())
            if not all_of_it:
                replace(i, common, number)
            for k in candidates[place:]:
                if common <= held[k]:
                    replace(k, common, number)
        if i in changed:
            forms[whole] = form(held[i])
        for number in held[i]:
            holders[number].discard(i)
    return forms


def _repeated(roots: Iterable[_Part], forms: Forms) -> set[_Part]:
    """The parts that stand in more than one place."""
    seen: set[_Part] = set()
    repeated: set[_Part] = set()

    def look(part: _Part) -> None:
        if not part.args:
            return
        if part in seen:
            repeated.add(part)
            return
        seen.add(part)
        for arg in forms.get(part, part).args:
            look(arg)

    for root in roots:
        look(root)
    return repeated
