"""The standard's parameters: a case worked by hand, its definitions written out again, and what must not change."""

import statistics
from dataclasses import fields

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from tests.evaluation.iso230_2.builders import made_up
from trueaxis.evaluation.positioning_test import Evaluation, PositioningTest, Unidirectional, departures, evaluate

ROOT2 = 2**0.5
SETTINGS = settings(max_examples=60, deadline=None)
TESTS = st.builds(made_up, m=st.integers(2, 12), n=st.integers(2, 7), seed=st.integers(0, 10**6))
AXIS = ("B", "B_mean", "R", "E", "M", "A")


def worked_by_hand() -> PositioningTest:
    """Deviations of 3 targets in 2 cycles, so that s of a pair is its difference over root 2."""
    targets = np.array([0.0, 10.0, 20.0])
    positive = np.array([[5.0, 7.0], [-1.0, -1.0], [0.0, 0.0]])
    negative = np.array([[5.0, 5.0], [0.0, 4.0], [-12.0, -12.0]])
    return PositioningTest(targets, targets[:, None] + positive, targets[:, None] + negative)


def test_a_case_worked_by_hand() -> None:
    found = evaluate(worked_by_hand())
    assert_close(found.positive.mean, [6, -1, 0])
    assert_close(found.negative.mean, [5, 2, -12])
    assert_close(found.positive.s, [ROOT2, 0, 0])
    assert_close(found.negative.s, [0, 2 * ROOT2, 0])
    assert_close(found.mean, [5.5, 0.5, -6])
    assert_close(found.b, [1, -3, 12])
    assert_close(found.positive.r, [4 * ROOT2, 0, 0])
    assert_close(found.negative.r, [0, 8 * ROOT2, 0])
    assert_close(found.r, [4 * ROOT2, 8 * ROOT2, 12])  # each by another of the three: 1 + 2 s < 4 s, ...
    assert_close([found.B, found.B_mean, found.R], [12, 10 / 3, 12])
    assert_close([found.positive.R, found.negative.R], [4 * ROOT2, 8 * ROOT2])
    assert_close([found.positive.E, found.negative.E, found.E], [7, 17, 18])
    assert_close(found.M, 11.5)
    assert_close(found.positive.A, 7 + 2 * ROOT2)
    assert_close(found.negative.A, 14 + 4 * ROOT2)
    assert_close(found.A, 18 + 2 * ROOT2)
    assert found.cycles == 2


def test_the_other_convention_changes_the_axis_s_repeatability_alone() -> None:
    iso, other = evaluate(worked_by_hand()), evaluate(worked_by_hand(), "unidirectional")
    assert_close(other.R, 8 * ROOT2)
    for name in ("B", "B_mean", "E", "M", "A"):
        assert getattr(other, name) == getattr(iso, name)
    assert np.array_equal(other.r, iso.r)


@given(test=TESTS)
@SETTINGS
def test_definitions_written_out_target_by_target(test: PositioningTest) -> None:
    found = evaluate(test)
    up, down, su, sd = [], [], [], []
    for target, positive, negative in zip(test.targets, test.positive, test.negative, strict=True):
        up.append(statistics.fmean(x - target for x in positive))
        down.append(statistics.fmean(x - target for x in negative))
        su.append(statistics.stdev(float(x - target) for x in positive))
        sd.append(statistics.stdev(float(x - target) for x in negative))
    mean = [(a + b) / 2 for a, b in zip(up, down, strict=True)]
    r = [max(2 * a + 2 * b + abs(u - d), 4 * a, 4 * b) for u, d, a, b in zip(up, down, su, sd, strict=True)]
    both, s = up + down, su + sd
    assert_close(found.b, [u - d for u, d in zip(up, down, strict=True)])
    assert_close(found.r, r)
    assert_close(found.R, max(r))
    assert_close(found.E, max(both) - min(both))
    assert_close(found.M, max(mean) - min(mean))
    highest = max(x + 2 * u for x, u in zip(both, s, strict=True))
    lowest = min(x - 2 * u for x, u in zip(both, s, strict=True))
    assert_close(found.A, highest - lowest)
    assert_close(found.negative.E, max(down) - min(down))


def test_estimators_are_those_of_scipy() -> None:
    test = made_up(8, 5)
    found = evaluate(test)
    described = stats.describe(test.negative - test.targets[:, None], axis=1)
    assert_close(found.negative.mean, described.mean)
    assert_close(found.negative.s, np.sqrt(described.variance))
    assert_close(found.positive.s, stats.tstd(test.positive - test.targets[:, None], axis=1))


@given(test=TESTS, shift=st.floats(-5.0, 5.0))
@SETTINGS
def test_a_shift_of_all_readings_shifts_mean_deviations_alone(test: PositioningTest, shift: float) -> None:
    before = evaluate(test)
    after = evaluate(PositioningTest(test.targets, test.positive + shift, test.negative + shift))
    for side in ("positive", "negative"):
        one, other = getattr(before, side), getattr(after, side)
        assert other.mean == pytest.approx(one.mean + shift, abs=1e-10)
        assert_same(one, other, ("s", "r", "R", "E", "A"))
    assert after.mean == pytest.approx(before.mean + shift, abs=1e-10)
    assert_same(before, after, ("b", "r", *AXIS))


@given(test=TESTS)
@SETTINGS
def test_swapped_labels_swap_the_directions_and_keep_what_both_have(test: PositioningTest) -> None:
    before, after = evaluate(test), evaluate(test.swapped())
    for name in (field.name for field in fields(Unidirectional)):
        assert np.array_equal(getattr(after.positive, name), getattr(before.negative, name))
        assert np.array_equal(getattr(after.negative, name), getattr(before.positive, name))
    assert np.array_equal(after.b, -before.b)
    assert after.B_mean == -before.B_mean
    assert_same(before, after, ("mean", "r", "B", "R", "E", "M", "A"))


@given(test=TESTS, seed=st.integers(0, 99))
@SETTINGS
def test_the_order_of_cycles_and_targets_does_not_matter(test: PositioningTest, seed: int) -> None:
    rng = np.random.default_rng(seed)
    i, j = rng.permutation(test.positive.shape[0]), rng.permutation(test.positive.shape[1])
    mixed = PositioningTest(test.targets[i], test.positive[i][:, j], test.negative[i])
    before, after = evaluate(test), evaluate(mixed)
    assert after.r == pytest.approx(before.r[i], abs=1e-10)
    assert_same(before, after, AXIS)


@given(test=TESTS)
@SETTINGS
def test_what_the_parts_imply_for_the_whole(test: PositioningTest) -> None:
    found = evaluate(test)
    assert max(found.positive.E, found.negative.E, found.M) <= found.E
    assert max(found.positive.A, found.negative.A, found.E) <= found.A
    assert max(found.B, found.positive.R, found.negative.R) <= found.R
    assert abs(found.B_mean) <= found.B


@pytest.mark.parametrize(
    ("targets", "n", "words"),
    [
        ([0.0, 9.0, 21.0, 33.0, 40.0], 5, []),
        ([0.0, 9.0, 21.0, 33.0], 5, ["4 targets"]),
        ([0.0, 9.0, 21.0, 33.0, 40.0], 4, ["4 cycles"]),
        ([0.0, 10.0, 20.0, 30.0, 40.0], 5, ["evenly"]),
        ([0.0, 210.0, 400.0, 600.0, 1100.0], 5, ["5 per metre"]),
        ([0.0, 210.0, 400.0, 600.0, 2100.0], 5, ["span 2100 mm"]),
    ],
)
def test_departures_from_the_standard_s_test_are_told(targets: list[float], n: int, words: list[str]) -> None:
    grid = np.tile(np.array(targets)[:, None], n)
    found = departures(evaluate(PositioningTest(np.array(targets), grid, grid)))
    assert len(found) == len(words)
    assert all(word in text for word, text in zip(words, found, strict=True))


def assert_close(found: npt.ArrayLike, expected: npt.ArrayLike) -> None:
    np.testing.assert_allclose(np.asarray(found, float), np.asarray(expected, float), rtol=1e-9, atol=1e-12)


def assert_same(one: Evaluation | Unidirectional, other: Evaluation | Unidirectional, names: tuple[str, ...]) -> None:
    for name in names:
        assert getattr(other, name) == pytest.approx(getattr(one, name), abs=1e-10), name
