"""Every function of `import trueaxis` gives what its command writes and prints, to the byte."""

import os
from pathlib import Path

import numpy as np
import pytest

import trueaxis as ta
from tests.evaluation.iso230_4.path import Mill, turn
from tests.instrument_files.writers import rtl
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main

ERRORS = ROOT / "machines" / "dmu60p_errors.json"
PLAN = ROOT / "machines" / "dmu60p_regular_runs"
KERNELS = ["--kernels", str(ROOT / "generated")]
PROGRAM = "G21 G90 G17\nG0 X0. Y0. Z0.\nG1 X270. Y350. Z150. F1000\nX530.\nG2 X430. Y350. I-50. J0.\nM2\n"


@pytest.fixture(scope="module")
def model() -> ta.MachineModel:
    return ta.load_model(DMU60P, ROOT / "generated")


@pytest.fixture(scope="module")
def values(model: ta.MachineModel, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Values of an estimate, with covariance and kept curves."""
    plan = ta.load_data(PLAN, model)
    data = ta.simulate(model, ta.load_errors(ERRORS, model), plan, noise_um=0.3, seed=3, replace_all=True)
    path = tmp_path_factory.mktemp("values") / "e.json"
    ta.save_errors(path, ta.identify(model, data).errors, model)
    return path


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder for the command, in it one for the function: both write under one name."""
    (tmp_path / "function").mkdir()
    monkeypatch.chdir(tmp_path)
    return tmp_path


def said(capsys: pytest.CaptureFixture[str], *words: object, code: int = 0) -> str:
    """What a command prints before the files that it names."""
    assert main([str(word) for word in words]) == code
    return capsys.readouterr().out.partition("\nwritten: ")[0].removesuffix("\n") + "\n"


def files_in(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_init(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    structure, travel = "[w C' Y' b X Z t]", {"X": (0.0, 600.0), "Y": (0.0, 400.0), "Z": (-150.0, 0.0)}
    words = [f"{axis}={low}:{high}" for axis, (low, high) in travel.items()]
    main(["init", "mill.toml", "--structure", structure, "--travel", *words, "--sense", "Y=-1"])
    told = capsys.readouterr().out
    os.chdir("function")
    made = ta.init("mill.toml", structure, travel, sense={"Y": -1})
    assert str(made) == told
    assert [(here / path.name).read_bytes() for path in made.files] == [path.read_bytes() for path in made.files]
    assert made.machine == ta.load_machine("mill.toml")
    assert "<td>Y</td>" in made._repr_html_()


def test_import_readings(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel) -> None:
    passes = np.array([[0.0, 1.5, -2.25, 3.0], [0.1, 1.4, -2.2, 3.1]])
    (here / "X.rtl").write_bytes(rtl([0.0, 100.0, 200.0, 300.0], passes, axis="X").encode())
    keys = ["target.point=0,0,-100.5", "at.Y=200", "at.Z=10"]
    main(["import", "X.rtl", "--machine", str(DMU60P), "--out", "data", "--map", *keys, *KERNELS])
    told = capsys.readouterr().out
    expected = files_in(here / "data")
    (here / "data").rename(here / "by_command")
    point = (0, 0, -100.5)
    done = ta.import_readings("X.rtl", model.machine, "data", keys={"target.point": point, "at.Y": 200, "at.Z": "10"})
    assert str(done) == told
    assert files_in(here / "data") == expected
    assert done.runs[0].readings == done.to_polars().height == 8
    assert set(done.runs[0].assumed) >= {"target.point", "at.Y", "at.Z"}
    with pytest.raises(ta.InputError, match="the file does not say the position of axis Y"):
        ta.import_readings(["X.rtl"], model, "other", keys={"target.point": (0, 0, 0), "at.Z": 1})
    assert not Path("other").exists()


def test_plan_from_nothing(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel) -> None:
    told = said(
        capsys, "plan", DMU60P, "--with", "laser", "--hours", 0.5, "--out", "made", "--report", "r.json", *KERNELS
    )
    done = ta.plan(model, instruments=["laser"], hours=0.5, out="function/made")
    assert str(done) == told
    assert done.to_json() == Path("r.json").read_text()
    assert files_in(here / "function" / "made") == files_in(here / "made")
    assert done.data.data.setup.runs[0].instrument == "laser"
    assert done.to_polars().columns == ["error", "state", "unit", "u", "u_rms", "prior"]
    assert done._repr_html_().startswith("<pre>")


def test_a_plan_judged_and_extended(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel) -> None:
    data = ta.load_data(PLAN, model)
    few = ["--runs", "X-1", "X-2", "--location-errors-only", "--tool-point", "0,0,-50", "--tool-point", "0,0,-150"]
    told = said(capsys, "plan", DMU60P, "--data", PLAN, *few, *KERNELS, code=1)
    tool = np.array([[0.0, 0.0, -50.0], [0.0, 0.0, -150.0]]).T
    done = ta.plan(model, data, runs=["X-1", "X-2"], location_errors_only=True, tool=tool)
    assert (str(done), done.folder, done.report.nothing_determined) == (told, None, True)
    with pytest.raises(ValueError, match="this plan is in no folder"):
        _ = done.data


def test_fit(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, values: Path) -> None:
    told = said(capsys, "fit", DMU60P, "--errors", values, "--out", "f.json", "--statistics", *KERNELS)
    done = ta.fit(model, ta.load_errors(values, model))
    assert done.text(statistics=True) == told
    assert set(str(done).splitlines()) < set(told.splitlines())
    ta.save_errors("function/f.json", done.errors, model)
    assert Path("function/f.json").read_bytes() == Path("f.json").read_bytes()
    assert Path("function/f.npz").read_bytes() == Path("f.npz").read_bytes()
    first = done.to_polars().filter(component="EXX")
    assert first["power"].to_list() == list(done.fits["EXX"].after.powers)
    with pytest.raises(ta.RefusedError, match="the largest standard uncertainty is") as refused:
        ta.fit(model, ta.load_errors(values, model), max_order=1, max_u=1e-4)
    assert isinstance(refused.value.result, ta.Fitted)


def test_compensate(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, values: Path) -> None:
    Path("p.nc").write_text(PROGRAM)
    errors = ta.load_errors(values, model)
    options = ["--tool-point", "0,0,-50", "--offset", "G54=X1.0,Y0:2,Z0", "--tolerance", "0.002", "--start", "X0Y0Z0"]
    told = said(capsys, "compensate", DMU60P, "--errors", values, "p.nc", "--out", "out.nc", *options, *KERNELS)
    done = ta.compensate(
        model, errors, "p.nc", "function/out.nc", tool=(0, 0, -50), offsets={"G54": {"X": 1.0, "Y": (0, 2), "Z": 0}},
        tolerance=0.002, start={"X": 0, "Y": 0, "Z": 0},
    )  # fmt: skip
    assert str(done) == told
    assert Path("function/out.nc").read_bytes() == Path("out.nc").read_bytes() == done.text.encode()
    assert done.programmed.shape == done.compensated.shape == (3, done.lines.size)
    # every point of the program, in machine coordinates, moved against the deviation there
    ends = {line: done.programmed[:, done.lines == line][:, -1].tolist() for line in set(done.lines.tolist())}
    assert ends == {2: [1.0, 1.0, 0.0], 3: [271.0, 351.0, 150.0], 4: [531.0, 351.0, 150.0], 5: [431.0, 351.0, 150.0]}
    deviation = ta.predict(model, errors, done.programmed, tool=(0, 0, -50)).deviation
    moved = model.ideal(done.compensated, np.array([[0.0], [0.0], [-50.0]])) - model.ideal(
        done.programmed, np.array([[0.0], [0.0], [-50.0]])
    )
    np.testing.assert_allclose(moved, -deviation, atol=1.1e-3)
    assert np.abs(done.correction).max() > 3e-3
    assert done.to_polars().columns == ["line", *"XYZ", "X_compensated", "Y_compensated", "Z_compensated"]
    again = ta.compensate(model, errors, Path("p.nc"), tools={1: 0.0}, dialect="linuxcnc")
    assert (again.file, again.text.count("TRUEAXIS COMPENSATED")) == (None, 1)


def test_a_compensation_is_refused_as_by_the_command(
    here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, values: Path
) -> None:
    Path("p.nc").write_text(PROGRAM)
    errors = ta.load_errors(values, model)
    for option, argument in (("--max-u", "max_u"), ("--max-correction", "max_correction")):
        words = ["compensate", DMU60P, "--errors", values, "p.nc", "--out", "out.nc", option, "0.0001", *KERNELS]
        told = said(capsys, *words, code=1)
        with pytest.raises(ta.RefusedError) as refused:
            ta.compensate(model, errors, "p.nc", "function/out.nc", **{argument: 1e-4})  # type: ignore[arg-type]
        assert f"out.nc: not written: {refused.value}" in told
        assert refused.value.result.text == ""
        assert not Path("out.nc").exists()
        assert not Path("function/out.nc").exists()


def test_diagnose(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel) -> None:
    few = PLAN / "setup.toml"
    Path("data").mkdir()
    heads = few.read_text().split("[[run]]")
    Path("data/setup.toml").write_text("[[run]]".join(heads[:3]))
    rows = (PLAN / "readings.csv").read_text().splitlines()
    kept = [rows[0], *(row for row in rows if row.startswith(("X-1,", "X-2,")))]
    Path("data/readings.csv").write_text("\n".join(kept) + "\n")
    errors = ta.load_errors(ERRORS, model)
    measured = ta.simulate(model, errors, ta.load_data("data", model), noise_um=0.3, seed=1, replace_all=True)
    ta.save_data("measured", measured)
    told = said(capsys, "diagnose", DMU60P, "--errors", ERRORS, "--data", "measured", "--out", "found", *KERNELS)
    done = ta.diagnose(model, ta.load_data("measured", model), errors, out="function/found")
    assert str(done) == told
    assert done.verdict in told
    assert files_in(here / "function" / "found") == files_in(here / "found")
    assert [path.name for path in done.files] == ["diagnosis.json", "report.html"]
    assert done._repr_html_().startswith("<table>")


def test_evaluate_a_positioning_test(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    draw = np.random.default_rng(1)
    rows = [
        f"{target:g},{cycle},{way},{target + 0.002 * (way > 0) + draw.normal(0.0, 0.001):.5f}"
        for target in (10.0, 90.0, 220.0, 310.0, 395.0)
        for cycle in range(1, 6)
        for way in (1, -1)
    ]
    Path("x.csv").write_text("target,cycle,direction,measured\n" + "\n".join(rows) + "\n")
    told = said(capsys, "evaluate", "x.csv", "--out", "r.json", "--repeatability", "unidirectional")
    done = ta.evaluate("x.csv", repeatability="unidirectional")
    assert isinstance(done, ta.EvaluatedPositioning)
    assert (str(done), done.to_json()) == (told, Path("r.json").read_text())
    assert done.to_polars()["reversal"].to_list() == done.evaluation.b.tolist()
    table = np.loadtxt("x.csv", delimiter=",", skiprows=1)  # rows by target, then by cycle, then +1 and -1
    measured = table[:, 3].reshape(5, 5, 2)
    by_arrays = ta.evaluate(ta.PositioningTest(table[::10, 0], measured[..., 0], measured[..., 1]))
    assert isinstance(by_arrays, ta.EvaluatedPositioning)
    np.testing.assert_allclose(by_arrays.evaluation.mean, done.evaluation.mean, atol=1e-12)
    with pytest.raises(ValueError, match=r"given \(5,\), \(4, 5\), \(5, 5\)"):
        ta.evaluate(ta.PositioningTest(table[::10, 0], measured[:4, :, 0], measured[..., 1]))
    with pytest.raises(ValueError, match="within 10 mm of their targets"):
        ta.evaluate(ta.PositioningTest(table[::10, 0], 1e3 * measured[..., 0], measured[..., 1]))
    with pytest.raises(ta.InputError, match=r"radius: x\.csv is a positioning test; leave it out"):
        ta.evaluate("x.csv", radius=150.0)


def test_evaluate_a_circular_test(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    angle = turn(1, 120)
    reading = Mill(squareness=5e-5, reversal=(-8e-3, 0.0)).read(angle, 1, 150.0, 1000.0)
    rows = [f"{np.degrees(a):.6f},{1e3 * d:.5f}" for a, d in zip(angle, reading, strict=True)]
    Path("ccw.csv").write_text("angle (deg),deviation (um)\n" + "\n".join(rows) + "\n")
    told = said(capsys, "evaluate", "ccw.csv", "--plane", "XY", "--radius", "150", "--out", "r.json")
    done = ta.evaluate(["ccw.csv"], plane="XY", radius=150.0)
    assert isinstance(done, ta.EvaluatedCircle)
    assert (str(done), done.to_json()) == (told, Path("r.json").read_text())
    assert set(done.to_polars()["error"].to_list()) >= {"reversal_error", "squareness"}
    with pytest.raises(ta.InputError, match=r"does not say the plane of the circle; plane XY"):
        ta.evaluate("ccw.csv", radius=150.0)


def test_report(here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, values: Path) -> None:
    words = ["--errors", values, "--against", ERRORS, "--out", "r.html", "--tool-point", "0,0,-50"]
    assert main(["report", *map(str, [DMU60P, *words, *KERNELS])]) == 0
    older = ta.load_errors(ERRORS, model)
    done = ta.report(model, ta.load_errors(values, model), "function/r.html", against=older, tool=(0, 0, -50))
    assert done.html == Path("r.html").read_text() == Path("function/r.html").read_text()
    assert done.content.machine == "dmu60p"


@pytest.mark.parametrize(("name", "out"), [("siemens-enc", "enc.ini"), ("heidenhain-com", "tables")])
def test_export(
    here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, values: Path, name: str, out: str
) -> None:
    words = ["export", DMU60P, "--errors", values, "--format", name, "--out", out, "--tool-point", "0,0,-50", *KERNELS]
    told = said(capsys, *words)
    errors = ta.load_errors(values, model)
    done = ta.export(model, errors, name, here / "function" / out, tool=(0, 0, -50))
    assert str(done) == told
    of_function, of_command = here / "function" / out, here / out
    if of_command.is_dir():
        assert files_in(of_function) == files_in(of_command)
    else:
        assert of_function.read_bytes() == of_command.read_bytes() == done.texts[""].encode()
    told = said(capsys, *words, "--max-u", "0.0001", "--max-correction", "0.0001", code=1)
    with pytest.raises(ta.RefusedError) as refused:
        ta.export(model, errors, name, tool=(0, 0, -50), max_u=1e-4, max_correction=1e-4)
    assert [f"{out}: not written: {one}" for one in refused.value.reasons] == told.splitlines()[-2:]
    assert refused.value.result.files == ()
