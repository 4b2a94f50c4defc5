"""TOOL CALL and TOOL DEF of Heidenhain Klartext programs."""

import re
from typing import NamedTuple

from trueaxis.compensation.nc.lexer import NUMBER
from trueaxis.compensation.settings import MM_PER_INCH
from trueaxis.compensation.tools import ToolTable

_CALL = re.compile(r"TOOL[ \t]+CALL\b[ \t]*(.*)", re.IGNORECASE)
_DEFINITION = re.compile(rf"TOOL[ \t]+DEF[ \t]+(\d+)[ \t]+L[ \t]*({NUMBER})(?:[ \t]+R[ \t]*{NUMBER})?", re.IGNORECASE)
_SAME = 1e-6  # mm
NO_DEFINITION = ("no TOOL DEF", "")
_NUMBER = re.compile(r'(\d+)(?=[ \t]|$)|"([^"]*)"')
_WORD = re.compile(
    r"(?:([XYZUVW])(?=[ \t]|$)|S[ \t]*[\d.]+|F[ \t]*[\d.]+|(D[LR]2?)[ \t]*([-+]?[\d.]+))[ \t]*", re.IGNORECASE
)


class ToolCall(NamedTuple):
    """tool: its number, or name: its name; neither where the call changes speed or feed alone. problems: (problem,
    remedy) of its words.
    """

    tool: int | None
    name: str = ""
    problems: tuple[tuple[str, str], ...] = ()


def tool_call(content: str) -> ToolCall | None:
    """What a block calls; None if it is no TOOL CALL."""
    match = _CALL.fullmatch(content.strip())
    if match is None:
        return None
    rest, problems = match[1].strip(), []
    number = _NUMBER.match(rest)
    rest = rest[number.end() :].strip() if number else rest
    while rest:
        word = _WORD.match(rest)
        if word is None:
            problems.append(
                (f"{rest[:20]!r} in TOOL CALL is not followed", "the number of the tool, its axis, S and F")
            )
            break
        if (word[1] or "Z").upper() != "Z":
            problems.append((f"the tool axis {word[1]} is not followed", "TOOL CALL with the tool axis Z"))
        if word[2] and word[2].upper() == "DL" and float(word[3]) != 0.0:
            problems.append(("DL changes the length of the tool", "the length that results, in --tools"))
        rest = rest[word.end() :]
    given = number[1] if number else None
    return ToolCall(int(given) if given else None, (number[2] or "") if number else "", tuple(problems))


def definition_differs(content: str, tools: ToolTable | None, inch: bool) -> tuple[str, str]:
    """What is wrong with the length that a block of TOOL DEF gives, and what would be right; empty if nothing is,
    NO_DEFINITION if it is no such block.
    """
    match = _DEFINITION.fullmatch(content.strip())
    if match is None:
        return NO_DEFINITION
    number, length = int(match[1]), float(match[2]) * (MM_PER_INCH if inch else 1.0)
    tool = None if tools is None else tools.tools.get(number)
    if tool is not None and abs(tool.shift[2] - length) < _SAME:
        return "", ""
    known = "has no such tool" if tool is None else f"says {tool.shift[2]:g}"
    return (
        f"TOOL DEF gives tool {number} the length {length:g} mm, and --tools {known}",
        f"[tool.{number}] with length = {length:g}, and point where that is not its length from the spindle",
    )
