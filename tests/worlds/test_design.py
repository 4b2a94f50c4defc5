"""Designs: what is in them, that they can be had again, and that they agree with themselves."""

import os
import subprocess
import sys
import tomllib
from collections import Counter
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from tests.worlds.design import AXES, FEWEST, MOST, MOST_IN_A_RUN, WITH_FOUR_AXES, Design, draw_design
from tests.worlds.files import readings_csv, setup_toml, spec_toml
from tests.worlds.lines import way_since_turn
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine

ROOT = Path(__file__).resolve().parents[2]
DESIGNS = 60


@cache
def designs() -> tuple[Design, ...]:
    return tuple(draw_design(seed) for seed in range(1, DESIGNS + 1))


def test_every_ingredient_is_in_a_fifth_of_the_designs() -> None:
    count = Counter(name for design in designs() for name, present in design.ingredients.items() if present)
    names = designs()[0].ingredients
    assert len(names) > 60
    assert {name: count[name] for name in names if count[name] < DESIGNS / 5} == {"four_axes": 0}  # later seeds have it


def test_from_a_seed_on_designs_have_four_axes_too_on_the_table_or_in_the_head() -> None:
    later = [draw_design(seed) for seed in range(WITH_FOUR_AXES, WITH_FOUR_AXES + 30)]
    count = Counter(len(design.machine.axes) for design in later)
    assert min(count[axes] for axes in AXES) >= 5
    four = [design.machine for design in later if design.ingredients["four_axes"]]
    assert {len(machine.rotary) for machine in four} == {1}
    assert {machine.carries("workpiece", machine.rotary[0]) for machine in four} == {True, False}


def test_designs_have_as_many_readings_as_is_said() -> None:
    counts = [design.plan.count for design in designs()]
    assert min(counts) >= FEWEST
    assert max(counts) <= 1.1 * MOST  # sessions repeat at random
    assert np.quantile(counts, 0.9) > 6000
    assert max(len(design.plan.rows(k)) for design in designs() for k in range(len(design.plan.runs))) <= MOST_IN_A_RUN


def test_the_axes_stand_in_many_orders() -> None:
    structures = {design.machine.structure for design in designs()}
    assert len(structures) > 30
    assert {structure.split()[0] for structure in structures} == {"three", "table-table", "head-table", "head-head"}


def test_positions_and_homes_lie_in_the_travels() -> None:
    for design in designs():
        for axis in design.machine.axes:
            low, high = design.machine.travel(axis)
            values = design.plan.positions[axis]
            homes = [run.home[axis] for run in design.plan.runs if run.home is not None]
            assert low <= values.min()
            assert values.max() <= high
            assert all(low <= home <= high for home in homes)


def test_bars_span_their_balls() -> None:
    """Positions are rounded to 1e-5 mm, balls to 1e-4."""
    for design in designs()[:25]:
        assert np.max(np.abs(design.jacobian.ideal)) < 5e-4


def test_directions_are_those_of_the_path_where_an_axis_has_moved_on() -> None:
    """A step of a run is in the direction of the reading after it, but where the axis turned back beyond the target."""
    for design in designs()[:20]:
        plan = design.plan
        for index, run in enumerate(plan.runs):
            rows = plan.rows(index)
            for axis in design.machine.axes:
                steps = np.diff(plan.positions[axis][rows])
                ways = plan.directions[axis][rows]
                same = (ways[1:] == ways[:-1]) & (np.abs(steps) > 1e-4)
                if run.plane or run.home is not None:
                    assert np.all(steps[same] * ways[1:][same] > 0) or not design.habits.both


def test_the_way_since_the_last_reversal_counts_the_overtravel() -> None:
    path = np.array([0.0, 10.0, 20.0, 20.0, 10.0, 0.0])
    ways = np.array([1.0, 1.0, 1.0, -1.0, -1.0, -1.0])
    assert way_since_turn(path, ways, 2.0).tolist() == [2.0, 12.0, 22.0, 2.0, 12.0, 22.0]
    again = np.array([0.0, 10.0, 0.0, 10.0, 20.0])
    assert way_since_turn(again, np.ones(5), 2.0).tolist() == [2.0, 12.0, 2.0, 12.0, 22.0]


def test_velocities_are_those_of_the_path() -> None:
    """By differences of positions over time, away from gaps where samples were left out."""
    for design in designs()[:15]:
        plan = design.plan
        for index, run in enumerate(plan.runs):
            if run.length is None:
                continue
            rows = plan.rows(index)
            time = plan.time[rows]
            even = np.abs(np.diff(time, 2)) < 1e-6 * np.median(np.diff(time)) + 1e-9
            for axis in design.machine.axes:
                middle = (plan.positions[axis][rows][2:] - plan.positions[axis][rows][:-2]) / (time[2:] - time[:-2])
                speed = plan.velocity[axis][rows]
                top = np.max(np.abs(speed)) + 1e-3
                assert speed[1:-1][even] == pytest.approx(middle[even], abs=0.05 * top)


def test_setups_say_sessions_and_devices_where_that_is_asked_for() -> None:
    design = next(d for d in designs() if d.ingredients["sessions"] and d.ingredients["display_steps"])
    plain, more = (tomllib.loads(setup_toml(design, sessions=wanted)) for wanted in (False, True))
    assert [run["session"] for run in more["run"]] == [str(run.session + 1) for run in design.plan.runs]
    steps = {name: table.get("resolution_um", 0.0) for name, table in more["device"].items()}
    for index, run in enumerate(more["run"]):
        row = design.plan.rows(index)[0]
        assert steps[run.pop("device")] == pytest.approx(1e3 * design.shop.resolution[row], abs=1e-9)
        run.pop("session")
    more.pop("device")
    assert more == plain


def test_a_seed_gives_the_same_bytes_whatever_the_hash_seed() -> None:
    code = (
        "import hashlib, sys\n"
        "from tests.worlds.test_design import world_bytes\n"
        "print(hashlib.sha256(world_bytes(6) + world_bytes(11)).hexdigest())"
    )
    found = set()
    for seed in ("0", "4711"):
        done = subprocess.run(
            [sys.executable, "-c", code],
            cwd=ROOT,
            env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
            capture_output=True,
            text=True,
            check=True,
        )
        found.add(done.stdout)
    assert len(found) == 1
    assert world_bytes(6) != world_bytes(11)


def world_bytes(seed: int) -> bytes:
    design = draw_design(seed)
    data = measure(design, draw_machine(design.machine, seed), seed)
    texts = (spec_toml(design.machine), setup_toml(design, sessions=True), readings_csv(design, data.reading))
    return "".join(texts).encode()
