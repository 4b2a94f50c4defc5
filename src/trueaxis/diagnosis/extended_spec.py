"""The text of a machine spec with effects added: every byte of what a person wrote stays where it was.

Text is put in at places where it may belong, and the TOML parser says which of them is right: what is returned reads
as what was there and the effects, whatever the layout.
"""

import json
import os
import re
import tomllib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trueaxis.effects.kind import Effect
from trueaxis.machine import Machine

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern

_TOLD = "# Found by trueaxis diagnose."
_RUNS = re.compile(r"""^([ \t]*(?:runs|"runs"|'runs')[ \t]*=[ \t]*)("(?:[^"\\\n]|\\.)*"|'[^'\n]*')""", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Extended:
    """A machine with effects that were named. runs: whose systems are derived; spec, text: of its file."""

    machine: Machine
    runs: "tuple[RunPattern, ...]"
    spec: str
    text: str


def extended_spec(text: str, effects: Sequence[Effect]) -> str:
    """The spec with an [[effect]] table for each effect that it does not have yet.

    Tables come after the last line; where the spec has `effect = [{...}]`, they come into that list. Raises ValueError
    for a text that is no spec with a list of effects or none.
    """
    tree = tomllib.loads(text)
    there = tree.get("effect", [])
    if not (isinstance(there, list) and all(isinstance(table, dict) for table in there)):
        raise ValueError("effect is no array of tables")
    known = {_identity(table) for table in there}
    added: list[dict[str, Any]] = []
    for table in map(_table, effects):
        if _identity(table) not in known:
            known.add(_identity(table))
            added.append(table)
    if not added:
        return text
    return _that_reads(tree | {"effect": [*there, *added]}, (_appended(text, added), *_inserted(text, added)))


def moved_spec(text: str, source: Path, target: Path) -> str:
    """The spec, written for the folder `source`, as it must read in `target`: its `runs` lead to where they led.

    Raises ValueError for a text that is no spec, or whose `runs` are no text of one line.
    """
    tree = tomllib.loads(text)
    runs = tree.get("runs")
    if runs is None or (target / runs).resolve() == (source / runs).resolve():
        return text
    folder = (source / runs).resolve()
    try:
        path = Path(os.path.relpath(folder, target.resolve()))
    except ValueError:  # another drive
        path = folder
    value = _quoted(path.as_posix())
    texts = (f"{text[: found.end(1)]}{value}{text[found.end() :]}" for found in _RUNS.finditer(text))
    return _that_reads(tree | {"runs": path.as_posix()}, texts)


def _that_reads(wanted: dict[str, Any], texts: Iterator[str] | Sequence[str]) -> str:
    for text in texts:
        try:
            if tomllib.loads(text) == wanted:
                return text
        except tomllib.TOMLDecodeError:
            continue
    raise ValueError("the spec cannot be changed in place")


def _table(effect: Effect) -> dict[str, Any]:
    table: dict[str, Any] = {"kind": effect.kind}
    for key in ("component", "axis", "end"):
        value = getattr(effect, key)
        if value is not None:
            table[key] = value
    if effect.runs:
        table["runs"] = list(effect.runs)
    return table


def _identity(table: dict[str, Any]) -> tuple[Any, ...]:
    """What makes two tables one effect: the order of runs and an end that goes without saying do not count."""
    runs = frozenset(table.get("runs", ()))
    return table.get("kind"), table.get("component"), table.get("axis"), runs, table.get("end", "target")


def _appended(text: str, added: Sequence[dict[str, Any]]) -> str:
    blocks = ["\n".join(["[[effect]]", *(f"{key} = {_value(value)}" for key, value in one.items())]) for one in added]
    lines = "\n\n".join([f"{_TOLD}\n{blocks[0]}", *blocks[1:]])
    newline = "\r\n" if "\r\n" in text else "\n"
    gap = "\n" if not text or text.endswith("\n") else "\n\n"
    return text + f"{gap}{lines}\n".replace("\n", newline)


def _inserted(text: str, added: Sequence[dict[str, Any]]) -> Iterator[str]:
    """The text with inline tables before each bracket that may close the list, as its first or further ones."""
    tables = [f"{{ {', '.join(f'{key} = {_value(value)}' for key, value in one.items())} }}" for one in added]
    for found in re.finditer(r"\]", text):
        before = len(text[: found.start()].rstrip())
        for place in (before, found.start()):  # the former may stand in a comment
            for separator in (", ", "" if text[:place].endswith("[") else " "):
                yield f"{text[:place]}{separator}{', '.join(tables)}{text[place:]}"


def _value(value: str | list[str]) -> str:
    return _quoted(value) if isinstance(value, str) else f"[{', '.join(map(_quoted, value))}]"


def _quoted(text: str) -> str:
    """A basic string of TOML: as in JSON, but for DEL."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
