"""What a diagnosis says of a real positioning test: the figures of docs/real-data.md."""

import numpy as np
import pytest

from tests.real_data.linear_axis import BOWED, TURNING, command, diagnosis, gained
from tests.real_data.linear_axis_data import FILE, readings
from trueaxis.diagnose.result import Diagnosis
from trueaxis.iso230_2.evaluation import evaluate
from trueaxis.iso230_2.read import read_positioning_test

pytestmark = pytest.mark.skipif(not FILE.exists(), reason="../shared/data/ess_iso230_2 is not here")


def named(found: Diagnosis) -> list[str]:
    return [one.effect.label for one in found.causes]


def evidence(found: Diagnosis, label: str) -> float:
    return next(one.evidence for one in found.scan if one.effect.label == label)


def test_readings_are_in_the_order_of_the_standard() -> None:
    test = read_positioning_test(FILE)
    table = readings(test)
    assert table.height == 90
    assert table["X"].to_list()[:19] == [*range(-20, 21, 5), *range(20, -21, -5), -20]
    assert table["dir_X"].to_list()[:19] == [1] * 9 + [-1] * 9 + [1]
    assert table["reading"][18] == test.positive[0, 1] - test.targets[0]
    assert table["reading"][17] == test.negative[0, 0] - test.targets[0]


@pytest.mark.parametrize("swapped", [False, True])
def test_lost_motion_is_by_far_the_best_but_no_name_is_given(swapped: bool) -> None:
    """A constant explains nine tenths of what there is: less than what a name beside a remainder must."""
    found = diagnosis(swapped=swapped)
    assert found.verdict == "unexplained_structure"
    assert named(found) == []
    assert evidence(found, "backlash EXX") > 10.0 * found.threshold
    assert any(one.fired and one.name == "lines of X, between directions" for one in found.checks)
    rms, held = found.gain.rms, found.gain.held_out
    assert 1e3 * np.array([rms.given, rms.refitted]) == pytest.approx([33.0, 13.3], abs=0.05)
    assert 1e3 * np.array([held.given, held.refitted]) == pytest.approx([33.3, 13.3], abs=0.05)
    assert 1e3 * found.gain.floor == pytest.approx(3.13, abs=0.02)
    assert "2 passes" in found.gain.split


def test_lost_motion_with_a_swing_is_named_and_predicts_the_last_two_cycles() -> None:
    found = diagnosis(kinds=TURNING)
    assert found.verdict == "explained"
    assert named(found) == ["backlash EXX", "turning_play EXX"]
    lost, turning = found.causes
    assert 1e3 * lost.parameters[0].value == pytest.approx(-26.5, abs=1.0)
    amplitude = np.hypot(turning.parameters[0].value, turning.parameters[1].value)
    assert 1e3 * amplitude == pytest.approx(3.6, abs=0.25)
    assert turning.parameters[2].value == pytest.approx(11.8, abs=0.2)
    assert (lost.held_out_gain, turning.held_out_gain) == pytest.approx((0.63, 0.06), abs=0.02)
    assert 1e3 * found.gain.held_out.extended == pytest.approx(4.9, abs=0.1)


def test_swapped_labels_turn_the_width_round() -> None:
    found = diagnosis(kinds=TURNING, swapped=True)
    assert named(found) == ["backlash EXX", "turning_play EXX"]
    assert 1e3 * found.causes[0].parameters[0].value == pytest.approx(25.8, abs=1.0)


def test_without_times_nothing_of_time_is_said() -> None:
    found = diagnosis(clock=False)
    unseen = {one.effect.kind for one in found.limits if "time_s" in one.reason}
    assert {"drift", "warm_up", "laser_step"} <= unseen
    assert evidence(found, "backlash EXX") == pytest.approx(evidence(diagnosis(), "backlash EXX"), rel=0.02)


def test_a_drift_of_the_middle_is_not_named() -> None:
    assert named(diagnosis(kinds=BOWED)) == []


def test_mean_reversal_value_is_that_of_the_standard() -> None:
    standard = 1e3 * evaluate(read_positioning_test(FILE)).B_mean
    assert gained(("backlash",)).value == pytest.approx(standard, rel=1e-9)
    assert standard == pytest.approx(-25.37, abs=0.005)


@pytest.mark.parametrize(
    ("terms", "inside", "ahead"),
    [
        ((), 13.27, 13.27),
        (("backlash",), 3.89, 5.18),
        (("backlash", "backlash_slope"), 3.86, 5.19),
        (("backlash", "drift"), 3.36, 4.06),
        (("backlash", "bowed drift"), 3.07, 3.50),
        (("backlash by target",), 2.83, 4.82),
        (("backlash by target", "bowed drift"), 1.61, 2.94),
    ],
    ids=lambda value: "+".join(value) or "none" if isinstance(value, tuple) else None,
)
def test_what_terms_gain_on_cycles_that_they_were_not_fitted_to(
    terms: tuple[str, ...], inside: float, ahead: float
) -> None:
    found = gained(terms)
    assert (found.inside, found.ahead) == pytest.approx((inside, ahead), abs=0.006)


def test_lost_motion_does_not_change_in_proportion_to_the_position() -> None:
    slope = gained(("backlash", "backlash_slope"))
    assert abs(slope.value) < 2.0 * slope.u


def test_the_command_says_the_same(capsys: pytest.CaptureFixture[str]) -> None:
    assert command() == 1
    assert "unexplained_structure" in capsys.readouterr().out
    assert command(kinds=TURNING) == 0
    assert "Backlash in EXX" in capsys.readouterr().out
