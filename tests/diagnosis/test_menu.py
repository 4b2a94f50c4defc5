"""The menu of further runs: each can be taken on the machine at hand, and is what its words say."""

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.diagnosis.prepared import SMALL, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.machines import MACHINES
from tests.kernels import kernels_of
from tests.machines import machine_of, three_axis_texts
from trueaxis.diagnosis.further_runs.menu import FurtherRun, menu
from trueaxis.diagnosis.null_model.rows import Rows, rows_of
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_geometry import ideal_bar, ideal_displacement
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import PointOn, Run, Setup
from trueaxis.model.curves import PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

TOPOLOGIES = dict(islice(three_axis_texts(), 0, None, 5))


def assert_feasible(model: MachineModel, further: tuple[FurtherRun, ...]) -> None:
    assert len({one.run.id for one in further}) == len(further)
    for one in further:
        assert np.isfinite(one.positions).all()
        assert one.lasts > 0.0
        for axis, at in zip(model.axes, one.positions, strict=True):
            low, high = model.travel[axis]
            assert low <= at.min() <= at.max() <= high, (one.what, axis)
            if one.run.instrument != "ballbar":
                assert low <= one.run.home[axis] <= high
        moving = np.ptp(one.positions, axis=1) > 0.0
        assert (np.abs(one.directions[moving]).max(axis=1) == 1.0).all()
        if one.run.instrument == "ballbar":
            assert np.linalg.norm(ideal_bar(model, one.run, one.positions), axis=0) == pytest.approx(
                one.run.length, abs=2e-3
            )


def of(further: tuple[FurtherRun, ...], words: str) -> FurtherRun:
    return next(one for one in further if words in one.what)


@settings(max_examples=8, deadline=None)
@given(
    machine=st.sampled_from(sorted(MACHINES)),
    lines=st.integers(1, 4),
    feeds=st.sampled_from([(1000.0,), (1000.0, 4000.0)]),
    radius=st.sampled_from([50.0, 150.0]),
    instruments=st.sampled_from([(True, True), (True, False), (False, True)]),
    jitter=st.booleans(),
)
def test_every_run_stays_within_the_travels(
    machine: str,
    lines: int,
    feeds: tuple[float, ...],
    radius: float,
    instruments: tuple[bool, bool],
    jitter: bool,
) -> None:
    laser, ball_bar = instruments
    design = Design(
        lines=lines, repeats=1, targets=11, samples=72, feeds=feeds, radius=radius, bar=radius, jitter=jitter,
        laser=laser, ball_bar=ball_bar,
    )  # fmt: skip
    case = prepared(Case(seed=1, machine=machine, design=design, noise="none"))
    further = menu(case.model, case.rows)
    assert_feasible(case.model, further)
    assert all(any(f"laser, {axis} moving" in one.what for one in further) for axis in "XYZ")
    assert ball_bar or any("circle" in one.what for one in further)
    assert any("irregular" in one.what for one in further) == (laser and not jitter)


@pytest.mark.parametrize("name", TOPOLOGIES)
def test_machines_of_any_order_of_bodies(name: str) -> None:
    model, rows = one_line(TOPOLOGIES[name])
    further = menu(model, rows)
    assert_feasible(model, further)
    for axis in "XYZ":
        gauge = of(further, f"along {axis}")
        away = ideal_displacement(model, gauge.run, gauge.positions, gauge.positions[:, :1])
        sensed = np.array(gauge.run.direction) @ away
        assert np.abs(sensed).max() == pytest.approx(np.ptp(gauge.positions[model.axes.index(axis)]), abs=1e-9)


def test_the_other_direction_is_proposed_where_one_is_missing() -> None:
    case = prepared(Case(seed=1, design=SMALL, noise="none"))
    assert not any("other direction" in one.what for one in menu(case.model, case.rows))
    rows = case.rows
    one_way = np.array([not run.id.endswith("-cw") for run in rows.runs])[rows.run]
    there = of(menu(case.model, rows.only(one_way)), "XY-F1000-ccw in the other direction")
    taken = rows.of_run(next(place for place, run in enumerate(rows.runs) if run.id == "XY-F1000-ccw"))
    np.testing.assert_array_equal(there.positions, rows.positions[:, taken][:, ::-1])
    np.testing.assert_array_equal(there.directions, -rows.directions[:, taken][:, ::-1])


def test_lines_are_far_from_all_lines_at_hand_too() -> None:
    case = prepared(Case(seed=1, design=SMALL, noise="none"))
    offsets = [run.home for run in case.rows.runs if run.id.startswith("X")]
    lines = [one.run.home for one in menu(case.model, case.rows) if "laser, X moving" in one.what]
    distance = [min(np.hypot(one["Y"] - at["Y"], one["Z"] - at["Z"]) for at in offsets) for one in lines]
    assert max(distance) > 200.0


def one_line(text: str) -> tuple[MachineModel, Rows]:
    """A machine with one laser line of X, there and back."""
    machine, module = machine_of(text), kernels_of(text)
    kernels = Kernels(
        meta=module.META,
        module=module,
        routines={n: getattr(module, n) for n in module.META["routines"]},
        backend="numpy",
        note="",
    )
    model = MachineModel(machine, kernels, ErrorValues(machine=machine.name))
    way = np.linspace(-290.0, 390.0, 12)
    positions = np.zeros((3, 24))
    positions[0] = np.concatenate([way, way[::-1]])
    directions = np.zeros((3, 24), dtype=np.int8)
    directions[0] = np.repeat([1, -1], 12)
    run = Run(
        id="X1",
        instrument="laser",
        target=PointOn("tool"),
        reference=PointOn("workpiece"),
        frame="bed",
        home=dict.fromkeys("XYZ", 0.0),
        direction=(1.0, 0.0, 0.0),
    )
    number = np.arange(24)
    readings = Readings(
        axes=("X", "Y", "Z"),
        run_ids=("X1",),
        run=np.zeros_like(number),
        seq=number,
        positions=positions,
        directions=directions,
        reading=np.zeros(24),
    )
    return model, rows_of(MeasuredData(Setup(machine.name, (run,)), readings))


def test_optics_elsewhere_tell_an_angle_from_the_error_of_a_point() -> None:
    """Towards Z+ the pitch of X, EBX, moves the optics along X by so much for each radian; EXX does as before."""
    case = prepared(Case(seed=1, design=SMALL, noise="none"))
    line = next(run for run in case.rows.runs if run.id.startswith("X"))
    found = [one for one in menu(case.model, case.rows) if "optics 100 mm" in one.what and line.id in one.what]
    assert [one.what[-2:] for one in found] == ["Y+", "Z+"]
    towards_z = found[1]

    def read(name: str, size: float, run: Run) -> np.ndarray:
        curve = PolynomialCurve(powers=(1,), coefficients=(size,))
        machine = case.model.with_values(replace(case.model.errors, motion_errors={name: curve}))
        return expected_reading(machine, run, towards_z.positions)

    way = np.ptp(towards_z.positions[0])
    np.testing.assert_allclose(read("EXX", 1e-5, towards_z.run), read("EXX", 1e-5, line), atol=1e-9)
    angle = read("EBX", 1e-8, towards_z.run) - read("EBX", 1e-8, line)
    assert np.ptp(angle) == pytest.approx(100.0 * 1e-8 * way, rel=1e-3)
