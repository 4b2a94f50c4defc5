"""Tables and set-ups with what no measurement has: each value is a fault at its place, soon, and short."""

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import polars as pl
import pytest

from tests.measurement.adapter import Dmu60pAxes
from tests.measurement.test_readings import RUNS, VALID
from tests.measurement.test_readings import faults_of as faults_of_readings
from tests.measurement.test_setup import CONTRACT
from tests.measurement.test_setup import faults_of as faults_of_setup
from trueaxis.io.faults import InputError
from trueaxis.measurement.limits import LONGEST_ID, MOST_COLUMNS
from trueaxis.measurement.points import read_points
from trueaxis.measurement.readings_reader import read_readings
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.measurement.setup_reader import read_setup

HEADER = "run,seq,reading,X,Y,time_s,feed,temperature_c,Z"
ROW = "X1,1,0,0,0,1,1000,20,0"


def faults_with(folder: Path, column: str, cell: str) -> list[str]:
    cells = dict(zip(HEADER.split(","), ROW.split(","), strict=True)) | {column: cell}
    return faults_of_readings(folder, f'{HEADER}\n{",".join(cells.values())}\n"b, c",1,0,0,0,1,,,0\n')


@pytest.mark.parametrize(
    ("column", "cell", "fault"),
    [
        ("temperature_c", "1e300", "line 2, column temperature_c: 1e300 is outside what can be; degC, from -100"),
        ("temperature_c", "293.15", "line 2, column temperature_c: 293.15 is outside what can be; degC"),
        ("temperature_c", "-274", "line 2, column temperature_c: -274 is outside"),
        ("time_s", "1e300", "line 2, column time_s: 1e300 is outside what can be; s, from -1e+10 to 1e+10"),
        ("time_s", "1763000000000", "line 2, column time_s: 1763000000000 is outside"),
        ("feed", "-1", "line 2, column feed: -1 is outside what can be; mm/min, from 0 to 1e+06"),
        ("feed", "1e300", "line 2, column feed: 1e300 is outside"),
        ("feed", "0x10", "line 2, column feed: 0x10 is not a number"),
        ("X", "1_000", "line 2, column X: 1_000 is not a number"),
        ("X", "\u0661\u0662", "line 2, column X: \u0661\u0662 is not a number"),
        ("X", "1e308", "line 2, column X: 1e308 is outside the travel"),
        ("X", "1e400", "line 2, column X: 1e400 is not a finite number"),
        ("seq", "9223372036854775808", "line 2, column seq: 9223372036854775808 is not a whole number"),
        ("reading", "1e308", "line 2, column reading: 1e308 is too large"),
        ("reading", "nan", "line 2, column reading: nan is not a finite number"),
        ("reading", "-Infinity", "line 2, column reading: -Infinity is not a finite number"),
        ("run", "X" * 100_000, f'line 2, column run: the setup has no run "{"X" * 36} ..."; runs X1, b, c'),
    ],
)  # fmt: skip
def test_each_is_a_fault_at_its_cell(tmp_path: Path, column: str, cell: str, fault: str) -> None:
    found = [one.replace('"' + cell + '"', cell) for one in faults_with(tmp_path, column, cell)]
    assert any(one.startswith(fault) for one in found), found


@pytest.mark.parametrize(
    ("column", "cell"), [("reading", "-0.0"), ("reading", "1e-320"), ("feed", "0"), ("time_s", "1.7e9")]
)
def test_what_is_small_or_rare_is_read(tmp_path: Path, column: str, cell: str) -> None:
    found = faults_with(tmp_path, column, cell + "x")  # the fault is of the x alone
    assert found == [f'line 2, column {column}: "{cell}x" is not a number; ']


@pytest.mark.parametrize("name", ["temperature_c", "time_s", "tool_x"])
def test_points_have_the_same_limits(tmp_path: Path, name: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(f"X,Y,Z,{name}\n0,0,0,1e308\n")
    with pytest.raises(InputError, match=f'line 2, column {name}: "1e308" is (outside|too far)'):
        read_points(path, Dmu60pAxes())


def test_a_million_columns_are_one_fault(tmp_path: Path) -> None:
    before = time.perf_counter()
    found = faults_of_readings(tmp_path, ",".join(f"x{number}" for number in range(1_000_000)) + "\n")
    assert found == [f"line 1: has 1000000 columns; {MOST_COLUMNS} at most"]
    assert time.perf_counter() - before < 20


def test_control_characters_do_not_reach_the_terminal(tmp_path: Path) -> None:
    path = tmp_path / "readings.csv"
    path.write_text(VALID.replace("1.25e-3", "\x1b[2J\x00").replace("time_s", "\x1b]0;title\x07"))
    with pytest.raises(InputError) as raised:
        read_readings(path, Dmu60pAxes(), RUNS)
    message = str(raised.value)
    assert message.replace("\n", "").isprintable()
    assert r"\x1b[2J\x00" in message


ODD: dict[str, Callable[[list[Any]], pl.Series]] = {
    "dates": lambda values: pl.Series(values).cast(pl.Int32).cast(pl.Date),
    "times": lambda values: pl.Series(values).cast(pl.Int64).cast(pl.Datetime),
    "lists": lambda values: pl.Series([[value] for value in values]),
    "structs": lambda values: pl.Series([{"x": value} for value in values]),
    "flags": lambda values: pl.Series([bool(value) for value in values]),
    "bytes": lambda values: pl.Series([str(value).encode() for value in values]),
    "NaN": lambda values: pl.Series([float("nan")] * len(values)),
}


@pytest.mark.parametrize("kind", ODD)
@pytest.mark.parametrize("column", ["X", "run"])
def test_odd_types_of_parquet_are_faults(tmp_path: Path, kind: str, column: str) -> None:
    frame = pl.read_csv(VALID.encode()).with_columns(reading=pl.lit(0.5))
    values = [1, 2, 3, 4] if column == "run" else frame[column].to_list()
    path = tmp_path / "readings.parquet"
    frame.with_columns(ODD[kind](values).alias(column)).write_parquet(path)
    with pytest.raises(InputError) as raised:
        read_readings(path, Dmu60pAxes(), RUNS)
    assert all(f"column {column}" in fault.place for fault in raised.value.faults if fault.place)


def test_decimals_and_categories_are_numbers_and_texts(tmp_path: Path) -> None:
    frame = pl.read_csv(VALID.encode())
    path = tmp_path / "readings.parquet"
    frame.with_columns(pl.col("X").cast(pl.Decimal(20, 3)), pl.col("run").cast(pl.Categorical)).write_parquet(path)
    found = read_readings(path, Dmu60pAxes(), RUNS)
    assert found.positions[0].tolist() == [0.0, 20.0, 0.0, 0.0]


@pytest.mark.parametrize("cut", [1, 100, -1, -8])
def test_truncated_parquet_is_a_fault(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "readings.parquet"
    pl.read_csv(VALID.encode()).write_parquet(path)
    for content in (path.read_bytes()[:cut], VALID.encode()):
        path.write_bytes(content)
        with pytest.raises(InputError, match="is not Parquet, or is damaged"):
            read_readings(path, Dmu60pAxes(), RUNS)


@pytest.mark.parametrize(
    ("old", "new", "fault"),
    [
        ("[167.0, 30.0, -195.0]", "[1e308, 30.0, -195.0]", "line 8, key run[0].target.point: is [1e+308, 30.0,"),
        ("[270.0, 350.0, 0.0]", "[270.0, -2e5, 0.0]", "line 16, key run[1].reference.point: is [270.0, -2000"),
        ("length = 300.0", f"length = 0x{'f' * 10_000}", "line 14, key run[1].length: is a number of thousands"),
        ("X = 0.0,", f"X = 0x{'f' * 10_000},", "line 10, key run[0].home.X: is a number of thousands of digits"),
        ('{ on = "bed" }', f"[{{ {'.'.join('a' * 100_000)} = 1 }}]", "line 9: has a dotted key of too many parts"),
        ('{ on = "bed" }', f"[{'{ a = ' * 60}1{' }' * 60}]", "line 9, key run[0].reference: is [{'a': "),
        ('"X1"', f'"{"X" * 100_000}"', f"line 4, key run[0].id: has 100000 characters; {LONGEST_ID} at most"),
        ('"laser"', f"[{'1,' * 1_000_000}]", "line 5, key run[0].instrument: is [1, 1, 1, 1, 1, 1, ...]"),
    ],
)  # fmt: skip
def test_hostile_values_of_a_setup_are_short_faults(tmp_path: Path, old: str, new: str, fault: str) -> None:
    assert old in CONTRACT
    found = faults_of_setup(tmp_path, CONTRACT.replace(old, new, 1))
    assert any(one.startswith(fault) for one in found), [one[:200] for one in found]
    assert max(map(len, found)) < 1000


def test_thousands_of_runs_take_seconds(tmp_path: Path) -> None:
    """Each run was compared with all before it, and each row with every run."""
    count = 5_000
    run = CONTRACT[CONTRACT.index("[[run]]") : CONTRACT.index('[[run]]\nid = "XY')]
    names = [f"R{number}" for number in range(count)]
    path = tmp_path / "setup.toml"
    path.write_text(
        CONTRACT[: CONTRACT.index("[[run]]")] + "".join(run.replace("X1", name) for name in names) + "odd = 1\n"
    )
    before = time.perf_counter()
    with pytest.raises(InputError) as raised:
        read_setup(path, Dmu60pAxes())
    assert [fault.place for fault in raised.value.faults] == [f"line {2 + 8 * count + 1}, key run[{count - 1}].odd"]
    home = {"X": 0.0, "Y": 0.0, "Z": 0.0}
    runs = [
        Run(
            id=name,
            instrument="laser",
            target=PointOn("tool"),
            reference=PointOn("bed"),
            frame="bed",
            home=home,
            direction=(1.0, 0.0, 0.0),
        )
        for name in names
    ]
    rows = "".join(f"{name},{seq},{20 * seq},0,0,0\n" for name in names for seq in (2, 1, 3))
    table = tmp_path / "readings.csv"
    table.write_text("run,seq,X,Y,Z,reading\n" + rows)
    found = read_readings(table, Dmu60pAxes(), runs)
    assert found.directions[0].tolist() == [1, 1, 1] * count
    table.write_text("run,seq,X,Y,Z,reading\n" + rows.replace("R", "Q"))
    with pytest.raises(InputError) as raised:
        read_readings(table, Dmu60pAxes(), runs)
    assert len(raised.value.faults) == count + 21
    assert time.perf_counter() - before < 30
