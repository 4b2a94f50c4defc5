"""Lines of a .dat file as assignments. The file is data: nothing in it is ever evaluated."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from trueaxis.io.faults import Faults, InputError

MOST_FAULTS = 1000  # a file of another kind is wrong in every line

_ASSIGNMENT = re.compile(r"([A-Za-z_][A-Za-z0-9_]*)[ \t]*(?:\[([^\[\]]*)\][ \t]*)?=(.*)")
_INDEX = re.compile(r"[ \t]*([0-9]{1,9})[ \t]*")
_NUMBER = re.compile(r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?")


@dataclass(frozen=True, slots=True)
class Statement:
    """`NAME=value` or `NAME[i,j]=value` in a line; index is empty without brackets."""

    line: int
    name: str
    index: tuple[int, ...]
    value: str

    @property
    def place(self) -> str:
        """`line 12`."""
        return f"line {self.line}"

    @property
    def target(self) -> str:
        """What is assigned to: `REF_DATA_FWD[1,2]`."""
        return self.name + (f"[{','.join(map(str, self.index))}]" if self.index else "")


def statements(text: str, faults: Faults) -> Iterator[Statement]:
    """The assignments of a file in order; lines that are none are noted. `#` begins a comment, anywhere.

    Raises InputError once there are MOST_FAULTS faults, whoever noted them.
    """
    for number, line in enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1):
        if len(faults.found) >= MOST_FAULTS:
            faults.add(f"line {number}", "reading stopped here: too much is wrong")
            raise InputError(faults.found)
        content = line.partition("#")[0].strip()
        if not content:
            continue
        parts = _ASSIGNMENT.fullmatch(content)
        if parts is None:
            faults.add(f"line {number}", f"{shown(content)} is not an assignment", "NAME=value or NAME[i,j]=value")
            continue
        name, inside, value = parts.groups()
        index = _index(inside)
        if index is None:
            faults.add(f"line {number}", f"{shown(inside)} is not an index", "whole numbers from 1, as in [1] or [1,2]")
        else:
            yield Statement(number, name, index, value.strip())


def _index(inside: str | None) -> tuple[int, ...] | None:
    if inside is None:
        return ()
    parts = [_INDEX.fullmatch(part) for part in inside.split(",")]
    index = tuple(int(part[1]) for part in parts if part is not None)
    return index if len(index) == len(parts) and 0 not in index else None


def number(text: str) -> float | None:
    """A decimal number, None where the text is none; infinite where it is too large."""
    return float(text) if _NUMBER.fullmatch(text) else None


def whole_number(text: str) -> int | None:
    """A whole number of up to nine digits, None where the text is none."""
    found = _INDEX.fullmatch(text)
    return None if found is None else int(found[1])


def shown(text: str | None) -> str:
    """A piece of the file in quotes, shortened, with nothing a terminal would obey."""
    plain = (text or "").encode("unicode_escape").decode("ascii") if not (text or "").isprintable() else text or ""
    return f'"{plain if len(plain) <= 40 else plain[:36] + " ..."}"'
