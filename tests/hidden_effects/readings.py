"""Readings of the exact machine, by their definition: displacements along a direction, and distances of balls."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from tests.hidden_effects import hidden, outside
from tests.hidden_effects.curves import Function
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.state import Indices, Plan, RunPlan, State

Located = Mapping[str, float]


@dataclass(frozen=True)
class Truth:
    """What the machine and the set-up really are; balls: plane -> by how much the ball on the workpiece is off, mm."""

    curves: Mapping[str, Function]
    located: Located = field(default_factory=dict)
    effects: tuple[Hidden, ...] = ()
    balls: Mapping[str, Array] = field(default_factory=dict)


def readings(machine: Machine, plan: Plan, truth: Truth) -> Array:
    """(n,), mm, without what is added to readings themselves."""
    errors = component_values(machine, plan.state, truth)
    found = np.empty(len(plan.state.time))
    for index, run in enumerate(plan.runs):
        rows = np.flatnonzero(plan.state.run == index)
        positions = _rows(plan.state.positions, rows)
        at = {name: values[rows] for name, values in errors.items()}
        ends = tuple(point + _shift(run, end, truth) for end, (_, point) in _ends(run))
        if run.length is not None:
            found[rows] = _bar(machine, run, positions, ends, at, truth.located) - run.length
        else:
            home = _home_state(machine, run, plan.state.at(rows))
            at_home = component_values(machine, home, truth)
            actual = _sensed(machine, run, positions, ends, at, truth.located)
            actual -= _sensed(machine, run, home.positions, ends, at_home, truth.located)
            found[rows] = actual - _ideal_sensed(machine, run, positions)
    return found


def component_values(machine: Machine, state: State, truth: Truth) -> dict[str, Array]:
    """Component -> (n,), mm or rad: the curves and the effects upon them."""
    found = {name: curve(state.positions[name[2]]) for name, curve in truth.curves.items()}
    for effect in truth.effects:
        for place in (hidden, outside):
            if effect.kind in place.OF_COMPONENTS:
                term = place.component_terms(effect, machine, state)
                found[effect.component] = found.get(effect.component, 0.0) + term
    return found


def sensitivity(machine: Machine, plan: Plan, component: str) -> Array:
    """Change of the readings per unit of a component error at the reading (not at home), (n,), by a finite step."""
    found, step = np.empty(len(plan.state.time)), 1e-4
    for index, run in enumerate(plan.runs):
        rows = np.flatnonzero(plan.state.run == index)
        positions = _rows(plan.state.positions, rows)
        measured = _sensed if run.length is None else _bar
        moved, still = (
            measured(machine, run, positions, _points(run), {component: np.full(len(rows), value)}, {})
            for value in (step, -step)
        )
        found[rows] = (moved - still) / (2 * step)
    return found


def bar_directions(machine: Machine, plan: Plan) -> Array:
    """Unit vectors of the ideal bars, (3, n); 0 for lines."""
    found = np.zeros((3, len(plan.state.time)))
    for index, run in enumerate(plan.runs):
        if run.length is not None:
            rows = np.flatnonzero(plan.state.run == index)
            found[:, rows] = _vector(machine, run, _rows(plan.state.positions, rows), _points(run), {}, {}) / run.length
    return found


def ideal_along(machine: Machine, plan: Plan) -> Array:
    """Ideal displacement sensed since home, (n,), mm; 0 for bars."""
    found = np.zeros(len(plan.state.time))
    for index, run in enumerate(plan.runs):
        if run.home is not None:
            rows = np.flatnonzero(plan.state.run == index)
            found[rows] = _ideal_sensed(machine, run, _rows(plan.state.positions, rows))
    return found


def polar_angle(machine: Machine, plan: Plan) -> Array:
    """Polar angle of the ideal bar in the plane of its circle, (n,), rad; 0 for all else."""
    found = np.zeros(len(plan.state.time))
    for index, run in enumerate(plan.runs):
        if run.plane:
            rows = np.flatnonzero(plan.state.run == index)
            bar = _vector(machine, run, _rows(plan.state.positions, rows), _points(run), {}, {})
            first, second = ("XYZ".index(letter) for letter in run.plane)
            found[rows] = np.arctan2(bar[second], bar[first])
    return found


def _sensed(
    machine: Machine,
    run: RunPlan,
    positions: Mapping[str, Array],
    points: tuple[Array, ...],
    errors: Mapping[str, Array],
    located: Located,
) -> Array:
    """Target less reference along the sensed direction, in the frame of the bed."""
    bodies = (run.target[0], run.reference[0])
    ends = [
        machine.coordinates((body, "bed"), positions, point, errors, located)
        for body, point in zip(bodies, points, strict=True)
    ]
    direction = np.zeros(3) if run.direction is None else run.direction
    return np.asarray(direction @ (ends[0] - ends[1]), float)


def _ideal_sensed(machine: Machine, run: RunPlan, positions: Mapping[str, Array]) -> Array:
    home = {axis: np.array([value]) for axis, value in (run.home or {}).items()}
    return _sensed(machine, run, positions, _points(run), {}, {}) - _sensed(machine, run, home, _points(run), {}, {})


def _bar(
    machine: Machine,
    run: RunPlan,
    positions: Mapping[str, Array],
    points: tuple[Array, ...],
    errors: Mapping[str, Array],
    located: Located,
) -> Array:
    return np.asarray(np.linalg.norm(_vector(machine, run, positions, points, errors, located), axis=0), float)


def _vector(
    machine: Machine,
    run: RunPlan,
    positions: Mapping[str, Array],
    points: tuple[Array, ...],
    errors: Mapping[str, Array],
    located: Located,
) -> Array:
    """The ball on the tool seen from that on the workpiece, (3, n), mm."""
    target, reference = points
    seen = machine.coordinates((run.target[0], run.reference[0]), positions, target, errors, located)
    return seen - reference[:, np.newaxis]


def _ends(run: RunPlan) -> tuple[tuple[str, tuple[str, Array]], ...]:
    return (("target", run.target), ("reference", run.reference))


def _points(run: RunPlan) -> tuple[Array, ...]:
    return (run.target[1], run.reference[1])


def _shift(run: RunPlan, end: str, truth: Truth) -> Array:
    """By how much a point of the set-up is off, (3,), mm."""
    found = np.zeros(3)
    if end == "reference" and run.plane in truth.balls:
        found = found + truth.balls[run.plane]
    for effect in truth.effects:
        if effect.kind in hidden.OF_SETUP and run.id in effect.runs and (effect.end or "target") == end:
            found = found + effect.size * np.eye(3)["XYZ".index(effect.shift)]
    return found


def _home_state(machine: Machine, run: RunPlan, rows: State) -> State:
    """Where the reading was zeroed: before the run, at rest, no axis come from anywhere."""
    here, never = np.zeros(1), np.full(1, np.inf)
    first = np.array([0])
    return State(
        run=rows.run[first],
        seq=first,
        positions={axis: np.array([value]) for axis, value in (run.home or {}).items()},
        directions=dict.fromkeys(machine.axes, here),
        velocity=dict.fromkeys(machine.axes, here),
        since_reversal=dict.fromkeys(machine.axes, never),
        time=rows.time[first],
        temperature=rows.temperature[first],
        soaked=rows.soaked[first],
        feed=np.full(1, np.nan),
    )


def _rows(values: Mapping[str, Array], rows: Indices) -> dict[str, Array]:
    return {axis: array[rows] for axis, array in values.items()}
