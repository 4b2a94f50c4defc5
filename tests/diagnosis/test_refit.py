"""The joint fit against scipy.optimize.least_squares, and whether its uncertainties cover the truth."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from scipy.optimize import least_squares

from tests.diagnosis.prepared import SIGMA, SLOW, SMALL, WHITE, Field, field, noise_of
from trueaxis.diagnosis.causes.refit import refit
from trueaxis.diagnosis.causes.search import Found, Ground, scan_all, zoomed
from trueaxis.diagnosis.causes.signature import Fitted
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.judging.amplitudes import amplitudes_of
from trueaxis.effects.kind import Effect
from trueaxis.estimation.noise import Noise

FloatArray = npt.NDArray[np.float64]
PLANTED = {
    "linear": ((Effect(kind="backlash", component="EXX"), [2e-3]),),
    "phase and pitch": ((Effect(kind="cyclic", component="EYY"), [1.5e-3, 0.7, 23.0]),),
    "time constant": ((Effect(kind="warm_up", component="EYY"), [8e-2, 4000.0]),),
    "decay": ((Effect(kind="reversal_spike", component="EXX"), [3e-3, 6.0]),),
    "two": ((Effect(kind="backlash", component="EXX"), [2e-3]), (Effect(kind="drift", component="EZZ"), [2e-6])),
}


def planted(where: Field, causes: tuple[tuple[Effect, list[float]], ...], seed: int) -> Ground:
    values = noise_of(where, seed)
    for effect, parameters in causes:
        values = values + parameter_signature(where.readings, effect, np.array(parameters))[0]
    return where.ground(values)


def found_of(ground: Ground, effects: list[Effect]) -> list[Found]:
    """Each by itself; the joint fit has to bring them together."""
    residual = ground.left(ground.base)
    return [zoomed(ground, residual, scan) for scan in scan_all(ground, residual, effects)]


def fitted(where: Field, name: str, seed: int) -> tuple[Ground, tuple[Fitted, ...]]:
    ground = planted(where, PLANTED[name], seed)
    return ground, refit(ground, found_of(ground, [effect for effect, _ in PLANTED[name]]))


@pytest.mark.parametrize("name", PLANTED)
@pytest.mark.parametrize("of", [WHITE, SLOW], ids=["white", "slow"])
def test_values_and_uncertainties_are_those_of_scipy(name: str, of: Noise) -> None:
    where = field(SMALL, of)
    ground, causes = fitted(where, name, 1)
    truth = np.concatenate([parameters for _, parameters in PLANTED[name]])
    ends = np.cumsum([len(parameters) for _, parameters in PLANTED[name]])[:-1]

    def residual(scaled: FloatArray) -> FloatArray:
        parts = np.split(scaled * truth, ends)
        signals = [
            parameter_signature(where.readings, effect, part)[0]
            for (effect, _), part in zip(PLANTED[name], parts, strict=True)
        ]
        return ground.base.rest(ground.values - ground.whitening(np.sum(signals, axis=0)))

    expected = least_squares(residual, np.ones(truth.size), jac="3-point", xtol=1e-14, ftol=1e-14, gtol=1e-14)
    jacobian = np.asarray(expected.jac, dtype=np.float64)
    u = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
    found = np.concatenate([one.values for one in causes]) / truth
    found_u = np.concatenate([one.u for one in causes]) / np.abs(truth)
    assert found == pytest.approx(expected.x, abs=1e-3 * u.min())
    assert found_u == pytest.approx(u, rel=1e-3)
    for (effect, _), one in zip(PLANTED[name], causes, strict=True):
        assert one.effect == effect
        assert one.signal == pytest.approx(parameter_signature(where.readings, effect, one.values)[0], abs=1e-12)


@pytest.mark.parametrize("name", PLANTED)
def test_two_standard_uncertainties_cover_the_truth_as_often_as_they_should(name: str) -> None:
    where = field(SMALL, SLOW, settles=SIGMA)
    truth = np.concatenate([parameters for _, parameters in PLANTED[name]])
    z = []
    for seed in range(60):
        _, causes = fitted(where, name, 100 + seed)
        found = np.concatenate([one.values for one in causes])
        z.append((found - truth) / np.concatenate([one.u for one in causes]))
    inside = np.mean(np.abs(z) < 2.0, axis=0)
    assert (inside > 0.86).all()
    assert np.mean(z, axis=0) == pytest.approx(0.0, abs=0.55)
    assert np.std(z, axis=0) == pytest.approx(1.0, abs=0.3)


def test_no_causes_no_fit() -> None:
    where = field()
    assert refit(where.ground(np.zeros(where.readings.rows.size)), []) == ()


def test_amplitudes_of_set_ups_are_one_where_the_cause_is_one() -> None:
    where = field(SMALL, SLOW, settles=SIGMA)
    rows = where.readings.rows
    p = []
    for seed in range(40):
        ground, causes = fitted(where, "linear", 200 + seed)
        groups, of_one = amplitudes_of(ground, causes, 0)
        p.append(of_one)
        assert len(groups) > 2
        assert np.mean([abs(one.value - 2e-3) < 3 * one.u for one in groups]) > 0.7
    assert np.mean(np.array(p) < 0.05) < 0.15
    # and are not where the ball bar shows twice what the laser shows
    effect, parameters = PLANTED["linear"][0]
    signal = parameter_signature(where.readings, effect, np.array(parameters))[0]
    ballbar = np.array([run.instrument == "ballbar" for run in rows.runs])[rows.run]
    values = noise_of(where, 7)
    ground = where.ground(values + signal * np.where(ballbar, 2.0, 1.0))
    causes = refit(ground, found_of(ground, [effect]))
    assert amplitudes_of(ground, causes, 0)[1] < 1e-4


def test_a_parameter_that_no_reading_tells_has_no_uncertainty() -> None:
    """A point of one line, moved along the line, does nothing beside the offset of its run."""
    where = field(replace(SMALL, lines=4, targets=15))
    effect = Effect(kind="point_offset", runs=("X1-1", "X1-2"), end="target")
    values = parameter_signature(where.readings, effect, np.array([0.0, 20.0, -10.0]))[0]
    ground = where.ground(values)
    (one,) = refit(ground, found_of(ground, [effect]))
    assert np.isfinite(one.values).all()
    assert np.isnan(one.u[0]) or one.u[0] > 1e2 * np.nanmin(one.u)


def test_a_time_constant_that_is_hardly_told_does_not_make_the_fit_worse() -> None:
    """Undamped steps overflow here: the amplitude is just found, its time constant is not."""
    where = field(replace(SMALL, lines=4, repeats=3), SLOW, settles=SIGMA)
    effect = Effect(kind="warm_up", component="EYY")
    for seed in range(12):
        ground = planted(where, ((effect, [8e-3, 4000.0]),), seed)
        (start,) = found_of(ground, [effect])
        (one,) = refit(ground, [start])
        before = float(np.sum(ground.base.rest(ground.values) ** 2)) - start.scan.statistic
        after = float(np.sum(ground.base.rest(ground.values - ground.whitening(one.signal)) ** 2))
        assert np.isfinite(one.values).all()
        assert after <= before * (1.0 + 1e-9)


def test_a_pitch_stays_by_the_one_that_the_search_found() -> None:
    """Half a period over the range of the axis farther off it would be another: in noise a fit may well go there."""
    where = field()
    for seed in range(5):
        ground = where.ground(noise_of(where, seed))
        (start,) = found_of(ground, [Effect(kind="cyclic", component="EXX")])
        (one,) = refit(ground, [start])
        pitch = dict(zip([each.name for each in one.kind.parameters], one.values, strict=True))["pitch"]
        span = float(np.ptp(where.readings.rows.positions[0]))
        assert abs(span / pitch - span / start.scan.point["pitch"]) <= 0.5 + 1e-9


def test_no_error_at_a_reversal_is_larger_than_a_machine_errs() -> None:
    """What has decayed for long would explain a little by any size."""
    where, effect = field(SMALL, WHITE), Effect(kind="reversal_spike", component="EXX")
    ground = planted(where, ((effect, [1e3, 6.0]),), 1)
    (cause,) = refit(ground, found_of(ground, [effect]))
    assert abs(cause.values[0]) <= 256.0 * where.readings.model.prior.translation < 10.0
