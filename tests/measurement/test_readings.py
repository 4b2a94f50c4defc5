"""readings.csv: what is written is read, and every fault comes with its line and column."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import numpy as np
import polars as pl
import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from tests.measurement.adapter import Dmu60pAxes
from trueaxis.io.faults import InputError
from trueaxis.measurement.data import read_data
from trueaxis.measurement.readings import Readings, dump_readings
from trueaxis.measurement.readings_reader import read_readings
from trueaxis.measurement.setup import PointOn, Run

HOME = {"X": 0.0, "Y": 0.0, "Z": 0.0}
RUNS = tuple(
    Run(
        id=name,
        instrument="laser",
        target=PointOn("tool"),
        reference=PointOn("bed"),
        frame="bed",
        home=HOME,
        direction=(1.0, 0.0, 0.0),
    )
    for name in ("X1", "b, c")
)

VALID = """run,seq,time_s,X,Y,Z,reading
X1,1,0.5,0,0,0,0.0
X1,2,1.5,20,0,0,1.25e-3
"b, c",1,2.5,0,25.926,0,
"b, c",2,3.5,0,0,0,-0.002
"""


def read_text(tmp_path: Path, text: str | bytes, runs: tuple[Run, ...] | None = RUNS) -> Readings:
    path = tmp_path / "readings.csv"
    path.write_bytes(text.encode() if isinstance(text, str) else text)
    return read_readings(path, Dmu60pAxes(), runs)


def faults_of(tmp_path: Path, text: str | bytes) -> list[str]:
    with pytest.raises(InputError) as caught:
        read_text(tmp_path, text)
    return [f"{fault.place}: {fault.problem}; {fault.remedy}" for fault in caught.value.faults]


def test_a_valid_file_becomes_arrays(tmp_path: Path) -> None:
    found = read_text(tmp_path, VALID)
    assert found.run_ids == ("X1", "b, c")
    assert found.run.tolist() == [0, 0, 1, 1]
    assert found.seq.tolist() == [1, 2, 1, 2]
    assert found.positions.tolist() == [[0.0, 20.0, 0.0, 0.0], [0.0, 0.0, 25.926, 0.0], [0.0, 0.0, 0.0, 0.0]]
    assert found.reading[[0, 1, 3]].tolist() == [0.0, 1.25e-3, -0.002]
    assert found.planned.tolist() == [False, False, True, False]
    assert found.time is not None
    assert found.time.tolist() == [0.5, 1.5, 2.5, 3.5]
    assert found.feed is None
    assert found.directions.tolist() == [[0, 1, 0, 0], [0, 0, 1, -1], [0, 0, 0, 0]]


@pytest.mark.parametrize(
    "change",
    [
        lambda text: text.replace("\n", "\r\n"),
        lambda text: "\ufeff" + text,
        lambda text: text.replace("X1,2", "\nX1,2").rstrip("\n"),
        lambda text: text.replace(",", " ,\t").replace('"b ,\t c" ', '"b, c"'),
        lambda text: text.replace("X1", '"X1"').replace("run,seq", '"run","seq"'),
    ],
    ids=["crlf", "byte order mark", "blank line", "spaces", "quotes"],
)
def test_layout_changes_nothing(tmp_path: Path, change: Callable[[str], str]) -> None:
    plain, changed = read_text(tmp_path, VALID), read_text(tmp_path, change(VALID))
    assert np.array_equal(plain.reading, changed.reading, equal_nan=True)
    assert np.array_equal(plain.positions, changed.positions)
    assert plain.run.tolist() == changed.run.tolist()


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("X1,2", "X9,2", 'line 3, column run: the setup has no run "X9"; runs X1, b, c'),
        ("X1,2", ",2", "line 3, column run: is empty"),
        ("X1,2", "X1,1", 'line 3, column seq: "1" is given already in this run'),
        ("X1,2", "X1,1.5", 'line 3, column seq: "1.5" is not a whole number'),
        ("X1,2", "X1,", "line 3, column seq: is empty; a number"),
        ("1.25e-3", "1.25e-3mm", 'line 3, column reading: "1.25e-3mm" is not a number'),
        ("1.25e-3", "nan", 'line 3, column reading: "nan" is not a finite number'),
        ("1.25e-3", "-inf", 'line 3, column reading: "-inf" is not a finite number'),
        ("1.25e-3", "1250", 'line 3, column reading: "1250" is too large; readings are deviations in mm'),
        (",20,", ",-0.001,", 'line 3, column X: "-0.001" is outside the travel; from 0.0 to 540.0'),
        (",20,", ",540.001,", 'line 3, column X: "540.001" is outside the travel; from 0.0 to 540.0'),
        (",20,", ",,", "line 3, column X: is empty"),
        ("1.5,20", "1.5,20,3", "line 3: has 8 cells; 7 as in the header"),
        ("1.5,20,", "1.5,", "line 3: has 6 cells; 7 as in the header"),
        ("X1,2", '"X1,2', "line 3: a quote is not closed"),
        ("X1,2", 'X"1",2', "line 3: a quote stands inside a cell"),
        (",Z,", ",A,", "column Z: is missing; machine dmu60p has axis Z: give its position"),
        (",Z,", ",A,", "column A: machine dmu60p has no axis A; axes X Y Z"),
        ("time_s", "dir_C", "column dir_C: machine dmu60p has no axis C"),
        ("time_s", "dir_X", 'line 2, column dir_X: "0.5" is not a direction; +1, -1 or 0'),
        ("time_s", "tme_s", "column tme_s: is not a known column; did you mean time_s?"),
        ("time_s", "X", "line 1: column X is given more than once"),
        ("time_s", "", "line 1: a column has no name"),
        (",reading", ",value", "column reading: is missing"),
    ],
)
def test_each_fault_has_its_line_and_remedy(tmp_path: Path, old: str, new: str, expected: str) -> None:
    assert old in VALID
    found = faults_of(tmp_path, VALID.replace(old, new, 1))
    assert any(fault.startswith(expected) for fault in found), found


def test_a_run_of_the_setup_without_rows_is_a_fault(tmp_path: Path) -> None:
    text = "\n".join(VALID.splitlines()[:3])
    assert faults_of(tmp_path, text)[0].startswith('column run: there is no row of run "b, c"')


def test_lines_are_counted_as_an_editor_does(tmp_path: Path) -> None:
    text = VALID.replace("X1,2,1.5,20", "\n\nX1,2,1.5,600")
    assert faults_of(tmp_path, text)[0].startswith("line 5, column X")


def test_a_table_of_another_separator_is_told_apart(tmp_path: Path) -> None:
    assert "columns are not separated by commas" in faults_of(tmp_path, VALID.replace(",", ";"))[0]


def test_no_rows_and_no_text(tmp_path: Path) -> None:
    assert ": has no rows" in faults_of(tmp_path, VALID.splitlines()[0])[0]
    assert faults_of(tmp_path, "\n\n")[0].startswith(": is empty")


def test_faults_of_all_columns_come_at_once(tmp_path: Path) -> None:
    text = VALID.replace("X1,2,1.5,20", "X9,2.5,x,999")
    assert [fault.split(":")[0] for fault in faults_of(tmp_path, text)] == [
        f"line 3, column {name}" for name in ("X", "run", "seq", "time_s")
    ]


def test_positions_of_another_machine_are_one_fault_of_each_axis(tmp_path: Path) -> None:
    rows = "\n".join(f"X1,{n},{600 + n},{-n},0,0" for n in range(100))
    assert [one for one in faults_of(tmp_path, f"run,seq,X,Y,Z,reading\n{rows}\n") if "travel" in one] == [
        'line 2, column X: "600" is outside the travel, and so in 99 more, from 600 to 699; from 0.0 to 540.0',
        'line 3, column Y: "-1" is outside the travel, and so in 98 more, from -99 to -1; from 0.0 to 700.0',
    ]


def test_a_wrong_column_does_not_fill_the_screen(tmp_path: Path) -> None:
    rows = "\n".join(f"X1,{n},0,0,0,oops{n}" for n in range(1000))
    found = faults_of(tmp_path, f"run,seq,X,Y,Z,reading\n{rows}\n")
    assert len([fault for fault in found if "oops" in fault]) == 20
    assert "column reading: and so 980 more cells; " in found


def test_one_wrong_word_in_many_rows_is_one_fault(tmp_path: Path) -> None:
    rows = "\n".join(f"X1,{n},0,0,0,{'none' if n % 2 else 0.001}" for n in range(100))
    (found,) = [fault for fault in faults_of(tmp_path, f"run,seq,X,Y,Z,reading\n{rows}\n") if "none" in fault]
    assert 'line 3, column reading: "none" is not a number, and so in 49 more: line 5, line 7,' in found


def test_a_direction_that_is_given_wins_and_an_empty_one_is_derived(tmp_path: Path) -> None:
    text = VALID.replace("time_s", "dir_X").replace("X1,1,0.5", "X1,1,-1").replace("X1,2,1.5", "X1,2,")
    found = read_text(tmp_path, text.replace("1,2.5", "1,0").replace("2,3.5", "2,+1"))
    assert found.directions[0].tolist() == [-1, 1, 0, 1]


def test_directions_follow_seq_not_the_order_of_lines_and_are_kept_while_an_axis_stands(tmp_path: Path) -> None:
    rows = [
        ("X1", 3, 10.0, 5.0),
        ("X1", 1, 0.0, 5.0),
        ("X1", 2, 20.0, 5.0),
        ("X1", 4, 10.0, 0.0),
        ("b, c", 1, 0.0, 0.0),
    ]
    text = "run,seq,X,Y,Z,reading\n" + "\n".join(f'"{r}",{s},{x},{y},0,' for r, s, x, y in rows)
    found = read_text(tmp_path, text)
    assert found.directions[0].tolist() == [-1, 0, 1, -1, 0]
    assert found.directions[1].tolist() == [1, 1, 1, -1, 0]  # row 1 came to Y 5 from home


def test_a_ball_bar_run_starts_where_it_is_first_read(tmp_path: Path) -> None:
    bar = Run(
        id="bar",
        instrument="ballbar",
        target=PointOn("tool"),
        reference=PointOn("workpiece"),
        frame="bed",
        home=HOME,
        direction=None,
        length=300.0,
    )
    text = "run,seq,X,Y,Z,reading\nbar,1,300,5,0,\nbar,2,290,5,0,\n"
    assert read_text(tmp_path, text, (bar,)).directions.tolist() == [[0, -1], [0, 0], [0, 0]]


def test_rows_of_unknown_runs_are_not_taken_for_repeated_ones(tmp_path: Path) -> None:
    found = faults_of(tmp_path, VALID + "P,1,0,0,0,0,0\nQ,1,0,0,0,0,0\n")
    assert [fault.split(";")[0] for fault in found] == [
        'line 6, column run: the setup has no run "P"',
        'line 7, column run: the setup has no run "Q"',
    ]


READING = st.floats(-100.0, 100.0) | st.just(np.nan)
ROW = st.tuples(st.floats(0.0, 540.0), st.floats(0.0, 700.0), st.floats(0.0, 600.0), READING)


@given(rows=st.lists(ROW, min_size=2, max_size=20), suffix=st.sampled_from([".csv", ".parquet"]), extra=st.booleans())
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_what_is_written_reads_back_bit_for_bit(
    tmp_path: Path, rows: list[tuple[float, float, float, float]], suffix: str, extra: bool
) -> None:
    columns = np.array(rows).T
    count = len(rows)
    written = Readings(
        axes=("X", "Y", "Z"),
        run_ids=("X1", "b, c"),
        run=np.arange(count) % 2,
        seq=np.arange(count) - 1,
        positions=columns[:3],
        directions=np.ones((3, count), dtype=np.int8),
        reading=columns[3],
        given_directions=("X", "Y", "Z"),
        time=np.arange(count) / 3 if extra else None,
        temperature=np.where(np.arange(count) % 2, np.nan, 20.1) if extra else None,
    )
    path = tmp_path / f"readings{suffix}"
    path.write_bytes(dump_readings(written, RUNS, suffix))
    found = read_readings(path, Dmu60pAxes(), RUNS)
    for name in ("run", "seq", "positions", "directions", "reading", "time", "feed", "temperature"):
        mine, theirs = getattr(written, name), getattr(found, name)
        assert (mine is None) == (theirs is None)
        assert mine is None or np.array_equal(mine, theirs, equal_nan=mine.dtype.kind == "f")
    assert found.run_ids == written.run_ids


def test_parquet_faults_name_rows_and_types(tmp_path: Path) -> None:
    path = tmp_path / "readings.parquet"
    frame = pl.DataFrame(
        {
            "run": ["X1", "b, c"],
            "seq": [1, 1],
            "X": [0.0, 900.0],
            "Y": [[1.0], [2.0]],
            "Z": ["0", "z"],
            "reading": [None] * 2,
        }
    )
    frame.write_parquet(path)
    with pytest.raises(InputError) as caught:
        read_readings(path, Dmu60pAxes(), RUNS)
    assert [f"{fault.place}: {fault.problem}" for fault in caught.value.faults] == [
        "row 2, column X: 900.0 is outside the travel",
        "column Y: holds List(Float64)",
        'row 2, column Z: "z" is not a number',
    ]


def test_a_million_rows_are_read(tmp_path: Path) -> None:
    count = 1_000_000
    path = tmp_path / "readings.csv"
    frame = pl.DataFrame(
        {
            "run": ["X1"] * (count - 1) + ["b, c"],
            "seq": np.arange(count),
            "X": np.linspace(0.0, 540.0, count),
            "Y": np.linspace(0.0, 700.0, count),
            "Z": np.zeros(count),
            "reading": np.sin(np.arange(count)),
        }
    )
    frame.write_csv(path)
    found = read_readings(path, Dmu60pAxes(), RUNS)
    assert np.array_equal(found.reading, frame["reading"].to_numpy())


def test_a_folder_gives_the_faults_of_both_files(tmp_path: Path) -> None:
    (tmp_path / "setup.toml").write_text("schema = 2\n")
    (tmp_path / "readings.csv").write_text(VALID.replace(",20,", ",999,"))
    with pytest.raises(InputError) as caught:
        read_data(tmp_path, Dmu60pAxes())
    assert {Path(fault.file).name for fault in caught.value.faults} == {"setup.toml", "readings.csv"}


def test_a_folder_with_two_readings_files_is_refused(tmp_path: Path) -> None:
    (tmp_path / "readings.csv").touch()
    (tmp_path / "readings.parquet").touch()
    with pytest.raises(InputError, match=r"has both readings\.csv and readings\.parquet"):
        read_data(tmp_path, Dmu60pAxes())


def check(found: Readings) -> None:
    assert np.isfinite(found.positions).all()
    assert (found.positions >= 0.0).all()
    assert (found.positions[0] <= 540.0).all()
    assert not np.isinf(found.reading).any()
    assert set(found.run.tolist()) == {0, 1}


@given(at=st.integers(0, len(VALID)), cut=st.integers(0, 12), piece=st.binary(max_size=6))
@settings(max_examples=500, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_damaged_bytes_read_or_are_refused_clearly(tmp_path: Path, at: int, cut: int, piece: bytes) -> None:
    raw = VALID.encode()
    with suppress(InputError):
        check(read_text(tmp_path, raw[:at] + piece + raw[at + cut :]))


@given(text=st.text(alphabet='X1bc",;\n\r\t 0.-+eE#nainf', max_size=120))
@settings(max_examples=500, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_cells_read_or_are_refused_clearly(tmp_path: Path, text: str) -> None:
    with suppress(InputError):
        check(read_text(tmp_path, f"run,seq,X,Y,Z,reading\n{text}"))


@given(at=st.integers(0, 4000), piece=st.binary(min_size=1, max_size=4))
@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@example(at=-250, piece=b"\xff\xff\xff\xff")  # within the footer
def test_damaged_parquet_reads_or_is_refused_clearly(tmp_path: Path, at: int, piece: bytes) -> None:
    raw = dump_readings(read_text(tmp_path, VALID), RUNS, ".parquet")
    path = tmp_path / "damaged.parquet"
    at %= len(raw)
    path.write_bytes(raw[:at] + piece + raw[at + len(piece) :])
    with suppress(InputError):
        read_readings(path, Dmu60pAxes(), RUNS)


@pytest.mark.parametrize("kind", [pl.Categorical, pl.Enum(["X1", "b, c"])])
def test_parquet_ids_may_be_categories(tmp_path: Path, kind: pl.DataType) -> None:
    path = tmp_path / "readings.parquet"
    frame = pl.read_csv(VALID.encode()).with_columns(pl.col("run").cast(kind))
    frame.write_parquet(path)
    assert read_readings(path, Dmu60pAxes(), RUNS).run.tolist() == [0, 0, 1, 1]


def test_parquet_ids_that_are_no_texts_are_a_fault(tmp_path: Path) -> None:
    path = tmp_path / "readings.parquet"
    pl.read_csv(VALID.encode()).with_columns(run=pl.lit(1.5)).write_parquet(path)
    with pytest.raises(InputError, match="column run: holds Float64; texts"):
        read_readings(path, Dmu60pAxes(), RUNS)
