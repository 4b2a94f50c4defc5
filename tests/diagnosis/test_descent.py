"""The likeliest noise: the descent beside SciPy's solvers, the slopes and the information by finite differences."""

import numpy as np
import pytest
from scipy.linalg import block_diag
from scipy.optimize import lsq_linear, minimize

from tests.diagnosis.prepared import SIGMA, FloatArray, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.null_model.base import base_of
from trueaxis.diagnosis.null_model.descent import Here, least
from trueaxis.diagnosis.null_model.noise_blocks import Blocks
from trueaxis.diagnosis.null_model.noise_fit import BOUNDS, FARTHEST, MISFIT, PER, SQUARES, START, Likelihood
from trueaxis.diagnosis.null_model.noise_law import Guess


@pytest.mark.parametrize("seed", range(6))
def test_least_squares_within_bounds_are_those_of_scipy(seed: int) -> None:
    source = np.random.default_rng(seed)
    a, b = source.standard_normal((30, 8)), source.standard_normal(30)
    low, high = -source.uniform(0.0, 0.2, 8), source.uniform(0.0, 0.2, 8)

    def tell(x: FloatArray) -> Here:
        rest = a @ x - b
        return Here(5e3 * float(rest @ rest), 1e4 * a.T @ rest, 1e4 * a.T @ a)

    found, value = least(tell, np.zeros(8), low, high)
    expected = lsq_linear(a, b, (low, high), tol=1e-14)
    assert (found >= low).all()
    assert (found <= high).all()
    assert value == pytest.approx(5e3 * 2.0 * expected.cost, abs=0.02)


def test_variances_that_are_zero_are_found_and_left() -> None:
    """Minus the logarithm of the likelihood of variances of groups, the first of which has none beside the noise."""
    squares, count = np.array([0.8, 4.0, 25.0]), np.array([20.0, 20.0, 20.0])

    def tell(x: FloatArray) -> Here:
        whole = 1.0 + x
        value = 0.5 * float(np.sum(count * (np.log(whole) + squares / whole)))
        return Here(value, 0.5 * count * (1.0 - squares / whole) / whole, np.diag(0.5 * count * squares / whole**3))

    for start in (0.0, 1.0, 1e3):
        found, _ = least(tell, np.full(3, start), np.zeros(3), np.full(3, 1e6))
        assert found == pytest.approx([0.0, 3.0, 24.0], rel=0.05)


def likelihood() -> tuple[Likelihood, FloatArray]:
    """Of lines with repeats and circles, and parameters at which every size counts."""
    design = Design(lines=1, repeats=2, targets=11, samples=24)
    case = prepared(Case(seed=1, design=design, noise="none", given="exact"))
    base = base_of(case.model, case.rows)
    source = np.random.default_rng(3)
    values = SIGMA * source.standard_normal(case.rows.size)
    block = next(Blocks(case.rows, base).of(values))
    groups = [one.noise_group for one in base.runs]
    of = Likelihood(block, groups, {name: Guess(SIGMA, 0.5) for name in dict.fromkeys(groups)})
    each = np.tile(START, of.units.size) * source.uniform(0.7, 1.3, PER * of.units.size)
    return of, np.concatenate([each, source.normal(0.0, 0.1, len(groups))])


def test_slopes_are_finite_differences_of_the_likelihood() -> None:
    of, x = likelihood()
    slope = of(x).slope
    for place in range(x.size):
        step = np.zeros(x.size)
        step[place] = 1e-4 * max(abs(x[place]), 0.1)
        expected = (of(x + step).value - of(x - step).value) / (2.0 * step[place])
        assert slope[place] == pytest.approx(expected, rel=1e-4, abs=1e-4)


def test_the_information_is_the_average_one() -> None:
    """Half of what covariances change by, P between, on both sides of the weighed readings; by finite differences."""
    of, x = likelihood()
    expected = np.zeros((x.size, x.size))
    for number, one in enumerate(of.told(x)[1]):
        changes = np.empty((one.weighed.size, x.size))
        for place in range(x.size):
            step = np.zeros(x.size)
            step[place] = 1e-4 * max(abs(x[place]), 0.1)
            more, less = covariance(of, x + step, number), covariance(of, x - step, number)
            changes[:, place] = (more - less) @ one.weighed / (2.0 * step[place])
        expected += 0.5 * changes.T @ one.precision.dense() @ changes
    prior = of(x).information - expected
    assert prior == pytest.approx(np.diag(np.diag(prior)), abs=1e-4 * np.abs(expected).max())
    assert np.diag(prior)[list(SQUARES)] == pytest.approx(0.0, abs=1e-4 * np.abs(expected).max())


def covariance(of: Likelihood, x: FloatArray, number: int) -> FloatArray:
    """Of the readings of a part."""
    one = of.told(x)[1][number]
    misfit = of.sizes(x)[one.number, MISFIT]
    return np.asarray(block_diag(*one.noise) + misfit**2 * one.part.repeated @ one.part.repeated.T)


def test_the_descent_comes_at_least_as_low_as_scipy() -> None:
    of, x = likelihood()
    bounds = np.array([*BOUNDS * of.units.size, *[(-FARTHEST, FARTHEST)] * (x.size - of.count)])

    def both(at: FloatArray) -> tuple[float, FloatArray]:
        here = of(at)
        return here.value, here.slope

    ends = [(low, high) for low, high in bounds.tolist()]
    expected = minimize(both, x, jac=True, method="L-BFGS-B", bounds=ends, options={"ftol": 1e-12})
    _, value = least(of, x, *bounds.T)
    assert value < expected.fun + 0.05
