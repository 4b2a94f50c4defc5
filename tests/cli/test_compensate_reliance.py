"""`compensate` says how far a program relies on what was measured, and refuses what relies on too little."""

import json
from pathlib import Path
from typing import Any

import polars as pl
import pytest

from tests.identification.test_command import ERRORS, KERNELS, MACHINE, STEPWISE, identify, simulated
from trueaxis.cli.main import main

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
    data = simulated(folder, "dmu60p_runs", "--noise-um", "0.3")
    assert identify(data, folder / "e.json", *STEPWISE) == 0
    return folder / "e.json"


def test_what_is_open_is_said_and_refused_under_a_limit(
    tmp_path: Path, published: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert compensate(tmp_path, published) == 1
    assert "take --accept-u" in capsys.readouterr().out
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, published, "--accept-u") == 0
    said = capsys.readouterr().out
    assert "the tool point rests on errors that neither readings nor a prior determine" in said
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
    """EXX alone, with a slope known to 1 %: at X = 530, the farthest of the program, its u is 53 nm."""
    errors = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[1e-7])})
    assert compensate(tmp_path, errors, "--max-u", "0.0000531") == 0
    assert "from home, in one coordinate: 0.053 um" in capsys.readouterr().out
    assert compensate(tmp_path, errors, "--max-u", "0.0000529") == 1


def test_values_that_are_more_uncertain_than_large_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Without an option: words that are as likely to make it worse are no compensation. An option takes them."""
    errors = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[1.2e-5])})
    assert compensate(tmp_path, errors) == 1
    said = capsys.readouterr().out
    assert "not written: the corrections are" in said
    assert "--accept-u" in said
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, errors, "--accept-u") == 0
    assert compensate(tmp_path, errors, "--max-u", "0.01") == 0
    known = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[0.8e-5])})
    assert compensate(tmp_path, known) == 0


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
    assert "the program leaves the measured range: EXX from X = 0 to 400 mm, used at X = 4" in capsys.readouterr().out


def test_a_misfit_is_compensated_on_request_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    errors = written(
        tmp_path, motion_errors={"EXX": line(1e-5)}, fit={"state": "misfit", "chi2": 50.0, "runs": ["X-1"]}
    )
    assert compensate(tmp_path, errors) == 2
    assert "worst in X-1" in capsys.readouterr().err
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, errors, "--accept-misfit") == 0


def test_a_program_that_moves_nothing_relies_on_nothing(tmp_path: Path) -> None:
    assert compensate(tmp_path, ERRORS, program="G21\nM2\n") == 1  # done, and nothing moves
    reliance = json.loads((tmp_path / "report.json").read_text())["reliance"]
    assert reliance["allowed_correction"] is None
    assert reliance["uncertainty"]["points"] == 0


def test_u_is_judged_all_along_a_motion_and_all_over_a_cell(tmp_path: Path) -> None:
    """EYX is not known between 200 and 300: a block that crosses rests on it, whatever its ends do."""
    table = {"basis": "table", "positions": [0, 100, 200, 250, 300, 400, 500], "values": [0.0] * 7}
    errors = written(tmp_path, motion_errors={"EYX": table | {"u": [0, 1e-6, 1e-6, None, 1e-6, 1e-6, 1e-6]}})
    crossing = "G21 G90\nG0 X100. Y0. Z0.\nG1 X500. F1000\nM2\n"
    assert compensate(tmp_path, errors, "--max-u", "0.01", program=crossing) == 1
    beside = "G21 G90\nG0 X0. Y0. Z0.\nG1 X150. F1000\nM2\n"
    assert compensate(tmp_path, errors, "--max-u", "0.01", program=beside) == 0


def test_home_lends_its_certainty_to_nobody(tmp_path: Path) -> None:
    """A program that starts at home and stays in its cell: u is 0 at home alone."""
    errors = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[1e-4])})
    near = "G21 G90\nG0 X0. Y0. Z0.\nG1 X15. F1000\nM2\n"
    assert compensate(tmp_path, errors, "--max-u", "0.001", program=near) == 1
    assert compensate(tmp_path, errors, "--max-u", "0.003", program=near) == 0


def test_the_covariance_that_is_read_is_not_overwritten(tmp_path: Path, published: Path) -> None:
    for file in ("e.json", "e.npz"):
        (tmp_path / file).write_bytes((published.parent / file).read_bytes())
    before = (tmp_path / "e.npz").read_bytes()
    files = ["--errors", str(tmp_path / "e.json"), "--out", str(tmp_path / "e2.json")]
    (tmp_path / "e2.npz").symlink_to(tmp_path / "e.npz")
    assert main(["fit", str(MACHINE), *files, *KERNELS]) == 2
    (tmp_path / "part.nc").write_text(PROGRAM)
    words = ["compensate", str(MACHINE), "--errors", str(tmp_path / "e.json"), str(tmp_path / "part.nc")]
    assert main([*words, "--out", str(tmp_path / "e.npz"), *KERNELS]) == 2
    assert (tmp_path / "e.npz").read_bytes() == before


def test_a_covariance_of_other_values_is_a_fault(
    tmp_path: Path, published: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two results that wrote one covariance file after the other."""
    tree = json.loads((published.parent / "e.json").read_text())
    (tmp_path / "e.npz").write_bytes((published.parent / "e.npz").read_bytes())
    tree["parameters"]["eps_xy"] += 1e-6
    (tmp_path / "e.json").write_text(json.dumps(tree))
    assert compensate(tmp_path, tmp_path / "e.json") == 2
    assert "is the covariance of other values" in capsys.readouterr().err


def test_the_active_compensation_is_not_overwritten(tmp_path: Path) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3")
    (tmp_path / "act.json").write_text(ERRORS.read_text())
    setup = data / "setup.toml"
    setup.write_text(setup.read_text().replace("schema = 1\n", 'schema = 1\ncompensation = "../act.json"\n', 1))
    assert identify(data, tmp_path / "act.json", "--noise-um", "0.3") == 2
    assert (tmp_path / "act.json").read_text() == ERRORS.read_text()


def test_uncertainty_of_known_values_is_kept(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3")
    given = written(tmp_path, motion_errors={"EXX": line(1e-5, u=[2e-4])})
    for method in ("paper", "global"):
        out = tmp_path / f"{method}.json"
        identify(data, out, "--noise-um", "0.3", "--known", str(given), "--method", method)
        (tmp_path / "p.csv").write_text("X,Y,Z\n500,0,0\n")
        words = ["predict", str(MACHINE), "--errors", str(out), "--at", str(tmp_path / "p.csv")]
        if out.exists():
            assert main([*words, "--out", str(tmp_path / "o.csv"), *KERNELS]) == 0
            table = pl.read_csv(tmp_path / "o.csv")
            assert table["u_dx"][0] == pytest.approx(0.1, rel=0.05), method
            assert table["u_prior_dx"][0] < 0.01, method  # what is stated counts with the readings
    assert (tmp_path / "global.json").exists()


def test_turns_that_no_machine_needs_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Near a singular pose a tilt of 4.9 mrad asks for 16 deg of C: a hundred times the prior, and a wild move."""
    spec = MACHINE.parent / "headhead_mill.toml"
    curves = {name: {"basis": "table", "positions": [0], "values": [4.9e-3]} for name in ("EAC", "EBC")}
    errors = tmp_path / "e.json"
    errors.write_text(json.dumps({"schema": 1, "machine": "headhead_mill", "motion_errors": curves}))
    (tmp_path / "part.nc").write_text("G21 G90\nG0 X100. Y100. Z-100. B1. C0.\nM2\n")
    words = [
        "compensate",
        str(spec),
        "--errors",
        str(errors),
        str(tmp_path / "part.nc"),
        "--out",
        str(tmp_path / "o.nc"),
    ]
    assert main([*words, "--orientation", "correct", "--max-correction", "100", *KERNELS]) == 1
    assert "a rotary axis would be corrected by 16" in capsys.readouterr().out
    assert not (tmp_path / "o.nc").exists()


def test_a_shift_of_all_words_that_is_hardly_known_is_said_and_refused_under_a_limit(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A squareness tilts the spindle, which displaces the tip of a long tool everywhere, at home too: u from there is
    small. Counted from a datum that was touched off with the same tool it is no part of the words.
    """
    errors = written(tmp_path, parameters={"eps_yz": 1e-4}, u={"eps_yz": 8e-5})
    options = ("--tool-point=0,0,-200", "--offset", "G54=X20,Y20,Z20", "--max-u", "0.015")
    program = "G21 G90 G17 G54\nG0 X0. Y0. Z0.\nG1 X20. Y10. Z-10. F1000\nM2\n"
    assert compensate(tmp_path, errors, *options, program=program) == 1
    said = capsys.readouterr().out
    assert "WARNING: every word holds the displacement at home, 20 um, which is known to" in said
    assert "uncertainty is 16 um, where --max-u allows 15 um: say --touched-off" in said
    assert not (tmp_path / "out.nc").exists()
    assert compensate(tmp_path, errors, *options, "--touched-off", "G54", program=program) == 0
    assert "WARNING" not in capsys.readouterr().out
