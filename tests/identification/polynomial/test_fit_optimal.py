"""Properties of the optimal polynomial that hold whatever the data."""

from collections.abc import Callable
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from statsmodels.regression.linear_model import OLS

from trueaxis.identification.polynomial import checked_samples, fit_optimal, fit_terms, statistics_table
from trueaxis.identification.polynomial.regression import reduced_system

FloatArray = NDArray[np.float64]
SEEDS = st.integers(0, 10_000)
X = np.linspace(0.0, 540.0, 28)


def noisy(seed: int, x: FloatArray = X, noise: float = 0.3) -> FloatArray:
    random = np.random.default_rng(seed)
    return 4.0 * np.sin(x / random.uniform(80.0, 400.0)) + random.normal(0.0, noise, x.size)


@pytest.mark.parametrize("n", [9, 28, 200])
def test_sums_of_squares_of_all_subsets_are_those_of_statsmodels(n: int) -> None:
    x = np.linspace(-200.0, 540.0, n)
    y = noisy(3, x)
    weights = np.random.default_rng(9).uniform(0.2, 3.0, n)
    system = reduced_system(checked_samples(x, y, weights), 7)
    root = np.sqrt(weights)
    for size in range(1, 8):
        for powers in combinations(range(1, 8), size):
            design = (x[:, np.newaxis] / 540.0) ** np.array(powers)
            ssr = OLS(root * y, root[:, np.newaxis] * design).fit().ssr
            assert system.rss(powers) == pytest.approx(ssr, rel=1e-9)
    assert system.rss(()) == pytest.approx(weights @ y**2, rel=1e-12)


@pytest.mark.parametrize("seed", range(5))
def test_a_model_the_search_stops_at_has_no_better_neighbour(seed: int) -> None:
    fit = fit_optimal(X, noisy(seed), order=7)
    left_out = {int(step.change[1:]) for step in fit.steps[1:] if step.reason != "AIC"}
    for other in set(range(1, 8)) - left_out:
        neighbour = tuple(sorted(set(fit.after.powers) ^ {other}))
        assert fit_terms(fit.samples, neighbour).aic >= fit.after.aic


@settings(deadline=None)
@given(SEEDS, st.floats(0.01, 100.0), st.floats(1e-9, 1e9))
def test_units_of_position_and_value_change_nothing_but_units(seed: int, mm: float, rad: float) -> None:
    y = noisy(seed)
    fit, other = fit_optimal(X, y), fit_optimal(X * mm, y * rad)
    assert other.after.powers == fit.after.powers
    powers = np.array(fit.after.powers, dtype=np.float64)
    assert other.after.coefficients == pytest.approx(fit.after.coefficients * rad * mm**-powers, rel=1e-7, abs=0.0)
    assert other.after.u == pytest.approx(fit.after.u * rad * mm**-powers, rel=1e-7, abs=0.0)
    assert other.after.p_values == pytest.approx(fit.after.p_values, rel=1e-6, abs=1e-280)
    assert other.after.adjusted_r_squared == pytest.approx(fit.after.adjusted_r_squared, rel=1e-10)


@settings(deadline=None)
@given(SEEDS, st.permutations(range(28)))
def test_the_order_of_the_points_does_not_matter(seed: int, order: list[int]) -> None:
    y = noisy(seed)
    fit, other = fit_optimal(X, y), fit_optimal(X[order], y[order])
    assert other.after.powers == fit.after.powers
    assert other.after.coefficients == pytest.approx(fit.after.coefficients, rel=1e-7, abs=0.0)
    assert other.verdict == fit.verdict


@settings(deadline=None)
@given(SEEDS)
def test_mirroring_the_axis_flips_the_odd_coefficients(seed: int) -> None:
    y = noisy(seed)
    fit, other = fit_optimal(X, y), fit_optimal(-X, y)
    signs = (-1.0) ** np.array(fit.after.powers)
    assert other.after.powers == fit.after.powers
    assert other.after.coefficients == pytest.approx(signs * fit.after.coefficients, rel=1e-9, abs=0.0)


@settings(deadline=None)
@given(SEEDS)
def test_adding_a_polynomial_to_the_values_adds_it_to_the_full_fit_and_leaves_the_residuals(seed: int) -> None:
    added = np.random.default_rng(seed + 1).normal(size=7) * 540.0 ** -np.arange(1.0, 8.0)
    y = noisy(seed)
    fit = fit_optimal(X, y, order=7).before
    other = fit_optimal(X, y + (X[:, np.newaxis] ** np.arange(1.0, 8.0)) @ added, order=7).before
    scale = 540.0 ** np.arange(1.0, 8.0)
    size = np.abs(fit.coefficients * scale).max()
    assert np.abs((other.coefficients - fit.coefficients - added) * scale).max() < 1e-9 * size
    assert other.residual_standard_error == pytest.approx(fit.residual_standard_error, rel=1e-9)
    assert other.covariance == pytest.approx(fit.covariance, rel=1e-8, abs=0.0)


@settings(deadline=None)
@given(st.sets(st.integers(1, 7), min_size=1), SEEDS)
def test_an_exact_polynomial_is_recovered_with_no_other_term(powers: set[int], seed: int) -> None:
    random = np.random.default_rng(seed)
    exponents = np.array(sorted(powers), dtype=np.float64)
    scaled = random.uniform(1.0, 3.0, exponents.size) * random.choice([-1.0, 1.0], exponents.size)
    x = np.linspace(0.0, 1.0, 60)
    fit = fit_optimal(x * 540.0, (x[:, np.newaxis] ** exponents) @ scaled)
    assert fit.after.powers == tuple(sorted(powers))
    assert fit.after.coefficients * 540.0**exponents == pytest.approx(scaled, rel=1e-9)


def test_covariance_goes_with_u_and_with_the_spread_of_repeated_fits() -> None:
    truth = 0.08 * X - 6e-4 * X**2 + 9e-7 * X**3
    samples = [checked_samples(X, truth + np.random.default_rng(s).normal(0.0, 0.3, 28)) for s in range(400)]
    fits = [fit_terms(sample, (1, 2, 3)) for sample in samples]
    predicted = fit_terms(samples[0], (1, 2, 3))
    assert np.sqrt(np.diag(predicted.covariance)) == pytest.approx(predicted.u, rel=1e-10)
    spread = np.std([fit.at(X) for fit in fits], axis=0)[1:]
    level = 0.3 / predicted.residual_standard_error
    assert predicted.u_at(X)[1:] * level == pytest.approx(spread, rel=0.15)
    scaled = predicted.u_at(X)[0]
    assert scaled == 0.0


def test_only_ratios_of_weights_count() -> None:
    weights = np.random.default_rng(1).uniform(0.5, 2.0, 28)
    one, other = (fit_optimal(X, noisy(1), weights=weights * level).after for level in (1.0, 1e12))
    assert other.powers == one.powers
    assert other.u == pytest.approx(one.u, rel=1e-9)


def test_a_point_of_weight_two_counts_as_two_points_in_the_coefficients() -> None:
    y = noisy(4)
    weights = np.ones(28)
    weights[10] = 2.0
    weighted = fit_terms(checked_samples(X, y, weights), (1, 2, 3))
    repeated = fit_terms(checked_samples(np.append(X, X[10]), np.append(y, y[10])), (1, 2, 3))
    assert weighted.coefficients == pytest.approx(repeated.coefficients, rel=1e-10)
    assert weighted.rss == pytest.approx(repeated.rss, rel=1e-10)


def test_the_order_is_the_one_of_least_mean_square() -> None:
    y = noisy(2)
    fit = fit_optimal(X, y)
    least = [np.linalg.lstsq((X[:, None] / 540) ** np.arange(1, p + 1), y, rcond=None)[1][0] for p in range(1, 8)]
    mean_squares = np.array(least) / (28 - np.arange(1, 8))
    assert fit.mean_squares == pytest.approx(mean_squares, rel=1e-9)
    assert fit.order == 1 + mean_squares.argmin()
    assert fit.before.powers == tuple(range(1, fit.order + 1))


def test_noise_alone_gets_an_empty_polynomial_that_says_so() -> None:
    fit = fit_optimal(X, np.random.default_rng(5).normal(size=28))
    assert fit.before.f_p_value > 0.05
    assert fit.after.powers == ()
    assert not fit.passed
    assert fit.verdict.startswith("no polynomial describes the values")
    assert fit.after.at(X) == pytest.approx(np.zeros(28))
    assert fit.after.u_at(X) == pytest.approx(np.zeros(28))


def test_values_that_are_all_zero_get_an_empty_polynomial_that_says_so() -> None:
    fit = fit_optimal(X, np.zeros(28))
    assert fit.after.powers == ()
    assert fit.verdict == "every value is zero: the polynomial is empty"


def test_an_exact_line_leaves_every_statistic_finite() -> None:
    fit = fit_optimal([0.0, 1.0, 2.0, 4.0, 8.0], [0.0, 2.0, 4.0, 8.0, 16.0])
    assert fit.after.powers == (1,)
    assert fit.after.coefficients == pytest.approx([2.0], rel=1e-15)
    assert fit.after.r_squared == 1.0
    assert np.isfinite([fit.after.aic, fit.after.f_statistic, fit.after.residual_standard_error, *fit.after.u]).all()
    assert fit.after.residual_standard_error < 1e-13


def test_repeated_positions_are_observations_of_their_own_and_limit_the_order() -> None:
    x = np.repeat([0.0, 100.0, 200.0, 300.0], 6)
    fit = fit_optimal(x, 0.01 * x + np.random.default_rng(0).normal(0.0, 0.1, x.size))
    assert len(fit.mean_squares) == 3  # three positions away from 0 tell three powers apart
    assert fit.after.residual_df == 24 - len(fit.after.powers)
    assert np.abs(fit.after.at(x) - 0.01 * x).max() < 0.1
    with pytest.raises(ValueError, match="powers up to 3 only, not 4"):
        fit_optimal(x, 0.01 * x, order=4)


def test_a_short_stretch_far_from_zero_is_fitted_with_the_powers_it_can_tell_apart() -> None:
    x = np.linspace(690.0, 700.0, 40)
    fit = fit_optimal(x, 1e-3 * x + np.random.default_rng(2).normal(0.0, 1e-4, 40))
    assert 1 <= len(fit.mean_squares) < 7
    assert np.abs(fit.after.at(x) - 1e-3 * x).max() < 2e-4


def test_the_order_is_limited_by_the_number_of_points() -> None:
    x = np.linspace(100.0, 400.0, 4)
    assert len(fit_optimal(x, [1.0, 2.1, 2.9, 4.2]).mean_squares) == 3
    with pytest.raises(ValueError, match="4 points determine powers up to 3 only, not 7"):
        fit_optimal(x, [1.0, 2.1, 2.9, 4.2], order=7)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: fit_optimal([1.0, 2.0, np.nan], [1.0, 2.0, 3.0]), "positions must be finite; see points 2"),
        (lambda: fit_optimal([1.0, 2.0, 3.0], [np.inf, 2.0, 3.0]), "values must be finite; see points 0"),
        (lambda: fit_optimal([1.0, 2.0], [1.0, 2.0, 3.0]), "of one length"),
        (lambda: fit_optimal([[1.0, 2.0]], [[1.0, 2.0]]), "one-dimensional"),
        (lambda: fit_optimal([1.0], [1.0]), "at least 2 points"),
        (lambda: fit_optimal([], []), "at least 2 points"),
        (lambda: fit_optimal([0.0, 0.0], [1.0, 2.0]), "away from position 0"),
        (lambda: fit_optimal([1.0, 2.0], [1.0, 2.0], weights=[1.0, 0.0]), "weights must be positive; see points 1"),
        (lambda: fit_optimal([1.0, 2.0], [1.0, 2.0], max_order=0), "at least 1"),
        (lambda: fit_optimal([1.0, 2.0], [1.0, 2.0], alpha=0.0), "alpha"),
    ],
)
def test_bad_input_is_refused_with_its_reason(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


def test_everything_wrong_is_said_at_once() -> None:
    with pytest.raises(ValueError, match=r"positions must be finite.*values must be finite.*one length"):
        fit_optimal([np.nan, 1.0], [np.inf, 1.0, 2.0])


def test_the_table_shows_both_sides() -> None:
    fit = fit_optimal(X, 1e-6 * noisy(0), order=7)
    table = statistics_table(fit, "urad", 1e6).splitlines()
    assert table[1].split() == ["terms", "7", str(len(fit.after.powers))]
    assert f"{fit.after.residual_standard_error * 1e6:.5g}" in table[2]
    dropped = set(range(1, 8)) - set(fit.after.powers)
    assert {int(line.split()[2][2:]) for line in table if line.endswith("-")} == dropped
