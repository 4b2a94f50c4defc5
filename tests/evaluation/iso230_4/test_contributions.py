"""Errors of a circular test against a machine driven point by point."""

from collections.abc import Sequence

import numpy as np
import pytest

from tests.evaluation.iso230_4.path import Mill, turn
from trueaxis.evaluation.circular_contributions import Contribution, contributions
from trueaxis.evaluation.circular_test import Arc, CircularTest

RADIUS, FEED = 150.0, 1000.0


def circle_of(mill: Mill, senses: Sequence[int] = (1, -1), noise: float = 0.0, seed: int = 0) -> CircularTest:
    draw = np.random.default_rng(seed)
    arcs = []
    for sense in senses:
        angle = turn(sense)
        reading = mill.read(angle, sense, RADIUS, FEED) + noise * draw.standard_normal(angle.size)
        arcs.append(Arc(id=f"{sense:+d}", sense=sense, angle=angle, deviation=reading))
    return CircularTest(plane=("X", "Y"), radius=RADIUS, feed=FEED, arcs=tuple(arcs))


def by_name(test: CircularTest) -> dict[tuple[str, str], Contribution]:
    return {(one.error, one.of): one for one in contributions(test).largest}


EACH = [
    (Mill(squareness=40e-6), {("squareness", "XY"): 40.0}),
    (Mill(scale=(30e-6, -20e-6)), {("scale_mismatch", "X-Y"): 50.0}),
    (Mill(sag=(4e-3, 0.0)), {("straightness", "X in Y"): 4.0}),
    (Mill(sag=(0.0, -3e-3)), {("straightness", "Y in X"): -3.0}),
    (Mill(reversal=(-6e-3, 0.0)), {("reversal_error", "X, + end"): -6.0, ("reversal_error", "X, - end"): -6.0}),
    (Mill(reversal=(0.0, 5e-3)), {("reversal_error", "Y, + end"): 5.0, ("reversal_error", "Y, - end"): 5.0}),
    (Mill(play=(4e-3, 0.0)), {("lateral_play", "X"): 4.0}),
    (Mill(play=(0.0, -4e-3)), {("lateral_play", "Y"): -4.0}),
    (Mill(lag=(6e-4, 2e-4)), {("servo_mismatch", "X-Y"): 0.4}),
    (Mill(spike=(5e-3, 0.0)), {("reversal_spike", "X"): 5.0}),
    (Mill(spike=(0.0, 5e-3)), {("reversal_spike", "Y"): 5.0}),
    (Mill(cyclic=(2e-3, 11.0)), {("cyclic_error", "X"): 4.0}),
]


@pytest.mark.parametrize(("mill", "expected"), EACH, ids=[next(iter(of))[0] + str(k) for k, (_, of) in enumerate(EACH)])
def test_an_error_is_found_with_its_sign_and_no_other_is(mill: Mill, expected: dict[tuple[str, str], float]) -> None:
    """Terms of second order and what the grids leave of a spike are all that the others may have."""
    found = by_name(circle_of(mill, noise=1e-5))
    largest = max(abs(found[name].range) for name in expected)
    for name, value in expected.items():
        assert found[name].value == pytest.approx(value, rel=0.03)
    others = [one for name, one in found.items() if name not in expected]
    assert max(abs(one.range) for one in others) < 0.06 * largest
    assert {(one.error, one.of) for one in contributions(circle_of(mill, noise=1e-5)).largest[: len(expected)]} == set(
        expected
    )


def drawn(draw: np.random.Generator) -> Mill:
    one, two = draw.normal(size=2), draw.normal(size=(6, 2))
    return Mill(
        squareness=30e-6 * one[0],
        scale=tuple(20e-6 * two[0]),
        sag=tuple(2e-3 * two[1]),
        reversal=tuple(4e-3 * two[2]),
        play=tuple(1e-3 * two[3]),
        lag=tuple(2e-4 * two[4]),
        spike=tuple(np.abs(4e-3 * two[5])),
        spike_length=float(draw.uniform(1.0, 12.0)),
        centre=tuple(draw.normal(0.0, 0.02, 2)),
        bar=float(draw.normal(0.0, 0.005)),
    )


def test_u_covers_the_truth_where_all_errors_are_there_at_once() -> None:
    """20 machines with a noise of 0.3 um: values of every kind within 2 u as often as they should be, or nearly."""
    within: list[bool] = []
    for seed in range(20):
        mill = drawn(np.random.default_rng(seed))
        found = by_name(circle_of(mill, noise=3e-4, seed=seed))
        for name, value in {
            ("squareness", "XY"): 1e6 * mill.squareness,
            ("scale_mismatch", "X-Y"): 1e6 * (mill.scale[0] - mill.scale[1]),
            ("reversal_error", "X, + end"): 1e3 * mill.reversal[0],
            ("reversal_error", "Y, - end"): 1e3 * mill.reversal[1],
            ("servo_mismatch", "X-Y"): 1e3 * (mill.lag[0] - mill.lag[1]),
            ("straightness", "X in Y"): 1e3 * mill.sag[0],
        }.items():
            within.append(abs(found[name].value - value) < 2.0 * found[name].u)
    assert np.mean(within) > 0.85


def test_noise_alone_has_no_cyclic_error() -> None:
    named = [name for seed in range(8) for name in by_name(circle_of(Mill(), noise=5e-4, seed=seed))]
    assert not [name for name in named if name[0] == "cyclic_error"]


def test_one_sense_leaves_out_what_it_cannot_tell() -> None:
    found = contributions(circle_of(Mill(squareness=40e-6), senses=(1,), noise=1e-5))
    assert ("servo_mismatch", "X-Y") in found.left_out
    assert not {name for name, _ in found.left_out} & {"squareness", "scale_mismatch", "reversal_error"}
    (value,) = (one.value for one in found.largest if one.error == "squareness")
    assert value == pytest.approx(40.0, rel=0.03)


def test_shares_add_up_and_ranks_fall() -> None:
    found = contributions(circle_of(drawn(np.random.default_rng(3)), noise=3e-4)).largest
    assert sum(one.share for one in found) == pytest.approx(1.0)
    assert [one.range for one in found] == sorted((one.range for one in found), reverse=True)


def test_without_a_feed_servo_mismatch_is_a_length() -> None:
    test = circle_of(Mill(lag=(6e-4, 0.0)), noise=1e-5)
    without = CircularTest(plane=test.plane, radius=test.radius, feed=None, arcs=test.arcs)
    one = by_name(without)["servo_mismatch", "X-Y"]
    assert one.unit == "um"
    assert one.value == pytest.approx(6e-4 * FEED / 60.0 * 1e3, rel=0.03)
