"""The context of readings, against sequences worked out by hand."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from tests.generator.dmu60p import dmu60p
from tests.measurement.adapter import GeneratorModel
from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.context import context_of, path_velocity
from trueaxis.measurement.reading_effects import polar_angle, reading_context_of
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.reversals import (
    beside_reversals,
    distance_since,
    duration_by_feed,
    reversals_of_standing,
    reversals_on_the_way,
    time_since,
)
from trueaxis.measurement.setup import PointOn, Run

INF, NAN = np.inf, np.nan
AXES = ("X", "Y", "Z")
HOME = {"X": 0.0, "Y": 0.0, "Z": 0.0}


def laser(run_id: str, direction: Any = (1.0, 0.0, 0.0), **home: float) -> Run:
    return Run(
        id=run_id,
        instrument="laser",
        target=PointOn("tool"),
        reference=PointOn("bed"),
        frame="bed",
        home={**HOME, **home},
        direction=direction,
    )


def bar(run_id: str) -> Run:
    return Run(
        id=run_id,
        instrument="ballbar",
        target=PointOn("tool"),
        reference=PointOn("workpiece"),
        frame="bed",
        home=HOME,
        direction=None,
        length=100.0,
    )


def readings(runs: tuple[Run, ...], paths: list[Any], **columns: Any) -> Readings:
    """One path (3, n) per run; columns of all rows in their order."""
    run = np.repeat(np.arange(len(paths)), [len(path[0]) for path in paths])
    seq = np.concatenate([np.arange(len(path[0])) for path in paths])
    positions = np.concatenate([np.array(path, dtype=float) for path in paths], axis=1)
    directions = np.concatenate(
        [
            approach_directions(one, AXES, np.arange(len(path[0])), np.array(path, dtype=float))
            for path, one in zip(paths, runs, strict=True)
        ],
        axis=1,
    )
    given: dict[str, Any] = {name: np.array(values, dtype=float) for name, values in columns.items()}
    ids = tuple(one.id for one in runs)
    return Readings(
        axes=AXES,
        run_ids=ids,
        run=run,
        seq=seq,
        positions=positions,
        directions=directions,
        reading=np.zeros(run.size),
        **given,
    )


THERE_AND_BACK = [[0, 10, 30, 30, 20, 20, 0, 5], [0, 0, 0, 1, 1, 1, 1, 1], [7, 7, 7, 7, 7, 7, 7, 7]]


def test_the_way_since_a_reversal_starts_where_the_axis_turned_and_a_dwell_adds_nothing() -> None:
    runs = (laser("a"), laser("b", X=3.0))
    context = context_of(runs, readings(runs, [THERE_AND_BACK, [[2, 1, 4], [0] * 3, [0] * 3]]))
    assert context.since_reversal[0].tolist() == [INF, 10, 30, 30, 10, 10, 30, 5, 0, 1, 3]
    assert context.since_reversal[1].tolist() == [INF] * 3 + [1] * 5 + [INF] * 3
    assert context.directions[0].tolist() == [0, 1, 1, 1, -1, -1, -1, 1, -1, -1, 1]
    assert context.directions[2].tolist() == [1] * 8 + [0] * 3
    assert context.home is not None
    assert (context.home.directions == 0).all()
    assert (context.home.since_reversal == INF).all()


def test_time_and_path_since_a_reversal_are_of_each_axis() -> None:
    """By ball bar X turns back at row 2, Y at row 3; the path is that of both."""
    path = [[0, 3, 6, 3, 0, -3.0], [0, 4, 8, 12, 8, 4.0], [0] * 6]
    runs = (bar("a"), laser("b"))
    time = [5.0, 6, 8, 9, 11, 14]
    for feed, known in ([NAN] * 6, time), ([300.0] * 6, [NAN] * 6), ([300.0] * 6, [5.0, 6, NAN, 9, 11, 14]):
        found = context_of(runs, readings(runs, [path, path], time=known * 2, feed=feed * 2))
        assert found.path_since[0, :6].tolist() == [INF, INF, INF, 5, 10, 15]
        assert found.path_since[1, :6].tolist() == [INF, INF, INF, INF, 5, 10]
        by_feed = [INF, INF, INF, 1, 2, 3]  # 5 mm at 5 mm/s
        told = found.time_since[0, :6].tolist()
        assert told == ([INF, INF, INF, 1, 3, 6] if known is time else by_feed)
        assert found.time_since[1, 4:6].tolist() == ([1, 2] if np.isnan(known[3]) else [2, 5])
        # laser: a run begins with a reversal beyond its first target, since nobody knows when; axes stand in between
        assert found.path_since[0, 6:].tolist() == [INF, 5, 10, 5, 10, 15]
        assert np.isinf(found.time_since[0, 6:9]).all()
        # nor how long they have stood, without times: longer than what passes within seconds
        assert found.time_since[0, 9:].tolist() == ([INF] * 3 if np.isnan(known[2]) else [1, 3, 6])
        assert found.home is not None
        assert (found.home.time_since == INF).all()


@pytest.mark.parametrize("start", [2.003, 2.009, 2.0159])
@pytest.mark.parametrize("gap", [0.0, 0.08])
def test_a_ball_bar_turns_between_readings_where_the_circle_has_it(start: float, gap: float) -> None:
    """Of a circle of 100 mm at 50 mm/s, arc and time since X was at its end at pi are known; wherever its samples are,
    and where those next to it are left out on both sides.
    """
    angle = np.arange(start, 4.3, 0.02)
    angle = angle[np.abs(angle - np.pi) > gap]
    path = [100.0 * np.cos(angle), 100.0 * np.sin(angle), np.zeros(angle.size)]
    given = readings((bar("a"),), [path], time=2.0 * angle, feed=np.full(angle.size, 3000.0))
    found = context_of(
        (bar("a"),), replace(given, directions=np.sign([np.sin(angle) * -1.0, np.cos(angle), 0 * angle]))
    )
    later = angle > np.pi
    arc = 100.0 * (angle[later] - np.pi)
    near = 0.01 + 100.0 * (2.0 * gap) ** 3 / 24.0  # mm, of a chord over the gap in place of its arc
    np.testing.assert_allclose(found.path_since[0, later], arc, atol=near)
    np.testing.assert_allclose(found.time_since[0, later], arc / 50.0, atol=0.01 / 50.0)
    np.testing.assert_allclose(found.since_reversal[0, later], 100.0 * (1.0 + np.cos(angle[later])), atol=0.01)


@pytest.mark.parametrize("seed", range(40))
def test_only_samples_at_a_reversal_have_a_direction_that_is_anybodys_choice(seed: int) -> None:
    """Of two laps of a circle: those that an axis takes within 1 um of where it turns have the direction before or
    after by chance. They are found; those that are 0.1 mm from there or farther are not.
    """
    source = np.random.default_rng(seed)
    count, radius = int(source.integers(9, 500)), float(source.uniform(30.0, 300.0))
    start = float(source.choice([0.0, 0.25, source.uniform(0.0, 1.0)]))  # on a reversal, or anywhere
    angle = 2.0 * np.pi * (start + np.arange(2 * count) / count) * source.choice([-1.0, 1.0])
    path = radius * np.array([np.cos(angle), np.sin(angle)])
    slope = np.sign(angle[-1] - angle[0]) * np.array([-np.sin(angle), np.cos(angle)])
    off = radius - np.abs(path)  # from where the axis turns
    chosen = np.where(off < 1e-3, source.choice([-1.0, 1.0], path.shape), np.sign(slope))
    found = beside_reversals(("X", "Y"), chosen, path, 2e-3)
    wrong = (chosen * slope < 0.0).any(axis=0)
    wrong[-1] = False  # what is beyond the end of a run, the run does not show
    wrong[0] = (off[:, 0] < 1e-3).any()  # a run is taken to have begun earlier
    assert found[wrong].all()
    apart = np.min(off, axis=0) > 0.1
    assert not (found & apart)[2:-2].any()


def test_where_the_path_does_not_show_a_reversal_both_samples_beside_it_are_doubtful() -> None:
    """X goes on for two samples after its direction has changed."""
    path = np.array([np.arange(12.0), 0.1 * np.arange(3.0, 15.0) ** 2])
    directions = np.array([np.where(np.arange(12) < 6, 1.0, -1.0), np.ones(12)])
    assert np.flatnonzero(beside_reversals(("X", "Y"), directions, path, 2e-3)).tolist() == [5, 6]


@pytest.mark.parametrize("count", [8, 12, 36, 100])
def test_an_axis_that_turns_halfway_between_two_samples_is_seen_to(count: int) -> None:
    """There its velocity along the chord is zero, or what rounding leaves of it."""
    angle = 2.0 * np.pi * (np.arange(2 * count) + 0.5) / count
    path = 100.0 * np.array([np.cos(angle), np.sin(angle)])
    directions = np.sign([-np.sin(angle), np.cos(angle)])
    turned = reversals_on_the_way(("X", "Y"), directions, path)
    np.testing.assert_allclose(turned.share[turned.row > 0], 0.5, atol=1e-6)
    assert not beside_reversals(("X", "Y"), directions, path, 2e-3)[:-2].any()


def test_nothing_tells_the_time_since_a_reversal_while_a_table_turns_alone() -> None:
    axes = ("X", "C")
    path = np.array([[0, 0, 0, 5.0], [0, 10, 5, 5.0]])
    duration = duration_by_feed(axes, path, np.full(4, 600.0))
    assert np.isnan(duration).tolist() == [False, True, True, False]
    turned = reversals_on_the_way(axes, np.array([[0, 0, 0, 1.0], [0, 1, -1, -1]]), path)
    found = time_since(turned, np.full(4, NAN), duration)
    assert np.isnan(found[1, 2:]).all()
    assert (found[0] == INF).all()


def test_directions_that_are_given_turn_the_axis_where_they_change() -> None:
    given = np.array([[1, 0, -1, -1, 1.0]])
    path = np.array([[5, 9, 9, 8, 8.0]])
    # 0 says nothing; the target at 9 is approached from both sides, the one at 8, too
    assert distance_since(reversals_of_standing(given, path), path).tolist() == [[0, 4, 0, 1, 0]]


def test_an_axis_that_comes_back_to_a_target_from_the_same_side_has_turned_beyond_it() -> None:
    path, given = np.array([[0, 30, 60, 0, 30, 60.0]]), np.ones((1, 6))
    assert distance_since(reversals_of_standing(given, path), path).tolist() == [[0, 30, 60, 0, 30, 60]]
    both = np.array([[1, 1, -1, -1, 1, 1.0]])  # poses of a target from both sides
    path = np.array([[0, 10, 10, 20, 20, 30.0]])
    assert distance_since(reversals_of_standing(both, path), path).tolist() == [[0, 10, 0, 0, 0, 10]]


@pytest.mark.parametrize("start", [-0.293, -0.053, 0.0, 0.004, 0.05])
def test_an_arc_has_begun_before_its_first_reading(start: float) -> None:
    """X turns at 0: where the arc begins past that, it has turned as on the circle that leads there."""
    angle = np.arange(0.01 + start, 1.4, 0.02)
    path = [100.0 * np.cos(angle), 100.0 * np.sin(angle), np.zeros(angle.size)]
    found = context_of((bar("a"),), readings((bar("a"),), [path], time=2.0 * angle, feed=np.full(angle.size, 3000.0)))
    past = angle > 0.0
    np.testing.assert_allclose(found.path_since[0, past], 100.0 * angle[past], atol=0.02)
    np.testing.assert_allclose(found.time_since[0, past], 2.0 * angle[past], atol=4e-4)
    np.testing.assert_allclose(found.since_reversal[0, past], 100.0 * (1.0 - np.cos(angle[past])), atol=0.02)


def test_an_order_of_rows_changes_nothing() -> None:
    runs = (laser("a"), bar("b"))
    angle = np.linspace(0.0, 5.0, 40)
    whole = readings(
        runs,
        [THERE_AND_BACK, [100 * np.cos(angle), 100 * np.sin(angle), 0 * angle]],
        time=np.arange(48.0),
        feed=np.full(48, 600.0),
        temperature=20 + np.arange(48.0),
    )
    shuffled = np.random.default_rng(1).permutation(48)
    cut = {name: getattr(whole, name)[..., shuffled] for name in ("run", "seq", "positions", "directions", "reading")}
    cut |= {name: getattr(whole, name)[shuffled] for name in ("time", "feed", "temperature")}
    one, other = context_of(runs, whole).of(shuffled), context_of(runs, replace(whole, **cut))
    for name in ("directions", "velocity", "since_reversal", "time_since", "path_since", "time", "temperature"):
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name), err_msg=name)
    assert one.home is not None
    assert other.home is not None
    np.testing.assert_array_equal(one.home.time, other.home.time)


def test_home_has_time_and_temperature_of_the_first_row_of_its_run() -> None:
    runs = (laser("a"), laser("b"))
    three = [[1, 2, 3], [0] * 3, [0] * 3]
    rows = readings(runs, [three, three], time=[5, 6, 7, 90, 91, 92], temperature=[20, 21, 22, NAN, 24, 25])
    home = context_of(runs, rows).home
    assert home is not None
    assert home.time.tolist() == [5, 5, 5, 90, 90, 90]
    np.testing.assert_array_equal(home.temperature, [20, 20, 20, NAN, NAN, NAN])


def test_what_no_column_tells_is_unknown_but_axes_that_stand_have_no_velocity() -> None:
    runs = (laser("a"), bar("b"))
    context = context_of(runs, readings(runs, [[[1, 2], [0, 0], [0, 0]]] * 2))
    assert np.isnan(context.time).all()
    assert np.isnan(context.temperature).all()
    assert not context.velocity[:, :2].any()
    assert np.isnan(context.velocity[:, 2:]).all()


@pytest.mark.parametrize("told", ["feed", "time"])
@pytest.mark.parametrize("seed", range(4))
def test_velocities_beside_a_gap_are_along_the_tangent_too(told: str, seed: int) -> None:
    """Of samples that are left out here and there, at the ends of the run as well."""
    kept = np.random.default_rng(seed).random(381) < 0.7
    angle = np.linspace(0.2, 4.0, 381)[kept]
    path = 50.0 * np.array([np.cos(angle), np.sin(angle), 0 * angle])
    feed = np.full(angle.size, 1800.0 if told == "feed" else NAN)
    time = angle * 50.0 / 30.0 if told == "time" else np.full(angle.size, NAN)
    by_hand = 30.0 * np.array([-np.sin(angle), np.cos(angle), 0 * angle])
    assert np.abs(path_velocity(AXES, path, feed, time) - by_hand).max() < 0.03


@pytest.mark.parametrize("turn", [1.0, -1.0])
@pytest.mark.parametrize("told", ["feed", "time"])
def test_velocities_on_a_circle_are_along_its_tangent(turn: float, told: str) -> None:
    angle = turn * np.linspace(0.2, 4.0, 381)
    path = 50.0 * np.array([np.cos(angle), np.sin(angle), 0 * angle])
    feed = np.full(381, 1800.0 if told == "feed" else NAN)
    time = np.abs(angle) * 50.0 / 30.0 if told == "time" else np.full(381, NAN)
    by_hand = 30.0 * turn * np.array([-np.sin(angle), np.cos(angle), 0 * angle])
    found = path_velocity(AXES, path, feed, time)
    np.testing.assert_allclose(found, by_hand, rtol=0, atol=30 * 0.01**2)  # steps of 0.01 rad; ends included
    np.testing.assert_allclose(np.linalg.norm(found, axis=0), 30.0, rtol=1e-12 if told == "feed" else 1e-4)


def test_a_feed_is_that_of_the_linear_axes_and_turning_axes_keep_their_time() -> None:
    path = np.array([[0, 3, 6.0], [0, 4, 8.0], [0, 0, 0], [0, 1, 2.0]])
    found = path_velocity(("X", "Y", "Z", "C"), path, np.full(3, 600.0), np.full(3, NAN))
    np.testing.assert_allclose(found, np.repeat([[6.0], [8.0], [0.0], [2.0]], 3, axis=1), rtol=1e-14)
    alone = path_velocity(("X", "C"), path[[2, 3]], np.full(3, 600.0), np.full(3, NAN))
    assert np.isnan(alone).all()  # a feed in mm/min tells nothing of an axis that turns alone


def test_while_a_table_turns_the_times_tell_velocities() -> None:
    """The feed may be that of the tool over the table, on which it stands still as both turn about one centre."""
    angle = np.linspace(0.0, 1.0, 201)
    path = np.array([80.0 * np.cos(angle), 80.0 * np.sin(angle), 0.0 * angle, np.degrees(angle)])
    found = path_velocity(("X", "Y", "Z", "C"), path, np.full(201, 600.0), 4.0 * angle)
    np.testing.assert_allclose(np.linalg.norm(found[:3], axis=0), 20.0, rtol=1e-4)
    np.testing.assert_allclose(found[3], np.degrees(0.25), rtol=1e-12)


@pytest.mark.parametrize("feed", [0.0, 600.0, NAN])
def test_a_path_that_stands_or_turns_back(feed: float) -> None:
    path = np.array([[0, 0, 0, 1, 0.0], [0] * 5, [0] * 5])
    found = path_velocity(AXES, path, np.full(5, feed), np.full(5, NAN))
    if feed > 0:
        assert found[0, 1] == 0.0
        assert found[0, 3] == 0.0
        assert found[0, 2] == 10.0
    else:
        assert np.isnan(found).all()


@pytest.mark.parametrize(("axes", "one", "other"), [("XY", 0, 1), ("YZ", 1, 2), ("ZX", 2, 0)], ids=["XY", "YZ", "ZX"])
def test_polar_angles_are_right_handed_in_their_plane(axes: str, one: int, other: int) -> None:
    angle = np.linspace(-3.0, 3.0, 50)
    vectors = np.full((3, 50), 12.0)  # a constant height over the plane, as of a cone
    vectors[one], vectors[other] = 80 * np.cos(angle), 80 * np.sin(angle)
    np.testing.assert_allclose(polar_angle(vectors), angle, atol=1e-14)


def test_a_tilted_circle_is_seen_along_the_axis_of_its_least_extent() -> None:
    angle = np.linspace(0.0, 6.0, 100)
    tilted = 80 * np.array([np.cos(angle) * np.cos(0.3), np.sin(angle), np.cos(angle) * np.sin(0.3)])
    np.testing.assert_allclose(polar_angle(tilted), np.arctan2(tilted[1], tilted[0]), atol=1e-14)
    assert polar_angle(np.array([[0.0], [5.0], [1.0]]))[0] == pytest.approx(np.pi / 2)


@pytest.mark.parametrize(("bar", "angle"), [((0.0, 100.0, 0.0), np.pi / 2), ((0.0, 0.0, 100.0), 0.0)])
def test_a_bar_that_stands_still_on_a_turning_table_has_one_polar_angle(
    bar: tuple[float, float, float], angle: float
) -> None:
    """Positions are rounded: what is left of its motion has no direction to speak of."""
    rounding = np.random.default_rng(1).uniform(-1e-6, 1e-6, (3, 90))
    found = polar_angle(np.array(bar)[:, np.newaxis] + rounding)
    assert found == pytest.approx(angle, abs=1e-6)
    assert np.ptp(found) == 0.0


def test_what_is_sensed_since_home_and_the_polar_angle_of_several_runs() -> None:
    model = GeneratorModel(dmu60p({}, {}))
    diagonal = laser("d", (0.6, 0.0, 0.8), X=10.0, Z=20.0)
    circle = bar("c")
    rows = readings(
        (diagonal, circle), [[[10, 20, 10], [0, 5, 5], [20, 20, 25]], [[3, 0, -3], [0, 0, 0], [400, 403, 400]]]
    )
    shuffled = np.array([3, 1, 5, 0, 4, 2])
    rows = replace(rows, run=rows.run[shuffled], seq=rows.seq[shuffled], positions=rows.positions[:, shuffled])
    found = reading_context_of(model, (diagonal, circle), rows)
    # the tool stands still over Y, which carries the workpiece
    np.testing.assert_allclose(found.along, [NAN, 6.0, NAN, 0.0, NAN, 4.0], atol=1e-12)
    ball = model.view_ideal("tool_in_workpiece", rows.positions, np.zeros((3, 1)))
    expected = np.arctan2(ball[0], ball[2])
    np.testing.assert_allclose(found.theta[[0, 2, 4]], expected[[0, 2, 4]], atol=1e-12)
    assert np.isnan(found.theta[[1, 3, 5]]).all()
