"""What is gathered while a program is read: faults, the first ones kept, lines, means and extremes of values."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import LINEAR, ROTARY, FloatArray
from trueaxis.compensation.nc.mistyped import Slip, Slips
from trueaxis.io.faults import Fault, InputError

LINES_KEPT = 50


@dataclass(frozen=True, slots=True, kw_only=True)
class Summary:
    """Mean, standard deviation (of the population), largest value and the line it stands in.

    The unit is that of the values.
    """

    count: int
    mean: float
    sd: float
    largest: float
    line: int


class Running:
    """Gathers the magnitudes of values; the mean is of what is seen, whatever the size of the batches."""

    def __init__(self) -> None:
        self._count = 0
        self._mean = 0.0
        self._square = 0.0  # sum of squares about the mean
        self._largest = 0.0
        self._line = 0

    def add(self, values: FloatArray, lines: NDArray[np.int64]) -> None:
        """Take in the absolute values that are finite, with their lines."""
        finite = np.isfinite(values)
        if not finite.all():
            values, lines = values[finite], lines[finite]
        size = np.abs(values)
        if size.size == 0:
            return
        mean = float(size.mean())
        total = self._count + size.size
        apart = mean - self._mean
        self._square += float(((size - mean) ** 2).sum()) + apart * apart * self._count * size.size / total
        self._mean += apart * size.size / total
        self._count = total
        worst = int(np.argmax(size))
        if size[worst] > self._largest or not self._line:
            self._largest = float(size[worst])
            self._line = int(lines[worst])

    def summary(self) -> Summary | None:
        """What was seen; None if nothing was."""
        if not self._count:
            return None
        sd = float(np.sqrt(self._square / self._count))
        return Summary(count=self._count, mean=self._mean, sd=sd, largest=self._largest, line=self._line)


@dataclass(frozen=True, slots=True)
class Lines:
    """Lines with something in common: how many points, and the first lines."""

    points: int
    first: tuple[int, ...]


class LineLog:
    """Gathers lines, keeping the first `LINES_KEPT` different ones."""

    def __init__(self) -> None:
        self._points = 0
        self._first: list[int] = []

    def add(self, lines: NDArray[np.int64]) -> None:
        """Take in the lines of some points, ascending."""
        self._points += int(lines.size)
        if lines.size and len(self._first) < LINES_KEPT:
            for line in np.unique(lines).tolist():
                if line not in self._first and len(self._first) < LINES_KEPT:
                    self._first.append(line)

    def lines(self) -> Lines:
        """What was seen."""
        return Lines(self._points, tuple(self._first))


class TravelLog(LineLog):
    """Gathers lines of points beyond the travel, and how far beyond each axis would be."""

    def __init__(self, axes: Sequence[str]) -> None:
        super().__init__()
        self._axes, self._farthest = axes, np.zeros(len(axes))

    def beyond(self, lines: NDArray[np.int64], beyond: FloatArray) -> None:
        """Take in the lines of some points, ascending, and (n_axes, n), mm or deg."""
        self.add(lines)
        self._farthest = np.maximum(self._farthest, np.abs(beyond).max(axis=1, initial=0.0))

    def farthest(self) -> dict[str, float]:
        """The largest of the axes that were beyond, mm or deg."""
        return {axis: far for axis, far in zip(self._axes, self._farthest.tolist(), strict=True) if far > 0.0}


KEPT = 49  # with the count of all, 50 messages


@dataclass(slots=True, kw_only=True)
class Undotted:
    """Blocks with numbers without a decimal point that may count two lengths: how many, the lines of the first `KEPT`,
    and the letters of all.
    """

    blocks: int = 0
    first: list[int] = field(default_factory=list)
    letters: set[str] = field(default_factory=set)

    def add(self, line: int, letters: set[str]) -> None:
        """Take in a block."""
        self.blocks += 1
        self.letters |= letters
        if self.blocks <= KEPT:
            self.first.append(line)

    @property
    def _example(self) -> str:
        """What a number with one of the letters may count."""
        letter = min(self.letters, key=lambda one: (one not in LINEAR, one in ROTARY, one))
        unit = "deg" if letter in ROTARY else "mm"
        return f"{letter}100 is 100 {unit} on some controls and 0.1 {unit} on others"

    def faults(self, file: str) -> Iterator[Fault]:
        """One for all blocks: one option says what all the numbers count."""
        if self.blocks:
            more = f" and {self.blocks - KEPT} more" if self.blocks > KEPT else ""
            yield Fault(
                file,
                f"line{'s' * (self.blocks > 1)} {', '.join(map(str, self.first))}{more}",
                f"{' '.join(sorted(self.letters))} without a decimal point: {self._example}",
                "say --integers mm (or inch, deg) or --integers least-increment (0.001 mm, 0.0001 inch, 0.001 deg)",
            )


@dataclass(slots=True, kw_only=True)
class FaultLog:
    """Gathers the faults of a program by line, keeping the text of the first `KEPT` found: a program may be garbage
    of any length. unplaced: the first line from which on positions are not known, as it is not where the work offset's
    zero is; None where they are known throughout. macros: blocks with macros and the like. undotted: one fault, whose
    text is made once all its blocks are known. reach: lowest and highest position of each axis by letter; outside: how
    many blocks take it out of its travel. placed: whether a work offset was in force anywhere, or none is
    needed; by_tip: whether tool centre point control was on, so that a shift of the program is none of its axes;
    mistyped: how many blocks hold mistyped numbers of each kind; first_mistyped: the first of them.
    """

    file: str
    count: int = 0
    kept: list[tuple[int, Fault]] = field(default_factory=list)
    unplaced: int | None = None
    macros: int = 0
    undotted: Undotted = field(default_factory=Undotted)
    reach: dict[str, tuple[float, float]] = field(default_factory=dict)
    outside: Counter[str] = field(default_factory=Counter)
    placed: bool = False
    by_tip: bool = False
    mistyped: Counter[Slip] = field(default_factory=Counter)
    first_mistyped: dict[Slip, Fault] = field(default_factory=dict)

    @property
    def broken(self) -> bool:
        """Whether there are faults that may leave moves out: those of the travel do not."""
        return self.count > self.outside.total()

    def add(self, line: int, problem: str, remedy: str = "") -> None:
        """Note a fault of one line (from 1; 0 for the program as a whole) and go on."""
        self.count += 1
        if self.count <= KEPT:
            self.kept.append((line, Fault(self.file, f"line {line}" if line else "", problem, remedy)))

    def add_option(self, option: str, problem: str) -> None:
        """Note a fault of an option, if there is a problem, beside those of the program."""
        if problem:
            self.count += 1
            self.kept.append((0, Fault(option, "", problem)))

    def add_unplaced(self, line: int, problem: str, remedy: str) -> None:
        """Note a fault from which on positions are not known: what they would be is no fault of its own."""
        self.add(line, problem, remedy)
        self._unplace(line)

    def add_mistyped(self, line: int, slips: Slips) -> None:
        """Note the mistyped numbers of a block, if it has some."""
        if slips.problem:
            self.add(line, slips.problem)
            self.mistyped.update(slips.kinds)
            for kind in slips.kinds:
                self.first_mistyped.setdefault(kind, Fault(self.file, f"line {line}", slips.problem))

    def add_undotted(self, line: int, letters: set[str]) -> None:
        """Note a block whose numbers may count two lengths: all such blocks are one fault."""
        self.count += not self.undotted.blocks
        self.undotted.add(line, letters)
        self._unplace(line)

    def _unplace(self, line: int) -> None:
        self.unplaced = line if self.unplaced is None else min(line, self.unplaced)

    def raise_if_any(self, first: Sequence[Fault] = ()) -> None:
        """Raise InputError with the kept faults in the order of lines, and the number of all if there are more; first:
        what is said before them, and a few of them make room for.
        """
        if not self.count:
            return
        shown = KEPT - len(first) if self.count > KEPT else KEPT
        by_line = sorted(self.kept, key=lambda entry: entry[0])[:shown]
        found = [*first, *self.undotted.faults(self.file), *(fault for _, fault in by_line)]
        if self.count > KEPT:
            found.append(Fault(self.file, "", f"{self.count} faults in all; the first {shown} are shown"))
        raise InputError(found)
