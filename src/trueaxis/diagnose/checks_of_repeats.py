"""Do repeats agree less at one place than elsewhere? Then what differs there is no noise of the instrument.

Noise is estimated from all repeats of an instrument; a cause that no repeat has twice (something that settles, warms or
shakes) makes that estimate larger, and hides behind it. So the repeats of each place, the lines of an axis or the
circles of a plane, are measured by the noise of all others.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.diagnose.checks_of_runs import FALSE_ALARMS
from trueaxis.diagnose.noise import REPEATS, Contrast, contrasts, estimate_noise
from trueaxis.diagnose.projection import Projection, orthonormal
from trueaxis.diagnose.result import Check, FloatArray, NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.tails import log_f_tail
from trueaxis.diagnose.whiten import whitened

BAND = 16  # half periods in a run, the slowest: what is quicker is no cause
MORE = 1.5  # times the variance of the other places, from which it is worth saying
SMALLEST = 1e-300  # mean square elsewhere: repeats that agree to the last digit
COURSE = "course of repeats"
SLOPES = "slopes of repeats"
WARMING = "slopes of repeats with temperature"
_MEANING = {
    COURSE: "repeats differ in their course, more than those of other places",
    SLOPES: "repeats differ by a slope, more than those of other places",
    WARMING: "repeats differ by a slope, as the temperature changes in them",
}


@dataclass(frozen=True, slots=True)
class Squares:
    """Sums of squares in units of a noise, here and elsewhere, and their degrees of freedom."""

    here: float
    k: int
    elsewhere: float
    freedom: int

    @property
    def ratio(self) -> float:
        """F, of (k, freedom) degrees of freedom."""
        return (self.here / self.k) / max(self.elsewhere / self.freedom, SMALLEST)

    @property
    def excess(self) -> float:
        """Squares here beyond those of as many elsewhere."""
        return max(self.here - self.k * self.elsewhere / self.freedom, 0.0)


@dataclass(frozen=True, slots=True)
class Unevenness:
    """What differs at a place, by the noise of the others and by that of all; unit: mm^2 over its readings that a
    square of 1 by the former comes to.
    """

    place: str
    what: str
    by_others: Squares
    by_all: Squares
    unit: float


def checks_of_repeats(rows: Rows, values: FloatArray, theta: FloatArray, noise: Sequence[NoiseOf]) -> tuple[Check, ...]:
    """Up to three checks per place, where the noise comes from repeats of two places or more.

    values: (n,) mm, readings less what is expected, causes found taken away; theta: (n,) rad, polar angles of circles;
    noise: that of the runs present. p values by the F test, multiplied by the number of these checks.
    """
    every = contrasts(rows, values, theta)
    pooled = {one.instrument: one for one in noise if one.origin == REPEATS}
    found = [
        each
        for name, of_all in pooled.items()
        for each in _of_instrument([one for one in every if one.instrument == name], of_all)
    ]
    return tuple(_check(one, len(found), rows.size) for one in found)


def _of_instrument(mine: Sequence[Contrast], of_all: NoiseOf) -> Iterator[Unevenness]:
    places = sorted({one.place for one in mine})
    if len(places) < 2:
        return
    for place in places:
        here = [one for one in mine if one.place == place]
        others = [one for one in mine if one.place != place]
        noise = estimate_noise(others, mine[0].instrument)
        if noise is None or noise.origin != REPEATS:
            continue
        by_others, by_all = (_courses(here, others, each) for each in (noise, of_all))
        yield Unevenness(place, COURSE, by_others, by_all, noise.sigma**2)
        here, others = ([one for one in side if one.across_runs] for side in (here, others))
        if here and others:
            _, scale = _standard(here, noise)
            # the mean square of a slope of 1 mm over a run is a twelfth
            unit = float(np.mean(scale**2) * np.mean([one.values.size for one in here])) / 12.0
            for what, sums in ((SLOPES, _slopes), (WARMING, _warming)):
                told, in_all = (sums(here, others, each) for each in (noise, of_all))
                if told is not None and in_all is not None:
                    yield Unevenness(place, what, told, in_all, unit)


def _courses(here: Sequence[Contrast], others: Sequence[Contrast], noise: NoiseOf) -> Squares:
    return Squares(*_band(here, noise), *_band(others, noise))


def _band(of: Sequence[Contrast], noise: NoiseOf) -> tuple[float, int]:
    """Whitened squares of the slowest courses, offset and slope apart, and how many they are."""
    total, count = 0.0, 0
    for one in of:
        size = one.values.size
        white = whitened(replace(noise, slope=0.0), np.hstack([one.nuisance, one.values[:, np.newaxis]]))
        aside = Projection(orthonormal(white[:, :-1]))
        angle = np.pi * (np.arange(size)[:, np.newaxis] + 0.5) / size
        basis = orthonormal(aside.rest(np.cos(angle * np.arange(1, min(BAND, size // 2) + 1))))
        total += float(np.sum((basis.T @ aside.rest(white[:, -1])) ** 2))
        count += basis.shape[1]
    return total, count


def _slopes(here: Sequence[Contrast], others: Sequence[Contrast], noise: NoiseOf) -> Squares:
    """All slopes against those of the other places."""
    of_here, of_others = (_standard(side, noise)[0] for side in (here, others))
    return Squares(float(of_here @ of_here), of_here.size, float(of_others @ of_others), of_others.size)


def _warming(here: Sequence[Contrast], others: Sequence[Contrast], noise: NoiseOf) -> Squares | None:
    """What of the slopes goes with the temperature and its square, against the rest of all slopes."""
    warming = [one.warming for one in here if one.warming is not None]
    of_here, scale = _standard(here, noise)
    if len(warming) < of_here.size:
        return None
    basis = orthonormal(np.array(warming) / scale[:, np.newaxis])
    k = basis.shape[1]
    if not 0 < k < of_here.size:
        return None
    of_others, _ = _standard(others, noise)
    within = float(np.sum((basis.T @ of_here) ** 2))
    rest = float(of_here @ of_here) - within + float(of_others @ of_others)
    return Squares(within, k, rest, of_here.size + of_others.size - k)


def _standard(of: Sequence[Contrast], noise: NoiseOf) -> tuple[FloatArray, FloatArray]:
    """(n,) slopes in their standard deviations, and those, mm."""
    slopes, variances = np.array([one.slope(noise) for one in of]).T
    scale = np.sqrt(variances + noise.slope**2)
    return slopes / scale, scale


def _check(one: Unevenness, tests: int, size: int) -> Check:
    told = one.by_others
    p_value = min(1.0, float(np.exp(log_f_tail(told.ratio, told.k, told.freedom))) * tests)
    fired = p_value < FALSE_ALARMS and told.ratio > MORE
    rms = float(np.sqrt(told.excess * one.unit / size))
    return Check(f"{one.place}, {one.what}", _MEANING[one.what], p_value, fired, rms, one.by_all.excess)
