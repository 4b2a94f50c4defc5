"""The estimate on worlds: random designs and shops with exact rotations that share no code with the package."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.worlds.estimates import World, deviations, outcome, rms_um, world
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine, random_points
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.rounds import NothingHeldError
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.setup import Device
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues

pytestmark = pytest.mark.usefixtures("values_alone")
SMALL = 36  # a design of three axes, 20 runs, ball bars alone, with outliers


@pytest.fixture(scope="module")
def small(tmp_path_factory: pytest.TempPathFactory) -> World:
    return world(SMALL, tmp_path_factory.mktemp("world"))


def given(one: World) -> ErrorValues:
    return ErrorValues(
        machine=one.model.name, parameters={name: one.model.errors.parameters[name] for name in one.model.dimensions}
    )


def estimated(one: World, seed: int) -> Estimate:
    data = measure(one.design, draw_machine(one.design.machine, seed), seed)
    return estimate(one.model, replace(one.plan, reading=data.reading.copy()), given(one))


def test_it_is_nearly_as_good_as_what_knows_noise_and_sizes(small: World) -> None:
    each = [outcome(small, seed) for seed in range(4)]
    error, oracle, true = (
        np.sqrt(np.mean([getattr(one, name) ** 2 for one in each])) for name in ("error", "oracle", "true")
    )
    assert error < 1.6 * oracle  # few readings: sizes that it does not know cost that
    assert error < true
    assert all(one.found.iteration.converged for one in each)
    assert 0.8 <= np.mean([one.coverage for one in each]) <= 1.0


@pytest.mark.slow
@pytest.mark.parametrize("seed", [9, 12])
def test_it_is_on_thorough_plans(seed: int, tmp_path: Path) -> None:
    one = world(seed, tmp_path)
    each = [outcome(one, seed) for seed in range(3)]
    error, oracle, true = (
        np.sqrt(np.mean([getattr(one, name) ** 2 for one in each])) for name in ("error", "oracle", "true")
    )
    assert error < 1.6 * oracle
    assert error < 0.15 * true


def test_outliers_are_found_and_no_others(small: World) -> None:
    spoilt = set(small.design.shop.outliers.tolist())
    assert spoilt
    found = set(np.flatnonzero(estimated(small, 1).readings.outliers).tolist())
    assert len(found & spoilt) >= 0.6 * len(spoilt)
    assert len(found - spoilt) <= 1


@pytest.mark.parametrize("off_by", [0.02, 1.0])
def test_how_far_a_spoilt_reading_is_off_makes_no_difference_to_the_noise(small: World, off_by: float) -> None:
    data = measure(small.design, draw_machine(small.design.machine, 1), 1)
    place = int(np.setdiff1d(np.arange(data.reading.size // 3, data.reading.size), small.design.shop.outliers)[5])
    kept = np.delete(np.arange(data.reading.size), place)
    without = estimate(small.model, replace(small.plan, reading=data.reading.copy()).of(kept), given(small))
    data.reading[place] += off_by
    spoilt = estimate(small.model, replace(small.plan, reading=data.reading.copy()), given(small))
    assert spoilt.readings.outliers[place]
    for name, noise in without.noise.of_group.items():
        assert spoilt.noise.of_group[name].sigma == pytest.approx(noise.sigma, rel=0.1)


def test_the_convention_levels_and_changes_nothing_seen_from_home(small: World) -> None:
    found = estimated(small, 2)
    level = found.levelled()
    positions = np.array(list(random_points(small.design.machine, 2, 60).values()))
    axes = list(random_points(small.design.machine, 2, 1))
    positions = positions[[axes.index(axis) for axis in small.model.axes]]
    before, after = (deviations(small.model.with_values(one.values), positions) for one in (found, level))
    assert rms_um(before) > 1.0
    assert rms_um(after - before) < 1e-3 * rms_um(before)  # what is of second order in the errors
    layout = found.layout
    straight = [
        int(first)
        for name, first in zip(layout.components, layout.offsets[:-1], strict=True)
        if name[1] in LINEAR and name[2] in LINEAR and name[1] != name[2]
    ]
    seen = [row for row in straight if not np.isclose(level.unknowns[row], found.unknowns[row], rtol=1e-9, atol=1e-12)]
    assert seen
    np.testing.assert_allclose(level.unknowns[seen], 0.0, atol=1e-9)


def test_the_order_of_readings_and_of_runs_does_not_matter(small: World) -> None:
    data = measure(small.design, draw_machine(small.design.machine, 3), 3)
    observed = replace(small.plan, reading=data.reading.copy())
    turned = observed.of(np.random.default_rng(1).permutation(data.reading.size))
    one, other = (estimate(small.model, readings, given(small)) for readings in (observed, turned))
    np.testing.assert_allclose(other.unknowns, one.unknowns, rtol=1e-6, atol=1e-12)


def test_unread_errors_keep_their_prior(small: World) -> None:
    """One line of one axis: all the rest is as likely as before, and u says so."""
    first = int(small.plan.run[0])
    rows = np.flatnonzero(small.plan.run == first)
    data = measure(small.design, draw_machine(small.design.machine, 4), 4)
    alone = replace(small.plan, reading=data.reading.copy()).of(rows)
    found = estimate(small.model, alone, given(small))
    assert found.iteration.converged
    assert np.isfinite(found.spread).all()
    u = np.linalg.norm(found.spread, axis=1)
    assert np.median(u[: found.layout.of_machine] / found.scale[: found.layout.of_machine]) > 0.8
    assert np.abs(found.unknowns).max() < 1.0


def test_readings_that_hold_nothing_are_refused(small: World) -> None:
    everything = dict.fromkeys(small.model.location_errors, 0.0)
    known = replace(
        given(small),
        parameters={**given(small).parameters, **everything},
        motion_errors=dict.fromkeys(small.model.components, PolynomialCurve(powers=(1,), coefficients=(0.0,))),
    )
    with pytest.raises(NothingHeldError):
        estimate(small.model, small.plan, known)


def test_balls_are_set_up_once_a_session_and_lengths_are_as_stated(small: World) -> None:
    bar = Device(id="B", length_u=1e-4)
    runs = tuple(
        replace(run, session="one" if place % 2 else "two", device=bar) for place, run in enumerate(small.plan.runs)
    )
    data = measure(small.design, draw_machine(small.design.machine, 5), 5)
    observed = replace(small.plan, reading=data.reading.copy(), runs=runs)
    plain = layout_of(small.model, small.plan, given(small))
    layout = layout_of(small.model, observed, given(small))
    assert {one.kind for one in plain.shared} == {"ballbar centre", "ballbar length"}
    assert {one.kind for one in layout.shared} == {"ballbar centre", "stated length"}
    assert all(len({runs[index].session for index in one.runs}) == 1 for one in layout.shared)
    assert {one.size for one in layout.shared if one.kind == "stated length"} == {1e-4}


def test_a_noise_that_is_stated_is_not_estimated(small: World) -> None:
    data = measure(small.design, draw_machine(small.design.machine, 5), 5)
    observed = replace(small.plan, reading=data.reading.copy())
    stated = dict.fromkeys(range(len(observed.runs)), 0.0005)
    found = estimate(small.model, observed, given(small), EstimationOptions(noise=stated))
    assert set(found.noise.scale_of_run.values()) == {5e-4}
    assert all(noise.sigma == 1.0 for noise in found.noise.of_group.values())
