"""Nested records as a Python literal that a person reads: what fits a line stands on one, the rest is indented by 4."""

from collections.abc import Iterator

_WIDTH = 118
_STEP = 4


def literal(value: object, indent: int = 0, before: int = 0) -> str:
    """The literal of dicts, lists and scalars; before: columns taken on its first line by what leads to it."""
    flat = repr(value)
    if not isinstance(value, dict | list) or not value or max(indent, before) + len(flat) < _WIDTH:
        return flat
    pad = " " * (indent + _STEP)
    ends = "{}" if isinstance(value, dict) else "[]"
    if isinstance(value, list) and not any(isinstance(item, dict | list) for item in value):
        body = list(_filled(value, _WIDTH - len(pad)))
    else:
        items = value.items() if isinstance(value, dict) else (("", item) for item in value)
        body = [_entry(key, item, indent + _STEP) for key, item in items]
    inner = "\n".join(f"{pad}{line}" for line in body)
    return f"{ends[0]}\n{inner}\n{' ' * indent}{ends[1]}"


def _entry(key: object, item: object, indent: int) -> str:
    head = f"{key!r}: " if key else ""
    return f"{head}{literal(item, indent, indent + len(head) + 1)},"


def _filled(items: list[object], width: int) -> Iterator[str]:
    """As many items to a line as fit."""
    lines = [""]
    for item in items:
        text = f"{item!r},"
        if lines[-1] and len(lines[-1]) + 1 + len(text) > width:
            lines.append("")
        lines[-1] += f" {text}" if lines[-1] else text
    yield from lines
