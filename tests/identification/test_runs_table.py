"""The table of runs: worst first, with what noise alone gives, so that what is unusual is seen."""

from dataclasses import replace

import numpy as np
import pytest

from trueaxis.estimation.noise import Noise
from trueaxis.identification.fit_quality import FitQuality, Residuals, run_residuals
from trueaxis.identification.report_text import WORST, fit_text, runs_table
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.errors import Fit

RUNS = tuple(
    Run(
        id=f"run-{k}",
        instrument="laser",
        target=PointOn("tool"),
        reference=PointOn("bed"),
        frame="bed",
        home={"X": 0.0},
        direction=(1.0, 0.0, 0.0),
    )
    for k in range(40)
)
EACH = 25  # readings


def residuals(reading: np.ndarray, *, known: bool) -> Residuals:
    """reading: (runs, EACH), of noise 1 um."""
    noise = np.full(reading.size, 1e-3)
    stated = noise if known else np.nan * noise
    run = np.repeat(np.arange(len(reading)), EACH)
    return Residuals(
        run=run, count=np.ones(run.size), squares=reading.ravel() ** 2, noise=stated, size=None,
        freedom=run.size, copied=(), estimated=noise,
    )  # fmt: skip


@pytest.mark.parametrize("known", [True, False])
def test_the_worst_runs_have_a_line_and_the_others_are_counted(known: bool) -> None:
    reading = np.random.default_rng(3).normal(0.0, 1e-3, (40, EACH))
    reading[7] *= 2.5
    lines = runs_table(run_residuals(residuals(reading, known=known), RUNS))
    worst = lines[2].split()
    assert worst[:2] == ["run-7", str(EACH)]
    assert float(worst[2]) / float(worst[3]) == pytest.approx(float(worst[4]), rel=0.02)
    assert worst[-1] == "unusual"
    assert sum("run-" in line for line in lines) == WORST
    assert "  and 35 more, all within the noise" in lines


def test_noise_alone_is_seldom_unusual() -> None:
    """In one data set of a hundred."""
    draw = np.random.default_rng(4)
    sets = [residuals(draw.normal(0.0, 1e-3, (40, EACH)), known=True) for _ in range(400)]
    assert sum(any(one.unusual for one in run_residuals(each, RUNS)) for each in sets) <= 10  # 4 expected


def test_noise_that_few_repeats_tell_makes_no_good_run_unusual() -> None:
    """Noise from six degrees of freedom is half of the true one now and then: it counted as known."""
    draw, freedom = np.random.default_rng(6), 6
    sets = []
    for _ in range(400):
        one = residuals(draw.normal(0.0, 1e-3, (8, EACH)), known=True)
        noise = one.noise * np.sqrt(draw.chisquare(freedom) / freedom)
        sets.append(replace(one, noise=noise, noise_freedom=dict.fromkeys(range(8), float(freedom))))
    assert sum(any(one.unusual for one in run_residuals(each, RUNS)) for each in sets) <= 10
    as_known = [replace(each, noise_freedom={}) for each in sets]
    assert sum(any(one.unusual for one in run_residuals(each, RUNS)) for each in as_known) > 80


def test_slow_noise_scatters_as_fewer_readings() -> None:
    """The mean square of a run: its variance from the covariance written down."""
    noise, steps = Noise(0.6, 0.8, 7.0), np.r_[0.0, np.random.default_rng(5).uniform(0.2, 3.0, 59)]
    time = np.cumsum(steps)
    dense = noise.white**2 * np.eye(60) + noise.slow**2 * np.exp(-np.abs(time[:, np.newaxis] - time) / noise.lasts)
    assert noise.independent(steps) == pytest.approx(np.trace(dense) ** 2 / np.sum(dense**2))
    assert Noise(2.0).independent(steps) == pytest.approx(60.0)


@pytest.mark.parametrize(("chi2", "said"), [(1.5, False), (15.0, True)])
def test_a_converged_fit_whose_residuals_are_no_noise_says_so(chi2: float, said: bool) -> None:
    """15 passed without a word."""
    text = fit_text(FitQuality(Fit("converged", chi2), ()))
    assert ("3.9 times the noise" in text) == said
    assert ("diagnose" in text) == said
