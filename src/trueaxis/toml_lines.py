"""Where a key of a TOML file stands: the standard parser reports values without positions."""

import tomllib
from collections.abc import Iterator
from typing import Any

KeyPath = tuple[str | int, ...]


def key_lines(text: str) -> dict[KeyPath, int]:
    """First line (from 1) of every key path in a valid TOML text.

    The text is parsed anew after each line: a key belongs to the stretch of lines after whose end it is first
    seen, and that stretch begins on the line after the previous valid prefix. Costs O(lines^2), so it is called
    only when a fault is to be reported.
    """
    lines = text.splitlines(keepends=True)
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


def _paths(node: Any, prefix: KeyPath = ()) -> Iterator[KeyPath]:
    if prefix:
        yield prefix
    if isinstance(node, dict):
        for key, value in node.items():
            yield from _paths(value, (*prefix, key))
    elif isinstance(node, list):
        for index, value in enumerate(node):
            yield from _paths(value, (*prefix, index))


def place(path: KeyPath, lines: dict[KeyPath, int]) -> str:
    """`line 12, key body[3].lower`; the line is that of the nearest key that exists."""
    name = ""
    for part in path:
        name += f"[{part}]" if isinstance(part, int) else (f".{part}" if name else part)
    for length in range(len(path), 0, -1):
        if path[:length] in lines:
            return f"line {lines[path[:length]]}, key {name}"
    return f"key {name}"
