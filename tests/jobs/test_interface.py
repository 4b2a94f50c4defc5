"""`import trueaxis`: the same results as the commands, lazily, with arrays that are checked."""

import ast
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import polars as pl
import pytest

import trueaxis as ta
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main

ERRORS = ROOT / "machines" / "dmu60p_errors.json"
PLAN = ROOT / "machines" / "dmu60p_regular_runs"
KERNELS = str(ROOT / "generated")


@pytest.fixture(scope="module")
def model() -> ta.MachineModel:
    return ta.load_model(str(DMU60P), KERNELS)


@pytest.fixture(scope="module")
def errors(model: ta.MachineModel) -> ta.Errors:
    return ta.load_errors(str(ERRORS), model)


@pytest.fixture(scope="module")
def measured(model: ta.MachineModel, errors: ta.Errors) -> ta.DataFolder:
    return ta.simulate(model, errors, ta.load_data(str(PLAN), model), noise_um=0.3, seed=3, replace_all=True)


def test_it_is_lazy() -> None:
    script = (
        "import sys, trueaxis as ta\n"
        "assert 'numpy' not in sys.modules and not [m for m in sys.modules if m.startswith('trueaxis.')]\n"
        "ta.load_machine; ta.identify; ta.predict\n"
        "print([m for m in ('sympy', 'jinja2', 'matplotlib') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_public_name_is_there_typed_and_described() -> None:
    assert sorted(ta.__all__) == list(ta.__all__)
    assert set(ta.__all__) <= set(dir(ta))
    for name in ta.__all__:
        assert getattr(ta, name).__doc__, name
    tree = ast.parse(Path(str(ta.__file__)).read_text())
    typed = {alias.name for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) for alias in node.names}
    assert set(ta.__all__) <= typed
    with pytest.raises(AttributeError, match="no attribute 'wobble'"):
        ta.wobble  # noqa: B018
    rooms = {path.name for path in Path(str(ta.__file__)).parent.iterdir() if path.is_dir()}
    assert not rooms & set(ta.__all__)


def test_predictions_are_those_of_the_command(model: ta.MachineModel, errors: ta.Errors, tmp_path: Path) -> None:
    source = np.random.default_rng(1)
    at = {axis: source.uniform(*model.travel[axis], 12) for axis in model.axes}
    points = tmp_path / "points.csv"
    pl.DataFrame({**at, "tool_z": np.full(12, -30.0)}).write_csv(points)
    for datum in ("machine", "home", "best-fit"):
        out = tmp_path / f"{datum}.csv"
        words = [str(DMU60P), "--errors", str(ERRORS), "--at", str(points), "--out", str(out), "--datum", datum]
        assert main(["predict", *words, "--kernels", KERNELS]) == 0
        there = ta.predict(model, errors, at, tool=[0.0, 0.0, -30.0], datum=datum)
        expected = pl.read_csv(out)
        np.testing.assert_allclose(there.deviation, expected.select("dx", "dy", "dz").to_numpy().T, atol=1e-12)
        assert there.to_polars().select("dx").to_series().to_list() == pytest.approx(expected["dx"].to_list())
        assert (there.placement is not None) == (datum == "best-fit")
    with pytest.raises(ta.RefusedError, match="an uncertainty is not known, and --max-u allows 1 um") as refused:
        ta.predict(model, errors, at, max_u=1e-3)
    assert refused.value.result.deviation.shape == (3, 12)
    assert str(ta.predict(model, errors, at, datum="best-fit")).startswith("note: the best fit shifts the workpiece")
    one = ta.predict(model, errors, {"X": 100.0})
    assert one.deviation.shape == one.u.shape == (3, 1)


@pytest.mark.parametrize(
    ("positions", "tool", "told"),
    [
        ({"W": 1.0}, (0, 0, 0), "positions: dmu60p has no axis W, but X, Y, Z"),
        ({"X": [1.0, 2.0], "Y": [1.0, 2.0, 3.0]}, (0, 0, 0), "arrays of one length; given X (2,), Y (3,), Z (1,)"),
        ({"X": [[1.0]]}, (0, 0, 0), "given X (1, 1)"),
        ({"X": "far"}, (0, 0, 0), "positions['X']: expected numbers"),
        ({"X": [1.0, np.nan]}, (0, 0, 0), "positions['X']: expected finite numbers; 1 are not"),
        (np.zeros((2, 5)), (0, 0, 0), "positions: expected shape (3, n), rows X, Y, Z; given (2, 5)"),
        (np.zeros((3, 5)), np.zeros((3, 4)), "tool: expected shape (3,) or (3, 5), mm; given (3, 4)"),
    ],
)
def test_arrays_of_another_shape_are_told(
    model: ta.MachineModel, errors: ta.Errors, positions: object, tool: object, told: str
) -> None:
    with pytest.raises(ValueError, match=re.escape(told)):
        ta.predict(model, errors, positions, tool=tool)  # type: ignore[arg-type]


def test_readings_and_values_are_those_of_the_commands(
    model: ta.MachineModel, measured: ta.DataFolder, tmp_path: Path
) -> None:
    data, out = tmp_path / "data", tmp_path / "e.json"
    words = [str(DMU60P), "--data", str(PLAN), "--errors", str(ERRORS), "--out", str(data), "--replace"]
    assert main(["simulate", *words, "--noise-um", "0.3", "--seed", "3", "--kernels", KERNELS]) == 0
    ta.save_data(tmp_path / "own", measured)
    assert (data / "readings.csv").read_bytes() == (tmp_path / "own" / "readings.csv").read_bytes()
    assert measured.to_polars().equals(pl.read_csv(data / "readings.csv", schema=measured.to_polars().schema))

    assert main(["identify", str(DMU60P), "--data", str(data), "--out", str(out), "--kernels", KERNELS]) == 0
    found = ta.identify(model, ta.load_data(data, model))
    again = tmp_path / "again.json"
    assert ta.save_errors(again, found.errors, model) == (again.with_suffix(".npz"), again)
    assert again.read_text().replace("again.npz", "e.npz") == out.read_text()
    assert again.with_suffix(".npz").read_bytes() == out.with_suffix(".npz").read_bytes()
    assert str(found).startswith("dmu60p: method global")
    assert found._repr_html_().startswith("<pre>dmu60p: method global")
    read = ta.load_errors(again, model)
    there = ta.predict(model, read, {"X": [0.0, 270.0]}, datum="home")
    assert np.isfinite(there.u).all()


def test_wrong_arguments_and_data_are_told(model: ta.MachineModel, errors: ta.Errors, measured: ta.DataFolder) -> None:
    with pytest.raises(ValueError, match="noise_um: expected micrometres above 0; given -1"):
        ta.identify(model, measured, noise_um=-1.0)
    with pytest.raises(ValueError, match="noise_um: expected a number of micrometres, at least 0"):
        ta.simulate(model, errors, measured, noise_um=-1.0)
    with pytest.raises(ta.InputError, match="nobody"):
        ta.identify(model, measured, noise_um={"nobody": 1.0})
    with pytest.raises(ta.InputError):
        ta.load_machine("no_such.toml")


def test_derived_files_are_those_of_the_command(tmp_path: Path) -> None:
    small = ROOT / "machines" / "cframe_mill.toml"
    done = ta.derive(small, tmp_path)
    assert {path.name for path in done.files} == {
        "kernels.py",
        "kernels.c",
        "kernels.h",
        "control.c",
        "control.h",
        "equations.md",
        "manifest.json",
    }
    assert ta.derive(small, tmp_path, check=True).differences == ()
    (tmp_path / done.machine.name / "equations.md").write_text("edited")
    again = ta.derive(small, tmp_path, check=True)
    assert again.differences
    assert again.files == ()
    assert set(done.tool_ranges) <= set("XYZ")
