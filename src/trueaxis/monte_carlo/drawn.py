"""What draws come to at each point, and where linear propagation says something else."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trueaxis.model.curves import FloatArray
from trueaxis.monte_carlo.tally import HIGH, LOW, Tally

COVERAGE = 1.959963984540054  # of a normal distribution: 95 % lie within so many standard deviations
SAMPLING = 3.0  # standard errors of a quantile, by which draws alone may miss it


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Drawn:
    """The distribution of error vectors at n points, mm. count: of draws; mean, sd, low, high: (4, n), of x, y, z and
    the length: mean, standard deviation, 2.5 % and 97.5 %; NaN where a value rests on what no reading determines.
    differing: (3, n), whether the linear 95 % interval of a coordinate is another to the accuracy that its u has;
    farthest: the largest distance between their ends, mm, 0 where none differs.
    """

    count: int
    mean: FloatArray
    sd: FloatArray
    low: FloatArray
    high: FloatArray
    differing: npt.NDArray[np.bool_]
    farthest: float


def drawn_of(tally: Tally, value: FloatArray, u: FloatArray) -> Drawn:
    """value, u: (3, n), mm, of linear propagation; u NaN where nothing determines it: no draws are given there."""
    low, high = tally.quantile(LOW), tally.quantile(HIGH)
    ends = np.abs([value - COVERAGE * u - low[:3], value + COVERAGE * u - high[:3]]).max(axis=0)
    standard_error = np.sqrt(LOW * HIGH / tally.count) / _density(COVERAGE) * tally.deviation[:3]
    differing = ends > tolerance(u) + SAMPLING * standard_error
    unknown = np.isnan(u).any(axis=0)
    mean, sd, low, high = (np.where(unknown, np.nan, one) for one in (tally.mean, tally.deviation, low, high))
    farthest = float(ends[differing].max(initial=0.0))
    return Drawn(
        count=tally.count, mean=mean, sd=sd, low=low, high=high, differing=differing & ~unknown, farthest=farthest
    )


def tolerance(u: FloatArray) -> FloatArray:
    """Half a unit of the last digit of u written with one digit (GUM Supplement 1, 7.9.2 and 8.1)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(u > 0.0, 0.5 * 10.0 ** np.floor(np.log10(u)), 1e-9))


def _density(x: float) -> float:
    return float(np.exp(-0.5 * x**2) / np.sqrt(2.0 * np.pi))
