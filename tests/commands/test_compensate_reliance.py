"""`compensate` says how far a program relies on what was measured, and refuses what relies on too little."""

import json
from pathlib import Path
from typing import Any

import pytest

from tests.identify.test_command import ERRORS, KERNELS, MACHINE, identify, simulated
from trueaxis.cli import main

PROGRAM = "G21 G90 G17\nG0 X0. Y0. Z0.\nG1 X270. Y350. Z150. F1000\nX530.\nM2\n"


def compensate(folder: Path, errors: Path, *options: str, program: str = PROGRAM) -> int:
    (folder / "part.nc").write_text(program)
    files = ["--errors", str(errors), str(folder / "part.nc"), "--out", str(folder / "out.nc")]
    return main(["compensate", str(MACHINE), *files, "--report", str(folder / "report.json"), *options, *KERNELS])


def written(folder: Path, **keys: Any) -> Path:
    path = folder / "e.json"
    path.write_text(json.dumps({"schema": 1, "machine": "dmu60p", **keys}))
    return path


def line(slope: float, **keys: Any) -> dict[str, Any]:
    return {"basis": "polynomial", "powers": [1], "coefficients": [slope], **keys}


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The published points leave what Z does open, and all that rests on it."""
    folder = tmp_path_factory.mktemp("published")
    assert identify(simulated(folder, "dmu60p_runs", "--noise-um", "0.3"), folder / "e.json", "--noise-um", "0.3") == 0
    return folder / "e.json"


def test_what_is_open_is_said_and_refused_under_a_limit(
    tmp_path: Path, published: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compensate(tmp_path, published) == 0
    said = capsys.readouterr().out
    assert "the tool point rests on components that the readings did not determine" in said
    assert "EZZ" in said
    report = json.loads((tmp_path / "report.json").read_text())
    assert report["reliance"]["uncertainty"]["open"] > 0
    for file in ("out.nc", "report.json"):
        (tmp_path / file).unlink()
    assert compensate(tmp_path, published, "--max-u", "5") == 1
    assert "not written" in capsys.readouterr().out
    assert not (tmp_path / "out.nc").exists()
    assert not (tmp_path / "report.json").exists()


def test_the_limit_is_that_of_the_largest_u_along_the_program(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """EXX alone, with a slope known to 1 %: at X = 530 its u is 53 nm."""
    errors = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[1e-7])})
    assert compensate(tmp_path, errors, "--max-u", "0.0000531") == 0
    assert "from home: 0.053 um" in capsys.readouterr().out
    assert compensate(tmp_path, errors, "--max-u", "0.0000529") == 1


def test_values_without_uncertainties_count_as_infinite(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert compensate(tmp_path, ERRORS) == 0
    assert "is not known" in capsys.readouterr().out
    assert compensate(tmp_path, ERRORS, "--max-u", "10") == 1


def test_corrections_beyond_three_times_the_prior_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """0.95 mm at X = 530: 47 sizes of a component, believable in a file, yet far more than is likely."""
    errors = written(tmp_path, motion_errors={"EXX": line(0.95 / 530.0)})
    assert compensate(tmp_path, errors) == 1
    said = capsys.readouterr().out
    assert "the correction at X530 Y350 Z150 is 0.9" in said
    assert "--max-correction" in said
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, errors, "--max-correction", "1.0") == 0
    assert compensate(tmp_path, errors, "--max-correction", "0.9") == 1


def test_use_beyond_the_measured_range_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    errors = written(tmp_path, motion_errors={"EXX": line(1e-5, measured=[0.0, 400.0])})
    assert compensate(tmp_path, errors) == 0
    assert "the program leaves what was measured: EXX from X = 0 to 400 mm, used at X = 530" in capsys.readouterr().out


def test_a_misfit_is_compensated_on_request_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    errors = written(
        tmp_path, motion_errors={"EXX": line(1e-5)}, fit={"state": "misfit", "chi2": 50.0, "runs": ["X-1"]}
    )
    assert compensate(tmp_path, errors) == 2
    assert "worst in X-1" in capsys.readouterr().err
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, errors, "--accept-misfit") == 0


def test_a_program_that_moves_nothing_relies_on_nothing(tmp_path: Path) -> None:
    assert compensate(tmp_path, ERRORS, program="G21\nM2\n") == 0
    reliance = json.loads((tmp_path / "report.json").read_text())["reliance"]
    assert reliance["allowed_correction"] is None
    assert reliance["uncertainty"]["points"] == 0
