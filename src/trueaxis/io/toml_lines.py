"""TOML texts: parsed within limits, and the lines of their keys, which the standard parser does not report."""

import re
import tomllib
from collections.abc import Callable, Iterator
from typing import Any

from trueaxis.io.faults import Faults, InputError

KeyPath = tuple[str | int, ...]

LARGEST_TEXT = 32 * 2**20  # characters: 100 000 runs; the parser takes about a second for each million
# Parts of a dotted key: no table of ours is deeper than 4. The parser's time grows with the square of their number.
MOST_PARTS = 50
LONGEST_SHOWN = 60  # characters of a key, in a message; the parser's own messages, three times as many

_DEEPEST = 8  # steps from the top to which lines are kept; deeper keys have the line of the key above them
_PART = r"""(?:[A-Za-z0-9_-]+|"[^"\\\n]*(?:\\.[^"\\\n]*)*"|'[^'\n]*')"""
_KEY = re.compile(rf"{_PART}(?:[ \t]*\.[ \t]*{_PART})*")
# What may look like a dotted key and is none: comments and strings, of which those on one line may be parts of a key.
# A string without an end takes the rest of its line, or of the text: the parser stops there.
_NO_KEY = re.compile(
    r'''(?P<lines>"""(?:[^"\\]++|\\[\s\S]?|"{1,2}(?!"))*(?:"{3,5}|\Z)|\'\'\'(?:[^']++|'{1,2}(?!'))*(?:'{3,5}|\Z))'''
    r"""|(?P<comment>#[^\n]*)|"[^"\\\n]*+(?:\\.[^"\\\n]*+)*"?|'[^'\n]*+'?"""
)
_LONG_KEY = re.compile(rf'(?<![\w"-])[\w"-]+(?:[ \t]*\.[ \t]*[\w"-]+){{{MOST_PARTS}}}', re.ASCII)
_BLANK = re.compile(r"(?:[ \t\n]+|#[^\n]*)*")
_HEADER = re.compile(r"(\[\[?)[ \t]*")
_OF_VALUE = re.compile(
    r'''(?P<string>"""(?:[^"\\]+|\\[\s\S]|""?(?!"))*"{3,5}|\'\'\'(?:[^']+|''?(?!'))*'{3,5}'''
    r"""|"[^"\\\n]*(?:\\.[^"\\\n]*)*"|'[^'\n]*')|(?P<open>[\[{])|(?P<close>[\]}])|(?P<comment>#[^\n]*)|(?P<end>\n)"""
    r"""|[^"'\[\]{}#\n]+"""
)


def parse_toml(text: str, faults: Faults) -> dict[str, Any]:
    """The tree of a TOML text. Raises InputError where it is none, or larger than any file that a person writes."""
    if len(text) > LARGEST_TEXT:
        faults.add("", f"has {len(text)} characters", f"{LARGEST_TEXT} at most")
        raise InputError(faults.found)
    bare = _NO_KEY.sub(_without, text.replace("\r\n", "\n"))
    if found := _LONG_KEY.search(bare):
        line = bare.count("\n", 0, found.start()) + 1
        faults.add(f"line {line}", "has a dotted key of too many parts", f"{MOST_PARTS} at most")
        raise InputError(faults.found)
    try:
        return tomllib.loads(text)
    except RecursionError:
        faults.add("", "is not TOML: nested too deeply")
    except ValueError as error:  # bad syntax, or a number of thousands of digits
        message = str(error)
        if len(message) > 3 * LONGEST_SHOWN:  # it quotes a key
            message = f"{message[:LONGEST_SHOWN]} ... {message[-LONGEST_SHOWN:]}"
        faults.add(error_line(error), f"is not TOML: {message}")
    raise InputError(faults.found)


def _without(found: re.Match[str]) -> str:
    """What stands for a string or comment where dotted keys are looked for: as many lines, and a part for a part."""
    if found["lines"] is not None:
        return "=" + "\n" * found[0].count("\n")
    return "" if found["comment"] is not None else '""'


def complainer(text: str, faults: Faults) -> Callable[[KeyPath, str, str], None]:
    """What adds a fault at a key of a valid TOML text, with its line; the lines are looked up with the first fault."""
    lines: dict[KeyPath, int] = {}

    def complain(key: KeyPath, problem: str, remedy: str = "") -> None:
        if not lines:
            lines.update(key_lines(text))
        faults.add(place(key, lines) if key else "", problem, remedy)

    return complain


def key_lines(text: str) -> dict[KeyPath, int]:
    """First line (from 1) of every table and key of a valid TOML text, down to eight steps from the top.

    Keys and elements within a value have no line of their own: theirs is that of the key of the value, see `place`.
    """
    lines: dict[KeyPath, int] = {}
    last: dict[KeyPath, int] = {}  # index of the table that an array of tables ended with so far
    table: KeyPath = ()
    for line, brackets, parts in _statements(text.replace("\r\n", "\n")):
        path = () if brackets else table
        for part in parts:
            if path in last:
                path = (*path, last[path])
            path = (*path, part)
        if brackets == 2:
            last[path] = last.get(path, -1) + 1
        if brackets:
            table = path = (*path, last[path]) if path in last else path
        for length in range(1, min(len(path), _DEEPEST) + 1):
            lines.setdefault(path[:length], line)
    return lines


def _statements(text: str) -> Iterator[tuple[int, int, list[str]]]:
    """(line, brackets, parts of the key) of every header (1 bracket, or 2) and every key with a value (0)."""
    at, line = 0, 1
    while True:
        start = _end(_BLANK, text, at)
        line += text.count("\n", at, start)
        if start == len(text):
            return
        header = _HEADER.match(text, start)
        key = _KEY.match(text, header.end() if header else start)
        if key is None:
            raise ValueError(f"line {line} is no TOML")
        yield line, len(header[1]) if header else 0, _parts(key[0])
        at = _line_end(text, key.end())
        line += text.count("\n", start, at)


def _line_end(text: str, at: int) -> int:
    """Where the line ends that a value, or the rest of a header, ends in: brackets and strings may hold line ends."""
    depth = 0
    while at < len(text):
        found = _OF_VALUE.match(text, at)
        if found is None:
            raise ValueError("no TOML")
        if found["end"] and depth <= 0:
            return at
        depth += bool(found["open"]) - bool(found["close"])
        at = found.end()
    return at


def _end(pattern: re.Pattern[str], text: str, at: int) -> int:
    found = pattern.match(text, at)
    return found.end() if found else at


def _parts(key: str) -> list[str]:
    if '"' not in key and "'" not in key:
        return [part.strip() for part in key.split(".")]
    parts: list[str] = []
    node: Any = tomllib.loads(f"{key} = 0")
    while isinstance(node, dict):
        ((part, node),) = node.items()
        parts.append(part)
    return parts


def error_line(error: ValueError) -> str:
    """`line 12` out of what the TOML parser says of an error, empty where it does not say."""
    found = re.search(r"\(at (line \d+), column \d+\)", str(error))
    return found[1] if found else ""


def place(path: KeyPath, lines: dict[KeyPath, int]) -> str:
    """`line 12, key body[3].lower`; the line is that of the nearest key that exists."""
    name = ""
    for part in path:
        name += f"[{part}]" if isinstance(part, int) else (f".{_shown(part)}" if name else _shown(part))
    for length in range(len(path), 0, -1):
        if path[:length] in lines:
            return f"line {lines[path[:length]]}, key {name}"
    return f"key {name}"


def _shown(part: str) -> str:
    """A part of a key: as it is where it is short and printable."""
    short = part if len(part) <= LONGEST_SHOWN else f"{part[:LONGEST_SHOWN]} ..."
    return short if short.isprintable() else repr(short)
