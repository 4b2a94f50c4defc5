"""What a rule gives instead of a measurement has no uncertainty of measurement (Sect. 3.6 against ISO 230-1)."""

import json
from pathlib import Path

import pytest

from tests.machines import ROOT
from trueaxis.cli.main import main

MACHINES = ROOT / "machines"
KERNELS = ("--kernels", str(ROOT / "generated"))


@pytest.mark.parametrize(
    ("rule", "known", "stated"), [("from-angles", "up to a slope", False), ("convention", "determined", True)]
)
def test_squareness_and_straightness(tmp_path: Path, rule: str, known: str, stated: bool) -> None:
    machine, truth = str(MACHINES / "dmu60p.toml"), str(MACHINES / "dmu60p_errors.json")
    data, out, report = tmp_path / "data", tmp_path / "e.json", tmp_path / "r.json"
    plan = str(MACHINES / "dmu60p_regular_runs")
    noise = ["--noise-um", "0.01"]
    assert main(["simulate", machine, "--errors", truth, "--data", plan, "--out", str(data), *noise, *KERNELS]) == 0
    options = ["--method", "stepwise", "--squareness", rule, "--report", str(report), *noise, *KERNELS]
    assert main(["identify", machine, "--data", str(data), "--out", str(out), *options]) == 0
    u = json.loads(out.read_text()).get("u", {})
    assert {name for name in ("eps_xy", "eps_xz", "eps_yz") if u.get(name) is not None} == (
        {"eps_xy", "eps_xz", "eps_yz"} if stated else set()
    )
    components = {part["name"]: part for part in json.loads(report.read_text())["components"]}
    for name in ("EYX", "EXZ", "EYZ"):
        assert components[name]["known"] == known
        assert (components[name]["u"] is not None) == stated
    assert components["EXX"]["known"] == "determined"
    assert components["EXX"]["u"] is not None
