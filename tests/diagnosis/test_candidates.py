"""Which causes are searched for, counted by hand for four campaigns, and that grids stay within bounds."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SMALL, field, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.candidates import candidates, grid_of
from trueaxis.diagnosis.causes.search import WORTH_ZOOMING
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.effects.kind import Effect
from trueaxis.estimation.effects.grids import OF_DIAGNOSIS, Covered
from trueaxis.estimation.effects.grids import grid_of as grid_of_covered


def found(design: Design, machine: str = "table_mill") -> tuple[Effect, ...]:
    where = field(design, machine=machine)
    return candidates(where.readings.model, where.readings.rows)


def test_lasers_alone_on_three_axes() -> None:
    """Along: 3 components; across: 6; rotations: 9. Two lines per axis, twice each. No zero, no slope of any run."""
    counts = Counter(one.kind for one in found(replace(SMALL, ball_bar=False)))
    every, along = 18, 3
    assert counts == {
        "backlash": every,
        "backlash_slope": every,
        "cyclic": 9,
        "thermal_expansion": along,
        "thermal_offset": every,
        "warm_up": along,
        "drift": every,
        "servo_lag": along,
        "reversal_spike": along,
        "reversal_spike_time": along,
        "reversal_spike_path": along,
        "cross_axis": 2 * every,
        "laser_cosine": 6,
        "laser_scale": 1,
        "laser_step": 12,
        "point_offset": 12,
        "squareness": 3,
    }


def test_ball_bar_alone_on_three_axes() -> None:
    counts = Counter(one.kind for one in found(replace(SMALL, laser=False)))
    assert not {"laser_cosine", "laser_scale", "laser_step", "point_offset"} & set(counts)
    assert counts["ballbar_length"] == counts["ballbar_lobes"] == 1
    assert counts["ballbar_centre"] == 3  # one per plane
    assert counts["backlash"] == 18


def test_an_axis_that_stands_has_no_effects() -> None:
    given = prepared(Case(seed=1, design=replace(SMALL, ball_bar=False), noise="none", given="exact"))
    rows = given.rows
    of_x = np.array([run.id.startswith("X") for run in rows.runs])[rows.run]
    # lines of X stand at other places of Y and Z each: take one
    one_line = of_x & (rows.setup == rows.setup[0])
    effects = candidates(given.model, rows.only(one_line))
    assert {one.component[2] for one in effects if one.component and one.kind != "squareness"} == {"X"}
    assert not [one for one in effects if one.kind == "cross_axis"]
    assert {one.runs for one in effects if one.kind == "laser_cosine"} == {("X1-1", "X1-2")}


def test_five_axes_have_rotary_ones_too() -> None:
    effects = found(replace(SMALL, lines=1, repeats=1), "turntable_mill")
    components = {one.component for one in effects if one.kind == "backlash"}
    assert {"ECC", "EAC", "EXC", "EXX"} <= components
    assert Effect(kind="servo_lag", component="ECC") in effects
    assert Effect(kind="cross_axis", component="EXX", axis="C") in effects
    assert Effect(kind="thermal_expansion", component="EXC") not in effects


def test_what_the_machine_has_already_is_not_searched_for() -> None:
    where = field(SMALL)
    model, there = where.readings.model, Effect(kind="backlash", component="EXX")
    known = replace(model, machine=replace(model.machine, effects=(there,)))
    before = candidates(model, where.readings.rows)
    after = candidates(known, where.readings.rows)
    assert there in before
    assert set(before) - set(after) == {there}


def test_without_time_and_temperature_what_needs_them_is_missing_and_the_rest_is_not() -> None:
    given = prepared(Case(seed=1, design=replace(SMALL, times=False, temperature=""), noise="none", given="exact"))
    readings = readings_of(given.model, given.rows)
    lacking: dict[str, set[str]] = {}
    for effect in candidates(given.model, given.rows):
        lacking.setdefault(effect.kind, set()).add(signature_of(readings, effect).missing)
    for kind in ("thermal_expansion", "thermal_offset"):
        assert all("temperature" in one for one in lacking[kind])
    for kind in ("drift", "warm_up", "laser_step"):
        assert all("time" in one for one in lacking[kind])
    for kind in ("backlash", "backlash_slope", "cyclic", "cross_axis", "laser_cosine", "laser_scale", "ballbar_length"):
        assert lacking[kind] == {""}


def test_grids_stay_within_what_the_readings_can_tell() -> None:
    where = field(SMALL)
    readings, rows = where.readings, where.readings.rows
    kinds = readings.model.machine.kinds
    assert rows.time is not None
    span_of_time = float(np.ptp(rows.time))
    for effect in candidates(readings.model, rows):
        kind = kinds[effect.kind]
        points = grid_of(kind, effect, rows)
        assert points
        values = np.array([list(point.values()) for point in points])
        assert np.isfinite(values).all()
        searched = [one.grid for one in kind.parameters if one.role == "grid"]
        if not searched:
            assert points == ({},)
            continue
        assert (values > 0.0).all()
        assert (np.diff(values[:, 0]) != 0.0).all()
        if searched == ["time"]:
            assert span_of_time / 50 < values.min() < values.max() < 3 * span_of_time
        elif searched == ["moment"]:
            mine = rows.of_run(next(i for i, run in enumerate(rows.runs) if run.id in effect.runs))
            assert rows.time[mine][1] < values.min() < values.max() < rows.time[mine][-2]
        elif searched == ["reversal_time"]:  # of half a circle at either feed
            assert 1e-3 < values.min() < values.max() < 5.0
        elif searched == ["reversal_path"]:
            assert 0.1 < values.min() < values.max() < 50.0
        else:
            assert effect.component is not None
            travel = float(np.ptp(rows.positions[rows.axes.index(effect.component[2])]))
            assert values.max() <= travel
            assert values.min() > travel / 5000


def test_neighbouring_pitches_are_close_enough_to_miss_nothing() -> None:
    """A pitch halfway between two points of the grid keeps most of its power at one: enough to be looked at closely."""
    where = field(replace(SMALL, lines=1, targets=81))
    effect = Effect(kind="cyclic", component="EXX")
    signature = signature_of(where.readings, effect)
    pitches = np.array([point["pitch"] for point in signature.points])
    for place in (3, len(pitches) // 2, len(pitches) - 3):
        between = 2.0 / (1.0 / pitches[place] + 1.0 / pitches[place + 1])
        truth = signature_of(where.readings, effect, ({"pitch": between},)).columns(slice(None))[:, 0, 0]
        power = []
        for column in (signature.columns(slice(at, at + 1))[:, 0] for at in (place, place + 1)):
            fitted = column @ np.linalg.lstsq(column, truth, rcond=None)[0]
            power.append(fitted @ fitted / (truth @ truth))
        assert max(power) > WORTH_ZOOMING + 0.1


@pytest.mark.parametrize(("machine", "axis", "shortest"), [("table_mill", "X", 4.6), ("gantry", "X", 6.1)])
def test_a_long_axis_is_searched_for_the_pitches_that_screws_have(machine: str, axis: str, shortest: float) -> None:
    """A hundred and twenty periods fit into a short axis only."""
    rows = field(SMALL, machine=machine).readings.rows
    kind = field(SMALL, machine=machine).readings.model.machine.kinds["cyclic"]
    pitches = [point["pitch"] for point in grid_of(kind, Effect(kind="cyclic", component=f"E{axis}{axis}"), rows)]
    assert min(pitches) < shortest
    steps = np.diff(1.0 / np.array(pitches)) * float(np.ptp(rows.positions[rows.axes.index(axis)]))
    assert steps == pytest.approx(0.5, rel=1e-6)


@pytest.mark.parametrize("pause_h", [0.0, 24.0, 200.0])
def test_time_constants_of_the_first_hours_are_searched_whatever_pauses_follow(pause_h: float) -> None:
    """A machine warms up in an hour or two: as finely as in the readings of the first day alone, and of each day on."""
    day = np.linspace(0.0, 7200.0, 100)
    time = np.concatenate([1e6 + day, 1e6 + 7200.0 + 3600.0 * pause_h + day])
    kind = field(SMALL).readings.model.machine.kinds["warm_up"]
    constants = np.array([point["tau"] for point in grid_of_covered(kind, Covered(time=time), OF_DIAGNOSIS)])
    assert constants.min() < 1000.0
    assert constants.max() > np.ptp(time)
    assert (constants[1:] / constants[:-1] < 2.2).all()
