"""Readings of exact machines by their definition, and what the shop makes of them.

Many machines of one design go at once: component errors are (machines, rows), points (machines, rows, 3).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from tests.worlds import effects as known
from tests.worlds.design import Design
from tests.worlds.effects import State, component_term, reading_term
from tests.worlds.kinematics import coordinates
from tests.worlds.machine import Array, Indices, Machine
from tests.worlds.plan import Plan, Run
from tests.worlds.shop import Shop, draw_noise, draw_spoilt, draw_values
from tests.worlds.truth import Truth, stacked

AT_A_TIME = 16  # machines


@dataclass(frozen=True, eq=False)
class Data:
    """reading: (n,), mm, as the display shows it; values: what the unknowns of the shop are."""

    reading: Array
    values: Array


@dataclass(frozen=True, eq=False)
class Off:
    """By how much the points of each run are off, (machines, runs, 3), mm."""

    target: Array
    reference: Array


def measure(design: Design, truth: Truth, seed: int) -> Data:
    """One set of readings of a machine; the seed is of the noise and of the unknowns alone."""
    return measure_all(design, [truth], [seed])[0]


def measure_all(design: Design, truths: Sequence[Truth], seeds: Sequence[int]) -> list[Data]:
    """A set of readings of each of many machines."""
    plan, shop = design.plan, design.shop
    values = [draw_values(np.random.default_rng([seed, 21]), shop) for seed in seeds]
    balls = np.array([_balls(plan, shop, own) for own in values])
    found = []
    for reading, seed, own in zip(exact_readings(design, truths, balls), seeds, values, strict=True):
        source = np.random.default_rng([seed, 22])
        shown = reading + draw_noise(source, plan, shop)
        for unknown, value in zip(shop.unknowns, own, strict=True):
            if not unknown.kind.startswith("centre"):  # these are in the exact readings
                shown[unknown.rows] += unknown.column * value
        shown[shop.outliers] += draw_spoilt(source, shop)
        steps = np.where(shop.resolution > 0, shop.resolution, 1.0)
        shown = np.where(shop.resolution > 0, np.round(shown / steps) * steps, shown)
        found.append(Data(np.round(shown, 9), own))
    return found


def exact_readings(design: Design, truths: Sequence[Truth], balls: Array | None = None) -> Array:
    """Without shop, (m, n), mm, hidden effects included; balls: (m, runs, 3), mm, by how much references are off."""
    machine, plan = design.machine, design.plan
    balls = np.zeros((len(truths), len(plan.runs), 3)) if balls is None else balls
    rows, homes = row_state(machine, plan), home_state(machine, plan)
    no_run = np.arange(len(plan.runs))
    none = Off(np.zeros((1, len(plan.runs), 3)), np.zeros((1, len(plan.runs), 3)))
    ideal = _between(machine, plan.runs, plan.run, rows.positions, none, {}, {})
    ideal = ideal - _between(machine, plan.runs, no_run, homes.positions, none, {}, {})[:, plan.run]
    bars = np.array([run.length is not None for run in plan.runs])[plan.run]
    lengths = np.array([run.length or 0.0 for run in plan.runs])[plan.run]
    directions = np.array([run.direction or (0.0, 0.0, 0.0) for run in plan.runs])[plan.run]
    found = np.empty((len(truths), plan.count))
    for start in range(0, len(truths), AT_A_TIME):
        some = truths[start : start + AT_A_TIME]
        off = _off(plan, some, balls[start : start + AT_A_TIME])
        located = {name: np.array([[truth.located[name]] for truth in some]) for name in machine.locations}
        here = _between(machine, plan.runs, plan.run, rows.positions, off, _errors(some, rows), located)
        home = _between(machine, plan.runs, no_run, homes.positions, off, _errors(some, homes), located)
        sensed = np.sum((here - home[:, plan.run] - ideal) * directions, axis=-1)
        distance = np.linalg.norm(here, axis=-1) - lengths
        found[start : start + AT_A_TIME] = np.where(bars, distance, sensed)
    for number, truth in enumerate(truths):
        found[number] += _effects_on_readings(machine, plan, truth)
    return found


def _between(
    machine: Machine,
    runs: Sequence[Run],
    run: Indices,
    positions: Mapping[str, Array],
    off: Off,
    errors: Mapping[str, Array],
    located: Mapping[str, Array],
) -> Array:
    """Target less reference, (m, k, 3), mm, in the measuring frame of each row's run; run: (k,)."""
    found = np.zeros((len(off.target), len(run), 3))
    for end, sign in (("target", 1.0), ("reference", -1.0)):
        views = [(getattr(one, end)[0], one.measuring_frame) for one in runs]
        points = np.array([getattr(one, end)[1] for one in runs]) + getattr(off, end)
        for on, frame in dict.fromkeys(views):
            own = np.flatnonzero(np.array([view == (on, frame) for view in views])[run])
            at = points[:, run[own]]
            if on != frame:
                there = {axis: values[own] for axis, values in positions.items()}
                values = {name: array[:, own] for name, array in errors.items()}
                at = coordinates(machine, on, frame, there, at, values, located)
            found[:, own] += sign * at
    return found


def _errors(truths: Sequence[Truth], state: State) -> dict[str, Array]:
    """Component errors and the effects upon them, component -> (m, k)."""
    found = stacked(truths, state.positions)
    for number, truth in enumerate(truths):
        for effect in truth.effects:
            if effect.kind in known.ON_COMPONENTS:
                found[effect.component][number] += component_term(effect, state)
    return found


def _off(plan: Plan, truths: Sequence[Truth], balls: Array) -> Off:
    found = Off(np.zeros_like(balls), balls.copy())
    for number, truth in enumerate(truths):
        for effect in truth.effects:
            if effect.kind in known.ON_POINTS:
                reference = effect.kind == "ballbar_centre" or effect.end == "reference"
                ends = found.reference if reference else found.target
                chosen = [index for index, run in enumerate(plan.runs) if run.id in effect.runs]
                ends[number, chosen, "XYZ".index(effect.component)] += effect.size
    return found


def _balls(plan: Plan, shop: Shop, values: Array) -> Array:
    """(runs, 3), mm, by how much the balls on the workpiece are off."""
    found = np.zeros((len(plan.runs), 3))
    for unknown, value in zip(shop.unknowns, values, strict=True):
        if unknown.kind.startswith("centre"):
            found[np.unique(plan.run[unknown.rows]), "XYZ".index(unknown.kind[-1])] = value
    return found


def _effects_on_readings(machine: Machine, plan: Plan, truth: Truth) -> Array:
    chosen = [effect for effect in truth.effects if effect.kind in known.ON_READINGS]
    if not chosen:
        return np.zeros(plan.count)
    along, theta = reading_context(machine, plan)
    return np.asarray(np.sum([reading_term(effect, plan, along, theta) for effect in chosen], axis=0), float)


def reading_context(machine: Machine, plan: Plan) -> tuple[Array, Array]:
    """Ideal displacement since home along the direction (0 for bars), mm, and polar angle of the bar in the plane of
    its circle (0 for all else), rad; (n,) each.
    """
    none = Off(np.zeros((1, len(plan.runs), 3)), np.zeros((1, len(plan.runs), 3)))
    homes = home_state(machine, plan).positions
    here = _between(machine, plan.runs, plan.run, plan.positions, none, {}, {})[0]
    home = _between(machine, plan.runs, np.arange(len(plan.runs)), homes, none, {}, {})[0]
    directions = np.array([run.direction or (0.0, 0.0, 0.0) for run in plan.runs])[plan.run]
    theta = np.zeros(plan.count)
    for index, run in enumerate(plan.runs):
        if run.plane:
            rows = plan.rows(index)
            first, second = ("XYZ".index(letter) for letter in run.plane)
            theta[rows] = np.arctan2(here[rows, second], here[rows, first])
    return np.sum((here - home[plan.run]) * directions, axis=-1), theta


def row_state(machine: Machine, plan: Plan) -> State:
    started = np.array([plan.time[plan.rows(index)[0]] for index in range(len(plan.runs))])[plan.run]
    moving = (plan.directions, plan.since, plan.path, plan.turned, plan.velocity)
    return State(machine, plan.positions, *moving, plan.time, plan.feed, plan.soaked, started)


def home_state(machine: Machine, plan: Plan) -> State:
    """One row per run: where it was zeroed, at rest, no axis come from anywhere, when the run began. Bars, which are
    not zeroed, have their first row there.
    """
    first = np.array([plan.rows(index)[0] for index in range(len(plan.runs))])
    at = {axis: values[first].copy() for axis, values in plan.positions.items()}
    for index, run in enumerate(plan.runs):
        for axis, value in (run.home or {}).items():
            at[axis][index] = value
    count = len(first)
    zero, never = dict.fromkeys(machine.axes, np.zeros(count)), dict.fromkeys(machine.axes, np.full(count, np.inf))
    time = plan.time[first]
    return State(machine, at, zero, never, never, never, zero, time, np.full(count, np.nan), plan.soaked[first], time)
