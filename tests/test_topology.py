"""The lower-body array and the branches: the paper's machine by hand, and any tree against repeated application."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.kernels import kernels_of
from tests.machines import DMU60P, machine_at, machine_of, serial_text, spec_text
from trueaxis.machine import Body, Machine
from trueaxis.machine.topology import branch, branches, format_lower_body_array, lower_body_array, tool_senses


def test_the_papers_machine() -> None:
    # Fig. 2 with C, B and spindle one with what they stand on: 1 - 2 - 4 and 1 - 5 - 6 - 9. By hand:
    assert lower_body_array(machine_at(DMU60P)) == (
        (1, 2, 4, 5, 6, 9),
        (0, 1, 2, 1, 5, 6),
        (0, 0, 1, 0, 1, 5),
        (0, 0, 0, 0, 0, 1),
        (0, 0, 0, 0, 0, 0),
    )
    workpiece, tool = branches(machine_at(DMU60P))
    assert [body.number for body in workpiece] == [2, 4]
    assert [body.number for body in tool] == [5, 6, 9]


def test_the_array_is_shown_aligned() -> None:
    assert format_lower_body_array(machine_at(DMU60P)).splitlines()[:2] == [
        "L^0  1  2  4  5  6  9",
        "L^1  0  1  2  1  5  6",
    ]


@st.composite
def trees(draw: st.DrawFn) -> Machine:
    """Bodies with gaps in their numbers, in any order in the spec, each on one drawn before it or on the bed."""
    numbers = draw(st.lists(st.integers(2, 99), min_size=1, max_size=12, unique=True))
    bodies = [
        Body(number=number, name=f"b{number}", lower=draw(st.sampled_from([1, *numbers[:index]])))
        for index, number in enumerate(numbers)
    ]
    workpiece, tool = draw(st.sampled_from(numbers)), draw(st.sampled_from(numbers))
    shuffled = tuple(draw(st.permutations(bodies)))
    return Machine(name="tree", title="tree", bodies=shuffled, workpiece=workpiece, tool=tool)


@given(trees())
def test_each_order_is_the_first_applied_so_many_times(machine: Machine) -> None:
    rows = lower_body_array(machine)
    lower = {body.number: body.lower for body in machine.bodies} | {1: 0, 0: 0}
    for order, row in enumerate(rows):
        for column, body in enumerate(rows[0]):
            at = body
            for _ in range(order):
                at = lower[at]
            assert row[column] == at
    assert not any(rows[-1])
    assert any(rows[-2])


@given(trees())
def test_a_branch_runs_from_the_bed_to_its_end_by_the_array(machine: Machine) -> None:
    rows = lower_body_array(machine)
    for end in (machine.workpiece, machine.tool):
        column = rows[0].index(end)
        downwards = [row[column] for row in rows if row[column] > 1]
        found = branch(machine, end)
        assert [body.number for body in found] == downwards[::-1]
        assert found[0].lower == 1


BOTH_ENDS = [
    {"number": 2, "name": "column", "lower": 1, "moves": "X", "travel": [0.0, 1.0]},
    {"number": 3, "name": "table", "lower": 2, "moves": "Y", "travel": [0.0, 1.0]},
    {"number": 4, "name": "ram", "lower": 2, "moves": "Z", "travel": [0.0, 1.0]},
]


@pytest.mark.parametrize(
    ("text", "senses"),
    [
        (serial_text("", "XYZ"), {"X": 1, "Y": 1, "Z": 1}),
        (serial_text("YX", "Z"), {"X": -1, "Y": -1, "Z": 1}),
        (serial_text("YX", "Z", X={"sense": -1}, Z={"sense": -1}), {"X": 1, "Y": -1, "Z": -1}),
        (serial_text("YC", "XZB"), {"X": 1, "Y": -1, "Z": 1, "B": 1, "C": -1}),
        (serial_text("ZB", "XYA", A={"sense": -1}, B={"sense": -1}), {"X": 1, "Y": 1, "Z": -1, "A": -1, "B": 1}),
        (spec_text(BOTH_ENDS, 3, 4), {"X": 0, "Y": -1, "Z": 1}),
    ],
    ids=range(6),
)
def test_the_way_that_positive_commands_move_the_tool(text: str, senses: dict[str, int]) -> None:
    machine = machine_of(text)
    assert tool_senses(machine) == senses
    assert hasattr(kernels_of(text), "correction") == (0 not in senses.values())  # no move of such an axis corrects
    ideal = kernels_of(text).tool_in_workpiece_ideal
    home, lengths = np.zeros((len(machine.axes), 1)), np.zeros(len(machine.parameters))
    for axis, sense in senses.items():
        moved = home + np.array([[float(axis == other)] for other in machine.axes])
        if axis in "XYZ":
            step = ideal(moved, lengths, np.zeros((3, 1))) - ideal(home, lengths, np.zeros((3, 1)))
            np.testing.assert_allclose(step[:, 0], [sense * float(axis == other) for other in "XYZ"], atol=1e-12)
        else:  # the second axis of Y-Z, Z-X, X-Y gains what the first one had
            first, second = {"A": (1, 2), "B": (2, 0), "C": (0, 1)}[axis]
            point = np.eye(3)[:, [first]]
            arm = ideal(moved, lengths, point) - ideal(moved, lengths, np.zeros((3, 1)))
            assert arm[second, 0] == pytest.approx(sense * np.sin(np.radians(1.0)), abs=1e-12)
