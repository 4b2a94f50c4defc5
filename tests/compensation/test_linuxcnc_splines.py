"""Splines and NURBS: found from the points of LinuxCNC's module, and cut into the arcs of its control."""

from pathlib import Path

import numpy as np
import pytest
from scipy.interpolate import BSpline

from tests.compensation.test_via_linuxcnc import AT_ZERO, INSTALLED, PACKAGE
from tests.shop_programs.grade import grade
from trueaxis.compensation.linuxcnc.interpreter import unroll
from trueaxis.compensation.linuxcnc.splines import biarcs, curve_of, parameters_of
from trueaxis.io.faults import InputError

POINTS = np.array([[0.0, 0.0], [0.0, 30.0], [20.0, 45.0], [50.0, 20.0], [60.0, -10.0], [90.0, 5.0]])


def spline(points: np.ndarray, weights: np.ndarray, order: int) -> BSpline:
    """The clamped spline with knots at whole numbers, as weight x, weight y, weight."""
    spans = len(points) - order + 1
    knots = np.concatenate([np.zeros(order - 1), np.arange(spans + 1), np.full(order - 1, spans)]).astype(float)
    return BSpline(knots, np.column_stack([points * weights[:, None], weights]), order - 1)


def at(curve: BSpline, parameter: np.ndarray) -> np.ndarray:
    x, y, weight = curve(parameter).T
    return np.column_stack([x / weight, y / weight])


@pytest.mark.parametrize("order", [3, 4, 5, 6])
@pytest.mark.parametrize("weights", [np.ones(6), np.array([1.0, 2.0, 0.5, 1.0, 3.0, 1.0])])
def test_a_spline_is_found_from_its_points(order: int, weights: np.ndarray) -> None:
    """And the arcs touch it at the places, and in the directions, that its parameter says."""
    meant = spline(POINTS, weights, order)
    parameter = np.array([0.0, *parameters_of(6, order), 7.0 - order])
    others = np.array([[200.0, 3.0], [1.0, 2.0]])  # of motions that follow
    found, used = curve_of(np.concatenate([at(meant, parameter), others]), 6)
    assert (used, found.order) == (len(parameter), order)
    fine = np.linspace(0.0, 7.0 - order, 333)
    assert np.abs(found.at(fine) - at(meant, fine)).max() < 1e-8
    made = list(biarcs(found))
    joints = at(meant, np.linspace(0.0, 7.0 - order, 25))
    assert np.abs(np.array([end for end, _, _ in made[1::2]]) - joints[1:]).max() < 1e-8
    place = joints[0]
    for end, centre, turns in made:
        assert centre is not None
        assert np.hypot(*(place - centre)) == pytest.approx(np.hypot(*(np.array(end) - centre)), rel=1e-9)
        ends = np.array([place, end]) - np.array(centre)
        assert np.sign(ends[0, 0] * ends[1, 1] - ends[0, 1] * ends[1, 0]) == turns  # less than half a turn
        place = np.array(end)


def test_points_of_no_spline_are_refused() -> None:
    with pytest.raises(ValueError, match="not found from its points"):
        curve_of(np.random.default_rng(1).normal(size=(91, 2)), 6)


def test_straight_pieces_are_refused() -> None:
    """There LinuxCNC divides by the difference of two directions that are the same but for rounding."""
    straight = np.column_stack([np.linspace(0.0, 50.0, 61), np.linspace(0.0, 10.0, 61)])
    found, _ = curve_of(straight, 4)
    with pytest.raises(ValueError, match="straight piece"):
        list(biarcs(found))


PROGRAM = """\
{units} G90 G17 G64
T1 M6
G43 H1
G0 X0 Y0 Z5
G1 Z-1 F200
G5 I0 J{a} P-{b} Q-{a} X{b} Y{b}
G5 P{a} Q-{a} X{c} Y0
G5.1 X0 Y0 I-{b} J-{b}
G5.2 X{a} Y{a} P1 L4
X{b} Y0 P2
X{c} Y{b} P1
X{b} Y{c} P0.5
G5.3
G0 Z5
M2
"""


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
@pytest.mark.parametrize(
    ("units", "sizes"),
    [("G21", {"a": 20, "b": 30, "c": 70}), ("G20", {"a": 1, "b": 1.25, "c": 3})],
)
def test_splines_are_right_along_the_arcs_of_the_control(tmp_path: Path, units: str, sizes: dict[str, float]) -> None:
    program = tmp_path / "in.ngc"
    program.write_text(PROGRAM.format(units=units, **sizes))
    graded = grade(program, PACKAGE, tmp_path, via=True)
    assert graded.outcome == "accepted", graded
    assert graded.after < 0.0014
    assert graded.before > 0.01


@pytest.mark.skipif(not INSTALLED, reason="LinuxCNC is not installed")
def test_splines_from_an_unknown_start_are_refused(tmp_path: Path) -> None:
    program = tmp_path / "in.ngc"
    program.write_text("G21 G90\nF100\nG5 I0 J3 P0 Q-3 X1 Y1\nM2\n")
    with pytest.raises(InputError, match="where a spline goes depends on where the axes stand"):
        unroll(program, PACKAGE, AT_ZERO, None, "in")
