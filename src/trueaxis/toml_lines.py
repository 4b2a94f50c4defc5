"""Where a key of a TOML file stands: the standard parser reports values without positions."""

import re
import tomllib
from collections.abc import Iterator
from typing import Any

KeyPath = tuple[str | int, ...]

_DEEPEST = 8  # keys of files that people write; dotted keys nest as deep as they are long


def key_lines(text: str) -> dict[KeyPath, int]:
    """First line (from 1) of every key path in a valid TOML text, down to eight steps from the top.

    The text is parsed anew after each line: a key belongs to the stretch of lines after whose end it is first
    seen, and that stretch begins on the line after the previous valid prefix. Costs O(lines^2), so it is called
    only when a fault is to be reported.
    """
    lines = [f"{line}\n" for line in text.split("\n")]  # TOML knows no other end of a line
    found: dict[KeyPath, int] = {}
    start = 1
    for count in range(1, len(lines) + 1):
        try:
            tree = tomllib.loads("".join(lines[:count]))
        except tomllib.TOMLDecodeError:
            continue  # inside a value that spans lines
        for path in _paths(tree):
            found.setdefault(path, start)
        start = count + 1
    return found


def error_line(error: ValueError) -> str:
    """`line 12` out of what the TOML parser says of an error, empty where it does not say."""
    found = re.search(r"\(at (line \d+), column \d+\)", str(error))
    return found[1] if found else ""


def _paths(tree: Any) -> Iterator[KeyPath]:
    waiting: list[tuple[KeyPath, Any]] = [((), tree)]
    while waiting:
        prefix, node = waiting.pop()
        if prefix:
            yield prefix
        if len(prefix) == _DEEPEST:
            continue
        if isinstance(node, dict):
            waiting += [((*prefix, key), value) for key, value in node.items()]
        elif isinstance(node, list):
            waiting += [((*prefix, index), value) for index, value in enumerate(node)]


def place(path: KeyPath, lines: dict[KeyPath, int]) -> str:
    """`line 12, key body[3].lower`; the line is that of the nearest key that exists."""
    name = ""
    for part in path:
        name += f"[{part}]" if isinstance(part, int) else (f".{part}" if name else part)
    for length in range(len(path), 0, -1):
        if path[:length] in lines:
            return f"line {lines[path[:length]]}, key {name}"
    return f"key {name}"
