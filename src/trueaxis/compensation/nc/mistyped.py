"""Numbers that are mistyped in a block: with a decimal comma, or the letter O for a zero."""

import re

COMMA = "has a decimal comma: write a decimal point"
LETTER = "has the letter O for a zero"
_COMMA = re.compile(r"[A-Za-z]?[ \t]*+=?[ \t]*+[-+]?+\d*+,\d++")
# not of letters that begin a word of a macro with O (DO1), and of no keyword
_LETTER = re.compile(r"[ABCFGHIJKMPQRSTXYZ][ \t]*+=?[ \t]*+[-+]?+[\d.]*[Oo][\dOo.]*+(?![A-Za-z\[=(_])", re.IGNORECASE)
_LONGEST = 24  # characters of such a number, before and behind the place


def mistyped(body: str, place: int) -> str:
    """What is wrong with the number at a place of a block that is no word of its own; empty if it is none of these."""
    begin = max(place - _LONGEST, 0)
    near = body[begin : place + _LONGEST]
    for pattern, problem in ((_COMMA, COMMA), (_LETTER, LETTER)):
        for found in pattern.finditer(near):
            if found.start() <= place - begin < found.end():
                text = found[0].strip()
                right = text.replace(",", ".") if problem == COMMA else text[0] + re.sub("[Oo]", "0", text[1:])
                return f"{text} {problem} ({right})" if problem == COMMA else f"{text} {problem}: {right}"
    return ""
