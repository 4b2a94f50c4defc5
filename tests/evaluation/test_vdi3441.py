"""The figures of VDI/DGQ 3441: a case worked by hand, its definitions target by target, what they imply."""

import json
import statistics

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.evaluation.iso230_2.builders import made_up
from tests.evaluation.iso230_2.test_evaluation import ROOT2, worked_by_hand
from trueaxis import evaluate
from trueaxis.evaluation.positioning_test import PositioningTest
from trueaxis.evaluation.positioning_test import evaluate as by_iso230_2
from trueaxis.evaluation.vdi3441 import Vdi3441, figures_of
from trueaxis.jobs.evaluated import EvaluatedPositioning


def test_a_case_worked_by_hand() -> None:
    """Means 5.5, 0.5, -6; reversals 1, 3, 12; scatter 3 root 2, 6 root 2, 0: half of both reaches 6 + 1.5 root 2 and
    down to -12.
    """
    found = figures_of(by_iso230_2(worked_by_hand()))
    assert found is not None
    expected = Vdi3441(
        P=18 + 1.5 * ROOT2, Pa=11.5, Ps_max=6 * ROOT2, Ps_mean=3 * ROOT2, U_max=12.0, U_mean=16 / 3
    )  # fmt: skip
    assert found.named() == pytest.approx(expected.named(), rel=1e-9)


@given(m=st.integers(2, 12), n=st.integers(2, 7), seed=st.integers(0, 10**6))
@settings(max_examples=60, deadline=None)
def test_definitions_written_out_target_by_target(m: int, n: int, seed: int) -> None:
    test = made_up(m, n, seed)
    found = figures_of(by_iso230_2(test))
    assert found is not None
    highest, lowest, middle, scatter = [], [], [], []
    for target, positive, negative in zip(test.targets, test.positive, test.negative, strict=True):
        up, down = statistics.fmean(positive) - target, statistics.fmean(negative) - target
        s = (statistics.stdev(map(float, positive)) + statistics.stdev(map(float, negative))) / 2
        middle.append((up + down) / 2)
        scatter.append(6 * s)
        highest.append(max(up, down) + 3 * s)  # the mean and half of the reversal is the farther of both means
        lowest.append(min(up, down) - 3 * s)
    assert pytest.approx(max(highest) - min(lowest), abs=1e-10) == found.P
    assert found.Pa == pytest.approx(max(middle) - min(middle), abs=1e-10)
    assert (found.Ps_max, found.Ps_mean) == pytest.approx((max(scatter), statistics.fmean(scatter)), abs=1e-10)
    assert found.Pa <= found.P


def test_reversal_and_deviation_are_those_of_iso_230_2() -> None:
    iso = by_iso230_2(made_up(8, 5))
    found = figures_of(iso)
    assert found is not None
    assert (found.U_max, found.Pa) == (iso.B, iso.M)
    assert found.U_mean == pytest.approx(-iso.B_mean)  # lost motion all along: every reversal is negative


def evaluated(test: PositioningTest) -> EvaluatedPositioning:
    done = evaluate(test)
    assert isinstance(done, EvaluatedPositioning)
    return done


def test_they_stand_in_the_report_and_in_the_file() -> None:
    done = evaluated(made_up(8, 5))
    assert done.vdi3441 is not None
    assert f"positional uncertainty P     {1e3 * done.vdi3441.P:14.2f}" in str(done)
    assert json.loads(done.to_json())["vdi_dgq_3441"] == done.vdi3441.named()
    targets = np.array([0.0, 90.0])
    up, down = targets[:, None] + [[0.01, 0.02], [0.0, 0.0]], np.tile(targets[:, None], 2)
    rotary = evaluated(PositioningTest(targets, up, down, "deg"))
    (line,) = [one for one in str(rotary).splitlines() if one.startswith("largest reversal error U")]
    assert [float(one) for one in line.split()[-2:]] == pytest.approx([0.015 * 3600, np.radians(0.015) * 1e6], abs=0.01)


def test_one_cycle_has_none() -> None:
    targets = np.linspace(0.0, 2500.0, 6)
    done = evaluated(PositioningTest(targets, targets[:, None] + 0.001, targets[:, None]))
    assert done.vdi3441 is None
    assert "3441" not in str(done)
    assert "vdi_dgq_3441" not in json.loads(done.to_json())
