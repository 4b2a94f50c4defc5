"""trueaxis evaluate of a .rtl file: the figures of the same readings in a table; what is no bidirectional test."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.evaluation.iso230_2.builders import made_up
from tests.evaluation.iso230_2.test_axes import table
from tests.instrument_files.writers import rtl
from trueaxis.cli.main import main


def deviations(cycles: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """Targets, and (runs, m) um, up and down by turns."""
    test = made_up(6, cycles)
    order = np.stack([test.positive.T, test.negative.T], axis=1).reshape(2 * cycles, -1)
    return test.targets, 1e3 * (order - test.targets)


def test_a_rtl_file_has_the_figures_of_a_table(tmp_path: Path) -> None:
    targets, off = deviations()
    (tmp_path / "x.rtl").write_bytes(rtl(targets.tolist(), off, axis="X", digits=12).encode("gbk"))
    table(tmp_path / "x.csv", made_up(6, 3))
    for name in ("x.rtl", "x.csv"):
        assert main(["evaluate", str(tmp_path / name), "--out", str(tmp_path / f"{name}.json")]) == 0
    found, right = (json.loads((tmp_path / f"{name}.json").read_text()) for name in ("x.rtl", "x.csv"))
    for figure in ("B", "B_mean", "R", "E", "M", "A"):
        assert found["bidirectional"][figure] == pytest.approx(right["bidirectional"][figure], abs=1e-9)


def foreign(path: Path, cycles: int = 3, scale: float = 1e3, skip: int | None = None) -> None:
    """The same readings under the names of another program, decimal commas, without cycles; skip: a row left out."""
    targets, off = deviations(cycles)
    rows = [
        f"{targets[k]};{off[run, k] / 1e3 * scale:.9f};{'vor' if run % 2 == 0 else 'rück'}".replace(".", ",")
        for run in range(2 * cycles)
        for k in (range(6) if run % 2 == 0 else range(5, -1, -1))
    ]
    if skip is not None:
        del rows[skip]
    path.write_text("Soll;Abweichung;Bemerkung\n" + "\n".join(rows) + "\n")


@pytest.mark.parametrize(
    ("scale", "unit", "rotary"), [(1e3, "um", []), (1.0, "mm", []), (3600.0, "arcsec", ["--rotary"])]
)
def test_a_table_of_other_names_has_the_figures_of_a_table(
    tmp_path: Path, scale: float, unit: str, rotary: list[str]
) -> None:
    foreign(tmp_path / "x.csv", scale=scale)
    table(tmp_path / "y.csv", made_up(6, 3))
    keys = ["--map", "column.target=Soll", "column.reading=Abweichung", f"unit.reading={unit}"]
    keys += ["unit.target=deg"] if rotary else []
    for name, words in (("x", [*rotary, *keys]), ("y", rotary)):
        assert main(["evaluate", str(tmp_path / f"{name}.csv"), *words, "--out", str(tmp_path / f"{name}.json")]) == 0
    found, right = (json.loads((tmp_path / f"{name}.json").read_text()) for name in "xy")
    for figure in ("B", "B_mean", "R", "E", "M", "A"):
        assert found["bidirectional"][figure] == pytest.approx(right["bidirectional"][figure], rel=1e-6)


def test_what_is_wrong_with_a_table_of_other_names(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "x.csv"

    def refused(*words: str, skip: int | None = None) -> str:
        foreign(file, skip=skip)
        assert main(["evaluate", str(file), *words]) == 2
        return capsys.readouterr().err

    keys = ["--map", "column.target=Soll", "column.reading=Abweichung"]
    assert "does not say the unit of its column Abweichung" in refused(*keys)
    assert '"Sol" is not right' in refused("--map", "column.target=Sol", *keys[2:], "unit.reading=um")
    assert "at.X: is no key that these files ask for" in refused(*keys, "unit.reading=um", "at.X=1")
    assert "not all targets were approached equally often in the negative" in refused(*keys, "unit.reading=um", skip=7)
    assert "has lengths; of a rotary axis angles" in refused(*keys, "unit.reading=um", "--rotary")
    table(file, made_up(6, 3))
    assert main(["evaluate", str(file), "--map", "column.target=target"]) == 2
    assert "names its columns and units itself" in capsys.readouterr().err


def test_what_is_no_bidirectional_test_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    targets, off = deviations()
    file = tmp_path / "x.rtl"

    def refused(text: str, *words: str) -> str:
        file.write_bytes(text.encode())
        assert main(["evaluate", str(file), *words]) == 2
        return capsys.readouterr().err

    assert "3 runs in the positive direction and 2 in the negative one" in refused(rtl(targets.tolist(), off[:5]))
    assert "has 1 cycle: an evaluation needs at least 2" in refused(rtl(targets.tolist(), off[:2]))
    assert "has lengths" in refused(rtl(targets.tolist(), off), "--rotary")
    mixed = targets[[0, 2, 1, 3, 4, 5]]
    assert "does not go one way" in refused(rtl(mixed.tolist(), off))
    assert "DEVIATIONS: one is " in refused(rtl(targets.tolist(), 1e4 * off))
    angles = tmp_path / "x.rta"
    angles.write_bytes(rtl(targets.tolist(), off).encode())
    assert main(["evaluate", str(angles)]) == 2
    assert "has angles" in capsys.readouterr().err
