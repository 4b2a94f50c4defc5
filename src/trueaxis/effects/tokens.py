"""Numbers, names and signs of an expression, and what is said of one that is wrong."""

import re
from dataclasses import dataclass
from typing import Literal

LONGEST = 300  # characters of an expression

_TOKEN = re.compile(
    r"(?P<number>(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)|(?P<name>[A-Za-z][A-Za-z0-9_]*)|(?P<sign>[-+*/^()])"
)


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


def tokens(text: str) -> tuple[Token, ...]:
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
