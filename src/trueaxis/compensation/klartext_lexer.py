"""One block of a Heidenhain Klartext program: its verb, its words, and the text around them.

Source: HEIDENHAIN, User's Manual Klartext Programming (TNC 640, iTNC 530).
"""

import re
from collections.abc import Mapping
from types import MappingProxyType
from typing import NamedTuple

from trueaxis.compensation.nc_lexer import NUMBER, decimals_of

_HEAD = re.compile(r"([ \t]*+(?:\d++[ \t]++)?)(/?)[ \t]*+")
_VERB = re.compile(r"(LP|LN|LT|L|CC|CP|CR|CTP|CT|C)(?=[ \t]|$|[XYZ][-+.0-9])", re.IGNORECASE)
_AXIS = re.compile(rf"(I?)(PR|PA|[XYZABC])[ \t]*+({NUMBER})(?![\w.])", re.IGNORECASE)
_DIRECTION = re.compile(r"DR([-+])", re.IGNORECASE)
_RADIUS = re.compile(r"R([-+](?:\d++\.?+\d*+|\.\d++))(?![\w.])", re.IGNORECASE)
_SIDE = re.compile(r"R[0LR](?![\w.])", re.IGNORECASE)
_FEED = re.compile(r"F[ \t]*+(?:(MAX|AUTO)|(\d++\.?+\d*+|\.\d++))(?![\w.])", re.IGNORECASE)
_CODE = re.compile(r"M[ \t]*+(\d++)(?![\w.])", re.IGNORECASE)
_LONG = re.compile(r"(?<![\d.])\d{10,}")
_BLANK = re.compile(r"[ \t]++")
MACHINE_COORDINATES = 91


class Coordinate(NamedTuple):
    """value: mm (inch) or deg; incremental: whether it counts from where the axis stands; decimals: written."""

    value: float
    incremental: bool
    decimals: int


class KlartextBlock(NamedTuple):
    """A block of the path functions; empty verb: none.

    head: block number and blanks before it; optional: `/` of an optional block; others: the words that are no
    coordinates, as written; comment: from `;` on. direction: +1 for DR+, -1 for DR-, 0: none. radius: of CR, with sign.
    feed: mm/min or 0.1 inch/min, None: no F; rapid: FMAX. side: R0, RL, RR or empty. problem: what is wrong with it.
    """

    verb: str = ""
    head: str = ""
    optional: str = ""
    coordinates: Mapping[str, Coordinate] = MappingProxyType({})
    direction: int = 0
    radius: float | None = None
    feed: float | None = None
    rapid: bool = False
    side: str = ""
    codes: tuple[int, ...] = ()
    others: tuple[str, ...] = ()
    comment: str = ""
    problem: str = ""


def head_of(body: str) -> tuple[str, str, str]:
    """Number and blanks, `/`, and the rest of a block without its comment."""
    match = _HEAD.match(body)
    if match is None:
        return "", "", body
    return match[1], match[2], body[match.end() :]


def too_long(body: str) -> str:
    """What is wrong with a number of more digits than any machine's, block numbers too; empty if there is none."""
    found = _LONG.search(body.partition(";")[0])
    return f"{found[0][:20]}... is no machine's number" if found else ""


def lex_klartext(body: str) -> KlartextBlock:
    """A block of a path function; verb is empty where it is something else."""
    head, optional, rest = head_of(body)
    text, sign, comment = rest.partition(";")
    verb = _VERB.match(text)
    if verb is None:
        return KlartextBlock(head=head, optional=optional, comment=sign + comment)
    coordinates: dict[str, Coordinate] = {}
    codes: list[int] = []
    others: list[str] = []
    direction, radius, feed, rapid, side, problem = 0, None, None, False, "", ""
    place = verb.end()
    while place < len(text) and not problem:
        if found := _BLANK.match(text, place):
            pass
        elif found := _AXIS.match(text, place):
            letter, value = found[2].upper(), float(found[3])
            if letter in coordinates:
                problem = f"{letter} occurs twice in the block"
            coordinates[letter] = Coordinate(value, bool(found[1]), decimals_of(found[3]) or 0)
        elif found := _DIRECTION.match(text, place):
            direction = 1 if found[1] == "+" else -1
        elif found := _SIDE.match(text, place):
            side = found[0].upper()
            others.append(found[0])
        elif found := _RADIUS.match(text, place):
            radius = float(found[1])
        elif found := _FEED.match(text, place):
            rapid = (found[1] or "").upper() == "MAX"
            feed = float(found[2]) if found[2] else None
            others.append(found[0])
        elif found := _CODE.match(text, place):
            codes.append(int(found[1]))
            others.append(found[0])
        else:
            problem = f"{text[place : place + 20].strip()!r} is no word whose value is in the program"
            break
        place = found.end()
    return KlartextBlock(
        verb[1].upper(), head, optional, coordinates, direction, radius, feed, rapid, side, tuple(codes),
        tuple(others), sign + comment, problem,
    )  # fmt: skip


def codes_alone(content: str) -> KlartextBlock | None:
    """A block of M codes without a path function."""
    words = content.split()
    if not words or not all(word[0] in "Mm" and word[1:].isdigit() for word in words):
        return None
    return KlartextBlock(codes=tuple(int(word[1:]) for word in words), others=tuple(words))
