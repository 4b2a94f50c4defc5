"""trueaxis evaluate --diagonals: what it prints, writes and refuses; the same from arrays."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import trueaxis as ta
from tests.evaluation.iso230_6.skewed import Skewed, table
from trueaxis.cli.main import main

SIDES = np.array([500.0, 400.0, 300.0])
LENGTHS = ["--diagonals", "X=500", "Y=400", "Z=300"]
NAMES = ("ppp", "npp", "pnp", "ppn")
TARGETS = np.round(np.linspace(0.0, float(np.linalg.norm(SIDES)), 8), 3)
MACHINE = Skewed(xy=80e-6, xz=-50e-6, lost=(-6e-3, -4e-3, 2e-3))


def readings(name: str, cycles: int) -> dict[int, np.ndarray]:
    draw = np.random.default_rng([ord(letter) for letter in name])
    once = {way: MACHINE.measured(name, SIDES, TARGETS, way)[:, np.newaxis] for way in (1, -1)}
    return {way: values + draw.normal(0.0, 5e-4, (TARGETS.size, cycles)) for way, values in once.items()}


def files(folder: Path, cycles: int = 3) -> list[str]:
    return [str(table(folder / f"mill_{name}.csv", readings(name, cycles), TARGETS)) for name in NAMES]


def test_report_json_and_picture(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    deep = tmp_path / ("folder" * 20)  # names of files made the title wider than the picture
    deep.mkdir()
    out, picture, data = tmp_path / "d.json", tmp_path / "d.png", files(deep)
    assert main(["evaluate", *data, *LENGTHS, "--out", str(out), "--picture", str(picture)]) == 0
    text = capsys.readouterr().out
    assert text.isascii()
    assert max(map(len, text.splitlines()[1:-1])) <= 120, "the first and the last name files"
    tree = json.loads(out.read_text())
    assert [one["of"] for one in tree["squareness"]] == ["XY", "XZ", "YZ"]
    for one, right in zip(tree["squareness"], (80e-6, -50e-6, 0.0), strict=True):
        assert one["value"] == pytest.approx(right, abs=3e-6)
        assert 0.0 < one["u"] < 2e-6
    assert tree["E_d"] == max(one["E"] for one in tree["diagonals"])
    assert tree["B_d"] == max(one["B"] for one in tree["diagonals"])
    assert f"{1e3 * tree['E_d']:.2f} um" in text
    assert "do not prove a good machine" in text.replace("\n", " ")
    assert picture.read_bytes().startswith(b"\x89PNG")
    one = tree["diagonals"][1]
    alone = ta.evaluate(data[1])
    assert isinstance(alone, ta.EvaluatedPositioning)
    assert [one[name] for name in "EBRAM"] == [getattr(alone.evaluation, name) for name in "EBRAM"]


def test_a_column_run_and_arrays_give_the_same(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", *files(tmp_path), *LENGTHS, "--out", str(tmp_path / "files.json")]) == 0
    whole = [table(tmp_path / "one.csv", readings(name, 3), TARGETS, name.upper()).read_text() for name in NAMES]
    head = whole[0].splitlines()[0]
    (tmp_path / "one.csv").write_text(head + "\n" + "".join(text.split("\n", 1)[1] for text in whole))
    assert main(["evaluate", str(tmp_path / "one.csv"), *LENGTHS, "--out", str(tmp_path / "run.json")]) == 0
    told = capsys.readouterr().out
    lengths = {"X": 500.0, "Y": 400.0, "Z": 300.0}
    tests = {name: ta.PositioningTest(TARGETS, readings(name, 3)[1], readings(name, 3)[-1]) for name in NAMES}
    done = ta.evaluate(tests, diagonals=lengths)
    assert isinstance(done, ta.EvaluatedDiagonals)
    assert done.to_json() == (tmp_path / "files.json").read_text() == (tmp_path / "run.json").read_text()
    assert str(done).split("\n", 1)[1] in told
    turned = ta.evaluate(tests, diagonals=dict(reversed(lengths.items())))
    assert turned.to_json() == done.to_json(), "letters are those of X, Y, Z, however the lengths are given"
    assert done.to_polars()["E"].max() == done.figures.E_d
    with pytest.raises(ValueError, match=r"diagonals: expected lengths of two axes or three of X, Y, Z; given {'X'"):
        ta.evaluate(tests, diagonals={"X": 500.0})
    with pytest.raises(ValueError, match="several tests are diagonals"):
        ta.evaluate(tests)
    with pytest.raises(ValueError, match="given one without a name"):
        ta.evaluate(tests["ppp"], diagonals=lengths)
    with pytest.raises(ValueError, match="expected tests in mm"):
        ta.evaluate({"ppp": replace(tests["ppp"], unit="deg")}, diagonals=lengths)


def test_columns_of_other_names(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A German table with decimal commas; its columns are named with the unit of their head, and without it."""
    for name in NAMES:
        rows = ["Soll;Richtung;Abweichung [um]"]
        for cycle in range(3):
            for way, order in ((1, slice(None)), (-1, slice(None, None, -1))):
                for target, value in list(zip(TARGETS, readings(name, 3)[way][:, cycle], strict=True))[order]:
                    rows.append(f"{target:.3f};{way};{1e3 * (value - target):.9f}".replace(".", ","))
        (tmp_path / f"german_{name}.csv").write_text("\n".join(rows) + "\n")
    german = [str(tmp_path / f"german_{name}.csv") for name in NAMES]
    keys = ["--map", "column.target=Soll", "column.direction=Richtung"]
    trees = []
    for data, reading in ((files(tmp_path), []), (german, ["Abweichung"]), (german, ["Abweichung [um]"])):
        given = [*keys, *(f"column.reading={one}" for one in reading)] if reading else []
        assert main(["evaluate", *data, *LENGTHS, *given, "--out", str(tmp_path / "d.json")]) == 0
        trees.append(json.loads((tmp_path / "d.json").read_text()))
    for tree in trees[1:]:
        assert tree["E_d"] == pytest.approx(trees[0]["E_d"], abs=2e-9)
        assert [one["value"] for one in tree["squareness"]] == pytest.approx(
            [one["value"] for one in trees[0]["squareness"]], abs=1e-11
        )
    capsys.readouterr()
    assert main(["evaluate", *german, *LENGTHS, *keys[:-1], "column.direction=Richtg", "column.reading=Abw"]) == 2
    told = capsys.readouterr().err
    for name in NAMES:
        assert f'german_{name}.csv: run german_{name}, column.direction: "Richtg" is not right' in told
    assert "a column of the header, line 1: Soll, Richtung, Abweichung [um]" in told
    assert main(["evaluate", *files(tmp_path), *LENGTHS, *keys]) == 2
    assert "names its columns and units itself" in capsys.readouterr().err


def test_one_cycle_gives_no_repeatability(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["evaluate", *files(tmp_path, 1), *LENGTHS, "--out", str(tmp_path / "d.json")]) == 0
    assert "R, A and u are not estimated" in capsys.readouterr().out
    tree = json.loads((tmp_path / "d.json").read_text())
    assert [(one["R"], one["A"], one["scale"]["u"]) for one in tree["diagonals"]] == [(None, None, None)] * 4
    assert tree["squareness"][0]["value"] == pytest.approx(80e-6, abs=3e-6)
    assert tree["squareness"][0]["u"] is None


def test_what_is_wrong_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    data = files(tmp_path)

    def refused(*words: str) -> str:
        assert main(["evaluate", *words]) == 2
        return capsys.readouterr().err

    assert "along diagonals: --diagonals" in refused(*data)
    assert "a diagonal of X 500, Y 400, Z 310 mm is 711.4" in refused(*data, "--diagonals", "X=500", "Y=400", "Z=310")
    assert "each once" in refused(*data, "--diagonals", "X=500", "X=400")
    again = Path(data[0]).rename(tmp_path / "first.csv")
    told = refused(str(again), *data[1:], str(table(tmp_path / "b_nnp.csv", readings("ppn", 2), TARGETS)), *LENGTHS)
    assert "run first" in told
    assert "a name that ends in ppp, npp, pnp, ppn" in told
    assert "is of the same diagonal as mill_ppn" in told
    assert "--plane: " in refused(*data[1:], *LENGTHS, "--plane", "XY")
    (tmp_path / "bad.csv").write_text("target,cycle,direction,measured,run\n0,1,1,0,ppp\n0,1,up,0,npp\n")
    told = refused(str(tmp_path / "bad.csv"), *LENGTHS)
    assert "bad.csv: run npp, line 3, column direction" in told
    assert "bad.csv: run ppp, column target: has 1 target" in told
    (tmp_path / "none.csv").write_text("target,cycle,direction,measured,run\n")
    assert "none.csv: has no readings" in refused(str(tmp_path / "none.csv"), *LENGTHS)
