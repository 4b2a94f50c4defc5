"""From the files of a laser to the table of a control: every sign on the way, judged on the true machine."""

import json
from pathlib import Path

import numpy as np

from tests.command_lines import KERNELS
from tests.controllers import control_files
from tests.instrument_files.writers import rtl
from tests.machines import ROOT
from trueaxis.cli.main import main
from trueaxis.model.model import load_model

MACHINE = ROOT / "machines" / "gantry_mill.toml"
POINT = np.array([[0.0], [0.0], [-100.0]])
MIDDLE = {"X": 1500.0, "Y": 750.0, "Z": -300.0}
NOISE_UM = 0.3  # of a reading


def run(*words: object) -> None:
    assert main([str(word) for word in words]) == 0


def true_machine(folder: Path) -> Path:
    """Each axis is off along itself by up to 60 um, and turns on the way, so that the laser's line matters."""
    draw = np.random.default_rng(4)
    curves = {}
    for axis, travel in (("X", 3000.0), ("Y", 1500.0), ("Z", 600.0)):
        sizes = draw.normal(0.0, 0.02, 3)
        coefficients = [float(size / travel**power) for power, size in enumerate(sizes, 1)]
        curves[f"E{axis}{axis}"] = {"basis": "polynomial", "powers": [1, 2, 3], "coefficients": coefficients}
    curves["ECX"] = {"basis": "polynomial", "powers": [1], "coefficients": [5e-9]}
    path = folder / "true.json"
    path.write_text(json.dumps({"schema": 1, "machine": "gantry_mill", "parameters": {}, "motion_errors": curves}))
    return path


def test_a_table_from_laser_files_takes_the_errors_off(tmp_path: Path) -> None:
    model = load_model(MACHINE, true_machine(tmp_path), KERNELS)
    draw = np.random.default_rng(5)
    keys = ["target.point=0,0,-100", *(f"at.{axis}={at}" for axis, at in MIDDLE.items())]
    for row, axis in enumerate("XYZ"):
        targets = np.linspace(*model.travel[axis], 11)
        at = np.repeat(np.array([[value] for value in MIDDLE.values()]), targets.size, axis=1)
        at[row] = targets
        off = model.view_deviation("tool_in_bed", at, POINT)[row] * 1e3
        passes = np.array([off - off[0] + draw.normal(0.0, NOISE_UM, targets.size) for _ in range(4)])
        (tmp_path / f"{axis}.rtl").write_bytes(rtl(targets.tolist(), passes, axis=axis).encode())
    files = [tmp_path / f"{axis}.rtl" for axis in "XYZ"]
    run("import", *files, "--machine", MACHINE, "--out", tmp_path / "data", "--map", *keys)
    options = ["--data", tmp_path / "data", "--method", "global"]
    run("identify", MACHINE, *options, "--out", tmp_path / "e.json", "--kernels", KERNELS)
    words = ["--format", "siemens-enc", "--out", tmp_path / "enc.ini", "--tool-point", "0,0,-100"]
    run("export", MACHINE, "--errors", tmp_path / "e.json", *words, "--kernels", KERNELS)
    tables = control_files.siemens_enc((tmp_path / "enc.ini").read_text())
    for row, axis in enumerate("XYZ"):
        line = np.linspace(*model.travel[axis], 25)
        sent, wanted = (np.repeat(np.array([[v] for v in MIDDLE.values()]), line.size, axis=1) for _ in range(2))
        wanted[row] = line
        sent[row] = line - np.interp(line, *tables[axis, axis][:2])
        before = model.deviation(wanted, POINT)[row]
        after = sent[row] - line + model.deviation(sent, POINT)[row]
        assert np.ptp(before) > 8e-3
        assert np.ptp(after) < 1.5e-3
