"""What a command refuses its function refuses too; wrong arguments are told with what was expected and given."""

import json
import re
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import polars as pl
import pytest

import trueaxis as ta
from tests.machines import DMU60P, ROOT
from trueaxis.cli.main import main

ERRORS = ROOT / "machines" / "dmu60p_errors.json"
PLAN = ROOT / "machines" / "dmu60p_regular_runs"
KERNELS = ["--kernels", str(ROOT / "generated")]
PROGRAM = "G21 G90 G17\nG0 X0. Y0. Z0.\nG1 X270. Y350. Z150. F1000\nM2\n"


@pytest.fixture(scope="module")
def model() -> ta.MachineModel:
    return ta.load_model(DMU60P, ROOT / "generated")


@pytest.fixture(scope="module")
def errors(model: ta.MachineModel) -> ta.Errors:
    return ta.load_errors(ERRORS, model)


@pytest.fixture(scope="module")
def data(model: ta.MachineModel) -> ta.DataFolder:
    return ta.load_data(PLAN, model)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    Path("p.nc").write_text(PROGRAM)
    return tmp_path


# of `plan`: arguments, and the same as options; each is refused for what does not go together
PLANS: list[tuple[dict[str, Any], list[str]]] = [
    ({"instruments": ["laser"]}, ["--with", "laser"]),
    ({"hours": 1.0}, ["--hours", "1"]),
    ({"propose_with": ["probe"]}, ["--propose-with", "probe"]),
    ({"wanted": "EYX"}, ["--for", "EYX"]),
    ({"wanted": "EWX", "propose": 1}, ["--for", "EWX", "--propose", "1"]),
    ({"out": "made"}, ["--out", "made"]),
    ({"out": "made", "propose": 1, "runs": ["X-1"]}, ["--out", "made", "--propose", "1", "--runs", "X-1"]),
    ({"runs": ["no-such"]}, ["--runs", "no-such"]),
    ({"noise_um": ta.NoiseModel(repeats="run")}, ["--noise-um", "repeats-by-run"]),
]


@pytest.mark.parametrize(("arguments", "options"), PLANS, ids=[" ".join(one) for _, one in PLANS])
def test_a_plan(
    here: Path,
    capsys: pytest.CaptureFixture[str],
    model: ta.MachineModel,
    data: ta.DataFolder,
    arguments: dict[str, Any],
    options: list[str],
) -> None:
    assert main(["plan", str(DMU60P), "--data", str(PLAN), *options, *KERNELS]) == 2
    told = capsys.readouterr().err.splitlines()
    with pytest.raises(ta.InputError) as refused:
        ta.plan(model, data, **arguments)
    # the same faults, arguments in the place of options
    spelled = [re.sub(r"--([a-z-]+)", lambda one: _argument(one[1]), line.removeprefix("trueaxis: ")) for line in told]
    assert str(refused.value).splitlines() == spelled
    assert not Path("made").exists()


def _argument(option: str) -> str:
    return {"with": "instruments", "for": "wanted"}.get(option, option.replace("-", "_"))


def test_a_first_plan(here: Path, model: ta.MachineModel) -> None:
    with pytest.raises(ta.InputError, match="data: is missing; a folder with a plan, or instruments laser ballbar"):
        ta.plan(model)
    with pytest.raises(ta.InputError, match="propose: goes with a plan that is there"):
        ta.plan(model, instruments=["laser"], propose=2)
    with pytest.raises(ta.RefusedError, match=r"fits into 0\.01 h"):
        ta.plan(model, instruments=["laser"], hours=0.01, out="made")
    assert not Path("made").exists()


def misfit(errors: ta.Errors) -> ta.Errors:
    text = json.loads(ERRORS.read_text())
    text["fit"] = {"state": "misfit", "chi2": 900.0, "runs": ["X-1"]}
    Path("bad.json").write_text(json.dumps(text))
    assert errors.machine is not None
    return ta.load_errors("bad.json", errors.machine)


def test_a_misfit_is_taken_on_request_alone(
    here: Path, capsys: pytest.CaptureFixture[str], model: ta.MachineModel, errors: ta.Errors
) -> None:
    bad = misfit(errors)
    calls: dict[str, Callable[..., object]] = {
        "compensate": lambda **accepted: ta.compensate(model, bad, "p.nc", "out.nc", **accepted),
        "export": lambda **accepted: ta.export(model, bad, "siemens-enc", "out.ini", **accepted),
        "fit": lambda **accepted: ta.fit(model, bad, **accepted),
    }
    words = {"compensate": ["p.nc"], "export": ["--format", "siemens-enc"], "fit": []}
    for name, call in calls.items():
        command = [name, str(DMU60P), "--errors", "bad.json", *words[name], "--out", "o", *KERNELS]
        assert main(command) == 2
        told = capsys.readouterr().err.removeprefix("trueaxis: ").strip()
        with pytest.raises(ta.InputError) as refused:
            call()
        assert str(refused.value) == told.replace("--accept-misfit", "accept_misfit"), name
    assert sorted(path.name for path in here.iterdir()) == ["bad.json", "p.nc"]
    assert ta.export(model, bad, "siemens-enc", accept_misfit=True).files == ()


def test_values_that_were_edited_have_no_covariance(model: ta.MachineModel, errors: ta.Errors) -> None:
    other = replace(errors, values=replace(errors.values, parameters={"eps_xy": 1e-4}))
    of_others = replace(other, covariance=replace(errors.covariance, sha256_of_values="0" * 64))
    with pytest.raises(ta.InputError, match="is the covariance of other values"):
        ta.export(model, of_others, "siemens-enc")
    with pytest.raises(ValueError, match="errors: expected those of dmu60p; given those of lathe"):
        ta.report(model, replace(errors, values=replace(errors.values, machine="lathe")))


def test_nothing_that_is_read_is_written_over(here: Path, model: ta.MachineModel, errors: ta.Errors) -> None:
    for call, problem in (
        (lambda: ta.compensate(model, errors, "p.nc", "p.nc"), "is both program, which is read, and out"),
        (lambda: ta.export(model, errors, "siemens-enc", ERRORS), "is both the file of the errors"),
        (lambda: ta.report(model, errors, DMU60P), "is both the spec"),
        (lambda: ta.report(model, errors, ROOT / "generated" / "dmu60p" / "x.html"), "lies among the kernels"),
        (lambda: ta.init("mill.toml", "[w Y' b X Z t]", {"X": (0, 1), "Y": (0, 1)}), "Z: is missing"),
    ):
        with pytest.raises(ta.InputError, match=problem):
            call()
    assert Path("p.nc").read_text() == PROGRAM
    assert [path.name for path in here.iterdir()] == ["p.nc"]


def test_a_spec_that_was_changed_is_no_ground_for_a_diagnosis(
    here: Path, model: ta.MachineModel, errors: ta.Errors, data: ta.DataFolder
) -> None:
    with pytest.raises(ta.InputError, match="is a plan: there is no reading in it"):
        ta.diagnose(model, data, errors, out="found")
    Path("own.toml").write_text(DMU60P.read_text().replace("540.0", "541.0"))
    changed = replace(model, machine=replace(model.machine, source=Path("own.toml")))
    with pytest.raises(ta.InputError, match="was changed since the model was loaded"):
        ta.diagnose(changed, data, errors, out="found")
    with pytest.raises(ValueError, match="model: expected one whose spec is in a file"):
        ta.diagnose(replace(model, machine=replace(model.machine, source=None)), data)
    assert not Path("found").exists()


WRONG: list[tuple[str, dict[str, Any], str]] = [
    ("compensate", {"tool": (0, 0)}, "tool: expected shape (3,) or (3, 1), mm; given (2,)"),
    ("compensate", {"format": "pdf"}, "format: expected nc or apt; given 'pdf'"),
    ("compensate", {"max_u": -1.0}, "max_u: expected a finite number, at least 0; given -1.0"),
    ("compensate", {"max_correction": 0.0}, "max_correction: expected a finite number above 0; given 0.0"),
    ("compensate", {"tolerance": -1.0}, "tolerance is -1; it must be above 0 and at most 1"),
    ("compensate", {"words": "many"}, "words: expected one of nearest, ends, middles; given 'many'"),
    ("compensate", {"ball": (1, 2)}, "ball: expected three finite numbers; given (1, 2)"),
    ("compensate", {"start": {"X": "far"}}, "start['X']: expected a finite number; given 'far'"),
    ("compensate", {"start": {"C": 0.0}}, "this machine has no axis C"),
    ("compensate", {"pass_m": ("M70",)}, "pass_m: expected whole numbers"),
    ("compensate", {"pass_g": "187"}, "pass_g: expected numbers, such as (187, 5.1); given '187'"),
    ("compensate", {"offsets": {"G53": {"X": 1.0}}}, "offsets: expected G54 to G59"),
    ("compensate", {"offsets": {"G54": {"W": 1.0}}}, "offsets['G54']: expected axes among X, Y, Z, A, B, C; given W"),
    ("compensate", {"offsets": {"G54": {"X": (5, 1)}}}, "offsets['G54']['X']: goes from 5 down to 1"),
    ("compensate", {"tools": {1: 1e6}}, "tools[1]: expected lengths in mm, up to 2000"),
    ("compensate", {"tools": {"T1": 100.0}}, "tools: expected numbers of tools"),
    ("compensate", {"program": "G0 X0\nG1 X1 F10\n"}, "program: expected the path of a file; given a text of 3 lines"),
    ("compensate", {"wobble": 1}, "compensate: no argument wobble; settings are tolerance"),
    ("export", {"format": "fanuc"}, "format: expected one of isg-csv, siemens-enc"),
    ("export", {"step": 0.0}, "step: expected a finite number above 0; given 0.0"),
    ("fit", {"max_order": 99}, "max_order: expected a whole number from 1 to 15; given 99"),
    ("fit", {"alpha": 2.0}, "alpha: expected a number above 0 and below 1; given 2.0"),
    ("plan", {"instruments": "laser"}, "instruments: expected a list, of laser, ballbar, probe, angle; given 'laser'"),
    ("plan", {"propose": 0}, "propose: expected a whole number from 1 to 100; given 0"),
    (
        "plan",
        {"tool": np.zeros((2, 3))},
        "tool: expected finite numbers of shape (3,) or (3, n), mm; given shape (2, 3)",
    ),
    ("plan", {"datum": "moon"}, "datum: expected one of home, best-fit; given 'moon'"),
    ("diagnose", {"noise_um": 1e9}, "noise_um: expected micrometres from 1e-06 to 10000"),
    ("report", {"tool": "far"}, "tool: expected numbers; given 'far'"),
    ("report", {"model": "mill.toml"}, "model: expected a MachineModel, from load_model; given 'mill.toml'"),
    ("report", {"errors": "e.json"}, "errors: expected Errors, from load_errors or identify; given 'e.json'"),
    ("report", {"out": 5}, "out: expected a path or None; given 5"),
    (
        "report",
        {"against": {}},
        "against: expected Errors, from load_errors or identify or None; given a value of class dict",
    ),
    ("diagnose", {"data": "runs"}, "data: expected a DataFolder, from load_data or simulate; given 'runs'"),
    ("diagnose", {"noise_um": "0.5"}, "noise_um: expected a number or None; given '0.5'"),
    ("identify", {"prior": "none"}, "prior: expected True or False; given 'none'"),
    ("identify", {"runs": "X-1"}, "runs: expected a list; given 'X-1'"),
    ("identify", {"degree": 2.5}, "degree: expected a whole number or None; given 2.5"),
    ("identify", {"noise_um": "repeat"}, "noise_um: expected one of repeats, repeats-by-run; given 'repeat'"),
    ("predict", {"draws": 1.5}, "draws: expected Draws or a whole number or None; given 1.5"),
    ("predict", {"context": "cold"}, "context: expected a Context or None; given 'cold'"),
    ("predict", {"positions": {}}, "positions: expected positions of some of X, Y, Z"),
    ("predict", {"positions": {"X": "12"}}, "positions['X']: expected numbers; given '12'"),
    ("predict", {"positions": {"X": True}}, "positions['X']: expected numbers; given True"),
    (
        "predict",
        {"positions": {"X": [1.0, 5e3], "Y": -9}},
        "X = 5000 is outside its travel, from 0 to 540; Y = -9 is outside",
    ),
    ("simulate", {"seed": "a"}, "seed: expected a whole number; given 'a'"),
    ("load_errors", {"machine": "mill.toml"}, "from load_model; given 'mill.toml'"),
    ("save_errors", {"errors": 3.0}, "errors: expected Errors, from load_errors or identify; given 3.0"),
    ("load_model", {"machine": 5}, "machine: expected a path; given 5"),
    ("evaluate", {"plane": "XX"}, "plane: expected one of XY, XZ, YX, YZ, ZX, ZY; given 'XX'"),
    ("evaluate", {"radius": -1.0}, "radius: expected a finite number above 0; given -1.0"),
    ("evaluate", {"keys": {"axis": None}}, "keys['axis']: expected a text, a number or numbers; given None"),
    ("import_readings", {"format": "xls"}, "format: expected one of rtl, iso230-2, ballbar-csv, csv; given 'xls'"),
    ("import_readings", {"files": []}, "files: expected a file or several; given none"),
    ("init", {"travel": {"X": (5.0, 1.0)}}, "travel['X']: expected (lowest, highest), mm or deg; given (5.0, 1.0)"),
    ("init", {"sense": {"X": 2}}, "sense['X']: expected 1 or -1; given 2"),
]


@pytest.mark.parametrize(
    ("name", "changed", "told"), WRONG, ids=[f"{name} {next(iter(one))}" for name, one, _ in WRONG]
)
def test_wrong_arguments_are_told(
    here: Path,
    model: ta.MachineModel,
    errors: ta.Errors,
    data: ta.DataFolder,
    name: str,
    changed: dict[str, Any],
    told: str,
) -> None:
    given: dict[str, dict[str, Any]] = {
        "compensate": {"model": model, "errors": errors, "program": "p.nc"},
        "export": {"model": model, "errors": errors, "format": "siemens-enc"},
        "fit": {"model": model, "errors": errors},
        "plan": {"model": model, "data": data},
        "diagnose": {"model": model, "data": data},
        "report": {"model": model, "errors": errors},
        "identify": {"model": model, "data": data},
        "predict": {"model": model, "errors": errors, "positions": {"X": 1.0}},
        "simulate": {"model": model, "errors": errors, "plan": data},
        "load_errors": {"path": ERRORS, "machine": model},
        "save_errors": {"path": "out.json", "errors": errors, "machine": model},
        "load_model": {"machine": DMU60P},
        "evaluate": {"data": "x.csv"},
        "import_readings": {"files": "x.rtl", "machine": model, "out": "data"},
        "init": {"spec": "mill.toml", "structure": "[w b X Z t]", "travel": {"X": (0.0, 1.0), "Z": (0.0, 1.0)}},
    }
    with pytest.raises((ValueError, TypeError), match=re.escape(told)):
        getattr(ta, name)(**{**given[name], **changed})
    assert [path.name for path in here.iterdir()] == ["p.nc"]


def test_numbers_and_tables_of_other_libraries_are_taken(model: ta.MachineModel, errors: ta.Errors) -> None:
    wanted = ta.predict(model, errors, {"X": [10.0, 20.0], "Z": 5.0}).deviation
    table = {"X": [10.0, 20.0], "Z": [5.0, 5.0]}
    tables: list[Any] = [pl.DataFrame(table), pd.DataFrame(table)]
    for positions in (*tables, {"X": np.array([10, 20]), "Z": np.float32(5.0)}):
        assert (ta.predict(model, errors, positions).deviation == wanted).all()


def test_what_comes_back_is_printed_in_a_few_words(
    model: ta.MachineModel, errors: ta.Errors, data: ta.DataFolder
) -> None:
    assert str(model) == str(model.machine)
    assert str(model).startswith("dmu60p: ")
    assert "X 0 to 540" in str(model)
    assert re.match(r"\| error +\| unit +\| value", str(errors).splitlines()[1])
    assert len(str(errors).splitlines()) == errors.to_polars().height + 3
    assert re.fullmatch(r".*dmu60p_regular_runs: \d+ readings in 18 runs \(.*\)", str(data))
    assert str(data) in data._repr_html_().replace("&amp;", "&")


def test_a_table_asks_for_pandas_by_name(errors: ta.Errors, monkeypatch: pytest.MonkeyPatch) -> None:
    frame = errors.to_pandas()
    assert list(frame["error"]) == errors.to_polars()["error"].to_list()
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ModuleNotFoundError, match=r"needs the package pandas: pip install 'trueaxis\[pandas\]'"):
        errors.to_pandas()


def test_machine_and_errors_are_tables_in_a_notebook(model: ta.MachineModel, errors: ta.Errors) -> None:
    assert model._repr_html_() == model.machine._repr_html_()
    assert "<td>X slide carriage</td>" in model._repr_html_()
    assert errors._repr_html_().startswith("<table><caption>dmu60p: error values")
    table = {row["error"]: row for row in errors.to_polars().iter_rows(named=True)}
    curve = errors.values.motion_errors["EXX"]
    assert table["EXX"]["value"] == pytest.approx(float(curve(np.array([table["EXX"]["at"]]))[0]))
    assert abs(table["EXX"]["value"]) == pytest.approx(np.abs(curve(np.linspace(0.0, 540.0, 5000))).max(), rel=0.01)
    assert (table["eps_xy"]["unit"], table["EXX"]["unit"], table["EAX"]["unit"]) == ("rad", "mm", "rad")


def test_nothing_is_imported_before_it_is_used() -> None:
    script = (
        "import sys, trueaxis as ta\n"
        "heavy = {'numpy', 'polars', 'scipy', 'sympy', 'jinja2', 'matplotlib', 'pandas', 'statsmodels'}\n"
        "assert not heavy & set(sys.modules)\n"
        "[getattr(ta, name) for name in ta.__all__]\n"
        "print(sorted({'sympy', 'jinja2', 'matplotlib', 'pandas', 'statsmodels'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


# of `identify`
CHOICES: list[tuple[dict[str, Any], list[str]]] = [
    ({"squareness": "from-angles"}, ["--squareness", "from-angles"]),
    ({"curves": "polynomial"}, ["--curves", "polynomial"]),
    ({"squareness": "known"}, ["--squareness", "known"]),
    ({"method": "stepwise", "noise_um": {"laser": 1.0}}, ["--method", "stepwise", "--noise-um", "laser=1"]),
    ({"method": "stepwise", "degree": 5}, ["--method", "stepwise", "--degree", "5"]),
    ({"method": "stepwise", "ideal_instruments": True}, ["--method", "stepwise", "--instruments", "ideal"]),
    ({"method": "stepwise", "prior": False}, ["--method", "stepwise", "--prior", "none"]),
]


@pytest.mark.parametrize(("arguments", "options"), CHOICES, ids=[" ".join(one) for _, one in CHOICES])
def test_an_identification(
    here: Path,
    capsys: pytest.CaptureFixture[str],
    model: ta.MachineModel,
    data: ta.DataFolder,
    arguments: dict[str, Any],
    options: list[str],
) -> None:
    assert main(["identify", str(DMU60P), "--data", str(PLAN), "--out", "e.json", *options, *KERNELS]) == 2
    told = capsys.readouterr().err.removeprefix("trueaxis: ").rstrip()
    with pytest.raises(ta.InputError) as refused:
        ta.identify(model, data, **arguments)
    spelled = re.sub(
        r"--([a-z-]+)", lambda one: {"instruments": "ideal_instruments"}.get(one[1], _argument(one[1])), told
    )
    assert str(refused.value) == spelled


def test_words_that_are_none_are_told(model: ta.MachineModel, errors: ta.Errors, data: ta.DataFolder) -> None:
    with pytest.raises(ValueError, match="method: expected one of global, stepwise; given 'paper'"):
        ta.identify(model, data, method="paper")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="degree: expected a whole number from 1 to 30; given 99"):
        ta.identify(model, data, degree=99)
    with pytest.raises(ValueError, match="datum: expected one of machine, home, best-fit; given 'moon'"):
        ta.predict(model, errors, {"X": 1.0}, datum="moon")  # type: ignore[arg-type]
