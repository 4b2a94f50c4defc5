"""How certain the noise of a test is, by Monte Carlo on noise whose law is known."""

import numpy as np
import pytest
from scipy.stats import f as f_law

from trueaxis.diagnosis.null_model.freedom import Freedom, freedom_of_runs
from trueaxis.diagnosis.null_model.noise_fit import UNEVEN

DRAWS = 200_000
READINGS = 9  # of a run that tell its noise


def test_freedom_is_that_of_the_instruments_that_sense_it() -> None:
    """Variances of a laser told by few repeats and of a ball bar told by many: the ratio, by simulation."""
    source = np.random.default_rng(6)
    sigma = np.array([1.0, 1.0, 2.0, 2.0])
    freedom = Freedom(np.array([8.0, 8.0, 50.0, 50.0]), sigma, np.array([0, 0, 1, 1]), np.full(2, np.inf))
    column = np.array([[1.0], [1.0], [4.0], [2.0]])
    share = np.array([2.0, 5.0]) / 7.0  # of the whitened squares
    variance = share[0] * source.chisquare(8.0, DRAWS) / 8.0 + share[1] * source.chisquare(50.0, DRAWS) / 50.0
    assert freedom.of(np.arange(4), column) == pytest.approx(2.0 / np.var(variance), rel=0.05)
    assert freedom.of(np.arange(2), column[:2]) == pytest.approx(8.0)
    assert freedom.of_cause(np.arange(4), column) == pytest.approx(freedom.of(np.arange(4), column))
    assert freedom.of(np.array([0, 2]), np.array([[1.0], [0.0]])) == pytest.approx(8.0)


def test_a_test_of_one_run_stands_on_the_noise_of_that_run() -> None:
    """Noise of the instrument from 300 readings, that of each of its runs beside it from few: what acts on one run has
    little freedom, what acts alike on twenty has nearly that of the instrument.
    """
    source = np.random.default_rng(7)
    runs, few, many = 20, 10.0, 300.0
    freedom = Freedom(np.full(runs, many), np.ones(runs), np.arange(runs), np.full(runs, few))
    scales = source.chisquare(few, (DRAWS // 10, runs)) / few
    of_instrument = source.chisquare(many, DRAWS // 10) / many
    for count in (1, 4, runs):
        column = np.where(np.arange(runs) < count, 1.0, 0.0)[:, np.newaxis]
        variance = of_instrument * scales[:, :count].mean(axis=1)
        assert freedom.of_cause(np.arange(runs), column) == pytest.approx(2.0 / np.var(variance), rel=0.07)


@pytest.mark.parametrize("uneven", [0.0, 0.2, 0.5])
def test_noise_of_a_run_is_no_more_certain_than_it_is(uneven: float) -> None:
    """Something of no size in each of 30 runs, over the noise of the run as it is estimated: an F test with these
    degrees of freedom is right about as often as it says. With those of all runs together it is not, where their noise
    differs.
    """
    source = np.random.default_rng(8)
    runs, sets, information = 30, 400, 2.0 * READINGS
    below = {0.01: 0, 0.001: 0}
    together = 0
    for _ in range(sets):
        sigma = np.exp(uneven * source.standard_normal(runs))
        alone = np.log(sigma) + 0.5 * np.log(source.chisquare(READINGS, runs) / READINGS)
        alone -= alone.mean()
        sigma /= np.exp(np.mean(np.log(sigma)))
        logs = alone * information / (information + UNEVEN**-2)
        freedom = freedom_of_runs(logs, np.full(runs, information))
        square = (sigma * source.standard_normal(runs) / np.exp(logs)) ** 2
        p = f_law.sf(square, 1, freedom)
        for chance in below:
            below[chance] += int(np.count_nonzero(p < chance))
        together += int(np.count_nonzero(f_law.sf(square, 1, READINGS * runs) < 0.001))
    for chance, count in below.items():
        assert count / (runs * sets) < 2.5 * chance, (chance, count)
    assert below[0.01] / (runs * sets) > 0.2 * 0.01
    if uneven == 0.5:
        assert together > 4 * below[0.001]
