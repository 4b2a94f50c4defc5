"""A step of the estimate: what it does to the posterior density of the exact model, and when it is shortened."""

from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.machine import Function
from tests.identification.data import bar, circle, dmu60p_model, mixed_data
from trueaxis.estimation import steps as module
from trueaxis.estimation.evidence import posterior_at
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.posterior import OwnPosterior, Posterior
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, linearised, started
from trueaxis.estimation.steps import ALIKE, Walk, at_share, moved
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues

GIVEN = ErrorValues(machine="dmu60p", parameters=PARAMETERS)
SQUARE = ErrorValues(machine="dmu60p", parameters=PARAMETERS | {"eps_xy": 0.0, "eps_xz": 0.0, "eps_yz": 0.0})
NOISE = 1e-4


def begun(data: Observations, given: ErrorValues = GIVEN) -> tuple[State, Posterior, list[FloatArray]]:
    """At the start, and the posterior of the model linearised there."""
    layout = layout_of(dmu60p_model().with_values(given), data, given, degree=3)
    state = started(layout, tuple(measured_runs(data)), given, dict.fromkeys(range(len(data.runs)), NOISE))
    sizes = Sizes(layout, state.own_kinds)
    x = np.zeros(sizes.spread.size)
    return state, posterior_at(sizes, linearised(state), x), sizes.own_scales(x)


def misfit(state: State, posterior: Posterior, own_scales: list[FloatArray]) -> float:
    """Minus twice the logarithm of the posterior density, by hand: squares over variances."""
    squares = sum(float(rest @ rest) for rest in state.residual) / NOISE**2
    squares += float(np.sum((state.unknowns / state.layout.sizes / posterior.scale) ** 2))
    return squares + sum(float(np.sum((own / of) ** 2)) for own, of in zip(state.own, own_scales, strict=True))


def too_far(posterior: Posterior, times: float) -> Posterior:
    """A step in the right direction, so many times too long."""
    own = tuple(OwnPosterior(times * one.mean, one.by_others, one.alone) for one in posterior.own)
    return replace(posterior, mean=times * posterior.mean, own=own)


@pytest.mark.parametrize("times", [1.0, 3.0, 40.0, 500.0])
def test_no_step_makes_the_values_less_likely(times: float) -> None:
    state, posterior, own_scales = begun(mixed_data(cubic_errors(), 3, seed=1))
    before, step = misfit(state, posterior, own_scales), too_far(posterior, times)
    after = moved(state, step, own_scales)
    assert misfit(after, step, own_scales) < 0.95 * before
    if times == 1.0:
        assert np.allclose(after.unknowns, posterior.mean * state.layout.sizes)
    else:  # the whole of it would have: it is halved as often as is needed, and no more
        assert misfit(at_share(state, step), step, own_scales) > before
        share = float(after.unknowns @ state.layout.sizes / (step.mean * state.layout.sizes @ state.layout.sizes))
        halved = float(np.log2(share))
        assert halved == pytest.approx(round(halved), abs=1e-6)
        assert misfit(at_share(state, step, 2.0 * share), step, own_scales) > before


def test_a_step_that_only_harms_is_not_taken() -> None:
    state, posterior, own_scales = begun(mixed_data(cubic_errors(), 3, seed=1))
    best = moved(state, posterior, own_scales)
    astray = replace(posterior, mean=posterior.mean + 1e6)
    assert moved(best, astray, own_scales) is best


def test_steps_end_at_a_ball_that_is_far_from_where_it_was_set_up() -> None:
    """20 mm off a bar of 150 mm, where the linear model is wrong by more than a millimetre: the exact one decides."""
    run = bar("xy", 600.0)
    at = circle(run, (0, 1), 48)
    # a lower end that is elsewhere by (12, -16, 0) is farther by this, exactly
    angle = 2.0 * np.pi * np.arange(48) / 48.0
    ball = 150.0 * np.array([np.cos(angle), np.sin(angle)])
    reading = np.hypot(*(ball - np.array([[12.0], [-16.0]]))) - 150.0
    data = Observations(source="", runs=(run,), run=np.zeros(48, dtype=np.int64), positions=at, reading=reading)
    state, _, _ = begun(data, SQUARE)
    layout = replace(state.layout, sizes=np.where(np.arange(state.layout.count) < state.layout.of_machine, 1e-9, 100.0))
    sizes = Sizes(layout, state.own_kinds)
    state = replace(state, layout=layout, kept=())
    x = np.zeros(sizes.spread.size)
    passed = []
    for _ in range(12):
        posterior = posterior_at(sizes, linearised(state), x)
        before = misfit(state, posterior, sizes.own_scales(x))
        state = moved(state, posterior, sizes.own_scales(x))
        assert misfit(state, posterior, sizes.own_scales(x)) <= before + module.NOTHING
        passed.append(np.abs(state.residual[0]).max())
    assert passed[0] > 1e-2
    assert passed[-1] < 1e-4
    centre = state.unknowns[layout.of_shared][:2]
    assert np.allclose(centre, [12.0, -16.0], atol=1e-3)


def test_effects_stay_within_their_limits(monkeypatch: pytest.MonkeyPatch) -> None:
    """A step that would leave what the kinds allow is shortened, however good it is."""
    state, posterior, own_scales = begun(mixed_data(cubic_errors(), 3, seed=1))
    tried = []

    def within(_: object, unknowns: FloatArray) -> bool:
        tried.append(unknowns)
        return len(tried) > 2

    monkeypatch.setattr(type(state.layout.effects), "within", within)
    after = moved(state, posterior, own_scales)
    assert np.allclose(after.unknowns, 0.25 * posterior.mean * state.layout.sizes)


def enlarged(of: Function, times: float) -> Function:
    return lambda position: times * of(position)


@pytest.mark.parametrize("times", [1.0, 30.0])
def test_steps_to_first_order_are_taken_where_no_reading_tells_the_difference(
    times: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Errors 30 times as large bend 900 times as much: more of the steps are on the exact model."""
    state, posterior, own_scales = begun(
        mixed_data({name: enlarged(of, times) for name, of in cubic_errors().items()}, 3, seed=1)
    )
    exact: list[State] = []

    def on_the_exact_model(state: State, posterior: Posterior, own_scales: list[FloatArray]) -> State:
        exact.append(moved(state, posterior, own_scales))
        return exact[-1]

    monkeypatch.setattr(module, "moved", on_the_exact_model)
    walk, number = Walk(), 0
    for number in range(1, 9):
        share = 1.0 + 0.1**number  # each step some way beyond the one before, as sizes and noise have it
        before, state = state, walk.step(state, too_far(posterior, share), own_scales)
        assert not np.array_equal(before.unknowns, state.unknowns)
        left = residuals_of(state.layout, state.runs, state.unknowns, state.own, state.given)
        away = [(one - other) / NOISE for one, other in zip(state.residual, left, strict=True)]
        assert np.sqrt(np.mean(np.concatenate(away) ** 2)) < ALIKE
    assert len(exact) == (1 if times == 1.0 else 5)
    ended = walk.ended(state)
    assert all(np.array_equal(one, other) for one, other in zip(ended.residual, left, strict=True))
