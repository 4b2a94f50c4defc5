"""Displays with coarse steps, and readings that are outliers in every other round."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.identification.data import dmu60p_model, mixed_data
from trueaxis.estimation import estimate as module
from trueaxis.estimation import rounds
from trueaxis.estimation.display import ROUNDING, display_step, display_steps, rounded
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.noise import Noise
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.rounds import MOST_ROUNDS, settled
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, counting, started, with_first_noise
from trueaxis.estimation.state import with_noise as noisy
from trueaxis.measurement.setup import Device
from trueaxis.model.errors import ErrorValues

GIVEN = ErrorValues(machine="dmu60p", parameters=PARAMETERS)
STEP = 5e-3


@given(st.sampled_from([1e-2, 5e-3, 1e-3, 2e-4, 1e-6]), st.integers(0, 2**32 - 1))
def test_a_step_is_the_largest_that_displays_have_and_all_readings_are_multiples_of(step: float, seed: int) -> None:
    counts = np.random.default_rng(seed).integers(-40, 40, 30)
    readings = step * np.array([*counts, 1, 7])  # one step, and no even number of steps
    assert display_step(readings) == pytest.approx(step)
    assert display_step(readings + 0.37 * 1e-6) == 0.0
    assert display_step(np.full(5, step)) == 0.0  # one reading says nothing of the step
    assert display_step(np.random.default_rng(seed).normal(size=50)) == 0.0


def begun(data: Observations) -> State:
    layout = layout_of(dmu60p_model().with_values(GIVEN), data, GIVEN, degree=3)
    return started(layout, tuple(measured_runs(data)), GIVEN, {})


def coarse() -> Observations:
    data = mixed_data(cubic_errors(), 3, seed=1)
    return replace(data, reading=STEP * np.round(data.reading / STEP))


def test_no_noise_is_less_than_the_rounding_of_the_display() -> None:
    """Most readings of a coarse display are as their neighbours: by these there would be no noise at all."""
    state = begun(coarse())
    assert set(state.display.values()) == {STEP}
    assert all(noise.white >= STEP * ROUNDING for noise in state.noise.values())
    still = replace(state, residual=tuple(np.zeros_like(rest) for rest in state.residual))
    assert {noise.white for noise in with_first_noise(still).noise.values()} == {STEP * ROUNDING}
    assert rounded(Noise(2.0 * STEP, 3.0), STEP) == Noise(2.0 * STEP, 3.0)


def test_what_a_device_states_counts_where_its_readings_are_finer() -> None:
    data = mixed_data(cubic_errors(), 3, seed=1)
    device = Device(id="one", resolution=2e-3)
    runs = [replace(run, device=device) for run in data.runs]
    assert set(display_steps(measured_runs(replace(data, runs=tuple(runs)))).values()) == {2e-3}
    assert set(display_steps(measured_runs(data)).values()) == {0.0}


def test_readings_that_are_outliers_in_every_other_round_do_not_keep_the_noise_at_its_start(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    state = begun(mixed_data(cubic_errors(), 3, seed=1))
    known: list[bool] = []
    turn = 0

    def without(state: State, posterior: Posterior, sharp: bool) -> State:
        nonlocal turn
        turn += 1
        good = np.ones(state.runs[0].good.size, dtype=bool)
        good[turn % 3] = False
        return replace(state, runs=(replace(state.runs[0], good=good), *state.runs[1:]))

    def recorded(state: State, posterior: Posterior, draw: np.random.Generator, shape_known: bool) -> State:
        known.append(shape_known)
        return noisy(state, posterior, draw, shape_known)

    monkeypatch.setattr(rounds, "without_outliers", without)
    monkeypatch.setattr(rounds, "with_noise", recorded)
    sizes = Sizes(state.layout, state.own_kinds)
    _, state, count = settled(state, sizes, MOST_ROUNDS)
    assert count < MOST_ROUNDS
    assert known[-1]


def test_noise_that_does_not_stand_still_is_no_estimate_that_has_converged(monkeypatch: pytest.MonkeyPatch) -> None:
    data = mixed_data(cubic_errors(), 3, seed=1)
    options = EstimationOptions(degree=3)
    assert module.estimate(dmu60p_model(), data, GIVEN, options).iteration.converged
    monkeypatch.setattr(module, "MOST_ROUNDS", 2)
    assert not module.estimate(dmu60p_model(), data, GIVEN, options).iteration.converged


def test_which_readings_count_is_one_key() -> None:
    state = begun(mixed_data(cubic_errors(), 3, seed=1))
    keys: Sequence[bytes] = [
        counting(replace(state, runs=(replace(run, good=np.arange(run.good.size) != k), *state.runs[1:])))
        for run in state.runs[:1]
        for k in range(run.good.size)
    ]
    assert len({counting(state), *keys}) == len(keys) + 1
