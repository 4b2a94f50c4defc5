"""`trueaxis fit`: from tables to polynomials, on files."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.machines import ROOT
from trueaxis.cli.main import main

MACHINE = str(ROOT / "machines" / "dmu60p.toml")


def tables(folder: Path, **components: tuple[list[float], list[float]]) -> Path:
    path = folder / "points.json"
    curves = {
        name: {"basis": "table", "positions": positions, "values": values}
        for name, (positions, values) in components.items()
    }
    tree = {"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": 1e-5}, "motion_errors": curves}
    path.write_text(json.dumps(tree))
    return path


def test_a_cubic_comes_back_and_all_else_stays(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    x = np.linspace(0.0, 540.0, 28)
    noise = np.random.default_rng(3).normal(scale=1e-6, size=28) * (x > 0)
    points = tables(tmp_path, EXX=(x.tolist(), (2e-5 * x - 4e-11 * x**3 + noise).tolist()))
    out, picture = tmp_path / "fitted.json", tmp_path / "p.png"
    arguments = ["fit", MACHINE, "--errors", str(points), "--out", str(out), "--picture", str(picture)]
    assert main(arguments) == 0
    assert "adjusted R^2" not in capsys.readouterr().out, "a line for each curve"
    assert main([*arguments, "--statistics"]) == 0
    found = json.loads(out.read_text())
    assert found["parameters"] == {"eps_xy": 1e-5}
    curve = found["motion_errors"]["EXX"]
    value = sum(c * 400.0**p for p, c in zip(curve["powers"], curve["coefficients"], strict=True))
    assert value == pytest.approx(2e-5 * 400 - 4e-11 * 400**3, abs=2e-6)
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "adjusted R^2" in capsys.readouterr().out


def test_noise_alone_is_no_polynomial_and_says_so(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    # Alternating values: no polynomial of low order follows them.
    x = np.linspace(0.0, 540.0, 28)
    points = tables(tmp_path, EYX=(x.tolist(), [0.0, *(1e-3 * (-1.0) ** k for k in range(27))]))
    assert main(["fit", MACHINE, "--errors", str(points), "--out", str(tmp_path / "f.json"), "--max-order", "2"]) == 1
    assert "EYX is left at zero" in capsys.readouterr().out


@pytest.mark.parametrize("extra", [["--max-order", "0"], ["--alpha", "1.5"]])
def test_options_out_of_range_are_faults(tmp_path: Path, extra: list[str]) -> None:
    points = tables(tmp_path, EXX=([0.0, 1.0, 2.0, 3.0], [0.0, 1e-3, 2e-3, 3e-3]))
    out = tmp_path / "f.json"
    with pytest.raises(SystemExit, match="2"):
        main(["fit", MACHINE, "--errors", str(points), "--out", str(out), *extra])
    assert not out.exists()


@pytest.mark.parametrize(
    ("curves", "problem"),
    [
        ({}, "has no table of three positions or more"),
        ({"EXX": "table"}, "has no table of three positions or more"),
        ({"EXX": "table", "EYX": "polynomial"}, "has no table of three positions or more"),
        ({"EYX": "polynomial"}, "are polynomials already, without a table: there is nothing to fit"),
    ],
    ids=range(4),
)
def test_nothing_to_fit_is_a_fault(
    tmp_path: Path, curves: dict[str, str], problem: str, capsys: pytest.CaptureFixture[str]
) -> None:
    by_basis = {
        "table": {"basis": "table", "positions": [0.0, 1.0], "values": [0.0, 1e-3]},
        "polynomial": {"basis": "polynomial", "powers": [1], "coefficients": [1e-6]},
    }
    path, out = tables(tmp_path), tmp_path / "f.json"
    tree = json.loads(path.read_text())
    tree["motion_errors"] = {name: by_basis[basis] for name, basis in curves.items()}
    path.write_text(json.dumps(tree))
    assert main(["fit", MACHINE, "--errors", str(path), "--out", str(out)]) == 2
    assert f"trueaxis: {path}: motion_errors: {problem}" in capsys.readouterr().err
    assert not out.exists()
