"""Two readings that were disturbed are nothing stale, though nothing was read twice; four are told."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import trueaxis as ta
from trueaxis.diagnosis.result import Diagnosis

ROOT = Path(__file__).parents[2]
NOISE = 0.3  # um
RUN = """
[[run]]
id = "{name}"
instrument = "laser"
direction = {direction}
frame = "workpiece"
target = {{ on = "tool", point = {target} }}
reference = {{ on = "workpiece", point = [100.0, 100.0, 0.0] }}
home = {home}
"""
Shop = tuple[ta.MachineModel, ta.Errors, ta.DataFolder]


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> Shop:
    """Positioning and straightness of each axis along two lines of 15 targets, one way and once."""
    folder = tmp_path_factory.mktemp("lines")
    model = ta.load_model(ROOT / "machines/dmu60p.toml", ROOT / "generated")
    errors = ta.load_errors(ROOT / "machines/dmu60p_errors.json", model)
    draw = np.random.default_rng(11)
    setup, rows = 'schema = 1\nmachine = "dmu60p"\n', ["run,seq,X,Y,Z,reading"]
    low, high = np.array([model.travel[axis] for axis in "XYZ"]).T
    for moving, along, line in (
        (moving, along, line) for moving in range(3) for along in range(3) for line in range(2)
    ):
        name, home = f"{'XYZ'[moving]}{'XYZ'[along]}{line}", draw.uniform(low, high).round(1)
        at = np.repeat(home[:, np.newaxis], 15, axis=1)
        at[moving] = np.linspace(low[moving], high[moving], 15).round(2)
        setup += RUN.format(
            name=name,
            direction=[float(along == k) for k in range(3)],
            target=[*draw.uniform(-40.0, 40.0, 2).round(1).tolist(), -100.0],
            home="{ " + ", ".join(f"{axis} = {value}" for axis, value in zip("XYZ", at[:, 0], strict=True)) + " }",
        )
        rows += [f"{name},{k},{','.join(map(str, place))}," for k, place in enumerate(at.T.tolist())]
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return model, errors, ta.simulate(model, errors, ta.load_data(folder, model), noise_um=NOISE, seed=3)


def said(shop: Shop, change: np.ndarray, folder: Path) -> Diagnosis:
    """Of readings that are larger, (n,) mm."""
    model, errors, data = shop
    readings = replace(data.data.readings, reading=np.round(data.data.readings.reading + change, 4) + 0.0)
    ta.save_data(folder, replace(data, data=replace(data.data, readings=readings)))
    return ta.diagnose(model, ta.load_data(folder, ta.load_machine(ROOT / "machines/dmu60p.toml")), errors).diagnosis


def off_by(shop: Shop, seed: int, many: int) -> np.ndarray:
    """(n,), mm: neighbours of one run that are off by about as much."""
    draw, rows = np.random.default_rng(seed), shop[2].data.readings
    run, first = int(draw.integers(18)), int(draw.integers(1, 12))
    change = np.zeros(rows.run.size)
    size = draw.choice([-1.0, 1.0]) * draw.uniform(8e-3, 15e-3) * draw.uniform(0.7, 1.0, many)
    change[np.flatnonzero(rows.run == run)[first : first + many]] = size
    return change


@pytest.mark.parametrize("seed", [0, 1, 4])
def test_two_neighbours_are_nothing_stale(measured: Shop, seed: int, tmp_path: Path) -> None:
    """Without the look at neighbours values were stale for seeds 1 and 4."""
    change = off_by(measured, seed, 2)
    found = said(measured, change, tmp_path / "data")
    assert (found.stale, found.causes) == ((), ())
    if seed in (1, 4):
        runs, seq = measured[2].data.setup.runs, measured[2].data.readings.seq
        off = [(runs[measured[2].data.readings.run[k]].id, int(seq[k])) for k in np.flatnonzero(change)]
        assert found.verdict == "no_discrepancy"
        assert [(one.run, one.seq) for one in found.outliers] == off


@pytest.mark.parametrize("seed", [1, 4])
def test_four_are_something(measured: Shop, seed: int, tmp_path: Path) -> None:
    found = said(measured, off_by(measured, seed, 4), tmp_path / "data")
    assert found.verdict in ("recalibrate", "unexplained_structure")
    assert found.outliers == ()
