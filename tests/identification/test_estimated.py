"""The estimate of all errors: without a prior and with ideal instruments it is least squares, which the independent
generator, scipy and closed forms check.
"""

import tracemalloc
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.machine import Function
from tests.identification.data import (
    P9_PRINTED,
    TRAVEL,
    dmu60p_model,
    line,
    mixed_data,
    moving,
    noisy,
    observed,
    paper_data,
    paper_runs,
    with_estimation,
)
from tests.identification.test_paper import DIMENSIONS
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.state import linearised, started
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.report import Identification
from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import InputError
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.measurement.setup import Device
from trueaxis.model.curves import Curve, LegendreCurve, PolynomialCurve
from trueaxis.model.errors import ErrorValues

LEVER = 700.0
FINE = NoiseModel(um=1e-3)  # so little that every combination that readings hold counts as determined
KNOWN = IdentifyOptions(
    "known",
    ErrorValues(machine="dmu60p", parameters=PARAMETERS),
    estimation=EstimationOptions(prior=False, ideal=True, degree=7),
)
CONVENTION = replace(KNOWN, squareness="convention", known=ErrorValues(machine="dmu60p", parameters=DIMENSIONS))


def off(found: Identification, truth: dict[str, Function], name: str) -> float:
    at = np.linspace(0.0, TRAVEL[name[2]], 41)
    values = found.values.motion_errors[name](at)
    difference = values - np.array([float(truth[name](s)) for s in at])
    return float(np.abs(difference).max()) * (LEVER if name[1] in "ABC" else 1.0)


def known_of(found: Identification) -> dict[str, str]:
    return {part.name: part.known for part in found.report.components}


def level_over_travel(truth: dict[str, Function]) -> dict[str, Function]:
    """The same errors; least-squares lines of the straightness beside a squareness are level (Gauss's rule: exact)."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    levelled = dict(truth)
    for name in ("EYX", "EXZ", "EYZ"):
        at = 0.5 * TRAVEL[name[2]] * (nodes + 1.0)
        values = np.array([float(truth[name](s)) for s in at])
        slope = float(weights @ (nodes * values)) / float(weights @ nodes**2) / (0.5 * TRAVEL[name[2]])
        levelled[name] = _sloped(truth[name], -slope)
    return levelled


def _sloped(function: Function, by: float) -> Function:
    return lambda s: function(s) + by * s


@pytest.mark.parametrize("make", [lambda truth: paper_data(generator(truth)), mixed_data], ids=["lasers", "ball bars"])
def test_noise_free_readings_give_the_errors_back(make: object) -> None:
    truth = cubic_errors()
    found = identify_estimated(dmu60p_model(), make(truth), replace(KNOWN, noise=FINE))  # type: ignore[operator]
    assert max(off(found, truth, name) for name in truth) < 1e-12
    assert found.report.residual_rms_um < 1e-9
    assert found.report.left_out == ()
    assert set(known_of(found).values()) == {"determined"}
    assert found.values.undetermined == ()
    assert found.covariance.open.shape == (18 * 7, 0)


@pytest.mark.parametrize(
    ("make", "within"),
    [(lambda truth: paper_data(generator(truth)), 1e-6), (mixed_data, 1e-11)],
    ids=["lasers", "ball bars"],
)
def test_squareness_by_convention_comes_back_where_the_truth_obeys_it(make: object, within: float) -> None:
    """Lasers on the bed are read alike, to 1e-14 mm, by values that move the tool tip otherwise by 4e-7 mm."""
    truth = level_over_travel(cubic_errors())
    options = with_estimation(replace(CONVENTION, noise=FINE), degree=4)
    found = identify_estimated(dmu60p_model(), make(truth), options)  # type: ignore[operator]
    assert max(off(found, truth, name) for name in truth) < within
    for name in ("eps_xy", "eps_yz", "eps_xz"):
        assert abs(found.values.parameters[name] - PARAMETERS[name]) * LEVER < within
    assert found.values.undetermined == ()  # the convention settles what no reading does
    assert found.covariance.open.shape[1] == 0


@pytest.mark.slow
def test_fit_and_covariance_are_those_of_scipy() -> None:
    """Degree 2, the paper's runs: Levenberg-Marquardt on the same readings, its own numerical derivative.

    The estimate's is that of the error-free machine: it lets residuals pull where they do not, by 1e-4 of their size.
    """
    data = noisy(paper_data(generator(cubic_errors()), 5), 3, 1e-4)
    machine = dmu60p_model()
    found = identify_estimated(machine, data, with_estimation(replace(KNOWN, noise=NoiseModel(um=0.1)), degree=2))
    assert found.covariance.open.shape[1] == 0
    names = machine.components
    size = np.array([[(1e-2 if n[1] in "XYZ" else 2e-5) / TRAVEL[n[2]] ** k for k in (1, 2)] for n in names]).ravel()

    def residual(scaled: FloatArray) -> FloatArray:
        coefficients = (scaled * size).reshape(-1, 2).tolist()
        curves: dict[str, Curve] = {
            n: PolynomialCurve(powers=(1, 2), coefficients=(a, b))
            for n, (a, b) in zip(names, coefficients, strict=True)
        }
        values = ErrorValues(machine="dmu60p", parameters=PARAMETERS, motion_errors=curves)
        expected = expected_readings(machine.with_values(values), data.runs, data.run, data.positions)
        return (data.reading - expected) / 1e-4

    solved = least_squares(
        residual, np.zeros(size.size), method="lm", diff_step=np.array(1e-6), xtol=1e-14, ftol=1e-15, gtol=1e-15
    )
    jacobian = np.asarray(solved.jac)
    u = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian))) * size
    ours, our_u = in_powers(found)
    assert np.allclose(our_u, u, rtol=1e-3)
    assert np.abs((ours - solved.x * size) / u).max() < 5e-3


def in_powers(found: Identification) -> tuple[FloatArray, FloatArray]:
    """Coefficients of s, s^2, ... of all components one after the other, and their standard uncertainties."""
    values, u = [], []
    matrix = found.covariance.matrix
    for name in found.covariance.components:
        curve = found.values.motion_errors[name]
        assert isinstance(curve, LegendreCurve)
        rows = found.covariance.rows_of(name)
        powers = curve.basis.powers
        values += (np.array(curve.coefficients) @ powers).tolist()
        u += np.sqrt(np.diag(powers.T @ matrix[rows, rows] @ powers)).tolist()
    return np.array(values), np.array(u)


def test_noise_is_estimated_from_what_is_left_over() -> None:
    found = identify_estimated(dmu60p_model(), mixed_data(cubic_errors(), seed=2), with_estimation(KNOWN, degree=3))
    assert found.report.freedom == 18 * 10 + 72 - 54
    assert found.report.noise_um == pytest.approx(0.3, rel=0.15)  # 198 degrees of freedom: 5 %


def test_a_device_has_its_own_noise_and_is_not_judged_by_the_repeats_of_another() -> None:
    """Two lasers: the one that is repeated is twenty times as fine. Runs of the other are sound, and are no misfit."""
    plain = paper_data(generator(cubic_errors()), count=20)
    rough = np.array([moving(run) == "Y" for run in plain.runs])
    runs = tuple(
        replace(run, device=Device(id="plain" if of else "fine")) for run, of in zip(plain.runs, rough, strict=True)
    )
    rows = np.concatenate([np.arange(plain.reading.size), *[np.flatnonzero(~rough[plain.run])] * 2])
    data = replace(plain.of(rows), runs=runs)
    noise = np.random.default_rng(7).normal(0.0, np.where(rough[data.run], 6e-3, 3e-4))
    found = identify_estimated(
        dmu60p_model(), replace(data, reading=data.reading + noise), with_estimation(KNOWN, degree=3)
    )
    fit = found.values.fit
    assert fit is not None
    assert (fit.state, fit.unjudged) == ("converged", ("laser plain",))
    assert fit.chi2 == pytest.approx(1.0, abs=0.15)
    told = {one.instrument: one.noise_um for one in found.report.noise_groups}
    assert told == {"laser fine": pytest.approx(0.3, rel=0.1), "laser plain": pytest.approx(6.0, rel=0.2)}


def test_published_points_leave_z_open_and_it_is_said() -> None:
    """A value with a share in what is open has no uncertainty: EZX was off by 38 times what it had."""
    truth = cubic_errors()
    options = with_estimation(replace(KNOWN, noise=NoiseModel(um=0.01)), degree=3)
    found = identify_estimated(dmu60p_model(), paper_data(generator(truth), 10, P9_PRINTED), options)
    open_ones = {"EZZ", "EAZ", "EBZ", "EXZ", "EYZ", "EYX", "EZX", "EAX", "EZY"}
    assert found.covariance.open.shape == (18 * 3, 3)
    assert {name for name, known in known_of(found).items() if known != "determined"} == open_ones
    assert max(off(found, truth, name) for name in set(truth) - open_ones) < 1e-5
    (item,) = found.values.undetermined
    assert set(item.parameters) == open_ones
    assert np.isnan(found.values.motion_errors["EAZ"].u).all()  # type: ignore[arg-type]
    assert all(part.u is None for part in found.report.components if part.name in open_ones)


def test_a_high_degree_from_few_positions_is_open_and_unmeasured_components_are_zero() -> None:
    truth = cubic_errors()
    runs = [run for run in paper_runs() if moving(run) == "X"]
    data = observed(generator(truth), runs, [line("X", 4)] * 3)
    for degree, state in ((3, "determined"), (7, "partly")):
        found = identify_estimated(dmu60p_model(), data, with_estimation(replace(KNOWN, noise=FINE), degree=degree))
        known = known_of(found)
        measured = {name for name, said in known.items() if said == state}
        assert measured == {"EXX", "EBX", "ECX"}
        assert {said for name, said in known.items() if name not in measured} == {"undetermined"}
        at = line("X", 4)[0]
        for name in measured:  # a curve through the readings, whatever it does between them
            through = np.array([float(truth[name](s)) for s in at])
            assert np.abs(found.values.motion_errors[name](at) - through).max() < 1e-6
        assert np.abs(found.values.motion_errors["EYX"](at)).max() < 1e-12
        assert "EYX" in found.values.undetermined[0].parameters


@pytest.mark.parametrize("prior", [True, False])
def test_order_of_rows_and_runs_does_not_matter(prior: bool) -> None:
    data = mixed_data(cubic_errors(), 4, seed=4)
    options = with_estimation(
        replace(CONVENTION, noise=NoiseModel(by_group={"laser": 0.3, "ballbar": 0.5})), prior=prior, degree=3
    )
    base = identify_estimated(dmu60p_model(), data, options)
    source = np.random.default_rng(0)
    rows, runs = source.permutation(data.reading.size), source.permutation(len(data.runs))
    mixed = replace(data.of(rows), runs=tuple(data.runs[i] for i in runs), run=np.argsort(runs)[data.run[rows]])
    other = identify_estimated(dmu60p_model(), mixed, options)
    at = np.linspace(0.0, 540.0, 9)
    for name, curve in base.values.motion_errors.items():
        assert np.allclose(other.values.motion_errors[name](at), curve(at), rtol=0, atol=1e-9)
    for name, u in base.values.u.items():
        assert other.values.u[name] == pytest.approx(u, rel=1e-4)
    assert [i.parameters for i in other.values.undetermined] == [i.parameters for i in base.values.undetermined]


def test_readings_that_hold_nothing_are_refused() -> None:
    data = observed(generator({}), [paper_runs()[0]], [np.zeros((3, 2))])
    with pytest.raises(InputError, match="no reading holds an error of the machine"):
        identify_estimated(dmu60p_model(), data, KNOWN)


def test_the_memory_of_a_pass_does_not_grow_with_the_readings_of_a_run() -> None:
    model = dmu60p_model()
    given = ErrorValues(machine="dmu60p", parameters=PARAMETERS)
    source = np.random.default_rng(8)
    peaks = []
    for count in (24_000, 48_000):  # in pieces, both
        positions = source.uniform(0.0, [[540.0], [700.0], [600.0]], (3, count))
        run = np.zeros(count, dtype=np.int64)
        data = Observations(
            source="", runs=paper_runs()[:1], run=run, positions=positions, reading=source.normal(0.0, 1e-3, count)
        )
        layout = layout_of(model.with_values(given), data, given)
        state = started(layout, tuple(measured_runs(data)), given, {0: 1e-3})
        tracemalloc.start()
        linearised(state)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    derivative = 24_000 * layout.count * 8
    assert peaks[1] - peaks[0] < 0.1 * derivative  # of all readings by all unknowns
