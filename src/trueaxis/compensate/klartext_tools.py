"""TOOL CALL of Heidenhain Klartext programs."""

import re
from typing import NamedTuple

_CALL = re.compile(r"TOOL[ \t]+CALL\b[ \t]*(.*)", re.IGNORECASE)
_NUMBER = re.compile(r"\d+(?=[ \t]|$)")
_WORD = re.compile(
    r"(?:([XYZUVW])(?=[ \t]|$)|S[ \t]*[\d.]+|F[ \t]*[\d.]+|(D[LR]2?)[ \t]*([-+]?[\d.]+))[ \t]*", re.IGNORECASE
)


class ToolCall(NamedTuple):
    """tool: its number; None where the call changes speed or feed alone. problems: (problem, remedy) of its words."""

    tool: int | None
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
    return ToolCall(int(number[0]) if number else None, tuple(problems))
