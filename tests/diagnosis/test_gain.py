"""What is held out has no part in the fit, and RMS before and after come out as worked by hand."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, SMALL, FloatArray, field, prepared
from tests.hidden_effects.case import Case
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.judging.gain import Fit, Prediction, fit, gain_of, held_out, predicted
from trueaxis.diagnosis.result import BoolArray
from trueaxis.effects.kind import Effect

WHERE = field(SMALL)
ROWS = WHERE.readings.rows
TIME = np.zeros(ROWS.size) if ROWS.time is None else ROWS.time
EVERY = np.ones(ROWS.size, dtype=bool)
HELD, SPLIT = held_out(ROWS)


def noise(seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(ROWS.size)


def cause(
    size: float = 1e-3, kind: str = "backlash", component: str | None = "EXX", runs: tuple[str, ...] = ()
) -> Fitted:
    effect = Effect(kind=kind, component=component, runs=runs)
    values = np.array([size]) if kind == "backlash" else np.array([size, float(TIME[ROWS.of_run(1)].mean())])
    signal, _ = parameter_signature(WHERE.readings, effect, values)
    return Fitted(
        effect=effect,
        kind=WHERE.readings.model.machine.kinds[kind],
        values=values,
        u=np.full(values.size, SIGMA / 100),
        signal=signal,
    )


def fit_of(values: FloatArray, causes: tuple[Fitted, ...] = (), rows: BoolArray = EVERY) -> Fit:
    return fit(WHERE.null, WHERE.whitening, values, causes, rows)


def of_all(values: FloatArray, causes: tuple[Fitted, ...] = ()) -> Prediction:
    return predicted(fit_of(values, causes), WHERE.whitening, values, EVERY)


def of_held(values: FloatArray, causes: tuple[Fitted, ...] = ()) -> Prediction:
    return predicted(fit_of(values, causes, ~HELD), WHERE.whitening, values, HELD)


def test_whole_repeats_are_held_back() -> None:
    assert "repeats" in SPLIT
    for index in ROWS.present:
        part = HELD[ROWS.of_run(index)]
        if ROWS.runs[index].instrument == "laser":
            assert part.all() or not part.any()
            assert part.all() == ROWS.runs[index].id.endswith("-2")
    of_laser = np.array([run.instrument == "laser" for run in ROWS.runs])[ROWS.run]
    assert 0.2 < HELD[of_laser].mean() < 0.6


def test_without_repeats_some_readings_are_held_back() -> None:
    single = prepared(Case(seed=1, design=replace(SMALL, repeats=1, feeds=(1000.0,)), noise="none", given="exact"))
    held, split = held_out(single.rows)
    assert "nothing is repeated" in split
    assert held.mean() == pytest.approx(0.25, abs=0.01)


def test_the_fit_is_ridge_regression() -> None:
    """By the normal equations, with the covariance of white noise, the runs' own unknowns wide, and their chance."""
    values = noise(1) + cause().signal
    found = fit_of(values, (cause(),), ~HELD)
    own = WHERE.without_own()
    wide, chance = own / np.maximum(np.linalg.norm(own, axis=0), 1e-300), WHERE.by_chance()
    columns = np.hstack([found.columns.dense(), wide, chance])[~HELD]
    p = found.extended.size
    prior = np.concatenate([np.ones(p - 1), np.full(1, 1e-6), np.full(own.shape[1], 1e-9), np.ones(chance.shape[1])])
    information = columns.T @ columns / SIGMA**2 + np.diag(prior)
    expected = np.linalg.solve(information, columns.T @ values[~HELD] / SIGMA**2)[:p]
    u = np.sqrt(np.diag(np.linalg.inv(information)))[:p]
    assert np.abs(found.extended - expected).max() < 1e-3 * u.max()
    assert np.linalg.norm(found.root, axis=1) == pytest.approx(u, rel=1e-3)


def test_held_out_readings_change_nothing_of_the_fit() -> None:
    values = noise(1) + cause().signal
    changed = values + np.where(HELD, np.random.default_rng(2).normal(0.0, 1.0, ROWS.size), 0.0)
    before, after = (fit_of(one, (cause(),), ~HELD) for one in (values, changed))
    assert after.extended == pytest.approx(before.extended, rel=1e-9, abs=1e-15)
    assert after.refitted == pytest.approx(before.refitted, rel=1e-9, abs=1e-15)


def test_zeros_slopes_and_centres_of_held_out_runs_are_nothing_lost() -> None:
    """Their own unknowns, however large, are fitted to them, and counted: the figure stays the same."""
    own = np.concatenate([columns @ np.full(columns.shape[1], 0.5) for columns in WHERE.null.free])
    values = noise(2)
    for stage in ("given", "refitted", "extended"):
        without, beside = (getattr(of_held(one).stage(), stage) for one in (values, values + own))
        assert beside == pytest.approx(without, rel=1e-6)
    assert of_held(values).stage().given == pytest.approx(SIGMA, rel=0.1)
    assert of_held(values).freedom < HELD.sum()


def test_on_noise_alone_held_out_readings_are_off_by_the_noise() -> None:
    """Over its predictive standard deviation each is 1 in the mean, and nothing is gained."""
    standardised, ratios = [], []
    for seed in range(12):
        values = noise(50 + seed)
        held = of_held(values, (cause(),))
        standardised.append(held.standardised)
        ratios.append(held.stage().extended / held.stage().refitted)
    assert np.mean(standardised) == pytest.approx(1.0, abs=0.03)
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.01)


def test_a_cause_lowers_the_rms_to_that_of_the_noise() -> None:
    values = noise(3) + cause(3e-3).signal
    gain = gain_of(of_all(values, (cause(),)), of_held(values, (cause(),)), SPLIT, SIGMA)
    assert gain.floor == SIGMA
    assert gain.rms.given > gain.rms.refitted > 1.25 * gain.rms.extended
    assert gain.held_out.extended == pytest.approx(SIGMA, rel=0.15)
    assert gain.held_out.extended < 0.8 * gain.held_out.refitted
    assert gain.standardised == pytest.approx(1.0, abs=0.1)
    assert of_held(values).standardised > 1.3  # the model without it is wrong, and that shows


def test_what_only_held_out_runs_have_is_known_from_them() -> None:
    """A step in a run that is held back: the others cannot predict it, and the extended model has it."""
    run = next(ROWS.runs[index].id for index in ROWS.present if HELD[ROWS.of_run(index)].all())
    step = cause(2e-2, "laser_step", None, (run,))
    place = next(index for index in ROWS.present if ROWS.runs[index].id == run)
    values, moment = noise(5), float(np.median(TIME[ROWS.of_run(place)]))
    signal, _ = parameter_signature(WHERE.readings, step.effect, np.array([2e-2, moment]))
    held = of_held(values + signal, (replace(step, signal=signal),))
    assert held.stage().extended == pytest.approx(of_held(values).stage().refitted, rel=1e-6)
    assert held.standardised == pytest.approx(1.0, abs=0.1)
    assert held.stage().refitted > 3.0 * held.stage().extended


def test_an_error_of_calibration_is_gained_by_refitting_not_by_a_cause() -> None:
    lever = WHERE.readings.sensitivity[WHERE.readings.model.components.index("EXX")]
    values = noise(4) + lever * 1e-5 * ROWS.positions[0]  # a scale of 10 um/m
    gain = gain_of(of_all(values), of_held(values), SPLIT, SIGMA)
    assert gain.held_out.refitted < 0.5 * gain.held_out.given
    assert gain.held_out.extended == pytest.approx(gain.held_out.refitted, rel=1e-12)


def test_what_is_predicted_badly_is_not_taken_for_predicted_too_well() -> None:
    """No line of Z is among the readings that are fitted: its curves are as [prior] has them, in a few directions."""
    held = np.char.startswith(np.array([run.id for run in ROWS.runs])[ROWS.run], "Z")
    values = noise(11)
    found = predicted(fit_of(values, (), ~held), WHERE.whitening, values, held)
    assert 0.75 < found.standardised < 1.15
