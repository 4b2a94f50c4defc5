"""Programs with rotary words through the whole command, on checked-in kernels, judged by chains in forty digits."""

import json
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.compensation.analytic_machine import FloatArray
from tests.compensation.control import Bench, execute
from tests.compensation.five_axes import TEXTS, FiveAxes, constant
from tests.compensation.test_command import ROOT, command
from tests.machines import serial_text
from trueaxis.io.faults import InputError
from trueaxis.model.model import load_model

TRUNNION = ROOT / "machines" / "trunnion_mill.toml"
PROGRAM = """\
%
G21 G90 G94 G17
G0 X250. Y220. Z200. A-40. C30. (above the part)
G1 Z150. F2000
X260. Y225. Z152. A-45. C90.
A-60.
G91 X5. C-12.5
G90 G3 X265. Y235. I0. J5. F1500
M30
%
"""
TOOL = np.array([[0.0], [0.0], [-120.0]])
AXES = "XYZAC"


def trunnion_errors(folder: Path, **others: float) -> Path:
    names = ["EXX", "EZX", "EBX", "EYY", "EAY", "EZZ", "EAZ", "EXA", "EBA", "EYC", "EAC", "EBC", "ECC"]
    random = np.random.default_rng(2)
    curves: dict[str, Any] = {}
    for name in names:
        scale = 2e-5 if name[1] in "XYZ" else 1e-7
        curves[name] = {"basis": "polynomial", "powers": [1, 2], "coefficients": [scale * random.uniform(-1, 1), 1e-10]}
    parameters = {"q_Ax": 250.0, "q_Ay": 225.0, "q_Az": 40.0, "q_Cz": -60.0, "q_wz": 10.0, "EB0C": 3e-5, "EA0Z": -2e-5}
    path = folder / "errors.json"
    path.write_text(
        json.dumps(
            {"schema": 1, "machine": "trunnion_mill", "parameters": parameters | others, "motion_errors": curves}
        )
    )
    return path


def trunnion(folder: Path, text: str, *options: str) -> tuple[int, dict[str, Any]]:
    errors, report = trunnion_errors(folder), folder / "report.json"
    (folder / "in.nc").write_text(text)
    more = ["--errors", str(errors), "--tool-point", "0,0,-120", "--report", str(report), *options]
    code = command(folder, None, *more, machine=TRUNNION)
    return code, json.loads(report.read_text())


def angles(folder: Path, commands: FloatArray, programmed: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Distance (mm) and angle (rad) by an evaluation of the model of its own."""
    model = load_model(TRUNNION, folder / "errors.json", ROOT / "generated", backend="numpy")
    axis = np.array([[0.0], [0.0], [1.0]])
    actual = model.ideal(commands, TOOL) + model.deviation(commands, TOOL)
    tool = model.ideal(commands, TOOL + axis) + model.deviation(commands, TOOL + axis) - actual
    wanted = model.ideal(programmed, TOOL)
    ideal = model.ideal(programmed, TOOL + axis) - wanted
    turn = np.linalg.norm(tool / np.linalg.norm(tool, axis=0) - ideal, axis=0)
    return np.linalg.norm(actual - wanted, axis=0), turn


STRAIGHT = PROGRAM.replace("G90 G3 X265. Y235. I0. J5. F1500", "G90 X265. Y235.")
WANTED = np.array(
    [
        [250.0, 220.0, 200.0, -40.0, 30.0], [250.0, 220.0, 150.0, -40.0, 30.0], [260.0, 225.0, 152.0, -45.0, 90.0],
        [260.0, 225.0, 152.0, -60.0, 90.0], [265.0, 225.0, 152.0, -60.0, 77.5], [265.0, 235.0, 152.0, -60.0, 77.5],
    ]
).T  # fmt: skip


def ends(folder: Path) -> FloatArray:
    """Executed positions that are nearest to the programmed ends, one for each."""
    at = execute((folder / "out.nc").read_bytes(), AXES)
    return np.array([at[:, np.argmin(np.abs(at - p[:, None]).max(axis=0))] for p in WANTED.T]).T


def test_keep_leaves_the_rotary_words_and_puts_the_point_right(tmp_path: Path) -> None:
    code, report = trunnion(tmp_path, STRAIGHT)
    assert code == 0
    at = ends(tmp_path)
    assert at[3:] == pytest.approx(WANTED[3:], abs=1e-9)
    point, turn = angles(tmp_path, at, WANTED)
    assert point.max() < 0.0009
    before = angles(tmp_path, WANTED, WANTED)[1]
    assert turn == pytest.approx(before, abs=1e-8)
    assert report["orientation"]["before"]["largest"] >= 1e6 * before.max() * 0.999
    assert report["orientation"]["after"]["mean"] == pytest.approx(report["orientation"]["before"]["mean"], rel=1e-3)
    assert report["over_orientation"]["points"] == report["singular"]["points"] == 0


def test_correct_turns_the_rotary_words_and_moves_the_slides_for_them(tmp_path: Path) -> None:
    code, report = trunnion(tmp_path, STRAIGHT, "--orientation", "correct")
    assert code == 0
    at = ends(tmp_path)
    point, turn = angles(tmp_path, at, WANTED)
    assert point.max() < 0.0009
    assert turn.max() < 1.3e-6  # half a step of 0.0001 deg in two axes
    assert angles(tmp_path, WANTED, WANTED)[1].min() > 1e-5
    assert np.abs(at - WANTED)[3:].max() < 0.05
    assert report["orientation"]["solved"]["largest"] < 0.02
    assert report["orientation"]["after"]["largest"] < 1.3
    assert report["orientation"]["along"]["largest"] < 1.3 + 0.5  # and what subdivision allows in between


def test_finer_rotary_words_leave_less(tmp_path: Path) -> None:
    options = ["--orientation", "correct", "--rotary-resolution", "0.00001", "--orientation-tolerance-urad", "0.2"]
    code, report = trunnion(tmp_path, PROGRAM, *options)
    assert code == 0
    assert report["orientation"]["after"]["largest"] < 0.13


def test_a_tolerance_below_the_words_is_not_met_and_said_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    code, report = trunnion(tmp_path, PROGRAM, "--orientation", "correct", "--orientation-tolerance-urad", "0.1")
    assert code == 1
    assert report["over_orientation"]["points"] > 0
    assert "above 0.1 urad" in capsys.readouterr().out


def test_singular_poses_are_told_with_their_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    text = "G0 X250. Y220. Z200. A-40. C30.\nA0.\nX255.\nA-0.3\nA-20.\n"
    code, report = trunnion(tmp_path, text, "--orientation", "correct")
    assert report["singular"] == {"points": 3, "first": [2, 3, 4]}
    assert report["not_converged"]["points"] == 0
    assert report["after"]["largest"] < 0.0009
    at = execute((tmp_path / "out.nc").read_bytes(), AXES)
    assert at[4, 1:3] == pytest.approx([30.0, 30.0])
    assert np.abs(at[4] - 30.0).max() < 0.5
    assert code == (1 if report["over_orientation"]["points"] else 0)
    told = capsys.readouterr().out
    assert "one direction of the tool axis not corrected (no fault between rapids): 3 points, lines 2, 3, 4" in told


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("A0.\nX255.\nA-20.\n", []),  # nothing is cut there
        ("A0.\nG1 X255. F500\nG0 A-20.\n", [2, 3]),  # the cut begins and ends at the pose
        ("A-20.\nG1 A0. F500\nG0 A-20.\n", [3]),
        ("A0.\nG1 A-20. F500\n", [2, 3]),
        ("A-20.\nA0.\nM30\n", []),
    ],
)
@pytest.mark.parametrize("points", [1, 16384])
def test_a_singular_pose_matters_where_something_is_cut(bench: Bench, text: str, lines: list[int], points: int) -> None:
    """A rapid to A0 alone made the exit code 1; points: in batches of as many."""
    model = FiveAxes(TEXTS["table-table"]).model
    bench.run(f"G0 X10. Y20. Z30. A-40. C30.\n{text}", model, orientation="correct", batch_points=points)
    assert bench.report.singular.points > 0
    assert list(bench.report.over_orientation.first) == lines
    assert bench.report.good == (not lines)


def test_incremental_and_absolute_rotary_words_agree(bench: Bench) -> None:
    model = FiveAxes(TEXTS["head and table"]).model
    random = np.random.default_rng(4)
    points = np.concatenate([random.uniform(0, 100, (3, 20)), random.uniform(-50, 50, (2, 20))]).round(3)

    def program(rows: FloatArray, head: str) -> str:
        words = [" ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZBC", row, strict=True)) for row in rows.T]
        return f"G90 G0 {words[0]}\n{head}" + "".join(f"{word}\n" for word in words[1:])

    steps = np.concatenate([points[:, :1], np.diff(points, axis=1)], axis=1)
    absolute = execute(bench.run(program(points, ""), model, orientation="correct"), "XYZBC")
    incremental = execute(bench.run(program(steps, "G91\n"), model, orientation="correct"), "XYZBC")
    assert incremental == pytest.approx(absolute, abs=1e-6)


def test_increments_from_a_start_between_words_are_made_up_by_the_slides(bench: Bench) -> None:
    machine = FiveAxes(TEXTS["table-table"])
    start = {"X": 10.0, "Y": 20.0, "Z": 30.0, "A": -20.00005, "C": 40.0}
    settings: dict[str, Any] = {"start": start, "orientation": "correct", "resolution": 0.00001}
    text = bench.run("G91 G0 X5. Y0. Z0. A-10. C0.\n", machine.model, **settings)
    at = execute(text, AXES, list(start.values()))
    point, axis = machine.off(at, np.array([[15.0], [20.0], [30.0], [-30.00005], [40.0]]), np.zeros((3, 1)))
    assert point.max() < 0.00001  # half a word of A, 0.9 urad at an arm of 100 mm, would be ten times that
    assert axis.max() < 1.3e-6


def test_lines_are_cut_where_the_turns_bend(bench: Bench) -> None:
    # C wobbles by 40 urad twice a turn; A = -60 deg makes that a tilt of 35 urad of the tool axis
    model = FiveAxes(TEXTS["table-table"]).model
    text = "G0 X10. Y20. Z30. A-60. C-80.\nG1 C80. F500\n"
    kept = execute(bench.run(text, model), AXES)
    turned = execute(bench.run(text, model, orientation="correct"), AXES)
    assert bench.report.orientation is not None
    assert bench.report.orientation.along is not None
    assert bench.report.orientation.along.largest < 1.3 + 0.5
    assert turned.shape[1] > kept.shape[1]
    assert any("some controls then read its F" in note for note in bench.report.warnings)


def test_a_machine_that_cannot_turn_the_tool_says_so(bench: Bench) -> None:
    four = constant(serial_text("YA", "XZ"), {"EAA": 30e-6, "EBX": 40e-6})
    bench.run("G0 X10. Y20. Z30. A10.\n", four, orientation="correct")
    assert any("one rotary axis" in note for note in bench.report.notes)
    assert bench.report.orientation is not None
    assert bench.report.orientation.after is not None
    assert bench.report.orientation.after.largest == pytest.approx(40.0, abs=1.0)
    assert bench.report.over_orientation.points == 1
    assert not bench.report.good
    bench.run("G0 X10. Y20. Z30.\n", orientation="correct")
    assert any("no rotary axis" in note for note in bench.report.notes)
    assert bench.report.orientation is None
    assert bench.report.good


def test_short_blocks_keep_the_point_while_rotary_axes_turn(bench: Bench) -> None:
    machine = FiveAxes(TEXTS["head-head"])
    lines = "".join(f"X{x}. B{30 + 0.1 * x:.1f}\n" for x in range(1, 40))
    still = "".join(f"X{x}.\n" for x in range(40, 80))
    text = f"G0 X0. Y0. Z0. B30. C20.\nG1 F900\n{lines}{still}"
    options: dict[str, Any] = {"words": "middles", "ball": (0.0, 0.0, 500.0), "orientation": "correct"}
    bench.run(text, machine.model, **options)
    assert bench.report.good
    assert bench.report.after is not None
    assert bench.report.after.largest <= 0.001
    bench.run(text, machine.model, words="middles", ball=(0.0, 0.0, 500.0))
    assert 30 < bench.report.short_blocks <= 41  # none where B turns: it would be there before the slides


def test_a_cl_file_must_be_told_where_rotary_axes_stand(bench: Bench) -> None:
    model = FiveAxes(TEXTS["table-table"]).model
    text = "FROM/0,0,100\nGOTO/10,0,0\nFINI\n"
    with pytest.raises(InputError, match=r"does not say where A C stands; give it by --start A0C0"):
        bench.run(text, model, language="apt")
    bench.run(text, model, language="apt", start={"A": -30.0, "C": 10.0})
    assert bench.report.good


@pytest.mark.parametrize(
    "settings",
    [{"tool_axis": (0.0, 0.0, 0.0)}, {"orientation_tolerance_urad": 0.0}, {"tool_axis": (0.0, float("nan"), 1.0)}],
)
def test_settings_out_of_range(bench: Bench, settings: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"tool_axis|orientation_tolerance_urad"):
        bench.run("G0 X1.\n", **settings)


def test_another_tool_axis(bench: Bench) -> None:
    # an angle head: along X of the tool frame A turns nothing, so that C alone is left, and every pose is singular
    machine = FiveAxes(TEXTS["table-table"])
    bench.run("G0 X10. Y20. Z30. A-40. C10.\n", machine.model, orientation="correct", tool_axis=(2.0, 0.0, 0.0))
    assert bench.report.singular.first == (1,)
    bench.run("G0 X10. Y20. Z30. A-40. C10.\n", machine.model, orientation="correct", tool_axis=(0.0, 0.5, 0.5))
    assert bench.report.singular.points == 0
    assert bench.report.good


VALUES = st.one_of(st.none(), st.integers(-3000, 3000), st.just(0))
BLOCKS = st.lists(
    st.tuples(
        st.sampled_from(["G0", "G1", "G91 G1", "G90 G1", "G91 G20 G1", "G90 G21 G0", ""]), st.tuples(*[VALUES] * 5)
    ),
    min_size=1,
    max_size=8,
)


@settings(max_examples=40, deadline=None)
@given(BLOCKS, st.sampled_from(["head-head", "table-table", "all reversed"]), st.sampled_from(["keep", "correct"]))
def test_any_program_ends_with_the_tool_where_it_belongs(
    blocks: list[tuple[str, tuple[int | None, ...]]], name: str, orientation: str
) -> None:
    machine = FiveAxes(TEXTS[name])
    axes = machine.model.axes
    lines = ["G90 G21 G0 " + " ".join(f"{axis}0.0" for axis in axes)]
    for code, values in blocks:
        # words of up to 1 inch and 9 deg, so that poses near and at the singular one are frequent
        scale = [3000.0 if axis in "XYZ" else 333.0 for axis in axes]
        words = [f"{a}{v / s:.3f}" for a, v, s in zip(axes, values, scale, strict=True) if v is not None]
        lines.append(" ".join([code, *words]).strip())
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(Path(folder))
        text = bench.run("\n".join(lines), machine.model, orientation=orientation, words="nearest")
    wanted = execute("\n".join(lines).encode(), axes)[:, -1:]
    got = execute(text, axes)[:, -1:]
    point, axis = machine.off(got, wanted, np.zeros((3, 1)))
    assert bench.report.not_converged.points == 0
    assert point[0] < 0.0009
    tilt = np.sin(np.radians(wanted[3, 0]))
    if orientation == "keep":
        assert got[3:] == pytest.approx(wanted[3:], abs=5.1e-5)
    elif abs(tilt) > 0.0101:
        assert axis[0] < 1.3e-6
    else:
        assert bench.report.singular.points > 0
        assert np.abs(got - wanted)[3:].max() < 2.0
