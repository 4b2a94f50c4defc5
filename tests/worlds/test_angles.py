"""Angle runs beside a world: they change nothing of it, and their readings are those of the package's exact model."""

from pathlib import Path

import numpy as np
import pytest

from tests.kept import derived
from tests.worlds import angles
from tests.worlds.__main__ import main
from tests.worlds.angles import draw_angles
from tests.worlds.design import draw_design
from tests.worlds.truth import draw_machine
from trueaxis.jobs.load import load_data, load_model
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.model.curves import Curve, TableCurve
from trueaxis.model.errors import ErrorValues

SEED = 8804  # table-table


def test_a_world_stays_what_it_is(tmp_path: Path) -> None:
    for name, more in (("plain", ()), ("angles", ("--angles",))):
        assert main([str(SEED), "--out", str(tmp_path / name), *more]) == 0
    for file in ("machine.toml", "errors.json", "truth/deviations.csv"):
        assert (tmp_path / "plain" / file).read_bytes() == (tmp_path / "angles" / file).read_bytes()
    for file in ("data/setup.toml", "data/readings.csv"):
        before, beside = ((tmp_path / name / file).read_text() for name in ("plain", "angles"))
        assert beside.startswith(before)
        assert len(beside) > len(before)


def test_readings_are_those_of_the_exact_model(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("WHITE", "ZERO", "DRIFT"):
        monkeypatch.setattr(angles, name, (0.0, 0.0))
    assert main([str(SEED), "--out", str(tmp_path), "--angles"]) == 0
    design = draw_design(SEED)
    truth = draw_machine(design.machine, SEED)
    drawn = {run.id: run for run in draw_angles(design, truth, SEED)}
    model = load_model(tmp_path / "machine.toml", derived(tmp_path / "machine.toml"))
    data = load_data(tmp_path / "data", model).data
    places = {axis: np.unique(np.concatenate([run.positions[axis] for run in drawn.values()])) for axis in model.axes}
    curves: dict[str, Curve] = {}
    for name in model.components:
        at = places[name.axis]
        at = at if at.size > 1 else np.array([at[0], at[0] + 1.0])
        curves[name] = TableCurve(tuple(at.tolist()), tuple(np.asarray(truth.curves[name](at)).tolist()))
    values = dict(design.machine.dimensions) | dict(truth.located)
    given = model.with_values(ErrorValues(machine=model.name, parameters=values, motion_errors=curves))
    count = 0
    for index, run in enumerate(data.setup.runs):
        if run.instrument == "angle":
            rows = data.readings.of_run(index)
            found = expected_reading(given, run, np.ascontiguousarray(data.readings.positions[:, rows]))
            off = found / ARM - drawn[run.id].reading
            assert np.abs(off).max() < 0.06e-6, run.id  # half a step of the display
            assert np.abs(drawn[run.id].reading).max() > 1e-6
            count += 1
    assert count == len(drawn) == 8
