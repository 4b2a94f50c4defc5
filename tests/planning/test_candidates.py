"""Candidate runs: within the travels, what they are said to be, on machines of the repository and on random ones."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.planning.data import model
from tests.planning.promise import NAMES
from tests.worlds.estimates import world
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import is_straightness, relative_motion
from trueaxis.identification.tips import tip_notes, wrong_tip
from trueaxis.identification.weighting import NoiseModel
from trueaxis.measurement.reading_geometry import home_positions, ideal_bar, ideal_displacement
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.measurement.setup import Device
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.candidates import Candidate, candidates
from trueaxis.planning.kit import Kit
from trueaxis.planning.method import PlanOptions, _kit_of
from trueaxis.planning.runs import RUN_MINUTES, SET_UP_MINUTES, minutes, no_runs, run_minutes, set_up_of

OPTIONS = PlanOptions(given=ErrorValues(machine="dmu60p"), noise=NoiseModel(), tools=((0.0, 0.0, 0.0),))
ALL = Kit(instruments=("laser", "ballbar", "probe"))


def check(machine: MachineModel, found: list[Candidate]) -> None:
    limits = np.array([machine.travel[axis] for axis in machine.axes])
    for one in found:
        positions = one.positions
        assert (positions >= limits[:, :1]).all(), one.what
        assert (positions <= limits[:, 1:]).all(), one.what
        half = positions.shape[1] // 2
        np.testing.assert_array_equal(positions[:, :half], positions[:, :half:-1])
        if one.run.instrument == "ballbar":
            assert one.run.length is not None
            bar = np.linalg.norm(ideal_bar(machine, one.run, positions), axis=0)
            assert np.abs(bar - one.run.length).max() < 5e-3, one.what
        else:
            assert list(one.run.home.values()) == positions[:, 0].tolist()
            assert np.linalg.norm(one.run.direction or ()) == pytest.approx(1.0, abs=1e-8)
        if "straightness" in one.what:
            assert is_straightness(machine, one.run, positions)
        if "displacement" in one.what:
            moved = relative_motion(machine, one.run, positions)
            along = np.array(one.run.direction) @ moved
            assert np.abs(np.linalg.norm(moved, axis=0) - np.abs(along)).max() < 1e-2
        if "sphere" in one.what:
            home = home_positions(one.run, machine.axes)
            assert home is not None
            assert np.abs(ideal_displacement(machine, one.run, positions, home)).max() < 5e-3


@pytest.mark.parametrize("name", NAMES)
def test_all_are_within_the_travels_and_as_they_say(name: str) -> None:
    found = candidates(model(name), ALL)
    check(model(name), found)
    kinds = {one.run.instrument for one in found}
    assert kinds == {"laser", "ballbar", "probe"}
    assert len({one.what for one in found}) == len(found)
    for axis in model(name).axes:
        moved = [one for one in found if np.ptp(one.positions[model(name).axes.index(axis)]) > 0.0]
        assert moved, axis


@pytest.mark.slow
@pytest.mark.parametrize("seed", [4])
def test_on_random_machines(seed: int, tmp_path: Path) -> None:
    machine = world(seed, tmp_path).model
    check(machine, candidates(machine, ALL))


def test_arcs_are_ways_without_jumps() -> None:
    for one in candidates(model(), Kit(instruments=("ballbar",))):
        assert one.run.length is not None
        step = np.linalg.norm(np.diff(one.positions, axis=1), axis=0)
        assert step.max() < 2.1 * np.sin(np.pi / 36) * one.run.length, one.what


def test_instruments_tools_and_lengths_are_those_at_hand() -> None:
    kit = Kit(instruments=("ballbar",), tools=((0.0, 0.0, 0.0), (0.0, 0.0, -80.0)), lengths=(100.0,), session="two")
    found = candidates(model(), kit)
    assert {one.run.length for one in found} == {100.0}
    assert {one.run.target.point for one in found} == set(kit.tools)
    assert {one.run.session for one in found} == {"two"}
    assert len(candidates(model(), Kit(instruments=("laser",)))) == 3 * 5 * 3 + 3 * 2 * 2 + 4


def test_an_instrument_sits_where_it_sits_in_the_plan() -> None:
    ball, optic = (0.0, 0.0, -150.0), (10.0, 0.0, -120.0)
    kit = Kit(instruments=("laser", "ballbar", "probe"), tools=(optic,), points={"ballbar": (ball,), "laser": (optic,)})
    for one in candidates(model(), kit):
        assert one.run.target.point == (ball if one.run.instrument == "ballbar" else optic)


def test_the_first_and_the_farthest_place_on_the_tool_are_those_of_the_plan() -> None:
    """The point whose uncertainty is wanted is no place of a ball."""
    at = [(0.0, 0.0, -120.0), (0.0, 0.0, -110.0), (0.0, 40.0, -120.0)]
    lasers = candidates(model(), Kit(instruments=("laser",), tools=tuple(at)))
    found = [next(one for one in lasers if one.run.target.point == point) for point in at]
    kit = _kit_of(model(), no_runs("here", model().axes).with_added(found).observed, OPTIONS, ("laser", "ballbar"))
    assert kit.on_tool("laser") == (at[0], at[2])
    assert kit.on_tool("ballbar") == (at[0],)


def test_straightness_is_read_by_the_device_that_reads_straightness() -> None:
    """It was proposed with the device of the distance optics, which comes first in a plan."""
    lasers = candidates(model(), Kit(instruments=("laser",)))
    distance, across = (next(one for one in lasers if word in one.what) for word in ("displacement", "straightness"))
    head, optic = Device(id="head"), Device(id="short range optic")
    for devices in ({distance: head, across: optic}, {distance: head}):
        found = [replace(one, run=replace(one.run, device=device)) for one, device in devices.items()]
        observed = no_runs("here", model().axes).with_added(found).observed
        proposed = candidates(model(), _kit_of(model(), observed, OPTIONS, ("laser",)))
        straight = {one.run.device for one in proposed if "straightness" in one.what}
        assert straight == {devices.get(across, head)}
        assert {one.run.device for one in proposed if "displacement" in one.what} == {head}


def test_a_set_up_takes_its_time_once() -> None:
    found = candidates(model(), Kit(instruments=("ballbar",), lengths=(150.0,)))
    keys = [set_up_of(one.run, one.positions) for one in found]
    same = [(one.run, one.positions) for one, key in zip(found, keys, strict=True) if key == keys[0]]
    assert len(same) == 3  # three planes about one ball
    single = sum(run_minutes(run, positions.shape[1]) for run, positions in same)
    assert minutes(same) == pytest.approx(single + SET_UP_MINUTES["ballbar"])
    assert run_minutes(same[0][0], 0) == RUN_MINUTES
    lasers = candidates(model(), Kit(instruments=("laser",)))
    assert len({set_up_of(one.run, one.positions) for one in lasers}) == len(lasers)  # other optics, or another line


def test_what_comes_back_to_a_set_up_is_set_up_again() -> None:
    found = candidates(model(), Kit(instruments=("ballbar",), lengths=(150.0,)))
    keys = [set_up_of(one.run, one.positions) for one in found]
    first, second = found[0], next(one for one, key in zip(found, keys, strict=True) if key != keys[0])
    here, there = (first.run, first.positions), (second.run, second.positions)
    assert minutes([here, there, here]) - minutes([here, here, there]) == pytest.approx(SET_UP_MINUTES["ballbar"])
    other = replace(there[0], device=Device(id="another bar")), there[1]
    assert minutes([here, other, here]) == pytest.approx(minutes([here, here, other]))  # it stays where it is


def test_a_set_up_that_was_measured_is_no_longer_there() -> None:
    """Runs to be added share the set-up of runs that are planned, not of those that have readings."""
    machine = model()
    found = candidates(machine, Kit(instruments=("ballbar",), lengths=(150.0,)))[:3]
    planned = no_runs("here", machine.axes).with_added(found)
    assert [run.id for run, _ in planned.to_take] == [run.id for run in planned.runs]
    reading = np.where(planned.readings.run == 1, 0.0, np.nan)
    measured = replace(planned, readings=replace(planned.readings, reading=reading))
    assert [run.id for run, _ in measured.to_take] == [planned.runs[0].id, planned.runs[2].id]


def test_spheres_tell_where_the_axis_of_a_table_is() -> None:
    """Since home, readings along the bed hold nothing of EX0C, those along the workpiece do."""
    machine = model("dmu60p_5axis")
    turns = [one for one in candidates(machine, replace(ALL, everywhere=False)) if "C turning at B0 about" in one.what]
    assert {(one.run.frame, one.what.split(",")[0]) for one in turns} == {
        ("bed", "probe in x"),
        ("bed", "probe in y"),
        ("bed", "probe in z"),
        ("workpiece", "probe in x of the workpiece"),
        ("workpiece", "probe in y of the workpiece"),
    }
    off = machine.with_values(replace(machine.errors, parameters={**machine.errors.parameters, "EX0C": 0.01}))
    for one in turns:
        read = np.ptp([expected_reading(each, one.run, one.positions) for each in (machine, off)], axis=0).max()
        assert (read > 1e-3) == (one.run.frame == "workpiece"), one.what


def test_a_tip_that_leaves_its_sphere_is_told() -> None:
    """Since the workpiece lies 80 mm elsewhere on the table than it is said to: a dimension is not given."""
    machine = model("dmu60p_5axis")
    turns = [one for one in candidates(machine, replace(ALL, everywhere=False)) if "C turning at B0 about" in one.what]
    positions = np.hstack([one.positions for one in turns])
    observed = Observations(
        source="plan",
        runs=tuple(one.run for one in turns),
        run=np.repeat(np.arange(len(turns)), [one.positions.shape[1] for one in turns]),
        positions=positions,
        reading=np.zeros(positions.shape[1]),
    )
    assert tip_notes(machine, observed) == ()
    (note,) = tip_notes(machine.with_values(replace(machine.errors, parameters={"q_wx": 80.0})), observed)
    assert "the tip leaves its place by up to" in note


def test_a_rotary_axis_that_turns_the_other_way_than_its_spec_says_is_named() -> None:
    """A probe that follows a sphere round C goes the wrong way round."""
    machine = model("dmu60p_5axis")
    turns = [one for one in candidates(machine, replace(ALL, everywhere=False)) if "C turning at B0 about" in one.what]
    row = machine.axes.index("C")
    for one in turns:
        assert wrong_tip(machine, one.run, one.positions, Path()) is None
        turned = one.positions.copy()
        turned[row] *= -1.0
        found = wrong_tip(machine, one.run, turned, Path())
        assert found is not None
        fault = found.fault
        assert fault.place == f"run {one.run.id}"
        assert "C moved the other way, it would stay there within 0.001 mm" in fault.problem
        assert fault.remedy in ("sense of axis X, Y or C in the spec", "sense of axis C in the spec")
        radians = one.positions.copy()
        radians[row] = np.deg2rad(radians[row])
        found = wrong_tip(machine, one.run, radians, Path())
        assert found is not None
        fault = found.fault
        assert (fault.place, fault.remedy) == ("column B or C", "degrees")
        assert "if these positions were radians, it would stay there within 0.001 mm" in fault.problem
