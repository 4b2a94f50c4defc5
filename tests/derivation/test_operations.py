"""Operations of an expression, beside SymPy's own count of them."""

import random

import sympy as sp

from trueaxis.derivation.routine import count_operations

X, Y, Z = sp.symbols("x y z")


def drawn(source: random.Random, depth: int) -> sp.Expr:
    if depth == 0:
        whole, part = source.randint(-3, 3), sp.Rational(source.randint(-5, 5), source.randint(1, 4))
        return source.choice([X, Y, Z, sp.Integer(whole), part, sp.Float(source.uniform(-2.0, 2.0)), sp.pi])
    kind = source.choice([sp.Add, sp.Add, sp.Mul, sp.Mul, sp.Mul, sp.sin, sp.Pow])
    if kind is sp.sin:
        return sp.sin(drawn(source, depth - 1))
    if kind is sp.Pow:
        return sp.Pow(drawn(source, depth - 1), source.choice([-1, 2, -2, sp.Rational(1, 2)]))
    return kind(*(drawn(source, depth - 1) for _ in range(source.randint(2, 4))))


def test_they_are_counted_as_sympy_counts_them() -> None:
    source = random.Random(4)
    values = [drawn(source, source.randint(1, 4)) for _ in range(800)]
    finite = [value for value in values if not value.has(sp.zoo, sp.nan)]
    assert len(finite) > 700
    differing = [value for value in finite if count_operations([value]) != sp.count_ops(value)]
    assert not differing
