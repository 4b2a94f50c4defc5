"""Tables: what is accepted is what Python's own CSV reader sees, line by line."""

import csv
import io
from contextlib import suppress
from pathlib import Path

import polars as pl
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from trueaxis.io.faults import InputError
from trueaxis.measurement.table import read_table, table_bytes

CELLS = st.text(alphabet="ab ,\"';0.1é\t", max_size=5)
SETTINGS = settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@given(rows=st.lists(st.tuples(CELLS, CELLS, CELLS), min_size=1, max_size=6), quoting=st.sampled_from([0, 1]))
@SETTINGS
def test_cells_are_those_that_were_written(tmp_path: Path, rows: list[tuple[str, str, str]], quoting: int) -> None:
    text = io.StringIO()
    csv.writer(text, quoting=quoting).writerows([("one", "two", "three"), *rows])  # type: ignore[arg-type]
    path = tmp_path / "table.csv"
    path.write_text(text.getvalue(), newline="", encoding="utf-8")
    found = read_table(path)
    assert [tuple(cell or "" for cell in row) for row in found.frame.rows()] == rows
    assert found.lines is not None
    assert found.lines.tolist() == list(range(2, len(rows) + 2))


@given(text=st.text(alphabet='ab,"\n \t1', max_size=40))
@SETTINGS
def test_whatever_is_accepted_reads_as_python_reads_it(tmp_path: Path, text: str) -> None:
    path = tmp_path / "table.csv"
    path.write_text(f"one,two\n{text}", newline="")
    with suppress(InputError):
        found = read_table(path)
        plain = [row for row in csv.reader(io.StringIO(text), strict=True) if "".join(row).strip() or len(row) > 1]
        assert [[cell or "" for cell in row] for row in found.frame.rows()] == plain


@pytest.mark.parametrize(
    ("text", "places"),
    [
        ('a,b\n"1,2\n3",4\n', ["line 2", "line 3"]),
        ("a,b\n\n1,2,3\n4\n", ["line 3", "line 4"]),
        ('a,b\n1,"2"x\n', ["line 2"]),
        ("\na,a\n1,2\n", ["line 2"]),
    ],
)
def test_faults_name_the_line_in_the_file(tmp_path: Path, text: str, places: list[str]) -> None:
    path = tmp_path / "table.csv"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_table(path)
    assert [fault.place for fault in caught.value.faults] == places


def test_many_short_lines_are_counted_not_listed(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("a,b\n" + "1\n" * 100)
    with pytest.raises(InputError) as caught:
        read_table(path)
    assert len(caught.value.faults) == 21
    assert caught.value.faults[-1].problem == "and so 80 more lines"


@pytest.mark.parametrize("at", [45, 285])
def test_a_parquet_file_that_makes_its_parser_abort_is_a_fault(tmp_path: Path, at: int) -> None:
    """With one bit width changed, Polars asks for 2^61 bytes and ends the process."""
    path = tmp_path / "table.parquet"
    frame = pl.DataFrame(
        {"run": ["X1", "X1", "b"], "seq": [1, 2, 3], "X": [0.0, 1.0, 2.0], "reading": [0.1, None, 0.3]}
    )
    raw = table_bytes(frame, ".parquet")
    path.write_bytes(raw[:at] + b"\x0d" + raw[at + 1 :])
    with pytest.raises(InputError, match="is not Parquet, or is damaged"):
        read_table(path)


def test_what_is_no_parquet_says_so(tmp_path: Path) -> None:
    path = tmp_path / "table.parquet"
    path.write_text("a,b\n1,2\n")
    with pytest.raises(InputError, match="is not Parquet"):
        read_table(path)


def test_numbers_are_written_with_the_digits_that_read_back() -> None:
    values = [0.1, 1 / 3, 5e-324, 1.7976931348623157e308, -0.0, 1e-7, 20.0]
    text = table_bytes(pl.DataFrame({"v": values}), ".csv").decode().splitlines()[1:]
    assert [float(cell) for cell in text] == values
    assert max(map(len, text)) <= 24
