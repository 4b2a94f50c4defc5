"""Angle instruments on the command line: planned, simulated, identified, diagnosed; figures in microradians."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest

from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main

ERRORS = ROOT / "machines" / "dmu60p_errors.json"
KNOWN = {"q_wx": 270.0, "q_wy": -350.0, "q_wz": 12.5, "q_Tx": 1.25, "q_Ty": 3.0, "q_Tz": 400.0}
TRAVEL = {"X": 540.0, "Y": 700.0, "Z": 600.0}
ACROSS = {"X": "bc", "Y": "ac", "Z": "ab"}  # pitch and yaw
WIDTH = 8e-6  # rad, lost motion of the yaw of X
ZEROS = np.array([4.0, -6.0, 3.0, 2.0, -5.0, 1.0]) * 1e-6


def runs() -> str:
    text = 'schema = 1\nmachine = "dmu60p"\n'
    number = "xyz".index
    for axis in "XYZ":
        on = "workpiece" if axis == "Y" else "tool"
        unit = [float(letter == axis.lower()) for letter in "xyz"]
        text += (
            f'[[run]]\nid = "{axis}"\ninstrument = "laser"\ndirection = {unit}\n'
            f'target = {{ on = "{on}", point = [100.0, 50.0, 30.0] }}\n'
        )
        for about in ACROSS[axis]:
            unit = [float(number("xyz"["abc".index(about)]) == k) for k in range(3)]
            text += (
                f'[[run]]\nid = "{axis}{about}"\ninstrument = "angle"\ndevice = "A"\ndirection = {unit}\n'
                f'target = {{ on = "{on}" }}\n'
            )
    return text + "[device.A]\nresolution_urad = 0.01\n"


def rows() -> list[str]:
    found = ["run,seq,time_s,X,Y,Z,dir_X,dir_Y,dir_Z,reading"]
    clock = 0
    for axis in "XYZ":
        for run in (axis, *(axis + about for about in ACROSS[axis])):
            steps = np.linspace(0.03, 0.97, 15) * TRAVEL[axis]
            ways = ([(at, 1) for at in steps] + [(at, -1) for at in steps[::-1]]) * 3
            for seq, (at, way) in enumerate(ways):
                place = [f"{at:.3f}" if one == axis else "0" for one in "XYZ"]
                way_of = [str(way) if one == axis else "0" for one in "XYZ"]
                found.append(",".join([run, str(seq), str(clock), *place, *way_of, ""]))
                clock += 6
    return found


def spoilt(folder: Path, width: float) -> None:
    """Zeros of the angle runs, and lost motion in the yaw of X, put into readings as they are in the file."""
    path = folder / "readings.csv"
    with path.open() as lines:
        table = list(csv.DictReader(lines))
    zeros = dict(zip(sorted({row["run"] for row in table if len(row["run"]) == 2}), ZEROS.tolist(), strict=True))
    for row in table:
        value = float(row["reading"]) + zeros.get(row["run"], 0.0)
        value += 0.5 * width * float(row["dir_X"]) * (row["run"] == "Xc")
        row["reading"] = repr(value)
    text = "\n".join([",".join(table[0]), *(",".join(row.values()) for row in table)])
    path.write_text(text + "\n")


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("angles")
    plan = folder / "plan"
    plan.mkdir()
    (plan / "setup.toml").write_text(runs())
    (plan / "readings.csv").write_text("\n".join(rows()) + "\n")
    known = {"schema": 1, "machine": "dmu60p", "parameters": KNOWN}
    (folder / "known.json").write_text(json.dumps(known))
    for name, width in (("as_modelled", 0.0), ("lost_motion", WIDTH)):
        words = ["simulate", str(DMU60P), "--errors", str(ERRORS), "--data", str(plan), "--out", str(folder / name)]
        words += ["--noise-um", "0.2", "--noise-urad", "0.4", "--seed", "8", "--kernels", str(ROOT / "generated")]
        assert main(words) == 0
        spoilt(folder / name, width)
    return folder


def identified(folder: Path, data: Path, out: Path, *options: str, ends: int = 0) -> dict[str, object]:
    report = out.with_suffix(".report.json")
    words = ["identify", str(DMU60P), "--data", str(data), "--out", str(out), "--known", str(folder / "known.json")]
    words += ["--report", str(report), "--kernels", str(ROOT / "generated"), *options]
    assert main(words) == ends
    found: dict[str, object] = json.loads(report.read_text())
    return found


def test_angles_are_told_by_angle_runs_and_left_on_the_prior_by_lasers(measured: Path, tmp_path: Path) -> None:
    lines = tmp_path / "lines"
    lines.mkdir()
    parts = runs().partition("[device")[0].split("[[run]]")
    kept = [part for part in parts if '"angle"' not in part]
    (lines / "setup.toml").write_text("[[run]]".join(kept))
    text = (measured / "as_modelled" / "readings.csv").read_text().splitlines()
    (lines / "readings.csv").write_text("\n".join(row for row in text if len(row.split(",")[0]) != 2) + "\n")
    states = {}
    for name, data in (("lines", lines), ("angles", measured / "as_modelled")):
        out = tmp_path / f"{name}.json"
        identified(measured, data, out)
        states[name] = json.loads(out.read_text())
    angular = [f"E{about.upper()}{axis}" for axis in "XYZ" for about in ACROSS[axis]]
    assert not [name for name in angular if states["lines"]["determined"][name] == "data"]
    assert all(states["angles"]["determined"][name] == "data" for name in angular)
    truth = json.loads(ERRORS.read_text())["motion_errors"]
    for name in angular:
        at = np.linspace(0.0, TRAVEL[name[2]], 21)
        right = sum(c * at**p for c, p in zip(truth[name]["coefficients"], truth[name]["powers"], strict=True))
        curve = states["angles"]["motion_errors"][name]
        polynomials = np.polynomial.legendre.Legendre
        found = polynomials([0.0, *curve["coefficients"]], domain=curve["range"])(at)
        off = found - found[0] - right
        assert np.sqrt(np.mean(off**2)) < 1.0e-6, name  # of 30 to 50 urad


def test_figures_of_angles_are_in_microradians(
    measured: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    report = identified(measured, measured / "as_modelled", tmp_path / "e.json")
    told = capsys.readouterr().out
    assert "0.4 urad" in told or " urad; noise of a reading" in told
    assert 0.3 < report["residual_rms_urad"] < 0.5  # type: ignore[operator]
    assert 0.1 < report["residual_rms_um"] < 0.3  # type: ignore[operator]
    (angle,) = [one for one in report["noise_groups"] if one["group"].startswith("angle")]  # type: ignore[attr-defined]
    assert math.isclose(angle["noise_urad"], 0.4, rel_tol=0.25)
    assert "noise_um" not in angle
    of_run = {one["run"]: one for one in report["quality"]["runs"]}  # type: ignore[index]
    assert "rms_urad" in of_run["Xb"]
    assert "rms_um" in of_run["X"]


def test_the_noise_of_angles_is_stated_by_itself(
    measured: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "e.json"
    both = identified(measured, measured / "as_modelled", out, "--noise-um", "0.2", "--noise-urad", "0.4")
    assert (both["noise_um"], both["noise_urad"]) == (pytest.approx(0.2), pytest.approx(0.4))
    words = ["identify", str(DMU60P), "--data", str(measured / "as_modelled"), "--out", str(tmp_path / "no.json")]
    words += ["--known", str(measured / "known.json"), "--kernels", str(ROOT / "generated")]
    capsys.readouterr()
    for options, said in ((["0.2"], "--noise-urad S"), (["laser=0.2,angle=0.4"], "reads an angle")):
        assert main([*words, "--noise-um", *options]) == 2
        assert said in capsys.readouterr().err
    assert not (tmp_path / "no.json").exists()


def test_lost_motion_of_a_rotation_is_named_and_what_is_gained_is_in_microradians(
    measured: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    identified(measured, measured / "lost_motion", tmp_path / "e.json", ends=1)  # a misfit: the repeats tell the noise
    out = tmp_path / "diagnosis"
    words = ["diagnose", str(DMU60P), "--errors", str(tmp_path / "e.json"), "--data", str(measured / "lost_motion")]
    assert main([*words, "--out", str(out), "--kernels", str(ROOT / "generated")]) in (0, 1)
    found = json.loads((out / "diagnosis.json").read_text())
    assert found["verdict"] == "explained"
    (cause,) = found["causes"]
    assert (cause["effect"], cause["component"]) == ("backlash", "ECX")
    width = cause["parameters"]["width"]
    assert abs(width["value"] - WIDTH) < 2.0 * width["u"] < 0.3 * WIDTH
    assert cause["evidence"]["held_out_gain"] > 0.2
    gain = found["gain"]
    assert gain["held_out_rms_urad"]["extended"] == pytest.approx(0.4, rel=0.25)
    assert gain["held_out_rms_urad"]["refitted"] > 1.2 * gain["held_out_rms_urad"]["extended"]
    assert gain["held_out_rms_um"]["extended"] == pytest.approx(0.2, rel=0.25)
    assert [one for one in found["noise"] if one["instrument"] == "angle" and "white_urad" in one]
    assert "urad" in capsys.readouterr().out


def test_a_first_plan_with_angles_tells_the_angular_errors(tmp_path: Path) -> None:
    report = tmp_path / "plan.json"
    words = ["plan", str(DMU60P), "--with", "angle", "--out", str(tmp_path / "plan"), "--report", str(report)]
    assert main([*words, "--kernels", str(ROOT / "generated"), "--noise-urad", "0.5"]) == 0
    said = json.loads(report.read_text())
    text = (tmp_path / "plan" / "setup.toml").read_text()
    assert 'instrument = "angle"' in text
    assert '"urad": [' in json.dumps(said)
