"""A set-up that contradicts itself is refused by every command that reads it, with what would be right."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from trueaxis.cli.main import main
from trueaxis.identification.believable_setup import setup_faults
from trueaxis.io.faults import Fault
from trueaxis.measurement.data import read_data
from trueaxis.model.model import load_model

ROOT = Path(__file__).parents[2]
MACHINE = str(ROOT / "machines" / "dmu60p.toml")
ERRORS = str(ROOT / "machines" / "dmu60p_errors.json")
KERNELS = ["--kernels", str(ROOT / "generated")]
BAR = """schema = 1
machine = "dmu60p"
[[run]]
id = "bar"
instrument = "ballbar"
length = {length}
target = {{ on = "tool", point = [0.0, 0.0, 0.0] }}
reference = {{ on = "workpiece", point = [270.0, {y}, 200.0] }}
"""
LASER = """schema = 1
machine = "dmu60p"
[[run]]
id = "line"
instrument = "laser"
direction = [1.0, 0.0, 0.0]
target = { on = "tool", point = [0.0, 0.0, 0.0] }
"""


def bar(folder: Path, *, y: float = -350.0, length: float = 200.0, reading: float = 0.001) -> Path:
    """A circle of 200 mm about (270, 350) of the axes; the workpiece rides on Y."""
    turn = np.linspace(0.0, 2.0 * np.pi, 40)
    at = zip(270.0 + 200.0 * np.cos(turn), 350.0 + 200.0 * np.sin(turn), strict=True)
    rows = [f"bar,{k},{a!r},{b!r},200,{reading!r}" for k, (a, b) in enumerate((float(a), float(b)) for a, b in at)]
    return written(folder, BAR.format(y=y, length=length), rows)


def line(folder: Path, size: float) -> Path:
    return written(folder, LASER, [f"line,{k},{20 * k},0,0,{size * k!r}" for k in range(20)])


def written(folder: Path, setup: str, rows: list[str]) -> Path:
    folder.mkdir()
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(["run,seq,X,Y,Z,reading", *rows]) + "\n")
    return folder


def test_a_ball_that_is_about_as_far_off_as_may_be_is_no_reading_in_another_unit(tmp_path: Path) -> None:
    """`up to 0.05 mm, where errors allow 10 mm at most; is the reading in mm?` was said of 16 runs."""
    model, faults = load_model(Path(MACHINE), None, ROOT / "generated"), []
    for number, off in enumerate(np.linspace(4.8, 6.0, 25).tolist()):
        folder = bar(tmp_path / str(number), y=-350.0 + off, reading=-0.05)
        faults += setup_faults(model, read_data(folder, model), folder)
    assert 5 < len(faults) < 25
    assert {one.place for one in faults} == {"run bar"}
    assert all("mm apart at" in one.problem for one in faults)


def commands(data: Path, out: Path) -> dict[str, list[str]]:
    errors = out / "zero.json"
    errors.write_text(json.dumps({"schema": 1, "machine": "dmu60p"}))
    return {
        "plan": ["plan", MACHINE, "--data", str(data), "--report", str(out / "plan.json")],
        "simulate": ["simulate", MACHINE, "--errors", ERRORS, "--data", str(data), "--out", str(out / "s")],
        "identify": ["identify", MACHINE, "--data", str(data), "--out", str(out / "e.json"), "--method", "global"],
        "diagnose": ["diagnose", MACHINE, "--errors", str(errors), "--data", str(data), "--out", str(out / "d")],
    }


@pytest.mark.parametrize("command", ["plan", "simulate", "identify", "diagnose"])
def test_a_ball_on_the_wrong_side_is_refused(tmp_path: Path, command: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The workpiece sees the ball at -Y: a centre hundreds of millimetres off gave coefficients of 1e43."""
    out = tmp_path / "out"
    out.mkdir()
    words = commands(bar(tmp_path / "data", y=350.0), out)[command]
    assert main([*words, *KERNELS]) == 2
    told = capsys.readouterr().err
    assert "the balls are 728.011 mm apart at the first position, not 200 mm" in told
    assert "would have to be at [270.0, -350.0, 200.0]" in told
    assert "does Y move the other way? (sense of axis Y in the spec)" in told
    assert [path.name for path in out.iterdir()] == ["zero.json"]


def test_another_length_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    out.mkdir()
    assert main([*commands(bar(tmp_path / "data", length=150.0), out)["identify"], *KERNELS]) == 2
    assert "is the length 199.999 mm?" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["plan", "identify"])
def test_readings_in_micrometres_are_refused(tmp_path: Path, command: str, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "out"
    out.mkdir()
    assert main([*commands(line(tmp_path / "data", 0.4), out)[command], *KERNELS]) == 2
    told = capsys.readouterr().err
    assert "is the reading in mm?" in told
    assert "run line, seq 2, 3, 4, 5, 6 and 13 more: up to 7.6 mm" in told


def test_good_set_ups_and_errors_of_a_tenth_of_a_millimetre_are_taken(tmp_path: Path) -> None:
    out = tmp_path / "out"
    out.mkdir()
    for number, data in enumerate((bar(tmp_path / "bar"), bar(tmp_path / "off", y=-348.0), line(tmp_path / "l", 5e-3))):
        assert main([*commands(data, out)["plan"], *KERNELS]) in (0, 1), number


def test_missing_dimensions_are_one_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Every run of a machine with rotary axes contradicts dimensions of zero: one cause, not one for each run."""
    machine = str(ROOT / "machines" / "dmu60p_5axis.toml")
    data = str(ROOT / "tests" / "planning" / "five_axis_runs")
    assert main(["plan", machine, "--data", data, "--report", str(tmp_path / "p.json"), *KERNELS]) == 2
    first, second = capsys.readouterr().err.strip().split("\n")
    assert "dimensions not given: q_Cx, q_Cy" in first
    assert "bar-xy, bar-xz, bar-yz" in first
    assert "--known" in first
    assert "run bar-xy: the balls are" in second


def bar_beside(folder: Path, z: float) -> Path:
    """A circle of 150 mm; the ball on the workpiece is said to be z above its plane."""
    turn = np.linspace(0.0, 2.0 * np.pi, 40)
    at = zip(270.0 + 150.0 * np.cos(turn), 350.0 + 150.0 * np.sin(turn), strict=True)
    rows = [f"bar,{k},{a!r},{b!r},200,0.001" for k, (a, b) in enumerate((float(a), float(b)) for a, b in at)]
    setup = BAR.format(y=-350.0, length=150.0).replace("200.0]", f"{200.0 + z}]")
    return written(folder, setup, rows)


@pytest.mark.parametrize("known", [None, 0.0])
def test_a_ball_off_along_the_axis_of_its_circle_has_likelier_causes_than_its_length(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], known: float | None
) -> None:
    out = tmp_path / "out"
    out.mkdir()
    words = [*commands(bar_beside(tmp_path / "data", 50.0), out)["identify"], *KERNELS]
    if known is not None:
        names = ["q_wx", "q_wy", "q_wz", "q_Tx", "q_Ty", "q_Tz"]
        values = {"schema": 1, "machine": "dmu60p", "parameters": dict.fromkeys(names, known)}
        (tmp_path / "known.json").write_text(json.dumps(values))
        words += ["--known", str(tmp_path / "known.json")]
    assert main(words) == 2
    told = capsys.readouterr().err
    assert "the balls are 158.114 mm apart at the first position, not 150 mm" in told
    taken = "given as" if known is not None else "not given, taken as"
    causes = [
        "likeliest first",
        f"dimension q_wz = -50 mm (--known; {taken} 0)",
        f"dimension q_Tz = 50 mm (--known; {taken} 0)",
        "the ball on the workpiece would have to be at [270.0, -350.0, 200.0] (key reference.point)",
        "is the length 158.113 mm? (key length)",
    ]
    places = [told.find(cause) for cause in causes]
    assert -1 not in places
    assert places == sorted(places)


def test_a_dimension_that_is_given_wrong_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The spec has the tool 80 mm too low: the circle across fits no other single cause but the ball."""
    out, data = tmp_path / "out", tmp_path / "data"
    out.mkdir()
    turn = np.linspace(0.0, 2.0 * np.pi, 40)
    at = zip(200.0 * np.cos(turn), 280.0 + 200.0 * np.sin(turn), strict=True)
    rows = [f"bar,{k},{270.0 + a!r},350,{b!r},0.001" for k, (a, b) in enumerate((float(a), float(b)) for a, b in at)]
    setup = BAR.format(y=-350.0, length=200.0)
    words = [*commands(written(data, setup, rows), out)["plan"], *KERNELS, "--known", str(tmp_path / "known.json")]
    values = {"schema": 1, "machine": "dmu60p", "parameters": {"q_Tz": 0.0, "q_wz": 0.0}}
    (tmp_path / "known.json").write_text(json.dumps(values))
    assert main(words) == 2
    told = capsys.readouterr().err
    assert "dimension q_Tz = -80 mm (--known; given as 0)" in told
    assert "the ball on the workpiece would have to be at [270.0, -350.0, 280.0]" in told
    assert "dimension q_Tx" not in told
    assert "is the length" not in told


def faults(data: Path) -> list[Fault]:
    model = load_model(Path(MACHINE), None, ROOT / "generated")
    zero = dict.fromkeys(model.dimensions, 0.0)
    return setup_faults(model.with_values(replace(model.errors, parameters=zero)), read_data(data, model), data)


def test_what_one_slip_explains_is_one_fault(tmp_path: Path) -> None:
    """A wrong sense was said once for each of 44 runs. The third bar has a slip of its own."""
    heads, rows = "", list[str]()
    for run, (y, low) in {"low": (350.0, 0.0), "high": (350.0, 90.0), "third": (-350.0, 0.0)}.items():
        turn = np.linspace(0.0, 2.0 * np.pi, 40)
        at = zip(270.0 + 200.0 * np.cos(turn), 350.0 + 200.0 * np.sin(turn), strict=True)
        rows += [f"{run},{k},{float(a)!r},{float(b)!r},{200.0 + low},0.001" for k, (a, b) in enumerate(at)]
        head = BAR.format(y=y, length=150.0 if run == "third" else 200.0).replace("200.0]", f"{200.0 + low}]")
        heads += "[[run]]" + head.split("[[run]]")[1].replace('"bar"', f'"{run}"')
    first, second = faults(written(tmp_path / "data", BAR.split("[[run]]", maxsplit=1)[0] + heads, rows))
    assert "2 runs contradict the machine, and none of them would if Y moved the other way" in first.problem
    assert first.remedy.startswith("sense of axis Y in the spec")
    assert first.remedy.endswith("the runs are low and high")
    assert (second.place, "is the length 199.999 mm?" in second.remedy) == ("run third", True)


def test_runs_whose_readings_are_all_too_large_are_one_fault(tmp_path: Path) -> None:
    data = line(tmp_path / "data", 0.4)
    setup, readings = data / "setup.toml", data / "readings.csv"
    head, run = setup.read_text().split("[[run]]")
    setup.write_text(f"{head}[[run]]{run}[[run]]{run.replace('line', 'again')}")
    table = readings.read_text()
    readings.write_text(table + table.split("\n", 1)[1].replace("line", "again"))
    (fault,) = faults(data)
    assert "run line, seq 2, 3, 4, 5, 6 and 13 more: up to 7.6 mm" in fault.problem
    assert fault.problem.endswith("likewise again")


def test_a_faulty_run_that_is_left_out_refuses_nothing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """--runs is how others are used until it is mended: it was refused with the run that it left out."""
    data = tmp_path / "data"
    bar(data, y=-250.0)
    both = LASER + BAR[BAR.index("[[run]]") :].format(y=-250.0, length=200.0)
    (data / "setup.toml").write_text(both)
    rows = [f"line,{k},{20 * k},0,0,{1e-4 * k!r}" for k in range(20)]
    (data / "readings.csv").write_text((data / "readings.csv").read_text() + "\n".join(rows) + "\n")
    words = ["identify", MACHINE, "--data", str(data), "--out", str(tmp_path / "e.json"), *KERNELS]
    assert main(words) == 2
    assert "run bar" in capsys.readouterr().err
    assert main([*words, "--runs", "line"]) == 0


WARM = "run,seq,X,Y,Z,reading,temperature_c\n"


@pytest.mark.parametrize(("warmer", "said"), [(3.0, True), (0.4, False)])
def test_runs_at_other_temperatures_are_told(
    tmp_path: Path, warmer: float, said: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    """Nothing in the model grows with temperature, and nothing was said of a second day that was 3 K warmer."""
    data = line(tmp_path / "data", 1e-4)
    (data / "setup.toml").write_text(LASER + LASER[LASER.index("[[run]]") :].replace("line", "again"))
    at = {"line": 20.0, "again": 20.0 + warmer}
    rows = [f"{run},{k},{20 * k},0,0,{1e-4 * k!r},{at[run]}" for run in at for k in range(20)]
    (data / "readings.csv").write_text(WARM + "\n".join(rows) + "\n")
    main(["identify", MACHINE, "--data", str(data), "--out", str(tmp_path / "e.json"), *KERNELS])
    shown = " ".join(capsys.readouterr().out.split())
    assert ("were taken at 20.0 degC (line) to 23.0 degC (again)" in shown) is said


def test_a_column_of_decimal_commas_is_one_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = line(tmp_path / "data", 1e-4)
    rows = [f'line,{k},{20 * k},0,0,"0,{k + 1}"' for k in range(20)]
    (data / "readings.csv").write_text("run,seq,X,Y,Z,reading\n" + "\n".join(rows) + "\n")
    assert main(["identify", MACHINE, "--data", str(data), "--out", str(tmp_path / "e.json"), *KERNELS]) == 2
    (said,) = capsys.readouterr().err.splitlines()
    assert '"0,1" has a decimal comma, and so have 19 more cells of the column' in said
