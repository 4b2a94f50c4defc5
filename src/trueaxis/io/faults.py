"""Why there is no result: faults of an input, gathered, so that a user sees all at once; or the answer is no."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

from trueaxis.io.safe_text import shown


@dataclass(frozen=True, slots=True)
class Fault:
    """One thing wrong with an input file.

    file: the file as the user named it; place: key, line or column within it (may be empty);
    problem: what is wrong; remedy: what would be right (may be empty), with further lines where it shows
    the place. As text each part is one line, safe to show and cut to a length that can be read, whatever an input put
    into it.
    """

    file: str
    place: str
    problem: str
    remedy: str = ""

    def __str__(self) -> str:
        file, place, problem = (shown(part) for part in (self.file, self.place, self.problem))
        remedy = "\n".join(map(shown, self.remedy.split("\n")))
        where = f"{file}: {place}" if place else file
        return f"{where}: {problem}" + (f"; {remedy}" if remedy else "")


class InputError(ValueError):
    """Raised once an input has been read to its end and is wrong; carries every fault found, each once."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults = tuple(dict.fromkeys(faults))
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


class RefusedError(ValueError):
    """Nothing was written, as the command ends with exit code 1.

    reasons: a sentence each; where one names an option of the command, such as --max-u, it means the argument of that
    name, max_u. result: what was computed, to look at, of the class that the function returns.
    """

    def __init__(self, reasons: tuple[str, ...], result: Any) -> None:
        super().__init__("; ".join(reasons))
        self.reasons, self.result = reasons, result
