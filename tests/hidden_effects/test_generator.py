"""The generator is itself checked before anything is measured with it: closed forms, another machine, the package."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial import Chebyshev
from numpy.typing import NDArray

from tests.generator.machine import Body, Generator
from tests.hidden_effects import hidden, noise, outside
from tests.hidden_effects.case import Case, clean_readings, generate
from tests.hidden_effects.curves import component_errors
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.machines import FIVE_AXES, GANTRY, MACHINES, TABLE_MILL
from tests.hidden_effects.readings import Truth, ideal_along, polar_angle
from tests.hidden_effects.schedule import plan_runs
from tests.hidden_effects.state import Plan
from tests.kept import derived
from trueaxis.cli.main import main
from trueaxis.machine import read_machine
from trueaxis.measurement.data import read_data

SMALL = Design(lines=1, repeats=1, targets=11, samples=72)
CIRCLES = Design(laser=False, samples=360)
RADIUS = 150.0


def planned(machine: Machine = TABLE_MILL, design: Design = SMALL) -> Plan:
    return plan_runs(machine, design, np.random.default_rng(1))


def shown(*effects: Hidden, machine: Machine = TABLE_MILL, design: Design = SMALL) -> tuple[Plan, Array]:
    """What effects add to the readings of an otherwise perfect machine, um."""
    plan = planned(machine, design)
    perfect = clean_readings(machine, plan, Truth({}))
    return plan, 1e3 * (clean_readings(machine, plan, Truth({}, {}, effects)) - perfect)


def rows_of(plan: Plan, names: Sequence[str]) -> NDArray[np.bool_]:
    return np.isin(plan.state.run, [k for k, run in enumerate(plan.runs) if run.id in names])


@pytest.mark.parametrize("machine", MACHINES.values(), ids=MACHINES)
def test_the_machine_agrees_with_the_other_exact_machine(machine: Machine) -> None:
    source = np.random.default_rng(4)
    poses = {axis: source.uniform(*machine.travel[axis], 3) for axis in machine.axes}
    errors = {name: 1e-3 * source.normal(size=3) for name in machine.components}
    located = {f"{d}0{j.moves}": 1e-3 * source.normal() for j in machine.joints for d in j.located}
    point = np.array([10.0, -20.0, 30.0])
    found = machine.coordinates(("tool", "workpiece"), poses, point, errors, located)
    names = {f"{d}0{j.moves}": name for j in machine.joints for d, name in j.located.items()}
    bodies = tuple(
        Body(j.number, j.lower, j.moves or None, 1, j.position or (0.0, 0.0, 0.0), j.located) for j in machine.joints
    )
    parameters = dict(machine.dimensions) | {names[key]: value for key, value in located.items()}
    for k in range(3):
        curves = {name: (lambda _, value=values[k]: value) for name, values in errors.items()}
        frames = {"bed": 1, "workpiece": machine.workpiece, "tool": machine.tool}
        other = Generator(bodies, machine.axes, frames, parameters, curves, "true")
        expected = other.coordinates("tool", "workpiece", {axis: poses[axis][k] for axis in poses}, point)
        assert found[:, k] == pytest.approx(expected.astype(float), abs=1e-9)


@pytest.mark.parametrize("machine", MACHINES.values(), ids=MACHINES)
def test_without_effects_the_package_simulates_the_same_readings(machine: Machine, tmp_path: Path) -> None:
    """Up to the second order that its small-angle matrices leave out, and the chords of its tables."""
    design = replace(SMALL, straightness=True, diagonals=True, gauge=True)
    case = Case(7, machine.name, design, noise="none", given="exact", nuisance=False)
    generate(case).write(tmp_path)
    spec, kernels = str(tmp_path / "machine.toml"), str(derived(tmp_path / "machine.toml"))
    data, out, errors = (str(tmp_path / name) for name in ("data", "out", "errors.json"))
    arguments = ["simulate", spec, "--errors", errors, "--data", data, "--out", out, "--replace", "--kernels", kernels]
    assert main(arguments) == 0
    read = read_machine(Path(spec))
    ours, theirs = (read_data(tmp_path / folder, read).readings.reading for folder in ("data", "out"))
    assert np.max(np.abs(ours)) > 5e-3
    assert ours == pytest.approx(theirs, abs=2e-6)


def test_the_same_case_gives_the_same_data_and_another_seed_others() -> None:
    case = Case(5, design=SMALL)
    assert generate(case).readings == generate(case).readings
    assert generate(case).errors == generate(case).errors
    assert generate(case).readings != generate(replace(case, seed=6)).readings


def test_an_effect_changes_neither_noise_nor_machine() -> None:
    case = Case(5, design=SMALL)
    with_it = replace(case, effects=(Hidden("ballbar_length", size=1e-3),))
    change = generate(with_it).reading - generate(case).reading
    bars = generate(case).plan.of_run("ballbar")
    assert np.all(change[~bars] == 0.0)
    assert change[bars] == pytest.approx(1e-3, rel=0.05)
    assert generate(with_it).errors == generate(case).errors


def test_curves_are_smooth_enough_for_degree_12_and_no_cubics() -> None:
    worst, cubic = [], []
    for seed in range(20):
        for name, curve in component_errors(np.random.default_rng(seed), TABLE_MILL).items():
            if name[1] in "XYZ":
                q = np.linspace(*TABLE_MILL.travel[name[2]], 301)
                worst.append(np.max(np.abs(Chebyshev.fit(q, curve(q), 12)(q) - curve(q))))
                cubic.append(np.max(np.abs(Chebyshev.fit(q, curve(q), 3)(q) - curve(q))))
                assert curve(np.zeros(1)) == pytest.approx(0.0, abs=1e-15)
    assert max(worst) < 5e-5
    assert np.median(cubic) > 2e-4


def test_circles_turn_as_they_say_seen_from_the_workpiece() -> None:
    for machine in (TABLE_MILL, GANTRY):
        plan = planned(machine, CIRCLES)
        theta = polar_angle(machine, plan)
        for index, run in enumerate(plan.runs):
            steps = np.diff(np.unwrap(theta[plan.state.run == index]))
            assert np.all(np.sign(steps) == (1 if run.id.endswith("-ccw") else -1))


def test_directions_velocities_and_ways_belong_to_the_path() -> None:
    """By differences of the commanded positions over time."""
    plan = planned(FIVE_AXES, replace(CIRCLES, leave_out=False))
    for index in range(len(plan.runs)):
        run = plan.state.at(plan.state.run == index)
        for axis in FIVE_AXES.axes:
            speed = np.gradient(run.positions[axis], run.time)
            top = max(1e-3, np.max(np.abs(speed)))
            assert run.velocity[axis][1:-1] == pytest.approx(speed[1:-1], abs=2e-3 * top)
            grown = np.diff(np.nan_to_num(run.since_reversal[axis], posinf=0.0))
            moved = np.abs(np.diff(run.positions[axis]))
            same = (run.directions[axis][1:] == run.directions[axis][:-1]) & (run.directions[axis][1:] != 0)
            assert grown[same] == pytest.approx(moved[same], abs=1e-4)


def test_no_sample_lies_next_to_a_reversal() -> None:
    plan = planned(design=CIRCLES)
    moving = [np.abs(plan.state.velocity[axis]) for axis in "XYZ"]
    slowest = np.sort(moving, axis=0)[1]  # of the two that move
    assert np.all(slowest > plan.state.feed / 60 * np.sin(np.radians(1.0)))
    kept = planned(design=replace(CIRCLES, leave_out=False))
    assert len(kept.state.time) == len(plan.state.time) + 8 * len(plan.runs)


def test_squareness_is_the_second_harmonic_of_a_circle() -> None:
    """-(C R / 2) sin 2 theta where the angle between X and Y grows by C; the same both ways."""
    plan, found = shown(Hidden("squareness", "EC0Y", size=1e-5), machine=GANTRY, design=CIRCLES)
    theta = polar_angle(GANTRY, plan)
    rows = rows_of(plan, ["XY-F1000-ccw", "XY-F1000-cw"])
    design = np.column_stack([np.cos(theta), np.sin(theta), np.ones_like(theta), np.sin(2 * theta)])[rows]
    harmonic = np.linalg.lstsq(design, found[rows], rcond=None)[0][3]
    assert harmonic == pytest.approx(-1e-5 * RADIUS / 2 * 1e3, rel=1e-3)


def test_lost_motion_steps_at_its_reversals_and_flips_with_the_direction() -> None:
    """dir (B/2) sgn(sin theta) cos theta with the width B on the drive of X, seen where X moves +x in the workpiece."""
    plan, found = shown(Hidden("backlash", "EXX", size=2e-3), machine=GANTRY, design=CIRCLES)
    theta = polar_angle(GANTRY, plan)
    for way, name in ((1.0, "XY-F1000-ccw"), (-1.0, "XY-F1000-cw")):
        rows = rows_of(plan, [name]) & (np.abs(np.sin(theta)) > 0.3)
        expected = -way * np.sign(np.sin(theta[rows])) * np.cos(theta[rows])  # X goes down while theta is in (0, pi)
        assert found[rows] == pytest.approx(expected, abs=0.06)
    assert not np.any(found[rows_of(plan, ["YZ-F1000-ccw"])])


def test_servo_lag_grows_with_the_feed_and_flips_with_the_direction() -> None:
    """dir F (difference of the lags) / 2 sin 2 theta."""
    plan, found = shown(Hidden("servo_lag", "EXX", size=1e-4), machine=GANTRY, design=CIRCLES)
    theta = polar_angle(GANTRY, plan)
    for name, speed in (("XY-F1000-ccw", 1000 / 60), ("XY-F4000-cw", -4000 / 60)):
        rows = rows_of(plan, [name])
        expected = 1e-4 * speed / 2 * np.sin(2 * theta[rows]) * 1e3
        assert found[rows] == pytest.approx(expected, abs=0.07 * np.max(np.abs(expected)))


def test_laser_effects_by_hand() -> None:
    along = ideal_along(TABLE_MILL, planned())
    plan, found = shown(Hidden("laser_cosine", runs=("X1",), size=1e-3))
    mine = rows_of(plan, ["X1"])
    assert found[mine] == pytest.approx(-0.5e-6 * along[mine] * 1e3, rel=1e-6)
    assert not np.any(found[~mine])
    plan, found = shown(Hidden("laser_scale", size=1e-6))
    lines = plan.of_run("laser")
    assert found[lines] == pytest.approx(1e-3 * along[lines], rel=0.03)
    assert not np.any(found[~lines])
    plan, found = shown(Hidden("laser_step", runs=("Y1",), size=2e-3))
    assert sorted(np.round(found[rows_of(plan, ["Y1"])], 3))[0] == 0.0
    assert np.max(found) == pytest.approx(2.0, abs=0.01)


def test_a_point_that_is_off_reads_the_rotation_with_its_lever() -> None:
    """Abbe: 5 mm across a yaw of 20 urad are 0.1 um."""
    plan = planned(GANTRY)
    curves = {"ECX": lambda q: 2e-5 * q / 1500.0}
    effect = Hidden("point_offset", runs=("X1",), end="target", size=5.0, shift="Y")
    before, after = (clean_readings(GANTRY, plan, Truth(curves, {}, effects)) for effects in ((), (effect,)))
    rows = rows_of(plan, ["X1"])
    expected = -5.0 * 2e-5 * plan.state.positions["X"][rows] / 1500.0
    assert (after - before)[rows] == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("kind", [*hidden.OF_COMPONENTS, *outside.OF_COMPONENTS])
def test_every_component_effect_shows_and_is_proportional_to_its_size(kind: str) -> None:
    one, two = (Hidden(kind, "EXX", "Y" if kind == "cross_axis" else "", size=size) for size in (1e-5, 2e-5))
    design = replace(SMALL, lines=2)
    _, first = shown(one, design=design)
    _, second = shown(two, design=design)
    assert np.max(np.abs(first)) > 0.0
    assert second == pytest.approx(2 * first, abs=1e-3 * np.max(np.abs(first)))


@pytest.mark.parametrize("kind", [kind for kind in noise.KINDS if kind not in ("none", "outliers")])
def test_noise_has_the_size_that_it_is_asked_for(kind: str) -> None:
    source, distance = np.random.default_rng(2), np.linspace(0.0, 500.0, 400)
    drawn = np.array([noise.noise(kind, source, 3e-4, distance) for _ in range(200)])
    assert 2.5e-4 < np.sqrt(np.mean(np.diff(drawn) ** 2) / 2) < 3.5e-4 or kind in ("correlated", "realistic")
    assert 2.5e-4 < np.std(drawn) < 4.5e-4


def test_correlated_noise_is_correlated_and_white_noise_is_not() -> None:
    source, distance = np.random.default_rng(2), np.linspace(0.0, 500.0, 200_000)
    for kind, expected in (("white", 0.0), ("correlated", 0.2 * 0.8)):
        drawn = noise.noise(kind, source, 1.0, distance)
        assert np.corrcoef(drawn[1:], drawn[:-1])[0, 1] == pytest.approx(expected, abs=0.01)


def test_values_given_are_as_good_as_they_are_said_to_be() -> None:
    """Curves as given against those that the truth is made of, both at the same positions."""
    q = np.linspace(0.0, 540.0, 101)
    off = {}
    for given in ("exact", "identified", "stale"):
        curve = generate(Case(3, design=SMALL, given=given)).given.motion_errors["EXX"]
        if curve["basis"] == "table":
            values = np.interp(q, curve["positions"], curve["values"])
        else:
            values = sum(c * q**p for p, c in zip(curve["powers"], curve["coefficients"], strict=True))
        off[given] = values
    truth = component_errors(np.random.default_rng([3, 2]), TABLE_MILL)["EXX"](q)
    assert off["exact"] == pytest.approx(truth, abs=1e-6)
    assert 1e-5 < np.std(off["identified"] - truth) < 3e-4


def test_a_position_error_left_out_is_in_neither_file() -> None:
    data = generate(Case(3, design=SMALL, effects=(Hidden("squareness", "EC0X", size=2e-5),)))
    assert "eps_xy" not in data.spec
    assert "eps_xy" not in data.errors
    assert "eps_xz" in data.spec


def test_tampering_changes_only_what_it_says() -> None:
    sound = generate(Case(3, design=SMALL))
    swapped = generate(Case(3, design=SMALL, tamper="swap_directions"))
    shuffled = generate(Case(3, design=SMALL, tamper="shuffle_time"))
    assert np.all(swapped.reading == sound.reading)
    assert np.all(swapped.plan.state.directions["X"] == sound.plan.state.directions["Y"])
    assert np.any(shuffled.plan.state.time != sound.plan.state.time)
    assert sorted(shuffled.plan.state.time) == sorted(sound.plan.state.time)
    with pytest.raises(ValueError, match="no way"):
        generate(Case(3, design=SMALL, tamper="burn"))


def test_every_option_of_the_design_makes_readable_files(tmp_path: Path) -> None:
    designs = [
        Design(lines=1, one_run=True, jitter=False, targets=11, samples=36, temperature="", times=False),
        Design(lines=6, repeats=1, targets=6, ball_bar=False, gauge=True, diagonals=True, straightness=True),
        Design(laser=False, samples=36, bar=300.0, temperature="linear"),
    ]
    for number, design in enumerate(designs):
        folder = tmp_path / str(number)
        data = generate(Case(3, design=design))
        data.write(folder)
        read = read_data(folder / "data", read_machine(folder / "machine.toml"))
        assert read.readings.reading == pytest.approx(data.reading, abs=0.0)
        assert (read.readings.temperature is None) == (not design.temperature)
        assert (read.readings.time is None) == (not design.times)
        for axis, directions in zip(read.readings.axes, read.readings.directions, strict=True):
            assert np.all(directions == data.plan.state.directions[axis])
