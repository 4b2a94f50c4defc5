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
class Unevenness:
    """Sums of squares, of variance 1 under the noise of the other places: here and elsewhere, and their degrees of
    freedom; unit: mm^2 summed over readings that a square of 1 comes to.
    """

    place: str
    what: str
    here: float
    k: int
    elsewhere: float
    freedom: int
    unit: float

    @property
    def ratio(self) -> float:
        """F, of (k, freedom) degrees of freedom."""
        return (self.here / self.k) / max(self.elsewhere / self.freedom, SMALLEST)

    @property
    def excess(self) -> float:
        """Squares here beyond those of elsewhere, in units of the latter's mean.

        What causes explain is measured by the noise of all places, which is larger: on purpose. A noise that is shown
        to be too large at one place is no ground for a name.
        """
        return max(self.ratio - 1.0, 0.0) * self.k


def checks_of_repeats(rows: Rows, values: FloatArray, theta: FloatArray, noise: Sequence[NoiseOf]) -> tuple[Check, ...]:
    """Up to three checks per place, where the noise comes from repeats of two places or more.

    values: (n,) mm, readings less what is expected, causes found taken away; theta: (n,) rad, polar angles of circles;
    noise: that of the runs present. p values by the F test, multiplied by the number of these checks.
    """
    every = contrasts(rows, values, theta)
    estimated = dict.fromkeys(one.instrument for one in noise if one.origin == REPEATS)
    groups = [[one for one in every if one.instrument == name] for name in estimated]
    found = [each for mine in groups for each in _of_instrument(mine)]
    return tuple(_check(one, len(found), rows.size) for one in found)


def _of_instrument(mine: Sequence[Contrast]) -> Iterator[Unevenness]:
    places = sorted({one.place for one in mine})
    if len(places) < 2:
        return
    for place in places:
        here = [one for one in mine if one.place == place]
        others = [one for one in mine if one.place != place]
        noise = estimate_noise(others, mine[0].instrument)
        if noise is None or noise.origin != REPEATS:
            continue
        yield _courses(place, here, others, noise)
        here, others = ([one for one in side if one.across_runs] for side in (here, others))
        if here and others:
            yield from _slopes(place, here, others, noise)


def _courses(place: str, here: Sequence[Contrast], others: Sequence[Contrast], noise: NoiseOf) -> Unevenness:
    return Unevenness(place, COURSE, *_band(here, noise), *_band(others, noise), noise.sigma**2)


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


def _slopes(place: str, here: Sequence[Contrast], others: Sequence[Contrast], noise: NoiseOf) -> Iterator[Unevenness]:
    """All slopes against those of the other places; and what of them goes with the temperature, against the rest."""
    of_here, scale = _standard(here, noise)
    of_others, _ = _standard(others, noise)
    whole, elsewhere = float(of_here @ of_here), float(of_others @ of_others)
    readings = np.mean([one.values.size for one in here])
    unit = float(np.mean(scale**2) * readings / 12.0)  # the mean square of a slope of 1 mm over a run is a twelfth
    yield Unevenness(place, SLOPES, whole, of_here.size, elsewhere, of_others.size, unit)
    warming = [one.warming for one in here if one.warming is not None]
    if len(warming) < of_here.size:
        return
    basis = orthonormal(np.array(warming) / scale[:, np.newaxis])
    k = basis.shape[1]
    if 0 < k < of_here.size:
        within = float(np.sum((basis.T @ of_here) ** 2))
        freedom = of_here.size + of_others.size - k
        yield Unevenness(place, WARMING, within, k, whole - within + elsewhere, freedom, unit)


def _standard(of: Sequence[Contrast], noise: NoiseOf) -> tuple[FloatArray, FloatArray]:
    """(n,) slopes in their standard deviations, and those, mm."""
    slopes, variances = np.array([one.slope(noise) for one in of]).T
    scale = np.sqrt(variances + noise.slope**2)
    return slopes / scale, scale


def _check(one: Unevenness, tests: int, size: int) -> Check:
    p_value = min(1.0, float(np.exp(log_f_tail(one.ratio, one.k, one.freedom))) * tests)
    fired = p_value < FALSE_ALARMS and one.ratio > MORE
    rms = float(np.sqrt(one.excess * one.unit / size))
    return Check(f"{one.place}, {one.what}", _MEANING[one.what], p_value, fired, rms, one.excess)
