"""trueaxis evaluate: what it prints, writes, draws and refuses."""

import json
import re
from pathlib import Path

import numpy as np
import pytest

from tests.evaluation.iso230_2.builders import dat_text, made_up
from trueaxis.cli.main import main
from trueaxis.evaluation.positioning_test import evaluate
from trueaxis.reporting.pictures.standard_tests import _positioning_figure, positioning_plot

TEST = made_up(6, 5)
PNG = b"\x89PNG\r\n\x1a\n"


@pytest.fixture
def data(tmp_path: Path) -> Path:
    path = tmp_path / "axis.dat"
    path.write_text(dat_text(TEST))
    return path


def test_the_report_prints_the_values_in_micrometres(data: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", str(data)]) == 0
    text = capsys.readouterr().out
    found, lines = evaluate(TEST), text.splitlines()
    assert text.isascii()
    assert "ISO 230-2:2014, k = 2" in lines[0]
    third = next(line.split() for line in lines if line.startswith("   3"))
    side = [found.positive, found.negative]
    expected = [side[0].mean, side[1].mean, found.mean, found.b, side[0].s, side[1].s, side[0].r, side[1].r, found.r]
    assert float(third[1]) == TEST.targets[2]
    assert [float(cell) for cell in third[2:]] == pytest.approx([1e3 * v[2] for v in expected], abs=0.0051)
    last = {
        line[:33].strip(): [float(cell) for cell in line[33:].split()]
        for line in lines
        if re.match(r"\w.* [A-Z] ", line)
    }
    for name, values in {
        "reversal value B": [found.B],
        "repeatability R": [side[0].R, side[1].R, found.R],
        "systematic deviation E": [side[0].E, side[1].E, found.E],
        "mean bidirectional deviation M": [found.M],
        "accuracy A": [side[0].A, side[1].A, found.A],
    }.items():
        assert last[name] == pytest.approx([1e3 * value for value in values], abs=0.0051)
    assert "the standard's" in text
    assert "note:" not in text


def test_json_holds_every_value_in_millimetres(data: Path, tmp_path: Path) -> None:
    out = tmp_path / "report.json"
    assert main(["evaluate", str(data), "--out", str(out)]) == 0
    tree, found = json.loads(out.read_text()), evaluate(TEST)
    assert tree["targets"] == TEST.targets.tolist()
    assert tree["negative"]["standard_uncertainty"] == found.negative.s.tolist()
    assert tree["positive"]["R"] == found.positive.R
    assert tree["bidirectional"]["reversal_value"] == found.b.tolist()
    for name in ("B", "B_mean", "R", "E", "M", "A"):
        assert tree["bidirectional"][name] == getattr(found, name)
    assert tree["repeatability"] == {"convention": "iso", "standard": True}


def test_options_choose_the_convention_and_the_directions(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "report.json"
    arguments = ["--out", str(out), "--repeatability", "unidirectional", "--swap-directions"]
    assert main(["evaluate", str(data), *arguments]) == 0
    text = capsys.readouterr().out
    tree, found = json.loads(out.read_text()), evaluate(TEST.swapped(), "unidirectional")
    assert tree["bidirectional"]["R"] == found.R != evaluate(TEST).R
    assert tree["positive"]["mean_deviation"] == evaluate(TEST).negative.mean.tolist()
    assert not tree["repeatability"]["standard"]
    assert "NOT the standard's" in text
    assert "every B_i is positive" in text


def test_wrong_input_is_told_and_touches_no_file(
    data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data.write_text(dat_text(TEST).replace("UNIT=mm", "UNIT=um").replace("TGT_DATA[2]=", "TGT_DATA[2]=x"))
    out, picture = tmp_path / "report.json", tmp_path / "axis.png"
    out.write_text("before")
    assert main(["evaluate", str(data), "--out", str(out), "--picture", str(picture)]) == 2
    told = capsys.readouterr()
    assert not told.out
    assert [line.split(": ")[2] for line in told.err.splitlines()] == ["line 4", "line 9"]
    assert out.read_text() == "before"
    assert not picture.exists()


def test_a_file_named_twice_is_a_fault(data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = data.read_bytes()
    both = str(tmp_path / "both")
    assert main(["evaluate", str(data), "--out", both, "--picture", both]) == 2
    assert main(["evaluate", str(data), "--out", str(data)]) == 2
    assert capsys.readouterr().err.count("is both") == 2
    assert data.read_bytes() == before
    assert not Path(both).exists()


def test_a_missing_file_is_a_fault(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", str(tmp_path / "none.dat")]) == 2
    assert "there is no such file" in capsys.readouterr().err


def test_the_picture_is_written_and_the_same_each_time(data: Path, tmp_path: Path) -> None:
    picture = tmp_path / "axis.png"
    assert main(["evaluate", str(data), "--picture", str(picture)]) == 0
    assert picture.read_bytes().startswith(PNG)
    assert picture.read_bytes() == positioning_plot(evaluate(TEST), "axis")
    assert picture.read_bytes() != positioning_plot(evaluate(TEST.swapped()), "axis")


def test_a_name_with_dollar_signs_is_drawn_as_it_is(data: Path) -> None:
    assert positioning_plot(evaluate(TEST), r"a$\b$c").startswith(PNG)


def test_the_picture_shows_means_and_limits_in_micrometres() -> None:
    found = evaluate(TEST)
    figure = _positioning_figure(found, "axis")
    lines = {str(line.get_label()): np.asarray(line.get_xydata()) for line in figure.axes[0].get_lines()}
    for name, side in (("positive", found.positive), ("negative", found.negative)):
        drawn = next(points for label, points in lines.items() if label.startswith(name))
        assert drawn[:, 0] == pytest.approx(TEST.targets)
        assert drawn[:, 1] == pytest.approx(1e3 * side.mean)
    low, high = (float(np.asarray(line.get_ydata())[0]) for line in figure.axes[0].get_lines()[1:3])
    assert high - low == pytest.approx(1e3 * found.A)
