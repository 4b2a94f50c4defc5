"""trueaxis identify, as a user runs it: on the checked-in kernels and plans."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from trueaxis.cli.main import main
from trueaxis.machine import read_machine
from trueaxis.model.errors import ErrorValues, read_errors

ROOT = Path(__file__).parents[2]
MACHINE = ROOT / "machines" / "dmu60p.toml"
ERRORS = ROOT / "machines" / "dmu60p_errors.json"
KERNELS = ["--kernels", str(ROOT / "generated")]
STEPWISE = ("--method", "stepwise", "--noise-um", "0.3")
LEAST_SQUARES = ["--method", "global", "--prior", "none", "--instruments", "ideal", "--noise-um", "0.001"]


def simulated(folder: Path, plan: str, *options: str) -> Path:
    data = ROOT / "machines" / plan
    arguments = ["simulate", str(MACHINE), "--errors", str(ERRORS), "--data", str(data), "--out", str(folder / plan)]
    assert main([*arguments, *options, *KERNELS]) == 0
    return folder / plan


def identify(data: Path, out: Path, *options: str) -> int:
    return main(["identify", str(MACHINE), "--data", str(data), "--out", str(out), *options, *KERNELS])


def values(path: Path) -> ErrorValues:
    machine = read_machine(MACHINE)
    return read_errors(path, machine=machine.name, components=machine.components, parameters=machine.parameters)


def known(folder: Path) -> Path:
    """The parameters of the simulated machine, without its motion errors."""
    tree = json.loads(ERRORS.read_text())
    tree["motion_errors"] = {}
    path = folder / "known.json"
    path.write_text(json.dumps(tree))
    return path


@pytest.mark.parametrize("method", [["--method", "paper"], LEAST_SQUARES], ids=["paper", "least squares"])
def test_noise_free_readings_give_the_errors_back(tmp_path: Path, method: list[str]) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs"), tmp_path / "e.json"
    options = [*method, "--squareness", "known", "--known", str(known(tmp_path))]
    assert identify(data, out, *options) == 0
    true, found = values(ERRORS), values(out)
    steps = np.arange(28) / 27
    machine = read_machine(MACHINE)
    for name, curve in true.motion_errors.items():
        at = np.round(machine.travel[name[2]][1] * steps, 3)
        lever = 700.0 if name[1] in "ABC" else 1.0
        assert np.abs(found.motion_errors[name](at) - curve(at)).max() * lever < 1e-12, name


def test_singular_plan_is_told_and_no_failure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data, out, report = (
        simulated(tmp_path, "dmu60p_runs", "--noise-um", "0.3"),
        tmp_path / "e.json",
        tmp_path / "r.json",
    )
    capsys.readouterr()
    assert identify(data, out, "--method", "stepwise", "--report", str(report), "--noise-um", "0.3") == 0
    printed = capsys.readouterr().out
    assert "RANK 54 OF 81" in printed
    assert "runs Z-8 and Z-9 are one point" in printed
    assert json.loads(report.read_text())["blocks"][2]["rank"] == 54
    assert any("EZZ" in item.parameters for item in values(out).undetermined)


def test_polynomial_curves_are_written(tmp_path: Path) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.05"), tmp_path / "e.json"
    options = ["--method", "stepwise", "--curves", "polynomial", "--squareness", "convention", "--noise-um", "0.05"]
    assert identify(data, out, *options) == 0
    bases = {entry["basis"] for entry in json.loads(out.read_text())["motion_errors"].values()}
    assert bases == {"polynomial"}


def test_one_run_determines_nothing_by_itself(tmp_path: Path) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs")
    rows = (data / "readings.csv").read_text().splitlines()
    (data / "readings.csv").write_text("\n".join([rows[0], *(r for r in rows if r.startswith("X-1,"))]) + "\n")
    setup = (data / "setup.toml").read_text()
    start, end = setup.index("[[run]]"), setup.index("[[run]]", setup.index("[[run]]") + 1)
    (data / "setup.toml").write_text('schema = 1\nmachine = "dmu60p"\n' + setup[start:end])
    assert identify(data, tmp_path / "e.json", "--method", "stepwise") == 1
    assert identify(data, tmp_path / "e.json") == 0  # with what may be expected, a line tells of its own axis
    determined = values(tmp_path / "e.json").determined
    assert {name for name, by in determined.items() if by != "prior"} <= {"EXX", "EBX", "ECX"}
    assert identify(data, tmp_path / "e.json", "--noise-um", "1e4") == 1  # nor that through so much noise


def test_every_fault_of_the_options_is_told_and_nothing_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "e.json"
    options = ["--method", "global", "--squareness", "sect36", "--report", str(out), "--known", str(tmp_path / "none")]
    assert identify(tmp_path / "nowhere", out, *options) == 2
    told = capsys.readouterr().err
    for words in ("goes with --method stepwise", "is both --out and --report", "nowhere", "none"):
        assert words in told
    assert not out.exists()


def test_a_plan_without_readings_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert identify(ROOT / "machines" / "dmu60p_regular_runs", tmp_path / "e.json") == 2
    assert "there is no reading in it" in capsys.readouterr().err


def test_runs_that_are_not_read_yet_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs")
    head, *rows = (data / "readings.csv").read_text().splitlines()
    empty = [row if not row.startswith(("Z-9,", "X-1,")) else row.rpartition(",")[0] + "," for row in rows]
    first = next(index for index, row in enumerate(rows) if row.startswith("X-1,"))
    empty[first] = rows[first]
    (data / "readings.csv").write_text("\n".join([head, *empty]) + "\n")
    capsys.readouterr()
    assert identify(data, tmp_path / "e.json") == 0
    shown = " ".join(capsys.readouterr().out.split())
    assert "NOTE: no reading yet in Z-9: the others alone are used" in shown
    assert "NOTE: readings are missing in X-1 (27 of 28 rows): the others alone are used" in shown


def test_the_example_of_known_dimensions_is_taken(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = (ROOT / "docs" / "files.md").read_text().split("### What is known beforehand")[1]
    (tmp_path / "known.json").write_text(page.split("```json")[1].split("```")[0])
    data = simulated(tmp_path, "dmu60p_regular_runs")
    assert identify(data, tmp_path / "e.json", "--known", str(tmp_path / "known.json")) == 0
    assert "are not given (--known)" not in capsys.readouterr().out
    assert json.loads((tmp_path / "e.json").read_text())["parameters"]["q_Tz"] == -195.0


def test_some_runs_alone_are_as_if_the_others_had_not_been_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3"), tmp_path / "e.json"
    chosen = ["X-1", "X-2", "Y-5"]
    capsys.readouterr()
    assert identify(data, out, *STEPWISE, "--runs", *chosen) == 0
    told = " ".join(capsys.readouterr().out.split())
    head, *rows = (data / "readings.csv").read_text().splitlines()
    unread = [row if row.split(",")[0] in chosen else row.rpartition(",")[0] + "," for row in rows]
    (data / "readings.csv").write_text("\n".join([head, *unread]) + "\n")
    assert identify(data, out, *STEPWISE) == 0
    unread_too = " ".join(capsys.readouterr().out.split())
    note = re.search("NOTE: no reading yet in .* the others alone are used ", unread_too)
    assert note is not None
    assert unread_too.replace(note[0], "") == told
    assert identify(data, out, "--runs", "X-1", "nosuch") == 2
    assert "--runs: nosuch: is no run of the setup" in capsys.readouterr().err


def test_readings_that_determine_nothing_end_with_a_reason(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data, out = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3"), tmp_path / "e.json"
    assert identify(data, out, *STEPWISE, "--runs", "X-1") == 1
    assert "trueaxis: the readings determine no error: the values are zero" in capsys.readouterr().err


def test_values_of_a_machine_whose_axis_was_turned_round_since_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Compensation with them would double the errors of the axis."""
    out = tmp_path / "e.json"
    assert identify(simulated(tmp_path, "dmu60p_regular_runs"), out, *STEPWISE) in (0, 1)
    assert json.loads(out.read_text())["chain"] == read_machine(MACHINE).chain
    turned, program = tmp_path / "turned.toml", tmp_path / "p.nc"
    turned.write_text(
        MACHINE.read_text().replace('moves = "X"', 'moves = "X"\nsense = -1').replace("runs =", "# runs =")
    )
    program.write_text("G21 G90\nG1 X10. Y10. Z10. F100\nM30\n")
    assert main(["derive", str(turned), "--out", str(tmp_path / "kernels")]) == 0
    capsys.readouterr()
    words = ["compensate", str(turned), "--errors", str(out), str(program), "--out", str(tmp_path / "o.nc")]
    assert main([*words, "--kernels", str(tmp_path / "kernels")]) == 2
    said = capsys.readouterr().err
    assert "chain" in said
    assert "-X" in said
    assert "identify again" in said
    assert not (tmp_path / "o.nc").exists()
