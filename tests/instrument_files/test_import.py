"""trueaxis import: what comes out of instrument files is what was read, and nothing else is claimed."""

import io
import re
import sys
import tomllib
from dataclasses import replace
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from tests.command_lines import ERRORS, KERNELS
from tests.instrument_files.writers import rtl
from tests.machines import DMU60P, machine_at
from tests.real_data import linear_axis_data
from trueaxis.cli.main import main
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.measurement.reading_geometry import ideal_displacement
from trueaxis.measurement.setup import Device, PointOn, Run, run_table
from trueaxis.model.model import load_model

DMU = machine_at(DMU60P)
LONG_AXIS = [0.0, 100.0, 200.0, 300.0, 400.0, 500.0]
SHAPE = np.array([0.0, 1.5, -2.25, 3.0, 0.5, 4.75])  # um


def imported(out: Path, *words: str | Path) -> MeasuredData:
    """The data folder that the command wrote."""
    code = main(["import", *map(str, words), "--machine", str(DMU60P), "--out", str(out), "--kernels", str(KERNELS)])
    assert code == 0
    return read_data(out, DMU)


def refused(out: Path, capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    """The faults of a command that must write nothing."""
    code = main(["import", *map(str, words), "--machine", str(DMU60P), "--out", str(out), "--kernels", str(KERNELS)])
    assert code == 2
    assert not out.exists()
    return capsys.readouterr().err


SIMULATED = """schema = 1
machine = "dmu60p"
[[run]]
id = "table-y"
instrument = "laser"
direction = [0.0, 1.0, 0.0]
target = { on = "workpiece", point = [45.0, -85.0, 64.0] }
home = { X = 30.0, Y = 0.0, Z = 20.0 }
[[run]]
id = "slide-x"
instrument = "laser"
direction = [1.0, 0.0, 0.0]
target = { on = "tool", point = [167.0, 30.0, -195.0] }
home = { X = 0.0, Y = 0.0, Z = 120.0 }
"""


def simulated(folder: Path) -> MeasuredData:
    """Two runs over five targets, there and back twice, on the paper's machine with its errors."""
    plan = folder / "plan"
    plan.mkdir()
    (plan / "setup.toml").write_text(SIMULATED)
    rows = ["run,seq,X,Y,Z,dir_X,dir_Y,reading"]
    for name, row in (("table-y", "30,{0},20,0,{1}"), ("slide-x", "{0},0,120,{1},0")):
        seq = 0
        for cycle in range(4):
            for at in sorted((0.0, 90.0, 210.0, 350.0, 505.0), reverse=cycle % 2 == 1):
                rows.append(f"{name},{(seq := seq + 1)},{row.format(at, 1 - 2 * (cycle % 2))},")
    (plan / "readings.csv").write_text("\n".join(rows) + "\n")
    words = ["simulate", DMU60P, "--errors", ERRORS, "--data", plan, "--out", folder / "known", "--kernels", KERNELS]
    assert main(list(map(str, words))) == 0
    return read_data(folder / "known", DMU)


def test_what_was_simulated_and_written_as_rtl_comes_back(tmp_path: Path) -> None:
    known = simulated(tmp_path)
    for index, (name, axis) in enumerate((("table-y", "Y"), ("slide-x", "X"))):
        rows = known.readings.of_run(index)
        at = known.readings.positions[DMU.axes.index(axis), rows].reshape(4, 5)
        values = np.take_along_axis(known.readings.reading[rows].reshape(4, 5), np.argsort(at), axis=1)
        text = rtl(np.sort(at[0]).tolist(), values * 1e3, axis=axis if axis == "X" else "")
        (tmp_path / f"{name}.rtl").write_bytes(text.encode())
    keys = ["table-y:axis=Y", "table-y:at.X=30", "at.Z=20", "target.point=45,-85,64"]
    keys += ["slide-x:target.point=167,30,-195", "slide-x:at.Y=0", "slide-x:at.Z=120"]
    data = imported(tmp_path / "data", tmp_path / "table-y.rtl", tmp_path / "slide-x.rtl", "--map", *keys)
    assert data.setup.runs == known.setup.runs
    assert data.readings.run_ids == known.readings.run_ids
    for name in ("run", "seq", "positions", "directions"):
        np.testing.assert_array_equal(getattr(data.readings, name), getattr(known.readings, name))
    np.testing.assert_allclose(data.readings.reading, known.readings.reading, atol=6e-10)  # six decimals of a um
    assert np.abs(known.readings.reading).max() > 1e-3
    assert data.setup.report["serial"] == "4711"


def test_setup_says_what_it_assumes_and_what_is_known(tmp_path: Path) -> None:
    (tmp_path / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    imported(tmp_path / "data", tmp_path / "x.rtl", "--map", "target.point=1,2,3", "at.Y=40", "at.Z=0", "home.Z=0")
    lines = (tmp_path / "data" / "setup.toml").read_text().splitlines()
    comments = {line.split(" = ")[0]: line.partition("# ")[2] for line in lines if " = " in line and line[0] != "#"}
    assert comments["direction"] == "assumed: by default"
    assert comments["target"] == "assumed: by default and given by the user"
    assert comments["home"] == "assumed: by default and given by the user"
    assert comments["id"] == comments["machine"] == ""
    assert "# assumed: at.Y = 40, given by the user" in lines
    assert not any("compensation" in line for line in lines)


def test_what_the_file_does_not_say_is_asked_for_all_at_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("one", "two"):
        (tmp_path / f"{name}.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    shown = refused(tmp_path / "out", capsys, tmp_path / "one.rtl", tmp_path / "two.rtl", "--map", "two:at.Z=5")
    assert re.findall(r"run (\w+): .*--map (\S+)=", shown) == [
        *(("one", key) for key in ("at.Y", "at.Z", "target.point")),
        *(("two", key) for key in ("at.Y", "target.point")),
    ]


def test_a_person_at_a_terminal_is_asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    for name in ("one", "two"):
        (tmp_path / f"{name}.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis]).encode())
    monkeypatch.setattr(sys, "stdin", Terminal("X\n70\n0\n1,2,3\n\n\n5\n\n"))
    monkeypatch.setattr(sys, "stderr", Terminal())
    data = imported(tmp_path / "data", tmp_path / "one.rtl", tmp_path / "two.rtl")
    assert [run.target.point for run in data.setup.runs] == [(1.0, 2.0, 3.0)] * 2
    assert [run.home for run in data.setup.runs] == [{"X": 0.0, "Y": 70.0, "Z": 0.0}, {"X": 0.0, "Y": 70.0, "Z": 5.0}]


def test_an_answer_that_is_wrong_is_asked_for_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Terminal(io.StringIO):
        def isatty(self) -> bool:
            return True

    (tmp_path / "one.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis]).encode())
    said = Terminal()
    monkeypatch.setattr(sys, "stdin", Terminal("Q\nX\n7o\n70\n0\n1,2\n1,2,3\n"))
    monkeypatch.setattr(sys, "stderr", said)
    data = imported(tmp_path / "data", tmp_path / "one.rtl")
    assert data.setup.runs[0].target.point == (1.0, 2.0, 3.0)
    assert data.setup.runs[0].home == {"X": 0.0, "Y": 70.0, "Z": 0.0}
    assert "--map" not in said.getvalue()
    assert re.findall('"(.*)" is not right', said.getvalue()) == ["Q", "7o", "1,2"]


def test_what_is_needed_in_any_case_is_told_with_the_first_question(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "one.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis]).encode())
    (tmp_path / "bar.csv").write_text("angle [deg];radius [mm]\n0;150\n90;150,001\n180;150\n")
    shown = refused(tmp_path / "out", capsys, tmp_path / "one.rtl", tmp_path / "bar.csv")
    assert re.findall(r"run (\w+): .*--map (\S+)=", shown) == [
        *(("one", key) for key in ("axis", "target.point")),
        *(("bar", key) for key in ("length", "plane", "at.X", "at.Y", "at.Z", "target.point")),
    ]


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        (("Run-count:2", "Run-count:4"), "has deviations of 2 runs, but Run-count is 4"),
        (("Target-count: 6", "Target-count: 7"), "has 6 targets, but Target-count is 7"),
        (("   2   3      -2.250000\r\n", ""), "1 deviations are missing, first that of run 2, target 3"),
        (("   2   3 ", "   1   3 "), "run 1, target 3 is given already in line"),
        (("   2   3 ", "   2   8 "), "there is no target 8; 1 to 6"),
        (("-2.250000", "-2.2.5"), "is not a deviation; run, target, deviation in um"),
        (("100.000000", "1oo"), 'target "1oo" is not a number'),
        (("DEVIATIONS::", "deviations"), "there is no section DEVIATIONS::"),
        (("500.000000", "560.000000"), "X = 560 is outside the travel; from 0.0 to 540.0"),
    ],
)
def test_a_faulty_rtl_file_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], change: tuple[str, str], fault: str
) -> None:
    text = rtl(LONG_AXIS, np.vstack([SHAPE, SHAPE]), axis="X")
    assert change[0] in text
    (tmp_path / "x.rtl").write_bytes(text.replace(*change).encode())
    told = refused(tmp_path / "out", capsys, tmp_path / "x.rtl", "--map", "target.point=0,0,0", "at.Y=0", "at.Z=0")
    assert fault in told
    assert f"{tmp_path / 'x.rtl'}: " in told


@pytest.mark.parametrize(
    "change",
    [
        ("::", ":: "),
        ("\r\n", "\n"),
        ("DEVIATIONS::", "Deviations::"),
        ("HEADER::", "Header::"),
        ("Run-count:1", "Run-count : 1"),
        ("Targets :\r\n", "Targets: "),
        ("-2.250000", "-2,250000"),
        ("-2.250000", "-2.25E+00"),
        ("   1   3      ", "1\t3\t"),
    ],
)
def test_an_rtl_file_of_another_writer(tmp_path: Path, change: tuple[str, str]) -> None:
    text = rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X")
    assert change[0] in text
    (tmp_path / "x.rtl").write_bytes(text.replace(*change).encode())
    data = imported(tmp_path / "data", tmp_path / "x.rtl", "--map", "target.point=0,0,0", "at.Y=0", "at.Z=0")
    np.testing.assert_allclose(data.readings.positions[0], LONG_AXIS)
    np.testing.assert_allclose(data.readings.reading, SHAPE * 1e-3)


def test_headers_in_chinese_are_read(tmp_path: Path) -> None:
    text = rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X", machine="机床")
    (tmp_path / "x.rtl").write_bytes(text.encode("gbk"))
    data = imported(tmp_path / "data", tmp_path / "x.rtl", "--map", "target.point=0,0,0", "at.Y=0", "at.Z=0")
    assert data.setup.report["machine"] == "机床"


CSV_VARIANTS = {
    "comma": "Target [mm],Error [um]\n0,0\n100.5,1.5\n200,-2.25\n",
    "semicolon and decimal commas": "Target [mm];Error [um]\n0;0\n100,5;1,5\n200;-2,25\n",
    "tabs, DIN heads": "Target/mm\tError/µm\n0\t0\n100,5\t1,5\n200\t-2,25\n",
    "a line of units": "Report of 3 points\n\nTarget;Error\n[mm];[mm]\n0;0\n100.5;0.0015\n200;-0.00225\n",
    "measured positions": "target_mm;measured_mm\n0;0\n100.5;100.5015\n200;199.99775\n",
    "spaces": "target_mm error_um\n0 0\n100.5 1.5\n200 -2.25\n",
    "metres and a separator at the end": "Position [m];Deviation [nm];\n0;0;\n0,1005;1500;\n0,2;-2250;\n",
}


@pytest.mark.parametrize("encoding", ["utf-8", "cp1252", "utf-16"])
def test_a_micro_sign_is_read_in_any_encoding(tmp_path: Path, encoding: str) -> None:
    """A German table in cp1252 was taken for Chinese: `unit "祄" is none of its reading`."""
    (tmp_path / "x.txt").write_bytes(
        "Prüfer: Jörg\nTarget [mm];Error [µm]\n0;0\n100,5;1,5\n200;-2,25\n".encode(encoding)
    )
    words = ("--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0")
    data = imported(tmp_path / "data", tmp_path / "x.txt", *words)
    np.testing.assert_allclose(data.readings.reading, [0.0, 1.5e-3, -2.25e-3])


@pytest.mark.parametrize("text", CSV_VARIANTS.values(), ids=CSV_VARIANTS)
def test_tables_of_any_separator_decimals_and_units(tmp_path: Path, text: str) -> None:
    (tmp_path / "x.txt").write_text(text)
    words = ["--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    data = imported(tmp_path / "data", tmp_path / "x.txt", *words)
    np.testing.assert_allclose(data.readings.positions[0], [0.0, 100.5, 200.0], atol=1e-12)
    np.testing.assert_allclose(data.readings.reading, [0.0, 0.0015, -0.00225], atol=1e-13)


def test_a_table_with_axis_columns_and_runs(tmp_path: Path) -> None:
    rows = ["run,X [mm],Y [mm],Z [mm],Time [s],Temperature [°C],Abweichung"]
    rows += ["a,10,0,5,0,20.5,0", "a,20,30,5,7,20.5,1.25", "b,10,30,5,9,20.6,0", "b,10,30,75,11,20.7,-3"]
    (tmp_path / "both.csv").write_text("\n".join(rows))
    words = ["--map", "column.reading=Abweichung", "unit.reading=um", "direction=1,1,0", "b:direction=0,0,1"]
    data = imported(tmp_path / "data", tmp_path / "both.csv", *words, "target.point=0,0,0", "b:target=tool")
    assert [run.id for run in data.setup.runs] == ["a", "b"]
    setup = (tmp_path / "data" / "setup.toml").read_text()
    assert setup.count("# assumed: column.reading = Abweichung, given by the user\n") == 2
    assert setup.count("# assumed: unit.reading = um, given by the user\n") == 2
    assert data.setup.runs[0].direction == pytest.approx((0.5**0.5, 0.5**0.5, 0.0))
    np.testing.assert_allclose(data.readings.reading, [0, 1.25e-3, 0, -3e-3])
    assert data.readings.time is not None
    assert data.readings.time.tolist() == [0.0, 7.0, 9.0, 11.0]
    assert data.readings.temperature is not None
    assert data.readings.temperature.tolist() == [20.5, 20.5, 20.6, 20.7]


@pytest.mark.parametrize("first", [1, -1])
def test_directions_along_a_diagonal_are_those_of_its_axes(tmp_path: Path, first: int) -> None:
    """The turn-round target is read again from beyond it: no order of rows says so. Y falls where X grows; whether the
    shop calls that forward is its own affair."""
    there = [(0, 300), (100, 200), (200, 100), (300, 0)]
    rows = [(*at, 1) for at in there] + [(*at, -1) for at in reversed(there)]
    text = "X [mm];Y [mm];Deviation [um];Direction\n" + "".join(f"{x};{y};0;{way * first}\n" for x, y, way in rows)
    (tmp_path / "d.csv").write_text(text)
    data = imported(tmp_path / "data", tmp_path / "d.csv", "--map", "at.Z=5", "target.point=0,0,0", "direction=1,-1,0")
    np.testing.assert_array_equal(data.readings.directions[0], [1] * 4 + [-1] * 4)
    np.testing.assert_array_equal(data.readings.directions[1], [-1] * 4 + [1] * 4)
    assert not data.readings.directions[2].any()


@pytest.mark.parametrize(("axis", "carried"), [("X", "tool"), ("Y", "workpiece")])
@pytest.mark.parametrize("other_way_round", [False, True])
def test_readings_count_as_commands_whatever_end_the_target_is(
    tmp_path: Path, axis: str, carried: str, other_way_round: bool
) -> None:
    """A retroreflector in the spindle, seen from the table: the table goes away from it, and the sign was reversed."""
    (tmp_path / "line.csv").write_text(f"{axis} [mm],deviation [um]\n0,0\n100,1\n200,3\n")
    ends = ["target", "reference"] if not other_way_round else ["reference", "target"]
    still = {"tool": "workpiece", "workpiece": "tool"}[carried]
    words = [f"{ends[0]}={carried}", f"{ends[1]}={still}", "target.point=0,0,-80", "reference.point=10,20,30"]
    rest = [f"at.{name}=100" for name in "XYZ" if name != axis]
    data = imported(tmp_path / "data", tmp_path / "line.csv", "--map", *words, *rest)
    (run,) = data.setup.runs
    home = np.array([[run.home[name]] for name in "XYZ"])
    model = load_model(DMU60P, None, KERNELS)
    along = np.array(run.direction) @ ideal_displacement(model, run, data.readings.positions, home)
    np.testing.assert_allclose(along, [0.0, 100.0, 200.0], atol=1e-9)


def test_the_ball_stands_where_the_dimensions_of_the_machine_have_it(tmp_path: Path) -> None:
    (tmp_path / "circle.csv").write_text(BAR)
    words = ["--map", "length=150", "plane=XY", "at.X=270", "at.Y=350", "at.Z=150", "target.point=0,0,-20"]
    known = tmp_path / "known.json"
    known.write_text(
        '{"schema": 1, "machine": "dmu60p", "parameters": {"q_wx": 3.0, "q_Tz": 7.0}, "motion_errors": {}}'
    )
    without = imported(tmp_path / "a", tmp_path / "circle.csv", *words)
    given = imported(tmp_path / "b", tmp_path / "circle.csv", *words, "--known", known)
    off = np.subtract(given.setup.runs[0].reference.point, without.setup.runs[0].reference.point)
    np.testing.assert_allclose(off, [-3.0, 0.0, 7.0], atol=1e-9)
    said = "q_wx, q_wy, q_wz, q_Tx, q_Ty, q_Tz of the spec taken as 0 (--known gives them)"
    assert said in (tmp_path / "a" / "setup.toml").read_text()
    assert "q_wx" not in (tmp_path / "b" / "setup.toml").read_text()


def test_a_reading_without_unit_is_not_guessed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.csv").write_text("target [mm];error\n0;0\n10;1\n")
    words = ["--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    told = refused(tmp_path / "out", capsys, tmp_path / "x.csv", *words)
    assert told.count("\n") == 1
    assert "the file does not say the unit of its column error; --map unit.reading=um" in told


@pytest.mark.parametrize(("own", "said"), [("mm", "um"), ("um", "mm")])
def test_a_unit_that_contradicts_the_file_is_a_fault(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], own: str, said: str
) -> None:
    (tmp_path / "x.csv").write_text(f"target [mm];error [{own}]\n0;0\n10;1e-3\n")
    words = ["--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    told = refused(tmp_path / "out", capsys, tmp_path / "x.csv", *words, f"unit.reading={said}")
    assert f"the file's own unit, {own}" in told
    imported(tmp_path / "data", tmp_path / "x.csv", *words, f"unit.reading={own}")


def test_a_constant_that_is_no_deviation_is_taken_off_and_told(tmp_path: Path) -> None:
    (tmp_path / "x.csv").write_text("target_mm;error_um\n0;40\n100;43\n200;45\n200;46\n100;44\n0;42\n")
    words: list[str | Path] = [tmp_path / "x.csv", "--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    data = imported(tmp_path / "mean", *words)
    np.testing.assert_allclose(data.readings.reading, np.array([-1, 2, 4, 5, 3, 1]) * 1e-3, atol=1e-15)
    np.testing.assert_array_equal(data.readings.directions[0], [1, 1, 1, -1, -1, -1])
    assert "mean of the 2 readings at home, 41 um, was taken off" in (tmp_path / "mean" / "setup.toml").read_text()
    kept = imported(tmp_path / "keep", *words, "zero=keep")
    np.testing.assert_allclose(kept.readings.reading, data.readings.reading + 0.041, atol=1e-15)


BAR = "Angle [deg];Deviation [µm];Feed [mm/min]\n" + "".join(f"{a};{(a % 7) - 3};1000\n" for a in range(0, 361, 15))


def test_a_ball_bar_lies_where_its_circle_does(tmp_path: Path) -> None:
    (tmp_path / "circle.csv").write_text(BAR)
    words = ["--map", "length=150", "plane=XY", "at.X=270", "at.Y=350", "at.Z=150", "target.point=0,0,-20"]
    data = imported(tmp_path / "data", tmp_path / "circle.csv", *words)
    (run,) = data.setup.runs
    assert (run.instrument, run.length) == ("ballbar", 150.0)
    at = data.readings.positions
    np.testing.assert_allclose(np.hypot(at[0] - 270, at[1] - 350), 150.0)
    np.testing.assert_allclose(at[:, 6], [270, 500, 150], atol=1e-9)  # 90 deg: Y+ of the commanded positions
    assert data.readings.feed is not None
    # the ball on the workpiece is where simulate has the nominal length everywhere
    zero = tmp_path / "zero.json"
    zero.write_text('{"schema": 1, "machine": "dmu60p", "parameters": {}, "motion_errors": {}}')
    options = ["--errors", zero, "--data", tmp_path / "data", "--out", tmp_path / "again", "--kernels", KERNELS]
    assert main(list(map(str, ["simulate", DMU60P, *options, "--replace"]))) == 0
    np.testing.assert_allclose(read_data(tmp_path / "again", DMU).readings.reading, 0.0, atol=1e-9)


def test_what_was_simulated_and_written_as_a_ball_bar_comes_back(tmp_path: Path) -> None:
    (tmp_path / "circle.csv").write_text(BAR)
    words = ["--map", "length=150", "plane=ZX", "at.X=270", "at.Y=350", "at.Z=250", "target.point=0,0,-20"]
    imported(tmp_path / "plan", tmp_path / "circle.csv", *words)
    options = ["--errors", ERRORS, "--data", tmp_path / "plan", "--out", tmp_path / "known", "--kernels", KERNELS]
    assert main(list(map(str, ["simulate", DMU60P, *options, "--replace"]))) == 0
    known = read_data(tmp_path / "known", DMU).readings
    z, x = known.positions[2] - 250.0, known.positions[0] - 270.0
    angles = np.degrees(np.unwrap(np.arctan2(x, z)))  # from Z to X
    rows = [f"{angle:.10f}\t{value * 1e3:.7f}\t1000" for angle, value in zip(angles, known.reading, strict=True)]
    (tmp_path / "circle.csv").write_text("\n".join(["theta [deg]\terror [um]\tfeed", *rows]))
    again = imported(tmp_path / "again", tmp_path / "circle.csv", *words)
    assert again.setup.runs == read_data(tmp_path / "known", DMU).setup.runs
    np.testing.assert_allclose(again.readings.positions, known.positions, atol=1e-8)
    np.testing.assert_allclose(again.readings.reading, known.reading, atol=1e-10)
    assert np.abs(known.reading).max() > 1e-3


def test_a_ball_bar_with_its_whole_length(tmp_path: Path) -> None:
    rows = ["X;Y;Radius [mm]", "420;350;150.0021", "270;500;149.9979", "120;350;150"]
    (tmp_path / "circle.csv").write_text("\n".join(rows))
    words = ["--map", "length=150", "at.Z=150", "target.point=0,0,0", "reference.point=270,-350,150"]
    data = imported(tmp_path / "data", tmp_path / "circle.csv", *words)
    np.testing.assert_allclose(data.readings.reading, [0.0021, -0.0021, 0.0], atol=1e-12)


def test_an_unknown_key_and_an_unknown_file_are_faults(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    words = ["--map", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    assert "at.C: is no key" in refused(tmp_path / "out", capsys, tmp_path / "x.rtl", *words, "at.C=1")
    (tmp_path / "letter.txt").write_text("Dear all,\nnothing was measured.\n")
    (tmp_path / "empty.rtl").write_bytes(b"")
    told = refused(tmp_path / "out", capsys, tmp_path / "letter.txt", tmp_path / "empty.rtl", *words)
    assert "letter.txt: is of no known format: neither .rtl nor a positioning test nor columns of numbers" in told
    assert "empty.rtl: is empty" in told


def test_values_that_are_wrong_are_told_together(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    words = ["--map", "target.point=0,0", "at.Y=zero", "at.Z=0", "direction=0,0,0", "frame=lab"]
    told = refused(tmp_path / "out", capsys, tmp_path / "x.rtl", *words)
    for key in ("target.point", "at.Y", "direction", "frame"):
        assert f"run x, {key}: " in told


ANGLES = """schema = 1
machine = "dmu60p"
[[run]]
id = "yaw"
instrument = "angle"
direction = [0.0, 0.0, 1.0]
target = { on = "tool", point = [0.0, 0.0, 0.0] }
home = { X = 0.0, Y = 40.0, Z = 120.0 }
"""


@pytest.mark.parametrize(
    ("unit", "per_rad"), [("", 1.0), ("mrad", 1e3), ("urad", 1e6), ("arcsec", 3600.0 * 180.0 / np.pi)]
)
def test_angles_simulated_and_written_as_rta_come_back(tmp_path: Path, unit: str, per_rad: float) -> None:
    plan = tmp_path / "plan"
    plan.mkdir()
    (plan / "setup.toml").write_text(ANGLES)
    cycles = [sorted(LONG_AXIS, reverse=cycle % 2 == 1) for cycle in range(4)]
    rows = [f"yaw,{k + 1},{at},40,120," for k, at in enumerate(at for cycle in cycles for at in cycle)]
    (plan / "readings.csv").write_text("\n".join(["run,seq,X,Y,Z,reading", *rows]) + "\n")
    words = ["simulate", DMU60P, "--errors", ERRORS, "--data", plan, "--out", tmp_path / "known", "--kernels", KERNELS]
    assert main([*map(str, words), "--noise-urad", "2"]) == 0
    known = read_data(tmp_path / "known", DMU)
    values = known.readings.reading.reshape(4, -1) / ARM
    values[1::2] = values[1::2, ::-1]
    text = rtl(LONG_AXIS, values * per_rad, axis="X", digits=12)
    (tmp_path / "yaw.rta").write_bytes(text.encode())
    keys = ["direction=0,0,1", "at.Y=40", "at.Z=120", *([f"unit.reading={unit}"] if unit else []), "zero=keep"]
    data = imported(tmp_path / "data", tmp_path / "yaw.rta", "--map", *keys)
    assert data.setup.runs == known.setup.runs
    np.testing.assert_allclose(data.readings.reading, known.readings.reading, atol=1e-9)
    assert np.abs(known.readings.reading).max() > 1e-3
    assert f"unit.reading = {unit or 'rad'}" in (tmp_path / "data" / "setup.toml").read_text()


def test_angles_ask_about_which_axis_and_milliradians_are_not_taken_for_radians(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.rta").write_bytes(rtl(LONG_AXIS, 1e-2 * SHAPE[np.newaxis], axis="X").encode())
    told = refused(tmp_path / "out", capsys, tmp_path / "x.rta", "--map", "at.Y=0", "at.Z=0")
    assert "--map unit.reading=mrad" in told
    assert "0.0475 rad" in told
    told = refused(tmp_path / "out", capsys, tmp_path / "x.rta", "--map", "at.Y=0", "at.Z=0", "unit.reading=mrad")
    assert "--map direction=0,0,1" in told
    assert "target.point" not in told


def test_a_table_of_pitch_and_yaw_is_a_run_of_each(tmp_path: Path) -> None:
    """Simulated, written as an autocollimator's table in two units, and read again."""
    plan, of_pitch = tmp_path / "plan", ANGLES.replace("yaw", "level-pitch").replace("0.0, 0.0, 1.0", "0.0, 1.0, 0.0")
    plan.mkdir()
    (plan / "setup.toml").write_text(of_pitch + ANGLES[ANGLES.index("[[run]]") :].replace("yaw", "level-yaw"))
    ats = [*sorted(LONG_AXIS), *sorted(LONG_AXIS, reverse=True)]
    rows = [f"level-{name},{k + 1},{at},40,120," for name in ("pitch", "yaw") for k, at in enumerate(ats)]
    (plan / "readings.csv").write_text("\n".join(["run,seq,X,Y,Z,reading", *rows]) + "\n")
    words = ["simulate", DMU60P, "--errors", ERRORS, "--data", plan, "--out", tmp_path / "known", "--kernels", KERNELS]
    assert main(list(map(str, words))) == 0
    known = read_data(tmp_path / "known", DMU)
    per_arcsec, per_um_m = ARM * np.pi / 180.0 / 3600.0, ARM * 1e-6
    both = known.readings.reading.reshape(2, -1)
    angles = zip(ats, both[0] / per_arcsec, both[1] / per_um_m, strict=True)
    lines = [f"{at:g};{pitch:.9f};{yaw:.9f}".replace(".", ",") for at, pitch, yaw in angles]
    (tmp_path / "level.csv").write_text("\n".join(["Level 7", "Position [mm];Pitch [arcsec];Yaw (µm/m)", *lines]))
    keys = ["axis=X", "at.Y=40", "at.Z=120", "level-pitch:direction=0,1,0", "level-yaw:direction=0,0,1", "zero=keep"]
    data = imported(tmp_path / "data", tmp_path / "level.csv", "--map", *keys)
    assert data.setup.runs == known.setup.runs
    np.testing.assert_allclose(data.readings.reading, known.readings.reading, atol=1e-9)
    assert np.abs(both).max(axis=1).min() > 1e-3
    alone = ["--map", *keys[:3], "direction=0,0,1", "column.reading=Yaw (µm/m)"]
    (run,) = imported(tmp_path / "one", tmp_path / "level.csv", *alone).setup.runs
    assert (run.id, run.instrument) == ("level", "angle")


@pytest.mark.parametrize(
    ("head", "value", "urad"),
    [
        ("slope [mm/m]", 0.012, 12.0),
        ("error [urad]", 12.0, 12.0),
        ("angle [arcsec]", 3.6, 3.6 * np.pi / 0.648),
        ("deviation_mrad", 0.012, 12.0),
        ("measured [deg]", 90.001, np.pi / 0.18),
    ],
)
def test_a_column_in_a_unit_of_angles_is_of_an_angle_instrument(
    tmp_path: Path, head: str, value: float, urad: float
) -> None:
    measured = "measured" in head
    first, unit = (0.0, "deg") if measured else (0, "mm")
    (tmp_path / "a.csv").write_text(f"target [{unit}],{head}\n0,{first}\n90,{value}\n")
    spec = DMU60P.with_stem("dmu60p_5axis") if measured else DMU60P
    keys = ["axis=C", "at.X=0", "at.Z=0", "at.B=0"] if measured else ["axis=X", "at.Z=120", "direction=0,1,0"]
    out = tmp_path / "data"
    words = ["import", tmp_path / "a.csv", "--machine", spec, "--out", out, "--map", *keys, "at.Y=0"]
    assert main(list(map(str, words))) == 0
    data = read_data(out, machine_at(spec))
    assert data.setup.runs[0].instrument == "angle"
    np.testing.assert_allclose(data.readings.reading, [0.0, urad * 1e-6 * ARM], atol=1e-9)


def test_angles_and_lengths_are_not_mixed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.csv").write_text("target [mm],measured [deg]\n0,0\n90,90.001\n")
    (tmp_path / "b.csv").write_text("target [mm],pitch\n0,0\n90,3\n")
    (tmp_path / "c.csv").write_text("target [mm],pitch [um]\n0,0\n90,3\n")
    words = ["--map", "axis=X", "at.Y=40", "at.Z=120"]
    assert "are lengths and angles" in refused(tmp_path / "out", capsys, tmp_path / "a.csv", *words)
    told = refused(tmp_path / "out", capsys, tmp_path / "b.csv", *words)
    assert "--map unit.reading=urad" in told
    assert "target.point" not in told
    assert 'unit "um" is none of its reading; deg, rad,' in refused(
        tmp_path / "out", capsys, tmp_path / "c.csv", *words
    )


def test_files_of_one_name_get_ids_of_their_own(tmp_path: Path) -> None:
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    words = ["--map", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    data = imported(tmp_path / "data", tmp_path / "a" / "x.rtl", tmp_path / "b" / "x.rtl", *words)
    assert [run.id for run in data.setup.runs] == ["x", "x-2"]


def test_odd_names_of_runs_read_back(tmp_path: Path) -> None:
    table = 'run;target [mm];error [um]\na "b" \\ c;0;0\na "b" \\ c;10;1\n'
    (tmp_path / "x.csv").write_text(table.replace('a "b" \\ c', '"a ""b"" \\ c"'))
    words = ["--map", "axis=X", "target.point=0,0,0", "at.Y=0", "at.Z=0"]
    data = imported(tmp_path / "data", tmp_path / "x.csv", *words)
    assert data.setup.runs[0].id == 'a "b" \\ c'
    run = Run(
        id="é\u202e",
        instrument="probe",
        target=PointOn("tool"),
        reference=PointOn("bed"),
        frame="bed",
        home={"X": 0.1},
        direction=(0.0, 0.0, 1.0),
    )
    assert "\u202e" not in run_table(run)
    table = tomllib.loads(run_table(replace(run, device=Device(id="XL"), session="monday")))["run"][0]
    assert (table["device"], table["session"]) == ("XL", "monday")


@pytest.mark.skipif(not linear_axis_data.FILE.exists(), reason="the measured files are not here")
def test_a_real_positioning_test(tmp_path: Path) -> None:
    words = [linear_axis_data.FILE, "--machine", linear_axis_data.SPEC, "--out", tmp_path / "data"]
    assert main(list(map(str, ["import", *words, "--map", "axis=X", "target.point=0,0,0", "home.X=0"]))) == 0
    machine = machine_at(linear_axis_data.SPEC)
    ours = read_data(tmp_path / "data", machine)
    known = read_data(linear_axis_data.write(tmp_path / "known", clock=False).data, machine)
    np.testing.assert_array_equal(ours.readings.positions, known.readings.positions)
    np.testing.assert_array_equal(ours.readings.directions, known.readings.directions)
    np.testing.assert_array_equal(ours.readings.reading, known.readings.reading)


def test_the_readings_file_has_no_columns_that_nobody_measured(tmp_path: Path) -> None:
    (tmp_path / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    imported(tmp_path / "data", tmp_path / "x.rtl", "--map", "target.point=0,0,0", "at.Y=0", "at.Z=0")
    assert pl.read_csv(tmp_path / "data" / "readings.csv").columns == ["run", "seq", "X", "Y", "Z", "dir_X", "reading"]


def test_a_key_that_is_none_is_told_with_what_else_is_missing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "x.rtl").write_bytes(rtl(LONG_AXIS, SHAPE[np.newaxis], axis="X").encode())
    keys = ["target.pont=0,0,0", "at.Y=0", "x:colour=red"]
    told = refused(tmp_path / "out", capsys, tmp_path / "x.rtl", "--map", *keys)
    assert "--map: target.pont: is no key; did you mean target.point?" in told
    assert "--map: x:colour: is no key; known: id, instrument, axis" in told
    assert "--map at.Z=" in told
