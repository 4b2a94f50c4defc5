"""What the document of error values says, against the values themselves and against `predict`."""

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.cli.main import main
from trueaxis.model.model import load_model
from trueaxis.model.uncertainty import load_uncertainty
from trueaxis.reporting.certificate_content import Content, Known, content

MACHINE, KERNELS = ROOT / "machines" / "dmu60p.toml", ROOT / "generated"
TOOL = (10.0, -20.0, -120.0)
EXX = {"basis": "polynomial", "powers": [1, 2], "coefficients": [2e-5, -3e-8], "u": [1e-6, 2e-9]}
ECY = {"basis": "table", "positions": [0, 350, 700], "values": [0, 1.2e-5, 4e-6]}


def written(path: Path, parameters: dict[str, float], **curves: dict[str, Any]) -> Path:
    tree = {"schema": 1, "machine": "dmu60p", "parameters": parameters, "motion_errors": curves}
    path.write_text(json.dumps(tree | {"u": {"eps_xy": 2e-6}}))
    return path


def known(path: Path) -> Known:
    model = load_model(MACHINE, path, KERNELS)
    return Known(model, load_uncertainty(path, model.errors, model.machine), str(path))


@pytest.fixture
def one(tmp_path: Path) -> Content:
    now = written(tmp_path / "now.json", {"eps_xy": 3e-5}, EXX=EXX, ECY=ECY)
    old = written(tmp_path / "old.json", {"eps_xy": 1e-5}, EXX=EXX | {"coefficients": [2e-5, 0.0]}, ECY=ECY)
    return content(known(now), known(old), TOOL)


def test_largest_value_of_a_curve_and_its_uncertainty(one: Content) -> None:
    exx, ecy = one.components
    at = np.linspace(0.0, 540.0, 61)
    values = 2e-5 * at - 3e-8 * at**2
    assert exx.value == pytest.approx(values.max())
    assert exx.at == at[np.argmax(values)]
    assert exx.rms == pytest.approx(np.sqrt(np.mean(values**2)))
    assert exx.at is not None
    assert exx.u == pytest.approx(np.hypot(1e-6 * exx.at, 2e-9 * exx.at**2))
    assert ecy.value == pytest.approx(1.2e-5, rel=0.02)
    assert ecy.at == pytest.approx(350.0, abs=6.0)
    assert np.isnan(ecy.u)


def test_changes_are_counted_in_their_uncertainty(one: Content) -> None:
    exx, ecy = one.components
    assert exx.change is not None
    assert ecy.change is not None
    at = np.linspace(0.0, 540.0, 61)[1:]
    ratio = 3e-8 * at**2 / (np.sqrt(2.0) * np.hypot(1e-6 * at, 2e-9 * at**2))
    assert exx.change.in_u == pytest.approx(ratio.max())
    assert exx.change.at == at[np.argmax(ratio)]
    assert (ecy.change.rms, ecy.change.in_u) == (0.0, 0.0)
    eps = {line.name: line for line in one.locations}["eps_xy"]
    assert eps.change is not None
    assert eps.change.rms == pytest.approx(2e-5)
    assert eps.change.in_u == pytest.approx(2e-5 / np.hypot(2e-6, 2e-6))


def test_the_volume_is_that_of_predict(one: Content, tmp_path: Path) -> None:
    rows = ["X,Y,Z,tool_x,tool_y,tool_z"]
    rows += [f"{x},{y},{z},{','.join(map(str, TOOL))}" for x in (0, 540) for y in (0, 700) for z in (0, 600)]
    at = one.volume.largest_at
    rows.append(f"{at['X']!r},{at['Y']!r},{at['Z']!r},{','.join(map(str, TOOL))}")
    (tmp_path / "at.csv").write_text("\n".join(rows) + "\n")
    files = [
        "--errors",
        str(tmp_path / "now.json"),
        "--at",
        str(tmp_path / "at.csv"),
        "--out",
        str(tmp_path / "out.csv"),
    ]
    assert main(["predict", str(MACHINE), *files, "--datum", "home", "--kernels", str(KERNELS)]) == 0
    with (tmp_path / "out.csv").open() as file:
        lengths = [np.hypot(np.hypot(float(r["dx"]), float(r["dy"])), float(r["dz"])) for r in csv.DictReader(file)]
    assert one.volume.largest == pytest.approx(lengths[-1], rel=1e-9)
    assert one.volume.largest >= max(lengths) - 1e-12
    assert one.volume.rms < one.volume.within <= one.volume.largest
    assert one.changed is not None
    assert 0.0 < one.changed.rms < one.changed.largest
    assert {frozenset(piece.axes) for piece in one.slices} == {frozenset(pair) for pair in ("XY", "XZ", "YZ")}


def test_the_largest_uncertainty_is_that_of_the_whole_travel(tmp_path: Path) -> None:
    """It grows along every axis: points inside the volume alone miss the corner, which `identify` and `export` name."""
    line = {"basis": "polynomial", "powers": [1], "coefficients": [1e-5], "u": [1e-6]}
    now = known(written(tmp_path / "now.json", {}, EXX=line, EXY=line, EXZ=line))
    assert content(now, None, TOOL).volume.u_largest == pytest.approx(1e-6 * np.linalg.norm([540.0, 700.0, 600.0]))
