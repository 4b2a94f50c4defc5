"""trueaxis diagnose, as a user runs it: what it refuses, what it writes, what it says."""

import io
import json
import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from tests.command_lines import SMALL, SMALL_RUN
from tests.diagnosis.prepared import prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.identification.data import TRAVEL, paper_runs
from tests.kept import derived
from tests.kernels import emitted
from tests.machines import DMU60P, ROOT
from tests.reporting.diagnosis.builders import cause, diagnosis
from trueaxis.cli.main import main
from trueaxis.cli.progress import progress
from trueaxis.diagnosis.extend import reidentified
from trueaxis.diagnosis.extended_spec import Extended
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.effects.kind import Effect as EffectOf
from trueaxis.estimation.observations import observations
from trueaxis.io.told import Told
from trueaxis.jobs.extending import Extending, Given
from trueaxis.measurement.setup import Run, run_table
from trueaxis.model.manifest import KERNEL_FILES

ERRORS = ROOT / "machines" / "dmu60p_errors.json"
KERNELS = ROOT / "generated"
FloatArray = npt.NDArray[np.float64]
WIDTH, SIGMA = 0.006, 0.0003


def diagnose(out: Path, data: Path, *options: str, machine: Path = DMU60P, errors: Path | None = ERRORS) -> int:
    words = ["diagnose", str(machine), "--data", str(data), "--out", str(out), "--kernels", str(KERNELS), *options]
    return main(words if errors is None else [*words, "--errors", str(errors)])


def no_effect(run: Run, positions: FloatArray, directions: FloatArray) -> FloatArray:
    return np.zeros(positions.shape[1])


def backlash(run: Run, positions: FloatArray, directions: FloatArray) -> FloatArray:
    """Lost motion of X (EXX by half the width in the direction of approach), as lasers along X sense it."""
    assert run.direction is not None
    along = run.direction[0] if run.target.on == "tool" else -run.direction[0] * (run.reference.on == "tool")
    return np.asarray(along * WIDTH / 2 * directions[0])


@pytest.fixture(scope="module")
def plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The paper's lines of nine targets, each three times to and fro, read without noise or effects by `simulate`."""
    return lines_of(9, tmp_path_factory.mktemp("plan"))


@pytest.fixture(scope="module")
def short_plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The same of five targets: runs that were read wrongly are as plain in half of the readings."""
    return lines_of(5, tmp_path_factory.mktemp("short"))


def lines_of(targets: int, folder: Path) -> Path:
    runs = paper_runs()
    rows = ["run,seq,time_s,X,Y,Z,dir_X,dir_Y,dir_Z,reading"]
    jitter = np.random.default_rng(5).uniform(-4.0, 4.0, targets)
    clock = 0.0
    for run in runs:
        steps = np.linspace(0.04, 0.96, targets)
        ways = [(k, 1) for k in range(targets)] + [(k, -1) for k in reversed(range(targets))]
        for seq, (k, way) in enumerate(ways * 3):
            moving = run.id.split("-")[0]
            at = {a: TRAVEL[a] * steps[k] + jitter[k] if a in moving else 0.0 for a in "XYZ"}
            signs = ",".join(str(way if a in moving else 0) for a in "XYZ")
            rows.append(f"{run.id},{seq},{clock:.1f},{at['X']:.4f},{at['Y']:.4f},{at['Z']:.4f},{signs},")
            clock += 7.0
    (folder / "setup.toml").write_text('schema = 1\nmachine = "dmu60p"\n\n' + "\n".join(run_table(run) for run in runs))
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    out = folder / "read"
    words = ["simulate", str(DMU60P), "--errors", str(ERRORS), "--data", str(folder), "--out", str(out)]
    assert main([*words, "--kernels", str(KERNELS)]) == 0
    return out


Effect = Callable[[Run, FloatArray, FloatArray], FloatArray]


def measured(plan: Path, folder: Path, effect: Effect, seed: int, sigma: float = SIGMA) -> Path:
    """The readings of the plan with an effect in closed form and noise of their own."""
    folder.mkdir()
    (folder / "setup.toml").write_text((plan / "setup.toml").read_text())
    lines = (plan / "readings.csv").read_text().splitlines()
    names = lines[0].split(",")
    table = [line.split(",") for line in lines[1:]]
    noise = np.random.default_rng(seed).normal(0.0, sigma, len(table))
    positions = np.array([[float(row[names.index(a)]) for row in table] for a in "XYZ"])
    directions = np.array([[float(row[names.index(f"dir_{a}")]) for row in table] for a in "XYZ"])
    of_run = np.array([row[names.index("run")] for row in table])
    added = np.zeros(len(table))
    for run in paper_runs():
        mine = of_run == run.id
        added[mine] = effect(run, positions[:, mine], directions[:, mine])
    place = names.index("reading")
    for row, more in zip(table, added + noise, strict=True):
        row[place] = repr(float(row[place]) + float(more))
    (folder / "readings.csv").write_text("\n".join([lines[0], *(",".join(row) for row in table)]) + "\n")
    return folder


def readings_by_run(folder: Path) -> tuple[list[str], FloatArray]:
    lines = (folder / "readings.csv").read_text().splitlines()
    names = lines[0].split(",")
    table = [line.split(",") for line in lines[1:]]
    return [row[names.index("run")] for row in table], np.array([float(row[names.index("reading")]) for row in table])


class TestFaults:
    def test_those_of_errors_data_and_options_are_told_together_and_nothing_is_written(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        out, errors = tmp_path / "out", tmp_path / "errors.json"
        out.write_text("a file")
        errors.write_text('{"schema": 1, "machine": "other", "parameters": {"no_such": 1}}')
        assert diagnose(out, tmp_path / "nowhere", "--kernels", str(tmp_path / "none"), errors=errors) == 2
        shown = capsys.readouterr()
        assert shown.out == ""
        for words in (
            f"{out}: is a file; a folder for --out",
            f'{errors}: machine: "other" is another machine',
            f"{errors}: parameters.no_such",
            f"{tmp_path / 'nowhere' / 'setup.toml'}: there is no such file",
            f"{tmp_path / 'nowhere' / 'readings.csv'}: there is no such file",
            "there are no kernels of this machine",
        ):
            assert words in shown.err
        assert all(line.startswith("trueaxis: ") for line in shown.err.splitlines())
        assert sorted(tmp_path.iterdir()) == [errors, out]

    def test_a_faulty_spec_is_told_with_the_faults_of_options(
        self, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        spec, out = tmp_path / "m.toml", tmp_path / "out"
        spec.write_text(DMU60P.read_text().replace("schema = 1", "schema = 2"))
        out.write_text("")
        assert diagnose(out, tmp_path, machine=spec) == 2
        told = capsys.readouterr().err
        assert "key schema" in told
        assert "is a file" in told

    def test_a_plan_without_readings_is_refused(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        assert diagnose(tmp_path / "out", ROOT / "machines" / "dmu60p_regular_runs") == 2
        assert "there is no reading in it" in capsys.readouterr().err
        assert not (tmp_path / "out").exists()

    def test_runs_of_the_spec_that_are_not_there(self, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        spec = tmp_path / "dmu60p.toml"
        spec.write_text(DMU60P.read_text())
        assert diagnose(tmp_path / "out", tmp_path / "nowhere", machine=spec) == 2
        told = capsys.readouterr().err
        assert "key runs: there is no folder" in told
        assert "nowhere" in told

    @pytest.mark.parametrize("noise", ["0", "-1", "nan", "much"])
    def test_a_noise_that_is_none(self, noise: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
        with pytest.raises(SystemExit) as stop:
            diagnose(tmp_path / "out", tmp_path, "--noise-um", noise)
        assert stop.value.code == 2
        assert "a number of micrometres from 1e-06 to 10000" in capsys.readouterr().err

    @pytest.mark.parametrize(
        ("inputs", "words"),
        [
            ({"machine": "out/dmu60p.toml"}, "is both MACHINE.toml, which is read, and dmu60p.toml of --out"),
            ({"errors": "out/errors.json"}, "is both --errors, which is read, and errors.json of --out"),
            (
                {"kernels": "out/generated"},
                "kernels.c of --out lies among the kernels of",
            ),
        ],
    )
    def test_what_is_read_is_not_written_over(
        self, inputs: dict[str, str], words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        out = tmp_path / "out"
        out.mkdir()
        places = {name: tmp_path / path for name, path in inputs.items()}
        sources = {"machine": DMU60P, "errors": ERRORS}
        for name, path in places.items():
            if name in sources:
                path.write_bytes(sources[name].read_bytes())
        before = {path: path.read_bytes() for path in out.rglob("*") if path.is_file()}
        options = ["--kernels", str(places["kernels"])] if "kernels" in places else []
        machine, errors = places.get("machine", DMU60P), places.get("errors", ERRORS)
        assert diagnose(out, tmp_path, *options, machine=machine, errors=errors) == 2
        assert words in capsys.readouterr().err
        assert {path: path.read_bytes() for path in out.rglob("*") if path.is_file()} == before


def looked_at(monkeypatch: pytest.MonkeyPatch, terminal: bool) -> io.StringIO:
    """What standard error shows, where it is a terminal or not."""
    shown = io.StringIO()
    monkeypatch.setattr(shown, "isatty", lambda: terminal)
    monkeypatch.setattr("sys.stderr", Told(shown))
    return shown


class TestProgress:
    def test_a_terminal_sees_each_stage_and_is_left_clean(self, monkeypatch: pytest.MonkeyPatch) -> None:
        terminal = looked_at(monkeypatch, True)
        with progress() as show:
            show("reading")
            show("noise")
        assert terminal.getvalue() == "\rreading\x1b[K\r\rnoise\x1b[K\r\r\x1b[K\r"

    def test_a_terminal_is_left_clean_by_what_fails(self, monkeypatch: pytest.MonkeyPatch) -> None:
        terminal = looked_at(monkeypatch, True)

        def fail() -> None:
            with progress() as show:
                show("reading")
                raise KeyError

        with pytest.raises(KeyError):
            fail()
        assert terminal.getvalue().endswith("\r\x1b[K\r")

    def test_a_pipe_sees_nothing(self, monkeypatch: pytest.MonkeyPatch) -> None:
        pipe = looked_at(monkeypatch, False)
        with progress() as show:
            show("reading")
        assert pipe.getvalue() == ""


@pytest.fixture(scope="module")
def out(plan: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What is written for readings with backlash."""
    folder = tmp_path_factory.mktemp("diagnosed")
    data = measured(plan, folder / "data", backlash, seed=11)
    assert diagnose(folder / "out", data) == 0
    return folder / "out"


def altered(plan: Path, folder: Path, changes: Callable[[list[str], FloatArray], FloatArray]) -> Path:
    """Readings without an effect, changed by run."""
    data = measured(plan, folder, no_effect, seed=5)
    runs, values = readings_by_run(data)
    changed = changes(runs, values)
    lines = (data / "readings.csv").read_text().splitlines()
    place = lines[0].split(",").index("reading")
    rows = [line.split(",") for line in lines[1:]]
    for row, value in zip(rows, changed.tolist(), strict=True):
        row[place] = repr(value)
    (data / "readings.csv").write_text("\n".join([lines[0], *(",".join(row) for row in rows)]) + "\n")
    return data


def reversed_run(runs: list[str], values: FloatArray) -> FloatArray:
    return np.where(np.array(runs) == "Y-5", -values, values)


def swapped_runs(runs: list[str], values: FloatArray) -> FloatArray:
    of_run, found = np.array(runs), values.copy()
    found[of_run == "X-1"], found[of_run == "Z-7"] = values[of_run == "Z-7"], values[of_run == "X-1"]
    return found


@pytest.mark.usefixtures("without_second_process")
@pytest.mark.parametrize(("changes", "named"), [(reversed_run, {"Y-5"}), (swapped_runs, {"X-1", "Z-7"})])
def test_runs_that_no_machine_fits_are_named_and_no_cause_beside_them(
    short_plan: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    changes: Callable[[list[str], FloatArray], FloatArray],
    named: set[str],
) -> None:
    assert diagnose(tmp_path / "out", altered(short_plan, tmp_path / "data", changes)) == 1
    assert "no errors of the machine fit" in capsys.readouterr().out
    told = json.loads((tmp_path / "out" / "diagnosis.json").read_text())
    assert (told["verdict"], told["causes"], told["extended_machine"]) == ("unexplained_structure", [], None)
    assert told["misfits"][0] in named
    assert not (tmp_path / "out" / "dmu60p.toml").exists()


def test_a_location_error_that_the_spec_left_out_is_identified_with_kernels_derived_for_it(tmp_path: Path) -> None:
    """The machine with it has one parameter more than the kernels at hand."""
    plan = Design(lines=2, repeats=2, targets=9, samples=36, feeds=(1000.0,))
    given = prepared(Case(4, design=plan, effects=(Hidden("squareness", "EC0X", size=8e-5),), given="exact"))
    assert "EC0X" not in given.model.parameters
    text = given.generated.spec
    named = replace(diagnosis("explained"), causes=(cause(EffectOf(kind="squareness", component="EC0X")),))

    def start(function: str, found: Diagnosis, extended: Extended) -> Callable[[], object]:
        assert (function, found) == ("drawn_and_derived", named)
        folder = emitted(extended.text) / extended.machine.name
        return lambda: (None, {"kernels.py": (folder / "kernels.py").read_bytes()})

    model = Extending(tmp_path, Given(model=given.model, covariance=None, data=given.data, spec=text, runs=()), start)(
        named
    )
    assert "EC0X" in model.parameters
    observed = observations("here", given.data.setup.runs, given.data.readings)
    values, table, _ = reidentified(model, given.model.errors, observed)
    assert values.parameters["EC0X"] == pytest.approx(8e-5, abs=1e-5)
    assert "EC0X" in [one.name for one in table]


class TestRun:
    def test_the_cause_is_named(self, out: Path) -> None:
        told = json.loads((out / "diagnosis.json").read_text())
        assert told["verdict"] == "explained"
        (cause,) = told["causes"]
        assert (cause["effect"], cause["component"], cause["cannot_be_told_from"]) == ("backlash", "EXX", [])
        width = cause["parameters"]["width"]
        assert width["unit"] == "mm"
        assert abs(width["value"] - WIDTH) < 4 * width["u"] < 0.1 * WIDTH
        assert (told["extended_machine"], told["extended_errors"]) == ("dmu60p.toml", "errors.json")
        assert told["gain"]["rms_um"]["extended"] < 1.1e3 * SIGMA < told["gain"]["rms_um"]["refitted"]

    def test_the_extended_spec_is_the_given_one_and_the_effect(self, out: Path) -> None:
        text, given = (out / "dmu60p.toml").read_text(), DMU60P.read_text()
        added = text.index("\n# Found by")
        runs = tomllib.loads(text)["runs"]
        assert text[:added] == given.replace('"dmu60p_runs"', f'"{runs}"')
        assert (out / runs).resolve() == ROOT / "machines" / "dmu60p_runs"
        assert tomllib.loads(text)["effect"] == [{"kind": "backlash", "component": "EXX"}]

    @pytest.mark.usefixtures("without_second_process")
    def test_without_error_values_all_are_zero(self, tmp_path: Path) -> None:
        """A machine of one axis will do, which is soon diagnosed; with other values the diagnosis is another."""
        spec, data = tmp_path / "small.toml", tmp_path / "data"
        spec.write_text(SMALL)
        data.mkdir()
        (data / "setup.toml").write_text(SMALL_RUN)
        noise, way = np.random.default_rng(11).normal(0.0, SIGMA, 132), np.tile(np.repeat([1, -1], 22), 3)
        x = np.tile(np.r_[0:22, 21:-1:-1] * 30.0 - 280.0, 3)
        read = 1e-7 * x**2 + 0.5 * WIDTH * way + noise
        rows = [f"X-1,{n},{at:.4f},{to},{of:.6f}" for n, (at, to, of) in enumerate(zip(x, way, read, strict=True))]
        (data / "readings.csv").write_text("\n".join(["run,seq,X,dir_X,reading", *rows]) + "\n")
        (tmp_path / "zero.json").write_text('{"schema": 1, "machine": "small"}')
        curve = {"basis": "polynomial", "powers": [2], "coefficients": [1e-7]}
        other = {"schema": 1, "machine": "small", "motion_errors": {"EXX": curve}}
        (tmp_path / "other.json").write_text(json.dumps(other))
        kernels = ("--kernels", str(derived(spec)))
        for name in ("none", "zero", "other"):
            errors = None if name == "none" else tmp_path / f"{name}.json"
            assert diagnose(tmp_path / name, data, *kernels, machine=spec, errors=errors) == 0
        none, zero, of_other = ((tmp_path / name / "diagnosis.json").read_bytes() for name in ("none", "zero", "other"))
        assert none == zero != of_other

    def test_its_kernels_are_what_it_derives_to(self, out: Path) -> None:
        words = ["derive", str(out / "dmu60p.toml"), "--out", str(out / "generated"), "--check"]
        assert main(words) == 0

    def test_its_values_hold_the_effect(self, out: Path) -> None:
        found, given = (json.loads(path.read_text()) for path in (out / "errors.json", ERRORS))
        (effect,) = found["effects"]
        assert (effect["kind"], effect["component"]) == ("backlash", "EXX")
        assert effect["parameters"]["width"] == pytest.approx(WIDTH, abs=4 * effect["u"]["width"])
        assert found["motion_errors"].keys() == given["motion_errors"].keys()

    def test_the_extended_machine_reads_what_the_machine_does(self, plan: Path, out: Path, tmp_path: Path) -> None:
        """Another command takes spec, values and kernels; what it reads is the truth, better than any one reading."""
        words = ["simulate", str(out / "dmu60p.toml"), "--errors", str(out / "errors.json"), "--data", str(plan)]
        words += ["--out", str(tmp_path / "read"), "--kernels", str(out / "generated"), "--replace"]
        assert main(words) == 0
        truth = measured(plan, tmp_path / "truth", backlash, seed=0, sigma=0.0)
        runs, found = readings_by_run(tmp_path / "read")
        _, wanted = readings_by_run(truth)
        off = found - wanted
        for run in set(runs):  # a laser's zero is anywhere
            off[np.array(runs) == run] -= off[np.array(runs) == run].mean()
        assert np.sqrt(np.mean(off**2)) < 0.4 * SIGMA

    def test_the_report_is_one_page(self, out: Path) -> None:
        page = (out / "report.html").read_text()
        assert page.lower().startswith("<!doctype html>")
        assert "EXX" in page

    def test_nothing_else_is_written(self, out: Path) -> None:
        assert sorted(str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()) == [
            "diagnosis.json",
            "dmu60p.toml",
            "errors.json",
            *(f"generated/dmu60p/{name}" for name in sorted(KERNEL_FILES)),
            "report.html",
        ]

    def test_noise_has_no_cause_and_no_extended_machine(
        self, plan: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
    ) -> None:
        data, out = measured(plan, tmp_path / "data", no_effect, seed=12), tmp_path / "out"
        out.mkdir()
        (out / "errors.json").write_text("of an earlier run")
        assert diagnose(out, data) == 0
        told = json.loads((out / "diagnosis.json").read_text())
        assert told["verdict"] == "no_discrepancy"
        assert (told["causes"], told["extended_machine"], told["extended_errors"]) == ([], None, None)
        assert told["noise_um"] == pytest.approx(1e3 * SIGMA, rel=0.1)
        assert sorted(path.name for path in out.iterdir()) == ["diagnosis.json", "errors.json", "report.html"]
        shown = capsys.readouterr()
        assert shown.out.startswith("no_discrepancy")
        assert f"left from before, not part of this diagnosis: {out / 'errors.json'}" in shown.out
        assert shown.err == ""

    @pytest.mark.usefixtures("without_second_process")
    def test_structure_that_nothing_explains_is_1(self, tmp_path: Path) -> None:
        """At so many targets that no curve of an error can follow it."""
        (tmp_path / "plan").mkdir()
        plan = lines_of(21, tmp_path / "plan")

        def jagged(run: Run, positions: FloatArray, directions: FloatArray) -> FloatArray:
            # neither smooth nor periodic nor of a direction: repeats in every pass
            shape = np.random.default_rng(99).normal(0.0, 4 * SIGMA, 25)[:21]
            near = np.argmin(np.abs(positions[0] - np.unique(positions[0])[:, np.newaxis]), axis=0)
            return shape[near] if "X" in run.id.split("-")[0] else np.zeros(positions.shape[1])

        data, out = measured(plan, tmp_path / "data", jagged, seed=13), tmp_path / "out"
        assert diagnose(out, data) == 1
        told = json.loads((out / "diagnosis.json").read_text())
        assert told["verdict"] == "unexplained_structure"
        assert told["extended_machine"] is None
        assert sorted(path.name for path in out.iterdir()) == ["diagnosis.json", "report.html"]
