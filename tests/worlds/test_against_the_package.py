"""Worlds and package check each other: two models that share no code read and predict the same."""

import json
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from tests.kept import derived
from tests.worlds.design import Design, draw_design
from tests.worlds.effects import Effect
from tests.worlds.files import points_csv, write_world
from tests.worlds.readings import exact_readings, measure
from tests.worlds.stale import truth_given
from tests.worlds.test_shop import perfect
from tests.worlds.truth import draw_machine, random_points
from trueaxis.cli.main import main
from trueaxis.machine import read_machine
from trueaxis.measurement.data import read_data

TOLERANCE = 1e-8  # mm; found: 2e-12
TOOL = np.array([10.0, -20.0, 30.0])


def agree(seed: int, folder: Path) -> None:
    """Readings without noise, and deviations, to rounding; curves are tables that are exact where asked."""
    design = draw_design(seed)
    truth = draw_machine(design.machine, seed)
    points, jac = random_points(design.machine, seed, 50), design.jacobian
    at = {axis: np.concatenate([jac.at[axis], jac.at_home[axis], points[axis]]) for axis in design.machine.axes}
    write_world(folder, design, truth, None, truth_given(truth, at))
    (folder / "points.csv").write_text(points_csv(design.machine, points, TOOL))
    spec, kernels = str(folder / "machine.toml"), str(derived(folder / "machine.toml"))
    model = [spec, "--errors", str(folder / "errors.json"), "--kernels", kernels]
    assert main(["simulate", *model, "--data", str(folder / "data"), "--out", str(folder / "out")]) == 0
    assert main(["predict", *model, "--at", str(folder / "points.csv"), "--out", str(folder / "predicted.csv")]) == 0
    theirs = pl.read_csv(folder / "out" / "readings.csv")["reading"].to_numpy()
    ours = exact_readings(design, [truth])[0]
    assert np.max(np.abs(ours)) > 5e-3
    assert theirs == pytest.approx(ours, abs=TOLERANCE)
    predicted = pl.read_csv(folder / "predicted.csv").select("dx", "dy", "dz").to_numpy()
    assert predicted == pytest.approx(truth.deviation(points, TOOL), abs=TOLERANCE)


@pytest.mark.parametrize("seed", [11, 36, 45])
def test_the_package_reads_and_predicts_the_same(seed: int, tmp_path: Path) -> None:
    agree(seed, tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(201, 204))
def test_the_package_reads_and_predicts_the_same_on_more_designs(seed: int, tmp_path: Path) -> None:
    agree(seed, tmp_path)


SAME_FORM = {  # kind -> component, first parameter and the share by which the worlds' own form may differ
    "backlash": ("EXX", "width", 0.1),
    "backlash_slope": ("EXX", "change", 0.25),
    "drift": ("EXX", "rate", 0.1),
    "servo_lag": ("EXX", "tau", 0.1),
    "cross_axis": ("EXX", "k", 0.1),
    "laser_scale": ("", "k", 0.1),
    "ballbar_length": ("", "length", 0.1),
}


@pytest.mark.slow
def test_effects_have_the_sign_and_size_of_the_library(tmp_path: Path) -> None:
    """One derivation has them all; each in turn gets a value."""
    design = next(d for d in map(draw_design, range(1, 1000)) if shows_all_effects(d))
    truth = perfect(design)
    write_world(tmp_path, design, truth, None)
    spec, plan, errors = tmp_path / "machine.toml", tmp_path / "data", tmp_path / "errors.json"
    tables = [f'\n[[effect]]\nkind = "{kind}"\n' + rest(own[0], kind) for kind, own in SAME_FORM.items()]
    spec.write_text(spec.read_text() + "".join(tables))
    kernels = ["--kernels", str(tmp_path / "kernels")]
    assert main(["derive", str(spec), "--out", kernels[1]]) == 0
    given = json.loads(errors.read_text())
    off = {}
    for kind, (component, parameter, _) in SAME_FORM.items():
        size = 1e-8 if kind == "drift" else 1e-4
        own = {"kind": kind, "parameters": {parameter: size}} | ({"component": component} if component else {})
        own |= {"axis": "Y"} if kind == "cross_axis" else {}
        errors.write_text(json.dumps(given | {"effects": [own]}))
        out = tmp_path / kind
        arguments = ["--errors", str(errors), "--data", str(plan), "--out", str(out), *kernels]
        assert main(["simulate", str(spec), *arguments]) == 0
        theirs = pl.read_csv(out / "readings.csv")["reading"].to_numpy()
        clean, with_it = exact_readings(design, [truth, truth.hiding(Effect(kind, component, size, "Y"))])
        far = design.plan.since["X"] > 3.0  # lost motion is taken up over up to a millimetre
        ours, theirs = (with_it - clean)[far], (theirs - clean)[far]
        off[kind] = float(np.sqrt(np.mean((ours - theirs) ** 2) / np.mean(theirs**2)))
    assert {kind: value for kind, value in off.items() if value > SAME_FORM[kind][2]} == {}


def rest(component: str, kind: str) -> str:
    """The keys of an effect's table after its kind."""
    return (f'component = "{component}"\n' if component else "") + ('axis = "Y"\n' if kind == "cross_axis" else "")


def shows_all_effects(design: Design) -> bool:
    """Three axes, circles of X without gaps (the package takes tangents of evenly spaced samples) and lines from both
    directions, all columns.
    """
    wanted = ("circle", "laser", "both_ways", "three_axes", "reversals_kept")
    missing = ("no_time", "no_feed", "no_temperature", "no_directions")
    has = design.ingredients
    dense = (
        design.habits.samples >= 90 and design.plan.count < 9000 and any("X" in run.plane for run in design.plan.runs)
    )
    return dense and all(has[name] for name in wanted) and not any(has[name] for name in missing)


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
    spec, kernels = str(tmp_path / "machine.toml"), str(derived(tmp_path / "machine.toml"))
    assert main(["plan", spec, "--data", str(tmp_path / "data"), "--kernels", kernels]) in (0, 1)
    assert "Traceback" not in capsys.readouterr().err
