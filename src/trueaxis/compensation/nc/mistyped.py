"""Numbers that are mistyped in a block: with a decimal comma, or the letter O for a zero."""

import re
from collections.abc import Callable
from enum import Enum
from typing import NamedTuple, Protocol, TypeVar

_COMMA = "has a decimal comma: write a decimal point"
_LETTER = "has the letter O for a zero"
_BOTH = f"{_LETTER}, and a decimal comma"
_NUMBER = r"[ABCFGHIJKMPQRSTXYZ][ \t]*+=?[ \t]*+[-+]?+"
# not of letters that begin a word of a macro with O (DO1), and of no keyword
_END = r"(?![A-Za-z\[=(_])"
# of a block number only what ends with the letter: N10O100 has a program number
_PATTERNS = [
    (re.compile(pattern, re.IGNORECASE), problem)
    for pattern, problem in (
        (rf"{_NUMBER}(?=\d*,?\d*O)[\dO]*+,[\dO]++{_END}", _BOTH),
        (r"[A-Z]?[ \t]*+=?[ \t]*+[-+]?+\d*+,\d++", _COMMA),
        (rf"{_NUMBER}[\d.]*O[\dO.]*+{_END}|N\d++O++(?![\w\[=(.<])", _LETTER),
    )
]
_LONGEST = 24  # characters of such a number, before and behind the place
_POSITIONS = frozenset("XYZABCIJKR")  # of which a number without a decimal point would be a fault of its own
_MOST = 9  # numbers of a block that are put right: a hostile block costs no more


class Slip(Enum):
    """What takes the place of a point or a digit."""

    COMMA = ","
    LETTER = "O"


class Mistyped(NamedTuple):
    """What is wrong with a word, and the block with it put right; empty where nobody knows how."""

    problem: str
    mended: str


class _Read(Protocol):
    @property
    def problem(self) -> str: ...
    @property
    def mended(self) -> str: ...


_R = TypeVar("_R", bound=_Read)


def mistyped(body: str, place: int) -> Mistyped | None:
    """What is wrong with the number at a place of a block that is no word of its own; None if it is none of these."""
    begin = max(place - _LONGEST, 0)
    near = body[begin : place + _LONGEST]
    for pattern, problem in _PATTERNS:
        for found in pattern.finditer(near):
            if found.start() <= place - begin < found.end():
                text = found[0].strip()
                right = text[0] + re.sub("[Oo]", "0", text[1:]).replace(",", ".")
                dot = "" if "." in right or right[0].upper() not in _POSITIONS else "."
                mended = f"{body[: begin + found.start()]}{right}{dot}{body[begin + found.end() :]}"
                return Mistyped(
                    f"{text} {problem} ({right})" if problem == _COMMA else f"{text} {problem}: {right}", mended
                )
    return None


class Slips(NamedTuple):
    """What is mistyped in a block: of which kinds, and the text of its fault, empty where nothing is."""

    kinds: frozenset[Slip] = frozenset()
    problem: str = ""


NOTHING = Slips()


def read_mended(body: str, read: Callable[[str], _R]) -> tuple[_R, Slips]:
    """A block as it is meant, so that what follows is read on from where it leads, and what of it is mistyped.

    read: takes words from a text; its result names a number that is mistyped, and the text with it put right.
    """
    found = read(body)
    if not found.mended:
        return found, NOTHING
    wrong, text = list[str](), body
    while found.mended and len(wrong) < _MOST:
        wrong.append(found.problem)
        text = found.mended
        found = read(text)
    kinds = frozenset(one for one in Slip if text.upper().count(one.value) < body.upper().count(one.value))
    return found, Slips(kinds, ", ".join(wrong))
