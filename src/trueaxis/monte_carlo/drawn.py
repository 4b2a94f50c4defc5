"""What draws come to at each point, in memory that does not grow with the draws, and where linear propagation differs.

Of each point there are mean, standard deviation and quantiles, and the columns of a table.

A frequency distribution on fixed bins stands for the draws. The
quantiles at 2.5 % and 97.5 % of any distribution lie within sqrt(39) = 6.2 standard deviations of its mean (Cantelli's
inequality), so that bins over `REACH` of a first sample's standard deviations hold them, and within a bin of 1/32
standard deviation a density is as good as even.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from trueaxis.model.curves import FloatArray

COVERAGE = 1.959963984540054  # of a normal distribution: 95 % lie within so many standard deviations
SAMPLING = 3.0  # standard errors of a quantile, by which draws alone may miss it
QUANTITIES = ("dx", "dy", "dz", "length")
STATISTICS = ("mean", "sd", "low", "high", "apart")
LOW, HIGH = 0.025, 0.975
REACH = 10.0
BINS = 640
LEAST_WIDTH = 1e-12  # mm, half of the range: of a point that no draw moves
Counts = npt.NDArray[np.uint16] | npt.NDArray[np.uint32]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Drawn:
    """The distribution of error vectors at n points, mm. count: of draws; mean, sd, low, high: (4, n), of x, y, z and
    the length: mean, standard deviation, 2.5 % and 97.5 %. apart: (3, n), largest distance between the ends of this
    95 % interval of a coordinate and of the linear one, 0 where they agree to the accuracy that u has. NaN where a
    value rests on what no reading determines.
    """

    count: int
    mean: FloatArray
    sd: FloatArray
    low: FloatArray
    high: FloatArray
    apart: FloatArray

    @property
    def differing(self) -> npt.NDArray[np.bool_]:
        """(3, n): whether the linear 95 % interval of a coordinate is another."""
        return self.apart > 0.0

    @classmethod
    def joined(cls, parts: "Sequence[Drawn]") -> "Drawn":
        """Points of several, one behind the other, of as many draws each."""
        arrays = {name: np.hstack([getattr(part, name) for part in parts]) for name in STATISTICS}
        return cls(count=parts[0].count, **arrays)


@dataclass(frozen=True, slots=True, eq=False)
class Bins:
    """Of each of k quantities at n points: centre and half width of the range, (k, n)."""

    centre: FloatArray
    half: FloatArray

    @classmethod
    def of_sample(cls, sample: FloatArray) -> "Bins":
        """For quantities like those of a first sample (draws, k, n)."""
        half = np.maximum(REACH * sample.std(axis=0), LEAST_WIDTH)
        return cls(sample.mean(axis=0), half)


class Tally:
    """Adds up draws. count: of draws; mean, squares: (k, n), sum of squares about the mean; bins: counts (k, n, BINS +
    2), the first and the last beyond the range.
    """

    def __init__(self, bins: Bins, dtype: type[np.uint16] | type[np.uint32] = np.uint32) -> None:
        self.bins = bins
        self.count = 0
        self.mean, self.squares = np.zeros_like(bins.centre), np.zeros_like(bins.centre)
        self.counts: Counts = np.zeros((*bins.centre.shape, BINS + 2), dtype=dtype)

    def add(self, values: FloatArray) -> None:
        """Draws (m, k, n)."""
        mean = values.mean(axis=0)
        self._join(values.shape[0], mean, ((values - mean) ** 2).sum(axis=0))
        scaled = (values - self.bins.centre + self.bins.half) * (BINS / (2.0 * self.bins.half))
        place = np.clip(np.floor(scaled), -1.0, BINS).astype(np.int64) + 1
        rows = np.arange(self.bins.centre.size).reshape(self.bins.centre.shape) * (BINS + 2)
        one = self.counts.dtype.type(1)  # of another type it would take twenty times as long
        np.add.at(self.counts.reshape(-1), (place + rows).ravel(), one)

    def merge(self, other: "Tally") -> None:
        """Draws that another tally of the same bins has added up."""
        self._join(other.count, other.mean, other.squares)
        self.counts += other.counts

    def _join(self, count: int, mean: FloatArray, squares: FloatArray) -> None:
        """Chan, Golub, LeVeque: Algorithms for computing the sample variance (1983)."""
        whole = self.count + count
        step = mean - self.mean
        self.squares = self.squares + squares + step**2 * (self.count * count / whole)
        self.mean = self.mean + step * (count / whole)
        self.count = whole

    @property
    def deviation(self) -> FloatArray:
        """(k, n): standard deviations."""
        return np.asarray(np.sqrt(self.squares / max(self.count - 1, 1)))

    def quantile(self, share: float) -> FloatArray:
        """(k, n): the value that this share of the draws does not exceed; NaN where it lies beyond the range."""
        flat: npt.NDArray[Any] = self.counts.reshape(-1, BINS + 2)
        wanted = share * self.count
        found = np.full(flat.shape[0], np.nan)
        for row, counts in enumerate(flat):  # cumulated row by row: all at once are as large again eight times over
            reached = np.cumsum(counts, dtype=np.int64)
            place = int(np.searchsorted(reached, wanted))
            if 0 < place <= BINS:
                found[row] = place - 1.0 + (wanted - reached[place - 1]) / counts[place]
        shape = self.bins.centre.shape
        return np.asarray(self.bins.centre - self.bins.half + found.reshape(shape) * (2.0 * self.bins.half / BINS))


def drawn_of(tally: Tally, value: FloatArray, u: FloatArray) -> Drawn:
    """value, u: (3, n), mm, of linear propagation; u NaN where nothing determines it: no draws are given there."""
    still = tally.deviation == 0.0  # no draw moves it, and a place within a bin would be none of it
    low, high = (np.where(still, tally.mean, tally.quantile(share)) for share in (LOW, HIGH))
    ends = np.abs([value - COVERAGE * u - low[:3], value + COVERAGE * u - high[:3]]).max(axis=0)
    standard_error = np.sqrt(LOW * HIGH / tally.count) / _density(COVERAGE) * tally.deviation[:3]
    apart = np.where(ends > tolerance(u) + SAMPLING * standard_error, ends, 0.0)
    unknown = np.isnan(u).any(axis=0)
    mean, sd, low, high, apart = (
        np.where(unknown, np.nan, one) for one in (tally.mean, tally.deviation, low, high, apart)
    )
    return Drawn(count=tally.count, mean=mean, sd=sd, low=low, high=high, apart=apart)


def tolerance(u: FloatArray) -> FloatArray:
    """Half a unit of the last digit of u written with one digit (GUM Supplement 1, 7.9.2 and 8.1)."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(u > 0.0, 0.5 * 10.0 ** np.floor(np.log10(u)), 1e-9))


def _density(x: float) -> float:
    return float(np.exp(-0.5 * x**2) / np.sqrt(2.0 * np.pi))


def drawn_columns(drawn: Drawn) -> list[tuple[tuple[str, ...], FloatArray]]:
    """Names and values (4, n), mm, of means, standard deviations, 2.5 % and 97.5 %: of dx, dy, dz and the length; and
    (3, n), how far apart the linear intervals are.
    """
    values = [getattr(drawn, statistic) for statistic in STATISTICS]
    return [
        (tuple(f"{statistic}_{quantity}" for quantity in QUANTITIES[: len(rows)]), rows)
        for statistic, rows in zip(STATISTICS, values, strict=True)
    ]
