"""Directions of approach from the order of the readings: of axes that stand, and of axes that are read on their way."""

import numpy as np
import pytest

from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.setup import PointOn, Run

AXES = ("X", "Y", "Z")
BALL = {"target": PointOn("tool"), "reference": PointOn("workpiece"), "frame": "bed"}


def run(instrument: str) -> Run:
    bar = instrument == "ballbar"
    home = dict.fromkeys(AXES, 0.0)
    direction = None if bar else (1.0, 0.0, 0.0)
    return Run(id="a", instrument=instrument, home=home, direction=direction, length=100.0 if bar else None, **BALL)  # type: ignore[arg-type]


def directions(instrument: str, *path: list[float] | np.ndarray) -> np.ndarray:
    positions = np.array(path)
    return approach_directions(run(instrument), AXES, np.arange(positions.shape[1]), positions)


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_ball_bar_moves_along_the_tangent_where_it_reads(seed: int, way: float) -> None:
    """A few dozen samples of an arc, some left out: the step from the sample before has another sign after a turn."""
    source = np.random.default_rng(seed)
    angle = source.uniform(0.0, 6.0) + way * np.linspace(0.0, source.uniform(2.0, 6.0), source.integers(24, 60))
    angle = angle[source.random(angle.size) > 0.05]
    step = 2.0 * float(np.abs(np.diff(angle)).max())
    found = directions("ballbar", 150 * np.cos(angle), 150 * np.sin(angle), 0 * angle)
    for row, velocity in enumerate((-way * np.sin(angle), way * np.cos(angle))):
        plain = np.abs(velocity) > 0.1 * step  # closer to a turn a gap of one sample may hide it
        np.testing.assert_array_equal(found[row, plain], np.sign(velocity[plain]))
    assert not found[2].any()
    assert (found[:2, 0] != 0).all()  # the first sample has a direction, too


def test_the_order_is_that_of_seq() -> None:
    angle = np.linspace(0.3, 5.0, 40)
    path = np.array([np.cos(angle), np.sin(angle), 0 * angle])
    shuffled = np.random.default_rng(2).permutation(40)
    found = approach_directions(run("ballbar"), AXES, shuffled, path[:, shuffled])
    np.testing.assert_array_equal(found, directions("ballbar", *path)[:, shuffled])


def test_a_laser_reads_axes_that_stand_where_their_last_step_brought_them() -> None:
    found = directions("laser", [0.0, 10, 20, 20, 10], [0.0] * 5, [5.0, 5, 4, 4, 6])
    np.testing.assert_array_equal(found, [[0, 1, 1, 1, -1], [0] * 5, [1, 1, -1, -1, 1]])


def test_an_axis_of_a_ball_bar_that_stops_keeps_its_direction() -> None:
    found = directions("ballbar", [0.0, 1, 2, 2, 2, 2], [0.0, 1, 2, 3, 4, 5], [0.0] * 6)
    np.testing.assert_array_equal(found[0], np.ones(6))
    two = directions("ballbar", [0.0, 1.0], [0.0, 0.0], [0.0, 0.0])
    np.testing.assert_array_equal(two[0], [0, 1])
