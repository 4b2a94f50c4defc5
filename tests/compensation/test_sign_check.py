"""The point of the sign check, against a machine of matrices."""

import json

import numpy as np
import pytest

from tests.compensation.analytic_machine import XyzMachine, paper_sized
from tests.compensation.control import Bench, execute
from tests.compensation.five_axes import TEXTS, FiveAxes, constant
from tests.machines import machine_of
from trueaxis.compensation.offsets import Offsets
from trueaxis.machine.topology import tool_senses

ORIGIN = np.zeros((3, 1))


def test_it_is_where_a_gauge_moves_most(bench: Bench) -> None:
    points = np.round(np.random.default_rng(5).uniform(-400, 400, (40, 3)), 3)
    program = "G21 G90\n" + "".join(f"G0 X{x:.3f} Y{y:.3f} Z{z:.3f}\n" for x, y, z in points)
    machine = paper_sized()
    at = execute(bench.run(program, machine))
    since = machine.deviation(points.T, ORIGIN) - machine.deviation(ORIGIN, ORIGIN)
    direction, index = np.unravel_index(np.argmax(np.abs(since)), since.shape)
    check = bench.report.sign_check
    assert check is not None
    assert (check.line, check.direction, check.axis) == (int(index) + 2, "XYZ"[direction], "XYZ"[direction])
    assert check.since_home == pytest.approx(since[direction, index])
    assert check.deviation == pytest.approx(machine.deviation(points.T, ORIGIN)[direction, index])
    assert check.command == pytest.approx(at[direction, index])
    # the command undoes what the gauge shows: in X and Z against it, in Y, which moves the table, with it
    moved = check.command - check.position[check.axis]
    assert bench.report.senses.towards == {"X": "X+", "Y": "Y-", "Z": "Z+"}
    assert check.correction == pytest.approx(-moved if check.axis == "Y" else moved)
    assert check.correction == pytest.approx(-check.deviation, abs=0.0006)
    assert check.at_home == pytest.approx(machine.deviation(ORIGIN, ORIGIN)[direction, 0])
    assert json.loads(bench.report.to_json())["sign_check"]["since_home"] == check.since_home


def test_it_is_at_the_end_of_a_block(bench: Bench) -> None:
    """Within an arc or a cut line the error may be larger, and no block has words to go there."""
    bump = XyzMachine({"EXX": lambda x: 0.02 * np.exp(-(((x - 50.0) / 30.0) ** 2))})
    program = "G21 G90\nG0 X0. Y0. Z0.\nG1 X100. F500\nX10.\nG2 X90. Y0. I40. J0.\n"
    for arcs in ("keep", "chords"):
        bench.run(program, bump, arcs=arcs)
        check = bench.report.sign_check
        assert check is not None
        assert check.position["X"] in (10.0, 90.0)
    narrow = XyzMachine({"EXX": lambda x: 0.02 * np.exp(-(((x - 50.0) / 15.0) ** 2))})  # the ends have no error
    bench.run(program, narrow)
    assert bench.report.sign_check is not None
    assert bench.report.sign_check.position["X"] == pytest.approx(50.0, abs=5.0)


def test_it_is_where_no_rotary_axis_is_turned_if_a_gauge_shows_enough_there(bench: Bench) -> None:
    """Along a table that stands turned nobody sets a gauge easily."""
    machine = FiveAxes(TEXTS["table-table"]).model
    faces = [(0.0, "X100. Y50. Z20."), (90.0, "X-200. Y240. Z-180.")]
    for order in (faces, faces[::-1]):
        cuts = "".join(f"G0 X0. Y0. Z0. A0. C{turned}\nG1 {there} F500\n" for turned, there in order)
        bench.run(f"G21 G90 G94\n{cuts}", machine)
        check = bench.report.sign_check
        assert check is not None
        assert (check.position["A"], check.position["C"]) == (0.0, 0.0)
        assert abs(check.since_home) > 0.005
    bench.run("G21 G90 G94\nG0 X0. Y0. Z0. A0. C90.\nG1 X-200. Y240. Z-180. F500\n", machine)
    assert bench.report.sign_check is not None
    assert bench.report.sign_check.position["C"] == 90.0


def test_the_words_of_a_table_that_moves(bench: Bench) -> None:
    text = bench.run("G21 G90\nG0 X0. Y0. Z0.\nY200.\n", XyzMachine({"EYY": lambda y: -6e-5 * y}))
    # the table goes 12 um too little to Y+, so the tool stands 12 um too far to Y+ of the workpiece; Y+ takes it to Y-
    assert text.endswith(b"Y200.012\n")
    shown = bench.told
    assert "along Y of the workpiece frame, to zero at home (X0 Y0 Z0) and go to X0 Y200 Z0 (line 3), " in shown
    assert "it must show +0.0120 mm (above 0: the tool stands too far towards Y+ of the workpiece).\n" in shown
    assert "which commands Y200.012 (+0.0120 mm), it must show +0.0000 mm.\n" in shown


@pytest.mark.parametrize("turn", ["C90.", "C-90."])
def test_what_errs_at_home_too_does_not_contradict_itself(bench: Bench, turn: str) -> None:
    """Errors that are the same everywhere show in the workpiece frame once the table turns."""
    machine = constant(TEXTS["table-table"], {"EXX": 0.15, "EYY": 0.1})
    bench.run(f"G21 G90\nG0 X270. Y20. Z30. A0. C0.\n{turn}\n", machine)
    check = bench.report.sign_check
    assert check is not None
    assert abs(check.since_home) == pytest.approx(0.25, abs=1e-3)
    assert abs(check.at_home) > 0.09
    assert check.since_home == pytest.approx(check.deviation - check.at_home)
    assert check.correction + check.at_home == pytest.approx(-check.since_home, abs=0.001)
    shown = bench.told
    # set to zero without compensation, it shows of the compensated program what home itself is off by
    assert check.compensated == pytest.approx(-check.at_home, abs=0.001)
    assert f"Without compensation it must show {check.since_home:+.4f} mm" in shown
    assert f"it must show {check.compensated:+.4f} mm (not zero, as home itself is not corrected).\n" in shown
    assert check.axis != check.direction  # C turns the table a quarter
    assert f"; {check.axis} moves the tool along {check.direction} there)" in shown


@pytest.mark.parametrize("name", ["table-table", "head and table"])
def test_the_correction_of_five_axes_takes_back_the_reading(bench: Bench, name: str) -> None:
    machine = FiveAxes(TEXTS[name], seed=11)
    blocks = [
        " ".join(f"{axis}{value:.3f}" for axis, value in zip(machine.model.axes, column, strict=True))
        for column in machine.programmed(12).T
    ]
    bench.run("G21 G90\nG0 " + "\n".join(blocks) + "\n", machine.model, orientation="correct")
    check = bench.report.sign_check
    assert check is not None
    assert check.correction + check.at_home == pytest.approx(-check.since_home, abs=0.003)


def test_every_report_says_which_way_each_axis_moves_the_tool(bench: Bench) -> None:
    """A table axis without `sense = -1` may show in no reading: here there is no sign check at all."""
    bench.run("G21 G90\nG0 X1. Y1. Z1.\n")
    assert bench.report.sign_check is None
    assert (
        "the model takes it that X+ commands move the tool to X+ of the workpiece, "
        "Y+ commands to Y- (as where the table moves to Y+), Z+ commands to Z+. "
        "If that is not so on the machine, `sense` in the spec is wrong: do not run the program."
    ) in bench.told
    assert json.loads(bench.report.to_json())["senses"]["towards"] == {"X": "X+", "Y": "Y-", "Z": "Z+"}


@pytest.mark.parametrize(
    ("name", "senses"),
    [
        ("table-table", {"X": "X+", "Y": "Y-", "Z": "Z+"}),
        ("all reversed", {"X": "X-", "Y": "Y+", "Z": "Z-"}),
    ],
)
def test_the_senses_follow_the_spec(bench: Bench, name: str, senses: dict[str, str]) -> None:
    model = constant(TEXTS[name], {})
    bench.run(f"G21 G90\nG0 {' '.join(f'{axis}10.' for axis in model.axes)}\n", model)
    assert bench.report.senses.towards == senses
    rotary = " ".join(f"{axis}0" for axis in model.axes if axis not in "XYZ")
    assert f"the model takes it that at {rotary} X+ commands move" in bench.told


@pytest.mark.parametrize("name", ["table-table", "head-head", "head and table", "all reversed"])
def test_the_way_rotary_axes_turn_the_tool_follows_the_spec(bench: Bench, name: str) -> None:
    """The tool turns with an axis on its own side, and against one on that of the workpiece."""
    model = constant(TEXTS[name], {})
    bench.run(f"G21 G90\nG0 {' '.join(f'{axis}10.' for axis in model.axes)}\n", model)
    wanted = {
        axis: f"{'XYZ'['ABC'.index(axis)]}{'+' if sense > 0 else '-'}"
        for axis, sense in tool_senses(machine_of(TEXTS[name])).items()
        if axis in "ABC"
    }
    assert wanted
    assert bench.report.senses.about == wanted
    assert all(f"{axis}+ turns it from " in bench.told for axis in wanted)


def test_it_is_left_out_where_nothing_is_to_be_seen(bench: Bench) -> None:
    bench.run("G21 G90\nG0 X1. Y1. Z1.\n")
    assert bench.report.sign_check is None
    bench.run("G21 G90\nG0 X1. Y1. Z1.\n", XyzMachine({"EXX": lambda x: 0.01 + 0.0 * x}))
    assert bench.report.sign_check is None  # the same at home: a gauge set to zero there shows nothing


def test_its_positions_are_said_to_be_those_of_the_machine(bench: Bench) -> None:
    """Typed under the program's own G54, G43 or G20 they would lead elsewhere."""
    offsets = Offsets({"G54": {axis: (value, value) for axis, value in zip("XYZ", (100.0, 50.0, 0.0), strict=True)}})
    program = "G20 G90 G54 G17\nG0 X1. Y1. Z1.\nX5.\n"
    bench.run(program, XyzMachine({"EXX": lambda x: 6e-5 * x}), offsets=offsets)
    assert (
        "go to X227 Y75.4 Z25.4 (line 3), in machine coordinates, mm: no work offset and no tool length" in bench.told
    )
    bench.run("G21 G90\nG0 X90. Y20. Z30. A0. C0.\nC90.\n", constant(TEXTS["table-table"], {"EXX": 0.15}))
    assert ", in machine coordinates, mm and deg: " in bench.told
