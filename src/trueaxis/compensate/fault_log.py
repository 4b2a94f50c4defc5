"""Faults of a program: all counted, the first ones kept."""

from dataclasses import dataclass, field

from trueaxis.faults import Fault, Faults, InputError

KEPT = 49  # with the count of all, 50 messages


@dataclass(slots=True)
class FaultLog:
    """Gathers the faults of a program by line, keeping the text of the first `KEPT`: a program may be garbage
    of any length.
    """

    file: str
    count: int = 0
    kept: Faults = field(init=False)

    def __post_init__(self) -> None:
        self.kept = Faults(self.file)

    def add(self, line: int, problem: str, remedy: str = "") -> None:
        """Note a fault of one line (from 1; 0 for the program as a whole) and go on."""
        self.count += 1
        if self.count <= KEPT:
            self.kept.add(f"line {line}" if line else "", problem, remedy)

    def raise_if_any(self) -> None:
        """Raise InputError with the first faults and the number of the others, if there is any."""
        if not self.count:
            return
        found = list(self.kept.found)
        if self.count > KEPT:
            found.append(Fault(self.file, "", f"{self.count} faults in all; the first {KEPT} are shown"))
        raise InputError(found)
