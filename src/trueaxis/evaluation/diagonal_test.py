"""A diagonal test: positioning tests along the diagonals of one box or of one of its faces, and its figures.

A diagonal is named by a letter for each axis, X before Y before Z: p where the axis goes in its positive direction as
the targets grow, n where it goes in its negative direction. The figures are E, B, R and A of each diagonal, the
largest, scales, and squarenesses.

The text of ISO 230-6 was not at hand. Each diagonal is evaluated as an axis by the definitions of ISO 230-2; Ed and Bd
are the largest E and B. Scales and squarenesses are geometry, derived in `_by_geometry`.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.evaluation.positioning_test import Evaluation, FloatArray, PositioningTest, Repeatability, evaluate
from trueaxis.io.faults import Fault, InputError

# by the number of axes: each line in one of its two directions
DIAGONALS = {2: ("pp", "np"), 3: ("ppp", "npp", "pnp", "ppn")}
# Share by which targets may span another length than the diagonal: they are rounded, a length typed wrong differs more.
SAME_LENGTH = 1e-3
STANDARD = "ISO 230-6"


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


@dataclass(frozen=True, slots=True, kw_only=True)
class OfDiagonal:
    """evaluation: as of an axis, mm; scale: slope of the least-squares line through the mean bidirectional deviations;
    u_scale: its standard uncertainty by the scatter of the cycles, None with one cycle.
    """

    name: str
    evaluation: Evaluation
    scale: float
    u_scale: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Geometric:
    """A value that the scales of all diagonals give, and u as `OfDiagonal.u_scale`. of: axes, such as "XY"."""

    of: str
    value: float
    u: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class DiagonalFigures:
    """E_d, B_d: largest E and B of the diagonals, mm; scale_range: of their scales. Of all diagonals, else None and
    empty: scale: mean of their scales; squareness: angle between the positive axes less 90 deg, rad.
    """

    diagonals: tuple[OfDiagonal, ...]
    E_d: float
    B_d: float
    scale_range: float
    scale: Geometric | None
    squareness: tuple[Geometric, ...]


def diagonal_figures(test: DiagonalTest, repeatability: Repeatability = "iso") -> DiagonalFigures:
    """Evaluate the test; repeatability: as in `evaluate` of ISO 230-2."""
    every = tuple(_of_diagonal(name, one, repeatability) for name, one in test.tests.items())
    scales = [one.scale for one in every]
    scale, squareness = (None, ()) if test.missing else _by_geometry(test, every)
    return DiagonalFigures(
        diagonals=every,
        E_d=max(one.evaluation.E for one in every),
        B_d=max(one.evaluation.B for one in every),
        scale_range=max(scales) - min(scales),
        scale=scale,
        squareness=squareness,
    )


def _of_diagonal(name: str, test: PositioningTest, repeatability: Repeatability) -> OfDiagonal:
    lever = test.targets - test.targets.mean()
    deviations = 0.5 * (test.positive + test.negative) - test.targets[:, np.newaxis]
    slopes = lever @ deviations / (lever @ lever)  # of each cycle
    u = float(slopes.std(ddof=1) / np.sqrt(slopes.size)) if slopes.size > 1 else None
    return OfDiagonal(name=name, evaluation=evaluate(test, repeatability), scale=float(slopes.mean()), u_scale=u)


def _by_geometry(test: DiagonalTest, every: tuple[OfDiagonal, ...]) -> tuple[Geometric, tuple[Geometric, ...]]:
    """Mean scale and squarenesses of straight axes that do not rotate as they move: as many as there are diagonals.

    With the length of an axis l_i, its sign s_i, its scale e_i, the length D of the diagonal and squarenesses g_ij,
    positive where the angle is larger than 90 deg, D^2 times the scale of a diagonal is, to first order,
    sum l_i^2 e_i - sum over pairs s_i s_j l_i l_j g_ij. The first sum is the same for all diagonals.
    """
    lengths, square = np.array(list(test.lengths.values())), test.length**2
    pairs = list(combinations(range(lengths.size), 2))
    rows = []
    for one in every:
        sides = direction(one.name) * lengths
        rows.append([1.0, *(-sides[i] * sides[j] / square for i, j in pairs)])
    solution: FloatArray = np.linalg.inv(np.array(rows))
    values = solution @ np.array([one.scale for one in every])
    u_scales = [one.u_scale for one in every if one.u_scale is not None]
    u = np.sqrt(solution**2 @ np.square(u_scales)).tolist() if len(u_scales) == len(every) else [None] * len(every)
    axes = list(test.lengths)
    names = ["".join(axes), *(axes[i] + axes[j] for i, j in pairs)]
    scale, *squareness = (Geometric(of=of, value=float(v), u=own) for of, v, own in zip(names, values, u, strict=True))
    return scale, tuple(squareness)
