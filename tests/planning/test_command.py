"""trueaxis plan, as a user runs it."""

import json
import subprocess
import sys
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.generator.dmu60p import cubic_errors
from tests.identification.data import mixed_data
from tests.planning.data import ROOT, model
from trueaxis.cli.main import main
from trueaxis.identification.weighting import NoiseModel
from trueaxis.machine import read_machine
from trueaxis.measurement.data import read_data
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.judge import noise_of_instruments, noise_of_runs
from trueaxis.planning.paths import follow_circle, follow_turn

MACHINE = ROOT / "machines" / "dmu60p.toml"
RUNS = ROOT / "machines" / "dmu60p_runs"
REGULAR = ROOT / "machines" / "dmu60p_regular_runs"
KERNELS = ["--kernels", str(ROOT / "generated")]


def plan(data: Path, *options: str, machine: Path = MACHINE) -> int:
    return main(["plan", str(machine), "--data", str(data), *options, *KERNELS])


def first(out: Path, *options: str, machine: Path = MACHINE) -> int:
    return main(["plan", str(machine), "--with", "laser", "ballbar", "--out", str(out), *options, *KERNELS])


def report(path: Path) -> dict[str, Any]:
    tree: dict[str, Any] = json.loads(path.read_text())
    return tree


def test_says_what_the_papers_runs_will_tell(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "report.json"
    assert plan(RUNS, "--noise-um", "0.3", "--report", str(out)) == 0
    text = capsys.readouterr().out
    assert "Z-7 Z-8 Z-9 -> EZZ EAZ EBZ: RANK 2 OF 3 at a position" in text
    assert "the points of Z-8 and Z-9 have the same x and y" in " ".join(text.split())
    assert "nothing is repeated: identify takes the noise from the residuals" in " ".join(text.split())
    assert max(len(line) for line in text.splitlines()) <= 120
    found = report(out)["expected"]
    states = {one["name"]: one["state"] for one in found["components"]}
    assert states["EAX"] == "partly"  # rests on Z
    assert states["EYY"] == "data"
    assert 0.0 < found["tool"]["u_prior_rms"] < found["tool"]["u_rms"] < found["tool"]["prior_rms"]
    assert found["tool"]["u_rms"] <= np.sqrt(3.0) * found["tool"]["largest_u"]
    assert any(text in " ".join(one["text"] for one in found["combinations"]) for text in ("the slope of EYX", "EYZ"))
    assert [one["freedom"] for one in found["noise"]] == [0]


def test_more_noise_tells_less_and_the_prior_more(tmp_path: Path) -> None:
    out, each = tmp_path / "report.json", []
    for um in ("0.1", "laser=1", "10"):
        assert plan(REGULAR, "--noise-um", um, "--report", str(out)) == 0
        each.append(report(out)["expected"])
    for low, high in pairwise(each):
        assert low["tool"]["u_rms"] < high["tool"]["u_rms"]
        for one, other in zip(low["components"], high["components"], strict=True):
            assert one["u_rms"] <= other["u_rms"] * (1.0 + 1e-9)
            assert one["prior"] == pytest.approx(other["prior"])
    states = [[one["state"] for one in of["components"]].count("data") for of in each]
    assert states[0] > states[2]


def test_a_larger_prior_is_a_larger_uncertainty(tmp_path: Path) -> None:
    spec = tmp_path / "dmu60p.toml"
    spec.write_text(MACHINE.read_text() + "\n[prior]\nlocation_urad = 1000.0\n")
    out, each = tmp_path / "report.json", []
    for machine in (MACHINE, spec):
        assert plan(RUNS, "--report", str(out), machine=machine) == 0
        each.append(report(out)["expected"])
    assert each[1]["locations"][0]["prior"] > 5.0 * each[0]["locations"][0]["prior"]
    assert each[1]["tool"]["prior_rms"] > 3.0 * each[0]["tool"]["prior_rms"]


def test_proposed_runs_are_a_plan_that_is_as_promised(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, found, again = tmp_path / "more", tmp_path / "report.json", tmp_path / "again.json"
    assert plan(RUNS, "--propose", "3", "--out", str(out), "--report", str(found)) == 0
    text = capsys.readouterr().out
    before, after = (read_data(folder, read_machine(MACHINE)) for folder in (RUNS, out))
    assert (out / "setup.toml").read_text().startswith((RUNS / "setup.toml").read_text())
    assert after.setup.runs[:18] == before.setup.runs
    assert [run.id for run in after.setup.runs[18:]] == ["added-1", "added-2", "added-3"]
    assert after.readings.planned.all()
    assert np.array_equal(after.readings.positions[:, : before.readings.run.size], before.readings.positions)
    assert plan(out, "--report", str(again)) == 0
    tree, promised = report(again)["expected"], report(found)["proposal"]
    for part in ("tool", "components", "locations", "noise"):
        assert tree[part] == promised["after"][part]
    falls = [promised["before"], *(one["u"] for one in promised["added"])]
    assert all(b < a for a, b in pairwise(falls))
    assert promised["after"]["tool"]["u_rms"] == pytest.approx(falls[-1], rel=1e-3)
    assert "runs that lower the uncertainty of the tool point over the volume most per minute" in " ".join(text.split())


@pytest.mark.parametrize(
    ("name", "part"), [("EYX", "components"), pytest.param("eps_xz", "locations", marks=pytest.mark.slow)]
)
def test_runs_for_one_error_are_better_for_it(name: str, part: str, tmp_path: Path) -> None:
    out, u = tmp_path / "report.json", []
    for wanted in (name, "volume"):
        options = ("--propose", "2", "--propose-with", "laser", "ballbar", "--for", wanted)
        assert plan(RUNS, *options, "--report", str(out)) == 0
        proposal = report(out)["proposal"]
        minutes = sum(one["minutes"] for one in proposal["added"])
        (error,) = [one for one in proposal["after"][part] if one["name"] == name]
        (before,) = [one for one in report(out)["expected"][part] if one["name"] == name]
        u.append((before["u_rms"] ** 2 - error["u_rms"] ** 2) / minutes)
    assert u[0] >= u[1]


def test_a_first_plan_from_nothing_is_better_than_the_papers_of_the_same_time(tmp_path: Path) -> None:
    """Seven hours by the same measure of time; at home, and on a workpiece placed where it fits best."""
    out, papers, own = tmp_path / "first", tmp_path / "papers.json", tmp_path / "own.json"
    assert plan(REGULAR, "--report", str(papers)) == 0
    theirs = report(papers)["expected"]
    assert first(out, "--hours", str(theirs["minutes"] / 60.0), "--report", str(own)) == 0
    ours = report(own)["proposal"]["after"]
    assert ours["minutes"] <= theirs["minutes"]
    assert ours["tool"]["u_rms"] < 0.7 * theirs["tool"]["u_rms"]
    assert ours["tool"]["u_placed_rms"] < 0.3 * theirs["tool"]["u_placed_rms"]
    assert ours["minutes"] == pytest.approx(sum(one["minutes"] for one in report(own)["proposal"]["added"]), rel=1e-9)
    assert all(one["freedom"] >= 20 for one in ours["noise"])


def test_a_first_plan_is_simulated_and_identified(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, data, errors = tmp_path / "first", tmp_path / "data", tmp_path / "e.json"
    assert first(out, "--hours", "0.7", "--tool-point", "0,0,-50") == 0
    assert "a plan from nothing" in capsys.readouterr().out
    assert read_data(out, read_machine(MACHINE)).readings.planned.all()
    true = str(ROOT / "machines" / "dmu60p_errors.json")
    words = [str(MACHINE), "--data", str(out), "--errors", true, "--out", str(data), "--noise-um", "1", *KERNELS]
    assert main(["simulate", *words]) == 0
    parameters = json.loads(Path(true).read_text())["parameters"]
    dimensions = {name: value for name, value in parameters.items() if name.startswith("q_")}
    known = tmp_path / "known.json"
    known.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "parameters": dimensions}))
    words = [str(MACHINE), "--data", str(data), "--method", "global", "--known", str(known), "--out", str(errors)]
    assert main(["identify", *words, *KERNELS]) == 0


DIMENSIONS = {"q_Ax": 250.0, "q_Ay": -225.0, "q_Az": 200.0, "q_Cx": 5.0, "q_Cy": 3.0, "q_Cz": -40.0, "q_wz": 50.0}


def trunnion_plan(folder: Path) -> Path:
    """A probe on one sphere, A and C turning with the linear axes following, and two ball-bar circles."""
    (folder / "known.json").write_text(json.dumps({"schema": 1, "machine": "trunnion_mill", "parameters": DIMENSIONS}))
    machine = model("trunnion_mill").with_values(ErrorValues(machine="trunnion_mill", parameters=DIMENSIONS))
    tool = (0.0, 0.0, -100.0)
    middle = np.array([[np.mean(machine.travel[axis]) if axis in "XYZ" else 0.0] for axis in machine.axes])
    centre = machine.ideal(middle, np.array([tool]).T) + np.array([[60.0], [40.0], [0.0]])
    setup, rows = 'schema = 1\nmachine = "trunnion_mill"\n', [f"run,seq,{','.join(machine.axes)},reading"]

    def add(run_id: str, text: str, positions: np.ndarray) -> str:
        rows.extend(f"{run_id},{i},{','.join(map(str, at))}," for i, at in enumerate(positions.T.tolist()))
        ends = f"target = {{ on = 'tool', point = {list(tool)} }}\n"
        ends += f"reference = {{ on = 'workpiece', point = {centre[:, 0].tolist()} }}\n"
        return f"\n[[run]]\nid = '{run_id}'\n{text}{ends}"

    for axis, angles in (("A", np.linspace(-60, 30, 10)), ("C", np.linspace(-170, 170, 12))):
        turning = np.repeat(middle, angles.size, axis=1)
        turning[machine.axes.index(axis)] = angles
        positions = follow_turn(machine, turning, tool, np.repeat(centre, angles.size, axis=1))
        assert positions is not None
        home = ", ".join(f"{name} = {value}" for name, value in zip(machine.axes, positions[:, 0], strict=True))
        for name, unit in zip("xyz", np.eye(3).tolist(), strict=True):
            text = f"instrument = 'probe'\ndirection = {unit}\nframe = 'bed'\nhome = {{ {home} }}\n"
            setup += add(f"{axis}-{name}", text, positions)
    angle = np.arange(36) * np.pi / 18
    for run_id, plane in (("xy", (0, 1)), ("yz", (1, 2)), ("xz", (0, 2))):
        way = np.repeat(centre, 36, axis=1)
        way[list(plane)] += 100.0 * np.array([np.cos(angle), np.sin(angle)])
        positions = follow_circle(machine, np.repeat(middle, 36, axis=1), tool, way)
        assert positions is not None
        setup += add(run_id, "instrument = 'ballbar'\nlength = 100.0\n", positions)
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return folder


def test_five_axes_with_probe_and_ball_bar(tmp_path: Path) -> None:
    data, out, more = trunnion_plan(tmp_path), tmp_path / "report.json", tmp_path / "more"
    machine = ROOT / "machines" / "trunnion_mill.toml"
    options = ["--known", str(tmp_path / "known.json"), "--location-errors-only", "--report", str(out)]
    assert plan(data, *options, "--propose", "2", "--out", str(more), machine=machine) == 0
    tree = report(out)
    # where the ball bar's and the sphere's centre are unknown, what displaces the tool is not seen but by the
    # set-up's own size, 50 um: the prior of 1 mm is lowered to it, and no further
    u = {one["name"]: one["u"] for one in tree["expected"]["locations"]}
    assert {name for name, value in u.items() if value > 0.02} == {"EY0A", "EZ0A", "EX0C"}
    assert all(one["state"] == "given" for one in tree["expected"]["components"])
    assert [len(one["kept"]) for one in tree["location_sets"]] == [11, 11, 8, 8]
    assert plan(more, *options, machine=machine) == 0
    assert report(out)["expected"]["tool"] == tree["proposal"]["after"]["tool"]


def test_no_plan_where_no_run_fits(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert first(tmp_path / "first", "--hours", "0.1") == 1
    assert "not written: no run that determines what is asked for fits into 0.1 h" in capsys.readouterr().out
    assert list(tmp_path.iterdir()) == []


def test_some_runs_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "report.json"
    assert plan(RUNS, "--runs", "X-1", "X-2", "X-3", "--report", str(out)) == 0
    assert capsys.readouterr().out.splitlines()[1].startswith("NOTE: dimensions q_wx, q_wy, q_wz, q_Tx, q_Ty and q_Tz")
    tree = report(out)
    assert tree["expected"]["runs"] == 3
    states = {one["name"]: one["state"] for one in tree["expected"]["components"]}
    assert all(state == "prior" for name, state in states.items() if name[2] != "X")
    assert states["EXX"] != "prior"
    assert "Y is not moved" in tree["notes"]


def test_it_draws_the_uncertainty_in_the_volume(tmp_path: Path) -> None:
    picture = tmp_path / "u.png"
    assert plan(RUNS, "--picture", str(picture)) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_faults_of_options_and_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    x = str(tmp_path / "x")
    assert plan(RUNS, "--out", x) == 2
    assert plan(RUNS, "--propose", "1", "--out", str(RUNS)) == 2
    assert plan(RUNS, "--runs", "X-1", "X-9") == 2
    assert plan(RUNS, "--for", "EQQ", "--propose", "1") == 2
    assert plan(RUNS, "--for", "EYX", "--hours", "3", "--with", "laser") == 2
    assert plan(RUNS, "--noise-um", "repeats") == 2
    assert plan(RUNS, "--noise-um", "lazer=1") == 2
    assert plan(tmp_path / "nowhere") == 2
    error = " ".join(capsys.readouterr().err.split())
    for said in (
        "--propose N as well", "another folder for --out", "nowhere", "X-9: is no run", "EQQ: is no error",
        "--hours: goes with --with", "--with: makes a plan from nothing", "a plan has no readings",
        "lazer: is neither an instrument nor a run",
    ):  # fmt: skip
        assert said in error
    assert main(["plan", str(MACHINE), *KERNELS]) == 2
    assert main(["plan", str(MACHINE), "--with", "laser", "--runs", "A", *KERNELS]) == 2
    error = capsys.readouterr().err
    for said in ("or --with laser ballbar for a first one", "--out: is missing", "--runs: goes with a plan"):
        assert said in error
    for wrong in (["--noise-um", "0"], ["--tool-point", "1,2"], ["--propose", "0"], ["--propose-with", "ruler"]):
        with pytest.raises(SystemExit) as caught:
            plan(RUNS, *wrong)
        assert caught.value.code == 2
    assert not (tmp_path / "x").exists()


def test_the_noise_of_one_instrument_may_be_stated_alone(capsys: pytest.CaptureFixture[str]) -> None:
    """The others keep the round figure of a plan, which the report says."""
    assert plan(RUNS, "--noise-um", "laser=0.4", "--propose", "1", "--propose-with", "ballbar") == 0
    assert "laser: 0.4 um assumed" in capsys.readouterr().out
    stated = NoiseModel(by_group={"laser": 0.4})
    assert noise_of_instruments({"laser": None, "ballbar": None}, stated) == {
        "laser": pytest.approx(4e-4),
        "ballbar": 1e-3,
    }
    observed = mixed_data(cubic_errors())
    each = noise_of_runs(observed, replace(stated, by_group={"laser": 0.4, "X-2": 0.7}))
    told = {run.id: each[index] for index, run in enumerate(observed.runs)}
    assert told == {
        run.id: pytest.approx({"X-2": 7e-4}.get(run.id, 4e-4 if run.instrument == "laser" else 1e-3))
        for run in observed.runs
    }
    words = ["--with", "laser", "ballbar", "--hours", "0.5", "--out", "never"]
    assert main(["plan", str(MACHINE), *words, "--noise-um", "lazer=0.4", *KERNELS]) == 2
    assert "lazer: is no instrument of lengths; laser, ballbar, probe" in capsys.readouterr().err


def test_options_of_the_least_squares_name_what_replaces_them(capsys: pytest.CaptureFixture[str]) -> None:
    assert plan(RUNS, "--degree", "3", "--ideal-instruments", "--unknown-linkage-lines", "--unknown-zeros") == 2
    error = capsys.readouterr().err
    for said in (
        "--degree: is no longer an option",
        "[prior]",
        "[device]",
        "--unknown-linkage-lines",
        "--unknown-zeros",
    ):
        assert said in error


def test_runs_in_an_inline_array_cannot_be_added_to(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "setup.toml").write_text(
        'schema = 1\nmachine = "dmu60p"\nrun = [{ id = "a", instrument = "laser", direction = [1.0, 0.0, 0.0], '
        'target = { on = "tool", point = [0.0, 0.0, 0.0] } }]\n'
    )
    (tmp_path / "readings.csv").write_text("run,seq,X,Y,Z,reading\na,0,0,0,0,\na,1,100,0,0,\n")
    assert plan(tmp_path, "--propose", "1", "--out", str(tmp_path / "more")) == 2
    assert "write the runs as [[run]] tables" in capsys.readouterr().err
    assert not (tmp_path / "more").exists()


def test_a_plan_that_determines_nothing(tmp_path: Path) -> None:
    (tmp_path / "setup.toml").write_text(
        'schema = 1\nmachine = "dmu60p"\n[[run]]\nid = "a"\ninstrument = "laser"\ndirection = [1.0, 0.0, 0.0]\n'
        'target = { on = "tool", point = [0.0, 0.0, 0.0] }\n'
    )
    (tmp_path / "readings.csv").write_text("run,seq,X,Y,Z,reading\na,0,0,0,0,\na,1,0,100,0,\n")
    assert plan(tmp_path) == 1


def test_no_symbolic_algebra_is_loaded() -> None:
    code = "import sys, trueaxis.cli.plan; assert not {'sympy', 'jinja2', 'statsmodels'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
