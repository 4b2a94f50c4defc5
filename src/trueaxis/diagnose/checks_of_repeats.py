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
    """ratio: of the variance here to that elsewhere, k and freedom their degrees of freedom; beyond: mm^2, summed."""

    place: str
    what: str
    ratio: float
    k: int
    freedom: int
    beyond: float


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
    of_here, k = _band(here, noise)
    of_others, freedom = _band(others, noise)
    ratio = (of_here / k) / (of_others / freedom)
    return Unevenness(place, COURSE, ratio, k, freedom, max(ratio - 1.0, 0.0) * k * noise.sigma**2)


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
    readings = sum(one.values.size for one in here) / len(here) / 12.0  # times the mean square of a slope of 1 mm
    ratio = float(np.mean(of_here**2) / np.mean(of_others**2))
    beyond = max(1.0 - 1.0 / ratio, 0.0) * float(np.sum((scale * of_here) ** 2)) * readings
    yield Unevenness(place, SLOPES, ratio, of_here.size, of_others.size, beyond)
    warming = [one.warming for one in here if one.warming is not None]
    if len(warming) < of_here.size:
        return
    basis = orthonormal(np.array(warming) / scale[:, np.newaxis])
    k = basis.shape[1]
    freedom = of_here.size + of_others.size - k
    if k == 0 or of_here.size <= k:
        return
    inside = basis @ (basis.T @ of_here)
    within = float(inside @ inside)
    rest = float(of_here @ of_here) - within + float(of_others @ of_others)
    ratio = (within / k) / (rest / freedom)
    beyond = max(1.0 - 1.0 / ratio, 0.0) * float(np.sum((scale * inside) ** 2)) * readings
    yield Unevenness(place, WARMING, ratio, k, freedom, beyond)


def _standard(of: Sequence[Contrast], noise: NoiseOf) -> tuple[FloatArray, FloatArray]:
    """(n,) slopes in their standard deviations, and those, mm."""
    slopes, variances = np.array([one.slope(noise) for one in of]).T
    scale = np.sqrt(variances + noise.slope**2)
    return slopes / scale, scale


def _check(one: Unevenness, tests: int, size: int) -> Check:
    p_value = min(1.0, float(np.exp(log_f_tail(one.ratio, one.k, one.freedom))) * tests)
    fired = p_value < FALSE_ALARMS and one.ratio > MORE
    excess = max(one.ratio - 1.0, 0.0) * one.k
    rms = float(np.sqrt(one.beyond / size))
    return Check(f"{one.place}, {one.what}", _MEANING[one.what], p_value, fired, rms, excess)
