"""Tables as shops have them: tests from one side, columns that nobody asks for, zeros, machines without a 0."""

import re
from pathlib import Path

import numpy as np
import pytest

from tests.instrument_files.test_import import imported
from tests.machines import DMU60P
from trueaxis.cli.main import main
from trueaxis.measurement.data import read_data
from trueaxis.model.model import load_model

POINT = "target.point=0,0,-150"
TARGETS = [0.0, 100.0, 210.0, 300.0, 500.0]
PLACE = ("--map", "axis=X", POINT, "at.Y=0", "at.Z=0")


def table(path: Path, targets: list[float], head: str = "target [mm];error [um]", more: str = "") -> Path:
    rows = [f"{at:g};{number + 1}.5{more}" for number, at in enumerate(targets)]
    path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("targets", "directions"),
    [
        (TARGETS * 3, [1] * 15),  # from one side: the way back is no approach
        (TARGETS[::-1] * 2, [-1] * 10),
        (TARGETS + TARGETS[::-1], [1] * 5 + [-1] * 5),
        (TARGETS + TARGETS[-2::-1], [1] * 5 + [-1] * 4),
        ((TARGETS + TARGETS[::-1]) * 2, ([1] * 5 + [-1] * 5) * 2),
        ([0.0, 100.0, 0.0, 100.0], [1, 1, -1, 1]),  # two targets: from one side, or there and back
        ([300.0, 100.0, 210.0, 0.0, 500.0], [-1, -1, 1, -1, 1]),  # in no order
    ],
)
def test_passes_from_one_side_are_no_reversals(tmp_path: Path, targets: list[float], directions: list[int]) -> None:
    """The first target of every further pass got the direction of the way back."""
    data = imported(tmp_path / "data", table(tmp_path / "x.csv", targets), *PLACE)
    found = data.readings.directions[0]
    assert [int(one) for one in found[1:]] == directions[1:]
    one_way = len(targets) > 8 and len(set(directions)) == 1
    assert ("as a test from one side" in (tmp_path / "data" / "setup.toml").read_text()) == one_way


def test_columns_that_are_not_read_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    head = "target [mm];error [um];Richtung;Zeit [s]"
    imported(tmp_path / "data", table(tmp_path / "x.csv", TARGETS, head, ";auf;7"), *PLACE)
    assert "  columns not read (--map column.NAME): Richtung, Zeit [s]\n" in capsys.readouterr().out
    imported(tmp_path / "more", tmp_path / "x.csv", *PLACE, "column.time=Zeit")
    assert "column.NAME): Richtung\n" in capsys.readouterr().out


@pytest.mark.parametrize("units", ["mm;um;", "mm;um;-", "[mm];[um];", "mm;um"])
def test_a_line_of_units_may_leave_the_last_ones_out(tmp_path: Path, units: str) -> None:
    head = f"target;error;note\n{units}"
    data = imported(tmp_path / "data", table(tmp_path / "x.csv", TARGETS, head, ";good"), *PLACE, "zero=keep")
    assert data.readings.reading == pytest.approx(np.arange(1.5e-3, 6e-3, 1e-3))


def test_a_table_of_several_axes_has_its_zero_at_its_home(tmp_path: Path) -> None:
    """The readings at home were kept as they were, 5 um, against what the page says, and no machine fitted them."""
    (tmp_path / "d.csv").write_text("X;Y;reading [um]\n0;0;5.2\n100;50;6.0\n200;100;8.0\n0;0;5.4\n")
    words = ("--map", "direction=1,0,0", POINT, "at.Z=0")
    data = imported(tmp_path / "data", tmp_path / "d.csv", *words)
    assert data.readings.reading * 1e3 == pytest.approx([-0.1, 0.7, 2.7, 0.1])
    for more in (("zero=keep",), ("home.X=100",)):
        kept = imported(tmp_path / more[0].replace("=", ""), tmp_path / "d.csv", *words, *more)
        assert kept.readings.reading * 1e3 == pytest.approx([5.2, 6.0, 8.0, 5.4])


def test_a_ball_bar_where_no_axis_has_a_zero(tmp_path: Path) -> None:
    """It was refused for a home at 0, which no reading of a ball bar counts from."""
    spec = re.sub(r"(?m)^runs = .*$", "", DMU60P.read_text().replace("travel = [0.0, 700.0]", "travel = [80.0, 480.0]"))
    (machine := tmp_path / "high.toml").write_text(spec)
    assert main(["derive", str(machine), "--out", str(tmp_path / "generated")]) == 0
    rows = "\n".join(f"{angle},0.5" for angle in range(0, 360, 30))
    (tmp_path / "c.csv").write_text(f"angle [deg],deviation [um]\n{rows}\n")
    keys = ("plane=XY", "length=100", "at.X=200", "at.Y=250", "at.Z=100", POINT)
    words = ["import", tmp_path / "c.csv", "--machine", machine, "--out", tmp_path / "data", "--map", *keys]
    assert main([*map(str, words), "--kernels", str(tmp_path / "generated")]) == 0
    model = load_model(machine, None, tmp_path / "generated")
    (run,) = read_data(tmp_path / "data", model.machine).setup.runs
    assert (run.instrument, run.length) == ("ballbar", 100.0)


def test_other_data_are_replaced_on_demand_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A folder of checked runs was lost without a word."""
    out, words = tmp_path / "data", (table(tmp_path / "x.csv", TARGETS), *PLACE)
    imported(out, *words)
    imported(out, *words)  # the same again loses nothing
    before = (out / "setup.toml").read_text()
    (out / "setup.toml").write_text(before + "# checked\n")
    command = ["import", *map(str, words), "--machine", str(DMU60P), "--out", str(out)]
    assert main(command) == 2
    assert "holds other measured data, which would be lost; another folder, or --replace" in capsys.readouterr().err
    assert (out / "setup.toml").read_text().endswith("# checked\n")
    assert main([*command, "--replace"]) == 0
    assert (out / "setup.toml").read_text() == before
