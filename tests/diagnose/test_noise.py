"""Noise from repeats, by Monte Carlo: noise of known kinds is drawn by other means and must be found again."""

from dataclasses import replace
from functools import cache

import numpy as np
import numpy.typing as npt
import pytest
from statsmodels.tsa.arima_process import arma_generate_sample

from tests.diagnose.prepared import SIGMA, SMALL, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnose.noise import Contrast, contrasts, estimate_noise
from trueaxis.diagnose.noise_of_runs import noise_of_runs
from trueaxis.diagnose.result import NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.signatures import readings_of

FloatArray = npt.NDArray[np.float64]
DRAWS = 24


@cache
def measured(design: Design) -> tuple[Prepared, Rows, FloatArray]:
    given = prepared(Case(seed=1, design=design, noise="none", given="exact"))
    rows = given.rows
    return given, rows, readings_of(given.model, rows).reading.theta


def drawn(rows: Rows, seed: int, correlated: float = 0.0, correlation: float = 0.8, slope: float = 0.0) -> FloatArray:
    """(n,) mm: standard deviation SIGMA, of whose variance a share is correlated, and slopes of runs."""
    source = np.random.default_rng(seed)
    found = np.empty(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        size = mine.stop - mine.start
        chain = arma_generate_sample(
            [1.0, -correlation], [1.0], size, np.sqrt(1.0 - correlation**2), distrvs=source.standard_normal, burnin=200
        )
        found[mine] = SIGMA * (np.sqrt(1.0 - correlated) * source.standard_normal(size) + np.sqrt(correlated) * chain)
        found[mine] += slope * source.standard_normal() * (np.arange(size) / (size - 1) - 0.5)
    return found


def estimates(instrument: str, correlated: float, slope: float) -> list[NoiseOf]:
    _, rows, theta = measured(Design())
    every = (contrasts(rows, drawn(rows, seed, correlated, slope=slope), theta) for seed in range(DRAWS))
    found = [estimate_noise(one, instrument) for one in every]
    return [one for one in found if one is not None]


def slow(white: float, correlated: float, correlation: float) -> float:
    """Spectral density at frequency 0 of white and AR(1) noise."""
    return white**2 + correlated**2 * (1.0 + correlation) / (1.0 - correlation)


@pytest.mark.parametrize("instrument", ["laser", "ballbar"])
@pytest.mark.parametrize("correlated", [0.0, 0.2, 0.6])
@pytest.mark.parametrize("slope", [0.0, 2 * SIGMA])
def test_noise_is_found_again(instrument: str, correlated: float, slope: float) -> None:
    found = estimates(instrument, correlated, slope)
    assert len(found) == DRAWS
    # the slow end of what repeats allow is taken, which costs some per cent
    assert 0.97 * SIGMA < np.mean([one.sigma for one in found]) < 1.12 * SIGMA
    assert np.mean([one.white for one in found]) == pytest.approx(np.sqrt(1.0 - correlated) * SIGMA, rel=0.08)
    truth = slow(np.sqrt(1.0 - correlated) * SIGMA, np.sqrt(correlated) * SIGMA, 0.8)
    enough = [slow(one.white, one.correlated, one.correlation) > 0.9 * truth for one in found]
    assert np.mean(enough) > 0.85  # at 90 % confidence


@pytest.mark.parametrize("instrument", ["laser", "ballbar"])
def test_the_slope_of_runs_has_no_bias_worth_speaking_of(instrument: str) -> None:
    found = [one.slope for one in estimates(instrument, 0.2, 2 * SIGMA)]
    assert np.sqrt(np.mean(np.square(found))) == pytest.approx(2 * SIGMA, rel=0.15)
    small = [one.slope for one in estimates(instrument, 0.2, 0.0)]
    assert np.sqrt(np.mean(np.square(small))) < 0.3 * SIGMA


def test_degrees_of_freedom_are_those_of_the_differences() -> None:
    _, rows, theta = measured(Design())
    found = estimate_noise(contrasts(rows, drawn(rows, 0), theta), "laser")
    assert found is not None
    # 12 lines of 82 readings, two differences each, of which offset and slope are taken away
    assert found.freedom == 12 * 2 * (82 - 2)
    assert found.slope_freedom == pytest.approx(9.6)  # two fifths of 24 slopes: the largest ones are left out


def same(one: tuple[Contrast, ...], other: tuple[Contrast, ...], instrument: str) -> None:
    pairs = [(a, b) for a, b in zip(one, other, strict=True) if a.instrument == instrument]
    assert pairs
    for a, b in pairs:
        assert a.values == pytest.approx(b.values, abs=1e-15)


def test_what_repeats_have_in_common_is_not_noise() -> None:
    """A misfit of 10 um, as wild as can be: a number of its own for each target, feed and direction."""
    _, rows, theta = measured(SMALL)
    noise = drawn(rows, 4)
    misfit = 1e-2 * np.random.default_rng(9).standard_normal(int(rows.target.max()) + 1)
    same(contrasts(rows, noise, theta), contrasts(rows, noise + misfit[rows.target], theta), "laser")


def test_offsets_and_slopes_of_runs_are_not_taken_for_white_noise() -> None:
    _, rows, theta = measured(Design())
    noise = drawn(rows, 4)
    moved = noise.copy()
    source = np.random.default_rng(2)
    for index in rows.present:
        mine = rows.of_run(index)
        moved[mine] += 5e-3 * source.normal() + 2e-3 * source.normal() * np.linspace(-0.5, 0.5, mine.stop - mine.start)
    for instrument in ("laser", "ballbar"):
        without = estimate_noise(contrasts(rows, noise, theta), instrument)
        with_them = estimate_noise(contrasts(rows, moved, theta), instrument)
        assert without is not None
        assert with_them is not None
        assert with_them.sigma == pytest.approx(without.sigma, rel=1e-6)
        assert with_them.slope == pytest.approx(2e-3, rel=0.6)


def test_servo_lag_is_not_taken_for_noise_of_circles() -> None:
    """Circles whose only repeats are at another feed: the lag's second harmonic differs, and is taken away."""
    _, rows, theta = measured(Design())
    assert rows.feed is not None
    noise = drawn(rows, 4)
    lag = np.where(np.isnan(rows.feed), 0.0, 1e-6 * rows.feed * np.sin(2.0 * np.nan_to_num(theta)))
    without = estimate_noise(contrasts(rows, noise, theta), "ballbar")
    with_lag = estimate_noise(contrasts(rows, noise + lag, theta), "ballbar")
    assert without is not None
    assert with_lag is not None
    assert with_lag.sigma == pytest.approx(without.sigma, rel=1e-6)


def test_without_repeats_the_course_of_each_run_tells_the_noise() -> None:
    given, rows, theta = measured(replace(Design(), repeats=1, feeds=(1000.0,)))
    assert estimate_noise(contrasts(rows, drawn(rows, 0), theta), "laser") is None
    smooth = 5e-3 * np.sin(rows.positions.sum(axis=0) / 200.0)  # two swings per line
    reading = readings_of(given.model, rows).reading
    found = noise_of_runs(rows, reading, smooth + drawn(rows, 0), None)
    for one in found:
        assert one.white == pytest.approx(SIGMA, rel=0.1)
        assert one.origin != "repeats"


def test_a_noise_that_is_given_holds() -> None:
    given, rows, _ = measured(SMALL)
    found = noise_of_runs(rows, readings_of(given.model, rows).reading, drawn(rows, 0), 0.7)
    assert len(found) == len(rows.runs)
    assert {(one.white, one.correlated, one.slope) for one in found} == {(0.7e-3, 0.0, 0.0)}


def tilted(slopes: FloatArray, source: np.random.Generator) -> NoiseOf:
    """What repeats of runs with these slopes (mm over a run) come to, readings of 1 um beside them."""
    ramp = np.linspace(-0.5, 0.5, 40)
    nuisance = np.stack([np.ones(40), ramp], axis=1)
    noise = 1e-3 * source.standard_normal((slopes.size, 40))
    values = noise + slopes[:, np.newaxis] * ramp
    found = estimate_noise([Contrast("laser", one, nuisance, across_runs=True) for one in values], "laser")
    assert found is not None
    return found


def test_slopes_of_a_third_of_the_runs_hardly_count() -> None:
    """What warms tilts the runs of one axis by ten times as much: the slope is still that of the others."""
    source = np.random.default_rng(31)
    size = 20e-3
    even, uneven = [], []
    for _ in range(40):
        slopes = size * source.standard_normal(24)
        even.append(tilted(slopes, source).slope)
        slopes[:8] += 10.0 * size * np.sign(slopes[:8])
        uneven.append(tilted(slopes, source).slope)
    assert np.sqrt(np.mean(np.square(even))) == pytest.approx(size, rel=0.12)
    assert np.sqrt(np.mean(np.square(uneven))) < 2.0 * size  # their mean square would say 6 sizes


def test_slopes_are_not_said_to_be_surer_than_they_are() -> None:
    """Degrees of freedom of an estimate: 2 / (relative variance), by simulation."""
    source = np.random.default_rng(32)
    found = [tilted(0.1 * source.standard_normal(24), source) for _ in range(300)]
    squares = np.array([one.slope**2 for one in found])
    told = 2.0 * squares.mean() ** 2 / squares.var()
    assert 0.6 * told < found[0].slope_freedom < 1.1 * told
