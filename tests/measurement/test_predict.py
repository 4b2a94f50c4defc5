"""predict: the exact deviation at given points, behind the columns that were given."""

import json
from contextlib import suppress
from pathlib import Path

import numpy as np
import polars as pl
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.generator.dmu60p import TRAVEL, cubic_errors, dmu60p
from tests.measurement.adapter import Dmu60pAxes
from tests.measurement.command_line import errors_tree, run
from trueaxis.cli import predict as command
from trueaxis.io.faults import InputError
from trueaxis.measurement.points import PRIOR_COLUMNS, UNCERTAINTY_COLUMNS, check_predicted, read_points


@pytest.fixture
def errors(tmp_path: Path) -> Path:
    path = tmp_path / "errors.json"
    path.write_text(json.dumps(errors_tree()))
    return path


def table(count: int, tool: str) -> pl.DataFrame:
    source = np.random.default_rng(5)
    frame = pl.DataFrame({axis: source.uniform(*TRAVEL[axis], count) for axis in "ZXY"})
    if tool == "none":
        return frame
    point = source.uniform(-100.0, 100.0, (3, count))
    if tool == "constant":
        point[:] = point[:, :1]
    return frame.with_columns(tool_z=pl.Series(point[2]), tool_x=pl.Series(point[0]), tool_y=pl.Series(point[1]))


@pytest.mark.parametrize("tool", ["none", "constant", "varying"])
@pytest.mark.parametrize("suffix", ["csv", "parquet"])
def test_deviations_are_those_of_the_independent_exact_machine(
    tmp_path: Path, errors: Path, tool: str, suffix: str
) -> None:
    frame = table(40, tool)
    at, out = tmp_path / f"points.{suffix}", tmp_path / f"out.{suffix}"
    (frame.write_csv if suffix == "csv" else frame.write_parquet)(at)
    assert run(command, "--errors", errors, "--at", at, "--out", out) == 0
    found = pl.read_csv(out) if suffix == "csv" else pl.read_parquet(out)
    assert found.columns == [*frame.columns, "dx", "dy", "dz", *UNCERTAINTY_COLUMNS, *PRIOR_COLUMNS]
    assert found.select(frame.columns).equals(frame)
    unknown = found.select(*UNCERTAINTY_COLUMNS, *PRIOR_COLUMNS).null_count().row(0)
    assert unknown == (40,) * 6  # these error values have none
    machine = dmu60p(cubic_errors())
    for row in found.iter_rows(named=True):
        point = [row.get(f"tool_{axis}", 0.0) for axis in "xyz"]
        exact = machine.deviation("tool", "workpiece", {axis: row[axis] for axis in "XYZ"}, point)
        assert np.abs(np.array([row["dx"], row["dy"], row["dz"]]) - exact.astype(float)).max() < 1e-12


def test_a_curve_given_as_a_table_is_followed_through_its_points(tmp_path: Path, errors: Path) -> None:
    tree = {"schema": 1, "machine": "dmu60p"}
    curve = {"basis": "table", "positions": [0, 100, 540], "values": [0.0, 0.01, 0.0]}
    errors.write_text(json.dumps({**tree, "motion_errors": {"EZX": curve}}))
    at, out = tmp_path / "points.csv", tmp_path / "out.csv"
    at.write_text("X,Y,Z\n0,0,0\n50,0,0\n100,700,0\n320,0,600\n")
    assert run(command, "--errors", errors, "--at", at, "--out", out) == 0
    assert pl.read_csv(out)["dz"].to_list() == pytest.approx([0.0, 0.005, 0.01, 0.005], abs=1e-15)


@pytest.mark.parametrize("value", [1e300, -1e308, 1e3])
def test_error_values_that_cannot_be_are_not_used(tmp_path: Path, value: float) -> None:
    tree = {"schema": 1, "machine": "dmu60p", "parameters": {"eps_xy": value}}
    curve = {"basis": "polynomial", "powers": [3], "coefficients": [value]}
    errors, at, out = tmp_path / "e.json", tmp_path / "points.csv", tmp_path / "out.csv"
    errors.write_text(json.dumps(tree | {"motion_errors": {"EXX": curve}}))
    at.write_text("X,Y,Z\n0,0,0\n100,10,0\n")
    with pytest.raises(InputError) as raised:
        run(command, "--errors", errors, "--at", at, "--out", out)
    assert sorted(fault.place for fault in raised.value.faults) == ["motion_errors.EXX", "parameters.eps_xy"]
    assert not out.exists()


def test_deviations_that_cannot_be_are_not_written() -> None:
    """Effects whose parameters have no size to expect may still make the tool deviate without bounds."""
    deviation = np.array([[0.0, 20.0, np.nan], [0.0, 0.0, 0.0], [0.0, 0.0, np.inf]])
    with pytest.raises(InputError, match=r"e\.json: at 2 of 3 points the tool would deviate too far: 20 mm in row 2"):
        check_predicted(deviation, np.full(3, 0.1), "e.json")
    check_predicted(deviation[:, :1], np.full(1, 0.1), "e.json")


def test_no_points_give_no_rows(tmp_path: Path, errors: Path) -> None:
    at, out = tmp_path / "points.csv", tmp_path / "out.csv"
    at.write_text("X,Y,Z\n")
    assert run(command, "--errors", errors, "--at", at, "--out", out) == 0
    assert out.read_text() == "X,Y,Z,dx,dy,dz,u_dx,u_dy,u_dz,u_prior_dx,u_prior_dy,u_prior_dz\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("X,Y\n1,2\n", "column Z: is missing"),
        ("X,Y,Z,A\n1,2,3,4\n", "column A: machine dmu60p has no axis A"),
        ("X,Y,Z,tool_X\n1,2,3,4\n", "column tool_X: is not a known column"),
        ("X,Y,Z,dx\n1,2,3,4\n", "column dx: is not a known column"),
        ("X,Y,Z\n1,2,3\n1,2,601\n", 'line 3, column Z: "601" is outside the travel'),
        ("X,Y,Z\n1,,3\n", "line 2, column Y: is empty"),
        ("X,Y,Z,tool_x\n1,2,3,\n", "line 2, column tool_x: is empty"),
    ],
)
def test_what_is_wrong_with_points_is_said_and_nothing_written(
    tmp_path: Path, errors: Path, text: str, expected: str
) -> None:
    at, out = tmp_path / "points.csv", tmp_path / "out.csv"
    at.write_text(text)
    with pytest.raises(InputError) as caught:
        run(command, "--errors", errors, "--at", at, "--out", out)
    assert [f"{fault.place}: {fault.problem}"[: len(expected)] for fault in caught.value.faults] == [expected]
    assert not out.exists()


@given(text=st.text(alphabet='XYZtool_,;"\n\r 0123.-+eEnaif', max_size=100))
@settings(max_examples=300, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_cells_read_or_are_refused_clearly(tmp_path: Path, text: str) -> None:
    path = tmp_path / "points.csv"
    path.write_text(f"X,Y,Z,tool_x\n1,2,3,4\n{text}", newline="")
    with suppress(InputError):
        assert np.isfinite(read_points(path, Dmu60pAxes()).positions).all()
