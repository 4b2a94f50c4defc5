"""Motion equations (Eqs. 7-11) against differences of exact matrices, away from home and at home."""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest

from tests.derivation.poses import drawn
from tests.derivation.topologies import OTHERS
from tests.exact_chain import DIGITS, ExactChain
from tests.kernels import call, kernels_of, model_of

LABELS = ("dmu60p", "five_axis", "table B, head A", "shared")


def displacement(chain: ExactChain, terms: Any, pose: Mapping[str, float], values: Mapping[str, Any]) -> Any:
    """Signed sum of displacements since home in the bed frame; at home there are no motion errors."""
    home = dict.fromkeys(chain.axes, 0.0)
    still = {name: value for name, value in values.items() if name not in chain.components}
    total = DIGITS.matrix([0, 0, 0])
    for sign, seen, point in terms:
        view = f"{seen}_in_bed"
        total += sign * (chain.place(view, pose, values, point) - chain.place(view, home, still, point))
    return total


def linear_part(chain: ExactChain, terms: Any, pose: Mapping[str, float], values: Mapping[str, Any]) -> Any:
    """Ideal displacement plus the derivative along the errors, by central differences in forty digits."""
    errors = {*chain.components, *chain.location_errors}
    step = DIGITS.mpf("1e-12")

    def scaled(by: Any) -> dict[str, Any]:
        return {name: by * DIGITS.mpf(v) if name in errors else v for name, v in values.items()}

    up, down = (displacement(chain, terms, pose, scaled(sign * step)) for sign in (1, -1))
    whole = displacement(chain, terms, pose, scaled(0)) + (up - down) / (2 * step)
    return np.array([float(v) for v in whole])


@pytest.mark.parametrize("label", LABELS)
def test_every_pattern_is_the_first_order_difference_of_exact_chains(label: str) -> None:
    chain, module = ExactChain(OTHERS[label]), kernels_of(OTHERS[label])
    for seed, motion in enumerate(model_of(OTHERS[label]).motions):
        pose, values, _ = drawn(chain, seed)
        pose = {axis: at if axis in motion.moves else 0.0 for axis, at in pose.items()}
        values = {n: v for n, v in values.items() if n not in chain.components or n[2] in motion.moves}
        points = np.random.default_rng(seed).uniform(-200, 200, (len(motion.terms), 3))
        terms = [(sign, seen, point) for (sign, seen, _), point in zip(motion.terms, points, strict=True)]
        name = "motion_" + "".join(motion.moves)
        found = call(module, name, pose, values, *(point[:, None] for point in points))[:, 0]
        np.testing.assert_allclose(found, linear_part(chain, terms, pose, values), rtol=0, atol=1e-12, err_msg=name)


def test_axes_that_stand_still_are_at_home_whatever_the_positions_say() -> None:
    module = kernels_of(OTHERS["dmu60p"])
    point = np.array([[10.0], [20.0], [30.0]])
    values = {"EBX": 1e-4, "ECX": 2e-4, "eps_xz": 3e-4, "EBZ": 5e-4}
    away = call(module, "motion_X", {"X": 100.0, "Y": 50.0, "Z": 70.0}, values, point)
    home = call(module, "motion_X", {"X": 100.0}, {n: v for n, v in values.items() if n != "EBZ"}, point)
    np.testing.assert_array_equal(away, home)
    assert np.abs(home[:, 0] - [100, 0, 0]).max() > 1e-3


def test_patterns_are_every_axis_and_every_pair_of_linear_axes() -> None:
    assert [m.moves for m in model_of(OTHERS["dmu60p"]).motions] == [
        ("X",), ("Y",), ("Z",), ("X", "Y"), ("X", "Z"), ("Y", "Z"),
    ]  # fmt: skip
    assert [m.moves for m in model_of(OTHERS["five_axis"]).motions][:5] == [("X",), ("Y",), ("Z",), ("B",), ("C",)]


def test_points_are_where_the_moving_axes_are() -> None:
    # As in the paper: tool point for X, Z and XZ, workpiece point for Y, workpiece minus tool point for XY and YZ.
    seen = {"".join(m.moves): [(sign, body) for sign, body, _ in m.terms] for m in model_of(OTHERS["dmu60p"]).motions}
    both = [(1, "workpiece"), (-1, "tool")]
    tool = [(1, "tool")]
    assert seen == {"X": tool, "Y": [(1, "workpiece")], "Z": tool, "XY": both, "XZ": tool, "YZ": both}
