"""Draws over a grid of the volume: beside a Monte Carlo that is composed here, in blocks, kept and gone on with."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

import trueaxis as ta
from tests.kernels import emitted
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main
from trueaxis.jobs import draws as drawing

KERNELS = ["--kernels", str(ROOT / "generated")]
TOOL = (10.0, -20.0, -80.0)
GRID = {"X": 3, "Y": 2, "Z": 3}
# rotations so large that products of two count: slopes over the travel (rad/mm), angles (rad), and their u
SLOPES = {"EBX": (1e-6, 4e-5), "ECX": (-2e-6, 5e-5), "EAY": (1e-6, 6e-5), "EXZ": (2e-6, 1e-4)}
ANGLES = {"eps_xy": (1e-3, 0.02), "eps_xz": (-2e-3, 0.03), "eps_yz": (0.0, 1e-4)}


@pytest.fixture(scope="module")
def model() -> ta.MachineModel:
    return ta.load_model(DMU60P, ROOT / "generated")


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("values") / "errors.json"
    curves = {
        name: {"basis": "polynomial", "powers": [1], "coefficients": [value], "u": [u]}
        for name, (value, u) in SLOPES.items()
    }
    values = {name: value for name, (value, _) in ANGLES.items()}
    stated = {name: u for name, (_, u) in ANGLES.items()}
    tree = {"schema": 1, "machine": "dmu60p", "parameters": values, "u": stated, "motion_errors": curves}
    path.write_text(json.dumps(tree))
    return path


def grid_words(grid: dict[str, int]) -> list[str]:
    return ["--grid", *(f"{axis}={count}" for axis, count in grid.items())]


def command(file: Path, out: Path, *more: str) -> list[str]:
    point = ",".join(map(str, TOOL))
    words = ["predict", str(DMU60P), "--errors", str(file), *KERNELS, "--tool-point", point, "--out", str(out)]
    return [*words, *more]


def pose(count: int, *, ways: tuple[float, float, float] = (0, 0, 0), angles: dict[int, np.ndarray]) -> np.ndarray:
    """(count, 4, 4): a displacement and a small rotation, by the contract."""
    found = np.tile(np.eye(4), (count, 1, 1))
    for row, way in enumerate(ways):
        found[:, row, 3] = way
    for axis, angle in angles.items():
        one, other = (axis + 1) % 3, (axis + 2) % 3
        found[:, other, one] += angle
        found[:, one, other] -= angle
    return found


def own_errors(x: float, y: float, z: float, count: int, source: np.random.Generator) -> np.ndarray:
    """(count, 3): actual minus ideal of the tool in the workpiece frame: bed, Y, table; bed, X, Z, tool."""
    drawn = {name: mean + u * source.standard_normal(count) for name, (mean, u) in (SLOPES | ANGLES).items()}
    table = pose(count, ways=(0, y, 0), angles={0: drawn["EAY"] * y})
    x_slide = pose(count, angles={2: drawn["eps_xy"]}) @ pose(
        count, ways=(x, 0, 0), angles={1: drawn["EBX"] * x, 2: drawn["ECX"] * x}
    )
    z_slide = pose(count, angles={0: drawn["eps_yz"], 1: drawn["eps_xz"]}) @ pose(count, ways=(0, 0, z), angles={})
    z_slide = z_slide @ pose(count, ways=(0, 0, 0), angles={})
    displaced = np.tile(np.array([*TOOL, 1.0]), (count, 1))
    displaced[:, 0] += drawn["EXZ"] * z
    there = np.linalg.solve(table, (x_slide @ z_slide @ displaced[:, :, np.newaxis]))[:, :3, 0]
    return np.asarray(there - (np.array(TOOL) + np.array([x, -y, z])))


def test_the_map_is_that_of_a_monte_carlo_composed_here(file: Path, tmp_path: Path) -> None:
    count, own_count = 20_000, 100_000
    out, png = tmp_path / "map.parquet", tmp_path / "map.png"
    assert main(command(file, out, *grid_words(GRID), "--draws", str(count), "--picture", str(png))) == 0
    table = pl.read_parquet(out)
    travel = {"X": (0.0, 540.0), "Y": (0.0, 700.0), "Z": (0.0, 600.0)}
    nodes = [np.linspace(*travel[axis], GRID[axis]) for axis in "XYZ"]
    expected = [(x, y, z) for x in nodes[0] for y in nodes[1] for z in nodes[2]]
    assert table.select("X", "Y", "Z").rows() == expected
    source, judged, differing = np.random.default_rng(77), 0, 0
    for row, at in zip(table.iter_rows(named=True), expected, strict=True):
        drawn = own_errors(*at, own_count, source)
        every = np.column_stack([drawn, np.linalg.norm(drawn, axis=1)])
        for column, name in zip(every.T, ("dx", "dy", "dz", "length"), strict=True):
            sd = max(float(column.std()), 1e-12)
            error = 5.0 * sd * np.sqrt(1.0 / count + 1.0 / own_count)  # of a mean; a quantile has 2.7 times that
            assert abs(row[f"mean_{name}"] - column.mean()) < error + 1e-12
            assert row[f"sd_{name}"] == pytest.approx(column.std(), rel=0.03, abs=1e-12)
            low, high = np.quantile(column, [0.025, 0.975])
            assert abs(row[f"low_{name}"] - low) < 2.7 * error + 0.03 * sd + 1e-12
            assert abs(row[f"high_{name}"] - high) < 2.7 * error + 0.03 * sd + 1e-12
            if name == "length" or sd < 1e-9:
                continue
            ends = max(abs(row[name] + side * 1.96 * row[f"u_{name}"] - end) for side, end in ((-1, low), (1, high)))
            if ends > row[f"u_{name}"]:  # far beyond half a digit of u and the error of the draws
                assert row[f"apart_{name}"] == pytest.approx(ends, abs=3.0 * error + 0.03 * sd)
                differing += 1
            elif ends < 0.02 * row[f"u_{name}"]:
                assert row[f"apart_{name}"] == 0.0
            judged += 1
    assert judged > 20
    assert differing > 0
    assert png.read_bytes().startswith(b"\x89PNG")


@pytest.fixture
def small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(drawing, "BLOCK", 5)


def test_blocks_workers_and_a_run_in_parts_give_the_same(
    file: Path, tmp_path: Path, small_blocks: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """18 points in four blocks, the last of three points; the run with --keep is stopped after two."""
    more = [*grid_words(GRID), "--draws", "400", "--noise-um", "2", "--datum", "home", "--seed", "9"]
    assert main(command(file, tmp_path / "1.parquet", *more)) == 0
    assert main(command(file, tmp_path / "2.parquet", *more, "--workers", "2")) == 0
    once = (tmp_path / "1.parquet").read_bytes()
    assert (tmp_path / "2.parquet").read_bytes() == once
    kept = tmp_path / "kept"
    stopped = [*more, "--keep", str(kept)]
    blocks: list[int] = []
    whole = drawing._block

    def stopping(*arguments: Any) -> object:
        if len(blocks) == 2:
            raise KeyboardInterrupt
        blocks.append(0)
        return whole(*arguments)

    with monkeypatch.context() as patched:
        patched.setattr(drawing, "_block", stopping)
        assert main(command(file, tmp_path / "3.parquet", *stopped)) == 130
    assert not (tmp_path / "3.parquet").exists()
    assert len(list(kept.iterdir())) == 2
    made: list[int] = []
    draw_here = drawing._here

    def counting(*arguments: Any) -> object:
        made.append(0)
        return draw_here(*arguments)

    monkeypatch.setattr(drawing, "_here", counting)
    assert main(command(file, tmp_path / "3.parquet", *stopped)) == 0
    assert len(made) == 2  # the other two were kept
    assert (tmp_path / "3.parquet").read_bytes() == once
    damaged = sorted(kept.iterdir())[0]
    damaged.write_bytes(damaged.read_bytes()[:100])
    assert main(command(file, tmp_path / "4.parquet", *stopped)) == 0
    assert len(made) == 3
    assert (tmp_path / "4.parquet").read_bytes() == once
    assert main(command(file, tmp_path / "5.parquet", *stopped[:-2], "--seed", "10", "--keep", str(kept))) == 0
    assert len(made) == 7  # other draws: nothing kept is theirs


def test_the_function_gives_what_the_command_writes(model: ta.MachineModel, file: Path, tmp_path: Path) -> None:
    errors = ta.load_errors(file, model)
    out, png = tmp_path / "map.parquet", tmp_path / "map.png"
    assert main(command(file, out, *grid_words({"X": 3, "Z": 4}), "--draws", "200", "--picture", str(png))) == 0
    there = ta.predict(model, errors, ta.Grid({"X": 3, "Z": 4}), tool=TOOL, draws=200)
    assert there.to_polars().equals(pl.read_parquet(out))
    assert there.picture() == png.read_bytes()
    assert set(there.positions[1]) == {0.0}  # Y at home
    table = ta.predict(model, errors, {"X": [1.0]})
    assert not table.has_picture
    with pytest.raises(ValueError, match="picture: positions are no grid of two axes or more"):
        table.picture()


def test_what_is_wrong_with_a_grid_is_told_at_once(
    model: ta.MachineModel, file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out, png = tmp_path / "map.parquet", tmp_path / "map.png"
    (tmp_path / "taken").write_text("")
    more = ["--grid", "X=1", "Q=3", "Y=2", "Y=4", "--draws", "100", "--keep", str(tmp_path / "taken")]
    assert main(command(file, out, *more)) == 2
    assert capsys.readouterr().err.splitlines() == [
        "trueaxis: --grid: Y: is given more than once; once",
        "trueaxis: --grid: dmu60p has no axis Q; X, Y, Z",
        "trueaxis: --grid: X: has 1 positions; a whole number, at least 2",
        f"trueaxis: {tmp_path / 'taken'}: is no folder; a folder for results, or a new name",
    ]
    assert main(command(file, out, "--grid", "X=1001", "Y=1000", "--keep", "kept")) == 2
    told = capsys.readouterr().err
    assert "--grid: has 1001000 points; 1000000 at most" in told
    assert "--keep: goes with --draws" in told
    assert main(command(file, out, "--grid", "Z=3", "--picture", str(png))) == 2
    assert "--picture: is of a grid of one axis" in capsys.readouterr().err
    assert main(command(file, out, "--at", "none.csv", "--picture", str(png))) == 2
    told = capsys.readouterr().err
    assert all(words in told for words in ("--tool-point: goes with --grid", "--picture: goes with", "none.csv"))
    with pytest.raises(SystemExit):
        main(command(file, out, "--grid", "X:3"))
    assert "'X:3' is not AXIS=N, such as X=11" in capsys.readouterr().err
    with pytest.raises(ta.InputError, match="positions: dmu60p has no axis Q; X, Y, Z"):
        ta.predict(model, ta.load_errors(file, model), ta.Grid({"Q": 3}))
    assert not out.exists()
    assert not png.exists()


def test_effects_of_time_need_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A grid has no times or temperatures: nothing is taken to be known of them."""
    text = (ROOT / "examples" / "worn_mill.toml").read_text() + '[[effect]]\nkind = "drift"\ncomponent = "EZZ"\n'
    spec, values = tmp_path / "mill.toml", tmp_path / "e.json"
    spec.write_text(text)
    drift = {"kind": "drift", "component": "EZZ", "parameters": {"rate": 1e-6}}
    values.write_text(json.dumps({"schema": 1, "machine": "cframe_mill", "effects": [drift]}))
    kernels = str(emitted(text))
    words = ["predict", str(spec), "--errors", str(values), "--kernels", kernels, "--out", str(tmp_path / "o.csv")]
    assert main([*words, "--grid", "X=2", "Z=2"]) == 2
    assert "--grid: column time_s: is not known at point 1" in capsys.readouterr().err
    table = tmp_path / "at.csv"
    table.write_text("X,Y,Z,time_s\n0,0,0,100\n")
    assert main([*words, "--at", str(table)]) == 0
