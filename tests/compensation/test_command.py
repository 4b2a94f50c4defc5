"""`trueaxis compensate` on the paper's machine: exit codes, the report, and what is left alone."""

import argparse
import json
from pathlib import Path

import numpy as np
import pytest

from tests.compensation.control import execute
from tests.compensation.extended_model import TEXT
from trueaxis.cli import compensate
from trueaxis.codegen.render import render
from trueaxis.derivation.model import derive_model
from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files
from trueaxis.machine import read_machine
from trueaxis.model.model import load_model

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "dmu60p.toml"
ERRORS = ROOT / "machines" / "dmu60p_errors.json"
PROGRAM = "%\nG21 G90\nG0 X420. Y350. Z100.\nG1 F1000\nG2 X420. Y350. I-150. J0.\nM30\n%\n"


def command(folder: Path, text: str | None, *options: str, machine: Path = MACHINE) -> int:
    parser = argparse.ArgumentParser()
    compensate.add_parser(parser.add_subparsers())
    if text is not None:
        (folder / "in.nc").write_text(text)
    arguments = ["compensate", str(machine), "--errors", str(ERRORS), str(folder / "in.nc")]
    arguments += ["--out", str(folder / "out.nc"), "--kernels", str(ROOT / "generated"), *options]
    args = parser.parse_args(arguments)
    return int(args.run(args))


def test_the_circle_is_round_on_the_erroneous_machine(tmp_path: Path) -> None:
    assert command(tmp_path, PROGRAM, "--arcs", "chords") == 0
    model = load_model(MACHINE, ERRORS, ROOT / "generated")
    point = np.zeros((3, 1))
    centre = model.ideal(np.array([[270.0], [350.0], [100.0]]), point)

    def roundness(at: np.ndarray) -> float:
        tool = model.ideal(at, point) + model.deviation(at, point)
        radius = np.linalg.norm((tool - centre)[:2], axis=0)
        return float(radius.max() - radius.min())

    turn = np.linspace(0.0, 2 * np.pi, 500)
    plain = np.stack([270 + 150 * np.cos(turn), 350 + 150 * np.sin(turn), 100 + 0 * turn])
    at = execute((tmp_path / "out.nc").read_bytes())
    assert roundness(plain) > 0.004
    assert roundness(at) < 0.0015


def test_report_is_readable_and_machine_readable(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    report = tmp_path / "report.json"
    options = ["--ball", "270,-350,0", "--words", "middles", "--report", str(report), "--method", "iterative"]
    assert command(tmp_path, PROGRAM, *options) == 0
    shown = capsys.readouterr().out
    for words in ("7 blocks read", "as written", "Eq. (6)", "passed in short blocks"):
        assert words in shown
    found = json.loads(report.read_text())
    assert found["schema"] == 1
    assert found["good"] is True
    assert found["moves"] == 2
    assert sum(found["iterations"]) == found["points"]
    assert found["after"]["largest"] <= 0.001
    assert found["ball"]["after"]["mean"] < 0.0001 < found["ball"]["before"]["mean"]
    assert found["settings"]["ball"] == [270.0, -350.0, 0.0]


def test_exit_one_where_the_answer_is_no(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command(tmp_path, PROGRAM, "--resolution", "0.01") == 1
    assert "above tolerance" in capsys.readouterr().out
    assert (tmp_path / "out.nc").exists()


def test_a_command_beyond_the_travel_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    low = load_model(MACHINE, ERRORS, ROOT / "generated").travel
    corners = "".join(f"X{x:g}. Y{y:g}. Z{z:g}.\n" for x in low["X"] for y in low["Y"] for z in low["Z"])
    assert command(tmp_path, f"G0\n{corners}") == 1
    assert "out of travel" in capsys.readouterr().out


def test_wrong_input_leaves_everything_alone(tmp_path: Path) -> None:
    (tmp_path / "out.nc").write_text("before")
    for text, options, words in (
        ("G54\nG0 X1.\n", [], "line 1: G54"),
        (PROGRAM, ["--tolerance", "-1"], "tolerance"),
        (PROGRAM, ["--words", "ends"], "ball"),
        (PROGRAM, ["--start", "C5"], "no axis C"),
        (PROGRAM, ["--resolution", "0.0012345678"], "decimals"),
    ):
        with pytest.raises(InputError, match=words):
            command(tmp_path, text, *options, "--report", str(tmp_path / "report.json"))
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.nc", "out.nc"]
    assert (tmp_path / "out.nc").read_text() == "before"


def test_one_file_for_two_outputs_is_one_fault(tmp_path: Path) -> None:
    with pytest.raises(InputError) as caught:
        command(tmp_path, PROGRAM, "--report", str(tmp_path / "out.nc"))
    assert [fault.problem for fault in caught.value.faults] == ["is both --out and --report"]
    assert not (tmp_path / "out.nc").exists()


def test_faults_of_options_and_errors_come_together(tmp_path: Path) -> None:
    with pytest.raises(InputError) as error:
        command(tmp_path, PROGRAM, "--tolerance", "-1", "--errors", str(tmp_path / "none.json"))
    assert {fault.file for fault in error.value.faults} == {"options", str(tmp_path / "none.json")}


def test_a_program_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="there is no such file"):
        command(tmp_path, None)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "option",
    [
        ["--ball", "1,2"],
        ["--start", "X1Q2"],
        ["--start", "X1X2"],
        ["--words", "best"],
        ["--pass-m", "7,x"],
        ["--pass-m", "7.5"],
        ["--integers", "inch"],
        ["--dialect", "okuma"],
    ],
)
def test_options_that_make_no_sense(tmp_path: Path, option: list[str]) -> None:
    with pytest.raises(SystemExit) as status:
        command(tmp_path, PROGRAM, *option)
    assert status.value.code == 2


def test_what_the_user_vouches_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    program = "G21 G90\nG0 X400 Y350 Z100\nM110\nG1 X420 F1000\nM70\n"
    with pytest.raises(InputError) as error:
        command(tmp_path, program)
    assert [fault.place for fault in error.value.faults] == ["lines 2, 4", "line 3", "line 5"]
    assert command(tmp_path, program, "--integers", "mm", "--pass-m", "70,M110") == 0
    shown = capsys.readouterr().out
    assert "M110 passed, as --pass-m says" in shown
    assert "sign check before first use: set a gauge or laser" in shown
    with pytest.raises(InputError, match="--pass-m does not pass it"):
        command(tmp_path, program, "--dialect", "linuxcnc", "--pass-m", "70,110")


def test_what_was_written_is_said_last(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command(tmp_path, PROGRAM, "--report", str(tmp_path / "report.json")) == 0
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == f"written: {tmp_path / 'out.nc'}, {tmp_path / 'report.json'}"
    assert command(tmp_path, PROGRAM, "--tolerance", "1e-9") == 1
    assert "\nwritten: " not in capsys.readouterr().out


def test_folders_are_made_and_taken_away_again(tmp_path: Path) -> None:
    options = ["--out", str(tmp_path / "a" / "b" / "out.nc"), "--report", str(tmp_path / "c" / "report.json")]
    with pytest.raises(InputError):
        command(tmp_path, "G54\n", *options)
    assert [path.name for path in tmp_path.iterdir()] == ["in.nc"]
    assert command(tmp_path, PROGRAM, *options) == 0
    assert (tmp_path / "a" / "b" / "out.nc").stat().st_mode & 0o777 == 0o644
    assert json.loads((tmp_path / "c" / "report.json").read_text())["good"]


def test_a_report_that_cannot_be_written_leaves_the_program_alone(tmp_path: Path) -> None:
    (tmp_path / "out.nc").write_text("before")
    with pytest.raises(InputError, match="is a folder"):
        command(tmp_path, PROGRAM, "--report", str(tmp_path))
    assert (tmp_path / "out.nc").read_text() == "before"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["in.nc", "out.nc"]


def test_the_program_is_never_written_over(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is both PROGRAM"):
        command(tmp_path, PROGRAM, "--out", str(tmp_path / "in.nc"))
    assert b"G2 " in (tmp_path / "in.nc").read_bytes()


def test_help_reads_well(capsys: pytest.CaptureFixture[str]) -> None:
    parser = argparse.ArgumentParser()
    compensate.add_parser(parser.add_subparsers())
    with pytest.raises(SystemExit):
        parser.parse_args(["compensate", "--help"])
    shown = capsys.readouterr().out
    for words in (
        "--ball",
        "machine coordinates",
        "exit status",
        "default 0.001",
        "default iterative",
        "singular",
        "default keep",
    ):
        assert words in shown


SPEC_OF_EFFECTS = """
[[effect]]
kind = "thermal_expansion"
component = "EXX"

[[effect]]
kind = "drift"
component = "EYY"
"""


def test_temperature_and_time_come_from_options(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    machine = tmp_path / "test.toml"
    machine.write_text(TEXT + SPEC_OF_EFFECTS)
    files = render(derive_model(read_machine(machine)))
    write_files({tmp_path / "kernels" / "test" / name: text for name, text in files.items()})
    values = [
        {"kind": "thermal_expansion", "component": "EXX", "parameters": {"coefficient": 1e-5}},
        {"kind": "drift", "component": "EYY", "parameters": {"rate": 1e-6}},
    ]
    errors = tmp_path / "errors.json"
    errors.write_text(json.dumps({"schema": 1, "machine": "test", "effects": values}))
    program = "G21 G90\nG0 X100. Y50. Z0.\n"
    options = ["--errors", str(errors), "--kernels", str(tmp_path / "kernels")]
    assert command(tmp_path, program, *options, machine=machine) == 0
    assert "effect drift EYY: left alone, depends on time: say --time" in capsys.readouterr().out
    assert execute((tmp_path / "out.nc").read_bytes())[:, -1] == pytest.approx([100.0, 50.0, 0.0])
    assert command(tmp_path, program, *options, "--temperature", "30", "--time", "2000", machine=machine) == 0
    assert execute((tmp_path / "out.nc").read_bytes())[:, -1] == pytest.approx([99.99, 49.998, 0.0])
    with pytest.raises(InputError, match="time is nan"):
        command(tmp_path, program, *options, "--time", "nan", machine=machine)
