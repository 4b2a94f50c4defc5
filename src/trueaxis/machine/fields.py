"""Typed access to one table of a TOML file; what is wrong is complained of, and reading goes on."""

import math
import re
import reprlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from trueaxis.io.toml_lines import KeyPath

Complain = Callable[[KeyPath, str, str], None]

_LARGEST = 2**63 - 1  # TOML's whole numbers
_SHORT = reprlib.Repr()
_SHORT.maxstring = _SHORT.maxother = 60


def shown(value: Any) -> str:
    """A value as a message shows it: short, however long or deep it is."""
    try:
        return _SHORT.repr(value)
    except ValueError:  # Python writes no number of thousands of digits
        return "a number of thousands of digits"


@dataclass
class Fields:
    """A table at `path`. Each reader returns None (or nothing) after complaining of a wrong value."""

    raw: dict[str, Any]
    path: KeyPath
    complain: Complain
    known: set[str] = field(default_factory=set)

    def fault(self, key: str, problem: str, remedy: str = "") -> None:
        """Complain of one key of this table."""
        self.complain((*self.path, key), problem, remedy)

    def _take(self, key: str, required: bool, kind: str) -> Any:
        self.known.add(key)
        if key not in self.raw and required:
            self.complain((*self.path, key), "is missing", kind)
        return self.raw.get(key)

    def integer(self, key: str, default: int | None = None) -> int | None:
        """A whole number; required unless there is a default."""
        value = self._take(key, default is None, "a whole number")
        if value is None:
            return default
        if isinstance(value, bool) or not isinstance(value, int):
            self.fault(key, f"is {shown(value)}", "a whole number")
            return default
        if abs(value) > _LARGEST:
            self.fault(key, "is larger than any number of TOML", "a whole number")
            return default
        return value

    def text(self, key: str, default: str | None = None, pattern: str = "", meaning: str = "") -> str | None:
        """A text of one line, not empty; required unless there is a default."""
        value = self._take(key, default is None, "a text in quotes")
        if value is None:
            return default
        if not isinstance(value, str) or not value.strip():
            self.fault(key, f"is {shown(value)}", "a text in quotes")
            return default
        if not value.isprintable():
            self.fault(key, f"is {shown(value)}", "a text of one line without control characters")
            return default
        if pattern and not re.fullmatch(pattern, value):
            self.fault(key, f"is {shown(value)}", meaning)
        return value

    def choice(self, key: str, among: tuple[str, ...]) -> str | None:
        """One of a few texts, or absent."""
        value = self._take(key, False, "")
        if value is not None and value not in among:
            self.fault(key, f"is {shown(value)}", f"one of {' '.join(among)}, or left out")
            return None
        return value if isinstance(value, str) else None

    @staticmethod
    def finite(value: Any) -> float | None:
        """The value as a finite float, or None."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return None
        try:
            number = float(value)
        except OverflowError:
            return None
        return number if math.isfinite(number) else None

    def number(self, key: str, right: str) -> float | None:
        """A finite number that must be there; `right` says what would be right."""
        value = self._take(key, True, right)
        if value is None:
            return None
        read = self.finite(value)
        if read is None:
            self.fault(key, f"is {shown(value)}", right)
        return read

    def numbers(self, key: str, count: int, required: bool = False, also: str = "") -> tuple[float, ...] | None:
        """A list of so many finite numbers; also: what else is to be known of them."""
        right = f"a list of {count} finite numbers{also}"
        value = self._take(key, required, right)
        if value is None:
            return None
        read = [self.finite(part) for part in value] if isinstance(value, list) else []
        if len(read) != count or None in read:
            self.fault(key, f"is {shown(value)}", right)
            return None
        return tuple(number for number in read if number is not None)

    def texts(self, key: str, required: bool = False) -> tuple[str, ...] | None:
        """A list of different texts, one or more."""
        right = "a list of texts in quotes, each once"
        value = self._take(key, required, right)
        if value is None:
            return None
        if (
            not isinstance(value, list)
            or not value
            or not all(isinstance(part, str) and part.strip() and part.isprintable() for part in value)
            or len(set(value)) < len(value)
        ):
            self.fault(key, f"is {shown(value)}", right)
            return None
        return tuple(value)

    def flag(self, key: str) -> bool:
        """A switch; off where it is absent."""
        value = self._take(key, False, "")
        if value is not None and not isinstance(value, bool):
            self.fault(key, f"is {shown(value)}", "true or false")
        return value is True

    def table(self, key: str, required: bool = False) -> "Fields":
        """The sub-table of that key; an empty one where it is absent or no table."""
        value = self._take(key, required, f"a table [{key}]")
        if value is not None and not isinstance(value, dict):
            self.fault(key, f"is {shown(value)}", f"a table [{key}]")
        return Fields(value if isinstance(value, dict) else {}, (*self.path, key), self.complain)

    def tables(self, key: str, required: bool = False, most: int | None = None) -> Iterator["Fields"]:
        """The tables of an array [[key]], `most` of them where that is given."""
        value = self._take(key, required, f"one table [[{key}]] or more")
        if value is not None and not (isinstance(value, list) and all(isinstance(part, dict) for part in value)):
            self.fault(key, "is no array of tables", f"[[{key}]]")
            return
        if value is not None and most is not None and len(value) > most:
            self.fault(key, f"has {len(value)} tables", f"{most} at most")
            value = value[:most]
        for index, part in enumerate(value or []):
            yield Fields(part, (*self.path, key, index), self.complain)

    def refuse_others(self, allowed: str = "") -> None:
        """Complain of every key that no reader asked for."""
        for key in self.raw:
            if key not in self.known:
                self.fault(key, "is not a key of this table", f"allowed: {allowed or ', '.join(sorted(self.known))}")
