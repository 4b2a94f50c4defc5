"""Readings that are spoilt are left out, what repeats share and what lasts is not."""

import numpy as np

from trueaxis.estimation.noise import Noise
from trueaxis.estimation.outliers import spoilt
from trueaxis.measurement.machine import FloatArray

NOISE, STEPS = Noise(3e-4, 2e-4, 10.0), np.r_[0.0, np.ones(99)]
ALONE = np.arange(100)


def residual(seed: int = 0) -> FloatArray:
    return np.asarray(np.random.default_rng(seed).normal(0.0, 3e-4, 100))


def test_good_readings_stay() -> None:
    found = [spoilt(NOISE, 1.0, STEPS, residual(seed), ALONE, 10_000).sum() for seed in range(50)]
    assert sum(found) <= 1


def test_single_ones_and_neighbours_go() -> None:
    values = residual()
    values[[20, 60, 61]] += [4e-3, -3e-3, -3.5e-3]
    assert np.flatnonzero(spoilt(NOISE, 1.0, STEPS, values, ALONE, 10_000)).tolist() == [20, 60, 61]


def test_what_repeats_share_stays() -> None:
    values, repeats = residual(), np.tile(np.arange(25), 4)
    values[repeats == 7] += 4e-3
    values[30] += 4e-3
    assert np.flatnonzero(spoilt(NOISE, 1.0, STEPS, values, repeats, 10_000)).tolist() == [30]


def test_what_lasts_stays() -> None:
    values = residual()
    values[40:46] += 4e-3
    assert not spoilt(NOISE, 1.0, STEPS, values, ALONE, 10_000)[40:46].all()
    values += 5e-3 * np.random.default_rng(1).standard_normal(100)  # the model is wrong, not the readings
    assert not spoilt(NOISE, 1.0, STEPS, values, ALONE, 10_000).any()


def test_a_large_one_takes_no_others_of_a_short_run_with_it() -> None:
    noise, steps = Noise(3e-4, 1.3e-4, 128.0), np.r_[0.0, np.ones(13)]
    for seed in range(50):
        values = residual(seed)[:14]
        values[0] += 0.02
        assert np.flatnonzero(spoilt(noise, 1.0, steps, values, ALONE[:14], 1000)).tolist() == [0]
