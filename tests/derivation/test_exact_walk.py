"""The exact kernels against products of 4x4 matrices in forty digits."""

from typing import Any

import numpy as np
import pytest

from tests.derivation.poses import VIEWS, drawn
from tests.derivation.topologies import OTHERS, THREE_AXIS
from tests.exact_chain import ExactChain
from tests.kernels import call, kernels_of

ALL = OTHERS | THREE_AXIS


def exact(text: str, view: str, seed: int, size: float = 1.0) -> Any:
    pose, values, point = drawn(chain := ExactChain(text), seed, size)
    return np.array([float(v) for v in chain.deviation(view, pose, values, point)])


def kernel(text: str, routine: str, seed: int, size: float = 1.0) -> Any:
    pose, values, point = drawn(ExactChain(text), seed, size)
    return call(kernels_of(text), routine, pose, values, np.array(point)[:, None])[:, 0]


@pytest.mark.parametrize("label", ALL)
def test_exact_deviation_of_every_view_is_that_of_the_matrices(label: str) -> None:
    for seed, view in enumerate(VIEWS):
        np.testing.assert_allclose(
            kernel(ALL[label], f"{view}_deviation", seed), exact(ALL[label], view, seed), rtol=0, atol=1e-14
        )


@pytest.mark.parametrize("label", OTHERS)
def test_large_errors_are_as_exact_as_small_ones(label: str) -> None:
    # A radian of error is far from any first order: the closed inverse of 1 + [epsilon x] must be the true one.
    pose, values, point = drawn(chain := ExactChain(OTHERS[label]), 7, 1e4)
    for view in VIEWS:
        found = call(kernels_of(OTHERS[label]), f"{view}_deviation", pose, values, np.array(point)[:, None])[:, 0]
        wanted = [float(v) for v in chain.deviation(view, pose, values, point)]
        np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-10)
        assert np.abs(found).max() > 10 or view != "tool_in_workpiece"


@pytest.mark.parametrize("label", OTHERS)
def test_tiny_errors_keep_their_digits(label: str) -> None:
    # Differences of two positions would lose all of 1e-15 mm against 1e3 mm.
    wanted = exact(OTHERS[label], "tool_in_workpiece", 3, 1e-9)
    found = kernel(OTHERS[label], "tool_in_workpiece_deviation", 3, 1e-9)
    assert 0 < np.abs(wanted).max() < 1e-9
    np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize("label", OTHERS)
def test_positions_and_ideal_positions_are_those_of_the_matrices(label: str) -> None:
    pose, values, point = drawn(chain := ExactChain(OTHERS[label]), 11)
    errors = {*chain.components, *chain.location_errors}
    ideal = {name: value for name, value in values.items() if name not in errors}
    module, at = kernels_of(OTHERS[label]), np.array(point)[:, None]
    for view in VIEWS:
        wanted = [float(v) for v in chain.place(view, pose, ideal, point)]
        np.testing.assert_allclose(call(module, f"{view}_ideal", pose, values, at)[:, 0], wanted, atol=2e-12)
    wanted = [float(v) for v in chain.place("tool_in_workpiece", pose, values, point)]
    np.testing.assert_allclose(call(module, "tool_in_workpiece_position", pose, values, at)[:, 0], wanted, atol=2e-12)


def test_a_body_below_both_ends_cancels_only_as_far_as_it_does() -> None:
    # X carries both ends: alone, its translation errors change nothing, and its rotation turns both ends alike.
    chain = ExactChain(OTHERS["shared"])
    pose, _, point = drawn(chain, 5)
    module = kernels_of(OTHERS["shared"])
    for name in ("EXX", "ECX", "b0", "b1"):
        found = call(module, "tool_in_workpiece_deviation", pose, {name: 1e-3}, np.array(point)[:, None])
        assert np.abs(found).max() < 1e-15
        assert np.abs(call(module, "tool_in_bed_deviation", pose, {name: 1e-3}, np.array(point)[:, None])).max() > 1e-4
