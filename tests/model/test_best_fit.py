"""The best-fit placement against an alignment of point sets by another library, and its uncertainty against draws."""

from pathlib import Path

import numpy as np
import polars as pl
import pytest
from scipy.spatial.transform import Rotation

from tests.identification.test_command import ERRORS, KERNELS, MACHINE
from tests.machines import ROOT
from tests.model.test_uncertainty import mixed_covariance, with_steps
from trueaxis.cli.main import main
from trueaxis.model.best_fit import placements
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel, load_model
from trueaxis.model.uncertainty import tool_uncertainty

TOOL = np.array([[12.0], [-35.0], [60.0]])


@pytest.fixture(scope="module")
def model() -> MachineModel:
    return load_model(ROOT / "machines" / "dmu60p.toml", None, ROOT / "generated", backend="numpy")


def drawn_positions(model: MachineModel, count: int) -> FloatArray:
    draw = np.random.default_rng(5)
    return np.array([draw.uniform(*model.travel[axis], count) for axis in model.axes])


def aligned(points: FloatArray, deviation: FloatArray) -> FloatArray:
    """What is left of deviations after the actual points are turned and shifted onto the ideal ones (Kabsch)."""
    actual = points + deviation
    centre, ideal = actual.mean(axis=1, keepdims=True), points.mean(axis=1, keepdims=True)
    turn, _ = Rotation.align_vectors((points - ideal).T, (actual - centre).T)
    return np.asarray(turn.apply((actual - centre).T).T + ideal - points)


def test_it_is_the_alignment_of_point_sets() -> None:
    draw = np.random.default_rng(1)
    points = draw.uniform(-300.0, 500.0, (3, 40))
    turn, shift = draw.normal(size=(3, 1)) * 1e-5, draw.normal(size=(3, 1)) * 0.02
    rough = draw.normal(size=(3, 40)) * 1e-3
    left, placement = placements(points).fit(rough + shift + np.cross(turn, points, axis=0))
    np.testing.assert_allclose(left, aligned(points, rough), atol=1e-6)
    only, _ = placements(points).fit(rough)
    np.testing.assert_allclose(left, only, atol=1e-12)
    exact, placement = placements(points).fit(shift + np.cross(turn, points, axis=0))
    np.testing.assert_allclose(exact, 0.0, atol=1e-13)
    at_centre = shift + np.cross(turn, points.mean(axis=1, keepdims=True), axis=0)
    np.testing.assert_allclose(placement, np.concatenate([at_centre, turn])[:, 0], atol=1e-14)


@pytest.mark.parametrize("count", [0, 1, 2])
def test_few_points_are_no_fault(count: int) -> None:
    """One point can be put anywhere; of two what remains is their distance."""
    points = np.array([[0.0, 100.0], [10.0, 10.0], [0.0, 0.0]])[:, :count]
    left, placement = placements(points).fit(np.array([[0.0, 3e-3], [1e-3, 5e-3], [0.0, 2e-3]])[:, :count])
    expected = np.array([[-1.5e-3, 1.5e-3], [0.0, 0.0], [0.0, 0.0]])[:, :count] if count == 2 else 0.0
    np.testing.assert_allclose(left, expected, atol=1e-15)
    assert np.isfinite(placement).all()


def test_u_is_the_scatter_of_what_is_left(model: MachineModel, monkeypatch: pytest.MonkeyPatch) -> None:
    """4000 draws through the exact model, aligned by the other library."""
    covariance = mixed_covariance(model)
    assert isinstance(covariance.root, np.ndarray)
    positions = drawn_positions(model, 12)
    points = model.ideal(positions, TOOL)
    draws = 0.2 * np.random.default_rng(2).normal(size=(4000, 10)) @ covariance.root.T  # small: Kabsch is not linear
    left = [aligned(points, model.with_values(with_steps(covariance, d)).deviation(positions, TOOL)) for d in draws]
    datum = placements(points)
    u = tool_uncertainty(model, covariance, positions, TOOL, datum=datum).u
    np.testing.assert_allclose(np.std(left, axis=0), 0.2 * u, rtol=0.05, atol=1e-8)
    assert u.max() > 1e-4
    monkeypatch.setattr("trueaxis.model.uncertainty._ENTRIES", 31)  # a point at a time
    np.testing.assert_allclose(tool_uncertainty(model, covariance, positions, TOOL, datum=datum).u, u, rtol=1e-9)


def test_predict_with_it(tmp_path: Path, model: MachineModel, capsys: pytest.CaptureFixture[str]) -> None:
    positions = drawn_positions(model, 30)
    pl.DataFrame(dict(zip(model.axes, positions, strict=True))).write_csv(tmp_path / "points.csv")
    tables = []
    for datum in ("machine", "best-fit"):
        words = ["predict", str(MACHINE), "--errors", str(ERRORS), "--at", str(tmp_path / "points.csv")]
        assert main([*words, "--datum", datum, "--out", str(tmp_path / "out.csv"), *KERNELS]) == 0
        tables.append(pl.read_csv(tmp_path / "out.csv").select("dx", "dy", "dz").to_numpy().T)
    expected = aligned(model.ideal(positions, np.zeros((3, 1))), tables[0])
    np.testing.assert_allclose(tables[1], expected, atol=1e-6)
    assert np.abs(tables[1]).max() < np.abs(tables[0]).max()
    assert "the best fit shifts the workpiece by" in capsys.readouterr().out
