"""The derivation's own algebra beside SymPy's: the same expressions, in the same order, with the same counts."""

import random

import pytest
import sympy as sp

from tests.derivation.test_routine import models
from trueaxis.derivation.expressions import (
    operations,
    opposite,
    ordered_factors,
    ordered_terms,
    put_together,
    renamed,
    simpler_opposite,
)
from trueaxis.derivation.products import linear_form, multiplied_out, polynomial
from trueaxis.derivation.sharing import shared

SYMBOLS = sp.symbols("EXX eps_xy q_Tx rx x w1 w10 _bound2 cos_b", real=True)
NUMBERS = [sp.Integer(n) for n in (-2, -1, 1, 3)] + [sp.Rational(1, 2), sp.Float(92.3, 17), sp.Float(-0.5, 17)]
DRAWS = 300


def drawn(draw: random.Random, depth: int = 3, *, quotients: bool = True) -> sp.Expr:
    """An expression of sums and products, with a few quotients, squares and roots."""
    if depth == 0 or draw.random() < 0.15:
        return draw.choice(SYMBOLS) if draw.random() < 0.85 else draw.choice(NUMBERS)
    parts = [drawn(draw, depth - 1, quotients=quotients) for _ in range(draw.randint(2, 4))]
    if quotients and draw.random() < 0.1:
        inner = sp.Add(*parts) ** 2 + 1
        return draw.choice((1 / inner, sp.sqrt(inner), sp.sin(inner)))
    return draw.choice((sp.Add, sp.Mul))(*parts)


def many(*, quotients: bool = True) -> list[sp.Expr]:
    draw = random.Random(1)
    return [drawn(draw, quotients=quotients) for _ in range(DRAWS)]


def test_what_expressions_share_is_what_sympy_finds() -> None:
    values = many()
    for start in range(0, DRAWS, 5):
        group = values[start : start + 5]
        theirs, their_rest = sp.cse(group, symbols=sp.numbered_symbols("_shared", real=True))
        ours, rest = shared(group, sp.numbered_symbols("_shared", real=True))
        assert ours == list(theirs)
        assert rest == list(their_rest)


def test_operations_are_those_that_sympy_counts() -> None:
    for value in many():
        assert operations(value) == sp.count_ops(value), value


def test_terms_and_factors_stand_as_sympy_prints_them() -> None:
    for value in many():
        if value.is_Add:
            assert list(ordered_terms(value)) == value.as_ordered_terms()
        if value.is_Mul and not value.args[0].is_negative:
            assert list(ordered_factors(value)) == value.as_ordered_factors()


def test_an_opposite_is_taken_where_sympy_takes_it() -> None:
    for value in many():
        assert opposite(value) == -value
        if value.is_Add or value.is_Mul:
            expected = -value if value.could_extract_minus_sign() else None
            assert simpler_opposite(value) == expected, value


def test_sums_and_products_are_put_together_as_sympy_sorts_them() -> None:
    for value in many():
        for part in sp.preorder_traversal(value):
            if part.is_Add or part.is_Mul:
                shuffled = list(part.args)
                random.Random(2).shuffle(shuffled)
                assert put_together(part.func, shuffled).args == part.args


def test_what_is_renamed_is_what_sympy_replaces() -> None:
    names = {SYMBOLS[0]: sp.Symbol("w2", real=True), SYMBOLS[7]: sp.Symbol("a", real=True)}
    for value in many():
        assert renamed(value, names) == value.xreplace(names)


def test_polynomials_are_multiplied_out_as_sympy_expands_them() -> None:
    exact = [value for value in many(quotients=False) if not value.has(sp.Float)]
    assert len(exact) > DRAWS / 3
    for value in exact:
        assert multiplied_out(value) == sp.expand(value)
        assert polynomial(value).expression() == sp.expand(value)
    quotient = SYMBOLS[0] / (SYMBOLS[1] * (SYMBOLS[2] + 1))
    assert multiplied_out(quotient) == sp.expand(quotient)
    with pytest.raises(ValueError, match="no polynomial"):
        polynomial(quotient)


def test_a_linear_form_has_the_coefficients_that_sympy_finds() -> None:
    a, b, c = SYMBOLS[:3]
    form = (SYMBOLS[3] + 2) * (a - b * SYMBOLS[4]) + 3 * a
    assert linear_form(form, (a, b, c)) == {a: SYMBOLS[3] + 5, b: sp.expand(-SYMBOLS[4] * (SYMBOLS[3] + 2))}
    assert linear_form(sp.S.Zero, (a, b, c)) == {}


@pytest.mark.parametrize("name", ["dmu60p", "five_axis"])
def test_every_value_of_a_routine_is_in_sympys_own_form(name: str) -> None:
    # put together without SymPy, an expression that SymPy would sort otherwise compares unequal to the same one
    for routine in models()[name].routines:
        for _, value in routine.batch + routine.body:
            for part in sp.preorder_traversal(value):
                assert not part.args or part.func(*part.args).args == part.args, (routine.name, part)
