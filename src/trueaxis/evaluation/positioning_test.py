"""A bidirectional positioning test: its readings, and its figures by ISO 230-2:2014, coverage factor k = 2.

The definitions of clause 3 are those of linear and rotary axes alike, in mm or deg. Axes beyond 2000 mm or 360 deg may
be tested with one approach of each target in each direction; repeatability and accuracy are not estimated then (6.2;
its text as in GOST ISO 230-2-2016, which is a translation of the standard).
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

MOST_TARGETS, MOST_CYCLES = 2000, 1000  # more is a table whose columns are confused
FARTHEST_TARGET = 1e5  # mm
FEWEST_CYCLES = 2  # of an axis up to its longest; of a diagonal 1, which gives no R and A
LARGEST_DEVIATION = 10.0  # mm: beyond it target and reading are not in one unit, or not of one position

Unit = Literal["mm", "deg"]  # of a linear axis, of a rotary one
# Beyond it the standard tests an axis otherwise: one approach of each target and direction suffices (6.2).
LONGEST_AXIS: dict[Unit, float] = {"mm": 2000.0, "deg": 360.0}
Repeatability = Literal["iso", "unidirectional"]

STANDARD = "ISO 230-2:2014"
COVERAGE_FACTOR = 2
STANDARD_TARGETS, STANDARD_CYCLES = 5, 5
TARGETS_PER_METRE = 5
SINGLE = "clause 6.2: one approach, with B, E and M alone"
EVEN = 1e-6  # of a step: rounding of evenly spaced targets


@dataclass(frozen=True, slots=True)
class PositioningTest:
    """Targets P_i, (m,), and the positions P_ij measured there, (m, n), by direction of approach; mm or deg (`unit`).

    positive: approached in the positive direction of the axis (the standard's upward arrow); negative: in the
    negative one. m targets, at least 2; n cycles, at least 2, of axes beyond LONGEST_AXIS 1. Every value is finite.
    """

    targets: FloatArray
    positive: FloatArray
    negative: FloatArray
    unit: Unit = "mm"

    def swapped(self) -> "PositioningTest":
        """The same readings where the labels of direction were the wrong way round."""
        return replace(self, positive=self.negative, negative=self.positive)


def too_few(what: str, count: int, span: float = 0.0, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> str:
    """What is wrong with this many targets or cycles; empty where there are enough. span: of the targets, in `unit`."""
    single = fewest_cycles == 1 or span > LONGEST_AXIS[unit]
    if count >= 2 or (what == "cycle" and count == 1 and single):
        return ""
    return f"has {count} {what}{'' if count == 1 else 's'}: an evaluation needs at least 2, the standard's test 5"


@dataclass(frozen=True, slots=True, kw_only=True)
class Unidirectional:
    """One direction of approach; mm or deg throughout, arrays (m,) over the targets; NaN where one approach tells
    nothing.

    mean: mean deviation; s: estimator of the standard uncertainty of positioning; r: repeatability R_i = 4 s_i;
    R: repeatability of the axis; E: systematic deviation of the axis; A: accuracy of the axis.
    """

    mean: FloatArray
    s: FloatArray
    r: FloatArray
    R: float
    E: float
    A: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Evaluation:
    """The parameters of the standard; mm or deg (`unit`) throughout, arrays (m,) over the targets. R, r, s, A: NaN of a
    test with one cycle.

    targets: P_i; cycles: n; mean: mean bidirectional deviation; b: reversal value B_i, positive approach minus
    negative; r: bidirectional repeatability R_i. Of the axis: B reversal value, B_mean mean reversal value (signed),
    R repeatability by the convention `repeatability`, E systematic deviation, M range of the mean bidirectional
    deviation, A accuracy.
    """

    targets: FloatArray
    cycles: int
    positive: Unidirectional
    negative: Unidirectional
    mean: FloatArray
    b: FloatArray
    r: FloatArray
    B: float
    B_mean: float
    R: float
    E: float
    M: float
    A: float
    repeatability: Repeatability
    unit: Unit = "mm"


def evaluate(test: PositioningTest, repeatability: Repeatability = "iso") -> Evaluation:
    """Evaluate the test. Source: ISO 230-2:2014, clause 3.

    repeatability: `iso`, the standard's R = max R_i with R_i = max(2 s_i+ + 2 s_i- + |B_i|, R_i+, R_i-), which holds
    the reversal; or `unidirectional`, R = max(R+, R-), which some programs report under the same name.
    """
    positive = _unidirectional(test.positive - test.targets[:, None])
    negative = _unidirectional(test.negative - test.targets[:, None])
    mean = (positive.mean + negative.mean) / 2
    b = positive.mean - negative.mean
    spread = COVERAGE_FACTOR * (positive.s + negative.s) + np.abs(b)
    r = np.maximum(spread, np.maximum(positive.r, negative.r))
    means = np.concatenate([positive.mean, negative.mean])
    s = np.concatenate([positive.s, negative.s])
    return Evaluation(
        targets=test.targets,
        cycles=test.positive.shape[1],
        positive=positive,
        negative=negative,
        mean=mean,
        b=b,
        r=r,
        B=float(np.abs(b).max()),
        B_mean=float(b.mean()),
        R=float(r.max()) if repeatability == "iso" else max(positive.R, negative.R),
        E=float(np.ptp(means)),
        M=float(np.ptp(mean)),
        A=_accuracy(means, s),
        repeatability=repeatability,
        unit=test.unit,
    )


def departures(evaluation: Evaluation) -> list[str]:
    """In what the test is less than the standard asks of a linear axis up to 2000 mm, and of the cycles of any axis up
    to its longest; empty where it is not. Of targets of rotary axes nothing is said: their number is not known to us
    from a public text.
    """
    m, span = len(evaluation.targets), float(np.ptp(evaluation.targets))
    longest, unit = LONGEST_AXIS[evaluation.unit], evaluation.unit
    found = []
    if evaluation.cycles == 1:
        return [f"one approach of each target and direction on {span:g} {unit}: R and A are not estimated ({SINGLE})"]
    if unit == "deg":
        pass
    elif m < STANDARD_TARGETS:
        found.append(f"{m} targets; the standard asks at least {STANDARD_TARGETS}")
    elif m < TARGETS_PER_METRE * span / 1000 and span <= longest:
        found.append(f"{m} targets on {span:g} mm; the standard asks at least {TARGETS_PER_METRE} per metre")
    if evaluation.cycles < STANDARD_CYCLES:
        found.append(f"{evaluation.cycles} cycles; the standard asks {STANDARD_CYCLES}")
    steps = np.diff(np.sort(evaluation.targets))
    if unit == "mm" and m > 2 and np.ptp(steps) <= EVEN * steps.max():
        found.append("targets are evenly spaced; the standard spaces them unevenly, lest periodic errors hide")
    if span > longest:
        found.append(
            f"targets span {span:g} {unit}; the standard tests axes beyond {longest:g} {unit} otherwise: {SINGLE}"
        )
    return found


def _unidirectional(deviations: FloatArray) -> Unidirectional:
    """deviations: x_ij, (m, n) mm."""
    mean = deviations.mean(axis=1)
    s = deviations.std(axis=1, ddof=1) if deviations.shape[1] > 1 else np.full(mean.size, np.nan)
    r = 2 * COVERAGE_FACTOR * s
    return Unidirectional(mean=mean, s=s, r=r, R=float(r.max()), E=float(np.ptp(mean)), A=_accuracy(mean, s))


def _accuracy(mean: FloatArray, s: FloatArray) -> float:
    return float((mean + COVERAGE_FACTOR * s).max() - (mean - COVERAGE_FACTOR * s).min())
