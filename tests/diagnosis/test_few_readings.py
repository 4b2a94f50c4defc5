"""A run or less: nothing breaks down, and where nothing can be known nothing is said to be there."""

from dataclasses import fields, replace
from typing import Any

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_model import expected_readings

CASE = Case(
    seed=3, design=Design(lines=1, repeats=1, targets=41, samples=160), effects=(Hidden("cyclic", "EXX", size=2e-3),)
)


def first_of(given: Prepared, run: str, count: int) -> MeasuredData:
    """The first readings of one run, and nothing else."""
    readings = given.data.readings
    index = readings.run_ids.index(run)
    mine = np.flatnonzero(readings.run == index)
    keep = mine[np.argsort(readings.seq[mine])][:count]
    cut: dict[str, Any] = {
        one.name: value[..., keep]
        for one in fields(readings)
        if isinstance(value := getattr(readings, one.name), np.ndarray)
    }
    runs = tuple(each for each in given.data.setup.runs if each.id == run)
    cut["run"] = np.zeros(keep.size, dtype=np.int64)
    return MeasuredData(replace(given.data.setup, runs=runs), replace(readings, run_ids=(run,), **cut))


def found(run: str, count: int) -> Diagnosis:
    given = prepared(CASE)
    return diagnose(given.model, first_of(given, run, count))


@pytest.mark.parametrize("count", [1, 2, 3, 8])
@pytest.mark.parametrize("run", ["X1", "XY-F1000-ccw"])
def test_of_readings_whose_noise_nobody_knows_nothing_is_said(run: str, count: int) -> None:
    one = found(run, count)
    assert one.verdict == "no_discrepancy"
    assert one.causes == ()
    (noise,) = one.noise  # the base and what is unknown of the run take all of them
    assert noise.origin == ("expected" if count == 8 else "unknown")
    assert 1.0 < noise.freedom < count if count == 8 else noise.freedom == 1.0


def test_one_circle_without_repeats_may_show_a_period_as_its_course_tells_the_noise() -> None:
    one = found("XY-F1000-ccw", 160)
    assert [cause.effect.label for cause in one.causes] == ["cyclic EXX"]
    assert one.noise[0].origin == "courses"


def test_one_line_names_nothing_that_is_not_there() -> None:
    assert {cause.effect.label for cause in found("X1", 82).causes} <= {"cyclic EXX"}


@pytest.mark.parametrize("kind", ["white", "correlated"])
def test_the_noise_of_circles_that_nothing_repeats_is_not_taken_for_larger_than_it_is(kind: str) -> None:
    """Slow noise beyond the bends of a course cannot be told from the course: the slowest that the likelihood allows
    was twice the noise that is there.
    """
    given = prepared(Case(seed=7, design=Design(lines=1, repeats=1), noise=kind, given="exact"))
    rows = given.rows
    values = rows.reading - expected_readings(given.model, rows.runs, rows.run, rows.positions, rows.context)
    (bar,) = [one for one in null_of(given.model, rows, values, None).noise if one.instrument == "ballbar"]
    assert bar.origin == "courses"
    assert bar.sigma == pytest.approx(SIGMA, rel=0.15)
