"""Worlds and package check each other: two models that share no code read and predict the same."""

from pathlib import Path

import numpy as np
import polars as pl
import pytest

from tests.worlds.design import draw_design
from tests.worlds.files import points_csv, write_world
from tests.worlds.readings import exact_readings, measure
from tests.worlds.stale import truth_given
from tests.worlds.truth import draw_machine, random_points
from trueaxis.cli import main
from trueaxis.measure.data import read_data
from trueaxis.spec import read_machine

NM = 1e-6  # mm
TOOL = np.array([10.0, -20.0, 30.0])


def agree(seed: int, folder: Path) -> None:
    """Readings without noise, and deviations, within half a nanometre; curves are tables that are exact where asked."""
    design = draw_design(seed)
    truth = draw_machine(design.machine, seed)
    points, jac = random_points(design.machine, seed, 50), design.jacobian
    at = {axis: np.concatenate([jac.at[axis], jac.at_home[axis], points[axis]]) for axis in design.machine.axes}
    write_world(folder, design, truth, None, truth_given(truth, at))
    (folder / "points.csv").write_text(points_csv(design.machine, points, TOOL))
    spec, kernels = str(folder / "machine.toml"), str(folder / "kernels")
    assert main(["derive", spec, "--out", kernels]) == 0
    model = [spec, "--errors", str(folder / "errors.json"), "--kernels", kernels]
    assert main(["simulate", *model, "--data", str(folder / "data"), "--out", str(folder / "out")]) == 0
    assert main(["predict", *model, "--at", str(folder / "points.csv"), "--out", str(folder / "predicted.csv")]) == 0
    theirs = pl.read_csv(folder / "out" / "readings.csv")["reading"].to_numpy()
    ours = exact_readings(design, [truth])[0]
    assert np.max(np.abs(ours)) > 5e-3
    assert theirs == pytest.approx(ours, abs=0.5 * NM)
    predicted = pl.read_csv(folder / "predicted.csv").select("dx", "dy", "dz").to_numpy()
    assert predicted == pytest.approx(truth.deviation(points, TOOL), abs=0.5 * NM)


@pytest.mark.parametrize("seed", [11, 36, 45])
def test_the_package_reads_and_predicts_the_same(seed: int, tmp_path: Path) -> None:
    agree(seed, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(201, 225))
def test_the_package_reads_and_predicts_the_same_on_more_designs(seed: int, tmp_path: Path) -> None:
    agree(seed, tmp_path)


@pytest.mark.parametrize("seed", range(1, 13))
def test_the_package_takes_the_files_and_reads_what_was_written(seed: int, tmp_path: Path) -> None:
    design = draw_design(seed)
    data = measure(design, draw_machine(design.machine, seed), seed)
    write_world(tmp_path, design, draw_machine(design.machine, seed), data)
    machine = read_machine(tmp_path / "machine.toml")
    read = read_data(tmp_path / "data", machine).readings
    assert machine.axes == design.machine.axes
    assert read.reading.tolist() == data.reading.tolist()
    assert (read.time is None) == ("time_s" not in design.columns)
    assert (read.temperature is None) == ("temperature_c" not in design.columns)
    assert (read.feed is None) == ("feed" not in design.columns)
    lines = np.array([run.length is None for run in design.plan.runs])[design.plan.run]
    for axis, directions in zip(read.axes, read.directions, strict=True):
        given = design.plan.directions[axis]
        rows = np.ones(len(given), bool) if "directions" in design.columns else lines
        assert directions[rows].tolist() == given[rows].tolist()


def test_plan_judges_a_world(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    design = draw_design(39)
    write_world(tmp_path, design, draw_machine(design.machine, 1), None)
    spec, kernels = str(tmp_path / "machine.toml"), str(tmp_path / "kernels")
    assert main(["derive", spec, "--out", kernels]) == 0
    assert main(["plan", spec, "--data", str(tmp_path / "data"), "--kernels", kernels]) in (0, 1)
    assert "Traceback" not in capsys.readouterr().err
