"""What readings count: against statsmodels on a design matrix differentiated numerically."""

import argparse
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from statsmodels.regression.linear_model import WLS

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identification.data import (
    TRAVEL,
    bar,
    circle,
    dmu60p_model,
    line,
    moving,
    noisy,
    observed,
    paper_runs,
    with_estimation,
)
from tests.identification.test_estimated import KNOWN, in_powers
from trueaxis.cli.identify import noise_option
from trueaxis.estimation.observations import Observations, pure_error
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.report import Identification
from trueaxis.identification.weighting import NoiseModel, weighting
from trueaxis.io.faults import InputError
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues

DEGREE = 2
SIGMA_UM = {"X-1": 0.2, "Y-5": 0.02, "laser": 0.07}
GIVEN = with_estimation(replace(KNOWN, noise=NoiseModel(by_group=SIGMA_UM)), degree=DEGREE)


def quadratic() -> dict[str, PolynomialCurve]:
    """So small that the exact model is linear within rounding."""
    source = np.random.default_rng(6)
    return {
        name: PolynomialCurve(powers=(1, 2), coefficients=(float(a) / TRAVEL[name[2]], float(b) / TRAVEL[name[2]] ** 2))
        for name in dmu60p_model().components
        for a, b in [source.normal(0.0, 3e-3 if name[1] in "XYZ" else 4e-6, 2)]
    }


def given_sigma(run: str) -> float:
    return SIGMA_UM.get(run, SIGMA_UM["laser"]) * 1e-3


@cache
def scattered() -> Observations:
    """The paper's runs but for their starts, where nothing is read, with noise that differs by run."""
    data = observed(generator(dict(quadratic())), paper_runs(), [line(moving(run), 14)[:, 1:] for run in paper_runs()])
    noise = np.random.default_rng(5).normal(0.0, 1.0, data.reading.size) * sigmas(data)
    return replace(data, reading=data.reading + noise)


def sigmas(data: Observations) -> FloatArray:
    return np.array([given_sigma(run.id) for run in data.runs])[data.run]


@cache
def jacobian() -> FloatArray:
    """(n_readings, 36): by central differences of the expected readings, in coefficients of plain powers / scale."""
    machine, data = dmu60p_model(), scattered()
    columns = []
    for name, power in ((name, power) for name in machine.components for power in (1, 2)):
        step = size(name, power)
        ends = [
            expected_readings(
                machine.with_values(
                    ErrorValues(
                        machine="dmu60p",
                        parameters=PARAMETERS,
                        motion_errors={name: PolynomialCurve(powers=(power,), coefficients=(sign * step,))},
                    )
                ),
                data.runs,
                data.run,
                data.positions,
            )
            for sign in (1.0, -1.0)
        ]
        columns.append((ends[0] - ends[1]) / 2.0)
    return np.array(columns).T


def size(name: str, power: int) -> float:
    return (1e-3 if name[1] in "XYZ" else 1e-6) / TRAVEL[name[2]] ** power


def right() -> FloatArray:
    """Readings less those of the machine with its location errors alone."""
    machine, data = dmu60p_model().with_values(ErrorValues(machine="dmu60p", parameters=PARAMETERS)), scattered()
    return data.reading - expected_readings(machine, data.runs, data.run, data.positions)


def agrees(found: Identification, expected: object) -> bool:
    """With coefficients and standard errors of statsmodels."""
    scale = np.array([size(name, power) for name in dmu60p_model().components for power in (1, 2)])
    values, u = (part / scale for part in in_powers(found))
    params, bse = expected.params, expected.bse  # type: ignore[attr-defined]
    return bool(np.allclose(u, bse, rtol=1e-3) and np.abs((values - params) / bse).max() < 2e-3)


def test_given_noise_weighs_as_in_statsmodels_wls() -> None:
    found = identify_estimated(dmu60p_model(), scattered(), GIVEN)
    weights = sigmas(scattered()) ** -2.0
    expected = WLS(right(), jacobian(), weights=weights).fit(cov_type="fixed scale", cov_kwds={"scale": 1.0})
    assert agrees(found, expected)
    assert found.values.fit is not None
    assert found.values.fit.chi2 == pytest.approx(expected.wresid @ expected.wresid / expected.df_resid, rel=1e-3)


def test_with_outliers_the_fit_is_that_of_the_other_readings() -> None:
    data, wild = scattered(), np.zeros(scattered().reading.size)
    spoilt = [7, 40, 66, 150]
    wild[spoilt] = (0.02, -0.05, 0.03, -5.0)
    found = identify_estimated(dmu60p_model(), replace(data, reading=data.reading + wild), GIVEN)
    others = np.setdiff1d(np.arange(data.reading.size), spoilt)
    expected = WLS(right()[others], jacobian()[others], weights=sigmas(data)[others] ** -2.0).fit(
        cov_type="fixed scale", cov_kwds={"scale": 1.0}
    )
    assert agrees(found, expected)
    assert any(
        "4 of 234 readings are left out as outliers, too far from the others of their run: " in note
        for note in found.report.notes
    )
    assert found.values.fit is not None
    assert found.values.fit.state == "converged"


def test_runs_that_are_far_from_zero_are_told() -> None:
    data = scattered()
    real = IdentifyOptions(known=ErrorValues(machine="dmu60p", parameters=PARAMETERS), squareness="known")
    off = data.reading + np.where(data.run == 4, 0.4, 0.0)
    found, shifted = (
        identify_estimated(dmu60p_model(), one, real).report.notes for one in (data, replace(data, reading=off))
    )
    assert not any("the laser zero of " in note for note in found)
    (told,) = [note for note in shifted if "the laser zero of " in note]
    assert "1 of 18 runs" in told
    assert "Y-5 by 4" in told


def test_noise_from_repeats_is_that_of_each_run_whatever_the_model() -> None:
    """Pure error, by hand: variance within the places. Degree 1 fits badly, which the noise must not hear of."""
    data = scattered()
    tripled = Observations(
        source=data.source,
        runs=data.runs,
        run=np.tile(data.run, 3),
        positions=np.tile(data.positions, 3),
        reading=np.tile(data.reading, 3),
    )
    noise = np.random.default_rng(1).normal(0.0, 3e-4, tripled.reading.size)
    tripled = replace(tripled, reading=tripled.reading + noise)
    groups = weighting(tripled, NoiseModel(repeats="run")).groups
    assert {group.group for group in groups} == {run.id for run in data.runs}
    for group in groups:
        mine = [run.id for run in data.runs].index(group.group)
        values = noise.reshape(3, -1)[:, data.run == mine]
        assert group.um == pytest.approx(1e3 * np.sqrt(values.var(axis=0, ddof=1).mean()))
        assert group.freedom == 2 * values.shape[1]
    found = identify_estimated(
        dmu60p_model(), tripled, with_estimation(replace(KNOWN, noise=NoiseModel(repeats="run")), degree=1)
    )
    assert found.report.noise_um == pytest.approx(
        np.sqrt(np.mean([(group.um) ** 2 for group in groups for _ in range(39)])), rel=1e-6
    )
    assert found.values.fit is not None
    assert found.values.fit.chi2 is not None
    assert found.values.fit.chi2 > 1.3**2


def test_repeats_tell_the_noise_of_one_instrument_beside_one_that_is_stated() -> None:
    """All or nothing was refused where the ball bar repeats nothing."""
    laser = scattered()
    draw = np.random.default_rng(8)
    tripled = laser.of(np.tile(np.arange(laser.reading.size), 3))
    tripled = replace(tripled, reading=tripled.reading + draw.normal(0.0, 2e-3, tripled.reading.size))
    bars = tuple(replace(run, instrument="ballbar") if run.id == "X-1" else run for run in laser.runs)
    both = replace(tripled, runs=bars)
    of_bar = np.array([bars[index].instrument == "ballbar" for index in both.run])
    weights = weighting(both, NoiseModel(by_group={"ballbar": 0.7}, repeated=frozenset({"laser"})))
    bar, found = weights.groups
    assert (bar.group, bar.um, bar.freedom) == ("ballbar", 0.7, None)
    assert found.group == "laser"
    assert found.freedom == (~of_bar).sum() * 2 // 3
    assert found.um == pytest.approx(2.0, rel=0.05)
    assert noise_option("laser=repeats, ballbar=0.7") == NoiseModel(
        by_group={"ballbar": 0.7}, repeated=frozenset({"laser"})
    )
    for wrong, told in (("laser=0,3", "decimals have a point"), ("laser=1,laser=repeats", "more than once")):
        with pytest.raises(argparse.ArgumentTypeError, match=told):
            noise_option(wrong)


def test_readings_approached_from_both_sides_are_no_repeats() -> None:
    data = scattered()
    twice = Observations(
        source=data.source,
        runs=data.runs,
        run=np.tile(data.run, 2),
        positions=np.tile(data.positions, 2),
        reading=np.concatenate([data.reading, data.reading + 0.01]),
        directions=np.repeat(np.array([[1], [-1]], dtype=np.int8), data.reading.size, axis=0).reshape(1, -1),
    )
    squares, freedom = pure_error(twice, np.zeros(twice.reading.size, dtype=np.int64), 1)
    assert (float(squares[0]), int(freedom[0])) == (0.0, 0)


def test_groups_without_noise_and_too_few_repeats_are_told() -> None:
    with pytest.raises(InputError, match="neither an instrument nor a run"):
        weighting(scattered(), NoiseModel(by_group={"lazer": 1.0, "laser": 1.0}))
    with pytest.raises(InputError) as fault:
        weighting(scattered(), NoiseModel(by_group={"Y-5": 1.0}))
    count = np.unique(scattered().run).size - 1
    (told,) = fault.value.faults  # one line that counts them, not one for each run
    assert f'says nothing of {count} runs of the laser, "X-1" first' in str(told)
    with pytest.raises(InputError, match="0 degrees of freedom"):
        weighting(scattered(), NoiseModel(repeats="instrument"))


def test_weights_are_one_on_average_and_fall_with_the_noise() -> None:
    found = weighting(scattered(), NoiseModel(by_group=SIGMA_UM))
    assert np.mean(found.roots**2) == pytest.approx(1.0)
    assert found.sigma is not None
    assert np.allclose(found.sigma / found.roots, sigmas(scattered()))


def test_a_ball_bar_that_starts_far_from_zero_beside_its_other_runs_is_a_misfit() -> None:
    """A laser that was not set to zero spoils nothing; a bar has one length, and something is not where it is said."""
    lines, bars = paper_runs(), [bar(f"xy{k}", 600.0 + 15.0 * k) for k in range(5)]
    at = [*(line(moving(run), 6) for run in lines), *(circle(run, (0, 1), 24) for run in bars)]
    data = noisy(observed(generator(cubic_errors()), (*lines, *bars), at), seed=4)
    found, far = (
        identify_estimated(
            dmu60p_model(),
            replace(data, reading=data.reading + np.where(data.run == data.run[-1], off, 0.0)),
            IdentifyOptions(known=ErrorValues(machine="dmu60p", parameters=PARAMETERS), squareness="known"),
        )
        for off in (0.0, 0.3)
    )
    assert [one.values.fit.state for one in (found, far) if one.values.fit] == ["converged", "misfit"]
    assert far.values.fit is not None
    assert far.values.fit.runs == ("xy4",)
    assert far.report.quality is not None
    assert "the ballbar zero of 1 of 5 runs is larger than " in far.report.quality.reason
    assert ": xy4 by 29" in far.report.quality.reason  # um, of 300
