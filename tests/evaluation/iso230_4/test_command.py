"""trueaxis evaluate on tables of a ball bar: what it prints, writes and refuses."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from tests.evaluation.iso230_4.path import Mill, turn
from trueaxis.cli.main import main

MILL = Mill(squareness=5e-5, reversal=(-8e-3, 0.0))
OPTIONS = ["--plane", "XY", "--radius", "150"]


@pytest.fixture
def files(tmp_path: Path) -> list[str]:
    """A file for each sense; one with decimal commas and the whole length."""
    draw = np.random.default_rng(2)
    found = []
    for sense, name in ((1, "ccw.csv"), (-1, "cw.csv")):
        angle = turn(sense, 400)
        reading = MILL.read(angle, sense, 150.0, 1000.0) + 2e-4 * draw.standard_normal(400)
        rows = [f"{np.degrees(a):.6f};{150.0 + d:.7f}".replace(".", ",") for a, d in zip(angle, reading, strict=True)]
        text = "angle [deg];radius [mm]\n" + "\n".join(rows) + "\n"
        if sense < 0:
            rows = [f"{np.degrees(a):.6f},{1e3 * d:.5f}" for a, d in zip(angle, reading, strict=True)]
            text = "angle (deg),deviation (um)\n" + "\n".join(rows) + "\n"
        (tmp_path / name).write_text(text)
        found.append(str(tmp_path / name))
    return found


def test_report_json_and_picture(files: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, picture = tmp_path / "r.json", tmp_path / "p.png"
    code = main(["evaluate", *files, *OPTIONS, "--feed", "1000", "--out", str(out), "--picture", str(picture)])
    text = capsys.readouterr().out
    assert code == 0
    assert text.isascii()
    assert max(map(len, text.splitlines()[1:-1])) <= 120, "the first and the last name files"
    tree = json.loads(out.read_text())
    # ranges: 8 um of each reversal, 150 mm * 50 urad = 7.5 um of the squareness
    assert [one["error"] for one in tree["errors"]][:3] == ["reversal_error", "reversal_error", "squareness"]
    (square,) = (one for one in tree["errors"] if one["error"] == "squareness")
    assert square["value"] == pytest.approx(50.0, abs=0.5)
    assert {one["sense"] for one in tree["arcs"]} == {"cw", "ccw"}
    assert tree["G_b"] > 0.0
    assert picture.read_bytes().startswith(b"\x89PNG")
    assert "squareness        XY" in text


def test_a_table_of_other_names(files: list[str], tmp_path: Path) -> None:
    """Columns that --map names make it a circle, as those of import's own names do."""
    for file in files:
        table = Path(file).read_text()
        for ours, theirs in (("angle", "Winkel"), ("radius", "Laenge"), ("deviation", "Abweichung")):
            table = table.replace(ours, theirs)
        (tmp_path / f"n{Path(file).name}").write_text(table)
    one, two = (str(tmp_path / name) for name in ("nccw.csv", "ncw.csv"))
    keys = ["nccw:column.angle=Winkel [deg]", "nccw:column.radius=Laenge [mm]", "ncw:column.angle=Winkel (deg)",
            "ncw:column.reading=Abweichung (um)"]  # fmt: skip
    for name, words in (("named", [one, two, "--map", *keys]), ("own", files)):
        assert main(["evaluate", *words, *OPTIONS, "--feed", "1000", "--out", str(tmp_path / f"{name}.json")]) == 0
    found, right = (json.loads((tmp_path / f"{name}.json").read_text()) for name in ("named", "own"))
    assert found["errors"] == right["errors"]
    assert found["G_b"] == right["G_b"]


def test_what_the_files_do_not_say_is_asked_for(files: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", files[0]]) == 2
    errors = capsys.readouterr().err
    assert "--plane XY" in errors
    assert "--radius 150" in errors


def test_faults_of_files_and_options(files: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    again = Path(files[1]).read_text().splitlines()
    (tmp_path / "both.csv").write_text("\n".join([*again, *again[:0:-1]]) + "\n")
    assert main(["evaluate", str(tmp_path / "both.csv"), *OPTIONS]) == 2
    assert "do not go one way" in capsys.readouterr().err
    assert main(["evaluate", files[0], "--plane", "XY", "--radius", "100", "--swap-directions"]) == 2
    assert "--swap-directions" in capsys.readouterr().err
    assert main(["evaluate", files[0], "--plane", "XY", "--radius", "100"]) == 2
    assert "from a radius of 100 mm" in capsys.readouterr().err
    feeds = [f"{line},{500 if k % 2 else 1000}" for k, line in enumerate(("cw", "ccw"))]
    both = [f"{row},{feed}" for row, feed in ((r, f) for f in feeds for r in again[1:])]
    (tmp_path / "feeds.csv").write_text("\n".join(["angle (deg),deviation (um),run,feed (mm/min)", *both]) + "\n")
    assert main(["evaluate", str(tmp_path / "feeds.csv"), *OPTIONS]) == 2
    assert "arcs at different feeds, 1000, 500 mm/min" in capsys.readouterr().err
    (tmp_path / "few.csv").write_text("\n".join(again[:40]) + "\n")
    assert main(["evaluate", str(tmp_path / "few.csv"), *OPTIONS]) == 2
    assert "at least half a circle" in capsys.readouterr().err
    line = tmp_path / "line.csv"
    line.write_text("target,cycle,direction,measured\n0,1,1,0\n0,1,-1,0\n10,1,1,10\n10,1,-1,10\n")
    assert main(["evaluate", files[0], str(line), *OPTIONS]) == 2
    assert "two kinds" in capsys.readouterr().err
    assert main(["evaluate", str(line), "--plane", "XY"]) == 2
    assert "positioning test" in capsys.readouterr().err


def test_zeros_have_no_sign(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    angle = turn(1, 90)
    rows = [f"{np.degrees(a):.6f},{-1e-7 + 3e-3 * np.sin(2 * a):.9f}" for a in angle]
    (tmp_path / "c.csv").write_text("angle (deg),deviation (mm)\n" + "\n".join(rows) + "\n")
    assert main(["evaluate", str(tmp_path / "c.csv"), *OPTIONS]) == 0
    told = capsys.readouterr().out
    assert "radius: 0.00 um above nominal" in told
    assert not re.search(r"-0\.0+\b", told)
