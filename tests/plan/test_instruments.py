"""What is assumed unknown of instruments."""

from dataclasses import replace

import numpy as np

from tests.identify.data import HOME
from tests.plan.data import folder, laser, model, observations, path
from trueaxis.measure.setup import PointOn, Run
from trueaxis.plan.instruments import Assumptions, instrument_unknowns
from trueaxis.plan.lines import line_kind, misplaced, path_line

STEPS = [0.0, 100.0, 200.0, 300.0]


def test_kinds_of_lines() -> None:
    single, both = path("X", STEPS), path("XY", STEPS)
    kinds = [
        line_kind(run, path_line(model(), run, at))
        for run, at in (
            (laser("a", "x", (0.0, 0.0, 0.0)), single),
            (laser("b", "z", (0.0, 0.0, 0.0)), single),
            (laser("c", "x", (0.0, 0.0, 0.0), PointOn("workpiece")), both),
            (laser("d", "z", (0.0, 0.0, 0.0), PointOn("workpiece")), both),
            (laser("e", "x", (0.0, 0.0, 0.0)), path("Y", STEPS)),  # the tool does not move with Y
        )
    ]
    assert kinds == ["displacement", "straightness", "linkage", "straightness", "none"]


def test_way_along_a_line_is_from_home() -> None:
    run = replace(laser("a", "z", (0.0, 0.0, 0.0)), home={**HOME, "X": 100.0})
    line = path_line(model(), run, path("X", STEPS))
    assert line is not None
    assert np.allclose(line[0], [1.0, 0.0, 0.0])
    assert np.allclose(line[1], [-100.0, 0.0, 100.0, 200.0])


def test_a_misplaced_line_of_two_axes_by_hand() -> None:
    """At 45 deg in xz, moved across by 1: x reads -1/sqrt 2 and z +1/sqrt 2, or the other way round."""
    motion, way = np.array([1.0, 0.0, 1.0]) / np.sqrt(2.0), np.array([0.0, 10.0])
    columns = misplaced([np.eye(3)[0], np.eye(3)[2]], [(motion, way), (motion, way)])
    half = np.sqrt(0.5) * np.sign(columns[0, 0])
    assert np.allclose(columns, [[half, 0.0], [half, 10 * half], [-half, 0.0], [-half, -10 * half]])


def test_who_has_unknowns() -> None:
    observed = observations(
        [laser("d", "x", (0.0, 0.0, 0.0)), laser("s", "y", (0.0, 0.0, 0.0))], [path("X", STEPS)] * 2
    )
    assert instrument_unknowns(model(), observed, Assumptions(ideal=True)) == ()
    (line,) = instrument_unknowns(model(), observed, Assumptions())
    assert line.runs == (1,)
    assert np.allclose(line.columns, np.column_stack([np.ones(4), STEPS]))
    with_zero = instrument_unknowns(model(), observed, Assumptions(zeros=True))
    assert next(one.names for one in with_zero) == ("zero of run d",)


def test_runs_of_one_linkage_line_share_it() -> None:
    found = instrument_unknowns(model(), folder("dmu60p_runs"), Assumptions(linkage_lines=True))
    ids = [run.id for run in folder("dmu60p_runs").runs]
    assert [[ids[index] for index in one.runs] for one in found] == [
        ["XZ-1x", "XZ-1z"],
        ["XZ-2x", "XZ-2z"],
        ["XY-1x", "XY-1y"],
        ["XY-2x"],
        ["YZ-1y", "YZ-1z"],
    ]
    assert all(one.columns.shape[1] == 2 for one in found)


def test_ball_bars_with_a_common_length_or_ball_hang_together() -> None:
    def bar(run_id: str, ball: tuple[float, float, float], length: float) -> Run:
        return Run(run_id, "ballbar", PointOn("tool"), PointOn("workpiece", ball), "bed", HOME, None, length)

    ball, other = (200.0, -100.0, 50.0), (300.0, -100.0, 50.0)
    runs = [bar("a", ball, 100.0), bar("b", ball, 150.0), bar("c", other, 150.0), bar("d", (9.0, 9.0, 9.0), 50.0)]
    found = instrument_unknowns(model(), observations(runs, [path("XY", STEPS)] * 4), Assumptions())
    assert [one.runs for one in found] == [(0, 1, 2), (3,)]
