"""Weights, robustness and chosen degrees: against statsmodels on a design matrix differentiated numerically."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from statsmodels.regression.linear_model import WLS
from statsmodels.robust.norms import HuberT, TukeyBiweight
from statsmodels.robust.robust_linear_model import RLM

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.identify.data import TRAVEL, line, moving, observed, paper_data, paper_runs
from tests.identify.test_global import CONVENTION, KNOWN
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.repeats import pure_error
from trueaxis.faults import InputError
from trueaxis.identify.global_fit.method import identify_global
from trueaxis.identify.report import Identification
from trueaxis.identify.weighting import NoiseModel, weighting
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]

DEGREE = 2
SIGMA_UM = {"X-1": 2.0, "Y-5": 0.2, "laser": 0.7}


@cache
def dmu60p() -> MachineModel:
    return load_model(ROOT / "machines" / "dmu60p.toml", None, ROOT / "generated", backend="numpy")


def quadratic() -> dict[str, PolynomialCurve]:
    """So small that the exact model is linear within rounding."""
    source = np.random.default_rng(6)
    return {
        name: PolynomialCurve((1, 2), (float(a) / TRAVEL[name[2]], float(b) / TRAVEL[name[2]] ** 2))
        for name in dmu60p().components
        for a, b in [source.normal(0.0, 3e-3 if name[1] in "XYZ" else 4e-6, 2)]
    }


def given_sigma(run: str) -> float:
    return SIGMA_UM.get(run, SIGMA_UM["laser"]) * 1e-3


@cache
def noisy() -> Observations:
    """The paper's runs but for their starts, where nothing is read, with noise that differs by run."""
    data = observed(generator(dict(quadratic())), paper_runs(), [line(moving(run), 14)[:, 1:] for run in paper_runs()])
    sigma = np.array([given_sigma(run.id) for run in data.runs])[data.run]
    noise = np.random.default_rng(5).normal(0.0, 1.0, data.reading.size) * sigma
    return replace(data, reading=data.reading + noise, seq=np.arange(data.reading.size) + 1)


@cache
def jacobian() -> FloatArray:
    """(n_readings, 36): by central differences of the expected readings, in coefficients of plain powers / scale."""
    machine, data = dmu60p(), noisy()
    columns = []
    for name, power in ((name, power) for name in machine.components for power in (1, 2)):
        step = size(name, power)
        ends = [
            expected_readings(
                machine.with_values(
                    ErrorValues("dmu60p", PARAMETERS, {name: PolynomialCurve((power,), (sign * step,))})
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
    machine, data = dmu60p().with_values(ErrorValues("dmu60p", PARAMETERS)), noisy()
    return data.reading - expected_readings(machine, data.runs, data.run, data.positions)


def scaled(found: Identification, what: str) -> FloatArray:
    curves = found.values.motion_errors
    return np.array(
        [getattr(curves[name], what)[power - 1] / size(name, power) for name in dmu60p().components for power in (1, 2)]
    )


def test_given_noise_weighs_as_in_statsmodels_wls() -> None:
    options = replace(KNOWN, degree=DEGREE, noise_by_group=SIGMA_UM)
    found = identify_global(dmu60p(), noisy(), options)
    sigma = np.array([given_sigma(run.id) for run in noisy().runs])[noisy().run]
    expected = WLS(right(), jacobian(), weights=sigma**-2.0).fit(cov_type="fixed scale", cov_kwds={"scale": 1.0})
    assert np.allclose(scaled(found, "u"), expected.bse, rtol=1e-3)
    assert np.abs((scaled(found, "coefficients") - expected.params) / expected.bse).max() < 2e-3
    assert {group.group for group in found.report.noise_groups} == {"X-1", "Y-5", "laser"}
    assert found.report.noise_ratio == pytest.approx(
        np.sqrt(expected.wresid @ expected.wresid / expected.df_resid), rel=1e-3
    )


@pytest.mark.parametrize(("kind", "norm"), [("huber", HuberT(1.345)), ("tukey", TukeyBiweight(4.685))])
def test_robust_fit_is_that_of_statsmodels_rlm(kind: str, norm: object) -> None:
    data = noisy()
    wild = np.zeros(data.reading.size)
    wild[[7, 40, 66]] = (0.02, -0.05, 0.03)
    spoilt = replace(data, reading=data.reading + wild)
    options = replace(KNOWN, degree=DEGREE, robust=kind)  # type: ignore[arg-type]
    found = identify_global(dmu60p(), spoilt, options)
    expected = RLM(right() + wild, jacobian(), M=norm).fit(cov="H1", tol=1e-10, maxiter=500)
    assert found.report.noise_um == pytest.approx(expected.scale * 1e3, rel=1e-3)
    assert np.abs((scaled(found, "coefficients") - expected.params) / expected.bse).max() < 5e-3
    assert np.allclose(scaled(found, "u"), expected.bse, rtol=5e-3)
    told = {(one.run, one.seq) for one in found.report.doubted}
    assert {(data.runs[data.run[row]].id, row + 1) for row in (7, 40, 66)} <= told


@pytest.mark.slow
def test_outliers_do_not_spoil_a_robust_fit() -> None:
    truth = cubic_errors()
    data = paper_data(generator(truth), 25)
    source = np.random.default_rng(3)
    wild = source.choice(data.reading.size, 20, replace=False)
    reading = data.reading + source.normal(0.0, 3e-4, data.reading.size)
    reading[wild] += source.choice([-1.0, 1.0], 20) * 0.05
    spoilt = replace(data, reading=reading)
    rows = {
        robust: _off(identify_global(dmu60p(), spoilt, replace(KNOWN, degree=3, robust=robust)))
        for robust in ("", "huber", "tukey")
    }
    assert rows["tukey"] < 0.1 * rows[""]
    assert rows["tukey"] < rows["huber"] < 0.5 * rows[""]
    found = identify_global(dmu60p(), spoilt, replace(KNOWN, degree=3, robust="tukey"))
    away = np.asarray(spoilt.positions.any(axis=0))
    assert {(one.run, one.seq) for one in found.report.doubted} >= {
        (data.runs[data.run[row]].id, int(row)) for row in wild if away[row]
    }


def _off(found: Identification) -> float:
    """Root mean square over components and positions, mm."""
    total = []
    for name, function in cubic_errors().items():
        at = np.linspace(0.0, TRAVEL[name[2]], 11)
        lever = 700.0 if name[1] in "ABC" else 1.0
        total.append(lever * (found.values.motion_errors[name](at) - np.array([float(function(s)) for s in at])))
    return float(np.sqrt(np.mean(np.array(total) ** 2)))


def test_noise_from_repeats_is_that_of_each_instrument_whatever_the_model() -> None:
    """Pure error, by hand: variance within the places. Degree 1 fits badly, which the noise must not hear of."""
    data = noisy()
    tripled = Observations(
        data.source, data.runs, np.tile(data.run, 3), np.tile(data.positions, 3), np.tile(data.reading, 3)
    )
    noise = np.random.default_rng(1).normal(0.0, 1e-3, tripled.reading.size)
    tripled = replace(tripled, reading=tripled.reading + noise)
    found = identify_global(dmu60p(), tripled, replace(KNOWN, degree=1, repeats="run"))
    of_places = noise.reshape(3, -1)
    for group in found.report.noise_groups:
        mine = [run.id for run in data.runs].index(group.group)
        values = of_places[:, data.run == mine]
        assert group.noise_um == pytest.approx(1e3 * np.sqrt(values.var(axis=0, ddof=1).mean()))
        assert group.freedom == 2 * values.shape[1]
    assert found.report.noise_ratio is not None
    assert found.report.noise_ratio > 1.3


def test_readings_approached_from_both_sides_are_no_repeats() -> None:
    data = noisy()
    twice = Observations(
        data.source,
        data.runs,
        np.tile(data.run, 2),
        np.tile(data.positions, 2),
        np.concatenate([data.reading, data.reading + 0.01]),
        directions=np.repeat(np.array([[1], [-1]], dtype=np.int8), data.reading.size, axis=0).reshape(1, -1),
    )
    squares, freedom = pure_error(twice, np.zeros(twice.reading.size, dtype=np.int64), 1)
    assert (float(squares[0]), int(freedom[0])) == (0.0, 0)


def test_groups_without_noise_and_too_few_repeats_are_told() -> None:
    with pytest.raises(InputError, match="neither an instrument nor a run"):
        weighting(noisy(), NoiseModel(by_group={"lazer": 1.0, "laser": 1.0}))
    with pytest.raises(InputError, match='says nothing of run "X-1"'):
        weighting(noisy(), NoiseModel(by_group={"Y-5": 1.0}))
    with pytest.raises(InputError, match="0 degrees of freedom"):
        weighting(noisy(), NoiseModel(repeats="instrument"))


def test_weights_are_one_on_average_and_fall_with_the_noise() -> None:
    found = weighting(noisy(), NoiseModel(by_group=SIGMA_UM))
    assert np.mean(found.roots**2) == pytest.approx(1.0)
    assert found.sigma is not None
    assert np.allclose(found.sigma / found.roots, [given_sigma(noisy().runs[run].id) for run in noisy().run])


@given(st.integers(0, 10**6))
@settings(max_examples=3, deadline=None)
def test_order_of_rows_and_runs_does_not_matter(seed: int) -> None:
    """Not to values, uncertainties, instruments, weights or degrees."""
    data = noisy()
    options = replace(CONVENTION, degree="auto", noise_by_group=SIGMA_UM)
    source = np.random.default_rng(seed)
    rows, runs = source.permutation(data.reading.size), source.permutation(len(data.runs))
    mixed = replace(data.of(rows), runs=tuple(data.runs[i] for i in runs), run=np.argsort(runs)[data.run[rows]])
    base, other = (identify_global(dmu60p(), one, options) for one in (data, mixed))
    assert base.report.orders is not None
    assert other.report.orders is not None
    assert base.report.orders.degrees == other.report.orders.degrees
    at = np.linspace(0.0, 540.0, 7)
    for name, curve in base.values.motion_errors.items():
        assert np.allclose(other.values.motion_errors[name](at), curve(at), rtol=0, atol=1e-9), name
    for name, u in base.values.u.items():
        assert other.values.u[name] == pytest.approx(u, rel=1e-4)


def test_degrees_follow_the_truth_and_hold_out_better() -> None:
    """Cubic errors: full polynomials of degree 7 fit the noise; chosen ones are lower and predict better."""
    truth = cubic_errors()
    data = paper_data(generator(truth), 28)
    data = replace(data, reading=data.reading + np.random.default_rng(2).normal(0.0, 3e-4, data.reading.size))
    auto = identify_global(dmu60p(), data, replace(KNOWN, degree="auto"))
    full = identify_global(dmu60p(), data, replace(KNOWN, degree=7))
    orders = auto.report.orders
    assert orders is not None
    assert all(1 <= degree <= 5 for degree in orders.degrees.values())
    assert np.mean([*orders.degrees.values()]) < 3.5
    assert orders.held_out_um < orders.held_out_highest_um < orders.held_out_none_um
    assert orders.held_out_um == pytest.approx(0.3, rel=0.1)
    assert _off(auto) < _off(full)
