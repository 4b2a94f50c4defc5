"""Every value of a report that others published of a real test, to its printed digits.

The report differs from the standard in three things, each asserted here: it calls forward what the readings call
backward; its R leaves the reversal out; its E is no range (it subtracts the higher of the two lowest means).
"""

import re
from pathlib import Path

import numpy as np
import numpy.typing as npt
import pytest

from trueaxis.evaluation.positioning_table_file import read_positioning_test
from trueaxis.evaluation.positioning_test import Evaluation, PositioningTest, evaluate

FOLDER = Path(__file__).parents[4] / "shared" / "data" / "ess_iso230_2"
DIGITS = 5

pytestmark = pytest.mark.skipif(
    not (FOLDER / "axis_x.dat").is_file(), reason="the measured data of others are not here (shared/data/ess_iso230_2)"
)


@pytest.fixture(scope="module")
def readings() -> PositioningTest:
    return read_positioning_test(FOLDER / "axis_x.dat")


@pytest.fixture(scope="module")
def report() -> str:
    text = (FOLDER / "axis_x_report.md").read_text(encoding="utf-8")
    start = text.index("# ISO 230-2 motion test")
    return text[start : text.index("# Limit Switch Performance")]


@pytest.fixture(scope="module")
def as_reported(readings: PositioningTest) -> Evaluation:
    return evaluate(readings.swapped(), "unidirectional")


def table(report: str, heading: str) -> list[list[float]]:
    """The columns behind i of the first table below a heading."""
    below = report[report.index(heading) :]
    rows = re.findall(r"^\d+\|.*\|$", below[: below.index("\n#", 1)], flags=re.MULTILINE)
    return [list(column) for column in zip(*([float(c) for c in row.split("|")[1:-1]] for row in rows), strict=True)]


def printed(report: str, name: str) -> float:
    found = re.findall(rf"^\**{name} = (-?[0-9.]+) \[mm\]\**\s*$", report, flags=re.MULTILINE)
    assert len(found) == 1
    return float(found[0])


def as_printed(values: npt.ArrayLike) -> list[float]:
    return [round(float(value), DIGITS) for value in np.atleast_1d(np.asarray(values))]


def test_the_report_calls_forward_what_the_readings_call_backward(report: str, readings: PositioningTest) -> None:
    """The logger numbers the points of a stroke in the order in which it passes them: 1... upwards, 2... downwards."""
    forward, backward = (table(report, f"### Data {side} direction") for side in ("forward", "backward"))
    assert [as_printed(column) for column in readings.negative.T] == forward[1:]
    assert [as_printed(column) for column in readings.positive.T] == backward[1:]
    assert as_printed(readings.targets) == forward[0] == backward[0]


def test_mean_deviations_and_reversal_values(report: str, as_reported: Evaluation) -> None:
    forward = table(report, "#### Positioning deviation forward direction")
    backward = table(report, "#### Positioning deviation backward direction")
    both = table(report, "#### Positioning deviation bi-directional")
    assert as_printed(as_reported.positive.mean) == forward[-1]
    assert as_printed(as_reported.negative.mean) == backward[-1]
    assert [as_printed(as_reported.mean), as_printed(as_reported.b)] == both
    assert as_printed(as_reported.B_mean) == [printed(report, "B_avg")]
    assert as_printed(as_reported.B) == [printed(report, "B")]


def test_estimators_and_repeatability(report: str, as_reported: Evaluation) -> None:
    positive, negative = as_reported.positive, as_reported.negative
    found = [as_printed(v) for v in (positive.s, negative.s, positive.r, negative.r, as_reported.r)]
    assert found == table(report, "### Repeatability")
    assert as_printed([positive.R, negative.R]) == [printed(report, "R_fwd"), printed(report, "R_bwd")]
    assert as_printed(as_reported.R) == [printed(report, "R")]


def test_systematic_deviation_mean_deviation_and_accuracy(report: str, as_reported: Evaluation) -> None:
    positive, negative = as_reported.positive, as_reported.negative
    assert as_printed([positive.E, negative.E]) == [printed(report, "E_fwd"), printed(report, "E_bwd")]
    assert as_printed([positive.A, negative.A]) == [printed(report, "A_fwd"), printed(report, "A_bwd")]
    assert as_printed(as_reported.M) == [printed(report, "M")]
    assert as_printed(as_reported.A) == [printed(report, "A")]
    means = np.array([positive.mean, negative.mean])
    assert as_printed(means.max() - means.min(axis=1).max()) == [printed(report, "E")]


def test_the_standards_r_and_e_follow_from_the_report_s_own_tables(report: str, readings: PositioningTest) -> None:
    standard = evaluate(readings)
    assert as_printed(standard.R) == [max(table(report, "### Repeatability")[-1])]
    means = [
        mean
        for side in ("forward", "backward")
        for mean in table(report, f"#### Positioning deviation {side} direction")[-1]
    ]
    assert abs(standard.E - (max(means) - min(means))) <= 1e-5
    assert printed(report, "R") < 0.6 * standard.R
    assert printed(report, "E") < 0.8 * standard.E
