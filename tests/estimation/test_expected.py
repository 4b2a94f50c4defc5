"""What a plan lets expect: against dense algebra, against the estimate's own scatter, and the volume's rigid part."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.planning.data import folder, model
from tests.planning.promise import NOISE, TOOL, outcomes, prior_sizes, ratio, shop
from trueaxis.estimation.expected import expected, expected_posterior, informing_rows
from trueaxis.estimation.instruments import CLASSES, own_kinds
from trueaxis.estimation.jacobian import pieces
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.tool_point import moved_by, tool_point, volume
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.candidates import candidates
from trueaxis.planning.kit import Kit
from trueaxis.planning.runs import no_runs

GIVEN = ErrorValues(machine="dmu60p")


def noise(observed: Observations) -> dict[int, float]:
    return dict.fromkeys(range(len(observed.runs)), NOISE)


def dense(layout: Layout, observed: Observations) -> tuple[FloatArray, FloatArray]:
    """(n, n) of the shared unknowns in units of their prior: the posterior by one matrix of all, own ones included."""
    blocks, owns = [], []
    for one in measured_runs(observed):
        size = np.array([CLASSES[kind].size for kind in own_kinds(one.rows.run, layout.straightness[one.rows.index])])
        parts = [(own * size / NOISE, others / NOISE) for _, own, others in pieces(layout, one.rows)]
        owns.append(np.vstack([own for own, _ in parts]))
        blocks.append(np.vstack([others for _, others in parts]) * (prior_sizes(layout) / layout.sizes))
    count = sum(own.shape[1] for own in owns)
    whole = np.zeros((sum(own.shape[0] for own in owns), layout.count + count))
    whole[:, : layout.count] = np.vstack(blocks)
    row, column = 0, layout.count
    for own in owns:
        whole[row : row + own.shape[0], column : column + own.shape[1]] = own
        row, column = row + own.shape[0], column + own.shape[1]
    covariance = np.linalg.inv(np.eye(whole.shape[1]) + whole.T @ whole)[: layout.count, : layout.count]
    return np.asarray(covariance), whole


@pytest.fixture(scope="module")
def paper() -> Observations:
    return folder("dmu60p_runs").observed


@pytest.fixture(scope="module")
def found(paper: Observations) -> Estimate:
    return expected(model(), paper, GIVEN, noise(paper))


def test_it_is_the_posterior_of_one_large_matrix(paper: Observations, found: Estimate) -> None:
    covariance, _ = dense(found.layout, paper)
    unit = found.spread / prior_sizes(found.layout)[:, np.newaxis]
    np.testing.assert_allclose(unit @ unit.T, covariance, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(found.scale, prior_sizes(found.layout), rtol=1e-12)


def test_readings_of_the_plan_are_not_looked_at(paper: Observations, found: Estimate) -> None:
    other = replace(paper, reading=np.random.default_rng(1).normal(size=paper.reading.size))
    np.testing.assert_array_equal(expected(model(), other, GIVEN, noise(paper)).spread, found.spread)


def test_rows_of_a_run_add_what_the_run_adds(paper: Observations) -> None:
    """All runs but one, and then the rows of that one: the same as all runs."""
    layout = layout_of(model(), paper, GIVEN)
    last = len(paper.runs) - 1
    without, _ = expected_posterior(layout, paper.of(np.flatnonzero(paper.run != last)), noise(paper))
    whole, _ = expected_posterior(layout, paper, noise(paper))
    scale = without.scale * layout.sizes
    rows = informing_rows(layout, measured_runs(paper)[-1].rows, NOISE, scale)
    spread = without.spread / without.scale[:, np.newaxis]
    by_rows = spread @ np.linalg.inv(np.eye(layout.count) + (rows @ spread).T @ (rows @ spread)) @ spread.T
    unit = whole.spread / whole.scale[:, np.newaxis]
    assert np.abs(by_rows - unit @ unit.T).max() < 2e-3  # what `informing_rows` leaves out as telling nothing
    assert np.abs(np.diag(spread @ spread.T - by_rows)).max() > 0.05


def test_the_scatter_of_posterior_means_is_as_expected(paper: Observations, found: Estimate) -> None:
    """3000 machines, set-ups and noises drawn, the mean by the normal equations of one large matrix."""
    _, whole = dense(found.layout, paper)
    draw, n = np.random.default_rng(4), found.layout.count
    truth = draw.standard_normal((whole.shape[1], 3000))
    readings = whole @ truth + draw.standard_normal((whole.shape[0], 3000))
    mean = np.linalg.solve(np.eye(whole.shape[1]) + whole.T @ whole, whole.T @ readings)
    moved = moved_by(found.layout, volume(model()), TOOL, "home") * prior_sizes(found.layout)[: found.layout.of_machine]
    off = moved @ (mean - truth)[:n][: found.layout.of_machine]
    u = tool_point(found, volume(model()), TOOL).u
    seen = np.sqrt(np.mean(off**2, axis=1).reshape(3, -1).sum(axis=0))
    np.testing.assert_allclose(seen, u, rtol=0.06)


def test_the_part_of_the_prior_is_a_part(found: Estimate) -> None:
    seen = tool_point(found, volume(model()), TOOL)
    assert (seen.u_prior <= seen.u * (1.0 + 1e-9)).all()
    assert (seen.u < seen.prior).all()
    one, two = (np.sqrt(np.mean(tool_point(found, volume(model()), tools).u ** 2)) for tools in (TOOL, TOOL + TOOL))
    assert two == pytest.approx(one, rel=1e-12)


def test_a_turn_of_the_whole_volume_counts_from_home_alone(found: Estimate) -> None:
    """Slopes of EYX, EZX ... and the squarenesses that make a rigid turn: nothing after the workpiece is placed."""
    layout = found.layout
    home, placed = (moved_by(layout, volume(model()), TOOL, datum) for datum in ("home", "best-fit"))
    offsets = layout.offsets
    turn = np.zeros(layout.of_machine)  # about Z: Y, which carries the workpiece, turned; and X turned with it
    turn[int(offsets[layout.components.index("EXY")])] = 1.0 / layout.bases[layout.components.index("EXY")].per_position
    turn[int(offsets[layout.components.index("EYX")])] = 1.0 / layout.bases[layout.components.index("EYX")].per_position
    signs = [
        float(np.linalg.norm(placed @ (turn * np.where(np.arange(turn.size) == np.flatnonzero(turn)[0], sign, 1.0))))
        for sign in (1.0, -1.0)
    ]
    assert min(signs) < 1e-9 * max(signs)  # the one is a turn, the other a squareness
    assert np.linalg.norm(home @ turn) > 0.1


def test_a_probed_plate_does_not_tell_how_the_volume_is_turned() -> None:
    """Plates in all planes: their form tells the errors, how each is aligned is not known to microradians."""
    every = candidates(model(), Kit(instruments=("probe",)))
    plan = no_runs("plates", model().axes).with_added(every)
    seen = expected(model(), plan.observed, GIVEN, noise(plan.observed))
    home, placed = (tool_point(seen, volume(model()), TOOL, datum).u for datum in ("home", "best-fit"))
    lines = no_runs("lines", model().axes).with_added(candidates(model(), Kit(instruments=("laser",))))
    by_lines = expected(model(), lines.observed, GIVEN, noise(lines.observed))
    assert home.mean() > 3.0 * placed.mean()
    # the squareness is told, the turn is not: together with lines as little as by lines alone
    both = no_runs("both", model().axes).with_added([*every, *candidates(model(), Kit(instruments=("laser",)))])
    u_both = tool_point(expected(model(), both.observed, GIVEN, noise(both.observed)), volume(model()), TOOL).u
    assert u_both.mean() > 0.7 * tool_point(by_lines, volume(model()), TOOL).u.mean()


@settings(max_examples=8, deadline=None)
@given(st.permutations(range(18)), st.integers(1, 18))
def test_order_does_not_matter_and_more_runs_tell_more(order: list[int], count: int) -> None:
    runs = folder("dmu60p_runs")
    ids = [runs.runs[index].id for index in order]
    few, whole = runs.of(ids[:count]).observed, runs.observed
    points = volume(model())[:, :20]
    one, other = (tool_point(expected(model(), of, GIVEN, noise(of)), points, TOOL).u for of in (few, whole))
    assert (other <= one * (1.0 + 1e-9)).all()
    shuffled = replace(whole, runs=tuple(whole.runs[index] for index in order), run=np.argsort(order)[whole.run])
    again = tool_point(expected(model(), shuffled, GIVEN, noise(whole)), points, TOOL).u
    np.testing.assert_allclose(again, other, rtol=1e-7)


@pytest.mark.slow
def test_predictions_are_as_good_as_promised() -> None:
    """First plan of four hours, machines and instruments drawn, the exact model, noise and sizes estimated."""
    one = shop(model(), 4.0, ("laser", "ballbar"))
    each = [outcomes(one, seed) for seed in range(4)]
    assert ratio([found["best-fit"] for found in each]) == pytest.approx(1.0, abs=0.15)
    assert ratio([found["home"] for found in each]) == pytest.approx(1.0, abs=0.4)  # mostly one turn for each machine
