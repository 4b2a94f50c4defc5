"""Singular geometries, and points that mend them."""

from dataclasses import replace

import numpy as np
import pytest

from tests.plan.data import IDEAL, folder, laser, observations, path, plan
from trueaxis.measure.setup import PointOn, Vector
from trueaxis.plan.method import PlanOptions, judge, plan_of
from trueaxis.plan.order import same_coordinates
from trueaxis.plan.repair import repair
from trueaxis.plan.rows import with_run

STEPS = [0.0, 150.0, 300.0, 450.0]


def three(*points: Vector) -> "list[str]":
    """What is said of three lasers along x at points of the tool, block by block."""
    runs = [laser(f"L{i}", "x", (x + 10.0, y + 20.0, z + 30.0)) for i, (x, y, z) in enumerate(points, 1)]
    report = judge(plan(observations(runs, [path("X", STEPS)] * 3), PlanOptions(assumed=IDEAL)))
    (block,) = report.blocks
    return [block.because, *[str(pair) for pair in block.ranks]]


def test_points_in_a_triangle_are_regular() -> None:
    assert three((0.0, 0.0, 0.0), (9.0, 100.0, 0.0), (0.0, 0.0, 100.0)) == ["", "(3, 3)"]


def test_points_on_a_line_are_singular() -> None:
    because, ranks = three((0.0, 0.0, 0.0), (50.0, 50.0, 20.0), (0.0, 100.0, 40.0))
    assert ranks == "(2, 3)"
    assert "lie on a line" in because


def test_two_lasers_on_one_line_are_one() -> None:
    because, ranks = three((0.0, 0.0, 0.0), (80.0, 0.0, 0.0), (0.0, 100.0, 40.0))
    assert ranks == "(2, 3)"
    assert because == "the points of L1 and L2 have the same y and z"


def test_same_coordinates_need_one_direction_and_one_body() -> None:
    one, other = laser("A", "x", (0.0, 1.0, 2.0)), laser("B", "x", (5.0, 1.0, 2.0))
    assert same_coordinates([one, other]) == "the points of A and B have the same y and z"
    assert same_coordinates([one, replace(other, direction=(0.0, 1.0, 0.0))]) == ""
    assert same_coordinates([one, replace(other, target=PointOn("workpiece", (5.0, 1.0, 2.0)))]) == ""


def test_the_papers_z_points_in_words() -> None:
    report = judge(plan(folder("dmu60p_runs"), PlanOptions(degree=3)))
    words = [item.combination for item in report.undetermined]
    assert any(
        text == "EZZ, EAZ and EBZ: at each Z position 2 equations for 3 unknowns in runs Z-7, Z-8 and Z-9, because the "
        "points of Z-8 and Z-9 have the same x and y"
        for text in words
    )
    assert sum(item.settled for item in report.undetermined) == 3
    assert [block.components for block in report.blocks][:3] == [
        ("EXX", "EBX", "ECX"),
        ("EYY", "EAY", "ECY"),
        ("EZZ", "EAZ", "EBZ"),
    ]
    touched = {name for item in report.undetermined if not item.settled for name in item.parameters}
    assert {c.name for c in report.curves if c.state != "determined"} == touched & {c.name for c in report.curves}


def test_points_that_make_the_paper_regular() -> None:
    """Z-8 or Z-9 moved in x or y: by Eq. (17) alone the rows (1, x, -y) must then be independent."""
    found = plan(folder("dmu60p_runs"), PlanOptions(degree=2))
    mended = repair(found, judge(found))
    assert mended is not None
    assert mended.regular
    (move,) = mended.moves
    assert {move.run, *(other.run for other in mended.others)} == {"Z-8", "Z-9"}
    points = {run.id: run.target.point for run in found.observed.runs} | {move.run: move.moved}
    rows = np.array([[1.0, points[name][0], -points[name][1]] for name in ("Z-7", "Z-8", "Z-9")])
    assert abs(np.linalg.det(rows)) > 1e3
    index = next(i for i, run in enumerate(found.observed.runs) if run.id == move.run)
    elsewhere = replace(found.observed.runs[index], target=PointOn("tool", move.moved))
    again = plan_of(found.machine, with_run(found.observed, index, elsewhere), found.options)
    assert again.system.factors.rank == move.rank == 36
    assert not again.settled.open.shape[1]
    assert repair(again, judge(again)) is None


def test_no_point_helps_where_runs_are_missing() -> None:
    runs = [laser("A", "x", (0.0, 0.0, 0.0)), laser("B", "x", (0.0, 50.0, 0.0))]
    found = plan(observations(runs, [path("X", STEPS)] * 2), PlanOptions(degree=2))
    mended = repair(found, judge(found))
    assert mended is not None
    assert not mended.regular
    assert mended.moves == ()


@pytest.mark.parametrize("name", ["dmu60p_runs", "dmu60p_regular_runs"])
def test_a_plan_at_every_degree_has_the_rank_of_its_orders(name: str) -> None:
    """Every order of polynomial sees the same geometry: 17 or 18 combinations of the 18 components."""
    each = 17 if name == "dmu60p_runs" else 18
    for degree in (1, 4):
        found = plan(folder(name), PlanOptions(degree=degree))
        assert found.system.factors.rank == each * degree
