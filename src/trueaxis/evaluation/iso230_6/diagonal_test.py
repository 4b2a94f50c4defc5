"""The readings of a diagonal test: positioning tests along the diagonals of one box or of one of its faces.

A diagonal is named by a letter for each axis, X before Y before Z: p where the axis goes in its positive direction as
the targets grow, n where it goes in its negative direction.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.evaluation.iso230_2.positioning_test import PositioningTest
from trueaxis.io.faults import Fault, InputError

# by the number of axes: each line in one of its two directions
DIAGONALS = {2: ("pp", "np"), 3: ("ppp", "npp", "pnp", "ppn")}
# Share by which targets may span another length than the diagonal: they are rounded, a length typed wrong differs more.
SAME_LENGTH = 1e-3


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagonalTest:
    """lengths: how far each axis goes along a diagonal, mm, by letter in their order, two axes or three; tests: by name
    of the diagonal, such as "ppn", no line twice.
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
    diagonal, whose letters are of the axes in alphabetical order, whichever order the lengths have.

    Raises InputError with every fault: no runs, names of no diagonal, one line twice, targets of another length.
    """
    lengths = dict(sorted(lengths.items()))
    axes, faults = len(lengths), list[Fault]()
    found: dict[str, PositioningTest] = {}
    lines: dict[str, str] = {}
    if not runs:
        faults.append(Fault(source, "", "has no readings", "those of a diagonal or several"))
    for file, run, test in runs:
        if problem := _off_length(test, lengths):
            faults.append(
                Fault(file, f"run {run}", problem, "how far each axis goes from the first target to the last")
            )
        name = diagonal_of(run, axes)
        if name is None:
            meaning = f"for {', '.join(lengths)}: p goes in the positive direction, n in the negative one"
            right = f"a name that ends in {', '.join(DIAGONALS[axes])} ({meaning})"
            faults.append(Fault(file, f"run {run}", "does not say which diagonal it is", right))
            continue
        if (line := _line(name)) in lines:
            faults.append(Fault(file, f"run {run}", f"is of the same diagonal as {lines[line]}", "each diagonal once"))
        lines.setdefault(line, f"{run} ({file})")
        found[name] = test
    if faults:
        raise InputError(faults)
    return DiagonalTest(lengths=lengths, tests=found)


def _off_length(test: PositioningTest, lengths: Mapping[str, float]) -> str:
    """What is wrong with the length over which a test goes; empty where it is that of a diagonal."""
    length, span = math.hypot(*lengths.values()), float(np.ptp(test.targets))
    if abs(span - length) <= SAME_LENGTH * length:
        return ""
    given = ", ".join(f"{axis} {value:g}" for axis, value in lengths.items())
    return f"its targets span {span:.7g} mm, a diagonal of {given} mm is {length:.7g} mm long"


def diagonal_of(run: str, axes: int) -> str | None:
    """The diagonal that the end of a run's name says; None where it says none."""
    match = re.search(rf"(?:^|[^a-z])([pn]{{{axes}}})$", run.lower())
    return None if match is None else match[1]


def _line(name: str) -> str:
    """The same for both directions along one line."""
    return name if name in DIAGONALS[len(name)] else name.translate(str.maketrans("pn", "np"))
