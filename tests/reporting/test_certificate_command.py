"""trueaxis report: what it writes and refuses."""

import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from tests.machines import ROOT
from tests.reporting.test_certificate_content import ECY, EXX, KERNELS, MACHINE, written
from trueaxis.cli.main import main


class _Text(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.cells: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, _: object) -> None:
        if tag not in {"meta", "br", "use", "path", "image", "rect"}:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if self.open and self.open[-1] == tag:
            self.open.pop()

    def handle_data(self, data: str) -> None:
        if data.strip() and not {"style", "svg"} & set(self.open):
            self.cells.append(data.strip())


def cells(path: Path) -> list[str]:
    reader = _Text()
    reader.feed(path.read_text())
    assert not reader.open, "every element is closed"
    return reader.cells


SQUARENESS = "eps_xy: squareness error of X to Y, about Z; X slide carriage on the bed"


def test_page_with_and_without_an_older_file(tmp_path: Path) -> None:
    now = written(tmp_path / "now.json", {"eps_xy": 3e-5}, EXX=EXX, ECY=ECY)
    old = written(tmp_path / "old.json", {"eps_xy": 1e-5}, EXX=EXX, ECY=ECY)
    out = tmp_path / "r.html"
    arguments = ["report", str(MACHINE), "--errors", str(now), "--out", str(out), "--kernels", str(KERNELS)]
    assert main(arguments) == 0
    alone = cells(out)
    assert "EXX" in alone
    assert "change / u" not in alone
    assert main([*arguments, "--against", str(old)]) == 0
    first = out.read_bytes()
    both = cells(out)
    assert both[both.index(SQUARENESS) + 1] == "30.0\N{NO-BREAK SPACE}\N{MICRO SIGN}rad"
    assert "changed" in both
    assert main([*arguments, "--against", str(old)]) == 0
    assert out.read_bytes() == first


def test_the_page_says_what_the_values_rest_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    origin = {
        "folder": "shop", "method": "global", "prior": True, "runs": 12, "readings": 340, "outliers": 2,
        "noise": [{"instrument": "laser", "value": 0.42, "unit": "um", "stated": False}],
        "usual_sizes": [{"unknown": "ballbar centre", "size": 1e-4, "usual": 0.05, "unit": "mm", "values": 3}],
        "report": {"machine serial": "77-1"},
    }  # fmt: skip
    now = written(tmp_path / "now.json", {"eps_xy": 3e-5}, EXX=EXX, ECY=ECY)
    tree = json.loads(now.read_text())
    now.write_text(json.dumps({**tree, "origin": origin, "fit": {"state": "converged"}}))
    out = tmp_path / "r.html"
    arguments = ["report", str(MACHINE), "--errors", str(now), "--kernels", str(KERNELS), "--out"]
    assert main([*arguments, str(out)]) == 0
    said = cells(out)
    assert said[said.index("machine serial") + 1] == "77-1"
    assert said[said.index("readings") + 1] == "340 in 12 runs, data folder shop; 2 left out as outliers"
    assert "could not be judged" in said[said.index("fit") + 1]
    um = "\N{NO-BREAK SPACE}\N{MICRO SIGN}m"
    assert f"ballbar centre 0.1{um} from 3 values (usual 50{um})" in said[said.index("instruments") + 1]
    assert f"laser 0.42{um}" in said[said.index("noise of a reading") + 1]
    assert not re.search(r"\d u(m|rad)\b", " ".join(said))  # one spelling of units on a page
    assert main([*arguments, str(tmp_path / "r.pdf")]) == 2
    assert "ends in .html" in capsys.readouterr().err
    assert not (tmp_path / "r.pdf").exists()
    now.write_text(json.dumps({**tree, "origin": {**origin, "runs": -1, "folder": 3}}))
    assert main([*arguments, str(out)]) == 2
    faults = capsys.readouterr().err
    assert "origin.runs" in faults
    assert "origin.folder" in faults


def test_five_axes(tmp_path: Path) -> None:
    errors = tmp_path / "e.json"
    errors.write_text('{"schema": 1, "machine": "trunnion_mill", "motion_errors": {"EAA": {"basis": "polynomial",'
                      ' "powers": [1], "coefficients": [1e-6]}}}')  # fmt: skip
    out = tmp_path / "r.html"
    machine = ROOT / "machines" / "trunnion_mill.toml"
    assert main(["report", str(machine), "--errors", str(errors), "--out", str(out), "--kernels", str(KERNELS)]) == 0
    assert any("no standard uncertainties" in cell for cell in cells(out))


def test_faults_of_all_files_come_together(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    now, old, out = tmp_path / "now.json", tmp_path / "old.json", tmp_path / "r.html"
    now.write_text('{"schema": 1, "machine": "other"}')
    old.write_text("{")
    files = ["--errors", str(now), "--against", str(old), "--out", str(out)]
    assert main(["report", str(MACHINE), *files, "--kernels", str(KERNELS)]) == 2
    errors = capsys.readouterr().err
    assert "now.json" in errors
    assert "old.json" in errors
    assert not out.exists()
    assert main(["report", str(MACHINE), "--errors", str(now), "--out", str(now), "--kernels", str(KERNELS)]) == 2
