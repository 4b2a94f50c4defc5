"""A cause that cannot be told from a rival stands: the machine extended without it fits no run, and says nothing."""

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
    folder = tmp_path_factory.mktemp("lines")
    model = ta.load_model(ROOT / "machines/dmu60p.toml", ROOT / "generated")
    errors = ta.load_errors(ROOT / "machines/dmu60p_errors.json", model)
    setup, rows = 'schema = 1\nmachine = "dmu60p"\n', ["run,seq,time_s,X,Y,Z,reading"]
    for number, axis in enumerate("XYZ"):
        setup += RUN.format(axis=axis, direction=[float(k == number) for k in range(3)])
        there = np.linspace(*model.travel[axis], 21)
        for seq, position in enumerate(np.tile([*there, *there[::-1]], 3)):
            at = [position if k == number else 0.0 for k in range(3)]
            rows.append(f"{axis},{seq},{5 * len(rows)},{','.join(f'{value:.3f}' for value in at)},")
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return model, errors, ta.simulate(model, errors, ta.load_data(folder, model), noise_um=0.2, seed=3)


def test_backlash_of_one_line_is_named_with_its_rival(
    measured: tuple[ta.MachineModel, ta.Errors, ta.DataFolder], tmp_path: Path
) -> None:
    model, errors, data = measured
    ta.save_data(tmp_path / "data", data)
    table = (tmp_path / "data/readings.csv").read_text().splitlines()
    column = table[0].split(",").index("reading")
    lines, last, direction = [table[0]], 0.0, 1.0
    for row in table[1:]:
        cells = row.split(",")
        if cells[0] == "X":
            position = float(cells[table[0].split(",").index("X")])
            direction = float(np.sign(position - last)) or direction
            last = position
            cells[column] = repr(float(cells[column]) + 0.5 * WIDTH * (direction - 1.0))
        lines.append(",".join(cells))
    (tmp_path / "data/readings.csv").write_text("\n".join(lines) + "\n")
    found = ta.diagnose(model, ta.load_data(tmp_path / "data", model), errors)
    (cause,) = found.diagnosis.causes
    assert found.verdict == "ambiguous"
    assert {(one.kind, one.component) for one in (cause.effect, *(rival.effect for rival in cause.rivals))} == {
        ("backlash", "EXX"),
        ("backlash", "EBX"),
    }
    assert found.diagnosis.misfits == ()
