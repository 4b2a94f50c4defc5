"""Faults of a program: all counted, the first ones kept."""

from dataclasses import dataclass, field

from trueaxis.io.faults import Fault, InputError

KEPT = 49  # with the count of all, 50 messages


@dataclass(slots=True)
class FaultLog:
    """Gathers the faults of a program by line, keeping the text of the first `KEPT` found: a program may be garbage
    of any length. unplaced: the first line from which on it is not known where the work offset's zero is, and so no
    position; None where that is known throughout.
    """

    file: str
    count: int = 0
    kept: list[tuple[int, Fault]] = field(default_factory=list)
    unplaced: int | None = None

    def add(self, line: int, problem: str, remedy: str = "") -> None:
        """Note a fault of one line (from 1; 0 for the program as a whole) and go on."""
        self.count += 1
        if self.count <= KEPT:
            self.kept.append((line, Fault(self.file, f"line {line}" if line else "", problem, remedy)))

    def add_unplaced(self, line: int, problem: str, remedy: str) -> None:
        """Note a fault from which on positions are not known: what they would be is no fault of its own."""
        self.add(line, problem, remedy)
        self.unplaced = line if self.unplaced is None else min(line, self.unplaced)

    def raise_if_any(self) -> None:
        """Raise InputError with the kept faults in the order of lines, and the number of all if there are more."""
        if not self.count:
            return
        found = [fault for _, fault in sorted(self.kept, key=lambda entry: entry[0])]
        if self.count > KEPT:
            found.append(Fault(self.file, "", f"{self.count} faults in all; the first {KEPT} are shown"))
        raise InputError(found)
