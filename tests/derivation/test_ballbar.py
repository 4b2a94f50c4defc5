"""The ball-bar kernel against the norm itself in forty digits (Eqs. 5, 6)."""

from typing import Any

import numpy as np
import pytest

from tests.derivation.poses import drawn
from tests.derivation.topologies import OTHERS
from tests.exact_chain import DIGITS, ExactChain
from tests.kernels import call, kernels_of

LENGTH = 300.0


def both(label: str, seed: int, size: float, length: float = LENGTH) -> tuple[Any, Any]:
    """(kernel, forty digits): E, E_x, E_y, E_z of a bar of LENGTH from ball to ball."""
    chain = ExactChain(OTHERS[label])
    pose, values, point = drawn(chain, seed, size)
    errors = {*chain.components, *chain.location_errors}
    ideal = chain.place("tool_in_workpiece", pose, {n: v for n, v in values.items() if n not in errors}, point)
    way = np.random.default_rng(seed + 100).normal(size=3)
    ball = [float(p) - LENGTH * w / np.linalg.norm(way) for p, w in zip(ideal, way, strict=True)]
    vector = chain.place("tool_in_workpiece", pose, values, point) - DIGITS.matrix(ball)
    distance = DIGITS.norm(vector)
    wanted = [distance - length] + [(distance - length) * v / distance for v in vector]
    columns = (np.array(point)[:, None], np.array(ball)[:, None], np.array([[length]]))
    found = call(kernels_of(OTHERS[label]), "ballbar_error", pose, values, *columns)[:, 0]
    return found, np.array([float(v) for v in wanted])


@pytest.mark.parametrize("label", OTHERS)
def test_the_error_and_its_components_are_those_of_the_norm(label: str) -> None:
    for seed in range(3):
        found, wanted = both(label, seed, 1.0)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=5e-13)
        found, wanted = both(label, seed, 1e3, length=299.0)
        np.testing.assert_allclose(found, wanted, rtol=0, atol=5e-12)


def test_the_growth_of_the_bar_keeps_its_digits_under_tiny_errors() -> None:
    # A picometre in 300 mm: the difference of two norms would be wrong by 5e-14 mm. On the paper's machine with the
    # ball along x the ideal distance is exact in doubles, and the error is the error alone.
    chain = ExactChain(OTHERS["dmu60p"])
    pose = {"X": 0.0, "Y": 0.0, "Z": 0.0}
    values = {"EXX": 1.1e-12, "EYX": 3e-7, "EZZ": -2e-13}
    point, ball = [LENGTH, 0.0, 0.0], [0.0, 0.0, 0.0]
    distance = DIGITS.norm(chain.place("tool_in_workpiece", pose, values, point))
    columns = (np.array(point)[:, None], np.array(ball)[:, None], np.array([[LENGTH]]))
    found = call(kernels_of(OTHERS["dmu60p"]), "ballbar_error", pose, values, *columns)[:, 0]
    assert found[0] == pytest.approx(float(distance - 300), rel=1e-12, abs=0)
    assert found[1] == pytest.approx(float(distance - 300), rel=1e-12, abs=0)


def test_the_components_are_the_error_along_the_actual_bar() -> None:
    found, _ = both("five_axis", 1, 1e3, length=298.5)
    assert np.linalg.norm(found[1:]) == pytest.approx(abs(found[0]), rel=1e-13, abs=0)
