"""`predict` and `compensate` with draws: the exact model, the posterior as it is, the same whoever draws."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import polars as pl
import pytest

import trueaxis as ta
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main
from trueaxis.model.curves import LegendreCurve

KERNELS = str(ROOT / "generated")
PLAN = ROOT / "machines" / "dmu60p_regular_runs"
TOOL = (0.0, 0.0, -50.0)
NC = "G21 G90\nG0 X10. Y10. Z10.\nG1 X270. Y350. Z150. F1000\nX280.\n"


@pytest.fixture(scope="module")
def model() -> ta.MachineModel:
    return ta.load_model(DMU60P, KERNELS)


@pytest.fixture(scope="module")
def file(model: ta.MachineModel, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Error values that were identified, with their covariance."""
    truth = ta.load_errors(ROOT / "machines" / "dmu60p_errors.json", model)
    data = ta.simulate(model, truth, ta.load_data(PLAN, model), noise_um=0.3, seed=3, replace_all=True)
    file = tmp_path_factory.mktemp("values") / "errors.json"
    ta.save_errors(file, ta.identify(model, data).errors, model)
    return file


@pytest.fixture(scope="module")
def errors(model: ta.MachineModel, file: Path) -> ta.Errors:
    return ta.load_errors(file, model)


def positions(model: ta.MachineModel, count: int) -> dict[str, np.ndarray]:
    source = np.random.default_rng(1)
    return {axis: source.uniform(*model.travel[axis], count) for axis in model.axes}


@pytest.mark.parametrize("datum", ["machine", "home", "best-fit"])
def test_draws_of_a_machine_that_is_linear_are_as_u_says(model: ta.MachineModel, errors: ta.Errors, datum: str) -> None:
    there = ta.predict(model, errors, positions(model, 20), tool=TOOL, datum=datum, draws=10_000)  # type: ignore[arg-type]
    drawn = there.drawn
    assert drawn is not None
    np.testing.assert_allclose(drawn.sd[:3], there.u, rtol=0.04)
    assert np.abs((drawn.mean[:3] - there.deviation) / there.u).max() < 0.05
    assert np.abs((drawn.low[:3] - there.deviation) / there.u + 1.96).max() < 0.15
    assert np.abs((drawn.high[:3] - there.deviation) / there.u - 1.96).max() < 0.15
    assert not drawn.differing.any()
    assert any("10000 draws (GUM Supplement 1): its 95 % intervals agree" in note for note in there.notes)


def test_draws_are_those_of_the_exact_model_one_by_one(model: ta.MachineModel, errors: ta.Errors) -> None:
    """The same random numbers, and a model loaded with the values of each draw: nothing of the fast way is used."""
    at = positions(model, 3)
    there = ta.predict(model, errors, at, tool=TOOL, datum="home", draws=ta.Draws(count=100, seed=11))
    covariance, values = errors.covariance, errors.values
    assert covariance.root is not None
    found = []
    for number in range(100):
        source = np.random.SeedSequence(11).spawn(100)[number].spawn(3)[0]
        unit = np.random.Generator(np.random.PCG64(source)).standard_normal((1, covariance.root.shape[1]))
        steps = np.asarray(covariance.root @ unit[0])
        curves = {}
        for name, curve in values.motion_errors.items():
            assert isinstance(curve, LegendreCurve)
            changed = np.array(curve.coefficients) + steps[covariance.rows_of(name)]
            curves[name] = replace(curve, coefficients=tuple(changed.tolist()))
        start = covariance.count - len(covariance.locations)
        located = dict(zip(covariance.locations, steps[start:], strict=True))
        parameters = {name: value + located.get(name, 0.0) for name, value in values.parameters.items()}
        drawn = replace(values, motion_errors=curves, parameters=parameters, covariance=None)
        given = replace(errors, values=drawn, covariance=replace(covariance, sha256_of_values=""))
        found.append(ta.predict(model, given, at, tool=TOOL, datum="home").deviation)
    every = np.array(found)
    drawn_here = there.drawn
    assert drawn_here is not None
    np.testing.assert_allclose(drawn_here.mean[:3], every.mean(axis=0), atol=1e-12)
    np.testing.assert_allclose(drawn_here.sd[:3], every.std(axis=0, ddof=1), rtol=1e-9)
    length = np.linalg.norm(every, axis=1)
    np.testing.assert_allclose(drawn_here.mean[3], length.mean(axis=0), rtol=1e-10)
    np.testing.assert_allclose(drawn_here.sd[3], length.std(axis=0, ddof=1), rtol=1e-9)


def test_noise_adds_to_it_and_the_seed_decides(model: ta.MachineModel, errors: ta.Errors) -> None:
    at = np.array([[100.0, 400.0], [350.0, 350.0], [300.0, 300.0]])
    one, same, other, noisy = (
        ta.predict(model, errors, at, draws=draws).drawn
        for draws in (ta.Draws(count=5000), 5000, ta.Draws(count=5000, seed=1), ta.Draws(count=5000, noise_um=4.0))
    )
    assert one is not None
    assert same is not None
    assert other is not None
    assert noisy is not None
    assert np.array_equal(one.mean, same.mean)
    assert not np.array_equal(one.mean, other.mean)
    np.testing.assert_allclose(noisy.sd[:3], np.hypot(one.sd[:3], 4e-3), rtol=0.05)
    assert not noisy.differing.any()  # u is compared with the noise in it


def test_two_workers_draw_the_same(model: ta.MachineModel, file: Path, tmp_path: Path) -> None:
    points = tmp_path / "points.csv"
    pl.DataFrame(positions(model, 5)).write_csv(points)
    words = ["predict", str(DMU60P), "--errors", str(file), "--at", str(points), "--kernels", KERNELS]
    for workers in ("1", "2"):
        more = ["--draws", "3000", "--workers", workers, "--seed", "5"]
        assert main([*words, *more, "--out", str(tmp_path / f"{workers}.parquet")]) == 0
    assert (tmp_path / "1.parquet").read_bytes() == (tmp_path / "2.parquet").read_bytes()
    table = pl.read_parquet(tmp_path / "1.parquet")
    names = [f"{s}_{q}" for s in ("mean", "sd", "low", "high") for q in ("dx", "dy", "dz", "length")]
    names += ["apart_dx", "apart_dy", "apart_dz"]
    assert table.columns[-19:] == names
    assert table.null_count().sum_horizontal().item() == 0
    assert (table["low_length"] >= 0.0).all()
    there = ta.predict(model, ta.load_errors(file, model), positions(model, 5), draws=ta.Draws(count=3000, seed=5))
    assert there.to_polars().select(names).equals(table.select(names))


def test_what_is_left_of_a_program_holds_the_uncertainty_and_the_words(
    model: ta.MachineModel, file: Path, errors: ta.Errors, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    program, out, table = tmp_path / "part.nc", tmp_path / "out.nc", tmp_path / "left.parquet"
    program.write_text(NC)
    words = ["compensate", str(DMU60P), "--errors", str(file), str(program), "--out", str(out), "--kernels", KERNELS]
    assert main([*words, "--draws", "20000", "--draws-out", str(table)]) == 0
    assert "20000 draws (GUM Supplement 1)" in capsys.readouterr().out
    left = pl.read_parquet(table)
    assert left.height > 5
    np.testing.assert_allclose(left.select("sd_dx", "sd_dy", "sd_dz"), left.select("u_dx", "u_dy", "u_dz"), rtol=0.04)
    assert float(left.select(pl.max_horizontal("mean_dx", "mean_dy", "mean_dz").abs().max()).item()) < 1e-4
    at = {axis: left[axis].to_numpy() for axis in model.axes}
    u = ta.predict(model, errors, at, datum="home").u
    words_u = 1e-3 / np.sqrt(12.0)  # of a resolution of 0.001 mm, the table moving along each axis alone
    np.testing.assert_allclose(left.select("u_dx", "u_dy", "u_dz").to_numpy().T, np.hypot(u, words_u), rtol=1e-3)
    plain = tmp_path / "plain.nc"
    assert main([*words[:5], "--out", str(plain), "--kernels", KERNELS]) == 0
    assert plain.read_bytes() == out.read_bytes()
    done = ta.compensate(model, errors, program, draws=2000)
    assert done.left is not None
    assert done.left.to_polars().columns == left.columns
    assert "2000 draws" in str(done)


def test_options_that_do_not_go_together_are_told(
    model: ta.MachineModel, file: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    points, out = tmp_path / "points.csv", tmp_path / "out.csv"
    pl.DataFrame(positions(model, 2)).write_csv(points)
    words = [
        "predict",
        str(DMU60P),
        "--errors",
        str(file),
        "--at",
        str(points),
        "--out",
        str(out),
        "--kernels",
        KERNELS,
    ]
    assert main([*words, "--seed", "3", "--workers", "2", "--noise-um", "1"]) == 2
    assert [line.split(":")[1] for line in capsys.readouterr().err.splitlines()] == [
        " --seed",
        " --noise-um",
        " --workers",
    ]
    without = tmp_path / "without.json"
    without.write_text('{"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": 1e-5}}')
    again = [str(without) if word == str(file) else word for word in words]
    assert main([*again, "--draws", "100", "--workers", "2", "--scheduler", "tcp://127.0.0.1:1"]) == 2
    told = capsys.readouterr().err.splitlines()
    assert [line.split(":")[1] for line in told] == [f" {without}", " --workers"]
    assert "there is nothing to draw" in told[0]
    program = tmp_path / "part.nc"
    program.write_text(NC)
    other = ["compensate", str(DMU60P), "--errors", str(file), str(program), "--out", str(tmp_path / "c.nc")]
    assert main([*other, "--kernels", KERNELS, "--draws", "100"]) == 2
    assert "--draws-out" in capsys.readouterr().err
    assert not out.exists()
    assert not (tmp_path / "c.nc").exists()


@pytest.mark.parametrize(
    ("draws", "told"),
    [
        (1, "draws.count: expected a whole number from 2"),
        (ta.Draws(count=10, seed=-1), "draws.seed"),
        (ta.Draws(count=10, noise_um=float("nan")), "draws.noise_um: expected a finite number"),
        (ta.Draws(count=10, workers=0), "workers: expected a whole number from 1"),
    ],
)
def test_numbers_out_of_their_range_are_told(
    model: ta.MachineModel, errors: ta.Errors, draws: ta.Draws | int, told: str
) -> None:
    with pytest.raises(ValueError, match=told):
        ta.predict(model, errors, {"X": 1.0}, draws=draws)


def test_points_are_drawn_in_blocks_unless_a_best_fit_is_of_all(model: ta.MachineModel, errors: ta.Errors) -> None:
    many = {"X": np.linspace(0.0, 500.0, 20_001)}
    with pytest.raises(ta.InputError, match="draws: is of the best fit of 20001 points; 20000 at most"):
        ta.predict(model, errors, many, draws=100, datum="best-fit")
    drawn = ta.predict(model, errors, many, draws=2).drawn
    last = ta.predict(model, errors, {"X": 500.0}, draws=2).drawn
    assert drawn is not None
    assert last is not None
    assert drawn.mean.shape == (4, 20_001)
    np.testing.assert_allclose(
        drawn.mean[:, -1:], last.mean, rtol=1e-12
    )  # all blocks have the same draws of the values
