"""trueaxis export: what is written, what is said of it, and what is refused."""

import json
import shutil
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from tests.command_lines import ERRORS, KERNELS
from tests.controllers import control_files
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main
from trueaxis.controllers.formats import FORMATS

GANTRY = ROOT / "machines" / "gantry_mill.toml"


def export(name: str, out: Path, *words: str | Path, machine: Path = DMU60P, errors: Path = ERRORS) -> int:
    options = ["--errors", errors, "--format", name, "--out", out, "--kernels", KERNELS, *words]
    return main(list(map(str, ["export", machine, *options])))


def values(folder: Path, **more: object) -> Path:
    """Error values of the gantry mill with uncertainties: a scale, a straightness, a squareness."""
    curve = {"basis": "polynomial", "powers": [1]}
    tree = {
        "schema": 1,
        "machine": "gantry_mill",
        "parameters": {"EC0Y": -2e-5},
        "u": {"EC0Y": 1e-6, "EA0Z": 1e-6, "EB0Z": 1e-6},
        "motion_errors": {
            "EXX": curve | {"coefficients": [1e-5], "u": [1e-7]},
            "EYX": curve | {"coefficients": [2e-6], "u": [1e-7]},
        },
    }
    path = folder / "e.json"
    path.write_text(json.dumps(tree | more))
    return path


@pytest.mark.parametrize("name", FORMATS)
def test_every_format_is_written_the_same_each_time(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    errors = values(tmp_path)
    for out in ("one", "two"):
        assert export(name, tmp_path / out, machine=GANTRY, errors=errors) == 0
    shown = capsys.readouterr().out
    assert "RMS of the tool point over the travel, from home:" in shown
    assert "largest standard uncertainty of the tool point over the travel" in shown
    files = sorted(path.relative_to(tmp_path / "one") for path in (tmp_path / "one").rglob("*") if path.is_file())
    assert (tmp_path / "one").is_dir() == (name in ("heidenhain-com", "linuxcnc-comp", "linuxcnc-kins"))
    for file in files or [Path()]:
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes()


def test_tables_that_make_the_machine_worse_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """EXX and EXY of opposite slopes make up for one another; a table of EXX alone takes that away."""
    line = {"basis": "polynomial", "powers": [1], "u": [1e-9]}
    curves = {"EXX": line | {"coefficients": [2e-2 / 3000.0]}, "EXY": line | {"coefficients": [-2e-2 / 1500.0]}}
    errors = values(tmp_path, motion_errors=curves, parameters={}, u={"EC0Y": 1e-9, "EA0Z": 1e-9, "EB0Z": 1e-9})
    for name in ("siemens-enc", "linuxcnc-comp"):
        out = tmp_path / name
        assert export(name, out, machine=GANTRY, errors=errors) == 1
        shown = capsys.readouterr().out
        assert not out.exists()
        assert "not written: with these tables" in shown
        assert ("siemens-cec loaded beside" in shown) == (name == "siemens-enc")
        assert export(name, out, "--accept-worse", machine=GANTRY, errors=errors) == 0
        shown = capsys.readouterr().out
        assert "warning: the error is larger with these tables than without them" in shown
        assert out.exists()
    assert export("isg-csv", tmp_path / "whole.csv", machine=GANTRY, errors=errors) == 0
    assert "warning" not in capsys.readouterr().out


def test_both_types_of_files_of_linuxcnc(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """What motion adds to the command is the same; the option is of no other format."""
    errors = values(tmp_path)
    added = []
    for kind in ("0", "1"):
        out = tmp_path / kind
        assert export("linuxcnc-comp", out, "--comp-file-type", kind, machine=GANTRY, errors=errors) == 0
        assert f"COMP_FILE_TYPE = {kind}" in (out / "joints.ini").read_text()
        added.append(control_files.linuxcnc(out)["X", "X"])
    np.testing.assert_allclose(added[0], added[1], atol=2e-7)
    np.testing.assert_allclose(added[1][1], 1e-5 * added[1][0], atol=1e-7)
    capsys.readouterr()
    assert export("isg-csv", tmp_path / "x.csv", "--comp-file-type", "1", machine=GANTRY, errors=errors) == 2
    assert "--comp-file-type: only linuxcnc-comp has types of files" in capsys.readouterr().err
    assert not (tmp_path / "x.csv").exists()


def test_the_files_agree_with_predict(tmp_path: Path) -> None:
    """Both commands, on a machine of which the tables hold everything at this point."""
    errors = values(tmp_path)
    for name in ("siemens-enc", "siemens-cec"):
        assert export(name, tmp_path / name, machine=GANTRY, errors=errors) == 0
    tables = {**control_files.siemens_enc((tmp_path / "siemens-enc").read_text())}
    tables |= control_files.siemens_cec((tmp_path / "siemens-cec").read_text())
    rows = [(x, y, -150.0) for x in (0.0, 1000.0, 2990.0) for y in (0.0, 700.0, 1500.0)]
    (tmp_path / "p.csv").write_text("X,Y,Z\n" + "".join(f"{x},{y},{z}\n" for x, y, z in rows))
    words = ["predict", GANTRY, "--errors", errors, "--at", tmp_path / "p.csv", "--out", tmp_path / "d.csv"]
    assert main(list(map(str, [*words, "--kernels", KERNELS, "--datum", "home"]))) == 0
    predicted = pl.read_csv(tmp_path / "d.csv")
    for of in "XYZ":
        off = sum(np.interp(predicted[by].to_numpy(), *tables[of, by][:2]) for by in "XYZ")
        np.testing.assert_allclose(off, predicted[f"d{of.lower()}"].to_numpy(), atol=3e-6)


def test_values_that_do_not_fit_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    errors = values(tmp_path, fit={"state": "misfit", "chi2": 50.0, "runs": ["X1"]})
    assert export("siemens-enc", tmp_path / "out", machine=GANTRY, errors=errors) == 2
    assert "--accept-misfit" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    assert export("siemens-enc", tmp_path / "out", "--accept-misfit", machine=GANTRY, errors=errors) == 0


@pytest.mark.parametrize("name", FORMATS)
def test_what_no_reading_determined_is_refused_by_max_u(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    errors = values(tmp_path, undetermined=[{"combination": "EZX", "parameters": ["EZX"]}])
    assert export(name, tmp_path / "out", "--max-u", "1", machine=GANTRY, errors=errors) == 1
    shown = capsys.readouterr().out
    assert "neither readings nor a prior determine (EZX)" in shown
    assert "not written: an uncertainty is not known" in shown
    assert not (tmp_path / "out").exists()
    assert export(name, tmp_path / "out", machine=GANTRY, errors=errors) == 1  # without a limit, too
    assert "--accept-u" in capsys.readouterr().out
    assert not (tmp_path / "out").exists()
    assert export(name, tmp_path / "out", machine=GANTRY, errors=values(tmp_path)) == 0
    assert export(name, tmp_path / "out2", "--max-u", "0.0001", machine=GANTRY, errors=values(tmp_path)) == 1


def test_values_that_are_more_uncertain_than_large_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    uncertain = {"EXX": {"basis": "polynomial", "powers": [1], "coefficients": [1e-6], "u": [1e-5]}}
    errors = values(tmp_path, motion_errors=uncertain, parameters={})
    assert export("siemens-enc", tmp_path / "out", machine=GANTRY, errors=errors) == 1
    assert "no better than doing nothing" in capsys.readouterr().out
    assert not (tmp_path / "out").exists()
    assert export("siemens-enc", tmp_path / "out", "--accept-u", machine=GANTRY, errors=errors) == 0


def test_corrections_beyond_what_a_machine_has_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    large = {"EXX": {"basis": "polynomial", "powers": [1], "coefficients": [4e-4]}}  # 1.2 mm over 3 m
    errors = values(tmp_path, motion_errors=large)
    assert export("siemens-enc", tmp_path / "out", machine=GANTRY, errors=errors) == 1
    assert "the tool point is off by 1.2" in capsys.readouterr().out
    assert export("siemens-enc", tmp_path / "out", "--max-correction", "2", machine=GANTRY, errors=errors) == 0
    assert export("siemens-enc", tmp_path / "no", "--max-correction", "0.01", machine=GANTRY, errors=errors) == 1


def test_the_tool_point_is_that_which_is_asked_for(tmp_path: Path) -> None:
    turning = {"EAX": {"basis": "polynomial", "powers": [1], "coefficients": [1e-8]}}
    errors = values(tmp_path, motion_errors=turning, parameters={})
    for length in (0, 100):
        words = ["--tool-point", f"0,0,-{length}"]
        assert export("siemens-cec", tmp_path / f"cec{length}", *words, machine=GANTRY, errors=errors) == 0
    short, long = (control_files.siemens_cec((tmp_path / f"cec{n}").read_text())["Y", "X"][1] for n in (0, 100))
    # a turn about X by 1e-8 rad/mm moves a point 100 mm below towards Y+ by 1 um per metre
    np.testing.assert_allclose(long[-1] - short[-1], 100 * 3000 * 1e-8, atol=2e-6)


def test_more_positions_than_the_control_takes_are_a_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert export("linuxcnc-comp", tmp_path / "out", "--step", "1") == 2
    assert (
        "needs 701 positions of Y with a step of 1 (1843 of all axes), and the control takes 256"
        in capsys.readouterr().err
    )
    assert export("linuxcnc-comp", tmp_path / "out", "--step", "5") == 0


def test_what_a_machine_has_not_is_a_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert export("isg-csv", tmp_path / "out") == 2
    assert "positive commands of Y move the tool in the negative direction" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["isg-csv", "siemens-enc", "siemens-cec", "heidenhain-com", "linuxcnc-comp"])
def test_a_step_far_too_small_is_a_fault_that_says_which_would_do(
    tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert export(name, tmp_path / "out", "--step", "0.001") == 2
    told = capsys.readouterr().err
    assert "needs 700001 positions of Y with a step of 0.001 (1840003 of all axes)" in told
    assert not (tmp_path / "out").exists()
    step = told.split("--step ")[1].split(" ")[0]
    if name != "isg-csv":  # which cannot hold this machine
        assert export(name, tmp_path / "out", "--step", step) == 0


@pytest.mark.parametrize("curves", [{}, {"EXX": {"basis": "table", "positions": [0, 100], "values": [0, 0]}}])
def test_error_values_that_are_all_zero_are_said(
    tmp_path: Path, curves: dict[str, object], capsys: pytest.CaptureFixture[str]
) -> None:
    errors = tmp_path / "e.json"
    dimensions = {"q_wx": 5.0}
    errors.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "parameters": dimensions, "motion_errors": curves}))
    said = "every error value is zero or missing"
    assert export("siemens-enc", tmp_path / "out", errors=errors) == 0
    assert said in capsys.readouterr().out
    (tmp_path / "part.nc").write_text("G21 G90\nG1 X270. Y350. Z150. F1000\n")
    words = ["compensate", DMU60P, "--errors", errors, tmp_path / "part.nc", "--out", tmp_path / "c.nc"]
    assert main(list(map(str, [*words, "--kernels", KERNELS]))) == 0
    assert said in capsys.readouterr().out
    assert export("siemens-enc", tmp_path / "out") == 0
    assert said not in capsys.readouterr().out


def test_a_module_has_no_step(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert export("linuxcnc-kins", tmp_path / "out", "--step", "5") == 2
    assert "--format linuxcnc-kins: has no positions with a step between them" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_module_is_made_of_kernels_as_they_were_derived(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kernels = tmp_path / "generated"
    shutil.copytree(KERNELS / "dmu60p", kernels / "dmu60p")
    words: list[str | Path] = ["--kernels", kernels]
    assert export("linuxcnc-kins", tmp_path / "good", *words) == 0
    assert export("linuxcnc-kins", kernels / "dmu60p", *words) == 2
    assert f"{kernels / 'dmu60p' / 'control.c'}: control.c of --out lies among the kernels" in capsys.readouterr().err
    control, manifest = kernels / "dmu60p" / "control.c", kernels / "dmu60p" / "manifest.json"
    control.write_text(control.read_text().replace("0", "1", 1))
    assert export("linuxcnc-kins", tmp_path / "out", *words) == 2
    told = capsys.readouterr().err
    assert f"{control}: is not as it was derived" in told
    assert f"run: trueaxis derive {DMU60P} --out {kernels}" in told
    record = json.loads(manifest.read_text())
    del record["files"]["control.c"]  # as derived by earlier versions
    manifest.write_text(json.dumps(record))
    assert export("linuxcnc-kins", tmp_path / "out", *words) == 2
    assert f"{control}: was not derived with these kernels; run: trueaxis derive" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
    assert export("linuxcnc-comp", tmp_path / "tables", *words) == 0


def test_a_module_that_would_stop_within_the_travel_is_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    large = {"EXX": {"basis": "polynomial", "powers": [1], "coefficients": [2e-3]}}  # 6 mm over 3 m
    errors = values(tmp_path, motion_errors=large)
    spec = tmp_path / GANTRY.name
    spec.write_text(GANTRY.read_text() + "\n[prior]\ntranslation_um = 100.0\n")  # else nobody believes the 6 mm
    words = ["--max-correction", "10"]
    assert export("linuxcnc-kins", tmp_path / "out", *words, machine=spec, errors=errors) == 1
    assert "within the travel, and the module corrects 5 mm at most" in capsys.readouterr().out
    assert not (tmp_path / "out").exists()
