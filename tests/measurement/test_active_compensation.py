"""Readings taken while a compensation was active: what it took away is added again, for all commands alike."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from tests.identification.test_command import ERRORS, KERNELS, MACHINE, identify, known, values
from trueaxis.cli.main import main
from trueaxis.machine import read_machine
from trueaxis.measurement.active_compensation import moved_setup
from trueaxis.measurement.data import read_data

PLAN = MACHINE.parent / "dmu60p_regular_runs"


def plan(folder: Path, compensation: str) -> Path:
    """The regular runs with the key, beside the values of a compensation that removes 9 tenths of each curve."""
    tree = json.loads(ERRORS.read_text())
    for curve in tree["motion_errors"].values():
        curve["coefficients"] = [0.9 * value for value in curve["coefficients"]]
    (folder / "active.json").write_text(json.dumps(tree))
    out = folder / "plan"
    shutil.copytree(PLAN, out)
    text = (out / "setup.toml").read_text()
    head, _, rest = text.partition("[[run]]")
    (out / "setup.toml").write_text(
        f'{head}compensation = "{compensation}"\n[report]\nserial = "4711"\n\n[[run]]{rest}'
    )
    return out


def simulated(data: Path, out: Path) -> int:
    words = ["simulate", str(MACHINE), "--errors", str(ERRORS), "--data", str(data), "--out", str(out)]
    return main([*words, *KERNELS])


def test_readings_under_a_compensation_give_the_whole_errors_back(tmp_path: Path) -> None:
    data, bare = tmp_path / "deeper" / "data", tmp_path / "bare"
    assert simulated(plan(tmp_path, "../active.json"), data) == 0
    assert simulated(PLAN, bare) == 0
    machine = read_machine(MACHINE)
    left, whole = (np.abs(read_data(folder, machine).readings.reading).max() for folder in (data, bare))
    assert left < 0.2 * whole  # what the compensation leaves
    out, report = tmp_path / "e.json", tmp_path / "r.json"
    options = [
        "--method",
        "stepwise",
        "--squareness",
        "known",
        "--known",
        str(known(tmp_path)),
        "--report",
        str(report),
    ]
    assert identify(data, out, *options) == 0
    true, found = values(ERRORS), values(out)
    for name, curve in true.motion_errors.items():
        at = np.round(machine.travel[name[2]][1] * np.arange(28) / 27, 3)
        lever = 700.0 if name[1] in "ABC" else 1.0
        assert np.abs(found.motion_errors[name](at) - curve(at)).max() * lever < 1e-8, name
    tree = json.loads(report.read_text())
    assert tree["measurement"] == {"serial": "4711"}
    assert any("use them instead of the active ones, not on top of them" in note for note in tree["notes"])


@pytest.mark.parametrize("command", ["plan", "simulate", "identify"])
def test_a_file_that_is_missing_is_a_fault_at_the_key(
    tmp_path: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    data, out = plan(tmp_path, "nowhere.json"), tmp_path / "out"
    words = {
        "plan": ["plan", str(MACHINE), "--data", str(data)],
        "simulate": ["simulate", str(MACHINE), "--errors", str(ERRORS), "--data", str(data), "--out", str(out)],
        "identify": ["identify", str(MACHINE), "--data", str(data), "--out", str(out)],
    }[command]
    assert main([*words, *KERNELS]) == 2
    told = capsys.readouterr().err
    assert "key compensation" in told
    assert "there is no such file" in told
    assert not out.exists()


def test_values_of_another_machine_are_a_fault_at_the_key(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = plan(tmp_path, "../active.json")
    (tmp_path / "active.json").write_text('{"schema": 1, "machine": "router"}')
    assert identify(data, tmp_path / "e.json") == 2
    told = capsys.readouterr().err
    assert "key compensation" in told
    assert '"router" is another machine' in told


def test_a_setup_that_says_nothing_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = tmp_path / "data"
    assert simulated(PLAN, data) == 0
    assert identify(data, tmp_path / "e.json", "--method", "stepwise") == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "setup.toml does not say whether a compensation of the control was active; none is assumed" in said


def test_the_way_to_the_file_is_kept_in_another_folder(tmp_path: Path) -> None:
    text = 'schema = 1\n# compensation = "old.json"\ncompensation = "active.json"  # as of May\n'
    source = tmp_path / "a"
    source.mkdir()
    (source / "setup.toml").write_text(text)
    moved = moved_setup(source, tmp_path / "b" / "c").decode()
    assert moved == text.replace('"active.json"', '"../../a/active.json"')
    assert moved_setup(source, source).decode() == text
    (source / "setup.toml").write_bytes(b"\xef\xbb\xbfschema = 1\r\n")
    assert moved_setup(source, tmp_path / "b") == b"\xef\xbb\xbfschema = 1\r\n"


def test_a_proposed_plan_keeps_the_way_to_the_file(tmp_path: Path) -> None:
    data, out = tmp_path / "data", tmp_path / "more" / "plan"
    assert simulated(PLAN, data) == 0
    (tmp_path / "active.json").write_text('{"schema": 1, "machine": "dmu60p"}')
    setup = data / "setup.toml"
    setup.write_text(setup.read_text().replace("schema = 1\n", 'schema = 1\ncompensation = "../active.json"\n', 1))
    arguments = ["plan", str(MACHINE), "--data", str(data)]
    assert main([*arguments, "--propose", "1", "--out", str(out), *KERNELS]) == 0
    assert 'compensation = "../../active.json"' in (out / "setup.toml").read_text()
