"""trueaxis report: what it writes and refuses."""

from html.parser import HTMLParser
from pathlib import Path

import pytest

from tests.machines import ROOT
from tests.reporting.certificate.test_content import ECY, EXX, KERNELS, MACHINE, written
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
