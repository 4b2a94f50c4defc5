"""Readings of a machine with effects against closed forms worked out by hand."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from tests.measurement.command_line import command_line
from tests.measurement.effect_machine import EFFECTS, FloatArray, effect, errors_text, simulated, write_machine
from trueaxis.cli import predict
from trueaxis.io.faults import InputError
from trueaxis.measurement.points import PRIOR_COLUMNS, UNCERTAINTY_COLUMNS

RADIUS, FEED, SIZE = 150.0, 3000.0, 2e-3
ANGLES = np.radians(np.arange(720.0) / 2.0 + 0.4)
SECOND_ORDER = 5e-8  # mm: (1e-2 mm)^2 / 2R / 5


@pytest.fixture(scope="module")
def spec(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_machine(tmp_path_factory.mktemp("machine"))


def circles(
    spec: Path, work: Path, *effects: dict[str, Any], drop: tuple[str, ...] = (), **curves: Any
) -> tuple[FloatArray, FloatArray]:
    """Readings of a circle about the origin run counter-clockwise and clockwise, each by rising polar angle."""
    setup = "".join(
        f'[[run]]\nid = "{name}"\ninstrument = "ballbar"\nlength = {RADIUS}\n'
        'target = { on = "tool", point = [0.0, 0.0, 0.0] }\nreference = { on = "workpiece", point = [0.0, 0.0, 0.0] }\n'
        for name in ("ccw", "cw")
    )
    # half a degree more at the start gives the first sample its direction
    ahead = np.r_[ANGLES[0] - np.radians(0.5), ANGLES]
    behind = np.r_[ANGLES[-1] + np.radians(0.5), ANGLES[::-1]]
    angle = np.r_[ahead, behind]
    count = ahead.size
    columns = {
        "run": ["ccw"] * count + ["cw"] * count,
        "seq": [*range(count)] * 2,
        "X": RADIUS * np.cos(angle),
        "Y": RADIUS * np.sin(angle),
        "Z": np.zeros(2 * count),
        "feed": np.full(2 * count, FEED),
        "time_s": np.arange(2 * count, dtype=float),
        "temperature_c": np.full(2 * count, 21.0),
    }
    columns = {name: values for name, values in columns.items() if name not in drop}
    found = simulated(spec, work, setup, columns, effects, **curves)
    return found[1:count], found[count + 1 :][::-1]


CIRCLES: dict[str, tuple[list[dict[str, Any]], Callable[[FloatArray, float], Any]]] = {
    # theta: polar angle; turn: +1 counter-clockwise. Of y before the motion of Y, EC turns y into -x.
    "squareness": ([effect("squareness", "EC0Y", angle=2e-5)], lambda t, _: -2e-5 * RADIUS / 2 * np.sin(2 * t)),
    # X moves in the direction -turn sgn(sin): what is told by the sign of the approach has it, too
    "backlash of X": (
        [effect("backlash", "EXX", width=SIZE)],
        lambda t, turn: -turn * SIZE / 2 * np.sign(np.sin(t)) * np.cos(t),
    ),
    "backlash of Y": (
        [effect("backlash", "EYY", width=SIZE)],
        lambda t, turn: turn * SIZE / 2 * np.sign(np.cos(t)) * np.sin(t),
    ),
    "lateral play": ([effect("backlash", "EYX", width=SIZE)], lambda t, turn: -turn * SIZE / 2 * np.abs(np.sin(t))),
    "servo lag": (
        [effect("servo_lag", "EXX", tau=3e-5), effect("servo_lag", "EYY", tau=1e-5)],
        lambda t, turn: turn * FEED / 60 * 2e-5 / 2 * np.sin(2 * t),
    ),
    "equal servo lags do not show": (
        [effect("servo_lag", "EXX", tau=3e-5), effect("servo_lag", "EYY", tau=3e-5)],
        lambda t, _: np.zeros_like(t),
    ),
    "length": ([effect("ballbar_length", length=SIZE)], lambda t, _: np.full_like(t, SIZE)),
    "lobes": ([effect("ballbar_lobes", amplitude=SIZE, phase=0.3)], lambda t, _: SIZE * np.cos(3 * t + 0.3)),
    "zero of one run": ([effect("reading_zero", zero=SIZE)], lambda t, turn: (turn > 0) * np.full_like(t, SIZE)),
    "centre of one run": (
        [effect("ballbar_centre", x=SIZE, y=-3e-3, z=0.0)],
        lambda t, turn: (turn > 0) * (3e-3 * np.sin(t) - SIZE * np.cos(t)),
    ),
    "a kind of its own": (
        [effect("table_sag", "EXX", sag=1e-2)],
        lambda t, _: 1e-2 * (s := (RADIUS * np.cos(t) + 300.0) / 800.0) * (1 - s) * np.cos(t),
    ),
}


@pytest.mark.parametrize("name", CIRCLES)
def test_circles_by_ball_bar(spec: Path, tmp_path: Path, name: str) -> None:
    effects, closed_form = CIRCLES[name]
    for turn, found in zip((1.0, -1.0), circles(spec, tmp_path, *effects), strict=True):
        np.testing.assert_allclose(found, closed_form(ANGLES, turn), rtol=0, atol=SECOND_ORDER)


def test_bow_and_effects_add_up_on_a_circle(spec: Path, tmp_path: Path) -> None:
    bow = 5e-8
    found = circles(spec, tmp_path, effect("backlash", "EYX", width=SIZE), EYX=(0.0, bow))
    bowed, play = bow * RADIUS**2 / 4 * (np.sin(ANGLES) + np.sin(3 * ANGLES)), SIZE / 2 * np.abs(np.sin(ANGLES))
    for turn, readings in zip((1.0, -1.0), found, strict=True):
        np.testing.assert_allclose(readings, (bowed - turn * play), rtol=0, atol=SECOND_ORDER)


def test_a_reversal_spike_dies_away_over_its_way(spec: Path, tmp_path: Path) -> None:
    ccw, _ = circles(spec, tmp_path, effect("reversal_spike", "EXX", height=SIZE, decay=5.0))
    x = RADIUS * np.cos(ANGLES)
    at = np.searchsorted(ANGLES, np.pi)  # first sample behind the reversal at 180 degrees
    expected = SIZE * np.exp(-(x[at : at + 40] + RADIUS) / 5.0) * np.cos(ANGLES[at : at + 40])
    np.testing.assert_allclose(ccw[at : at + 40], expected, rtol=0, atol=SECOND_ORDER)
    np.testing.assert_allclose(ccw[:40], expected, rtol=0, atol=SECOND_ORDER)  # the circle has begun before 0 degrees
    assert abs(ccw[at - 20 : at]).max() < 1e-8 * SIZE


@pytest.mark.parametrize("kind", ["reversal_spike_time", "reversal_spike_path"])
@pytest.mark.parametrize("told", ["time_s", "feed"])
def test_a_spike_over_time_or_path_dies_away_with_the_arc(spec: Path, tmp_path: Path, kind: str, told: str) -> None:
    """R times the angle since the reversal of X, at 50 mm/s: times of a second per sample are what they say."""
    parameters = {"height": SIZE, "tau": 0.3} if kind == "reversal_spike_time" else {"height": SIZE, "decay": 15.0}
    drop = ("feed",) if told == "time_s" else ("time_s",)
    ccw, _ = circles(spec, tmp_path, effect(kind, "EXX", **parameters), drop=drop)
    at = np.searchsorted(ANGLES, np.pi)
    step = np.radians(0.5) * RADIUS
    samples = np.degrees(ANGLES[at : at + 40] - np.pi) / 0.5  # since 180 degrees, between two of them
    arc = 2.0 * RADIUS * np.sin(np.radians(0.25)) * samples  # along the chords
    passed = arc if kind == "reversal_spike_path" else (samples if told == "time_s" else arc / 50.0)
    over = parameters.get("tau", parameters.get("decay", 0.0))
    expected = SIZE * np.exp(-passed / over) * np.cos(ANGLES[at : at + 40])
    np.testing.assert_allclose(ccw[at : at + 40], expected, rtol=0, atol=SECOND_ORDER)
    np.testing.assert_allclose(ccw[:40], expected, rtol=0, atol=SECOND_ORDER)  # the circle has begun before 0 degrees
    assert abs(ccw[at - 20 : at]).max() < 1e-8 * SIZE
    assert step == pytest.approx(arc[1] - arc[0], rel=1e-4)


def test_a_spike_over_time_needs_times_or_a_feed(spec: Path, tmp_path: Path) -> None:
    spike = effect("reversal_spike_time", "EXX", height=SIZE, tau=0.3)
    with pytest.raises(InputError, match=r"column time_s \(or, by ball bar, feed\).*reversal_spike_time EXX"):
        circles(spec, tmp_path, spike, drop=("time_s", "feed"))
    for readings in line(spec, tmp_path, spike, drop="time_s").values():
        np.testing.assert_array_equal(readings, 0.0)  # over when the axis stands


HOME = -100.0
THERE = np.array([-100.0, 0.0, 133.0, 400.0, 401.0])
X = np.r_[THERE, THERE[:-1][::-1]]
DIRECTION = np.r_[0.0, np.ones(4), -np.ones(4)]
TIME = 50.0 + 7.0 * np.arange(9)
WARM = 21.0 + 0.3 * np.arange(9)


def line(spec: Path, work: Path, *effects: dict[str, Any], drop: str = "", **curves: Any) -> dict[str, FloatArray]:
    """Readings of a laser line along X there and back, by a run that effects name and by one that they do not."""
    setup = "".join(
        f'[[run]]\nid = "{name}"\ninstrument = "laser"\ndirection = [1.0, 0.0, 0.0]\nhome = {{ X = {HOME} }}\n'
        'target = { on = "tool", point = [0.0, 50.0, 0.0] }\n'
        for name in ("X1", "X2")
    )
    columns: dict[str, Any] = {"run": ["X1"] * 9 + ["X2"] * 9, "seq": [*range(9)] * 2, "X": [*X] * 2}
    columns |= {"Y": [200.0] * 18, "Z": [0.0] * 18, "time_s": [*TIME] * 2, "temperature_c": [*WARM] * 2}
    columns.pop(drop, None)
    shuffled = np.random.default_rng(3).permutation(18)
    found = np.empty(18)
    rows = pl.DataFrame(columns)[shuffled].to_dict(as_series=False)
    found[shuffled] = simulated(spec, work, setup, rows, effects, **curves)
    return {"X1": found[:9], "X2": found[9:]}


SHARE, HOME_SHARE = (X + 300.0) / 800.0, (HOME + 300.0) / 800.0
Hand = Mapping[str, tuple[list[dict[str, Any]], FloatArray]]
LINES: Hand = {
    "backlash": ([effect("backlash", "EXX", width=SIZE)], SIZE / 2 * DIRECTION),
    "cyclic": (
        [effect("cyclic", "EXX", amplitude=SIZE, phase=0.7, pitch=17.0)],
        SIZE * (np.cos(2 * np.pi * X / 17 + 0.7) - np.cos(2 * np.pi * HOME / 17 + 0.7)),
    ),
    "thermal expansion": (
        [effect("thermal_expansion", "EXX", coefficient=1e-5)],
        1e-5 * (X * (WARM - 20) - HOME * (WARM[0] - 20)),
    ),
    "warm-up": (
        [effect("warm_up", "EXX", amplitude=SIZE, tau=30.0)],
        SIZE * (SHARE * np.exp(-TIME / 30) - HOME_SHARE * np.exp(-TIME[0] / 30)),
    ),
    "drift": ([effect("drift", "EXX", rate=1e-4)], 1e-4 * (TIME - TIME[0])),
    "reversal spike": (
        [effect("reversal_spike", "EXX", height=SIZE, decay=100.0)],
        # from home on as if it had turned there, and from where it turns back
        SIZE * np.r_[0.0, np.exp(-(X[1:5] - HOME) / 100.0), -np.exp(-(401.0 - X[5:]) / 100.0)],
    ),
    "reversal spike over time": (
        [effect("reversal_spike_time", "EXX", height=SIZE, tau=20.0)],
        # nobody knows since when it stands at home: nothing is left of that reversal
        SIZE * np.r_[np.zeros(5), -np.exp(-(TIME[5:] - TIME[4]) / 20.0)],
    ),
    "reversal spike over the path": (
        [effect("reversal_spike_path", "EXX", height=SIZE, decay=100.0)],
        SIZE * np.r_[0.0, np.exp(-(X[1:5] - HOME) / 100.0), -np.exp(-(401.0 - X[5:]) / 100.0)],
    ),
    "servo lag of standing axes": ([effect("servo_lag", "EXX", tau=1e-3)], np.zeros(9)),
    "cross axis": (
        # home has Y = 0, the line Y = 200
        [effect("cross_axis", "EXX", k=SIZE)],
        SIZE * (SHARE * (500 / 800) ** 2 - HOME_SHARE * (300 / 800) ** 2),
    ),
    "scale of the laser": ([effect("laser_scale", k=1e-5)], 1e-5 * (X - HOME)),
}
OF_ONE_RUN: Hand = {
    "cosine": ([effect("laser_cosine", angle=3e-3)], -(3e-3**2) / 2 * (X - HOME)),
    "zero": ([effect("reading_zero", zero=SIZE)], np.full(9, SIZE)),
    "slope": ([effect("reading_slope", slope=3e-5)], 3e-5 * (X - HOME)),
    "step": ([effect("laser_step", jump=SIZE, t_0=72.0)], np.where(np.arange(9) > 3, SIZE, 0.0)),
}


@pytest.mark.parametrize("name", LINES)
def test_lines_by_laser(spec: Path, tmp_path: Path, name: str) -> None:
    effects, by_hand = LINES[name]
    for found in line(spec, tmp_path, *effects).values():
        np.testing.assert_allclose(found, by_hand, rtol=0, atol=1e-14)


@pytest.mark.parametrize("name", OF_ONE_RUN)
def test_effects_of_a_run_are_in_its_readings_alone(spec: Path, tmp_path: Path, name: str) -> None:
    effects, by_hand = OF_ONE_RUN[name]
    found = line(spec, tmp_path, *effects)
    np.testing.assert_allclose(found["X1"], by_hand, rtol=0, atol=1e-14)
    assert not found["X2"].any()


def test_a_point_that_is_off_has_its_lever(spec: Path, tmp_path: Path) -> None:
    yaw = 1e-7
    found = line(spec, tmp_path, effect("point_offset", x=1.0, y=4.0, z=-2.0), ECX=(yaw,))
    # about the X slide the target is at Y + its own y; at home Y = 0
    for run, lever in (("X1", 54.0), ("X2", 50.0)):
        np.testing.assert_allclose(found[run], -yaw * (X * (200.0 + lever) - HOME * lever), rtol=0, atol=1e-14)


@pytest.mark.parametrize(
    ("drop", "effects", "column"),
    [
        ("time_s", [effect("drift", "EXX", rate=1e-4), effect("warm_up", "EXX", amplitude=1e-3, tau=9.0)], "time_s"),
        ("temperature_c", [effect("thermal_expansion", "EXX", coefficient=1e-5)], "temperature_c"),
        ("time_s", [effect("laser_step", jump=1e-3, t_0=9.0)], "time_s"),
    ],
)
def test_a_column_that_effects_lack_is_named_once(
    spec: Path, tmp_path: Path, drop: str, effects: list[dict[str, Any]], column: str
) -> None:
    with pytest.raises(InputError) as caught:
        line(spec, tmp_path, *effects, drop=drop)
    (fault,) = caught.value.faults
    assert fault.place == f"column {column}"
    assert 'run "X1"' in fault.problem
    for one in effects:
        assert one["kind"] in fault.remedy
    assert not (tmp_path / "out").exists()


def test_effects_of_zero_need_no_columns(spec: Path, tmp_path: Path) -> None:
    assert not np.any([*line(spec, tmp_path, drop="time_s").values()])


def test_a_lag_on_circles_needs_a_feed_or_times(spec: Path, tmp_path: Path) -> None:
    bar = (
        f'[[run]]\nid = "c"\ninstrument = "ballbar"\nlength = {RADIUS}\ntarget = {{ on = "tool", point = [0, 0, 0] }}\n'
    )
    bar += 'reference = { on = "workpiece", point = [0, 0, 0] }\n'
    columns = {"run": ["c"] * 720, "seq": [*range(720)], "X": RADIUS * np.cos(ANGLES), "Y": RADIUS * np.sin(ANGLES)}
    columns["Z"] = np.zeros(720)
    lag = effect("servo_lag", "EXX", tau=1e-4)
    with pytest.raises(InputError, match=r"column feed \(or time_s\).*row 0 of run \"c\".*servo_lag EXX"):
        simulated(spec, tmp_path, bar, columns, [lag])
    columns["time_s"] = ANGLES * RADIUS / 50.0  # 50 mm/s along the circle
    found = simulated(spec, tmp_path, bar, columns, [lag])
    np.testing.assert_allclose(found, 50.0 * 1e-4 / 2 * np.sin(2 * ANGLES), rtol=0, atol=1e-6)


def test_predict_in_the_context_of_the_points(spec: Path, tmp_path: Path) -> None:
    effects = [effect("backlash", "EXX", width=SIZE), effect("thermal_expansion", "EXX", coefficient=1e-5)]
    (tmp_path / "errors.json").write_text(errors_text([*effects, effect("laser_scale", k=1.0)]))
    at, out = tmp_path / "points.csv", tmp_path / "out.csv"
    files = ("--errors", tmp_path / "errors.json", "--at", at, "--out", out)
    at.write_text("X,Y,Z,dir_X,temperature_c\n100,0,0,1,22\n100,0,0,-1,19\n100,0,0,,20\n")
    assert command_line(predict, spec, spec.parent / "generated", *files) == 0
    found = pl.read_csv(out)
    assert found.columns == [
        *("X", "Y", "Z", "dir_X", "temperature_c", "dx", "dy", "dz"),
        *UNCERTAINTY_COLUMNS,
        *PRIOR_COLUMNS,
    ]
    assert found["dir_X"].to_list() == [1.0, -1.0, None]
    np.testing.assert_allclose(found["dx"], [1e-3 + 2e-3, -1e-3 - 1e-3, 0.0], rtol=0, atol=1e-15)
    at.write_text("X,Y,Z,temperature_c\n100,0,0,22\n100,0,0,\n")
    with pytest.raises(InputError, match=r"column temperature_c: is not known at point 2.*thermal_expansion EXX"):
        command_line(predict, spec, spec.parent / "generated", *files)
    at.write_text("X,Y,Z,dir_X\n100,0,0,2\n")
    with pytest.raises(InputError, match="is not a direction"):
        command_line(predict, spec, spec.parent / "generated", *files)


def test_a_squareness_is_told_once(spec: Path, tmp_path: Path) -> None:
    tree = json.loads(errors_text([effect("squareness", "EC0Y", angle=1e-5)])) | {"parameters": {"EC0Y": 1e-5}}
    (tmp_path / "errors.json").write_text(json.dumps(tree))
    (tmp_path / "points.csv").write_text("X,Y,Z\n100,0,0\n")
    files = ("--errors", tmp_path / "errors.json", "--at", tmp_path / "points.csv", "--out", tmp_path / "out.csv")
    with pytest.raises(InputError, match=r"parameters\.EC0Y: is told by the effect squareness EC0Y as well"):
        command_line(predict, spec, spec.parent / "generated", *files)


def test_every_kind_of_place_is_on_the_machine() -> None:
    assert {one["kind"] for one in EFFECTS} >= {"backlash", "laser_step", "point_offset", "squareness", "table_sag"}


def test_a_sensor_at_one_pose_reads_what_time_and_temperature_do_there(spec: Path, tmp_path: Path) -> None:
    setup = (
        '[[run]]\nid = "warm"\ninstrument = "displacement"\ndirection = [1.0, 0.0, 0.0]\n'
        'target = { on = "tool", point = [0.0, 0.0, 0.0] }\nhome = { X = 100.0, Y = 50.0, Z = 0.0 }\n'
    )
    time = np.arange(0.0, 3600.0, 300.0)
    columns = {
        "run": ["warm"] * time.size, "seq": list(range(time.size)), "X": np.full(time.size, 100.0),
        "Y": np.full(time.size, 50.0), "Z": np.zeros(time.size), "time_s": time,
        "temperature_c": 20.0 + time / 1800.0,
    }  # fmt: skip
    drift, growth = effect("drift", "EXX", rate=1e-6), effect("thermal_expansion", "EXX", coefficient=1e-5)
    assert np.allclose(simulated(spec, tmp_path, setup, columns, [drift]), 1e-6 * time, atol=1e-12)
    found = simulated(spec, tmp_path, setup, columns, [growth], EXX=[2e-5])
    assert np.allclose(
        found, 1e-5 * 100.0 * time / 1800.0, atol=1e-12
    )  # since the run began; its curve cancels at home
