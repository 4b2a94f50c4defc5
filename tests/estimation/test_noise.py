"""White and slow noise: whitening against dense matrices, and the noise that residuals are made of found again."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.estimation.noise_of_residuals import first_noise, noise_of_draws
from trueaxis.measurement.machine import FloatArray


def covariance(noise: Noise, time: FloatArray) -> FloatArray:
    """Of readings at times in typical steps, written down."""
    apart = np.abs(time[:, np.newaxis] - time)
    return np.asarray(noise.white**2 * np.eye(time.size) + noise.slow**2 * np.exp(-apart / noise.lasts))


@given(
    st.integers(1, 30),
    st.integers(0, 2**32 - 1),
    st.floats(1e-4, 1.0),
    st.sampled_from([0.0, 0.1, 1.0, 30.0]),
    st.floats(0.3, 200.0),
)
def test_whitening_is_the_inverse_root_of_the_covariance(
    count: int, seed: int, white: float, slow: float, lasts: float
) -> None:
    draw = np.random.default_rng(seed)
    steps = np.r_[0.0, draw.uniform(0.05, 4.0, count - 1)]
    noise = Noise(white, slow, lasts)
    dense = 1.7**2 * covariance(noise, np.cumsum(steps))
    inverse = np.linalg.inv(dense)
    columns = draw.standard_normal((count, 3))
    cut = int(draw.integers(0, count + 1))
    whiten = Whitening(noise, steps, 1.7)
    white_columns = np.vstack([whiten(columns[:cut]), whiten(columns[cut:])]) if 0 < cut < count else whiten(columns)
    size = np.abs(inverse).max()
    np.testing.assert_allclose(white_columns.T @ white_columns, columns.T @ inverse @ columns, atol=1e-7 * size * count)
    assert whiten.log_root == pytest.approx(0.5 * np.linalg.slogdet(dense)[1], abs=1e-6)
    np.testing.assert_allclose(
        Whitening(noise, steps, 1.7).weighed(columns[:, 0]), inverse @ columns[:, 0], atol=1e-7 * size * count
    )
    np.testing.assert_allclose(Whitening(noise, steps, 1.7).weights(), np.diag(inverse), rtol=1e-6)


def drawn(noise: Noise, steps: FloatArray, draw: np.random.Generator) -> FloatArray:
    root = np.linalg.cholesky(covariance(noise, np.cumsum(steps)))
    return np.asarray(root @ draw.standard_normal(steps.size))


@pytest.mark.parametrize("noise", [Noise(3e-4), Noise(2e-4, 3e-4, 8.0), Noise(1e-4, 5e-4, 64.0)], ids=str)
def test_noise_is_found_again(noise: Noise) -> None:
    draw = np.random.default_rng(5)
    steps = [np.r_[0.0, draw.uniform(0.7, 1.4, 119)] for _ in range(25)]
    found, scales = noise_of_draws([drawn(noise, one, draw)[:, np.newaxis] for one in steps], steps)
    assert found.sigma == pytest.approx(noise.sigma, rel=0.1)
    assert found.white == pytest.approx(noise.white, rel=0.15)
    assert 0.5 * noise.lasts <= found.lasts <= 2.0 * noise.lasts or noise.slow == 0.0
    np.testing.assert_allclose(scales, 1.0, atol=0.25)


def test_a_run_that_is_noisier_is_found() -> None:
    draw = np.random.default_rng(6)
    steps = [np.r_[0.0, np.ones(79)] for _ in range(10)]
    values = [draw.normal(0.0, 3e-4 if place == 4 else 1e-4, 80)[:, np.newaxis] for place in range(10)]
    _, scales = noise_of_draws(values, steps)
    assert int(np.argmax(scales)) == 4
    assert scales[4] > 1.8


def test_the_first_guess_is_the_noise_where_readings_are_close() -> None:
    draw = np.random.default_rng(7)
    s = np.linspace(0.0, 1.0, 400)
    values = [20e-3 * np.sin(3.0 * s + place) + draw.normal(0.0, 5e-4, 400) for place in range(4)]
    assert first_noise(values).white == pytest.approx(5e-4, rel=0.1)
    assert first_noise([np.array([1e-3]), np.array([3e-3])]).white > 0.0
