"""Means and extremes of values that come in batches."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray

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
        size = np.abs(values[finite])
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
            self._line = int(lines[finite][worst])

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

    @property
    def shown(self) -> str:
        """The first lines, for people."""
        return ", ".join(map(str, self.first[:10])) + (" ..." if len(self.first) > 10 else "")

    def __str__(self) -> str:
        return f"{self.points} points, lines {self.shown}"


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
