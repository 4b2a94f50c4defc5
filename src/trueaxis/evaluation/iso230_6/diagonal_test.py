"""The readings of a diagonal test: positioning tests along the diagonals of one box or of one of its faces.

A diagonal is named by a letter for each axis: p where the axis goes in its positive direction as the targets grow, n
where it goes in its negative direction.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.evaluation.iso230_2.positioning_test import PositioningTest
from trueaxis.io.faults import Faults

# by the number of axes: each line in one of its two directions
DIAGONALS = {2: ("pp", "np"), 3: ("ppp", "npp", "pnp", "ppn")}
# Share by which targets may span another length than the diagonal: they are rounded, a length typed wrong differs more.
SAME_LENGTH = 1e-3


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagonalTest:
    """lengths: how far each axis goes along a diagonal, mm, by letter, two axes or three; tests: by name of the
    diagonal, such as "ppn", no line twice.
    """

    lengths: Mapping[str, float]
    tests: Mapping[str, PositioningTest]

    @property
    def length(self) -> float:
        """Of a diagonal, mm."""
        return math.hypot(*self.lengths.values())

    @property
    def missing(self) -> tuple[str, ...]:
        """Diagonals of the box or face that were not measured."""
        measured = {_line(name) for name in self.tests}
        return tuple(name for name in DIAGONALS[len(self.lengths)] if name not in measured)


def direction(name: str) -> np.ndarray:
    """(axes,): +1 where an axis goes in its positive direction, -1 where in its negative one."""
    return np.array([1.0 if letter == "p" else -1.0 for letter in name])


def diagonal_test(
    runs: Sequence[tuple[str, str, PositioningTest]], lengths: Mapping[str, float], source: str
) -> DiagonalTest:
    """The test that runs are. runs: file, name of the run and readings of each; its name ends with that of its
    diagonal.

    Raises InputError with every fault: no runs, names of no diagonal, one line twice, targets of another length.
    """
    faults, axes = Faults(source), len(lengths)
    found: dict[str, PositioningTest] = {}
    lines: dict[str, str] = {}
    length = math.hypot(*lengths.values())
    if not runs:
        faults.add("", "has no readings", "those of a diagonal or several")
    for file, run, test in runs:
        name = diagonal_of(run, axes)
        if name is None:
            meaning = f"for {', '.join(lengths)}: p goes in the positive direction, n in the negative one"
            right = f"a name that ends in {', '.join(DIAGONALS[axes])} ({meaning})"
            faults.add(f"run {run} ({file})", "does not say which diagonal it is", right)
            continue
        if (line := _line(name)) in lines:
            faults.add(f"run {run} ({file})", f"is of the same diagonal as {lines[line]}", "each diagonal once")
        lines.setdefault(line, f"{run} ({file})")
        span = float(np.ptp(test.targets))
        if abs(span - length) > SAME_LENGTH * length:
            given = ", ".join(f"{axis} {value:g}" for axis, value in lengths.items())
            faults.add(
                f"run {run} ({file})",
                f"its targets span {span:.7g} mm, a diagonal of {given} mm is {length:.7g} mm long",
                "how far each axis goes from the first target to the last",
            )
        found[name] = test
    faults.raise_if_any()
    return DiagonalTest(lengths=lengths, tests=found)


def diagonal_of(run: str, axes: int) -> str | None:
    """The diagonal that the end of a run's name says; None where it says none."""
    match = re.search(rf"(?:^|[^a-z])([pn]{{{axes}}})$", run.lower())
    return None if match is None else match[1]


def _line(name: str) -> str:
    """The same for both directions along one line."""
    return name if name in DIAGONALS[len(name)] else name.translate(str.maketrans("pn", "np"))
