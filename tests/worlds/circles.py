"""Ball bars: circles and arcs of two linear axes, and turns of a rotary axis that the linear axes follow."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from scipy.interpolate import CubicSpline

from tests.worlds.kinematics import coordinates, follow
from tests.worlds.lines import three
from tests.worlds.machine import Array, Machine
from tests.worlds.plan import Habits, Measurement, Run, Track

Source = np.random.Generator

FINER = 30  # steps of a path for one of its samples
FREE_OF_REVERSALS = 1.6  # samples next to a reversal that are left out, in steps
SLOWEST_SHARE = 1e-9
FARTHER = 1e-3  # mm or deg, than what rounding moves an axis by


def draw_circle(source: Source, machine: Machine, habits: Habits, name: str, plane: str, arc: bool) -> Measurement:
    """Both directions of a circle or an arc in the plane of two axes, about a random centre, at every feed."""
    widths = {axis: np.ptp(machine.travel(axis)) for axis in machine.linear}
    largest = 0.48 * min(widths[axis] for axis in plane)
    radius = float(np.round(largest * source.uniform(0.35, 1.0), 1))
    middle = {axis: machine.home(axis) for axis in machine.rotary}
    for axis in machine.linear:
        low, high = machine.travel(axis)
        room = radius if axis in plane else 0.05 * (high - low)
        middle[axis] = float(np.round(source.uniform(low + 1.02 * room, high - 1.02 * room), 2))
    tool = np.round(source.uniform(-1, 1, 3) * 0.3 * habits.bracket, 1)
    cone = source.random() < 0.3
    height = float(np.round(source.uniform(0.2, 0.6) * radius, 1)) if cone else 0.0
    normal = next(letter for letter in "XYZ" if letter not in plane)
    ball = _ball(machine, middle, tool, -height * np.eye(3)["XYZ".index(normal)])
    length = float(np.round(np.hypot(radius, height), 4))
    start = source.uniform(0, 2 * np.pi)
    extent = source.uniform(np.pi / 3, 1.5 * np.pi) if arc else 2 * np.pi
    run = Run(name, "ballbar", ("tool", three(tool)), ("workpiece", three(ball)), "workpiece", name, None, None, length)
    pairs = []
    for repeat in range(habits.repeats if habits.as_runs else 1):
        for feed in habits.feeds:
            for way in (1, -1):
                track = _circle_track(machine, habits, plane, middle, radius, (start, extent, way), feed)
                mark = f"-{repeat + 1}" if habits.as_runs and habits.repeats > 1 else ""
                ident = f"{name}-F{feed:.0f}-{'ccw' if way > 0 else 'cw'}{mark}"
                pairs.append((replace(run, id=ident, plane=plane), track))
    return Measurement(tuple(pairs), ("arc" if arc else "circle", *(["long_bar"] if cone else [])))


def draw_turn(source: Source, machine: Machine, habits: Habits, name: str, axis: str) -> Measurement:
    """A rotary axis turns, X Y Z follow; the bar stands radial, tangential or axial to it. Empty where the travels do
    not let the linear axes follow.
    """
    shortest = min(np.ptp(machine.travel(letter)) for letter in machine.linear)
    length = float(np.round(source.uniform(0.1, 0.25) * min(shortest, 1500.0), 1))
    middle = {letter: float(np.round(np.mean(machine.travel(letter)), 2)) for letter in machine.linear}
    middle |= {letter: machine.home(letter) for letter in machine.rotary}
    tool = np.zeros(3)
    bar = np.eye(3)[source.integers(3)]
    ball = _ball(machine, middle, tool, source.uniform(-0.1, 0.1, 3) * shortest)
    low, high = machine.travel(axis)
    low, high = max(low, -360.0), min(high, low + 360.0, 360.0)
    turned = np.linspace(low, high, habits.samples + 2)[1:-1]
    rotary = {letter: np.full(len(turned), middle[letter]) for letter in machine.rotary} | {axis: turned}
    direction = bar if machine.carries("workpiece", axis) else _turning_bar(machine, axis, bar, turned)
    followed = follow(machine, rotary, tool, ball + length * direction)
    positions: dict[str, Array] = {a: np.asarray(np.round(v, 5), float) for a, v in (followed | rotary).items()}
    inside = np.ones(len(turned), bool)
    for letter in machine.linear:
        low, high = machine.travel(letter)
        inside &= (positions[letter] >= low) & (positions[letter] <= high)
    if inside.sum() < 0.4 * len(turned):
        return Measurement(())
    edges = np.flatnonzero(np.diff(np.concatenate([[0], inside.astype(int), [0]])))
    begin, end = max(zip(edges[::2], edges[1::2], strict=True), key=lambda pair: pair[1] - pair[0])
    positions = {letter: np.array(values[begin:end]) for letter, values in positions.items()}
    run = Run(name, "ballbar", ("tool", three(tool)), ("workpiece", three(ball)), "workpiece", name, None, None, length)
    pairs = []
    for way in (1, -1):
        there = {letter: values[::way] for letter, values in positions.items()}
        track = _path_track(there, axis, speed=source.uniform(2.0, 8.0))
        pairs.append((replace(run, id=f"{name}-{'ccw' if way > 0 else 'cw'}"), track))
    return Measurement(tuple(pairs), ("rotary_turn",))


def _turning_bar(machine: Machine, axis: str, bar: Array, turned: Array) -> Array:
    """The bar turns with the head that swings the tool, (n, 3)."""
    letter = "ABC".index(axis)
    if bar[letter]:
        return np.broadcast_to(bar, (len(turned), 3))
    angle = np.radians(machine.body_of(axis).sense * turned)[:, None]
    side = np.cross(np.eye(3)[letter], bar)
    return np.asarray(np.cos(angle) * bar + np.sin(angle) * side, float)


def _ball(machine: Machine, middle: Mapping[str, float], tool: Array, shift: Array) -> Array:
    centre = {axis: np.array([value]) for axis, value in middle.items()}
    met = coordinates(machine, "tool", "workpiece", centre, tool, {}, {})[0]
    return np.asarray(np.round(met + shift, 4), float)


def _circle_track(
    machine: Machine,
    habits: Habits,
    plane: str,
    middle: Mapping[str, float],
    radius: float,
    path: tuple[float, float, int],
    feed: float,
) -> Track:
    """path: start and extent of the angle, rad, and the sense as the workpiece sees it."""
    start, extent, way = path
    rounds = 1 if habits.as_runs or extent < 2 * np.pi else habits.repeats
    step = extent / habits.samples
    passed: Array = step * (np.arange(float(habits.samples * rounds)) + 0.5)
    angle = start + passed if way > 0 else start + extent * rounds - passed
    if habits.leave_out:
        off = np.abs(np.mod(angle + np.pi / 4, np.pi / 2) - np.pi / 4)
        kept = off > FREE_OF_REVERSALS * step
        angle, passed = angle[kept], passed[kept]
    time: Array = np.asarray(passed * radius * 60.0 / feed, float)
    count, speed = len(angle), feed / 60.0
    zero, never = np.zeros(count), np.full(count, np.inf)
    positions = {axis: np.full(count, middle[axis]) for axis in machine.axes}
    directions, velocity = dict.fromkeys(machine.axes, zero), dict.fromkeys(machine.axes, zero)
    since: dict[str, Array] = dict.fromkeys(machine.axes, never)
    gone: dict[str, Array] = dict.fromkeys(machine.axes, never)
    turned: dict[str, Array] = dict.fromkeys(machine.axes, never)
    for axis, phase in zip(plane, (angle, angle - np.pi / 2), strict=True):
        body = machine.body_of(axis)
        side = body.sense * (-1.0 if machine.carries("workpiece", axis) else 1.0)
        positions[axis] = np.round(middle[axis] + side * radius * np.cos(phase), 5)
        velocity[axis] = -way * side * speed * np.sin(phase)
        directions[axis] = np.sign(velocity[axis])
        since[axis] = radius * (1.0 - np.cos(np.mod(way * phase, np.pi)))
        gone[axis] = radius * np.mod(way * phase, np.pi)
        turned[axis] = gone[axis] / speed
    return Track(positions, directions, since, gone, turned, velocity, time, np.full(count, feed))


def _path_track(positions: Mapping[str, Array], axis: str, speed: float) -> Track:
    """A path at a steady speed of one rotary axis, deg/s; the others follow it smoothly and turn between samples."""
    count = len(positions[axis])
    time: Array = np.asarray(np.abs(positions[axis] - positions[axis][0]) / speed, float)
    courses = {letter: CubicSpline(time, values) for letter, values in positions.items()}
    velocity: dict[str, Array] = {letter: course(time, 1) for letter, course in courses.items()}
    velocity = {letter: np.where(np.abs(v) > SLOWEST_SHARE, v, 0.0) for letter, v in velocity.items()}
    directions = {letter: np.sign(values) for letter, values in velocity.items()}
    since, path, turned = ({letter: np.full(count, np.inf) for letter in positions} for _ in range(3))
    fine = np.linspace(time[0], time[-1], FINER * count)
    steps = np.linalg.norm([np.diff(courses[letter](fine)) for letter in positions if letter in "XYZ"], axis=0)
    gone = np.concatenate([[0.0], np.cumsum(steps)])
    for letter, course in courses.items():
        moves = np.ptp(positions[letter]) > FARTHER
        for turn in np.sort(course.derivative().roots(extrapolate=False)) if moves else []:
            after = time > turn
            since[letter][after] = np.abs(positions[letter] - course(turn))[after]
            path[letter][after] = (np.interp(time, fine, gone) - np.interp(turn, fine, gone))[after]
            turned[letter][after] = (time - turn)[after]
    linear: Array = np.stack([velocity[letter] for letter in positions if letter in "XYZ"])
    feed: Array = np.asarray(60.0 * np.sqrt((linear**2).sum(axis=0)), float)
    return Track(positions, directions, since, path, turned, velocity, time, np.where(feed > 1.0, feed, np.nan))
