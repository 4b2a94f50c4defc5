"""Measuring plans of the paper in a few lines, and readings of them from the independent generator."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from tests.generator.dmu60p import PARAMETERS
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.instruments import ball_bar, laser
from tests.generator.machine import Function, Generator
from trueaxis.estimation.observations import Observations
from trueaxis.identification.estimated import IdentifyOptions
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.model.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]

AXES = ("X", "Y", "Z")
TRAVEL = {"X": 540.0, "Y": 700.0, "Z": 600.0}
HOME = {"X": 0.0, "Y": 0.0, "Z": 0.0}
UNIT: dict[str, Vector] = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
BED = PointOn("bed")

P9_PRINTED, P9_REGULAR = (-54.0, -72.0, -165.0), (-54.0, 72.0, -165.0)


def with_estimation(options: IdentifyOptions, **estimation: Any) -> IdentifyOptions:
    """With fields of its `EstimationOptions` changed."""
    return replace(options, estimation=replace(options.estimation, **estimation))


def tool(run_id: str, along: str, point: Vector, reference: PointOn = BED, home: Mapping[str, float] = HOME) -> Run:
    return Run(
        id=run_id,
        instrument="laser",
        target=PointOn("tool", point),
        reference=reference,
        frame="bed",
        home=home,
        direction=UNIT[along],
    )


def table(run_id: str, along: str, point: Vector, reference: PointOn = BED, home: Mapping[str, float] = HOME) -> Run:
    return Run(
        id=run_id,
        instrument="laser",
        target=PointOn("workpiece", point),
        reference=reference,
        frame="bed",
        home=home,
        direction=UNIT[along],
    )


def paper_runs(p9: Vector = P9_REGULAR, home: Mapping[str, float] = HOME) -> tuple[Run, ...]:
    """Tables 4 and 5, transcribed."""
    k1, k2 = (-75.2, 31.8, 58.3), (-75.2, 81.7, 58.3)
    xy1, xy2 = PointOn("tool", (-187.8, 97.0, -49.127)), PointOn("tool", (-187.8, 97.0, -19.127))
    yz = PointOn("tool", (-220.0, 93.0, -26.0))
    return (
        tool("X-1", "x", (167.0, 30.0, -195.0), home=home),
        tool("X-2", "x", (185.0, 30.0, -175.0), home=home),
        tool("X-3", "x", (232.0, 40.0, -164.0), home=home),
        table("Y-4", "y", (45.0, -85.0, 64.0), home=home),
        table("Y-5", "y", (45.0, -85.0, 115.0), home=home),
        table("Y-6", "y", (150.0, -120.0, 84.0), home=home),
        tool("Z-7", "z", (-100.0, -77.0, 125.0), home=home),
        tool("Z-8", "z", (-54.0, -72.0, 125.0), home=home),
        tool("Z-9", "z", p9, home=home),
        tool("XZ-1x", "x", k1, home=home),
        tool("XZ-2x", "x", k2, home=home),
        tool("XZ-1z", "z", k1, home=home),
        tool("XZ-2z", "z", k2, home=home),
        table("XY-1x", "x", (130.0, 195.0, 75.0), xy1, home=home),
        table("XY-2x", "x", (130.0, 195.0, 105.0), xy2, home=home),
        table("XY-1y", "y", (130.0, 195.0, 75.0), xy1, home=home),
        table("YZ-1y", "y", (113.0, 20.0, 78.0), yz, home=home),
        table("YZ-1z", "z", (113.0, 20.0, 78.0), yz, home=home),
    )


def moving(run: Run) -> str:
    return run.id.split("-")[0]


def line(axes: str, count: int, home: Mapping[str, float] = HOME) -> FloatArray:
    """(3, count): the axes together from 0 to the ends of their travels, the others at home."""
    steps = np.arange(count) / (count - 1)
    return np.array([TRAVEL[axis] * steps if axis in axes else np.full(count, home[axis]) for axis in AXES])


def observed(machine: Generator, runs: Sequence[Run], positions: Sequence[FloatArray]) -> Observations:
    """Readings of the generator, rounded to double once."""
    frames = {id(run): "workpiece" if run.instrument == "ballbar" else run.frame for run in runs}
    readings = []
    for run, at in zip(runs, positions, strict=True):
        ends = {"target": (run.target.on, run.target.point), "reference": (run.reference.on, run.reference.point)}
        for column in at.T:
            pose = dict(zip(AXES, column.tolist(), strict=True))
            if run.length is not None:
                value = ball_bar(machine, pose, length=run.length, frame=frames[id(run)], **ends)
            else:
                assert run.direction is not None
                value = laser(machine, pose, run.home, direction=run.direction, frame=run.frame, **ends)
            readings.append(float(value))
    index = np.repeat(np.arange(len(runs)), [at.shape[1] for at in positions])
    return Observations(
        source="readings.csv",
        runs=tuple(runs),
        run=index,
        positions=np.hstack(list(positions)),
        reading=np.array(readings),
    )


def paper_data(machine: Generator, count: int = 10, p9: Vector = P9_REGULAR) -> Observations:
    runs = paper_runs(p9)
    return observed(machine, runs, [line(moving(run), count) for run in runs])


@cache
def dmu60p_model() -> MachineModel:
    """The checked-in kernels of the paper's machine."""
    return load_model(ROOT / "machines" / "dmu60p.toml", None, ROOT / "generated", backend="numpy")


def bar(run_id: str, height: float, length: float = 150.0) -> Run:
    tool_ball, table_ball = PointOn("tool", (0.0, 0.0, -height)), PointOn("workpiece", (20.0, 30.0, 10.0))
    return Run(
        id=run_id, instrument="ballbar", target=tool_ball, reference=table_ball, frame="bed", home=HOME, length=length
    )


def circle(run: Run, plane: tuple[int, int], count: int) -> FloatArray:
    """Positions that take the tool ball round the workpiece ball at the nominal length, the third axis still."""
    tool_frame, table_frame = (np.array([PARAMETERS[f"q_{body}{letter}"] for letter in "xyz"]) for body in "Tw")
    at_home = tool_frame + run.target.point - table_frame
    angle = 2.0 * np.pi * np.arange(count) / count
    moved = np.repeat((np.array(run.reference.point) - at_home)[:, np.newaxis], count, axis=1)
    assert run.length is not None
    moved[plane[0]] += run.length * np.cos(angle)
    moved[plane[1]] += run.length * np.sin(angle)
    moved[1] *= -1.0  # Y carries the workpiece
    return moved


def mixed_data(truth: dict[str, Function], count: int = 10, seed: int | None = None) -> Observations:
    """The paper's runs and two ball-bar circles, with 0.3 um of noise where a seed is given."""
    lasers = paper_runs()
    bars = (bar("xy", 600.0), bar("xz", 680.0, 120.0))  # the tool frame is 400 mm above the table
    positions = [line(moving(run), count) for run in lasers]
    positions += [circle(bars[0], (0, 1), 36), circle(bars[1], (0, 2), 36)]
    data = observed(generator(truth), (*lasers, *bars), positions)
    return data if seed is None else noisy(data, seed)


def noisy(data: Observations, seed: int, sigma: float = 3e-4) -> Observations:
    noise = np.random.default_rng(seed).normal(0.0, sigma, data.reading.size)
    return replace(data, reading=data.reading + noise)


def joined(*parts: Observations) -> Observations:
    starts = np.cumsum([0, *(len(part.runs) for part in parts)])
    return Observations(
        source="readings.csv",
        runs=tuple(run for part in parts for run in part.runs),
        run=np.concatenate([part.run + start for part, start in zip(parts, starts, strict=False)]),
        positions=np.hstack([part.positions for part in parts]),
        reading=np.concatenate([part.reading for part in parts]),
    )
