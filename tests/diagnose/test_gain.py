"""What is held out has no part in the fit, and RMS before and after come out as worked by hand."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest

from tests.diagnose.prepared import SIGMA, SMALL, WHITE, field, prepared
from tests.hidden_effects.case import Case
from trueaxis.diagnose.base import base_of
from trueaxis.diagnose.gain import fitted_left, gain_of, held_out
from trueaxis.diagnose.refit import Fitted
from trueaxis.diagnose.signatures import parameter_signature
from trueaxis.effects.kind import Effect

FloatArray = npt.NDArray[np.float64]
WHERE = field(SMALL, WHITE)
ROWS = WHERE.readings.rows
BASE = base_of(WHERE.readings.model, ROWS)


def noise(seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(ROWS.size)


def cause(size: float = 1e-3) -> Fitted:
    effect = Effect("backlash", "EXX")
    kind = WHERE.readings.model.machine.kinds["backlash"]
    signal, _ = parameter_signature(WHERE.readings, effect, np.array([size]))
    return Fitted(effect, kind, np.array([size]), np.array([SIGMA / 100]), signal)


def test_whole_repeats_are_held_back() -> None:
    held, split = held_out(ROWS)
    assert "repeats" in split
    for index in ROWS.present:
        part = held[ROWS.of_run(index)]
        if ROWS.runs[index].instrument == "laser":
            assert part.all() or not part.any()
            assert part.all() == ROWS.runs[index].id.endswith("-2")
    assert 0.2 < held.mean() < 0.6


def test_without_repeats_some_readings_are_held_back() -> None:
    single = prepared(Case(seed=1, design=replace(SMALL, repeats=1, feeds=(1000.0,)), noise="none", given="exact"))
    held, split = held_out(single.rows)
    assert "nothing is repeated" in split
    assert held.mean() == pytest.approx(0.25, abs=0.01)


@pytest.mark.parametrize("causes", [(), (cause(),)], ids=["base", "with a cause"])
def test_held_out_readings_change_nothing_of_the_fit(causes: tuple[Fitted, ...]) -> None:
    """Other held-out values: nothing changes in the others' rows; in their own, their change less its mean by run."""
    held, _ = held_out(ROWS)
    values = noise(1) + cause().signal
    source = np.random.default_rng(2)
    changed = np.where(held, source.normal(0.0, 1.0, ROWS.size), 0.0)
    before = fitted_left(BASE, WHERE.whitening, values, causes, ~held)
    after = fitted_left(BASE, WHERE.whitening, values + changed, causes, ~held)
    expected = changed.copy()
    for index in ROWS.present:
        if ROWS.runs[index].instrument == "laser":
            mine = ROWS.of_run(index)
            expected[mine] -= changed[mine].mean()
    for name in ("given", "refitted", "extended"):
        one, other = getattr(before, name), getattr(after, name)
        assert other[~held] == pytest.approx(one[~held], abs=1e-13)
        assert other[held] - one[held] == pytest.approx(expected[held], abs=1e-12)


def test_a_cause_lowers_the_rms_to_that_of_the_noise() -> None:
    held, split = held_out(ROWS)
    values = noise(3) + cause().signal
    everything = fitted_left(BASE, WHERE.whitening, values, (cause(),), np.ones_like(held))
    of_held = fitted_left(BASE, WHERE.whitening, values, (cause(),), ~held)
    gain = gain_of(everything, of_held, held, split, SIGMA)
    laser = np.array([run.instrument == "laser" for run in ROWS.runs])[ROWS.run]
    assert gain.floor == SIGMA
    # all rows: unbiased once the parameters are counted
    freedom = 1.0 - (WHERE.base.rank + 1) / ROWS.size
    assert gain.rms.extended == pytest.approx(SIGMA * np.sqrt(freedom), rel=0.06)
    assert gain.rms.given > gain.rms.refitted > 1.3 * gain.rms.extended
    # held out: noise and what the uncertain fit adds; never below the noise
    assert np.sqrt(np.mean(of_held.extended[held & laser] ** 2)) == pytest.approx(SIGMA, rel=0.35)
    assert gain.held_out.extended < 0.8 * gain.held_out.refitted
    assert gain.held_out.given == pytest.approx(np.sqrt(np.mean(of_held.given[held] ** 2)))


def test_on_noise_alone_nothing_is_gained_on_what_is_held_out() -> None:
    held, split = held_out(ROWS)
    ratios = []
    for seed in range(12):
        values = noise(50 + seed)
        everything = fitted_left(BASE, WHERE.whitening, values, (cause(),), np.ones_like(held))
        of_held = fitted_left(BASE, WHERE.whitening, values, (cause(),), ~held)
        gain = gain_of(everything, of_held, held, split, SIGMA)
        assert gain.rms.extended <= gain.rms.refitted <= gain.rms.given
        ratios.append(gain.held_out.extended / gain.held_out.refitted)
    assert np.mean(ratios) == pytest.approx(1.0, abs=0.01)


def test_an_error_of_calibration_is_gained_by_refitting_not_by_a_cause() -> None:
    held, split = held_out(ROWS)
    lever = WHERE.readings.sensitivity[WHERE.readings.model.components.index("EXX")]
    values = noise(4) + lever * 1e-5 * ROWS.positions[0]  # a scale of 10 um/m
    of_held = fitted_left(BASE, WHERE.whitening, values, (), ~held)
    everything = fitted_left(BASE, WHERE.whitening, values, (), np.ones_like(held))
    gain = gain_of(everything, of_held, held, split, SIGMA)
    assert gain.held_out.refitted < 0.5 * gain.held_out.given
    assert gain.held_out.extended == gain.held_out.refitted
