"""simulate: the exact model's readings of the paper's runs, and what happens to files on the way."""

import json
import shutil
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from tests.generator.dmu60p import TRAVEL, cubic_errors, dmu60p
from tests.generator.instruments import ball_bar, laser
from tests.measurement.adapter import Dmu60pAxes, GeneratorModel
from tests.measurement.command_line import PLAN, errors_tree, run
from trueaxis.cli import simulate as command
from trueaxis.io.faults import InputError
from trueaxis.measurement.data import read_data
from trueaxis.measurement.simulate import filled_in


@pytest.fixture
def errors(tmp_path: Path) -> Path:
    path = tmp_path / "errors.json"
    path.write_text(json.dumps(errors_tree()))
    return path


def simulated(errors: Path, data: Path, out: Path, *options: object) -> pl.DataFrame:
    assert run(command, "--errors", errors, "--data", data, "--out", out, *options) == 0
    return pl.read_csv(out / "readings.csv")


def test_readings_are_those_of_the_independent_exact_machine(tmp_path: Path, errors: Path) -> None:
    found = simulated(errors, PLAN, tmp_path / "out")
    machine = dmu60p(cubic_errors())
    runs = {one.id: one for one in read_data(PLAN, Dmu60pAxes()).setup.runs}
    for row in found.iter_rows(named=True):
        one = runs[row["run"]]
        assert one.direction is not None
        by_definition = laser(
            machine,
            {axis: row[axis] for axis in "XYZ"},
            one.home,
            direction=one.direction,
            frame=one.frame,
            target=(one.target.on, one.target.point),
            reference=(one.reference.on, one.reference.point),
        )
        assert abs(row["reading"] - float(by_definition)) < 1e-12
    assert found["reading"].abs().max() > 1e-3  # type: ignore[operator]


def test_ball_bar_readings_are_those_of_the_independent_exact_machine(tmp_path: Path, errors: Path) -> None:
    plan = tmp_path / "plan"
    plan.mkdir()
    centre = (270.0, 350.0, 100.0)
    workpiece = tuple(c - q for c, q in zip(centre, (270.0, -350.0, 12.5), strict=True))
    tool = tuple(-q for q in (1.25, 3.0, 400.0))
    (plan / "setup.toml").write_text(
        'schema = 1\nmachine = "dmu60p"\n[[run]]\nid = "XY"\ninstrument = "ballbar"\nlength = 150.0\n'
        f'target = {{ on = "tool", point = {list(tool)} }}\n'
        f'reference = {{ on = "workpiece", point = {list(workpiece)} }}\n'
    )
    turn = np.linspace(0.0, 2.0 * np.pi, 73)
    x, y = centre[0] + 150.0 * np.cos(turn), 350.0 * 2 - (centre[1] + 150.0 * np.sin(turn))
    # the workpiece rides on Y: at command Y its ball is at centre_y + Y in the bed; the tool stays at 0 + X, 0, Z
    rows = [f"XY,{n},{a!r},{b!r},100.0," for n, (a, b) in enumerate(zip(x.tolist(), y.tolist(), strict=True))]
    (plan / "readings.csv").write_text("run,seq,X,Y,Z,reading\n" + "\n".join(rows))
    machine = dmu60p(cubic_errors())
    with pytest.raises(InputError, match=r"run XY: the balls are 715.891 mm apart at the first position, not 150 mm"):
        simulated(errors, plan, tmp_path / "out")
    moved = tuple(w - d for w, d in zip(workpiece, (0.0, 700.0, 0.0), strict=True))
    text = (plan / "setup.toml").read_text().replace(str(list(workpiece)), str(list(moved)))
    (plan / "setup.toml").write_text(text)
    found = simulated(errors, plan, tmp_path / "out")
    for row in found.iter_rows(named=True):
        by_definition = ball_bar(
            machine,
            {axis: row[axis] for axis in "XYZ"},
            length=150.0,
            target=("tool", tool),
            reference=("workpiece", moved),
            frame="workpiece",
        )
        assert abs(row["reading"] - float(by_definition)) < 1e-12
        assert abs(row["reading"]) < 0.2


def test_true_rotations_would_read_the_same_to_second_order(tmp_path: Path, errors: Path) -> None:
    data = read_data(PLAN, Dmu60pAxes())
    small = simulated(errors, PLAN, tmp_path / "out")["reading"].to_numpy()
    model = GeneratorModel(dmu60p(cubic_errors(), rotations="true"))
    true = filled_in(model, data.setup.runs, data.readings).reading
    assert 1e-9 < np.abs(small - true).max() < 1e-4


def test_noise_has_its_size_and_its_seed(tmp_path: Path, errors: Path) -> None:
    plain = simulated(errors, PLAN, tmp_path / "0")["reading"].to_numpy()
    one, two = (simulated(errors, PLAN, tmp_path / f"{s}", "--noise-um", 0.5, "--seed", s) for s in (1, 2))
    noise = [table["reading"].to_numpy() - plain for table in (one, two)]
    for sample in noise:
        assert np.std(sample) == pytest.approx(0.5e-3, rel=4 / np.sqrt(2 * len(sample)))
        assert abs(np.mean(sample)) < 4 * 0.5e-3 / np.sqrt(len(sample))
    assert abs(np.corrcoef(*noise)[0, 1]) < 4 / np.sqrt(len(plain))
    simulated(errors, PLAN, tmp_path / "again", "--noise-um", 0.5, "--seed", 1)
    assert (tmp_path / "again" / "readings.csv").read_bytes() == (tmp_path / "1" / "readings.csv").read_bytes()


def test_readings_that_are_there_stay_unless_told_otherwise(
    tmp_path: Path, errors: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plan = tmp_path / "plan"
    shutil.copytree(PLAN, plan)
    text = (PLAN / "readings.csv").read_text().replace("X-1,3,60.0,0.0,0.0,", "X-1,3,60.0,0.0,0.0,0.125")
    (plan / "readings.csv").write_text(text)
    full = simulated(errors, PLAN, tmp_path / "full")["reading"].to_numpy()
    capsys.readouterr()
    partly = simulated(errors, plan, tmp_path / "out")["reading"].to_numpy()
    assert "503 readings made; 1 were there already" in capsys.readouterr().out
    assert partly[3] == 0.125
    assert np.array_equal(np.delete(partly, 3), np.delete(full, 3))
    assert np.array_equal(simulated(errors, plan, tmp_path / "all", "--replace")["reading"].to_numpy(), full)


def test_the_setup_is_copied_byte_for_byte_and_every_column_stays(tmp_path: Path, errors: Path) -> None:
    plan = tmp_path / "plan"
    plan.mkdir()
    raw = (PLAN / "setup.toml").read_bytes().replace(b"\n", b"\r\n") + "# gemessen in Köln".encode()
    (plan / "setup.toml").write_bytes(raw)
    table = pl.read_csv(PLAN / "readings.csv").with_columns(feed=pl.lit(1000.0), dir_X=pl.lit(1), time_s=pl.lit(0.1))
    table.write_csv(plan / "readings.csv")
    found = simulated(errors, plan, tmp_path / "out")
    assert (tmp_path / "out" / "setup.toml").read_bytes() == raw
    assert set(found.columns) == {"run", "seq", "time_s", "X", "Y", "Z", "dir_X", "feed", "reading"}
    assert found.drop("reading").equals(table.drop("reading").select(found.drop("reading").columns), null_equal=True)


def test_a_parquet_plan_is_as_good(tmp_path: Path, errors: Path) -> None:
    plan = tmp_path / "plan"
    plan.mkdir()
    shutil.copy(PLAN / "setup.toml", plan)
    pl.read_csv(PLAN / "readings.csv").write_parquet(plan / "readings.parquet")
    simulated(errors, plan, tmp_path / "parquet")
    simulated(errors, PLAN, tmp_path / "csv")
    assert (tmp_path / "parquet/readings.csv").read_bytes() == (tmp_path / "csv/readings.csv").read_bytes()


def test_the_folder_of_the_data_is_never_the_output(tmp_path: Path, errors: Path) -> None:
    plan = tmp_path / "plan"
    shutil.copytree(PLAN, plan)
    (tmp_path / "link").symlink_to(plan)
    for out in (plan, plan / ".." / "plan", tmp_path / "link"):
        with pytest.raises(InputError, match="is the folder of the data itself"):
            simulated(errors, plan, out)
    assert (plan / "readings.csv").read_bytes() == (PLAN / "readings.csv").read_bytes()


def test_a_readings_file_of_the_other_kind_is_not_left_beside_the_new_one(tmp_path: Path, errors: Path) -> None:
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "readings.parquet").touch()
    with pytest.raises(InputError, match=r"would stand beside the new readings\.csv"):
        simulated(errors, PLAN, tmp_path / "out")


def test_faults_of_all_files_come_at_once_and_nothing_is_written(tmp_path: Path, errors: Path) -> None:
    plan = tmp_path / "plan"
    plan.mkdir()
    (plan / "setup.toml").write_text((PLAN / "setup.toml").read_text().replace('id = "X-1"', 'id = "X-2"'))
    (plan / "readings.csv").write_text((PLAN / "readings.csv").read_text().replace("X-1,1,20.0", "X-1,1,2000.0"))
    errors.write_text(errors.read_text().replace("EXX", "EXQ"))
    with pytest.raises(InputError) as caught:
        simulated(errors, plan, tmp_path / "out")
    assert {Path(fault.file).name for fault in caught.value.faults} == {"setup.toml", "readings.csv", "errors.json"}
    assert not (tmp_path / "out").exists()


def test_a_folder_that_cannot_be_made_leaves_nothing_behind(tmp_path: Path, errors: Path) -> None:
    (tmp_path / "out").write_text("a file")
    before = sorted(tmp_path.iterdir())
    with pytest.raises(InputError, match="out: is a file; a folder to write to"):
        simulated(errors, PLAN, tmp_path / "out")
    assert sorted(tmp_path.iterdir()) == before
    assert (tmp_path / "out").read_text() == "a file"


@pytest.mark.parametrize(
    "option",
    [
        ("--noise-um", "-1"),
        ("--noise-um", "nan"),
        ("--noise-um", "1e308"),
        ("--noise-um", "1.1e4"),
        ("--seed", "-3"),
        ("--seed", "x"),
    ],
)
def test_noise_options_are_checked(tmp_path: Path, errors: Path, option: tuple[str, str]) -> None:
    with pytest.raises(SystemExit) as caught:
        simulated(errors, PLAN, tmp_path / "out", *option)
    assert caught.value.code == 2


def test_every_position_of_the_plan_is_within_the_travel() -> None:
    found = read_data(PLAN, Dmu60pAxes()).readings.positions
    for axis, row in zip("XYZ", found, strict=True):
        assert (row.min(), row.max()) == TRAVEL[axis]
