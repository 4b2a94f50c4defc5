"""Whitening against the covariance written out, its Cholesky factor, and statsmodels' generalised least squares."""

import numpy as np
import pytest
import statsmodels.api as sm
from scipy.linalg import block_diag

from tests.diagnosis.prepared import FloatArray, dense_covariance, drawn_noise, run_noise
from trueaxis.diagnosis.null_model.whiten import RunNoise, Whitening, wandering, whitening
from trueaxis.estimation.noise import Noise

NOISES = {
    "white": (Noise(3e-4), 0.0, 0.0, 0.0),
    "slow": (Noise(3e-4, 2e-4, 4.5), 0.0, 0.0, 0.0),
    "settling": (Noise(3e-4), 5e-4, 0.0, 0.0),
    "drifting": (Noise(3e-4), 0.0, 0.0, 1e-2),
    "everything": (Noise(3e-4, 2e-4, 4.5), 5e-4, 7e-4, 1e-2),
}


def run_of(name: str, size: int, seed: int = 0) -> RunNoise:
    """At uneven times."""
    noise, settles, wanders, drifts = NOISES[name]
    steps = np.random.default_rng(seed).uniform(0.5, 1.5, size)
    passed = np.linspace(0.0, 1.0, size)
    ball = np.random.default_rng(seed + 1).normal(size=(size, 3)) if name == "everything" else None
    return run_noise(noise, steps, passed, settles, wanders, drifts, ball, places=3e-3)


def own_of(size: int, seed: int = 0) -> FloatArray:
    """Zero and two courses of no particular shape."""
    return np.column_stack([np.ones(size), np.random.default_rng(seed).normal(size=(size, 2))])


def whitening_of(*sizes: int) -> Whitening:
    names = list(NOISES)
    runs = [run_of(names[k % len(names)], size, k) for k, size in enumerate(sizes)]
    numbers = np.repeat(3 * np.arange(len(sizes)), sizes)
    return whitening(numbers, runs, [own_of(size, k) for k, size in enumerate(sizes)])


def dense(white: Whitening) -> tuple[FloatArray, FloatArray]:
    """Covariance of all readings, and the unknowns of all runs, (n, k)."""
    return block_diag(*map(dense_covariance, white.runs)), block_diag(*white.own)


@pytest.mark.parametrize("name", NOISES)
@pytest.mark.parametrize("size", [5, 37])
def test_inner_products_are_those_of_generalised_least_squares(name: str, size: int) -> None:
    """What is left of columns after the run's own unknowns, in the metric of the inverse covariance."""
    run, own = run_of(name, size), own_of(size)
    columns = np.random.default_rng(3).normal(size=(size, 4))
    found = whitening(np.zeros(size, dtype=np.int64), [run], [own])(columns)
    inverse = np.linalg.inv(dense_covariance(run))
    expected = columns.T @ (inverse - inverse @ own @ np.linalg.solve(own.T @ inverse @ own, own.T @ inverse)) @ columns
    assert found.T @ found == pytest.approx(expected, rel=1e-7, abs=1e-9 * np.abs(expected).max())


def test_noise_becomes_white_beside_the_unknowns_of_the_run() -> None:
    """Its covariance is the projection that takes these away."""
    run, own = run_of("everything", 40), own_of(40)
    white = whitening(np.zeros(40, dtype=np.int64), [run], [own])
    root = np.linalg.cholesky(dense_covariance(run))
    found = white(np.asarray(root))
    covariance = found @ found.T
    assert covariance @ covariance == pytest.approx(covariance, abs=1e-9)
    assert np.trace(covariance) == pytest.approx(40 - 3, abs=1e-9)
    assert np.abs(white(own)).max() < 1e-9 * np.abs(run.whitened(own)).max()
    assert white.own_count.tolist() == [3]


def test_runs_are_independent_of_each_other() -> None:
    white = whitening_of(20, 33, 20)
    columns = np.random.default_rng(1).normal(size=(73, 3))
    found = white(columns)
    assert white.part(np.arange(20, 73), columns[20:]) == pytest.approx(found[20:], rel=1e-12)
    alone = whitening(np.zeros(33, dtype=np.int64), [white.runs[1]], [white.own[1]])
    assert alone(columns[20:53]) == pytest.approx(found[20:53], rel=1e-9)


def test_no_columns_are_none_whitened() -> None:
    for white in (whitening_of(20, 33), whitening_of(450, 20)):
        nothing = np.zeros((int(white.starts[-1]), 0))
        assert white(nothing).shape == white.back(nothing).shape == nothing.shape


def test_back_is_the_transpose() -> None:
    """Short runs by matrices, a long one by recursions: the product of b and a whitened, for any a and b."""
    for white in (whitening_of(20, 33, 20, 25), whitening_of(450, 470, 20, 455)):
        source = np.random.default_rng(4)
        a, b = source.normal(size=(2, int(white.starts[-1]), 3))
        assert white.back(b).T @ a == pytest.approx(b.T @ white(a), rel=1e-8)


def test_of_some_rows_it_is_that_of_their_covariance() -> None:
    white = whitening_of(20, 33, 20)
    keep = np.random.default_rng(2).random(73) < 0.6
    keep[53:] = False
    columns = np.random.default_rng(7).normal(size=(73, 3))[keep]
    some = white.only(keep)
    assert some.starts.tolist() == [0, keep[:20].sum(), keep[:53].sum()]
    covariance, own = dense(white)
    covariance, own = covariance[np.ix_(keep, keep)], own[keep][:, :6]
    inverse = np.linalg.inv(covariance)
    expected = columns.T @ (inverse - inverse @ own @ np.linalg.solve(own.T @ inverse @ own, own.T @ inverse)) @ columns
    assert some(columns).T @ some(columns) == pytest.approx(expected, rel=1e-6)


def test_least_squares_on_whitened_readings_are_generalised_least_squares() -> None:
    """By statsmodels, with the unknowns of the run as columns."""
    run, own = run_of("everything", 60), own_of(60)
    source = np.random.default_rng(8)
    design = np.vander(np.linspace(-1.0, 1.0, 60), 6)[:, :4]
    values = design @ source.normal(size=4) * 1e-3 + drawn_noise(source, run)[:, 0]
    expected = sm.GLS(values, np.hstack([design, own]), sigma=dense_covariance(run)).fit()
    white = whitening(np.zeros(60, dtype=np.int64), [run], [own])
    found, rss = np.linalg.lstsq(white(design), white(values), rcond=None)[:2]
    assert found == pytest.approx(expected.params[:4], rel=1e-6)
    left = white(design)
    assert np.linalg.inv(left.T @ left) == pytest.approx(expected.normalized_cov_params[:4, :4], rel=1e-6)
    assert rss[0] == pytest.approx(expected.ssr, rel=1e-8)


def test_a_walk_less_its_zero_and_its_drift_is_a_brownian_bridge() -> None:
    """Its covariance is min(s, t) - s t (Revuz and Yor, Continuous Martingales, 1999), but for its fine part."""
    passed = np.linspace(0.0, 1.0, 41)
    walk = wandering(passed)
    expected = np.minimum.outer(passed, passed) - np.outer(passed, passed)
    assert walk @ walk.T == pytest.approx(expected, abs=0.012)


def test_play_of_targets_read_in_both_directions_at_once_is_no_drift() -> None:
    """A drift of 0.1 mm and a curve against it come to the same as play, reading by reading; one of 10 um does not."""
    targets = 11
    at, play = np.repeat(np.arange(targets), 2), np.tile([2.5e-3, -2.5e-3], targets)
    curve = np.eye(targets)[at]
    seen = []
    for drifts in (1e-2, 1e3):
        run = run_noise(Noise(3e-4), np.ones(at.size), np.linspace(0.0, 1.0, at.size), drifts=drifts)
        white = whitening(np.zeros(at.size, dtype=np.int64), [run], [np.ones((at.size, 1))])
        left, free = white(play), white(curve)
        rest = left - free @ np.linalg.lstsq(free, left, rcond=1e-9)[0]
        seen.append(float(rest @ rest))
    expected, unlimited = seen
    assert unlimited < 1.0
    assert expected > 25.0
