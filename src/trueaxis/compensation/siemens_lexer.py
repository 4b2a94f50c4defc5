"""One block of a SINUMERIK program (840D, 828D, 808D) as words: `X=10.5`, `CR=5`, `X=AC(10)`, keywords and calls.

Source: SINUMERIK 840D sl / 828D, Programming Manual Fundamentals.
"""

import re
from typing import NamedTuple

from trueaxis.compensation.nc_lexer import LARGEST, NUMBER, Block, Word, beyond, decimals_of

_BLANK = re.compile(r"[ \t]++")
_COMMENT = re.compile(r";.*+")
_LABEL = re.compile(r"[A-Za-z_][A-Za-z0-9_]++:(?!=)[ \t]*+")
_WAY = re.compile(rf"([XYZABCIJK])[ \t]*+=[ \t]*+(AC|IC)[ \t]*+\([ \t]*+({NUMBER})[ \t]*+\)", re.IGNORECASE)
_ASSIGNED = re.compile(rf"(CR|[XYZABCIJKFSTDMN])[ \t]*+=[ \t]*+({NUMBER})(?![\w(*/+.$-])", re.IGNORECASE)
_SPINDLE = re.compile(r"[MS][0-9]{1,2}[ \t]*+=[ \t]*+([0-9]++(?:\.[0-9]*+)?)(?![\w(*/+.$-])", re.IGNORECASE)
_TOOL_NAME = re.compile(r'T[ \t]*+=[ \t]*+"[^"]*+"', re.IGNORECASE)
_PLAIN = re.compile(rf"([A-Za-z])[ \t]*+({NUMBER})(?![ \t]*+=)")
_KEYWORD = re.compile(r"[A-Za-z_][A-Za-z0-9_]*+")
_ARGUMENTS = re.compile(r"[ \t]*+\([^()\"]*+(?:\"[^\"]*+\"[^()\"]*+)*\)")
_ADIS = re.compile(rf"(?:ADIS|ADISPOS)[ \t]*+=[ \t]*+{NUMBER}", re.IGNORECASE)
_STATEMENT = re.compile(r"(?:R[0-9]++|\$\w++|[A-Za-z_]\w*+)[ \t]*+(?:\[[^\]]*+\])?[ \t]*+=")

# a spindle's speed and direction: no axis; what a word with another spindle's number may say
_SPINDLE_CODES = frozenset({"3", "4", "5", "03", "04", "05"})
ABSOLUTE_WAY, INCREMENTAL_WAY = "AC", "IC"
TOOL_BY_NAME = "T="


class Function(NamedTuple):
    """A keyword or call in a block, in capitals; arguments: the text in its parentheses, None without any."""

    name: str
    arguments: str | None


class SiemensBlock(NamedTuple):
    """words: as of a `Block`; functions: keywords and calls; ways: AC or IC of words that have it."""

    block: Block
    functions: tuple[Function, ...]
    ways: dict[str, str]


def lex_siemens(body: str, begin: int = 0) -> SiemensBlock:
    """Words, keywords and calls of a block; `body` has no line end, reading begins at `begin`."""
    words: list[Word] = []
    functions: list[Function] = []
    ways: dict[str, str] = {}
    place = begin
    problem = ""
    while place < len(body) and not problem:
        if passed := _BLANK.match(body, place) or _COMMENT.match(body, place) or _ADIS.match(body, place):
            place = passed.end()
        elif not functions and (label := _LABEL.match(body, place)):
            place = label.end()
        elif (number := _WAY.match(body, place)) and abs(float(number[3])) > LARGEST:
            problem = beyond(number[1], number[3])
        elif way := _WAY.match(body, place):
            ways[way[1].upper()] = way[2].upper()
            words.append(_word(way[1], way[3], place, way.end()))
            place = way.end()
        elif found := _ASSIGNED.match(body, place) or _PLAIN.match(body, place):
            if abs(float(found[2])) > LARGEST:
                problem = beyond(found[1], found[2])
                break
            words.append(_word("R" if found[1].upper() == "CR" else found[1], found[2], place, found.end()))
            if found[1].upper() == "R":
                problem = f"column {place + 1}: R is a parameter on SINUMERIK; the radius of an arc is CR="
            place = found.end()
        elif (spindle := _SPINDLE.match(body, place)) and (body[place] in "Ss" or spindle[1] in _SPINDLE_CODES):
            place = spindle.end()
        elif named := _TOOL_NAME.match(body, place):
            functions.append(Function(TOOL_BY_NAME, named[0]))
            place = named.end()
        elif _STATEMENT.match(body, place) or not (keyword := _KEYWORD.match(body, place)):
            problem = f"column {place + 1}: {body[place : place + 20]!r} is no word whose value is in the program"
        else:
            arguments = _ARGUMENTS.match(body, keyword.end())
            functions.append(Function(keyword[0].upper(), arguments[0].strip() if arguments else None))
            place = arguments.end() if arguments else keyword.end()
    return SiemensBlock(Block(tuple(words), problem), tuple(functions), ways)


def _word(letter: str, number: str, start: int, end: int) -> Word:
    return Word(letter.upper(), float(number), start, end, decimals_of(number))
