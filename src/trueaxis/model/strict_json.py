"""JSON text to Python values, with what the standard parser lets pass noted as faults.

The standard parser keeps the last of two equal keys and accepts NaN and Infinity; both would change numbers in silence.
"""

import json
import math
from collections import Counter
from typing import Any

from trueaxis.io.faults import Faults

JsonPath = tuple[str | int, ...]


class _Object(dict[str, Any]):
    """A JSON object that remembers which of its keys came twice."""

    repeated: tuple[str, ...] = ()


def parse(text: str, faults: Faults) -> Any:
    """The parsed value; None, with a fault, where the text is no JSON. Repeated keys are noted with their paths."""
    try:
        tree = json.loads(text, object_pairs_hook=_object)
    except json.JSONDecodeError as error:
        faults.add(f"line {error.lineno}, column {error.colno}", f"is not JSON: {error.msg}")
        return None
    except RecursionError:
        faults.add("", "is nested too deeply")
        return None
    except ValueError:  # an integer of more digits than Python converts
        faults.add("", "has a number with too many digits")
        return None
    _note_repeated(tree, faults)
    return tree


def key_path(path: JsonPath) -> str:
    """`motion_errors.EXX.coefficients[2]`."""
    name = ""
    for part in path:
        name += f"[{part}]" if isinstance(part, int) else (f".{part}" if name else part)
    return name


def number(value: Any, path: JsonPath, faults: Faults) -> float:
    """A finite number; NaN, with a fault, where the value is none."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        faults.add(key_path(path), f"{shown(value)} is not a number")
        return math.nan
    try:
        converted = float(value)
    except OverflowError:
        converted = math.inf
    if not math.isfinite(converted):
        faults.add(key_path(path), "is not a finite number")
        return math.nan
    return converted


def numbers(value: Any, path: JsonPath, faults: Faults) -> tuple[float, ...]:
    """A list of finite numbers; empty, with a fault, where the value is no list."""
    if not isinstance(value, list):
        faults.add(key_path(path), f"{shown(value)} is not a list of numbers")
        return ()
    return tuple(number(item, (*path, index), faults) for index, item in enumerate(value))


def shown(value: Any) -> str:
    """A value as a fault quotes it: as JSON, shortened."""
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        return "a list"
    text = json.dumps(value)
    return text if len(text) <= 40 else f"{text[:36]} ..."


def _object(pairs: list[tuple[str, Any]]) -> _Object:
    found = _Object(pairs)
    if len(found) != len(pairs):
        counts = Counter(key for key, _ in pairs)
        found.repeated = tuple(key for key in found if counts[key] > 1)
    return found


def _note_repeated(tree: Any, faults: Faults) -> None:
    """In the order of the text, without recursion: newer Pythons parse deeper than they recurse."""
    waiting: list[tuple[Any, JsonPath]] = [(tree, ())]
    while waiting:
        node, path = waiting.pop()
        items: list[tuple[str | int, Any]] = []
        if isinstance(node, _Object):
            for key in node.repeated:
                faults.add(key_path((*path, key)), "is given more than once", "keep one")
            items = list(node.items())
        elif isinstance(node, list):
            items = list(enumerate(node))
        waiting += [(value, (*path, key)) for key, value in reversed(items) if isinstance(value, _Object | list)]


def two_levels(tree: dict[str, Any]) -> str:
    """JSON with a line per parameter and per curve: lists of coefficients stay on one line."""
    parts = []
    for key, value in tree.items():
        if isinstance(value, dict) and value:
            inner = ",\n".join(f"    {_flat(name)}: {_flat(item)}" for name, item in value.items())
            parts.append(f"  {_flat(key)}: {{\n{inner}\n  }}")
        elif isinstance(value, list) and value:
            inner = ",\n".join(f"    {_flat(item)}" for item in value)
            parts.append(f"  {_flat(key)}: [\n{inner}\n  ]")
        else:
            parts.append(f"  {_flat(key)}: {_flat(value)}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def _flat(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, allow_nan=False)
