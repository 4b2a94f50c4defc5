"""The commands of docs/tutorials/laser_to_control.md, as they stand there, one after another."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from tests import tutorials
from tests.controllers.kins_module import KinsModule, compiled, compiler
from tests.laser_to_control.inputs import FOLDER, all_files
from tests.laser_to_control.left import left
from tests.machines import ROOT

PAGE = ROOT / "docs" / "tutorials" / "laser_to_control.md"
HOLE = {"X": 200.0, "Y": 130.0, "Z": -177.0}  # X20 Y20 Z-12 of the program, G54, a tool of 95 mm


def test_every_command_does_what_the_page_says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shutil.copytree(FOLDER, tmp_path / "shop")
    monkeypatch.chdir(tmp_path)
    text = PAGE.read_text(encoding="utf-8")
    assert tutorials.run(text, tmp_path) == 10
    assert not Path("no").exists()
    found = left(tmp_path)
    told = dict(re.findall(r"^(\w[\w ]+): ([\d.]+) um$", text, re.MULTILINE))
    assert found.keys() == told.keys()
    for name, value in found.items():
        assert value * 1e3 == pytest.approx(float(told[name]), abs=0.15)
    words_of_a_hole(tmp_path)
    if compiler():
        the_module_sends_joints_where_the_words_are(tmp_path)


def words_of_a_hole(folder: Path) -> dict[str, float]:
    """Machine positions that the compensated program commands at the bottom of the first hole, mm."""
    modal: dict[str, float] = {}
    for line in (folder / "plate_compensated.nc").read_text().splitlines():
        modal |= {axis: float(value) for axis, value in re.findall(r"([XYZ])(-?\d+\.\d+)", line)}
        if modal.get("Z", 0.0) < -11.0:
            break
    zero = {"X": 180.0, "Y": 110.0, "Z": -260.0 + 95.0}
    sent = {axis: modal[axis] + zero[axis] for axis in HOLE}
    off = [abs(sent[axis] - HOLE[axis]) for axis in HOLE]
    assert 5e-3 < max(off) < 5e-2
    return sent


def the_module_sends_joints_where_the_words_are(folder: Path) -> None:
    module = KinsModule(compiled(folder / "kins"))
    module.switch_on((0.0, 0.0, 95.0))
    code, joints = module.inverse(HOLE, 3)
    assert code == 0
    np.testing.assert_allclose(joints, list(words_of_a_hole(folder).values()), rtol=0, atol=5.1e-4)  # words of 0.001


@pytest.mark.slow
def test_the_files_of_the_shop_are_those_that_are_simulated() -> None:
    for name, text in all_files().items():
        assert (FOLDER / name).read_bytes().decode() == text
