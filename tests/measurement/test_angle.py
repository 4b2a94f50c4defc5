"""Angle instruments and displacement sensors: readings against exact rotations, files, and faults."""

import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import polars as pl
import pytest
from scipy.spatial.transform import Rotation

from tests.exact_chain import ExactChain
from tests.kernels import emitted
from tests.machines import FIVE_AXIS, ROOT, machine_of
from trueaxis.cli.main import main
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.io.faults import InputError
from trueaxis.jobs.load import load_data
from trueaxis.machine import read_machine
from trueaxis.measurement.instrument_kinds import ARM
from trueaxis.measurement.reading_model import expected_reading
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import load_kernels
from trueaxis.model.model import MachineModel

TRUE = 'rotations = "true"\n' + FIVE_AXIS.read_text()
DMU = ROOT / "machines" / "dmu60p.toml"
SETUP = """schema = 1
machine = "dmu60p"
[device.A]
resolution_urad = 0.05
[[run]]
id = "pitch"
instrument = "angle"
device = "A"
direction = [0.0, 0.0, 1.0]
target = { on = "tool" }
[[run]]
id = "warm"
instrument = "displacement"
direction = [0.0, 0.0, 1.0]
target = { on = "tool", point = [0.0, 0.0, 0.0] }
home = { X = 100.0, Y = 100.0, Z = 100.0 }
"""


@pytest.fixture(scope="module")
def spec(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("spec") / "machine.toml"
    path.write_text(TRUE)
    return path


@pytest.fixture(scope="module")
def model(spec: Path) -> MachineModel:
    machine = machine_of(TRUE)
    source = np.random.default_rng(1)
    curves: dict[str, Curve] = {}
    for name in machine.components:
        reach = max(abs(end) for end in machine.travel[name.axis])
        size = 1e-4 if name.is_rotation else 0.05
        drawn = source.normal(0.0, size, 2) / np.array([1.0, reach])
        curves[name] = PolynomialCurve(powers=(0, 1), coefficients=tuple(drawn.tolist()))
    values = {name: float(source.normal(0.0, 100.0)) for name in machine.dimensions}
    values |= {name: float(source.normal(0.0, 1e-4)) for name in machine.location_errors}
    kernels = load_kernels(machine, spec, emitted(TRUE), backend="numpy")
    return MachineModel(machine, kernels, ErrorValues(machine=machine.name, parameters=values, motion_errors=curves))


HOME = {"X": 20.0, "Y": -30.0, "Z": 10.0, "A": 0.0, "B": 0.0, "C": 0.0}
AXIS = (0.48, -0.6, 0.64)
RUNS = [
    ("tool", "bed", "bed"), ("workpiece", "bed", "bed"), ("tool", "workpiece", "bed"),
    ("tool", "workpiece", "workpiece"), ("workpiece", "bed", "workpiece"), ("tool", "bed", "workpiece"),
]  # fmt: skip


def angle_run(machine: MachineModel, target: str, reference: str, frame: str) -> Run:
    home = {axis: HOME[axis] for axis in machine.axes}
    return Run(
        id="A",
        instrument="angle",
        target=PointOn(target),  # type: ignore[arg-type]
        reference=PointOn(reference),  # type: ignore[arg-type]
        frame=frame,  # type: ignore[arg-type]
        home=home,
        direction=AXIS,
    )


def poses(machine: MachineModel, count: int = 6) -> np.ndarray:
    source = np.random.default_rng(5)
    return np.array([source.uniform(*machine.travel[axis], count) for axis in machine.axes])


def turned(machine: MachineModel, pose: dict[str, float], run: Run) -> float:
    """Rotation of the target less that of the reference about the axis of the run, actual against ideal, rad."""
    chain, values = ExactChain(TRUE), dict(machine.errors.parameters)
    for name, curve in machine.errors.motion_errors.items():
        values[name] = float(curve(np.array([pose[name[2]]]))[0])
    ideal = {name: value for name, value in values.items() if name in machine.dimensions}
    total = np.zeros(3)
    for end, sign in ((run.target, 1.0), (run.reference, -1.0)):
        if end.on != run.frame:
            frames = []
            for each in (values, ideal):
                ends = [chain.to_bed(chain.ends[body], pose, each) for body in (end.on, run.frame)]
                frames.append(np.array((ends[1] ** -1 * ends[0]).tolist(), dtype=float)[:3, :3])
            total += sign * Rotation.from_matrix(frames[0] @ frames[1].T).as_rotvec()
    return float(np.array(AXIS) @ total)


@pytest.mark.parametrize("ends", RUNS, ids=" ".join)
def test_a_reading_is_the_rotation_of_exact_chains(model: MachineModel, ends: tuple[str, str, str]) -> None:
    run, positions = angle_run(model, *ends), poses(model)
    found = expected_reading(model, run, positions) / ARM
    at = [dict(zip(model.axes, pose.tolist(), strict=True)) for pose in positions.T]
    right = np.array([turned(model, pose, run) for pose in at]) - turned(model, dict(run.home), run)
    assert np.abs(right).max() > 5e-5
    assert np.abs(found - right).max() < 2e-11  # third order of 3e-4: what parts a rotation vector from its matrix


def test_its_derivative_is_that_of_the_exact_reading(model: MachineModel) -> None:
    run, positions = angle_run(model, "tool", "workpiece", "bed"), poses(model)
    slopes = sensed(model, run, positions) - sensed_at_home(model, run)
    nothing = model.with_values(
        ErrorValues(machine=model.name, parameters={name: model.errors.parameters[name] for name in model.dimensions})
    )
    step = 1e-7
    for row, name in enumerate((*model.components, *model.location_errors)):
        values = nothing.errors
        if name in model.components:
            values = replace(values, motion_errors={name: PolynomialCurve(powers=(0,), coefficients=(step,))})
        else:
            values = replace(values, parameters={**values.parameters, name: step})
        quotient = expected_reading(nothing.with_values(values), run, positions) / step
        assert np.abs(quotient - slopes[row]).max() < 1e-3, name  # mm per rad at an arm of 1000 mm; second order 1e-4
    translations = [row for row, name in enumerate(model.components) if not name.is_rotation]
    assert np.abs(slopes[translations]).max() < 1e-9


def test_where_the_points_are_does_not_matter(model: MachineModel) -> None:
    run, positions = angle_run(model, "tool", "bed", "bed"), poses(model)
    there = replace(run, target=PointOn("tool", (300.0, -200.0, 150.0)))
    assert np.array_equal(expected_reading(model, run, positions), expected_reading(model, there, positions))


def folder(tmp_path: Path, setup: str = SETUP, rows: str = "") -> Path:
    data = tmp_path / "data"
    data.mkdir(exist_ok=True)
    (data / "setup.toml").write_text(setup)
    turns = "".join(f"pitch,{k},{x},0,0,\n" for k, x in enumerate(range(0, 541, 60)))
    (data / "readings.csv").write_text("run,seq,X,Y,Z,reading\n" + (rows or turns + "warm,0,100,100,100,0.001\n"))
    return data


def test_it_is_read_and_written_in_radians(tmp_path: Path) -> None:
    rows = "pitch,0,10,0,0,1.23e-05\npitch,1,20,0,0,-3.3e-06\nwarm,0,100,100,100,0.0041\n"
    data = folder(tmp_path, rows=rows)
    found = load_data(data, read_machine(DMU))
    assert found.data.readings.reading.tolist() == pytest.approx([1.23e-2, -3.3e-3, 0.0041], rel=1e-14)
    assert found.data.setup.runs[0].device is not None
    assert found.data.setup.runs[0].device.resolution == pytest.approx(0.05e-6 * ARM)
    assert found.to_polars()["reading"].to_list() == [1.23e-05, -3.3e-06, 0.0041]


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("resolution_urad = 0.05", "resolution_um = 0.05", "device.A.resolution_um: is in um"),
        ("resolution_urad = 0.05", "resolution_urad = 0.05\nresolution_um = 0.05", "given beside resolution_um"),
        ('target = { on = "tool" }', 'target = { on = "tool" }\nreference = { on = "tool" }', "does not turn against"),
        ('target = { on = "tool" }', 'target = { on = "tool" }\nlength = 3.0', "an angle has no length"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, old: str, new: str, told: str) -> None:
    assert old in SETUP
    with pytest.raises(InputError) as caught:
        load_data(folder(tmp_path, SETUP.replace(old, new, 1)), read_machine(DMU))
    assert any(told in str(fault) for fault in caught.value.faults), [str(fault) for fault in caught.value.faults]


def test_readings_that_are_no_angles_and_sensors_that_move_are_faults(tmp_path: Path) -> None:
    rows = "pitch,0,10,0,0,1.23\nwarm,0,100,100,100,0.0041\nwarm,1,100,101,100,0.0041\n"
    with pytest.raises(InputError) as caught:
        load_data(folder(tmp_path, rows=rows), read_machine(DMU))
    told = [str(fault) for fault in caught.value.faults]
    assert len(told) == 2
    assert "rad, at most 0.1" in told[0]
    assert "a displacement sensor reads at one pose" in told[1]


def test_simulated_angles_are_those_of_the_curve_with_noise_in_microradians(tmp_path: Path) -> None:
    errors = tmp_path / "e.json"
    curve = {"basis": "polynomial", "powers": [1], "coefficients": [1e-7]}
    tree = {"schema": 1, "machine": "dmu60p", "parameters": {}, "motion_errors": {"ECX": curve}}
    errors.write_text(json.dumps(tree))
    data = folder(tmp_path)
    command = ["simulate", str(DMU), "--errors", str(errors), "--data", str(data), "--kernels", str(ROOT / "generated")]
    assert main([*command, "--out", str(tmp_path / "exact")]) == 0
    exact = pl.read_csv(tmp_path / "exact" / "readings.csv").filter(pl.col("run") == "pitch")
    assert exact["reading"].to_list() == pytest.approx((1e-7 * exact["X"].to_numpy()).tolist(), abs=1e-15)
    noisy = ["--noise-urad", "2", "--seed", "4", "--out", str(tmp_path / "noisy")]
    assert main([*command, *noisy]) == 0
    found = pl.read_csv(tmp_path / "noisy" / "readings.csv").filter(pl.col("run") == "pitch")
    spread = float(np.std(found["reading"].to_numpy() - exact["reading"].to_numpy()))
    assert 1e-6 < spread < 4e-6
    assert math.isclose(
        pl.read_csv(tmp_path / "noisy" / "readings.csv")["reading"][-1], 0.001
    )  # a reading that was there
