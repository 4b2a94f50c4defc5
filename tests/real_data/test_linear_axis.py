"""What a diagnosis says of a real positioning test: the figures of docs/real-data.md."""

import numpy as np
import pytest

from tests.real_data.linear_axis import BOWED, TURNING, command, diagnosis, gained, lost_motion
from tests.real_data.linear_axis_data import FILE, readings
from trueaxis.diagnosis.judging.structure import StructureClass
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.evaluation.positioning_table_file import read_positioning_test
from trueaxis.evaluation.positioning_test import evaluate

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


OF_DIRECTION = {
    StructureClass.ERROR_DIRECTION,
    StructureClass.ERROR_AFTER_REVERSALS,
    StructureClass.LINE_DIRECTION,
    StructureClass.LINE_RIPPLE,
    StructureClass.LINE_LOCAL,
    StructureClass.LACK_OF_FIT,
}


@pytest.mark.parametrize(("swapped", "width"), [(False, -26.0), (True, 24.5)])
def test_lost_motion_is_named_with_a_remainder_and_swapped_labels_turn_its_sign(swapped: bool, width: float) -> None:
    """A constant explains a little more than the nine tenths asked; what is left depends on the direction as well."""
    found = diagnosis(swapped=swapped)
    assert found.verdict == "explained"
    (cause,) = found.causes
    (size,) = cause.parameters
    assert cause.effect.label == "backlash EXX"
    assert cause.rivals == ()
    assert 1e3 * size.value == pytest.approx(width, abs=0.4)
    assert 2e3 * size.u == pytest.approx(1.15, abs=0.2)
    assert cause.evidence > found.threshold + 30.0
    assert cause.remainder
    assert {one.structure for one in found.checks if one.fired} == OF_DIRECTION
    assert [one.component for one in found.stale] == ["EXX"]  # zero was given


def test_its_size_is_the_mean_reversal_value_of_the_standard() -> None:
    (size,) = diagnosis().causes[0].parameters
    assert abs(size.value - evaluate(read_positioning_test(FILE)).B_mean) < 2.0 * size.u


def test_what_the_name_gains_lies_between_plain_least_squares_with_and_without_a_drift() -> None:
    """Nine targets: the base is a mean for each target, backlash one column beside, and the run may creep."""
    gain = diagnosis().gain
    none, lost, drifting = gained(()), gained(("backlash",)), gained(("backlash", "drift"))
    counted = np.sqrt(90.0 / 88.0)  # the zero of the run is fitted and counts, and so, nearly, does its creep
    assert 1e3 * gain.rms.refitted == pytest.approx(counted * none.inside, rel=0.01)
    assert drifting.inside < 1e3 * gain.rms.extended < lost.inside
    assert drifting.ahead < 1e3 * gain.held_out.extended < lost.ahead < 0.5 * 1e3 * gain.held_out.refitted
    assert 1e3 * np.array([gain.rms.given, gain.held_out.given]) == pytest.approx([33.15, 33.24], abs=0.1)
    assert 1e3 * np.array([gain.rms.extended, gain.held_out.extended]) == pytest.approx([3.54, 4.68], abs=0.05)
    assert 1e3 * gain.floor == pytest.approx(2.27, abs=0.05)
    assert "2 passes" in gain.split


def test_the_last_cycles_hold_more_than_the_first_ones_tell() -> None:
    """The middle creeps: no term named accounts for that, and the scatter of the held-out residuals says so."""
    assert diagnosis().gain.standardised == pytest.approx(1.82, abs=0.1)


def test_lost_motion_is_not_the_same_everywhere_in_any_cycle() -> None:
    """16 um at -5 mm and 34 um at 0: the size named, with its uncertainty, is that of the mean alone."""
    found = lost_motion()
    assert found[3:5].mean(axis=1) == pytest.approx([-16.0, -33.6], abs=0.05)
    assert (found[4] < 1.5 * found[3]).all()
    (size,) = diagnosis().causes[0].parameters
    outside = np.abs(found.mean(axis=1) - 1e3 * size.value) > 2e3 * size.u
    assert np.count_nonzero(outside) >= 4


def test_with_four_cycles_lost_motion_is_named_all_the_same() -> None:
    """A cycle less neither costs the name nor brings another, nor does it change the size by more than its U."""
    found = {cycle: diagnosis(without=cycle) for cycle in range(1, 6)}
    for one in found.values():
        assert max(one.scan, key=lambda each: each.evidence).effect.label == "backlash EXX"
        assert named(one) == ["backlash EXX"]
        assert one.verdict == "explained"
        assert [1e3 * cause.parameters[0].value for cause in one.causes] == pytest.approx([-26.0], abs=0.6)


@pytest.mark.parametrize(("swapped", "width", "ahead"), [(False, -24.9, 4.6), (True, 23.5, 4.4)])
def test_a_kind_with_a_swing_takes_the_remainder_and_gains_little_ahead(
    swapped: bool, width: float, ahead: float
) -> None:
    found = diagnosis(kinds=TURNING, swapped=swapped)
    assert named(found) == ["backlash EXX", "turning_play EXX"]
    lost, turning = found.causes
    assert found.verdict == ("ambiguous" if lost.rivals else "explained")
    assert {one.effect.label for one in lost.rivals} <= {"reversal_spike EXX", "reversal_spike_path EXX"}
    assert turning.rivals == ()
    assert not lost.remainder
    assert 1e3 * lost.parameters[0].value == pytest.approx(width, abs=0.4)
    amplitude = np.hypot(turning.parameters[0].value, turning.parameters[1].value)
    assert 1e3 * amplitude == pytest.approx(4.5, abs=0.5)
    assert turning.parameters[2].value == pytest.approx(12.4, abs=0.4)
    assert (lost.held_out_gain, turning.held_out_gain) == pytest.approx((0.635, 0.048), abs=0.02)
    assert 1e3 * found.gain.held_out.extended == pytest.approx(ahead, abs=0.15)


def test_without_times_nothing_of_time_is_said() -> None:
    found = diagnosis(clock=False)
    unseen = {one.effect.kind for one in found.limits if "time_s" in one.reason}
    assert {"drift", "warm_up", "laser_step"} <= unseen
    assert evidence(found, "backlash EXX") == pytest.approx(evidence(diagnosis(), "backlash EXX"), rel=0.02)


@pytest.mark.parametrize("kinds", ["", BOWED], ids=["library", "bowed"])
def test_no_drift_is_named_and_the_noise_does_not_hold_it(kinds: str) -> None:
    """A creep of the run is the instrument's until another line says that it is not: it is free, and no noise."""
    found = diagnosis(kinds=kinds)
    assert named(found) == ["backlash EXX"]
    (noise,) = found.noise
    assert noise.origin == "repeats"
    assert 1e3 * noise.sigma < 0.85 * gained(("backlash by target",)).inside
    assert noise.correlated < 0.5 * noise.white
    assert gained(("backlash", "bowed drift")).ahead < 0.75 * gained(("backlash",)).ahead


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
    assert command() == 0
    said = capsys.readouterr().out
    assert "Cause found: Backlash in EXX, width -2" in said
    assert "a remainder is left" in said
    assert command(swapped=True) == 0
    assert "Cause found: Backlash in EXX, width 2" in capsys.readouterr().out
