"""trueaxis plan, as a user runs it."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.plan.data import ROOT, model
from trueaxis.cli import main
from trueaxis.measure.data import read_data
from trueaxis.plan.candidates import follow
from trueaxis.runtime.errors import ErrorValues
from trueaxis.spec import read_machine

MACHINE = ROOT / "machines" / "dmu60p.toml"
RUNS = ROOT / "machines" / "dmu60p_runs"
KERNELS = ["--kernels", str(ROOT / "generated")]
QUICK = ["--degree", "2"]


def plan(data: Path, *options: str, machine: Path = MACHINE) -> int:
    return main(["plan", str(machine), "--data", str(data), *options, *KERNELS])


def report(path: Path) -> dict[str, Any]:
    tree: dict[str, Any] = json.loads(path.read_text())
    return tree


def test_says_what_the_papers_runs_determine(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "report.json"
    assert plan(RUNS, "--report", str(out)) == 0
    text = capsys.readouterr().out
    assert "rank 119 of 129 unknowns, 3 more settled by convention, 7 open" in text
    assert "eps_xy and the slope of EYX: only their sum is determined" in text
    assert "Z-7 Z-8 Z-9 -> EZZ EAZ EBZ: RANK 2 OF 3 at a position" in text
    assert "the points of Z-8 and Z-9 have the same x and y" in " ".join(text.split())
    assert max(len(line) for line in text.splitlines()) <= 120
    tree = report(out)
    assert (tree["rank"], tree["unknowns"], tree["settled"]) == (119, 129, 3)
    assert tree["repair"]["regular"] is True
    assert tree["proposal"] is None


def test_a_regular_plan_needs_no_repair(capsys: pytest.CaptureFixture[str]) -> None:
    assert plan(ROOT / "machines" / "dmu60p_regular_runs", *QUICK) == 0
    text = capsys.readouterr().out
    assert "0 open" in text
    assert "points that would" not in text


def test_proposed_runs_are_a_plan_that_can_be_simulated_and_identified(tmp_path: Path) -> None:
    out, data, found = tmp_path / "more", tmp_path / "data", tmp_path / "report.json"
    assert plan(RUNS, "--propose", "3", "--out", str(out), "--report", str(found), *QUICK) == 0
    before, after = (read_data(folder, read_machine(MACHINE)) for folder in (RUNS, out))
    assert (out / "setup.toml").read_text().startswith((RUNS / "setup.toml").read_text())
    assert after.setup.runs[:18] == before.setup.runs
    assert [run.id for run in after.setup.runs[18:]] == ["added-1", "added-2", "added-3"]
    assert after.readings.planned.all()
    assert np.array_equal(after.readings.positions[:, : before.readings.run.size], before.readings.positions)
    errors = ROOT / "machines" / "dmu60p_errors.json"
    shared = [str(MACHINE), "--data"]
    assert main(["simulate", *shared, str(out), "--errors", str(errors), "--out", str(data), *KERNELS]) == 0
    identify = [
        "identify",
        *shared,
        str(data),
        "--out",
        str(tmp_path / "e.json"),
        "--method",
        "global",
        "--prior",
        "none",
        *QUICK,
    ]
    assert main([*identify, "--known", str(_parameters(tmp_path)), *KERNELS]) == 0
    # the plan of the result says what the proposal promised
    again = tmp_path / "again.json"
    assert plan(out, "--report", str(again), *QUICK) == 0
    promised = report(found)["proposal"]
    assert report(again)["rank"] == promised["rank"] > report(found)["rank"]
    for one, other in zip(report(again)["curves"], promised["curves"], strict=True):
        assert one["state"] == other["state"]
        assert one["u_travel"] == pytest.approx(other["u_travel"], rel=1e-6)


def _parameters(folder: Path) -> Path:
    tree = json.loads((ROOT / "machines" / "dmu60p_errors.json").read_text())
    path = folder / "known.json"
    path.write_text(json.dumps({**tree, "motion_errors": {}}))
    return path


def test_every_uncertainty_falls_with_more_runs(tmp_path: Path) -> None:
    out = tmp_path / "report.json"
    assert plan(ROOT / "machines" / "dmu60p_regular_runs", "--propose", "2", "--report", str(out), *QUICK) == 0
    tree = report(out)
    pairs = list(zip(tree["curves"], tree["proposal"]["curves"], strict=True))
    assert all(after["u_travel"] <= before["u_travel"] * (1 + 1e-9) for before, after in pairs)
    assert sum(after["u_travel"] < 0.5 * before["u_travel"] for before, after in pairs) >= 5


DIMENSIONS = {"q_Ax": 250.0, "q_Ay": -225.0, "q_Az": 200.0, "q_Cx": 5.0, "q_Cy": 3.0, "q_Cz": -40.0, "q_wz": 50.0}


def trunnion_plan(folder: Path) -> Path:
    """A probe on one sphere, A and C turning with the linear axes following, and two ball-bar circles."""
    (folder / "known.json").write_text(json.dumps({"schema": 1, "machine": "trunnion_mill", "parameters": DIMENSIONS}))
    machine = model("trunnion_mill").with_values(ErrorValues("trunnion_mill", DIMENSIONS))
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
        positions = follow(machine, turning, tool, np.repeat(centre, angles.size, axis=1))
        assert positions is not None
        home = ", ".join(f"{name} = {value}" for name, value in zip(machine.axes, positions[:, 0], strict=True))
        for name, unit in zip("xyz", np.eye(3).tolist(), strict=True):
            text = f"instrument = 'probe'\ndirection = {unit}\nframe = 'bed'\nhome = {{ {home} }}\n"
            setup += add(f"{axis}-{name}", text, positions)
    angle = np.arange(36) * np.pi / 18
    for run_id, plane in (("xy", (0, 1)), ("yz", (1, 2)), ("xz", (0, 2))):
        way = np.repeat(centre, 36, axis=1)
        way[list(plane)] += 100.0 * np.array([np.cos(angle), np.sin(angle)])
        positions = follow(machine, np.repeat(middle, 36, axis=1), tool, way)
        assert positions is not None
        setup += add(run_id, "instrument = 'ballbar'\nlength = 100.0\n", positions)
    (folder / "setup.toml").write_text(setup)
    (folder / "readings.csv").write_text("\n".join(rows) + "\n")
    return folder


def test_five_axes_with_probe_and_ball_bar(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data, out, more = trunnion_plan(tmp_path), tmp_path / "report.json", tmp_path / "more"
    machine = ROOT / "machines" / "trunnion_mill.toml"
    options = ["--known", str(tmp_path / "known.json"), "--location-errors-only", "--report", str(out)]
    assert plan(data, *options, "--propose", "2", "--out", str(more), machine=machine) == 0
    tree = report(out)
    # where the ball bar's and the sphere's centre are unknown, what displaces the tool is not seen (8 of 11 are left)
    states = {one["name"]: one["state"] for one in tree["locations"]}
    assert tree["rank"] == 8
    assert {name for name, state in states.items() if state == "undetermined"} == {"EY0A", "EZ0A", "EX0C"}
    assert [len(one["kept"]) for one in tree["location_sets"]] == [11, 11, 8, 8]
    assert tree["proposal"]["rank"] > 8
    assert "centre" in capsys.readouterr().out
    assert plan(more, *options, machine=machine) == 0
    assert report(out)["rank"] == tree["proposal"]["rank"]
    assert plan(data, *options, "--ideal-instruments", machine=machine) == 0
    assert report(out)["rank"] == 11


def test_faults_of_options_and_files(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert plan(RUNS, "--out", str(tmp_path / "x")) == 2
    assert plan(RUNS, "--ideal-instruments", "--unknown-zeros") == 2
    assert plan(RUNS, "--propose", "1", "--out", str(RUNS)) == 2
    assert plan(RUNS, "--runs", "X-1", "X-9") == 2
    assert plan(tmp_path / "nowhere") == 2
    error = capsys.readouterr().err
    for said in ("--propose N as well", "--unknown-zeros", "another folder for --out", "nowhere", "X-9: is no run"):
        assert said in error
    for wrong in (["--noise-um", "0"], ["--degree", "x"], ["--propose", "0"], ["--propose-with", "ruler"]):
        with pytest.raises(SystemExit) as caught:
            plan(RUNS, *wrong)
        assert caught.value.code == 2
    assert not (tmp_path / "x").exists()


def test_runs_in_an_inline_array_cannot_be_added_to(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "setup.toml").write_text(
        'schema = 1\nmachine = "dmu60p"\nrun = [{ id = "a", instrument = "laser", direction = [1.0, 0.0, 0.0], '
        'target = { on = "tool", point = [0.0, 0.0, 0.0] } }]\n'
    )
    (tmp_path / "readings.csv").write_text("run,seq,X,Y,Z,reading\na,0,0,0,0,\na,1,100,0,0,\n")
    assert plan(tmp_path, "--propose", "1", "--out", str(tmp_path / "more"), *QUICK) == 2
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
    code = "import sys, trueaxis.commands.plan; assert not {'sympy', 'jinja2', 'statsmodels'} & set(sys.modules)"
    subprocess.run([sys.executable, "-c", code], check=True)
