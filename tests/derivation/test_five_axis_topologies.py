"""Serial five-axis machines, drawn from all: three linear and two rotary axes, every order, every place of the bed."""

from itertools import combinations, permutations
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from tests.derivation.poses import VIEWS, drawn
from tests.exact_chain import ExactChain
from tests.kernels import call, column, kernels_of
from tests.machines import machine_of, serial_text

ALL = [
    ("".join(order[:bed][::-1]), "".join(order[bed:]))
    for rotary in combinations("ABC", 2)
    for order in permutations(("X", "Y", "Z", *rotary))
    for bed in range(6)
]
ERRORS: dict[str, dict[str, Any]] = {
    "X": {"sense": -1},
    "Y": {"position_errors": {"EC": "y_C"}, "position": [0.0, 12.5, 0.0]},
    "Z": {"position_errors": {"EA": "z_A", "EB": "z_B"}},
    "A": {"position": [1.0, "q_A", 7.0], "position_errors": {"EY": "a_Y", "EB": "a_B"}},
    "B": {"position": ["q_B", 0.0, -40.0], "position_errors": {"EX": "b_X", "EC": "b_C"}, "sense": -1},
    "C": {"position": [3.0, -2.0, "q_C"], "position_errors": {"EX": "c_X", "EA": "c_A"}},
}
DRAWS = [int(k) for k in np.random.default_rng(5).permutation(len(ALL))]


def check(index: int) -> None:
    workpiece, tool = ALL[index]
    text = serial_text(workpiece, tool, **{axis: ERRORS[axis] for axis in workpiece + tool})
    module = kernels_of(text)
    pose, values, point = drawn(chain := ExactChain(text), index)
    at = np.array(point)[:, None]
    for view in VIEWS:
        wanted = [float(v) for v in chain.deviation(view, pose, values, point)]
        found = call(module, f"{view}_deviation", pose, values, at)[:, 0]
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-13, err_msg=f"{workpiece}|{tool} {view}")
    first_order_falls_with_the_square(module, chain, index)
    inverse_undoes(module, chain, index)
    vector = [0.0, 0.6, 0.8]
    found = call(module, "tool_orientation_deviation", pose, values, np.array(vector)[:, None])[:, 0]
    np.testing.assert_allclose(found, [float(v) for v in chain.direction_deviation(pose, values, vector)], atol=1e-16)


def first_order_falls_with_the_square(module: ModuleType, chain: ExactChain, seed: int) -> None:
    gaps = []
    for size in (1.0, 0.5):
        pose, values, point = drawn(chain, seed, size)
        at = np.array(point)[:, None]
        both = (call(module, f"tool_in_workpiece_deviation{form}", pose, values, at) for form in ("", "_first_order"))
        gaps.append(np.abs(np.subtract(*both)).max())
    assert gaps[0] / gaps[1] == pytest.approx(4.0, rel=2e-2)


def inverse_undoes(module: ModuleType, chain: ExactChain, seed: int) -> None:
    """Moving the linear axes as `correction` says displaces the ideal tool point by the vector asked for."""
    pose, values, point = drawn(chain, seed)
    at, wanted = np.array(point)[:, None], np.array([[0.3], [-0.7], [0.4]])
    moves = call(module, "correction", pose, values, wanted)[:, 0]
    if np.abs(moves).max() > 1e3:
        return  # a linear axis on a rotary one: near a pose where three of them do not span space
    moved = pose | {axis: pose[axis] + step for axis, step in zip("XYZ", moves, strict=True)}
    ideal = [call(module, "tool_in_workpiece_ideal", where, values, at) for where in (pose, moved)]
    np.testing.assert_allclose(ideal[1] - ideal[0], wanted, atol=1e-9)


def test_there_are_as_many_as_there_should_be() -> None:
    assert len(set(ALL)) == len(ALL) == 3 * 120 * 6


@pytest.mark.parametrize("index", DRAWS[:6])
def test_a_drawn_machine_is_right(index: int) -> None:
    check(index)


@pytest.mark.slow
def test_many_drawn_machines_are_right() -> None:
    for index in DRAWS[6:22]:
        check(index)


def test_the_structure_code_gives_the_same_topology_as_bodies() -> None:
    for index in DRAWS[:60]:
        workpiece, tool = ALL[index]
        code = (
            "[w"
            + "".join(f" {axis}'" for axis in workpiece[::-1])
            + " b"
            + "".join(f" {axis}" for axis in tool)
            + " t]"
        )
        tables = "".join(f"[axis.{axis}]\ntravel = [-300.0, 400.0]\n" for axis in "XYZ")
        coded = machine_of(f'schema = 1\nname = "m"\nstructure = "{code}"\n{tables}')
        plain = machine_of(serial_text(workpiece, tool))
        assert [(b.number, b.lower, b.moves) for b in coded.bodies] == [
            (b.number, b.lower, b.moves) for b in plain.bodies
        ]
        assert (coded.workpiece, coded.tool) == (plain.workpiece, plain.tool)
        assert column(coded.axes, {}).shape == (5, 1)
