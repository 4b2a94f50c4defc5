"""Directions, distances since reversals and velocities along a path, worked out by hand."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from trueaxis.compensation.course import (
    LONG,
    RAMP,
    Course,
    Standing,
    at_vertices,
    cruising,
    ramps,
    since_reversal,
    turnings,
)
from trueaxis.compensation.path import Path
from trueaxis.effects.placement import FARTHEST


def path(points: list[list[float]], start: list[float], rapid: list[bool] | None = None) -> Path:
    """One move for each point."""
    ends = np.array(points, dtype=np.float64).T
    size = ends.shape[1]
    origins = np.concatenate([np.array(start, dtype=np.float64)[:, None], ends[:, :-1]], axis=1)
    none = np.zeros(size, dtype=bool)
    return Path(
        points=ends,
        origins=origins,
        owner=np.arange(size),
        rapid=none if rapid is None else np.array(rapid),
        halts=none,
    )


def directions(places: list[float], band: float, start: float = 0.0) -> list[float]:
    wanted = np.array([places])
    found, _ = turnings(wanted, Standing.at(np.array([start])), np.full_like(wanted, band))
    return [float(direction) for direction in found[0]]


def test_an_axis_keeps_its_direction_while_it_stands() -> None:
    assert directions([0.0, 1.0, 1.0, 2.0, 1.5, 1.5, 1.0, 3.0], 0.1) == [0, 1, 1, 1, -1, -1, -1, 1]


def test_less_than_the_band_is_no_reversal() -> None:
    assert directions([1.0, 0.95, 0.99, 0.91, 0.89, 0.95, 0.98, 1.0], 0.1) == [1, 1, 1, 1, -1, -1, -1, 1]


def test_an_axis_of_unknown_position_has_no_direction_until_it_moves() -> None:
    assert directions([5.0, 5.0, 4.0], 0.1, start=np.nan) == [0, 0, -1]


@given(st.lists(st.integers(-50, 50), min_size=1, max_size=40), st.integers(0, 39))
def test_a_cut_anywhere_leaves_no_trace(places: list[int], cut: int) -> None:
    wanted = np.array([places], dtype=np.float64)
    band = np.full_like(wanted, 3.0)
    whole, far = turnings(wanted, Standing.at(np.zeros(1)), band)
    cut = min(cut, len(places) - 1)
    if cut == 0:
        return
    first, extreme = turnings(wanted[:, :cut], Standing.at(np.zeros(1)), band[:, :cut])
    between = Standing(extreme, first[:, -1], np.zeros(1), np.zeros(1))
    second, end = turnings(wanted[:, cut:], between, band[:, cut:])
    assert np.array_equal(np.concatenate([first, second], axis=1), whole)
    assert end == far


def test_distance_since_the_reversal() -> None:
    way = path([[3.0], [5.0], [4.0], [1.0], [1.5]], [0.0])
    direction = np.array([[1.0, 1.0, -1.0, -1.0, 1.0]])
    still = Standing.at(np.zeros(1))
    since, gone = since_reversal(way, direction, still, np.ones(5), [0])
    assert since[0, 0].tolist() == [FARTHEST, FARTHEST + 3.0, 0.0, 1.0, 0.0]
    assert gone[0, 0].tolist() == [3.0, 2.0, 1.0, 3.0, 0.5]
    turned = Standing(np.zeros(1), -np.ones(1), np.full((3, 1), 7.0), np.zeros(1))
    carried, _ = since_reversal(way, direction, turned, np.ones(5), [0])
    assert carried[0, 0, 0] == 0.0


def test_time_and_path_since_the_reversal_of_each_axis() -> None:
    """X turns back at the third motion, Y at the fourth; C is no way in mm. The fifth takes nobody knows how long."""
    way = path([[3.0, 4.0, 0.0], [6.0, 8.0, 9.0], [3.0, 12.0, 9.0], [0.0, 8.0, 9.0], [0.0, 0.0, 9.0]], [0.0, 0.0, 0.0])
    direction = np.array([[1.0, 1, -1, -1, -1], [1, 1, 1, -1, -1], [0, 1, 1, 1, 1]])
    duration = np.array([1.0, 2.0, 3.0, 4.0, 0.0])
    since, gone = since_reversal(way, direction, Standing.at(np.zeros(3)), duration, [0, 1])
    assert since[1, 0, 2:].tolist() == [0.0, 3.0, 7.0]
    assert since[1, 1, 3:].tolist() == [0.0, 4.0]
    assert since[2, 0, 2:].tolist() == [0.0, 5.0, 10.0]
    assert since[2, 1, 3:].tolist() == [0.0, 5.0]
    assert (since[:, 2] >= FARTHEST).all()
    assert gone[2, 1].tolist() == [5.0, 5.0, 5.0, 5.0, 8.0]
    assert gone[1, 0, :4].tolist() == duration[:4].tolist()
    assert gone[1, 0, 4] == LONG


def test_velocity_has_the_feed_along_the_linear_axes() -> None:
    way = path([[30.0, 40.0, 10.0], [30.0, 40.0, 20.0], [0.0, 0.0, 0.0]], [0.0, 0.0, 0.0], [False, False, True])
    velocity, duration = cruising(way, np.full(3, 600.0), ("X", "Y", "C"))
    assert velocity[:, 0] == pytest.approx([6.0, 8.0, 2.0])
    assert velocity[:, 1] == pytest.approx([0.0, 0.0, 10.0])  # a rotary axis alone: F in deg/min
    assert velocity[:, 2].tolist() == [0.0, 0.0, 0.0]
    assert duration == pytest.approx([5.0, 1.0, 0.0])


def test_only_smooth_passages_keep_their_velocity() -> None:
    velocity = np.array([[10.0, 10.0, 0.0, 0.0], [0.0, 1.0, 10.0, 10.0]])
    owner = np.array([0, 1, 2, 3])
    run = np.array([True, True, False, True])
    found = at_vertices(velocity, owner, run)
    assert found.T.tolist() == [[10.0, 0.5], [0.0, 0.0], [0.0, 0.0]]
    same = at_vertices(velocity, np.zeros(4, dtype=np.int64), np.array([False]))
    assert same.T.tolist() == [[10.0, 0.5], [5.0, 5.5], [0.0, 10.0]]


def test_velocity_rises_over_the_ramp() -> None:
    still, full = np.zeros((1, 1)), np.full((1, 1), 10.0)
    gone = np.array([[[10.0]], [[1.0]], [[20.0]]])
    line = Course(
        direction=np.ones((1, 1)),
        since=np.zeros((3, 1, 1)),
        gone=gone,
        velocity=(still, full, still),
        ramp=ramps(np.ones(1)),
    )
    place = np.array([0.0, 0.5 * RAMP, RAMP, 0.5, 1.0 - 0.5 * RAMP, 1.0])
    at = line.context(np.zeros(6, dtype=np.int64), place, 0.0, 20.0)
    assert at.velocity[0] == pytest.approx([0.0, 5.0, 10.0, 10.0, 5.0, 0.0])
    assert at.since_reversal[0] == pytest.approx(10.0 * place)
    assert at.time_since[0] == pytest.approx(place)
    assert at.path_since[0] == pytest.approx(20.0 * place)
    cut = line.cut(np.zeros(1, dtype=np.int64), np.array([0.25]), np.array([0.75]))
    assert (cut.since[:, 0, 0].tolist(), cut.gone[:, 0, 0].tolist()) == ([2.5, 0.25, 5.0], [5.0, 0.5, 10.0])
