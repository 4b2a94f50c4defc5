"""Singular geometries in the order of blocks, as the stepwise method needs it."""

from dataclasses import replace

from tests.planning.data import folder, laser, model, path, runs
from trueaxis.measurement.setup import PointOn, Vector
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.order import order, same_coordinates

STEPS = [0.0, 150.0, 300.0, 450.0]


def three(*points: Vector) -> "list[str]":
    """What is said of three lasers along x at points of the tool, block by block."""
    lasers = [laser(f"L{i}", "x", (x + 10.0, y + 20.0, z + 30.0)) for i, (x, y, z) in enumerate(points, 1)]
    found = order(model(), runs(lasers, [path("X", STEPS)] * 3).observed, ErrorValues(machine="dmu60p"))
    assert found is not None
    (block,) = found.blocks()
    return [block.because, *[str(pair) for pair in block.ranks]]


def test_points_in_a_triangle_are_regular() -> None:
    assert three((0.0, 0.0, 0.0), (9.0, 100.0, 0.0), (0.0, 0.0, 100.0)) == ["", "(3, 3)"]


def test_points_on_a_line_are_singular() -> None:
    because, ranks = three((0.0, 0.0, 0.0), (50.0, 50.0, 20.0), (0.0, 100.0, 40.0))
    assert ranks == "(2, 3)"
    assert "lie on a line" in because


def test_two_lasers_on_one_line_are_one() -> None:
    because, ranks = three((0.0, 0.0, 0.0), (80.0, 0.0, 0.0), (0.0, 100.0, 40.0))
    assert ranks == "(2, 3)"
    assert because == "the points of L1 and L2 have the same y and z"


def test_same_coordinates_need_one_direction_and_one_body() -> None:
    one, other = laser("A", "x", (0.0, 1.0, 2.0)), laser("B", "x", (5.0, 1.0, 2.0))
    assert same_coordinates([one, other]) == "the points of A and B have the same y and z"
    assert same_coordinates([one, replace(other, direction=(0.0, 1.0, 0.0))]) == ""
    assert same_coordinates([one, replace(other, target=PointOn("workpiece", (5.0, 1.0, 2.0)))]) == ""


def test_the_papers_blocks_and_its_z_points_in_words() -> None:
    found = order(model(), folder("dmu60p_runs").observed, ErrorValues(machine="dmu60p"))
    assert found is not None
    blocks = found.blocks()
    assert [block.components for block in blocks][:3] == [
        ("EXX", "EBX", "ECX"),
        ("EYY", "EAY", "ECY"),
        ("EZZ", "EAZ", "EBZ"),
    ]
    assert [block.because for block in blocks if block.because] == ["the points of Z-8 and Z-9 have the same x and y"]
    regular = order(model(), folder("dmu60p_regular_runs").observed, ErrorValues(machine="dmu60p"))
    assert regular is not None
    assert not any(block.because for block in regular.blocks())
