"""Rank and uncertainty of plans against matrices made the long way."""

from dataclasses import replace

import numpy as np
import pytest

from tests.identify.data import P9_PRINTED, P9_REGULAR, line, moving, paper_runs
from tests.plan.data import IDEAL, known_but, laser, model, observations, path, plan
from tests.plan.explicit import by_location, by_power, design, rank, readings, unit_columns
from trueaxis.estimation.observations import Observations
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import PointOn, Run, Vector
from trueaxis.plan import expected
from trueaxis.plan.instruments import Assumptions
from trueaxis.plan.method import Plan, PlanOptions, judge
from trueaxis.runtime.errors import ErrorValues

LINKAGE = Assumptions(linkage_lines=True)


def paper_plan(p9: Vector, count: int = 6) -> Observations:
    runs = paper_runs(p9)
    return observations(runs, [line(moving(run), count) for run in runs])


def u(found: Plan, name: str) -> float:
    """Largest standard uncertainty of a curve, or that of a location error, for readings of 1 um."""
    spread = expected.covariance(found.system, found.settled, 1e-3)
    by_name = {one.name: one.u_measured for one in expected.curves(found.system, found.settled, spread)}
    by_name |= {one.name: one.u for one in expected.locations(found.system, found.settled, spread, spread)}
    value = by_name[name]
    assert value is not None
    return value


@pytest.mark.parametrize(("p9", "open_at_each_order"), [(P9_REGULAR, 0), (P9_PRINTED, 1)])
def test_rank_is_that_of_finite_differences(p9: Vector, open_at_each_order: int) -> None:
    observed = paper_plan(p9)
    found = plan(observed, PlanOptions(degree=3))
    assert found.system.factors.rank == rank(design(model(), observed, 3)) == 18 * 3 - 3 * open_at_each_order
    assert found.settled.settled.shape[1] == 3
    assert found.settled.open.shape[1] == 3 * open_at_each_order


def test_uncertainties_are_those_of_the_pseudo_inverse() -> None:
    """Squareness known: variances of the whole least-squares solution, in powers instead of the project's basis."""
    observed = paper_plan(P9_REGULAR)
    located = dict.fromkeys(model().location_errors, 0.0)
    found = plan(observed, PlanOptions(degree=2, known=ErrorValues("dmu60p", located)))
    whole = design(model(), observed, 2)[:, :36]
    size = np.linalg.norm(whole, axis=0)
    covariance = 1e-6 * np.linalg.inv(unit_columns(whole).T @ unit_columns(whole)) / np.outer(size, size)
    for index, name in enumerate(model().components):
        knots = np.unique(observed.positions["XYZ".index(name[2])]) / 100.0
        basis = np.stack([knots, knots**2])
        mine = slice(2 * index, 2 * index + 2)
        variance = np.einsum("kn,kl,ln->n", basis, covariance[mine, mine], basis)
        assert u(found, name) == pytest.approx(np.sqrt(variance.max()), rel=1e-6), name


def test_order_of_runs_does_not_matter() -> None:
    observed = paper_plan(P9_PRINTED)
    count = len(observed.runs)
    turned = replace(observed, runs=observed.runs[::-1], run=count - 1 - observed.run)
    one, other = (judge(plan(each, PlanOptions(degree=3))) for each in (observed, turned))
    assert (one.rank, one.settled) == (other.rank, other.settled)
    assert one.condition == pytest.approx(other.condition, rel=1e-9)
    for a, b in zip(one.curves, other.curves, strict=True):
        assert (a.state, a.determined) == (b.state, b.determined)
        assert a.u_travel == (None if b.u_travel is None else pytest.approx(b.u_travel, rel=1e-7))


def test_noise_scales_every_uncertainty() -> None:
    observed = paper_plan(P9_REGULAR)
    one, five = (judge(plan(observed, PlanOptions(noise_um=s, degree=2))) for s in (1.0, 5.0))
    for a, b in zip(one.curves, five.curves, strict=True):
        assert a.u_travel is not None
        assert b.u_travel == pytest.approx(5.0 * a.u_travel)


def bar(run_id: str, centre: Vector, length: float = 100.0) -> Run:
    home = dict.fromkeys("XYZ", 0.0)
    return Run(run_id, "ballbar", PointOn("tool"), PointOn("workpiece", centre), "bed", home, None, length)


def circle(centre: Vector, plane: tuple[int, int], count: int = 24) -> FloatArray:
    """Tool ball at commanded X, -Y, Z in the workpiece frame: Y carries the workpiece."""
    angle = 2.0 * np.pi * np.arange(count) / count
    way: FloatArray = np.repeat(np.array(centre)[:, np.newaxis], count, axis=1)
    way[plane[0]] += 100.0 * np.cos(angle)
    way[plane[1]] += 100.0 * np.sin(angle)
    way[1] *= -1.0
    return way


def test_unknown_centre_and_length_of_a_ball_bar_cost_what_finite_differences_say() -> None:
    """Explicit columns of the moved ball and the longer bar beside those of two unknown components."""
    centre = (250.0, -300.0, 250.0)
    runs = (bar("xy", centre), bar("zx", centre))
    observed = observations(runs, [circle(centre, (0, 1)), circle(centre, (2, 0))])
    known = known_but("EXX", "eps_xy")
    found = plan(observed, PlanOptions(degree=2, known=known))

    def with_ball(shift: Vector) -> np.ndarray:
        moved = tuple(replace(run, reference=PointOn("workpiece", shift)) for run in runs)
        return readings(model(), replace(observed, runs=moved), ErrorValues("dmu60p"))

    extra = []
    for axis in range(3):
        ends = [list(centre), list(centre)]
        ends[0][axis] += 1e-3
        ends[1][axis] -= 1e-3
        one, other = ((end[0], end[1], end[2]) for end in ends)
        extra.append((with_ball(one) - with_ball(other)) / 2e-3)
    extra.append(-np.ones(observed.reading.size))
    own = [by_power(model(), observed, "EXX", 1), by_power(model(), observed, "EXX", 2)]
    columns = np.column_stack([*own, by_location(model(), observed, "eps_xy"), *extra])
    # a linear EXX is partly a longer bar, but circles in two planes part them
    assert found.system.factors.rank + found.system.instruments == rank(columns) == 7
    size = np.linalg.norm(columns, axis=0)
    inverse = np.linalg.inv(unit_columns(columns).T @ unit_columns(columns)) / np.outer(size, size)
    assert u(found, "eps_xy") == pytest.approx(1e-3 * np.sqrt(inverse[2, 2]), rel=1e-5)
    ideal = plan(observed, PlanOptions(degree=2, known=known, assumed=IDEAL))
    assert u(ideal, "EXX") < 0.9 * u(found, "EXX")


def test_unknown_linkage_lines_hide_the_slopes_that_rest_on_them() -> None:
    observed = paper_plan(P9_REGULAR)
    found = plan(observed, PlanOptions(degree=3, assumed=LINKAGE))
    extra = []
    for lines in (["XZ-1x", "XZ-1z"], ["XZ-2x", "XZ-2z"], ["XY-1x", "XY-1y"], ["XY-2x"], ["YZ-1y", "YZ-1z"]):
        runs = [index for index, run in enumerate(observed.runs) if run.id in lines]
        rows = np.isin(observed.run, runs)
        plane = [index for index in range(3) if np.ptp(observed.positions[index, rows])]
        # the target is the tool in XZ; else the workpiece seen from it: Y moves it along, X and Z against
        against = 1.0 if lines[0].startswith("XZ") else -1.0
        signs = np.array([[1.0 if axis == 1 else against] for axis in plane])
        way = observed.positions[plane][:, rows] * signs
        motion = way[:, -1] / np.linalg.norm(way[:, -1])
        across = np.zeros(3)
        across[plane] = [-motion[1], motion[0]]
        directions = np.array([observed.runs[index].direction for index in observed.run[rows]])
        for values in (np.ones(way.shape[1]), motion @ way):
            column = np.zeros(observed.reading.size)
            column[rows] = directions @ across * values
            extra.append(column)
    whole = design(model(), observed, 3, extra)
    assert found.system.factors.rank + found.system.instruments == rank(whole)
    states = {one.name: one.state for one in judge(found).curves}
    assert {name for name, state in states.items() if state == "partly"} >= {"EBY", "ECZ", "EAX"}
    assert states["EXX"] == states["ECX"] == states["EYY"] == states["EZZ"] == "determined"


def test_an_unseen_axis_is_said_so() -> None:
    runs = [laser(f"X{i}", "x", point) for i, point in enumerate([(0.0, 0.0, 0.0), (0.0, 90.0, 0.0), (0.0, 0.0, 90.0)])]
    report = judge(plan(observations(runs, [path("X", [0, 200, 400])] * 3)))
    states = {one.name: one.state for one in report.curves}
    assert states["EXX"] == states["EBX"] == states["ECX"] == "determined"
    assert all(state == "not seen" for name, state in states.items() if name not in ("EXX", "EBX", "ECX"))
    assert any("no reading holds them" in item.combination and "EAX" in item.parameters for item in report.undetermined)
    assert "Y is not moved" in report.notes
