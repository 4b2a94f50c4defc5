"""The two parts of the posterior covariance against drawn machines and readings, with a gain from a dense formula."""

import numpy as np
import pytest

from tests.estimation.test_estimate import SMALL, estimated
from tests.estimation.test_evidence import Problem
from tests.worlds.estimates import World, world
from trueaxis.estimation.evidence import averaged, posterior_at
from trueaxis.estimation.factors import triangle_of
from trueaxis.estimation.gauge import covariance_of, levelling
from trueaxis.estimation.judgement import determined_by, judged_component, judged_location
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.posterior import parted_root
from trueaxis.estimation.reduce import Reduced
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.sizes import Sizes
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.model import home_of
from trueaxis.model.uncertainty import tool_uncertainty

READINGS, DRAWS = 150, 6000


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> World:
    return world(SMALL, tmp_path_factory.mktemp("world"))


@pytest.fixture(scope="module")
def found(small: World) -> Estimate:
    return estimated(small, 2)


def reduced(jacobian: FloatArray) -> Reduced:
    """Of readings that are zero, with a noise of 1."""
    n = jacobian.shape[1]
    triangle = triangle_of([jacobian, np.zeros((n, n))])
    return Reduced(triangle=triangle, readings=np.zeros(n), rest=0.0, blocks=(), log_root=0.0)


def split(root: FloatArray, of_prior: int) -> tuple[FloatArray, FloatArray]:
    """Standard deviations of the parts by the readings and by the prior."""
    parts = np.split(root, [root.shape[1] - of_prior], axis=1)
    readings, prior = (np.linalg.norm(part, axis=1) for part in parts)
    return readings, prior


def test_both_parts_are_those_of_drawn_machines_and_readings(found: Estimate) -> None:
    """Fewer readings than unknowns, levelled: the mean is wrong by K e + K J b on the instruments' side, else by
    (1 - K J) a; 6000 draws know a standard deviation to 0.9 %.
    """
    layout: Layout = found.layout
    draw = np.random.default_rng(3)
    n, m = layout.count, layout.of_machine
    assert n > m
    sizes = Sizes(layout, [])
    x = np.zeros(sizes.spread.size)
    scale = np.exp(sizes.scale(x)[0])
    jacobian = draw.standard_normal((READINGS, n)) * np.exp(draw.uniform(-2.0, 4.0, n))
    gain = (jacobian * scale**2).T @ np.linalg.inv((jacobian * scale**2) @ jacobian.T + np.eye(READINGS))
    machine, rest = scale[:m, np.newaxis] * draw.standard_normal((m, DRAWS)), np.zeros((n - m, DRAWS))
    instruments = scale[m:, np.newaxis] * draw.standard_normal((n - m, DRAWS))
    noise = draw.standard_normal((READINGS, DRAWS))
    of_readings = gain @ (noise + jacobian[:, m:] @ instruments)
    of_prior = gain @ (jacobian[:, :m] @ machine) - np.vstack([machine, rest])
    level = levelling(layout) * layout.sizes
    posterior = posterior_at(sizes, reduced(jacobian), x)
    root, columns = parted_root([posterior], posterior.mean, m)
    readings, prior = split(level @ root, columns)
    rows = np.flatnonzero(np.linalg.norm(level, axis=1) > 0.0)
    rows = rows[rows < m]
    for expected, part in ((of_readings, readings), (of_prior, prior)):
        drawn = np.sqrt(np.mean((level @ expected) ** 2, axis=1))
        known = rows[drawn[rows] > 1e-9 * drawn.max()]
        np.testing.assert_allclose(part[known], drawn[known], rtol=0.05)
    assert 0.1 < np.median(prior[rows] / np.hypot(readings, prior)[rows]) < 1.0
    np.testing.assert_allclose(root @ root.T, posterior.spread @ posterior.spread.T, atol=1e-12)


def test_uncertain_sizes_are_the_priors() -> None:
    """The covariance of the mixture is the sum of both parts, and its members' parts are those of a dense formula."""
    problem = Problem(3)
    x = np.full(problem.sizes.spread.size, 0.1)
    whole = averaged(problem.sizes, problem.reduced, x)
    readings, prior = np.split(whole.spread, [whole.spread.shape[1] - whole.of_prior], axis=1)
    one = posterior_at(problem.sizes, problem.reduced, x)
    scale, covariance = problem.dense(x)
    gain = (problem.jacobian * scale**2).T @ np.linalg.inv(covariance)
    of_machine = problem.sizes.layout.of_machine
    open_part = (np.eye(scale.size) - gain @ problem.jacobian)[:, :of_machine] * scale[:of_machine]
    root, columns = parted_root([one], one.mean, of_machine)
    np.testing.assert_allclose(root[:, -columns:] @ root[:, -columns:].T, open_part @ open_part.T, atol=1e-10)
    # drawn sizes: the means of the mixture differ, which no reading causes
    assert np.linalg.norm(prior) > np.linalg.norm(open_part)
    assert np.linalg.norm(readings) > 0.0


def test_the_parts_reach_the_tool_point(small: World, found: Estimate) -> None:
    level = found.levelled()
    covariance = covariance_of(level.layout, level.spread, level.of_prior)
    model = small.model.with_values(level.values)
    draw = np.random.default_rng(1)
    positions = np.array([draw.uniform(*model.travel[axis], 20) for axis in model.axes])
    there = tool_uncertainty(model, covariance, positions, np.zeros((3, 1)), datum=home_of(model))
    assert (there.u_prior <= there.u * (1.0 + 1e-9)).all()
    assert (there.u_prior > 0.0).any()
    # what is seen from home does not depend on the convention, nor do its parts
    before = covariance_of(found.layout, found.spread, found.of_prior)
    as_found = tool_uncertainty(model, before, positions, np.zeros((3, 1)), datum=home_of(model))
    np.testing.assert_allclose(there.u_prior, as_found.u_prior, rtol=1e-5, atol=1e-9)


def test_values_are_judged_by_their_parts(found: Estimate) -> None:
    level = found.levelled()
    judged = [judged_component(level, name) for name in level.layout.components]
    judged += [judged_location(level, name) for name in level.layout.locations]
    for one in judged:
        assert np.hypot(one.u_readings_rms, one.u_prior_rms) == pytest.approx(one.u_rms, rel=1e-6, abs=1e-15)
    assert {one.determined for one in judged} <= {"partly", "prior"}  # ball bars alone: no curve is theirs


@pytest.mark.parametrize(
    ("u", "u_readings", "u_prior", "expected"),
    [
        (5.0, 4.0, 3.0, "data"),  # the prior's part is the smaller one
        (0.95, 0.1, 0.94, "data"),  # below a tenth of the prior of 10
        (5.0, 3.0, 4.0, "partly"),
        (9.5, 3.0, 9.0, "prior"),
    ],
)
def test_the_rule_of_determined(u: float, u_readings: float, u_prior: float, expected: str) -> None:
    assert determined_by(u, u_readings, u_prior, 10.0) == expected


def test_without_readings_all_is_the_priors() -> None:
    one = Problem(1)
    none = Reduced(
        triangle=np.zeros_like(one.reduced.triangle),
        readings=np.zeros_like(one.reduced.readings),
        rest=0.0,
        blocks=(),
        log_root=0.0,
    )
    x = np.zeros(one.sizes.spread.size)
    posterior = posterior_at(one.sizes, none, x)
    readings, prior = split(*parted_root([posterior], posterior.mean, one.sizes.layout.of_machine))
    machine = slice(0, one.sizes.layout.of_machine)
    np.testing.assert_allclose(prior[machine], posterior.scale[machine], rtol=1e-9)
    np.testing.assert_allclose(readings[machine], 0.0, atol=1e-7 * posterior.scale.max())
