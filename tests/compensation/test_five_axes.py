"""Compensation with rotary axes, judged by chains of matrices in forty digits."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import FloatArray
from tests.compensation.five_axes import TEXTS, FiveAxes, constant
from tests.machines import serial_text
from trueaxis.compensation.solve import SINGULAR, PoseSolution, ToolAxis, angle, solve, solve_pose
from trueaxis.model.model import MachineModel

TOOL = np.array([[4.0], [-3.0], [-120.0]])
ALONG_Z = (0.0, 0.0, 1.0)
URAD = 1e-6


@cache
def machine_of(name: str) -> FiveAxes:
    return FiveAxes(TEXTS[name])


def posed(model: MachineModel, programmed: FloatArray, tool_point: FloatArray = TOOL) -> PoseSolution:
    return solve_pose(programmed, model, tool_point, ToolAxis(model, ALONG_Z), 1e-8, 1e-11)


@pytest.mark.parametrize("name", TEXTS)
def test_tool_point_and_tool_axis_get_where_they_belong(name: str) -> None:
    machine = machine_of(name)
    programmed = machine.programmed(25)
    found = posed(machine.model, programmed)
    assert not found.singular.any()
    assert found.converged.all()
    before_point, before_axis = machine.off(programmed, programmed, TOOL)
    assert before_point.min() > 0.005
    assert before_axis.min() > 5 * URAD
    point, axis = machine.off(found.commands, programmed, TOOL)
    assert point.max() < 1e-9
    assert axis.max() < 1e-12
    moved = np.abs(found.commands - programmed)
    assert moved[3:].max() < 0.2  # deg: errors of 100 urad do not turn an axis far
    assert found.steps.max() <= 5


@pytest.mark.parametrize("name", TEXTS)
def test_linear_axes_alone_leave_the_rotary_ones_and_put_the_point_right(name: str) -> None:
    machine = machine_of(name)
    programmed = machine.programmed(10)
    found = solve(programmed, programmed, machine.model, TOOL, 1e-8)
    assert (found.commands[3:] == programmed[3:]).all()
    point, axis = machine.off(found.commands, programmed, TOOL)
    _, before = machine.off(programmed, programmed, TOOL)
    assert point.max() < 1e-9
    assert axis == pytest.approx(before, abs=0.1 * URAD)  # errors change by that much over the few um that slides move


@given(
    st.sampled_from(sorted(TEXTS)),
    st.lists(st.floats(-200.0, 300.0), min_size=3, max_size=3),
    st.lists(st.floats(-160.0, 160.0), min_size=2, max_size=2),
    st.lists(st.floats(-100.0, 100.0), min_size=3, max_size=3),
)
@settings(max_examples=60, deadline=None)
def test_any_pose(name: str, linear: list[float], rotary: list[float], tool: list[float]) -> None:
    machine, tool_point = machine_of(name), np.array(tool)[:, None]
    programmed = np.array([*linear, *rotary])[:, None]
    found = posed(machine.model, programmed, tool_point)
    assert np.isfinite(found.commands).all()
    assert found.converged.all()
    point, axis = machine.off(found.commands, programmed, tool_point)
    _, before = machine.off(programmed, programmed, tool_point)
    assert point.max() < 1e-9
    if found.singular.any():
        assert axis.max() < before.max() * 1.01 + 0.1 * URAD  # no worse than it was
    else:
        assert axis.max() < 1e-12
    turned = np.radians(np.abs(found.commands - programmed)[3:]).max()
    assert turned <= 2.0 * before.max() / SINGULAR


@pytest.mark.parametrize("name", TEXTS)
def test_a_machine_without_errors_keeps_its_commands(name: str) -> None:
    machine = FiveAxes(TEXTS[name], size=0.0)
    programmed = machine.programmed(50)
    found = posed(machine.model, programmed)
    assert np.abs(found.commands - programmed).max() < 1e-11
    assert found.steps.max() == 0


@pytest.mark.parametrize("name", ["head-head", "table-table"])
def test_at_a_singular_pose_one_axis_keeps_and_the_other_corrects(name: str) -> None:
    # B (head-head) or A (table-table) at 0: C turns about the tool axis, and the tilting axis, row 3, tilts the tool in
    # one plane of the workpiece frame, across e: (-sin C, cos C, 0) under the head, (cos C, -sin C, 0) on the table
    machine = machine_of(name)
    programmed = machine.programmed(40)
    programmed[3] = 0.0
    found = posed(machine.model, programmed)
    assert found.singular.all()
    assert found.converged.all()
    moved = np.abs(found.commands - programmed)
    assert moved[3].min() > 1e-5
    assert moved[4].max() < 1e-12
    point, axis = machine.off(found.commands, programmed, TOOL)
    assert point.max() < 1e-9  # the point is put right all the same
    c = np.radians(programmed[4])
    lost = np.array([-np.sin(c), np.cos(c)] if name == "head-head" else [np.cos(c), -np.sin(c)])
    before = np.array([[float(v) for v in machine.pose_of(p, TOOL)[1]] for p in programmed.T]).T[:2]
    assert axis == pytest.approx(np.abs((lost * before).sum(axis=0)), abs=0.1 * URAD)


def test_turns_do_not_jump_on_the_way_through_a_singular_pose() -> None:
    machine = machine_of("head-head")
    programmed = np.repeat(np.array([[10.0], [20.0], [30.0], [0.0], [15.0]]), 4001, axis=1)
    programmed[3] = np.linspace(-2.0, 2.0, 4001)
    found = posed(machine.model, programmed)
    assert found.converged.all()
    turn = found.commands[4] - programmed[4]
    assert np.abs(turn).max() > 0.05
    assert np.abs(turn).max() < np.degrees(2e-4 / SINGULAR)
    assert np.abs(np.diff(turn)).max() < 0.005  # deg, per 0.001 deg of B
    tilt = np.abs(np.radians(programmed[3]))
    assert (found.singular == (np.sin(tilt) < SINGULAR)).all()
    assert np.abs(turn[2000]) < 1e-12


def test_the_jacobian_is_the_derivative() -> None:
    # against turns of the error-free tool axis worked out by hand: n = Rz(C) Ry(B) e_z on a fork head
    axis = ToolAxis(machine_of("head-head").model, ALONG_Z)
    b, c = np.radians(37.0), np.radians(-112.0)
    at = np.array([[1.0], [2.0], [3.0], [37.0], [-112.0]])
    by_b = [np.cos(c) * np.cos(b), np.sin(c) * np.cos(b), -np.sin(b)]
    by_c = [-np.sin(c) * np.sin(b), np.cos(c) * np.sin(b), 0.0]
    assert axis.jacobian(at)[:, :, 0] == pytest.approx(np.array([by_b, by_c]).T, abs=1e-15)


@pytest.mark.parametrize(("sense", "sign"), [(1, -1.0), (-1, 1.0)])
def test_a_table_that_turns_too_far_is_turned_back(sense: int, sign: float) -> None:
    # the body turns by sense * A + EAA: to undo EAA, A changes by -sense * EAA, and no other axis moves
    text = serial_text("YAC", "XZ", A={"sense": sense})
    model = constant(text, {"EAA": 100 * URAD})
    programmed = np.array([[50.0], [60.0], [70.0], [-40.0], [25.0]])
    found = posed(model, programmed)
    expected = programmed + np.array([[0.0], [0.0], [0.0], [sign * np.degrees(100 * URAD)], [0.0]])
    assert found.commands == pytest.approx(expected, abs=1e-6)  # to the square of the error


def test_a_small_rotation_is_no_longer_tool_axis() -> None:
    # the matrix of EAA = 0.01 takes (0, 0, 1) to (0, -+0.01, 1): an angle of atan(0.01)
    model = constant(serial_text("YAC", "XZ"), {"EAA": 0.01})
    at = np.array([[50.0], [60.0], [70.0], [-40.0], [25.0]])
    axis = ToolAxis(model, ALONG_Z)
    assert angle(axis.actual(at), axis.wanted(at)) == pytest.approx([np.arctan(0.01)], rel=1e-9)


def test_one_rotary_axis_corrects_what_it_can() -> None:
    text = serial_text("YA", "XZ")
    model = constant(text, {"EAA": 30 * URAD, "EBX": 40 * URAD})
    programmed = np.array([[50.0], [60.0], [70.0], [0.0]])
    tool_axis = ToolAxis(model, ALONG_Z)
    found = solve_pose(programmed, model, TOOL, tool_axis, 1e-8, 1e-11)
    assert found.converged.all()
    assert not found.singular.any()
    left = angle(tool_axis.actual(found.commands), tool_axis.wanted(programmed))
    assert left == pytest.approx([40 * URAD], rel=1e-4)  # the turn about Y stays, that about X is gone
    assert found.commands[3, 0] == pytest.approx(-np.degrees(30 * URAD), rel=1e-3)


def test_three_rotary_axes_share_the_turn() -> None:
    machine = FiveAxes(serial_text("YC", "XZAB"))
    programmed = np.concatenate([machine.programmed(8), [[10.0, -20.0, 30.0, 40.0, -50.0, 60.0, 70.0, 5.0]]])
    found = posed(machine.model, programmed)
    point, axis = machine.off(found.commands, programmed, TOOL)
    assert point.max() < 1e-9
    assert axis.max() < 1e-12


def test_large_errors_converge_or_say_so() -> None:
    machine = FiveAxes(TEXTS["table-table"], size=50.0)
    programmed = machine.programmed(30)
    found = posed(machine.model, programmed)
    assert found.converged.any()
    point, axis = machine.off(found.commands[:, found.converged], programmed[:, found.converged], TOOL)
    assert point.max() < 1e-9
    assert axis.max() < 1e-12


def test_what_is_not_finite_stays_where_it_is() -> None:
    model = constant(TEXTS["table-table"], {"EAA": 1e-5, "EXX": float("nan")})
    programmed = np.array([[50.0], [60.0], [70.0], [-40.0], [25.0]])
    found = posed(model, programmed)
    assert not found.converged.any()
    assert (found.commands == programmed).all()


def test_once_is_the_first_correction() -> None:
    machine = machine_of("head and table")
    programmed = machine.programmed(10)
    tool_axis = ToolAxis(machine.model, ALONG_Z)
    found = solve_pose(programmed, machine.model, TOOL, tool_axis, 1e-8, 1e-11, "ordinary")
    assert (found.steps == 1).all()
    point, axis = machine.off(found.commands, programmed, TOOL)
    assert 1e-12 < axis.max() < 0.1 * URAD
    assert 1e-9 < point.max() < 1e-3
