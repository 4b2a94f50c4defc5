"""The campaign goes on where it stopped, counts right, and hears the same from process and command."""

import json
import subprocess
import sys
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.hidden_effects.power.grade import Name, Said
from tests.machines import ROOT
from tests.worlds.diagnosis.__main__ import main
from tests.worlds.diagnosis.answers import Answer, answer_of, matched, said_by_command, said_of
from tests.worlds.diagnosis.cases import Bench, bench_of, draw_case
from tests.worlds.diagnosis.counting import reasons, shares
from tests.worlds.diagnosis.lines import line_of
from tests.worlds.diagnosis.measuring import read_lines
from tests.worlds.diagnosis.tables import failures, tables
from tests.worlds.diagnosis.values import write_case

SMALL = 5006


@cache
def bench() -> Bench:
    return bench_of(SMALL)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of a campaign: kernels stay in it."""
    return tmp_path_factory.mktemp("campaign")


def line(**changes: Any) -> dict[str, Any]:
    """An effect at ten limits, named alone and right."""
    one = {"kind": "backlash", "name": "backlash EXX", "size": 0.01, "state": "isolable", "times": 10.0}
    one |= {"detection": 1e-3, "isolation": 8e-4, "r2": 0.1, "rival": "cyclic EXX"}
    found = {"world": SMALL, "case": 1, "kind": "effect", "given": "truth", "hidden": [one], "wear": None}
    found |= {"grade": "unique", "verdict": "explained", "sets": [["backlash EXX"]], "audited": [[1.1e-3, 1e-3, 0.2]]}
    return found | {"stale_expected_p": 0.3, "standardised": {}, "stale": [], "checks": [], "seconds": 1.0} | changes


NOTHING = {"kind": "nothing", "hidden": [], "sets": [], "grade": "silent", "verdict": "no_discrepancy"}
WORN = {"component": "EYY", "form": "bump", "size": 1e-3, "sigma": 9.0, "beyond": 1.0}


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({}, []),
        ({"grade": "in set", "sets": [["a", "b"]]}, []),
        ({"grade": "in set", "sets": [["a", "b", "c", "d"]]}, ["large set"]),
        ({"grade": "silent", "sets": [], "verdict": "no_discrepancy"}, ["silent"]),
        ({"grade": "wrong"}, ["wrong name"]),
        (NOTHING, []),
        (NOTHING | {"grade": "wrong", "sets": [["a"]]}, ["false name"]),
        (NOTHING | {"verdict": "unexplained_structure"}, ["unexplained, nothing there"]),
        (NOTHING | {"verdict": "recalibrate"}, ["called stale"]),
        (NOTHING | {"verdict": "recalibrate", "given": "zeros"}, []),
        (NOTHING | {"kind": "stale", "wear": WORN, "stale_expected_p": 1e-9}, ["stale, not said"]),
        (NOTHING | {"kind": "stale", "wear": WORN, "stale_expected_p": 1e-9, "verdict": "recalibrate"}, []),
        ({"grade": "failed"}, ["broke down"]),
    ],
)
def test_what_counts_as_a_failure(changes: dict[str, Any], expected: list[str]) -> None:
    assert reasons(line(**changes)) == expected


def test_shares_of_lines_by_hand() -> None:
    lines = [line(), line(grade="wrong"), line(grade="in set", sets=[["a", "b"]]), line(**NOTHING)]
    found = {one.what: (one.count, len(one.lines)) for one in shares(lines)}
    assert found["a wrong name, effects of the library"] == (1, 3)
    assert found["a false name, no effect hidden"] == (0, 1)
    assert found["isolable, at 10 limits: one name, right"] == (1, 3)
    assert found["the rest of these: a set of at most 3 that holds it"] == (1, 2)
    assert found["the audit's limit within 20 %"] == (3, 3)
    text = "\n".join([*tables(lines), *failures(lines)])
    assert "| a wrong name, effects of the library | limit < 1 % | 33.3% (1) | 3 |" in text
    assert f"- world {SMALL} case 1: wrong name" in text


def test_a_name_of_a_set_up_is_that_of_the_runs_that_it_holds() -> None:
    truth = (Name("laser_cosine", runs=("X1-1", "X1-2")),)
    said = Said("explained", ((Name("laser_cosine", runs=("X1-1", "X1-2", "X1-1-s2")), Name("drift", "EXX")),))
    assert matched(said, truth).sets == ((truth[0], Name("drift", "EXX")),)
    other = Said("explained", ((Name("laser_cosine", runs=("X1-1", "Y1-1")),),))
    assert matched(other, truth).sets == other.sets


def test_an_answer_by_the_keys_of_the_contract() -> None:
    cause = {"effect": "reading_zero", "of": "instrument", "runs": ["X2", "X1"], "parameters": {}}
    tree = {"verdict": "recalibrate", "noise_um": 0.3, "causes": [cause], "gain": {"held_out_standardised": 1.02}}
    found = answer_of(tree | {"stale": [{"component": "EYY", "p_value": 1e-9}], "checks": [{"id": "between_runs"}]})
    assert found.said == Said(
        "recalibrate", ((Name("reading_zero", runs=("X1", "X2")),),), (0.0,), (0.0,), ("between_runs",)
    )
    assert (found.stale, found.standardised) == (("EYY",), {"extended": 1.02})


def test_a_diagnosis_that_breaks_down_is_a_line(folder: Path) -> None:
    def engine(folder: Path, kernels: Path) -> Answer:
        raise RuntimeError("no")

    found = line_of(bench(), 2, folder / "worlds" / str(SMALL), engine=engine)
    assert (found["grade"], found["error"]) == ("failed", "RuntimeError: no")
    assert reasons(found) == ["broke down"]


def test_a_campaign_goes_on_where_it_stopped(folder: Path) -> None:
    options = ["--out", str(folder), "--worlds", "1", "--first", str(SMALL)]
    assert main([*options, "--cases", "1"]) == 0
    (results,) = folder.glob("cases-*.jsonl")
    before = results.read_text()
    assert main([*options, "--cases", "2"]) == 0
    assert results.read_text().startswith(before)
    lines = read_lines(folder)
    assert [(one["world"], one["case"]) for one in lines] == [(SMALL, 0), (SMALL, 1)]
    assert "1 worlds, 2 cases" in "\n".join(tables(lines))
    assert json.loads(before)["seconds"] > 0.0


def test_processes_of_its_own_find_their_work(tmp_path: Path) -> None:
    """As `python -m` a package is run: what processes are given is looked for by its name. Time is up at once."""
    words = f"--worlds 2 --first {SMALL} --cases 1 --processes 2 --minutes 0".split()
    command = [sys.executable, "-m", "tests.worlds.diagnosis", "--out", str(tmp_path / "out"), *words]
    done = subprocess.run(command, capture_output=True, check=False, cwd=ROOT, timeout=100)
    assert (done.returncode, done.stderr) == (0, b"")
    assert len(list((tmp_path / "out").glob("cases-*.jsonl"))) == 2


def test_process_and_command_say_the_same(folder: Path, tmp_path: Path) -> None:
    case = next(case for case in (draw_case(bench(), k, ("effect",)) for k in range(20)) if case.given == "zeros")
    kernels = write_case(tmp_path, folder / "worlds" / str(SMALL), bench().design, case)
    found = [replace(engine(tmp_path, kernels), seconds=0.0) for engine in (said_of, said_by_command)]
    assert found[0].said.verdict
    assert found[0] == found[1]
