"""A probe on a sphere: the rotary axes take poses, the linear axes bring the probe back to the sphere."""

from dataclasses import replace

import numpy as np

from tests.worlds.kinematics import coordinates, follow
from tests.worlds.lines import RAPID, path_since_turn, steps_taken, three, way_since_turn
from tests.worlds.machine import Array, Machine
from tests.worlds.plan import Habits, Measurement, Run, Track

Source = np.random.Generator

FEWEST_POSES = 5


def draw_sphere(source: Source, machine: Machine, habits: Habits, name: str, frame: str) -> Measurement:
    """Three runs that sense X, Y and Z at the same poses; empty where too few poses can be reached."""
    shortest = min(np.ptp(machine.travel(axis)) for axis in machine.linear)
    middle = {axis: np.array([np.round(np.mean(machine.travel(axis)), 2)]) for axis in machine.linear}
    middle |= {axis: np.array([machine.home(axis)]) for axis in machine.rotary}
    tool = np.round(source.uniform(-1, 1, 3) * 0.3 * habits.bracket, 1)
    met = coordinates(machine, "tool", "workpiece", middle, tool, {}, {})[0]
    ball = np.round(met + source.uniform(-0.12, 0.12, 3) * shortest, 2)
    poses = _poses(source, machine, habits)
    positions = {axis: np.round(values, 4) for axis, values in (follow(machine, poses, tool, ball) | poses).items()}
    inside = np.ones(len(next(iter(poses.values()))), bool)
    for axis in machine.linear:
        low, high = machine.travel(axis)
        inside &= (positions[axis] > low) & (positions[axis] < high)
    if inside.sum() < FEWEST_POSES:
        return Measurement(())
    positions = {axis: np.array(values[inside]) for axis, values in positions.items()}
    home = {axis: float(values[0]) for axis, values in positions.items()}
    order = np.tile(np.arange(int(inside.sum())), habits.repeats)
    positions = {axis: values[order] for axis, values in positions.items()}
    directions = {axis: steps_taken(values, home[axis]) for axis, values in positions.items()}
    since = {axis: way_since_turn(values, directions[axis], habits.overtravel) for axis, values in positions.items()}
    longest = np.max([np.abs(np.diff(v, prepend=v[0])) for v in positions.values()], axis=0)
    count = len(order)
    base = source.uniform(3.0, 8.0)
    zero = dict.fromkeys(machine.axes, np.zeros(count))
    time = np.cumsum(base + longest / RAPID)
    never = {axis: np.full(count, np.inf) for axis in positions}
    path = {axis: path_since_turn(values, positions, positions[axis]) for axis, values in since.items()}
    track = Track(positions, directions, since, path, never, zero, time, np.full(count, np.nan))
    run = Run(name, "probe", ("tool", three(tool)), ("workpiece", three(ball)), frame, name, home)
    runs = []
    for k, letter in enumerate("XYZ"):
        own = replace(run, id=f"{name}-{letter}", direction=three(np.eye(3)[k]))
        runs.append((own, replace(track, time=time + 1.0 * k)))
    return Measurement(tuple(runs), ("probe",))


def _poses(source: Source, machine: Machine, habits: Habits) -> dict[str, Array]:
    """One axis at a time, then a grid of all."""
    count = min(max(habits.targets, 6), 24)
    start = {axis: machine.home(axis) for axis in machine.rotary}
    rows = [start]
    for axis in machine.rotary:
        low, high = machine.travel(axis)
        rows += [start | {axis: float(value)} for value in np.round(np.linspace(low, high, count), 3)]
    rows += [
        {axis: float(np.round(source.uniform(*machine.travel(axis)), 2)) for axis in machine.rotary}
        for _ in range(2 * count)
    ]
    return {axis: np.array([row[axis] for row in rows]) for axis in machine.rotary}
