"""The figures of a diagonal test: E, B, R and A of each diagonal, the largest, scales, and squarenesses.

The text of ISO 230-6 was not at hand. Each diagonal is evaluated as an axis by the definitions of ISO 230-2; Ed and Bd
are the largest E and B. Scales and squarenesses are geometry, derived in `_by_geometry`.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from trueaxis.evaluation.iso230_2.evaluation import Evaluation, Repeatability, evaluate
from trueaxis.evaluation.iso230_2.positioning_test import FloatArray, PositioningTest
from trueaxis.evaluation.iso230_6.diagonal_test import DiagonalTest, direction

STANDARD = "ISO 230-6"


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
