"""Faults of an input: gathered, so that a user sees all of them at once."""

from collections.abc import Iterable
from dataclasses import dataclass, field

LONGEST_PART = 1000  # characters of the place, the problem or the remedy of a fault, as a message shows it
_ENDS = 400, 200  # what is shown of a longer one: its first and its last characters


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing wrong with an input file.

    file: the file as the user named it; place: key, line or column within it (may be empty);
    problem: what is wrong; remedy: what would be right (may be empty).
    """

    file: str
    place: str
    problem: str
    remedy: str = ""

    def __str__(self) -> str:
        place, problem, remedy = map(_shown, (self.place, self.problem, self.remedy))
        where = f"{self.file}: {place}" if place else self.file
        return f"{where}: {problem}" + (f"; {remedy}" if remedy else "")


def _shown(text: str) -> str:
    """A text that may quote an input: of bounded length, and with nothing that a terminal would obey."""
    if len(text) > LONGEST_PART:
        text = f"{text[: _ENDS[0]]} ... {text[-_ENDS[1] :]}"
    if text.replace("\n", "").isprintable():
        return text
    return "".join(sign if sign.isprintable() or sign == "\n" else ascii(sign)[1:-1] for sign in text)


class InputError(ValueError):
    """Raised once an input has been read to its end and is wrong; carries every fault found."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults = tuple(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))


@dataclass(slots=True)
class Faults:
    """Collector of the faults of one file."""

    file: str
    found: list[Fault] = field(default_factory=list)

    def add(self, place: str, problem: str, remedy: str = "") -> None:
        """Note one fault and go on reading."""
        self.found.append(Fault(self.file, place, problem, remedy))

    def raise_if_any(self) -> None:
        """Raise InputError with everything noted so far, if anything was."""
        if self.found:
            raise InputError(self.found)
