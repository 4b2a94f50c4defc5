"""One block of an NC program as words (ISO 6983-1, RS-274)."""

import re
from typing import NamedTuple

# possessive quantifiers: no backtracking, so a hostile block costs linear time; none of groups, which Python before
# 3.11.5 gets wrong
NUMBER = r"[-+]?+(?:\d++\.?+\d*+|\.\d++)"
_TOKEN = re.compile(rf"([ \t]++)|([A-Za-z])[ \t]*+({NUMBER})|(\([^()]*+\)|;.*+)")
_MACRO = re.compile(r"[#\[\]=<>&|]|(?i:\b(?:WHILE|GOTO|IF|CALL|SUB|ENDSUB|DEF|PROC|REPEAT|FOR|SET)\b)")


LARGEST = 1e9  # of a word's number: what is more is no machine's
# LinuxCNC runs such a comment as Python, which may do anything
_PYTHON = re.compile(r"[(;][ \t]*+py[ \t]*+,", re.IGNORECASE)
_FURTHER_BLOCK = re.compile(rf";[ \t;]*+(?:[A-Z][ \t]*+{NUMBER}[ \t;]*+)+", re.IGNORECASE)


class Word(NamedTuple):
    """An address and its value; start and end are the place in the block, decimals the digits written after the decimal
    point, None where there is none.
    """

    letter: str
    value: float
    start: int
    end: int
    decimals: int | None

    @property
    def dot(self) -> bool:
        """Whether the number has a decimal point."""
        return self.decimals is not None


class Block(NamedTuple):
    """Words of a block in order; problem is what is wrong with its text, empty if nothing is."""

    words: tuple[Word, ...]
    problem: str


def lex(body: str, begin: int = 0) -> Block:
    """Words of a block, comments left out; `body` has no line end, reading begins at `begin`."""
    words: list[Word] = []
    place = begin
    while place < len(body):
        token = _TOKEN.match(body, place)
        if token is None:
            return Block(tuple(words), _complaint(body, place))
        if token[2]:
            value = float(token[3])
            if abs(value) > LARGEST:
                return Block(tuple(words), beyond(token[2], token[3]))
            words.append(Word(token[2].upper(), value, place, token.end(), decimals_of(token[3])))
        elif token[4] and (problem := _active_comment(token[4], bool(words))):
            return Block(tuple(words), f"column {place + 1}: {problem}")
        place = token.end()
    return Block(tuple(words), "")


def beyond(letter: str, number: str) -> str:
    """What is wrong with a word above `LARGEST`."""
    return f"{letter} has the value {number[:20]}..., which is no machine's"


def decimals_of(number: str) -> int | None:
    """Digits after the decimal point of a number as written; None where there is none."""
    _, dot, part = number.partition(".")
    return len(part) if dot else None


def _active_comment(text: str, after_words: bool) -> str:
    """Why a comment could do more than comment; empty if it cannot."""
    if _PYTHON.match(text):
        return "LinuxCNC runs this comment as Python, which is not followed"
    if after_words and _FURTHER_BLOCK.fullmatch(text):
        return "; ends a block on some controls and begins a comment on others, and words follow it"
    return ""


def _complaint(body: str, place: int) -> str:
    column = f"column {place + 1}"
    sign = body[place]
    if sign == "(":
        return f"{column}: a comment that is not closed, or holds another"
    if _MACRO.search(body, place):
        return f"{column}: {body[place : place + 20]!r} is a macro, variable or expression; its value is not followed"
    if sign.isascii() and sign.isalpha():
        return f"{column}: address {sign} without a number"
    return f"{column}: {sign!r} does not belong in a block"
