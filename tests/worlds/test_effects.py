"""Hidden effects by closed forms, and given values that are no longer true."""

from functools import cache

import numpy as np
import pytest

from tests.worlds import effects
from tests.worlds.design import Design, draw_design
from tests.worlds.effects import Effect
from tests.worlds.machine import Array
from tests.worlds.readings import exact_readings, reading_context
from tests.worlds.stale import rescaled, truth_given, worn_at
from tests.worlds.test_shop import perfect
from tests.worlds.truth import draw_machine


@cache
def with_circles() -> Design:
    """Circles in XY of three axes without rotary turns."""

    def fits(design: Design) -> bool:
        wanted = {"laser", "circle", "both_ways", "straightness"}
        planes = {run.plane for run in design.plan.runs}
        return all(design.ingredients[name] for name in wanted) and "XY" in planes and not design.machine.rotary

    return next(design for design in map(draw_design, range(1, 200)) if fits(design))


def shown(effect: Effect) -> Array:
    """What an effect adds to the readings of a perfect machine, mm."""
    design = with_circles()
    clean, with_it = exact_readings(design, [perfect(design), perfect(design).hiding(effect)])
    return np.asarray(with_it - clean, float)


def run_of(instrument: str, *, across: bool = False) -> str:
    runs = with_circles().plan.runs
    return next(run.id for run in runs if run.instrument == instrument and run.across == across)


def an_effect(kind: str, size: float) -> Effect:
    machine = with_circles().machine
    instrument = "ballbar" if kind == "ballbar_centre" else "laser"
    runs = (run_of(instrument, across=kind == "reading_slope"),) if kind in effects.OF_RUNS else ()
    component = next(name for name in machine.components if name[1] in "XYZ" and name[1] == name[2])
    if kind == "squareness":
        component = next(iter(machine.locations))
    elif kind in effects.ON_POINTS:
        component = "X"
    return Effect(kind, component, size, "Y" if component[2:] != "Y" else "X", runs)


@pytest.mark.parametrize(
    "kind", [*effects.ON_COMPONENTS, *effects.ON_READINGS, *effects.ON_LOCATIONS, "ballbar_centre"]
)
def test_every_effect_shows_and_grows_with_its_size(kind: str) -> None:
    size = 1e-8 if kind == "drift" else 1e-4  # of a drift: mm/s
    once, twice = shown(an_effect(kind, size)), shown(an_effect(kind, 2 * size))
    largest = np.max(np.abs(once))
    assert largest > 0.0
    assert twice == pytest.approx((4 if kind == "laser_cosine" else 2) * once, abs=2e-3 * 2 * largest + 1e-12)


def test_every_kind_is_of_the_library_or_outside_it() -> None:
    every = (*effects.ON_COMPONENTS, *effects.ON_READINGS, *effects.ON_POINTS, *effects.ON_LOCATIONS)
    assert sorted(every) == sorted((*effects.KNOWN, *effects.OUTSIDE))


def test_a_point_that_is_off_shows_by_the_rotations_of_the_machine() -> None:
    design = with_circles()
    truth = draw_machine(design.machine, 4)
    run = run_of("laser")
    moved = truth.hiding(Effect("point_offset", "Y", 5.0, runs=(run,)))
    change = np.abs(exact_readings(design, [moved])[0] - exact_readings(design, [truth])[0])
    own = effects.of_runs(design.plan, (run,))
    assert 0.0 < change[own].max() < 5.0 * 1e-3
    assert change[~own].max() == 0.0


def test_squareness_is_the_second_harmonic_of_a_circle() -> None:
    """|C R / 2| sin 2 theta, the same both ways."""
    design = with_circles()
    machine, plan = design.machine, design.plan
    name = next(name for name, direction in machine.locations.items() if direction == "EC")
    found, (_, theta) = shown(Effect("squareness", name, 1e-5)), reading_context(machine, plan)
    for index in [k for k, run in enumerate(plan.runs) if run.plane == "XY" and not run.line.endswith("arc")][:4]:
        rows = plan.rows(index)
        if np.ptp(np.unwrap(theta[rows])) < 6.0:
            continue
        one = np.ones(len(rows))
        columns = np.column_stack([np.cos(theta[rows]), np.sin(theta[rows]), one, np.sin(2 * theta[rows])])
        radius = np.ptp(plan.positions["X"][rows]) / 2
        length = plan.runs[index].length or 1.0
        height = np.linalg.lstsq(columns, found[rows], rcond=None)[0][3]
        assert abs(height) == pytest.approx(1e-5 * radius**2 / length / 2, rel=0.02)


def test_lost_motion_steps_by_its_width_between_both_directions() -> None:
    design = with_circles()
    plan = design.plan
    found = np.abs(shown(Effect("backlash", "EXX", 4e-3)))
    lines = [
        k
        for k, run in enumerate(plan.runs)
        if run.instrument == "laser" and run.line.startswith("X") and not run.across
    ]
    moved = (plan.since["X"] > 5.0) & (plan.directions["X"] != 0.0)
    far = np.flatnonzero(np.isin(plan.run, lines) & moved)
    assert found[far] == pytest.approx(2e-3, rel=0.06)


def test_laser_effects_by_hand() -> None:
    design = with_circles()
    along, _ = reading_context(design.machine, design.plan)
    run = run_of("laser")
    own = effects.of_runs(design.plan, (run,))
    found = shown(Effect("laser_cosine", "", 1e-3, runs=(run,)))
    assert found[own] == pytest.approx(-0.5e-6 * along[own], rel=1e-5, abs=1e-15)
    assert not np.any(found[~own])
    lines = np.array([one.instrument == "laser" for one in design.plan.runs])[design.plan.run]
    scaled = shown(Effect("laser_scale", "", 1e-6))
    assert scaled[lines] == pytest.approx(1e-6 * along[lines], rel=0.03)
    assert not np.any(scaled[~lines])


def test_stale_values_differ_by_what_is_said_and_in_one_component_alone() -> None:
    truth = draw_machine(with_circles().machine, 5)
    now = truth_given(truth).motion_errors
    for given in (worn_at(truth, "EYY", 3e-3, 1), rescaled(truth, "EYY", 3e-3)):
        off = {name: np.subtract(now[name]["values"], given.motion_errors[name]["values"]) for name in now}
        assert [name for name in now if np.any(off[name])] == ["EYY"]
        assert np.max(np.abs(off["EYY"])) == pytest.approx(3e-3, rel=0.01)
