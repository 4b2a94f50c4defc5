"""trueaxis init: a spec that the other commands take, and nothing that was there before lost."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from tests.machines import machine_of
from trueaxis.cli.main import main

FIVE = "[w C' Y' b X Z B t]"


def init(path: Path, structure: str, *words: str) -> int:
    return main(["init", str(path), "--structure", structure, *words])


def test_the_machine_is_that_of_the_structure_code(tmp_path: Path) -> None:
    path = tmp_path / "mill.toml"
    assert init(path, FIVE, "--travel", "X=0:600", "Y=0:400.5", "Z=-150:0", "--sense", "Y=-1") == 0
    machine = machine_of(path.read_text())
    assert machine.name == "mill"
    assert machine.travel == {"X": (0.0, 600.0), "Y": (0.0, 400.5), "Z": (-150.0, 0.0), "B": (-360.0, 360.0),
                              "C": (-360.0, 360.0)}  # fmt: skip
    assert [machine.mover(axis).sense for axis in "XYZBC"] == [1, -1, 1, 1, 1]
    short = f'schema = 1\nname = "mill"\nstructure = "{FIVE}"\n[axis.X]\ntravel = [0.0, 600.0]\n'
    short += "[axis.Y]\ntravel = [0.0, 400.5]\nsense = -1\n[axis.Z]\ntravel = [-150.0, 0.0]\n"
    assert machine.digest == machine_of(short).digest
    assert "# sense = -1" in path.read_text().split("[axis.C]")[1]
    shown = re.sub(r"^# (\[prior\]|\w+_(?:um|urad) = )", r"\1", path.read_text(), flags=re.MULTILINE)
    assert "\n[prior]\ntranslation_um = 20.0\n" in shown
    assert machine_of(shown).prior == machine.prior  # the default, to be edited
    values = json.loads((tmp_path / "mill_errors.json").read_text())
    assert (values["machine"], values["motion_errors"]) == ("mill", {})


def test_the_job_begins_with_it(tmp_path: Path) -> None:
    path, kernels = tmp_path / "mill.toml", str(tmp_path / "generated")
    assert init(path, "[w b X Y Z t]", "--travel", "X=0:600", "Y=0:400", "Z=-150:0") == 0
    assert main(["derive", str(path), "--out", kernels]) == 0
    (tmp_path / "points.csv").write_text("X,Y,Z\n600,400,-150\n")
    words = ["predict", str(path), "--errors", str(tmp_path / "mill_errors.json"), "--kernels", kernels]
    assert main([*words, "--at", str(tmp_path / "points.csv"), "--out", str(tmp_path / "d.csv")]) == 0
    rows = np.genfromtxt(tmp_path / "d.csv", delimiter=",", names=True)
    assert [float(rows[name]) for name in ("dx", "dy", "dz")] == [0.0, 0.0, 0.0]


@pytest.mark.parametrize("name", ["mill.toml", "mill_errors.json"])
def test_what_is_there_is_not_written_over(tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / name).write_text("by hand")
    assert init(tmp_path / "mill.toml", "[w b X t]", "--travel", "X=0:600") == 2
    assert f"{tmp_path / name}: is there already" in capsys.readouterr().err
    assert {path.name: path.read_text() for path in tmp_path.iterdir()} == {name: "by hand"}


def test_the_same_again_is_no_fault(tmp_path: Path) -> None:
    for _ in range(2):
        assert init(tmp_path / "mill.toml", "[w b X t]", "--travel", "X=0:600") == 0
    assert init(tmp_path / "mill.toml", "[w b X t]", "--travel", "X=0:601") == 2


def test_every_fault_at_once(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert init(tmp_path / "3.toml", FIVE, "--travel", "X=0:1", "X=0:2", "A=0:1") == 2
    told = capsys.readouterr().err
    for fault in ("is no name of a spec", "--travel: X: is given more than once", "A: is no axis of the structure",
                  "--travel: Y: is missing; Y=LOW:HIGH, mm", "--travel: Z: is missing"):  # fmt: skip
        assert fault in told
    assert init(tmp_path / "mill.toml", "[w b X X t]", "--travel", "X=0:1") == 2
    assert "--structure: [w b X X t]: cannot be read: axis X stands there more than once" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("word", ["X=1:0", "X=0", "X=a:b", "U=0:1", "X=nan:1"])
def test_what_is_no_travel(tmp_path: Path, word: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stop:
        init(tmp_path / "mill.toml", "[w b X t]", "--travel", word)
    assert stop.value.code == 2
    assert "is not AXIS=LOW:HIGH" in capsys.readouterr().err


def test_limits_of_a_spec_hold(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert init(tmp_path / "mill.toml", "[w b X t]", "--travel", "X=0:1e9") == 2
    assert "axis.X.travel" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
