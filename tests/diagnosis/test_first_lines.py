"""What a shop measures first, a line of each axis: backlash keeps its name and its rival, a new scale has no name."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import trueaxis as ta

ROOT = Path(__file__).parents[2]
WIDTH = 6e-3  # mm, of backlash
RUN = """
[[run]]
id = "{axis}"
instrument = "laser"
direction = {direction}
frame = "workpiece"
target = {{ on = "tool", point = [0.0, 0.0, -100.0] }}
reference = {{ on = "workpiece", point = [100.0, 100.0, 0.0] }}
home = {{ X = 0.0, Y = 0.0, Z = 0.0 }}
"""


@pytest.fixture(scope="module")
def measured(tmp_path_factory: pytest.TempPathFactory) -> tuple[ta.MachineModel, ta.Errors, ta.DataFolder]:
    """A line of each axis, three times there and back, and nothing else: as a shop measures first."""
    model = ta.load_model(ROOT / "machines/dmu60p.toml", ROOT / "generated")
    errors = ta.load_errors(ROOT / "machines/dmu60p_errors.json", model)
    return model, errors, _lines(tmp_path_factory.mktemp("lines"), model, errors, 3)


def _lines(folder: Path, model: ta.MachineModel, errors: ta.Errors, passes: int) -> ta.DataFolder:
    setup, rows = 'schema = 1\nmachine = "dmu60p"\n', ["run,seq,time_s,X,Y,Z,reading"]
    for number, axis in enumerate("XYZ"):
        setup += RUN.format(axis=axis, direction=[float(k == number) for k in range(3)])
        there = np.linspace(*model.travel[axis], 21)
        for seq, position in enumerate(np.tile([*there, *there[::-1]], passes)):
            at = [position if k == number else 0.0 for k in range(3)]
            rows.append(f"{axis},{seq},{5 * len(rows)},{','.join(f'{value:.3f}' for value in at)},")
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return ta.simulate(model, errors, ta.load_data(folder, model), noise_um=0.1, seed=3)


def _changed(data: ta.DataFolder, folder: Path, change: np.ndarray) -> ta.DataFolder:
    """With readings that are larger, (n,) mm."""
    readings = replace(data.data.readings, reading=data.data.readings.reading + change)
    ta.save_data(folder, replace(data, data=replace(data.data, readings=readings)))
    return ta.load_data(folder, ta.load_machine(ROOT / "machines/dmu60p.toml"))


def test_backlash_of_one_line_is_named_with_its_rival(
    measured: tuple[ta.MachineModel, ta.Errors, ta.DataFolder], tmp_path: Path
) -> None:
    """The machine that is extended without it fits no run: that says nothing against it."""
    model, errors, data = measured
    moves = np.diff(data.data.readings.positions[0], prepend=0.0)
    direction, last = np.zeros(moves.size), 1.0
    for row, move in enumerate(moves.tolist()):
        last = direction[row] = float(np.sign(move)) or last
    lost = 0.5 * WIDTH * (direction - 1.0)
    found = ta.diagnose(
        model, _changed(data, tmp_path / "data", np.where(data.data.readings.run == 0, lost, 0.0)), errors
    )
    (cause,) = found.diagnosis.causes
    assert found.verdict == "ambiguous"
    assert {(one.kind, one.component) for one in (cause.effect, *(rival.effect for rival in cause.rivals))} == {
        ("backlash", "EXX"),
        ("backlash", "EBX"),
    }
    assert found.diagnosis.misfits == ()


def test_a_spike_that_hardly_more_than_one_target_shows_has_its_name(
    measured: tuple[ta.MachineModel, ta.Errors, ta.DataFolder], tmp_path: Path
) -> None:
    """Targets stand many decay lengths apart: of height and decay hardly more than a product is known."""
    model, errors, data = measured
    rows = data.data.readings
    there = rows.positions[0]
    spike, turn, last = np.zeros(there.size), there[0], 0.0
    for row in np.flatnonzero(rows.run == 0).tolist():
        before = there[row - 1] if row else 0.0  # home
        way = float(np.sign(there[row] - before)) or last
        if row and way != last:
            turn = before
        last = way
        spike[row] = 0.02 * way * np.exp(-abs(there[row] - turn) / 12.0)
    found = ta.diagnose(model, _changed(data, tmp_path / "data", spike), errors)
    (cause,) = found.diagnosis.causes
    kinds = {(one.kind, one.component) for one in (cause.effect, *(rival.effect for rival in cause.rivals))}
    assert ("reversal_spike", "EXX") in kinds
    assert len(kinds) <= 3


def test_a_new_scale_is_no_cyclic_error_that_aliases_to_it(
    measured: tuple[ta.MachineModel, ta.Errors, ta.DataFolder], tmp_path: Path
) -> None:
    """Targets of one distance see a pitch near a fifth of it as a slow curve, of any amplitude."""
    model, errors, data = measured
    longer = np.where(data.data.readings.run == 0, 2e-5 * data.data.readings.positions[0], 0.0)
    found = ta.diagnose(model, _changed(data, tmp_path / "data", longer), errors)
    assert (found.verdict, found.diagnosis.causes) == ("recalibrate", ())
    (stale,) = found.diagnosis.stale
    assert "EXX" in (stale.component, *stale.alike)
