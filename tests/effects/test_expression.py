"""The parser: what is right gives the tree that it says, what is wrong is told with its column and what is expected."""

import math
import re
from fractions import Fraction

import mpmath
import pytest
import sympy as sp
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.effects.expressions import NAMES, SYMBOLS, Drawn, expressions
from trueaxis.effects.evaluate import evaluate, is_linear
from trueaxis.effects.expression import (
    DEEPEST,
    LONGEST,
    Binary,
    Call,
    ExpressionError,
    Name,
    Negative,
    Number,
    Pi,
    Power,
    names,
    parse,
)

A, B, C = Name("a"), Name("b"), Name("c")

RIGHT = {
    "a": A,
    "2.5e-3": Number(0.0025),
    ".5": Number(0.5),
    "3.": Number(3.0),
    "pi": Pi(),
    "pie": Name("pie"),
    "t_0": Name("t_0"),
    "a + b*c": Binary("+", A, Binary("*", B, C)),
    "a - b - c": Binary("-", Binary("-", A, B), C),
    "a - (b - c)": Binary("-", A, Binary("-", B, C)),
    "a/b*c": Binary("*", Binary("/", A, B), C),
    "a/b/c": Binary("/", Binary("/", A, B), C),
    "-a^2": Negative(Power(A, 2)),
    "(-a)^2": Power(Negative(A), 2),
    "-a*b": Binary("*", Negative(A), B),
    "a*-b": Binary("*", A, Negative(B)),
    "--a": Negative(Negative(A)),
    "a^2*b": Binary("*", Power(A, 2), B),
    "(a^2)^3": Power(Power(A, 2), 3),
    "sin(a)^2": Power(Call("sin", A), 2),
    "step ( a-b )": Call("step", Binary("-", A, B)),
    "  a  ": A,
    "((a))": A,
}


@pytest.mark.parametrize("text", RIGHT)
def test_what_is_right(text: str) -> None:
    assert parse(text) == RIGHT[text]


# Column of the caret (from 0), a part of the problem, a part of what is expected.
WRONG = {
    "": (0, "the end", "a number, a name"),
    "   ": (3, "the end", "a number, a name"),
    "a +": (3, "the end", "a number, a name"),
    "+a": (0, "'+'", "a number, a name"),
    "a**2": (2, "'*'", "^ for a power"),
    "a*/b": (2, "'/'", "a number, a name"),
    "2 a": (2, "'a'", "one of + - * / ^ or the end"),
    "2a": (1, "'a'", "one of + - * / ^ or the end"),
    "a b": (2, "'b'", "one of + - * / ^ or the end"),
    "1..2": (2, "'.2'", "one of + - * / ^ or the end"),
    "(a": (2, "the end", ") for the ( at column 1"),
    "(a + (b)": (8, "the end", ") for the ( at column 1"),
    "a)": (1, "')'", "one of + - * / ^ or the end"),
    "()": (1, "')'", "a number, a name"),
    "sin": (3, "the end", "( after sin"),
    "sin a": (4, "'a'", "( after sin"),
    "sin()": (4, "')'", "a number, a name"),
    "log(a)": (0, "no function log", "sin cos exp"),
    "a(b)": (0, "no function a", "* for a product"),
    "pi(2)": (0, "no function pi", "sin cos exp"),
    "a^b": (2, "'b'", "whole number from 1 to 9"),
    "a^-1": (2, "'-'", "whole number from 1 to 9"),
    "a^0": (2, "'0'", "whole number from 1 to 9"),
    "a^10": (2, "'10'", "whole number from 1 to 9"),
    "a^2.0": (2, "'2.0'", "whole number from 1 to 9"),
    "a^(2)": (2, "'('", "whole number from 1 to 9"),
    "a^": (2, "the end", "whole number from 1 to 9"),
    "a^2^3": (3, "'^'", "parentheses"),
    "1e999": (0, "too large", "finite"),
    "_a": (0, "'_'", "numbers, names"),
    "a.b": (1, "'.'", "numbers, names"),
    "a, b": (1, "','", "numbers, names"),
    "a = 1": (2, "'='", "numbers, names"),
    "a\tb": (1, "'\\t'", "numbers, names"),
    "a\n": (1, "'\\n'", "numbers, names"),
    "größe": (2, "'ö'", "numbers, names"),
    "٣": (0, "'٣'", "numbers, names"),
    "a²": (1, "'²'", "numbers, names"),
    "__import__('os')": (0, "'_'", "numbers, names"),
    "lambda: 0": (6, "':'", "numbers, names"),
    "(" * (DEEPEST + 1): (DEEPEST, "too deeply", str(DEEPEST)),
    "-" * (DEEPEST + 1) + "a": (DEEPEST, "too deeply", str(DEEPEST)),
    "sin(" * (DEEPEST + 1) + "a": (4 * DEEPEST + 3, "too deeply", str(DEEPEST)),
    "a" * (LONGEST + 1): (LONGEST, "too many", str(LONGEST)),
}


@pytest.mark.parametrize("text", WRONG)
def test_what_is_wrong(text: str) -> None:
    column, problem, expected = WRONG[text]
    with pytest.raises(ExpressionError) as caught:
        parse(text)
    assert caught.value.column == column
    assert problem in caught.value.problem
    assert expected in caught.value.expected


@pytest.mark.parametrize("text", ["a + )", "a*b + " * 30 + ")"])
def test_the_caret_is_under_the_column(text: str) -> None:
    with pytest.raises(ExpressionError) as caught:
        parse(text)
    _, line, caret = str(caught.value).split("\n")
    assert line[caret.index("^")] == ")"
    assert len(line) < 120


def test_as_deep_and_as_long_as_allowed() -> None:
    assert parse("(" * DEEPEST + "a" + ")" * DEEPEST) == A
    chain = "+".join("1" * ((LONGEST + 1) // 2))
    assert evaluate(parse(chain), {}) == (LONGEST + 1) // 2


@given(st.text(alphabet="ab1.e^*/+-() \tsinpö_", max_size=40) | st.text(max_size=40))
def test_any_text_is_read_or_told_to_be_wrong_within_it(text: str) -> None:
    try:
        tree = parse(text)
    except ExpressionError as error:
        told = error
    else:
        assert {name.name for name in names(tree)} <= set(re.findall(r"[A-Za-z][A-Za-z0-9_]*", text))
        assert all(text[name.column :].startswith(name.name) for name in names(tree))
        return
    assert 0 <= told.column <= len(text)
    assert told.problem
    assert told.expected
    assert str(told).count("\n") == 2


def test_names_come_once_at_their_first_column() -> None:
    found = names(parse("b*(a - b) + sin(c)^2 - a"))
    assert [(name.name, name.column) for name in found] == [("b", 0), ("a", 3), ("c", 16)]


POINTS = st.fixed_dictionaries({name: st.floats(-3, 3) for name in NAMES})


def exact(drawn: Drawn, values: dict[str, float]) -> float:
    with mpmath.workdps(40):
        substituted = drawn.value.subs({SYMBOLS[name]: sp.Rational(Fraction(v)) for name, v in values.items()})
        return float(sp.N(substituted, 30))


def smooth(drawn: Drawn) -> bool:
    """Without jumps, next to which rounding alone decides."""
    return not drawn.value.has(sp.sign, sp.Heaviside)


@given(expressions().filter(smooth), POINTS)
def test_values_are_those_of_another_arithmetic(drawn: Drawn, values: dict[str, float]) -> None:
    assume(len(drawn.text) <= LONGEST)
    wanted = exact(drawn, values)
    assume(abs(wanted) < 1e12)
    # Sums of terms up to this size cancel in any floating-point arithmetic.
    assert evaluate(parse(drawn.text), values) == pytest.approx(wanted, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("-3^2", -9.0),
        ("2*3 - 4/8", 5.5),
        ("1 - 2 - 3", -4.0),
        ("12/3/2", 2.0),
        ("step(0)", 1.0),
        ("step(-1e-300)", 0.0),
        ("sign(0)", 0.0),
        ("sign(-2) + abs(-3)", 2.0),
        ("cos(pi)", -1.0),
        ("sqrt(16)*exp(0) + tanh(0) + sin(0)", 4.0),
    ],
)
def test_values_by_hand(text: str, value: float) -> None:
    assert evaluate(parse(text), {}) == value


@pytest.mark.parametrize(
    "text", ["1/0", "sqrt(-1)", "exp(1000)", "9^9^9".replace("^9^", "^9*1e308*") + "*1e308", "0/0"]
)
def test_no_value_is_nan(text: str) -> None:
    assert not math.isfinite(evaluate(parse(text), {}))


@pytest.mark.parametrize(
    ("text", "linear"),
    [
        ("a", True),
        ("-a*s/2", True),
        ("a*sin(s) + b*cos(s)", True),
        ("(a - 2*b)*(s^2 - 1)/(1 + s)", True),
        ("a + 1", False),
        ("a*b", False),
        ("a^2", False),
        ("a^1", False),
        ("s/a", False),
        ("sin(a)", False),
        ("abs(a)*s", False),
        ("a*exp(b)", False),
        ("s", False),
        ("a - a*b", False),
    ],
)
def test_linear_in_a_and_b(text: str, linear: bool) -> None:
    assert is_linear(parse(text), ("a", "b")) is linear
