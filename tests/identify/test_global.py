"""All readings at once: against the independent generator, and against scipy on a small case."""

import tracemalloc
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.machine import Function
from tests.identify.data import AXES, P9_PRINTED, TRAVEL, line, moving, observed, paper_data, paper_runs
from tests.identify.machines import PlainMachine, dmu60p
from tests.identify.test_paper import DIMENSIONS, level
from trueaxis.estimation.observations import Observations
from trueaxis.faults import InputError
from trueaxis.identify.global_fit.method import identify_global
from trueaxis.identify.global_fit.result import GlobalOptions
from trueaxis.identify.report import Identification
from trueaxis.measure.machine import FloatArray, View
from trueaxis.measure.reading_model import expected_readings
from trueaxis.measure.setup import PointOn, Run
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues

LEVER = 700.0
KNOWN = GlobalOptions("known", ErrorValues("dmu60p", parameters=PARAMETERS))
CONVENTION = GlobalOptions("convention", ErrorValues("dmu60p", parameters=DIMENSIONS))


def off(found: Identification, truth: dict[str, Function], name: str) -> float:
    at = np.linspace(0.0, TRAVEL[name[2]], 41)
    values = found.values.motion_errors[name](at)
    difference = values - np.array([float(truth[name](s)) for s in at])
    return float(np.abs(difference).max()) * (LEVER if name[1] in "ABC" else 1.0)


def bar(run_id: str, height: float, length: float = 150.0) -> Run:
    return Run(
        run_id,
        "ballbar",
        PointOn("tool", (0.0, 0.0, -height)),
        PointOn("workpiece", (20.0, 30.0, 10.0)),
        "bed",
        dict.fromkeys(AXES, 0.0),
        length=length,
    )


def circle(machine: PlainMachine, run: Run, plane: tuple[int, int], count: int) -> FloatArray:
    """Positions that take the tool ball round the workpiece ball at the nominal length, the third axis still."""
    start = machine.with_values(ErrorValues("dmu60p", parameters=DIMENSIONS))
    view: View = "tool_in_workpiece"
    at_home = start.view_ideal(view, np.zeros((3, 1)), np.array([run.target.point]).T)[:, 0]
    angle = 2.0 * np.pi * np.arange(count) / count
    moved = np.repeat((np.array(run.reference.point) - at_home)[:, np.newaxis], count, axis=1)
    assert run.length is not None
    moved[plane[0]] += run.length * np.cos(angle)
    moved[plane[1]] += run.length * np.sin(angle)
    moved[1] *= -1.0  # Y carries the workpiece
    return moved


def mixed_data(truth: dict[str, Function], count: int = 10, seed: int | None = None) -> Observations:
    """The paper's runs and two ball-bar circles, with noise where a seed is given."""
    lasers = paper_runs()
    bars = (bar("xy", 600.0), bar("xz", 680.0, 120.0))  # the tool frame is 400 mm above the table
    positions = [line(moving(run), count) for run in lasers]
    positions += [circle(dmu60p(), bars[0], (0, 1), 36), circle(dmu60p(), bars[1], (0, 2), 36)]
    data = observed(generator(truth), (*lasers, *bars), positions)
    noise = (
        np.zeros(data.reading.size) if seed is None else np.random.default_rng(seed).normal(0, 3e-4, data.reading.size)
    )
    return replace(data, reading=data.reading + noise)


def test_noise_free_readings_give_the_errors_back() -> None:
    truth = cubic_errors()
    found = identify_global(dmu60p(), paper_data(generator(truth)), KNOWN)
    assert max(off(found, truth, name) for name in truth) < 1e-12
    assert found.report.blocks[0].rank == found.report.blocks[0].unknowns == 18 * 7


def test_ball_bar_readings_agree_with_the_same_errors() -> None:
    truth = cubic_errors()
    found = identify_global(dmu60p(), mixed_data(truth), KNOWN)
    assert found.report.left_out == ()
    assert found.report.residual_rms_um < 1e-9
    assert max(off(found, truth, name) for name in truth) < 1e-12


def test_squareness_by_convention_comes_back_where_the_truth_obeys_it() -> None:
    truth = level(cubic_errors(), 10)
    found = identify_global(dmu60p(), paper_data(generator(truth)), CONVENTION)
    assert max(off(found, truth, name) for name in truth) < 1e-11
    for name in ("eps_xy", "eps_yz", "eps_xz"):
        assert abs(found.values.parameters[name] - PARAMETERS[name]) * LEVER < 1e-11
    words = [item.combination for item in found.values.undetermined]
    assert len(words) == 3
    assert (
        "eps_xy and the slope of EYX: only their sum is determined (+1 rad of eps_xy with -1 mm/mm of EYX" in words[0]
    )
    assert found.report.blocks[0].rank == found.report.blocks[0].unknowns - 3


@pytest.mark.slow
def test_fit_and_covariance_are_those_of_scipy() -> None:
    """Degree 2, the paper's runs: Levenberg-Marquardt on the same readings, its own numerical derivative."""
    truth = cubic_errors()
    data = paper_data(generator(truth), 5)
    data = replace(data, reading=data.reading + np.random.default_rng(3).normal(0.0, 1e-3, data.reading.size))
    machine = dmu60p()
    options = replace(KNOWN, noise_um=1.0, degree=2)
    found = identify_global(machine, data, options)
    names = machine.components
    size = np.array([[(1e-2 if n[1] in "XYZ" else 2e-5) / TRAVEL[n[2]] ** k for k in (1, 2)] for n in names]).ravel()

    def residual(scaled: FloatArray) -> FloatArray:
        coefficients = (scaled * size).reshape(-1, 2).tolist()
        curves = {n: PolynomialCurve((1, 2), (a, b)) for n, (a, b) in zip(names, coefficients, strict=True)}
        values = ErrorValues("dmu60p", PARAMETERS, curves)
        expected = expected_readings(machine.with_values(values), data.runs, data.run, data.positions)
        return (data.reading - expected) / 1e-3

    solved = least_squares(residual, np.zeros(size.size), method="lm", diff_step=np.array(1e-8))
    jacobian = np.asarray(solved.jac)
    u = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian))) * size
    ours = np.array([found.values.motion_errors[n].coefficients for n in names]).ravel()  # type: ignore[union-attr]
    our_u = np.array([found.values.motion_errors[n].u for n in names]).ravel()
    assert np.allclose(our_u, u, rtol=1e-3)
    assert np.abs((ours - solved.x * size) / u).max() < 2e-3


@pytest.mark.slow
def test_uncertainty_covers_the_scatter_of_repeated_identification() -> None:
    truth = level(cubic_errors(), 6)
    clean = mixed_data(truth, 6)
    machine = dmu60p()
    options = replace(CONVENTION, degree=3)
    draws, source = 150, np.random.default_rng(11)
    z: dict[str, list[float]] = {name: [] for name in (*machine.components, "eps_xy", "eps_xz", "eps_yz")}
    for _ in range(draws):
        noisy = replace(clean, reading=clean.reading + source.normal(0.0, 3e-4, clean.reading.size))
        found = identify_global(machine, noisy, options).values
        for name in machine.components:
            curve = found.motion_errors[name]
            assert isinstance(curve, PolynomialCurve)
            assert curve.u is not None
            z[name].append((curve.coefficients[0] - _first_coefficient(truth[name])) / curve.u[0])
        for name in ("eps_xy", "eps_xz", "eps_yz"):
            z[name].append((found.parameters[name] - PARAMETERS[name]) / found.u[name])
    spread = {name: float(np.std(values)) for name, values in z.items()}
    assert all(0.8 < s < 1.22 for s in spread.values()), spread  # 150 draws: standard error 6 %
    assert np.mean(list(spread.values())) == pytest.approx(1.0, abs=0.06)
    inside = np.mean([abs(value) < 1.96 for values in z.values() for value in values])
    assert inside == pytest.approx(0.95, abs=0.015)


def _first_coefficient(function: Function) -> float:
    """Of a cubic without constant term, from three values."""
    at = np.array([100.0, 200.0, 300.0])
    return float(np.linalg.solve(at[:, np.newaxis] ** [1, 2, 3], [float(function(s)) for s in at])[0])


def test_noise_is_estimated_from_what_is_left_over() -> None:
    found = identify_global(dmu60p(), mixed_data(cubic_errors(), seed=2), replace(KNOWN, degree=3))
    assert found.report.freedom == 18 * 9 + 72 - 54 - 5  # the centre of the ball and two lengths of bars
    assert found.report.noise_um == pytest.approx(0.3, rel=0.15)  # 180 degrees of freedom: 5 %


def test_published_points_leave_z_open_and_it_is_said() -> None:
    truth = cubic_errors()
    found = identify_global(dmu60p(), paper_data(generator(truth), 10, P9_PRINTED), replace(KNOWN, noise_um=0.3))
    assert found.report.blocks[0].rank == 18 * 7 - 7
    known = {part.name: part.known for part in found.report.components}
    open_ones = {"EZZ", "EAZ", "EBZ", "EXZ", "EYZ", "EYX", "EZX", "EAX", "EZY"}
    assert {name for name in truth if known[name] != "determined"} == open_ones
    assert max(off(found, truth, name) for name in set(truth) - open_ones) < 1e-5
    (item,) = found.values.undetermined
    assert set(item.parameters) == open_ones
    assert "7 combinations undetermined" in item.combination
    assert np.isnan(found.values.motion_errors["EAZ"].u).all()  # type: ignore[arg-type]


def test_few_positions_lower_the_degree_and_unmeasured_components_are_named() -> None:
    runs = [run for run in paper_runs() if moving(run) == "X"]
    found = identify_global(dmu60p(), observed(generator(cubic_errors()), runs, [line("X", 4)] * 3), KNOWN)
    known = {part.name: part.known for part in found.report.components}
    assert {name for name, state in known.items() if state == "determined"} == {"EXX", "EBX", "ECX"}
    assert known["EYX"] == known["EAZ"] == "not measured"
    curve = found.values.motion_errors["EXX"]
    assert isinstance(curve, PolynomialCurve)
    assert curve.powers == (1, 2, 3)
    assert "EYX" in found.values.undetermined[-1].parameters


def test_order_of_rows_and_runs_does_not_matter() -> None:
    data, machine = mixed_data(cubic_errors(), 6, seed=4), dmu60p()
    base = identify_global(machine, data, CONVENTION)
    source = np.random.default_rng(0)
    rows, runs = source.permutation(data.reading.size), source.permutation(len(data.runs))
    mixed = Observations(
        data.source,
        tuple(data.runs[i] for i in runs),
        np.argsort(runs)[data.run[rows]],
        data.positions[:, rows],
        data.reading[rows],
    )
    other = identify_global(machine, mixed, CONVENTION)
    at = np.linspace(0.0, 540.0, 9)
    for name, curve in base.values.motion_errors.items():
        assert np.allclose(other.values.motion_errors[name](at), curve(at), rtol=0, atol=1e-11)
    assert [i.parameters for i in other.values.undetermined] == [i.parameters for i in base.values.undetermined]


def test_readings_that_hold_nothing_are_refused() -> None:
    runs = [paper_runs()[0]]
    with pytest.raises(InputError, match="no reading holds an unknown"):
        identify_global(dmu60p(), observed(generator({}), runs, [np.zeros((3, 2))]), KNOWN)


class Linear:
    """A cheap machine of many readings: the point moves by EXX .. ECX etc. to first order, exactly."""

    def __init__(self, machine: PlainMachine, values: ErrorValues | None = None) -> None:
        self.machine, self.values = machine, values or ErrorValues("dmu60p")
        for name in ("name", "axes", "travel", "components", "parameters", "location_errors"):
            setattr(self, name, getattr(machine, name))

    def with_values(self, errors: ErrorValues) -> "Linear":
        return Linear(self.machine, errors)

    def view_ideal(self, _: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        return positions + point

    def view_sensitivity(self, _: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        x, y, z = np.broadcast_to(point, positions.shape) + 0.3 * positions
        zero, one = np.zeros_like(x), np.ones_like(x)
        six = np.array([[one, zero, zero, zero, z, -y], [zero, one, zero, -z, zero, x], [zero, zero, one, y, -x, zero]])
        located = np.array([[zero, zero, z], [x, -z, zero], [zero, zero, zero]])
        return np.concatenate([six, six, six, located], axis=1)

    def view_deviation(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        errors = [
            self.values.motion_errors[name](positions[AXES.index(name[2])])
            if name in self.values.motion_errors
            else np.zeros(positions.shape[1])
            for name in self.machine.components
        ]
        located = [
            np.full(positions.shape[1], self.values.parameters.get(n, 0.0)) for n in self.machine.location_errors
        ]
        moved: FloatArray = np.einsum(
            "ijn,jn->in", self.view_sensitivity(view, positions, point), np.array(errors + located)
        )
        return moved

    def view_deviations(self, points: Sequence[tuple[View, FloatArray]], positions: FloatArray) -> list[FloatArray]:
        return [self.view_deviation(view, positions, point) for view, point in points]


def _many(runs: Sequence[Run], count: int) -> Observations:
    source = np.random.default_rng(8)
    run = np.repeat(np.arange(len(runs)), count // len(runs))
    positions = source.uniform(0.0, [[540.0], [700.0], [600.0]], (3, run.size))
    return Observations("", tuple(runs), run, positions, source.normal(0.0, 1e-3, run.size))


@pytest.mark.slow
def test_hundred_thousand_readings_take_bounded_memory() -> None:
    runs = paper_runs()
    machine, data = Linear(dmu60p()), _many(runs, 99_990)
    found = identify_global(machine, data)  # type: ignore[arg-type]
    assert found.report.blocks[0].unknowns == 18 * 7 + 3
    tracemalloc.start()
    identify_global(machine, data)  # type: ignore[arg-type]
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    whole = data.reading.size * found.report.blocks[0].unknowns * 8
    assert peak < 0.5 * whole  # of the design matrix
    assert found.report.noise_um == pytest.approx(1.0, rel=0.01)
