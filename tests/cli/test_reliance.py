"""What rests on the readings and what does not, from `identify` to `fit` and `predict`, as a user runs them."""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from tests.identification.test_command import ERRORS, KERNELS, MACHINE, STEPWISE, identify, simulated
from trueaxis.cli.main import main
from trueaxis.machine import read_machine
from trueaxis.model.covariance import digest_of_numbers
from trueaxis.model.measured_range import BeyondMeasured
from trueaxis.model.model import load_errors
from trueaxis.reporting.reliance import travel_sentences

POINTS = "X,Y,Z,tool_z\n0,0,0,0\n300,0,0,0\n0,0,400,0\n540,700,600,0\n"


def predict(folder: Path, errors: Path, *options: str, points: str = POINTS) -> int:
    (folder / "points.csv").write_text(points)
    files = ["--errors", str(errors), "--at", str(folder / "points.csv"), "--out", str(folder / "out.csv")]
    return main(["predict", str(MACHINE), *files, *options, *KERNELS])


def fit(errors: Path, out: Path, *options: str) -> int:
    return main(["fit", str(MACHINE), "--errors", str(errors), "--out", str(out), *options, *KERNELS])


@pytest.fixture(scope="module")
def published(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the stepwise method makes of the published points, which leave EZZ, EAZ and EBZ open."""
    folder = tmp_path_factory.mktemp("published")
    data = simulated(folder, "dmu60p_runs", "--noise-um", "0.3")
    assert identify(data, folder / "e.json", *STEPWISE) == 0
    return folder / "e.json"


@pytest.fixture(scope="module")
def regular(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("regular")
    data = simulated(folder, "dmu60p_regular_runs", "--noise-um", "0.3")
    assert identify(data, folder / "e.json", *STEPWISE) == 0
    return folder / "e.json"


def test_a_prediction_on_open_values_has_no_u_and_says_so(
    tmp_path: Path, published: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert predict(tmp_path, published) == 0
    table = pl.read_csv(tmp_path / "out.csv")
    assert table["u_dx"][1] > 0.0  # along X itself
    assert table["u_dz"].null_count() == 3  # all but home
    said = capsys.readouterr().out
    assert "at 3 of 4 positions the deviation rests on values that neither readings nor a prior determine" in said
    assert "EZZ" in said


@pytest.mark.parametrize("limit", ["1.0", "1000"])
def test_what_is_open_counts_as_infinite(tmp_path: Path, published: Path, limit: str) -> None:
    assert predict(tmp_path, published, "--max-u", limit) == 1
    assert not (tmp_path / "out.csv").exists()
    assert fit(published, tmp_path / "f.json", "--max-u", limit) == 1
    assert not list(tmp_path.glob("f.*"))


def test_max_u_is_the_largest_u_of_the_points(tmp_path: Path, regular: Path) -> None:
    assert predict(tmp_path, regular) == 0
    table = pl.read_csv(tmp_path / "out.csv").select("u_dx", "u_dy", "u_dz")
    largest = float(np.nanmax(table.to_numpy()))
    assert 3e-4 < largest < 0.1
    (tmp_path / "out.csv").unlink()
    assert predict(tmp_path, regular, "--max-u", repr(0.999 * largest)) == 1
    assert not (tmp_path / "out.csv").exists()
    assert predict(tmp_path, regular, "--max-u", repr(1.001 * largest)) == 0


def test_polynomials_keep_the_uncertainty_of_their_tables(
    tmp_path: Path, regular: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Fitting changes u, as it smooths the noise of each component apart from the others, and never drops it."""
    fitted = tmp_path / "f.json"
    assert fit(regular, fitted) in (0, 1)
    assert "largest standard uncertainty of the tool point over the travel" in capsys.readouterr().out
    assert json.loads(fitted.read_text())["covariance"]["file"] == "f.npz"
    u = []
    for errors in (regular, fitted):
        assert predict(tmp_path, errors) == 0
        u.append(pl.read_csv(tmp_path / "out.csv").select("u_dx", "u_dy", "u_dz").to_numpy()[1:])
    assert np.isfinite(u[1]).all()
    assert u[1][0].max() < 1.01 * u[0][0].max()  # in the middle of one axis, many positions take part
    assert u[1][2].max() == pytest.approx(u[0][2].max(), rel=0.5)  # at the ends few do


@pytest.mark.parametrize("curves", ["polynomial", "held-out"])
def test_identified_polynomials_have_the_same_u_as_fitted_ones(tmp_path: Path, curves: str) -> None:
    data = simulated(tmp_path, "dmu60p_regular_runs", "--noise-um", "0.3")
    assert identify(data, tmp_path / "e.json", *STEPWISE, "--curves", curves) == 0
    tree = json.loads((tmp_path / "e.json").read_text())
    assert tree["motion_errors"]["EXX"]["measured"] == [0.0, 540.0]
    assert predict(tmp_path, tmp_path / "e.json") == 0
    assert pl.read_csv(tmp_path / "out.csv").select("u_dx", "u_dy", "u_dz").null_count().row(0) == (0, 0, 0)


def test_the_datum_home_is_the_difference_to_home(tmp_path: Path, regular: Path) -> None:
    tables = []
    for datum in ("machine", "home"):
        assert predict(tmp_path, regular, "--datum", datum, points=POINTS.replace("600,0", "600,25")) == 0
        tables.append(pl.read_csv(tmp_path / "out.csv"))
    home = pl.DataFrame({"X": [0.0], "Y": [0.0], "Z": [0.0], "tool_z": [25.0]})
    assert predict(tmp_path, regular, points=home.write_csv()) == 0
    at_home = pl.read_csv(tmp_path / "out.csv")
    for column in ("dx", "dy", "dz"):
        assert tables[1][column][0] == 0.0
        assert tables[1][column][3] == pytest.approx(tables[0][column][3] - at_home[column][0], abs=1e-15)


def test_use_beyond_the_measured_range_is_said(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], regular: Path
) -> None:
    tree = json.loads(regular.read_text())
    curve: dict[str, Any] = {"basis": "polynomial", "powers": [1], "coefficients": [1e-6], "measured": [20.0, 400.0]}
    path = tmp_path / "e.json"
    path.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "motion_errors": {"EXX": curve}}))
    assert tree["machine"] == "dmu60p"
    assert predict(tmp_path, path) == 0
    said = capsys.readouterr().out
    assert "3 of 4 positions lie beyond the measured range: EXX from X = 20 to 400 mm, used at X = 0 to 540" in said


def test_tables_beyond_the_measured_range_are_told_without_counting_their_rows() -> None:
    """Ends of the travel are rows of every table; where u holds beyond what was measured, u says all."""
    beyond = BeyondMeasured(axis="X", components=("EXX",), low=20.0, high=400.0, lowest=0.0, highest=540.0, count=99)
    (said,) = travel_sentences([beyond, replace(beyond, by_prior=True)])
    assert said.startswith("EXX: measured from X = 20 to 400 mm, written for X = 0 to 540; no reading supports")


def test_a_misfit_is_predicted_with_a_warning_and_fitted_on_request_alone(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], regular: Path
) -> None:
    tree = json.loads(regular.read_text()) | {"fit": {"state": "misfit", "chi2": 961.0, "runs": ["Y-2", "X-1"]}}
    del tree["covariance"]
    path, out = tmp_path / "e.json", tmp_path / "f.json"
    path.write_text(json.dumps(tree))
    assert predict(tmp_path, path) == 0
    assert "do not fit their readings (chi2 per degree of freedom 961), worst in Y-2, X-1" in (capsys.readouterr().out)
    assert fit(path, out) == 2
    assert "--accept-misfit" in capsys.readouterr().err
    assert not out.exists()
    assert fit(path, out, "--accept-misfit") in (0, 1)
    assert json.loads(out.read_text())["fit"]["state"] == "misfit"


def test_fit_does_without_kernels_unless_a_limit_asks_for_them(tmp_path: Path, regular: Path) -> None:
    nowhere = ["--kernels", str(tmp_path / "none")]
    arguments = ["fit", str(MACHINE), "--errors", str(regular), "--out", str(tmp_path / "f.json")]
    assert main([*arguments, *nowhere]) in (0, 1)
    assert main([*arguments, *nowhere, "--max-u", "1"]) == 2


def test_absurd_values_are_faults_of_every_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    tree = json.loads(ERRORS.read_text())
    tree["motion_errors"]["EXX"] = {"basis": "table", "positions": [0, 100, 200, 540], "values": [0, 1e308, 0, 0]}
    path = tmp_path / "e.json"
    path.write_text(json.dumps(tree))
    assert predict(tmp_path, path) == 2
    assert fit(path, tmp_path / "f.json") == 2
    assert capsys.readouterr().err.count("motion_errors.EXX: is not finite") == 0
    assert [file.name for file in tmp_path.glob("*") if file.name not in ("e.json", "points.csv")] == []


@pytest.fixture(scope="module")
def estimated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the estimate makes of the regular plan."""
    folder = tmp_path_factory.mktemp("estimated")
    data = simulated(folder, "dmu60p_regular_runs", "--noise-um", "0.3")
    assert identify(data, folder / "e.json", "--method", "global", "--report", str(folder / "r.json")) == 0
    return folder / "e.json"


def test_the_parts_of_u_are_written_and_predicted(
    tmp_path: Path, estimated: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    tree = json.loads(estimated.read_text())
    assert set(tree["determined"].values()) <= {"data", "partly", "prior"}
    assert {"EXX", "eps_xy"} <= set(tree["determined"])
    curve = tree["motion_errors"]["EXX"]
    np.testing.assert_allclose(np.hypot(curve["u_readings"], curve["u_prior"]), curve["u"], rtol=1e-6)
    assert np.hypot(tree["u_readings"]["eps_xy"], tree["u_prior"]["eps_xy"]) == pytest.approx(tree["u"]["eps_xy"])
    report = json.loads((estimated.parent / "r.json").read_text())
    assert report["components"][0]["u_prior_rms"] > 0.0
    assert predict(tmp_path, estimated, "--datum", "home") == 0
    table = pl.read_csv(tmp_path / "out.csv")
    u, prior = (table.select(f"{kind}_d{axis}" for axis in "xyz").to_numpy()[1:] for kind in ("u", "u_prior"))
    assert (prior <= u).all()
    assert prior.max() > 0.0
    capsys.readouterr()
    words = ["compensate", str(MACHINE), "--errors", str(estimated), str(tmp_path / "part.nc")]
    (tmp_path / "part.nc").write_text("G21 G90\nG1 X270. Y350. Z150. F1000\nX280.\n")
    assert main([*words, "--out", str(tmp_path / "c.nc"), *KERNELS]) == 0
    said = capsys.readouterr().out
    assert "largest part from [prior] of the spec" in said

    def figure(pattern: str) -> float:
        (told,) = re.findall(pattern, said)
        return float(told)

    row = figure(r"u of the values, from home +(\S+)")
    assert row == pytest.approx(figure(r"in one coordinate: (\S+) um"), rel=5e-3)
    corrected = figure(r"as programmed +\S+ +\S+ +(\S+)")
    assert ("WARNING: the tool point is known" in said) == (row > corrected)


def test_files_without_the_parts_are_read(tmp_path: Path, estimated: Path) -> None:
    """As identify wrote them before: u is the same, its parts are not known."""
    tree = json.loads(estimated.read_text())
    for key in ("u_readings", "u_prior", "determined"):
        del tree[key]
    for curve in tree["motion_errors"].values():
        del curve["u_readings"], curve["u_prior"]
    with np.load(estimated.with_suffix(".npz")) as archive:
        arrays: dict[str, Any] = {key: np.array(archive[key]) for key in archive}
    (tmp_path / "e.json").write_text(json.dumps(tree))
    head = json.loads(arrays["head"].tobytes())
    del head["prior_columns"]
    head["sha256_of_values"] = digest_of_numbers(load_errors(tmp_path / "e.json", read_machine(MACHINE)))
    arrays["head"] = np.frombuffer(json.dumps(head).encode(), dtype=np.uint8)
    np.savez(tmp_path / "e.npz", allow_pickle=False, **arrays)
    tables = []
    for errors in (estimated, tmp_path / "e.json"):
        assert predict(tmp_path, errors) == 0
        tables.append(pl.read_csv(tmp_path / "out.csv"))
    np.testing.assert_allclose(tables[1]["u_dx"].to_numpy(), tables[0]["u_dx"].to_numpy())
    assert tables[1].select("u_prior_dx", "u_prior_dy", "u_prior_dz").null_count().row(0) == (4, 4, 4)


def test_values_without_their_covariance_keep_the_parts(tmp_path: Path, estimated: Path) -> None:
    """As if independent: each coefficient with its parts."""
    tree = json.loads(estimated.read_text())
    del tree["covariance"]
    (tmp_path / "e.json").write_text(json.dumps(tree))
    assert predict(tmp_path, tmp_path / "e.json") == 0
    table = pl.read_csv(tmp_path / "out.csv")
    u, prior = (table[column].to_numpy() for column in ("u_dx", "u_prior_dx"))
    assert (prior <= u).all()
    assert prior.max() > 0.0


@pytest.mark.parametrize(
    ("change", "words"),
    [({"determined": {"EXX": "surely"}}, "determined.EXX"), ({"u_prior": {"eps_xy": -1.0}}, "u_prior.eps_xy")],
)
def test_parts_that_identify_does_not_write_are_faults(
    tmp_path: Path, estimated: Path, change: dict[str, Any], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    tree = json.loads(estimated.read_text()) | change
    (tmp_path / "e.json").write_text(json.dumps(tree))
    (tmp_path / "e.npz").write_bytes(estimated.with_suffix(".npz").read_bytes())
    assert predict(tmp_path, tmp_path / "e.json") == 2
    assert words in capsys.readouterr().err
