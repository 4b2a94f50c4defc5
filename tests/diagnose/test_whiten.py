"""Whitening against the covariance written out, its Cholesky factor, and statsmodels' generalised least squares."""

import numpy as np
import pytest
import statsmodels.api as sm
from hypothesis import given
from hypothesis import strategies as st
from scipy.linalg import cho_factor, cho_solve

from tests.diagnose.prepared import dense_covariance, drawn_noise
from trueaxis.diagnose.result import NoiseOf
from trueaxis.diagnose.whiten import Whitening, solved, tridiagonal, whitened, whitening

NOISES = {
    "white": NoiseOf("laser", 3e-4, 0.0, 0.0, 0.0, 1e6, ""),
    "correlated": NoiseOf("laser", 3e-4, 2e-4, 0.8, 0.0, 1e6, ""),
    "correlated alone": NoiseOf("laser", 0.0, 2e-4, 0.95, 0.0, 1e6, ""),
    "white with slopes": NoiseOf("laser", 3e-4, 0.0, 0.0, 5e-4, 1e6, ""),
    "everything": NoiseOf("laser", 3e-4, 2e-4, 0.8, 5e-4, 1e6, ""),
    "uncorrelated after all": NoiseOf("laser", 3e-4, 2e-4, 0.0, 5e-4, 1e6, ""),
}


@pytest.mark.parametrize("noise", NOISES.values(), ids=NOISES.keys())
@pytest.mark.parametrize("size", [1, 2, 37])
def test_inner_products_are_those_of_the_inverse_covariance(noise: NoiseOf, size: int) -> None:
    columns = np.random.default_rng(3).normal(size=(size, 4))
    found = whitened(noise, columns)
    covariance = dense_covariance(noise, size)
    if size == 1:
        covariance = covariance - noise.slope**2 * 0.25  # one reading has no slope
    expected = columns.T @ cho_solve(cho_factor(covariance), columns)
    assert found.T @ found == pytest.approx(expected, rel=1e-9)


@given(
    white=st.floats(0.05, 3.0),
    correlated=st.floats(0.0, 3.0),
    correlation=st.floats(0.0, 0.99),
    slope=st.floats(0.0, 5.0),
    size=st.integers(2, 60),
)
def test_the_noise_becomes_the_unit_matrix(
    white: float, correlated: float, correlation: float, slope: float, size: int
) -> None:
    noise = NoiseOf("laser", white, correlated, correlation, slope, 1e6, "")
    root = np.asarray(np.linalg.cholesky(dense_covariance(noise, size)), dtype=np.float64)
    found = whitened(noise, root)
    assert found @ found.T == pytest.approx(np.eye(size), abs=1e-8)


def of_three_runs() -> tuple[Whitening, list[tuple[int, NoiseOf]]]:
    runs = [(20, NOISES["everything"]), (33, NOISES["correlated"]), (20, NOISES["everything"])]
    run = np.repeat([0, 2, 5], [size for size, _ in runs])
    return whitening(run, [noise for _, noise in runs]), runs


def test_runs_are_independent_of_each_other() -> None:
    white, runs = of_three_runs()
    size = sum(count for count, _ in runs)
    columns = np.random.default_rng(1).normal(size=(size, 3))
    covariance = np.zeros((size, size))
    first = 0
    for count, noise in runs:
        covariance[first : first + count, first : first + count] = dense_covariance(noise, count)
        first += count
    found = white(columns)
    assert found.T @ found == pytest.approx(columns.T @ np.linalg.solve(covariance, columns), rel=1e-9)
    assert white.part(np.arange(20, 73), columns[20:]) == pytest.approx(found[20:], rel=1e-12)


def test_no_columns_are_none_whitened() -> None:
    for white in (of_three_runs()[0], whitening(np.repeat([0, 1], [450, 20]), [NOISES["everything"]] * 2)):
        nothing = np.zeros((int(white.starts[-1]), 0))
        assert white(nothing).shape == white.back(nothing).shape == nothing.shape
    assert whitened(NOISES["everything"], np.zeros((18, 0))).shape == (18, 0)


@pytest.mark.parametrize("transposed", [False, True])
@pytest.mark.parametrize("columns", [0, 1, 7])
@pytest.mark.parametrize("size", [1, 2, 450])
def test_a_banded_factor_is_taken_back(size: int, columns: int, transposed: bool) -> None:
    """By the dense matrix."""
    factor = tridiagonal(NOISES["everything"], size)
    dense = np.diag(factor[0]) + np.diag(factor[1, : size - 1], -1)
    known = np.random.default_rng(2).normal(size=(size, columns))
    given = (dense.T if transposed else dense) @ known
    assert solved(factor, given, transposed=transposed) == pytest.approx(known, rel=1e-9, abs=1e-12)


def test_back_is_the_transpose() -> None:
    """Short runs by matrices, a long one by recursions: the product of b and a whitened, for any a and b."""
    long = whitening(np.repeat([0, 1], [450, 20]), [NOISES["everything"], NOISES["everything"]])
    for white in (of_three_runs()[0], long):
        source = np.random.default_rng(4)
        a, b = source.normal(size=(2, int(white.starts[-1]), 3))
        assert white.back(b).T @ a == pytest.approx(b.T @ white(a), rel=1e-10)


def test_ramps_are_the_share_that_slopes_have_in_the_noise() -> None:
    white, _ = of_three_runs()
    ramps = white.ramps()
    with_slope = NOISES["everything"]
    covariance = dense_covariance(with_slope, 20)
    way = with_slope.slope * np.linspace(-0.5, 0.5, 20)
    assert ramps[:20] @ ramps[:20] == pytest.approx(way @ np.linalg.solve(covariance, way), rel=1e-9)
    assert not ramps[20:53].any()


def test_least_squares_on_whitened_readings_are_generalised_least_squares() -> None:
    noise, size = NOISES["everything"], 60
    source = np.random.default_rng(8)
    design = np.vander(np.linspace(-1.0, 1.0, size), 5)
    values = design @ source.normal(size=5) * 1e-3 + drawn_noise(source, noise, size)[:, 0]
    expected = sm.GLS(values, design, sigma=dense_covariance(noise, size)).fit()
    white = whitened(noise, design)
    found, rss = np.linalg.lstsq(white, whitened(noise, values), rcond=None)[:2]
    assert found == pytest.approx(expected.params, rel=1e-7)
    assert np.linalg.inv(white.T @ white) == pytest.approx(expected.normalized_cov_params, rel=1e-7)
    assert rss[0] == pytest.approx(expected.ssr, rel=1e-9)
