"""The language of expressions of effects: text to a small syntax tree, read strictly and never executed.

    sum      = product { ("+" | "-") product }
    product  = factor { ("*" | "/") factor }
    factor   = "-" factor | power
    power    = atom [ "^" whole number from 1 to 9 ]
    atom     = number | name | "pi" | function "(" sum ")" | "(" sum ")"

A function is one of FUNCTIONS; step(x) is 1 for x >= 0 and 0 below, sign(0) is 0. An exponent is no expression: a power
then has a value and a derivative wherever its base has.
"""

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Literal, cast

Operator = Literal["+", "-", "*", "/"]
Function = Literal["sin", "cos", "exp", "sqrt", "abs", "sign", "step", "tanh"]
FUNCTIONS: tuple[Function, ...] = ("sin", "cos", "exp", "sqrt", "abs", "sign", "step", "tanh")
LARGEST_EXPONENT = 9
# Powers of powers multiply their exponents, and a kernel writes a power as a product of as many factors.
HIGHEST_DEGREE = 99
DEEPEST = 30  # parentheses, functions and minus signs within one another
_ATOM = "a number, a name, a function or ("
_OPERATOR = "one of + - * / ^ or the end"
LONGEST = 300  # characters of an expression
_TOKEN = re.compile(
    r"(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[A-Za-z][A-Za-z0-9_]*)|(?P<sign>[-+*/^()])"
)


@dataclass(frozen=True, slots=True)
class Number:
    """A number, finite and not negative."""

    value: float


@dataclass(frozen=True, slots=True)
class Pi:
    """The constant pi."""


@dataclass(frozen=True, slots=True)
class Name:
    """A context variable or a parameter; column: where it stands in the text, from 0."""

    name: str
    column: int = field(default=0, compare=False)


@dataclass(frozen=True, slots=True)
class Negative:
    """Minus its operand."""

    operand: "Expression"


@dataclass(frozen=True, slots=True)
class Binary:
    """A sum, difference, product or quotient."""

    operator: Operator
    left: "Expression"
    right: "Expression"


@dataclass(frozen=True, slots=True)
class Power:
    """The base to a whole exponent from 1 to 9."""

    base: "Expression"
    exponent: int


@dataclass(frozen=True, slots=True)
class Call:
    """A function of one argument."""

    function: Function
    argument: "Expression"


Expression = Number | Pi | Name | Negative | Binary | Power | Call


def parse(text: str) -> Expression:
    """The syntax tree of an expression. Raises ExpressionError, which tells the column and what was expected there."""
    return _Parser(text, _tokens(text)).whole()


def names(expression: Expression) -> tuple[Name, ...]:
    """Every name of an expression once, in the order in which they stand in it."""
    found: dict[str, Name] = {}
    for name in _names(expression):
        found.setdefault(name.name, name)
    return tuple(found.values())


def _names(expression: Expression) -> Iterator[Name]:
    match expression:
        case Name():
            yield expression
        case Negative(operand=inner) | Power(base=inner) | Call(argument=inner):
            yield from _names(inner)
        case Binary(left=left, right=right):
            yield from _names(left)
            yield from _names(right)


def _degree(expression: Expression) -> int:
    """How many factors of a product an expression has at most, once its powers are written as products."""
    match expression:
        case Number() | Pi():
            return 0
        case Negative(operand=inner):
            return _degree(inner)
        case Power(base=base, exponent=exponent):
            return exponent * _degree(base)
        case Binary(operator=operator, left=left, right=right):
            degrees = _degree(left), _degree(right)
            return sum(degrees) if operator in "*/" else max(degrees)
    return 1


class ExpressionError(ValueError):
    """An expression that cannot be read: `problem` at `column` (from 0), and what was `expected` there.

    The message shows the text with a caret under the column.
    """

    def __init__(self, text: str, column: int, problem: str, expected: str) -> None:
        self.text, self.column, self.problem, self.expected = text, column, problem, expected
        super().__init__(f"{problem}; expected: {expected}\n{self.marked}")

    @property
    def marked(self) -> str:
        """Two lines, indented: the text (a stretch of it where it is long), and the caret under the column."""
        start = max(0, self.column - 70)
        line = "".join(sign if sign.isprintable() else " " for sign in self.text[start : start + 100])
        return f"    {line}\n    {' ' * (self.column - start)}^"


@dataclass(frozen=True, slots=True)
class Token:
    """A stretch of the text; column from 0."""

    kind: Literal["number", "name", "sign", "end"]
    text: str
    column: int

    @property
    def shown(self) -> str:
        """As a message shows it."""
        return f"{self.text[:40]!r}" if self.text else "the end"


class _Parser:
    """Recursive descent over the tokens; one method per rule of the grammar."""

    def __init__(self, text: str, found: tuple[Token, ...]) -> None:
        self._text, self._tokens, self._at, self._depth = text, found, 0, 0

    def whole(self) -> Expression:
        expression = self._sum()
        if self._next.kind != "end":
            raise self._fault(_OPERATOR)
        return expression

    @property
    def _next(self) -> Token:
        return self._tokens[self._at]

    def _taken(self) -> Token:
        token = self._next
        self._at += token.kind != "end"
        return token

    def _takes(self, signs: str) -> bool:
        return self._next.kind == "sign" and self._next.text in signs

    def _fault(self, expected: str, token: Token | None = None) -> ExpressionError:
        token = token or self._next
        return ExpressionError(self._text, token.column, f"{token.shown} stands where it cannot", expected)

    def _deeper(self, token: Token) -> None:
        self._depth += 1
        if self._depth > DEEPEST:
            raise ExpressionError(self._text, token.column, "is nested too deeply", f"{DEEPEST} levels at most")

    def _sum(self) -> Expression:
        left = self._product()
        while self._takes("+-"):
            left = Binary(cast(Operator, self._taken().text), left, self._product())
        return left

    def _product(self) -> Expression:
        left = self._factor()
        while self._takes("*/"):
            left = Binary(cast(Operator, self._taken().text), left, self._factor())
        return left

    def _factor(self) -> Expression:
        if not self._takes("-"):
            return self._power()
        self._deeper(self._taken())
        operand = self._factor()
        self._depth -= 1
        return Negative(operand)

    def _power(self) -> Expression:
        base = self._atom()
        if not self._takes("^"):
            return base
        self._taken()
        right = f"a whole number from 1 to {LARGEST_EXPONENT} as exponent (else sqrt, exp or a division)"
        token = self._taken()
        if token.kind != "number" or not token.text.isdigit() or not 1 <= float(token.text) <= LARGEST_EXPONENT:
            raise self._fault(right, token)
        if self._takes("^"):
            raise self._fault("parentheses around the first of two powers")
        power = Power(base, int(token.text))
        if (degree := _degree(power)) > HIGHEST_DEGREE:
            problem = f"the powers within one another are of degree {degree}"
            raise ExpressionError(self._text, token.column, problem, f"{HIGHEST_DEGREE} at most")
        return power

    def _atom(self) -> Expression:
        token = self._taken()
        if token.kind == "number":
            value = float(token.text)
            if not math.isfinite(value):
                raise ExpressionError(self._text, token.column, f"{token.text} is too large", "a finite number")
            return Number(value)
        if token.kind == "name":
            return self._named(token)
        if token.text == "(":
            return self._enclosed(token)
        twice = self._at > 1 and token.text == "*" and self._tokens[self._at - 2].text == "*"
        raise self._fault("^ for a power" if twice else _ATOM, token)

    def _named(self, token: Token) -> Expression:
        called = self._takes("(")
        if token.text in FUNCTIONS:
            if not called:
                raise self._fault(f"( after {token.text}")
            return Call(token.text, self._enclosed(self._taken()))
        if called:
            problem = f"there is no function {token.text}"
            raise ExpressionError(self._text, token.column, problem, f"one of {' '.join(FUNCTIONS)}; * for a product")
        return Pi() if token.text == "pi" else Name(token.text, token.column)

    def _enclosed(self, opened: Token) -> Expression:
        self._deeper(opened)
        inner = self._sum()
        if not self._takes(")"):
            raise self._fault(f") for the ( at column {opened.column + 1}, or one of + - * / ^")
        self._taken()
        self._depth -= 1
        return inner


def _tokens(text: str) -> tuple[Token, ...]:
    """The tokens of an expression and one of the kind `end`. Raises ExpressionError."""
    if len(text) > LONGEST:
        raise ExpressionError(text, LONGEST, f"{len(text)} characters are too many", f"{LONGEST} characters at most")
    found: list[Token] = []
    column = 0
    while column < len(text):
        if text[column] == " ":
            column += 1
            continue
        match = _TOKEN.match(text, column)
        if match is None:
            right = "numbers, names, + - * / ^ ( )"
            raise ExpressionError(text, column, f"{text[column]!r} means nothing here", right)
        if match["number"]:
            found.append(Token("number", match[0], column))
        elif match["name"]:
            found.append(Token("name", match[0], column))
        else:
            found.append(Token("sign", match[0], column))
        column = match.end()
    return (*found, Token("end", "", len(text)))
