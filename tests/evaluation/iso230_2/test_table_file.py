"""The plain table: the same test in any order of rows and either kind of file, or every fault at its place."""

from contextlib import suppress
from pathlib import Path

import numpy as np
import polars as pl
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.evaluation.iso230_2.builders import made_up
from trueaxis.evaluation.positioning_table_file import read_positioning_test
from trueaxis.evaluation.positioning_test import PositioningTest, Unit
from trueaxis.io.faults import Fault, InputError

TEST = made_up(3, 2)
SETTINGS = settings(max_examples=200, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


def rows(test: PositioningTest) -> list[tuple[float, int, str, float]]:
    return [
        (float(test.targets[i]), int(j) + 1, label, float(value))
        for label, grid in (("+1", test.positive), ("-1", test.negative))
        for (i, j), value in np.ndenumerate(grid)
    ]


def csv_text(found: list[tuple[float, int, str, float]]) -> str:
    lines = [f"{target!r},{cycle},{direction},{measured!r}" for target, cycle, direction, measured in found]
    return "\n".join(["target,cycle,direction,measured", *lines]) + "\n"


LINES = csv_text(rows(TEST)).splitlines()


def read(tmp_path: Path, text: str | bytes) -> PositioningTest:
    path = tmp_path / "axis.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_positioning_test(path)


def faults_of(tmp_path: Path, text: str) -> tuple[Fault, ...]:
    with pytest.raises(InputError) as caught:
        read(tmp_path, text)
    return caught.value.faults


def assert_is_the_test(found: PositioningTest) -> None:
    assert np.array_equal(found.targets, TEST.targets)
    assert np.array_equal(found.positive, TEST.positive)
    assert np.array_equal(found.negative, TEST.negative)


@given(order=st.permutations(rows(TEST)))
@SETTINGS
def test_rows_in_any_order_are_the_same_test(tmp_path: Path, order: list[tuple[float, int, str, float]]) -> None:
    assert_is_the_test(read(tmp_path, csv_text(order)))


@pytest.mark.parametrize(
    ("plus", "minus"),
    [
        ("1", "-1"),
        ("forward", "backward"),
        ("Forward", "BACKWARD"),
        ("fwd", "bwd"),
        ("pos", "neg"),
        ("+", "-"),
        (" +1 ", '"-1"'),
    ],
)
def test_directions_have_several_names(tmp_path: Path, plus: str, minus: str) -> None:
    assert_is_the_test(read(tmp_path, csv_text(rows(TEST)).replace(",+1,", f",{plus},").replace(",-1,", f",{minus},")))


@pytest.mark.parametrize("kind", [pl.Int8, pl.Int64, pl.String])
def test_parquet_is_accepted_with_the_columns_in_any_order(tmp_path: Path, kind: type[pl.DataType]) -> None:
    columns = ("target", "cycle", "direction", "measured")
    frame = pl.DataFrame(rows(TEST), schema=columns, orient="row")
    frame = frame.with_columns(pl.col("direction").str.strip_prefix("+").cast(kind)).select(reversed(columns))
    frame.write_parquet(tmp_path / "axis.parquet")
    assert_is_the_test(read_positioning_test(tmp_path / "axis.parquet"))


def test_cycles_need_not_count_from_one(tmp_path: Path) -> None:
    moved = [(target, cycle + 7, direction, measured) for target, cycle, direction, measured in rows(TEST)]
    assert_is_the_test(read(tmp_path, csv_text(moved)))


@pytest.mark.parametrize(
    ("line", "replacement", "place", "words"),
    [
        (3, "x,1,+1,0", "line 3, column target", "is not a number"),
        (3, ",1,+1,0", "line 3, column target", "is empty"),
        (3, "1e7,1,+1,0", "line 3, column target", "is too far"),
        (3, "-1e7,1,+1,0", "line 3, column target", "is too far"),
        (4, "{target},{cycle},+1,-9e4", "line 4, column measured", "is far off its target"),
        (4, "{target},1.5,+1,{measured}", "line 4, column cycle", "is not a whole number"),
        (4, "{target},{cycle},up,{measured}", "line 4, column direction", "is not a direction"),
        (4, "{target},{cycle},0,{measured}", "line 4, column direction", "is not a direction"),
        (4, "{target},{cycle},+1,nan", "line 4, column measured", "is not a finite number"),
        (4, "{target},{cycle},+1,", "line 4, column measured", "is empty"),
        (4, "{target},{cycle},+1,9e4", "line 4, column measured", "is far off its target"),
        (4, "{target},{cycle},+1", "line 4", "has 3 cells"),
    ],
)
def test_a_wrong_cell_is_the_one_fault(tmp_path: Path, line: int, replacement: str, place: str, words: str) -> None:
    lines = list(LINES)
    target, cycle, _, measured = lines[line - 1].split(",")
    lines[line - 1] = replacement.format(target=target, cycle=cycle, measured=measured)
    found = faults_of(tmp_path, "\n".join(lines))
    assert [fault.place for fault in found] == [place]
    assert words in found[0].problem


def test_a_row_given_twice_and_one_missing_are_both_told(tmp_path: Path) -> None:
    lines = list(LINES)
    lines[-1] = lines[-2]
    found = faults_of(tmp_path, "\n".join(lines))
    assert [fault.place for fault in found] == [f"line {len(lines)}, column cycle", ""]
    assert found[1].problem == f"there is no row of target {TEST.targets[-1]:.12g}, cycle 2, backward"


@pytest.mark.parametrize(
    ("text", "problems"),
    [
        ("target,cycle,direction,measured\n", ["has no rows"]),
        ("target,cycle,measurd\n1,1,1\n", ["column direction: is missing", "column measured: is missing", "measurd"]),
        ("target,cycle,direction,measured\n1,1,+1,1\n", ["has 1 target:", "has 1 cycle:", "no row backward"]),
    ],
)
def test_tables_that_are_no_test(tmp_path: Path, text: str, problems: list[str]) -> None:
    told = "\n".join(str(fault) for fault in faults_of(tmp_path, text))
    assert all(problem in told for problem in problems)


def test_a_million_rows_that_are_no_grid_are_told_briefly(tmp_path: Path) -> None:
    count = 1_000_000
    frame = pl.DataFrame({"target": np.arange(count) * 0.01, "cycle": np.arange(count)})
    frame = frame.with_columns(direction=pl.lit(1), measured=pl.col("target"))
    frame.write_csv(tmp_path / "axis.csv")
    with pytest.raises(InputError) as caught:
        read_positioning_test(tmp_path / "axis.csv")
    assert [fault.place for fault in caught.value.faults] == ["column target"]


def in_columns(separator: str, decimals: str, head: str = "target,cycle,direction,measured") -> str:
    lines = csv_text(rows(TEST)).splitlines()[1:]
    cells = [[cell.replace(".", decimals) for cell in line.split(",")] for line in lines]
    return "\n".join(separator.join(row) for row in [head.split(","), *cells]) + "\n"


@pytest.mark.parametrize(("separator", "decimals"), [(";", ","), (";", "."), ("\t", ","), ("|", ",")])
@pytest.mark.parametrize("above", ["", "Positioning test of X\nlaser 123, 20 degC\n"])
def test_tables_of_spreadsheets_are_read(tmp_path: Path, separator: str, decimals: str, above: str) -> None:
    """As programs write them where the comma is that of the decimals, under lines of text or not."""
    assert_is_the_test(read(tmp_path, above + in_columns(separator, decimals)))


def test_units_of_the_header_count(tmp_path: Path) -> None:
    lines = [f"{t / 1e3!r},{c},{d},{1e3 * m!r}" for t, c, d, m in rows(TEST)]
    found = read(tmp_path, "\n".join(["Target [m],cycle,direction,measured_um", *lines]))
    np.testing.assert_allclose(found.targets, TEST.targets, rtol=1e-15)
    np.testing.assert_allclose(found.positive, TEST.positive, rtol=1e-15)


@pytest.mark.parametrize(("unit", "scale", "of"), [("um", 1e3, "mm"), ("mm", 1.0, "mm"), ("arcsec", 3600.0, "deg")])
def test_deviations_are_a_column_of_their_own(tmp_path: Path, unit: str, scale: float, of: Unit) -> None:
    lines = [f"{t!r},{c},{d},{(m - t) * scale!r}" for t, c, d, m in rows(TEST)]
    path = tmp_path / "axis.csv"
    path.write_text("\n".join([f"target,cycle,direction,deviation [{unit}]", *lines]))
    found = read_positioning_test(path, of)
    np.testing.assert_allclose(found.positive, TEST.positive, atol=1e-12)
    np.testing.assert_allclose(found.negative, TEST.negative, atol=1e-12)


def test_a_deviation_without_a_unit_is_asked_for_it(tmp_path: Path) -> None:
    """3.1 may be um or mm: neither is taken."""
    (fault,) = faults_of(tmp_path, csv_text(rows(TEST)).replace("measured", "deviation"))
    assert (fault.place, fault.problem) == ("column deviation", "does not say its unit")
    assert "deviation [um]" in fault.remedy


def test_deviations_typed_as_positions_are_one_question(tmp_path: Path) -> None:
    lines = [f"{100.0 + 100.0 * t!r},{c},{d},{(m - t)!r}" for t, c, d, m in rows(TEST)]
    (fault,) = faults_of(tmp_path, "\n".join(["target,cycle,direction,measured", *lines]))
    assert fault.place == "column measured"
    assert "are these deviations?" in fault.problem
    assert "name the column deviation" in fault.remedy


def test_a_word_that_is_no_direction_is_one_fault(tmp_path: Path) -> None:
    text = csv_text(rows(TEST)).replace(",+1,", ",hin,").replace(",-1,", ",her,")
    forward, backward = faults_of(tmp_path, text)
    assert forward.place == "line 2, column direction"
    assert forward.problem == '"hin" is not a direction, and so in 5 more: line 3, line 4, line 5, line 6, line 7'
    assert backward.place == "line 8, column direction"


@pytest.mark.parametrize("name", ["axis.xlsx", "axis", "axis.DAT"])
def test_a_file_of_no_known_kind_is_a_fault(tmp_path: Path, name: str) -> None:
    (tmp_path / name).write_text("target")
    with pytest.raises(InputError, match=r"\.dat, \.csv, \.txt or \.parquet"):
        read_positioning_test(tmp_path / name)


@given(at=st.integers(0, len(csv_text(rows(TEST))) - 1), new=st.text(alphabet='0123456789.-+e,"\n xé', max_size=3))
@SETTINGS
def test_a_mutated_table_is_a_fault_or_another_test(tmp_path: Path, at: int, new: str) -> None:
    text = csv_text(rows(TEST))
    mutated = text[:at] + new + text[at + 1 :]
    with suppress(InputError):
        found = read(tmp_path, mutated)
        cells = [line.split(",") for line in mutated.split("\n")[1:] if line.strip()]
        values = sorted([*found.positive.ravel(), *found.negative.ravel()])
        assert values == sorted(float(row[3].strip('"')) for row in cells)
        assert found.targets.tolist() == sorted({float(row[0].strip('"')) for row in cells})
