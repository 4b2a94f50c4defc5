"""The marginal likelihood of the sizes against a dense normal density, and its derivative against differences."""

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import multivariate_normal, norm

from trueaxis.error_name import ErrorName
from trueaxis.estimation.curve_prior import CurvePrior
from trueaxis.estimation.evidence import (
    FARTHEST,
    NO_GAIN,
    SAID,
    _batches,
    _point,
    _slope,
    averaged,
    best_sizes,
    likelier,
    posterior_at,
)
from trueaxis.estimation.factors import triangle_of
from trueaxis.estimation.instruments import CLASSES
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.reduce import OwnBlock, Reduced
from trueaxis.estimation.sizes import Sizes
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import travel_basis

KINDS = [("laser zero", "laser drift"), ("laser zero", "laser drift"), ("ballbar zero", "ballbar drift")]
DEGREE, HARMONICS, RUN = 5, 2, 12
CURVES = 2 * DEGREE + 2 * HARMONICS  # unknowns of both


class Problem:
    """Two curves, one of an axis that turns round, an angle and a scale, read in three runs, all written down as
    matrices; noise 1.
    """

    def __init__(self, seed: int) -> None:
        draw = np.random.default_rng(seed)
        bases = (travel_basis((-100.0, 300.0), DEGREE), travel_basis((0.0, 360.0), DEGREE, HARMONICS))
        layout = SimpleNamespace(
            components=(ErrorName("EXX"), ErrorName("EXC")),
            bases=bases,
            offsets=np.array([0, DEGREE, CURVES]),
            kinds=("translation", "translation", "location rad", "laser scale"),
            count=CURVES + 2,
            of_machine=CURVES + 1,
        )
        self.sizes = Sizes(cast(Layout, layout), KINDS)
        self.jacobian = 30.0 * draw.standard_normal((3 * RUN, layout.count))
        self.own = [draw.standard_normal((RUN, 2)) / np.array([CLASSES[k].size for k in kinds]) for kinds in KINDS]
        self.readings = 20.0 * draw.standard_normal(3 * RUN)
        blocks, rest = [], []
        for index, own in enumerate(self.own):
            rows = slice(index * RUN, (index + 1) * RUN)
            t = triangle_of([np.column_stack([own, self.jacobian[rows], self.readings[rows]])])
            blocks.append(OwnBlock(kinds=KINDS[index], own=t[:2, :2], others=t[:2, 2:-1], readings=t[:2, -1]))
            rest.append(t[2:, 2:])
        n = layout.count
        folded = triangle_of([*rest, np.zeros((n + 1, n + 1))])
        self.reduced = Reduced(
            triangle=folded[:n, :n], readings=folded[:n, n], rest=float(folded[n, n] ** 2), blocks=tuple(blocks),
            log_root=0.0,
        )  # fmt: skip

    def value(self, x: FloatArray) -> float:
        return _point(self.sizes, self.reduced, _batches(self.reduced.blocks), x).value

    def dense(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Prior standard deviations, and the covariance of the readings."""
        scale = np.exp(self.sizes.scale(x)[0])
        covariance = np.eye(3 * RUN) + (self.jacobian * scale**2) @ self.jacobian.T
        for index, (own, kinds) in enumerate(zip(self.own, KINDS, strict=True)):
            rows = slice(index * RUN, (index + 1) * RUN)
            covariance[rows, rows] += (own * self.sizes.own_scale(kinds, x) ** 2) @ own.T
        return scale, covariance


@pytest.mark.parametrize("seed", range(4))
def test_it_is_the_density_of_the_readings(seed: int) -> None:
    problem, draw = Problem(seed), np.random.default_rng(seed)
    for x in 0.6 * draw.standard_normal((5, problem.sizes.spread.size)):
        _, covariance = problem.dense(x)
        expected = multivariate_normal(cov=covariance).logpdf(problem.readings) + 1.5 * RUN * np.log(2.0 * np.pi)
        assert problem.value(x) == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("seed", range(4))
def test_its_derivative_is_that_of_differences(seed: int) -> None:
    problem, draw = Problem(seed), np.random.default_rng(seed)
    x = 0.6 * draw.standard_normal(problem.sizes.spread.size)
    slope = _slope(problem.sizes, _point(problem.sizes, problem.reduced, _batches(problem.reduced.blocks), x))
    for place in range(x.size):
        step = np.eye(x.size)[place] * 1e-5
        assert slope[place] == pytest.approx((problem.value(x + step) - problem.value(x - step)) / 2e-5, abs=1e-5)


def test_mean_and_covariance_are_those_of_the_normal_distribution() -> None:
    problem = Problem(1)
    x = np.full(problem.sizes.spread.size, 0.2)
    posterior = posterior_at(problem.sizes, problem.reduced, x)
    scale, covariance = problem.dense(x)
    gain = (problem.jacobian * scale**2).T @ np.linalg.inv(covariance)
    np.testing.assert_allclose(posterior.mean, gain @ problem.readings, atol=1e-9)
    expected = np.diag(scale**2) - gain @ (problem.jacobian * scale**2)
    np.testing.assert_allclose(posterior.spread @ posterior.spread.T, expected, atol=1e-9)
    for index, (own, kinds) in enumerate(zip(problem.own, KINDS, strict=True)):
        rows = slice(index * RUN, (index + 1) * RUN)
        cross = np.zeros((2, 3 * RUN))
        cross[:, rows] = (own * problem.sizes.own_scale(kinds, x) ** 2).T
        mean = cross @ np.linalg.solve(covariance, problem.readings)
        np.testing.assert_allclose(posterior.own[index].mean, mean, rtol=1e-6, atol=1e-12)


def test_uncertain_sizes_widen_the_posterior() -> None:
    problem = Problem(2)
    x, best = best_sizes(problem.sizes, problem.reduced, np.zeros(problem.sizes.spread.size))
    wide = averaged(problem.sizes, problem.reduced, x)
    assert np.linalg.norm(wide.spread) > np.linalg.norm(best.spread)


@pytest.mark.parametrize("silent", ["location rad", "EXC", "translation"])
def test_u_of_what_no_reading_tells_covers_all_its_sizes(silent: str) -> None:
    """Whatever the sizes are by their priors: within 1.96 u lie 95 % of what is drawn with them."""
    problem = Problem(3)
    sizes = problem.sizes
    unread = {"location rad": [CURVES], "EXC": range(DEGREE, CURVES), "translation": range(CURVES)}[silent]
    triangle = problem.reduced.triangle.copy()
    triangle[:, unread] = 0.0
    blocks = []
    for block in problem.reduced.blocks:
        others = block.others.copy()
        others[:, unread] = 0.0
        blocks.append(replace(block, others=others))
    reduced = replace(problem.reduced, triangle=triangle, blocks=tuple(blocks))
    x, _ = best_sizes(sizes, reduced, np.zeros(sizes.spread.size))
    u = np.linalg.norm(averaged(sizes, reduced, x).spread, axis=1)
    draw = np.random.default_rng(5)
    root = np.linalg.inv(np.linalg.cholesky(sizes.information(posterior_at(sizes, reduced, x), sizes.scale(x)[1])))
    drawn = x + draw.standard_normal((4000, x.size)) @ root
    scales = np.exp([sizes.scale(one)[0] for one in drawn])
    for place in unread:
        within = np.mean(2.0 * norm.cdf(1.96 * u[place] / scales[:, place]) - 1.0)
        assert 0.93 < within < 0.99


def test_a_size_is_said_to_be_off_by_how_much_likelier_it_is() -> None:
    problem = Problem(4)
    sizes = problem.sizes
    scaled = replace(problem.reduced, readings=problem.reduced.readings * 40.0, rest=problem.reduced.rest * 1600.0)
    x, _ = best_sizes(sizes, scaled, np.zeros(sizes.spread.size))
    told = likelier(sizes, scaled, x)
    assert told.keys() == {name for k, name in enumerate(sizes.of_errors) if abs(x[k] * sizes.spread[k]) > np.log(SAID)}
    assert "translation" in told
    batches = _batches(scaled.blocks)

    def cost(free: FloatArray, fixed: float) -> float:
        whole = np.concatenate([[fixed], free])
        return 0.5 * float(whole @ whole) - _point(sizes, scaled, batches, whole).value

    bounds = [(-FARTHEST, FARTHEST)] * (x.size - 1)
    there = minimize(cost, x[1:], args=(0.0,), method="L-BFGS-B", bounds=bounds)
    assert told["translation"] == pytest.approx(there.fun - cost(x[1:], x[0]), rel=0.01, abs=0.02)
    assert likelier(sizes, problem.reduced, np.zeros(x.size)) == {}


@pytest.mark.parametrize("seed", range(6))
def test_the_sizes_are_those_that_plain_values_lead_to(seed: int) -> None:
    problem = Problem(seed)
    count = problem.sizes.spread.size

    def cost(x: FloatArray) -> float:
        return 0.5 * float(x @ x) - problem.value(x)

    other = minimize(cost, np.zeros(count), method="L-BFGS-B", bounds=[(-FARTHEST, FARTHEST)] * count)
    x, posterior = best_sizes(problem.sizes, problem.reduced, np.zeros(count))
    assert cost(x) < other.fun + 10.0 * NO_GAIN
    np.testing.assert_allclose(x, other.x, atol=0.1)
    np.testing.assert_array_equal(posterior.mean, posterior_at(problem.sizes, problem.reduced, x).mean)


@pytest.mark.parametrize(
    ("travel", "harmonics"),
    [((-100.0, 300.0), 0), ((0.0, 500.0), 0), ((-900.0, -200.0), 0), ((0.0, 720.0), 8), ((90.0, 450.0), 8)],
)
@pytest.mark.parametrize("shape", [(0.0, 0.0), (0.6, -0.4)])
def test_a_curve_of_the_prior_has_its_size(
    travel: tuple[float, float], harmonics: int, shape: tuple[float, float]
) -> None:
    """Where an axis turns round half of its mean square repeats."""
    basis = travel_basis(travel, 10, harmonics)
    log, slope = CurvePrior(basis).log_weights(np.array(shape))
    at = np.linspace(*travel, 4001)
    squares = np.mean(np.exp(2.0 * log)[:, np.newaxis] * basis(at) ** 2, axis=1)
    assert squares.sum() == pytest.approx(1.0, abs=2e-3)
    assert squares[10:].sum() == pytest.approx(0.5 if harmonics else 0.0, abs=2e-3)
    for place in range(2):
        step = np.eye(2)[place] * 1e-6
        ahead, behind = (CurvePrior(basis).log_weights(np.array(shape) + sign * step)[0] for sign in (1, -1))
        np.testing.assert_allclose(slope[place], (ahead - behind) / 2e-6, atol=1e-6)
