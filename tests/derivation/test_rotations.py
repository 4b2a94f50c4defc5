"""True rotations, and directions instead of points, against matrices in forty digits."""

import numpy as np
import pytest

from tests.derivation.poses import VIEWS, drawn
from tests.derivation.topologies import OTHERS
from tests.exact_chain import ExactChain
from tests.kernels import call, kernels_of

TRUE = {label: 'rotations = "true"\n' + text for label, text in OTHERS.items()}


@pytest.mark.parametrize("size", [1.0, 1e2])
@pytest.mark.parametrize("label", TRUE)
def test_true_rotations_are_exponentials_of_the_rotation_vector(label: str, size: float) -> None:
    pose, values, point = drawn(chain := ExactChain(TRUE[label]), 5, size)
    for view in VIEWS:
        found = call(kernels_of(TRUE[label]), f"{view}_deviation", pose, values, np.array(point)[:, None])[:, 0]
        wanted = [float(v) for v in chain.deviation(view, pose, values, point)]
        np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-14 * size)


def test_the_two_forms_differ_in_second_order() -> None:
    label = "table-table AC"
    gaps = []
    for size in (1.0, 0.5):
        pose, values, point = drawn(ExactChain(OTHERS[label]), 2, size)
        at = np.array(point)[:, None]
        both = [call(kernels_of(t[label]), "tool_in_workpiece_deviation", pose, values, at) for t in (OTHERS, TRUE)]
        gaps.append(np.abs(both[0] - both[1]).max())
    assert gaps[0] > 0
    assert gaps[0] / gaps[1] == pytest.approx(4.0, rel=1e-3)


@pytest.mark.parametrize("texts", [OTHERS, TRUE], ids=["small-angle", "true"])
@pytest.mark.parametrize("label", [label for label in OTHERS if label != "dmu60p"])
def test_orientation_deviation_is_that_of_the_matrices(label: str, texts: dict[str, str]) -> None:
    pose, values, _ = drawn(chain := ExactChain(texts[label]), 9)
    vector = [0.6, 0.0, 0.8]
    found = call(kernels_of(texts[label]), "tool_orientation_deviation", pose, values, np.array(vector)[:, None])
    wanted = [float(v) for v in chain.direction_deviation(pose, values, vector)]
    np.testing.assert_allclose(found[:, 0], wanted, rtol=1e-11, atol=1e-16)
    first = call(
        kernels_of(texts[label]), "tool_orientation_deviation_first_order", pose, values, np.array(vector)[:, None]
    )
    assert np.abs(first[:, 0] - wanted).max() < 1e-3 * np.abs(wanted).max()


def test_a_true_rotation_keeps_the_length_of_the_tool_axis() -> None:
    label = "five_axis"
    pose, values, _ = drawn(ExactChain(TRUE[label]), 9, 1e2)
    axis = np.array([[0.0], [0.0], [1.0]])
    module = kernels_of(TRUE[label])
    ideal = call(module, "tool_orientation_ideal", pose, values, axis)
    actual = ideal + call(module, "tool_orientation_deviation", pose, values, axis)
    assert np.linalg.norm(actual) == pytest.approx(1.0, abs=1e-14)
