"""Readings with effects from the independent generator: hand formulas of the terms, row by row."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import numpy as np

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.instruments import ball_bar, laser
from tests.generator.machine import Function
from tests.identification.data import AXES, TRAVEL, bar, circle, line, moving, paper_runs
from tests.identification.test_paper import DIMENSIONS
from tests.kernels import kernels_at
from tests.machines import DMU60P, FIVE_AXIS, machine_at
from trueaxis.effects.kind import Effect
from trueaxis.estimation.observations import Observations, observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import Run
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import Kernels
from trueaxis.model.model import MachineModel

FEEDS = (500.0, 3000.0)
SIGMA = 3e-4


@dataclass(frozen=True)
class Row:
    """What a term may depend on at one reading; directions and velocity by axis, along: mm, theta: rad."""

    run: Run
    at: Mapping[str, float]
    direction: Mapping[str, float]
    velocity: Mapping[str, float]
    time: float
    temperature: float
    along: float
    theta: float


Term = Callable[[Row], float]


def model_with(*effects: Effect) -> MachineModel:
    return _model(DMU60P, effects, ErrorValues(machine="dmu60p", parameters=DIMENSIONS))


def five_axis(*effects: Effect) -> MachineModel:
    return _model(FIVE_AXIS, effects, ErrorValues(machine="five_axis"))


def _model(path: Path, effects: tuple[Effect, ...], errors: ErrorValues) -> MachineModel:
    module = kernels_at(path)
    routines = {name: getattr(module, name) for name in module.META["routines"]}
    kernels = Kernels(meta=module.META, module=module, routines=routines, backend="numpy", note="")
    return MachineModel(replace(machine_at(path), effects=effects), kernels, errors)


def plan(count: int = 7, samples: int = 24, even: bool = False) -> tuple[list[Run], Readings]:
    """The paper's lines there and back at irregular targets (even: at the same regular ones), and circles in both
    directions at two feeds.
    """
    source = np.random.default_rng(4)
    runs, paths, feeds = [], [], []
    for run in paper_runs():
        share = np.arange(1, count + 1) / count if even else np.sort(source.uniform(0.05, 0.98, count))
        away = line(moving(run), 2)[:, 1:] * share
        runs.append(run)
        paths.append(np.hstack([away, away[:, ::-1] * (1.0 if even else 0.995)]))
        feeds.append(np.nan)
    for ball, plane in ((bar("xy", 600.0), (0, 1)), (bar("xz", 680.0), (0, 2))):
        around = circle(ball, plane, samples)
        for sign in (1, -1):
            for feed in FEEDS:
                runs.append(replace(ball, id=f"{ball.id}{sign:+d}F{feed:g}"))
                paths.append(around[:, ::sign])
                feeds.append(feed)
    sizes = [path.shape[1] for path in paths]
    positions = np.hstack(paths)
    directions = np.hstack([_directions(run, path) for run, path in zip(runs, paths, strict=True)])
    time = 7.0 * np.arange(positions.shape[1], dtype=np.float64)
    return runs, Readings(
        axes=AXES,
        run_ids=tuple(run.id for run in runs),
        run=np.repeat(np.arange(len(runs)), sizes),
        seq=np.concatenate([np.arange(size) for size in sizes]),
        positions=positions,
        directions=directions.astype(np.int8),
        reading=np.zeros(positions.shape[1]),
        given_directions=AXES,
        time=time,
        feed=np.repeat(feeds, sizes),
        temperature=20.0 + 2.0 * np.sin(time / 800.0) + source.normal(0.0, 0.3, time.size),
    )


def measured(
    components: Mapping[str, Term] | None = None,
    readings: Sequence[Term] = (),
    *,
    moved: Mapping[str, tuple[float, float, float]] | None = None,
    seed: int | None = None,
    even: bool = False,
    change: Callable[[Readings], Readings] = lambda one: one,
) -> Observations:
    """Readings with terms on components and on readings, targets moved by run, noise where a seed is given."""
    runs, rows = plan(even=even)
    geometry = _of_geometry(components, moved or {}, even) if components or moved else _of_geometry_alone(even)
    values = geometry + [sum(term(row) for term in readings) for row in _rows(even)]
    if seed is not None:
        values = values + np.random.default_rng(seed).normal(0.0, SIGMA, values.size)
    return observations("readings.csv", runs, change(replace(rows, reading=values)))


@cache
def _of_geometry_alone(even: bool) -> FloatArray:
    """(n,), mm: what most sets have in common."""
    return _of_geometry(None, {}, even)


def _of_geometry(
    components: Mapping[str, Term] | None, moved: Mapping[str, tuple[float, float, float]], even: bool
) -> FloatArray:
    """(n,), mm, of the cubic errors and the terms on components."""
    truth = cubic_errors()
    found: list[float] = []
    first: dict[str, Row] = {}
    for row in _rows(even):
        start = first.setdefault(row.run.id, row)
        found.append(_reading(row.run, row, truth, components or {}, start.time, start.temperature, moved))
    return np.array(found)


@cache
def _rows(even: bool) -> tuple[Row, ...]:
    """Of the plan, run by run."""
    runs, rows = plan(even=even)
    assert rows.feed is not None
    found: list[Row] = []
    for index, run in enumerate(runs):
        mine = np.flatnonzero(rows.run == index)
        velocity = (
            _velocity(rows.positions[:, mine], float(rows.feed[mine[0]])) if run.length else np.zeros((3, mine.size))
        )
        found += [_row(run, rows, int(n), velocity[:, place]) for place, n in enumerate(mine)]
    return tuple(found)


def _row(run: Run, rows: Readings, n: int, velocity: FloatArray) -> Row:
    at = dict(zip(AXES, rows.positions[:, n].tolist(), strict=True))
    assert rows.time is not None
    assert rows.temperature is not None
    # the ideal motion of tool and table: X and Z carry the tool, Y the table
    moved = {"tool": (at["X"], 0.0, at["Z"]), "workpiece": (0.0, at["Y"], 0.0), "bed": (0.0, 0.0, 0.0)}
    away = np.array(moved[run.target.on]) - np.array(moved[run.reference.on])
    theta = 0.0
    if run.length is not None:
        at_tool, at_table = (np.array([PARAMETERS[f"q_{body}{letter}"] for letter in "xyz"]) for body in "Tw")
        tool = moved["tool"] + at_tool + run.target.point
        x, y, z = tool - (moved["workpiece"] + at_table + run.reference.point)
        theta = float(np.arctan2(y, x) if run.id.startswith("xy") else np.arctan2(x, z))
    return Row(
        run,
        at,
        dict(zip(AXES, rows.directions[:, n].astype(float).tolist(), strict=True)),
        dict(zip(AXES, velocity.tolist(), strict=True)),
        float(rows.time[n]),
        float(rows.temperature[n]),
        float(np.array(run.direction) @ away) if run.direction else 0.0,
        theta,
    )


def _reading(
    run: Run,
    row: Row,
    truth: Mapping[str, Function],
    components: Mapping[str, Term],
    time: float,
    temperature: float,
    moved: Mapping[str, tuple[float, float, float]],
) -> float:
    still = dict.fromkeys(AXES, 0.0)
    home = Row(run, still, still, still, time, temperature, 0.0, 0.0)
    errors = dict(truth)
    for name, term in components.items():
        errors[name] = _with_term(truth[name], term(row), term(home), row.at[name[2]])
    machine = generator(errors)
    target = tuple(a + b for a, b in zip(run.target.point, moved.get(run.id, (0.0, 0.0, 0.0)), strict=True))
    ends = {"target": (run.target.on, target), "reference": (run.reference.on, run.reference.point)}
    if run.length is not None:
        return float(ball_bar(machine, row.at, length=run.length, frame="workpiece", **ends))
    assert run.direction is not None
    return float(laser(machine, row.at, run.home, direction=run.direction, frame=run.frame, **ends))


def _with_term(curve: Function, here: float, home: float, position: float) -> Function:
    return lambda s: curve(s) + (here if float(s) == position and position != 0.0 else home)


def _directions(run: Run, path: FloatArray) -> FloatArray:
    before = path[:, -1:] if run.length else np.zeros((3, 1))
    steps = np.sign(np.diff(path, prepend=before, axis=1))
    for n in range(1, steps.shape[1]):
        steps[:, n] = np.where(steps[:, n] == 0.0, steps[:, n - 1], steps[:, n])
    return steps


def _velocity(path: FloatArray, feed: float) -> FloatArray:
    """mm/s along chords over two steps; at the ends from the parabola through three points."""
    way = np.gradient(path, axis=1, edge_order=2)
    return np.asarray(way / np.linalg.norm(way, axis=0) * feed / 60.0)


def off(found: ErrorValues) -> float:
    """Largest difference of any curve from the truth, mm, rotations times 700 mm."""
    truth, worst = cubic_errors(), 0.0
    for name, curve in found.motion_errors.items():
        at = np.linspace(0.0, TRAVEL[name[2]], 11)
        difference = np.abs(curve(at) - np.array([float(truth[name](s)) for s in at])).max()
        worst = max(worst, float(difference) * (700.0 if name[1] in "ABC" else 1.0))
    return worst
