"""Readings that are spoilt are left out, what repeats share and what lasts is not."""

import numpy as np
import pytest
import statsmodels.api as sm
from scipy.stats import t as student

from trueaxis.estimation import outliers
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.noise_of_residuals import AS_MANY
from trueaxis.estimation.outliers import EXPECTED, WINDOW, Judged, covariance_of, shared_by_repeats, spoilt, surely_none
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray

NOISE = Noise(3e-4, 2e-4, 10.0)
WHITE = Noise(1e-3)
READINGS, NOTHING = 10_000, 1e-9


def residual(seed: int = 0, count: int = 100) -> FloatArray:
    return np.asarray(np.random.default_rng(seed).normal(0.0, 3e-4, count))


def judged(
    left: FloatArray,
    noise: Noise = NOISE,
    *,
    repeats: IntArray | None = None,
    free: FloatArray | None = None,
    good: BoolArray | None = None,
    usual: float = 1.0,
    told: float = AS_MANY,
) -> Judged:
    """free: (n, k), columns of unknowns of the run that are taken away of what is left, by weighted least squares."""
    steps, chance = np.r_[0.0, np.ones(left.size - 1)], np.zeros((left.size, 0))
    taken = np.zeros((left.size, 0))
    if free is not None:
        weighed = np.linalg.inv(covariance_of(noise, steps, chance)) @ free
        left = left - free @ np.linalg.solve(free.T @ weighed, weighed.T @ left)
        taken = weighed @ np.linalg.inv(np.linalg.cholesky(free.T @ weighed)).T
    return Judged(
        steps=steps,
        left=left,
        shared=np.zeros(left.size, dtype=bool) if repeats is None else shared_by_repeats(left, repeats),
        good=np.ones(left.size, dtype=bool) if good is None else good,
        noise=noise,
        chance=chance,
        taken=taken,
        usual=usual,
        told=told,
    )


def found(one: Judged, readings: int = READINGS) -> list[int]:
    return np.flatnonzero(spoilt(one, readings)).tolist()


def test_good_readings_stay() -> None:
    assert sum(len(found(judged(residual(seed)))) for seed in range(50)) <= 1


@pytest.mark.parametrize(("unknowns", "least"), [(2, 20), (5, 0)])
def test_one_data_set_in_twenty_loses_a_good_reading(unknowns: int, least: int) -> None:
    """Fewer where the fit leaves little of the readings at the ends."""
    few = np.vander(np.linspace(-1.0, 1.0, 9), unknowns)
    source = np.random.default_rng(5)
    number = [len(found(judged(source.normal(0.0, 1e-3, 9), WHITE, free=few), 9)) for _ in range(1000)]
    assert least <= sum(number) <= 100


def test_single_ones_and_neighbours_go() -> None:
    values = residual()
    values[[20, 60, 61]] += [4e-3, -3e-3, -3.5e-3]
    assert found(judged(values)) == [20, 60, 61]


def test_those_left_out_before_come_back_only_where_they_are_good() -> None:
    values = residual()
    values[[20, 60]] += [4e-3, -3e-3]
    before = np.ones(100, dtype=bool)
    before[[20, 33, 60]] = False
    assert found(judged(values, good=before)) == [20, 60]


def test_two_that_hide_each_other_in_a_short_run_are_found() -> None:
    # the noise of the run was taken with them in it: three times what it is
    place = np.linspace(0.0, 1.0, 21)
    free = np.column_stack([np.ones(21), place, np.cos(np.pi * place), np.sin(np.pi * place)])
    for seed in range(20):
        values = np.random.default_rng(seed).normal(0.0, 1e-3, 21)
        values[[4, 5]] -= 0.015
        assert found(judged(values, Noise(3e-3), free=free, usual=1.0 / 9.0)) == [4, 5]


@pytest.mark.parametrize("size", [3.0, 4.0, 5.0, 6.0, 8.0, 12.0])
def test_each_is_judged_as_statsmodels_does(size: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the residual that is studentised without it, where nothing but the run itself tells its noise."""
    monkeypatch.setattr(outliers, "HARDLY", NOTHING)
    monkeypatch.setattr(outliers, "HELD", NOTHING)
    free = np.vander(np.linspace(-1.0, 1.0, 15), 4)
    for seed in range(20):
        values = np.random.default_rng(seed).normal(0.0, 1e-3, 15)
        values[[7, 12][: 1 + seed % 2]] += 1e-3 * size
        left, order, last = np.arange(15), [], 0
        for taken in (1, 2, 3):
            apart = np.abs(sm.OLS(values[left], free[left]).fit().get_influence().resid_studentized_external)
            order.append(int(left[np.argmax(apart)]))
            if apart.max() > -student.ppf(0.5 * EXPECTED / 15, 15 - 4 - taken):
                last = taken
            left = np.delete(left, np.argmax(apart))
        expected = sorted(order[:last]) if last < 3 else []  # a fifth of the run: the model is wrong
        assert found(judged(values, WHITE, free=free, told=NOTHING), 15) == expected


def test_a_noise_that_is_known_is_not_taken_from_the_readings() -> None:
    assert not found(judged(10.0 * residual(), Noise(3e-4), told=np.inf))  # most are far: the model is wrong
    values = residual()
    values[20] += 2e-3
    assert found(judged(values, Noise(3e-4), told=np.inf)) == [20]


def test_what_repeats_share_stays() -> None:
    values, repeats = residual(), np.tile(np.arange(25), 4)
    values[repeats == 7] += 4e-3
    values[30] += 4e-3
    assert found(judged(values, repeats=repeats)) == [30]


def test_what_lasts_stays() -> None:
    values = residual()
    values[40:46] += 4e-3
    assert not spoilt(judged(values), READINGS)[40:46].all()
    values += 5e-3 * np.random.default_rng(1).standard_normal(100)  # the model is wrong, not the readings
    assert not found(judged(values))


def test_a_step_is_no_outlier() -> None:
    for seed in range(20):
        values = residual(seed, 30)
        values[17:] += 6e-3
        free = np.column_stack([np.ones(30), np.linspace(0.0, 1.0, 30)])
        assert not found(judged(values, Noise(2e-3), free=free, usual=0.02))


def test_a_large_one_takes_no_others_of_a_short_run_with_it() -> None:
    noise = Noise(3e-4, 1.3e-4, 128.0)
    for seed in range(50):
        values = residual(seed, 14)
        values[0] += 0.02
        assert found(judged(values, noise), 1000) == [0]


def test_long_runs_are_judged_piece_by_piece() -> None:
    count = 40 * WINDOW + 7
    values = residual(2, count)
    places = [0, 1, WINDOW, 20 * WINDOW - 1, 20 * WINDOW, count - 1]
    values[places] += 5e-3
    assert found(judged(values)) == places


@pytest.mark.parametrize("told", [AS_MANY, np.inf])
def test_a_run_without_far_readings_is_done_with_at_once_and_no_other(told: float) -> None:
    """Whatever unknowns the readings bend, and wherever one or two are spoilt: by 3 to 12 standard deviations."""
    source = np.random.default_rng(8)
    clean = missed = 0
    for _ in range(1500):
        count = int(source.integers(4, 80))
        free = np.vander(np.linspace(-1.0, 1.0, count), int(source.integers(1, min(6, count - 1))))
        values = source.normal(0.0, 1e-3, count)
        hit = source.choice(count, int(source.integers(0, 3)), replace=False)
        values[hit] += source.uniform(3e-3, 12e-3, hit.size) * source.choice([-1.0, 1.0], hit.size)
        scale = max(1.0, float(np.std(values)) / 1e-3)  # as its own noise would be found
        one = judged(values, Noise(scale * 1e-3), free=free, usual=scale**-2.0, told=told)
        none = surely_none(one.left, one.noise, one.steps, one.usual, 2000)
        missed += none and bool(spoilt(one, 2000).any())
        clean += none and hit.size == 0
    assert missed == 0
    assert clean > 300  # of 500
