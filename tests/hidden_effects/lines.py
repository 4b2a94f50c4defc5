"""Lines: one axis (or all three, along a diagonal) from target to target and back, sensed by a laser or a probe."""

from collections.abc import Iterator, Mapping

import numpy as np

from tests.hidden_effects.design import Design
from tests.hidden_effects.machine import LETTERS, Array, Machine
from tests.hidden_effects.rows import Rows, unit
from tests.hidden_effects.state import RunPlan

OVERTRAVEL = 3.0  # mm beyond the last target of a line, before it is turned back
MARGIN = 5.0  # mm that a line stays within the travel
DWELL_S, RAPID = 3.0, 100.0  # s at a target; mm/s between targets
OFFSETS = ((0.2, 0.3), (0.8, 0.25), (0.3, 0.8), (0.7, 0.75), (0.5, 0.15), (0.1, 0.6))  # shares of the other travels
BRACKETS = ((60.0, -40.0), (-80.0, 20.0), (30.0, 90.0), (-50.0, -70.0), (90.0, 10.0), (10.0, 80.0))  # mm, at the tool

Source = np.random.Generator


def laser_runs(machine: Machine, design: Design, source: Source) -> Iterator[tuple[RunPlan, Rows]]:
    """Lines along the axes and, where wanted, across them and along the diagonals."""
    for axis in machine.linear:
        for number in range(design.lines):
            yield from _line(machine, design, source, axis, number, axis)
    if design.straightness:
        for axis in machine.linear:
            for across in (other for other in machine.linear if other != axis):
                yield from _line(machine, design, source, axis, len(OFFSETS) - 1, across)
    if design.diagonals:
        for number, corner in enumerate(((1, 1, 1), (1, -1, 1), (-1, 1, 1), (-1, -1, 1))):
            yield from _diagonal(machine, design, source, number, corner)


def gauge_runs(machine: Machine, design: Design, source: Source) -> Iterator[tuple[RunPlan, Rows]]:
    """A step gauge along X."""
    yield from _line(machine, design, source, "X", len(OFFSETS) - 2, "X", gauge=True)


def _line(
    machine: Machine,
    design: Design,
    source: Source,
    axis: str,
    number: int,
    sensed: str,
    gauge: bool = False,
) -> Iterator[tuple[RunPlan, Rows]]:
    """One line of an axis, sensed along that axis or across it; other axes stand at the offsets of its number."""
    others = [other for other in machine.linear if other != axis]
    home = dict.fromkeys(machine.axes, 0.0)
    bracket = np.zeros(3)
    for other, share, reach in zip(others, OFFSETS[number], BRACKETS[number], strict=True):
        low, high = machine.travel[other]
        home[other] = round(low + share * (high - low), 3)
        bracket[LETTERS.index(other)] = reach
    low, high = machine.travel[axis]
    home[axis] = min(max(0.0, low), high)
    targets = _targets(design, source, low + MARGIN, high - MARGIN)
    name = "G" if gauge else f"{axis}{number + 1}" if sensed == axis else f"S{axis}{sensed}"
    yield from _run_of_line(
        machine,
        design,
        name,
        {axis: targets},
        home,
        unit(sensed),
        bracket,
        moves_workpiece=machine.carries_workpiece(axis),
        instrument="probe" if gauge else "laser",
    )


def _diagonal(
    machine: Machine, design: Design, source: Source, number: int, corner: tuple[int, int, int]
) -> Iterator[tuple[RunPlan, Rows]]:
    share = _targets(design, source, 0.04, 0.96)
    home, moved, way = dict.fromkeys(machine.axes, 0.0), {}, np.zeros(3)
    for axis, sign in zip(machine.linear, corner, strict=True):
        low, high = machine.travel[axis]
        moved[axis] = np.round((low if sign > 0 else high) + sign * share * (high - low), 3)
        home[axis] = low if sign > 0 else high
        way["XYZ".index(axis)] = sign * (high - low) * (-1 if machine.carries_workpiece(axis) else 1)
    direction = way / np.linalg.norm(way)
    yield from _run_of_line(machine, design, f"D{number + 1}", moved, home, direction, np.zeros(3))


def _run_of_line(
    machine: Machine,
    design: Design,
    name: str,
    moved: Mapping[str, Array],
    home: Mapping[str, float],
    direction: Array,
    bracket: Array,
    moves_workpiece: bool = False,
    instrument: str = "laser",
) -> Iterator[tuple[RunPlan, Rows]]:
    """The repeats of a line. The part that moves carries the target, the other one the reference, in line with it."""
    start = {axis: np.array([value]) for axis, value in home.items()}
    seen = machine.coordinates(("tool", "workpiece"), start, bracket)[:, 0] - 100.0 * direction
    tool, workpiece = ("tool", bracket), ("workpiece", np.round(seen, 3))
    ends = (workpiece, tool) if moves_workpiece else (tool, workpiece)
    once = _there_and_back(machine, moved, home)
    if design.one_run:
        yield RunPlan(name, instrument, *ends, name, home, direction), _again(once, design.repeats)
        return
    for repeat in range(design.repeats):
        run = f"{name}-{repeat + 1}" if design.repeats > 1 else name
        yield RunPlan(run, instrument, *ends, name, home, direction), once


def _targets(design: Design, source: Source, low: float, high: float) -> Array:
    targets = np.linspace(low, high, design.targets)
    if design.jitter:
        most = 0.4 * (targets[1] - targets[0])
        if design.off is not None:
            most = min(most, design.off)
        targets[1:-1] += source.uniform(-1.0, 1.0, design.targets - 2) * most
    return np.round(targets, 3 if high - low > 2.0 else 6)


def _there_and_back(machine: Machine, moved: Mapping[str, Array], home: Mapping[str, float]) -> Rows:
    count = 2 * len(next(iter(moved.values())))
    still, never = np.zeros(count), np.full(count, np.inf)
    positions = {axis: np.full(count, home[axis]) for axis in machine.axes}
    directions, since = dict.fromkeys(machine.axes, still), dict.fromkeys(machine.axes, never)
    longest = np.zeros(count)
    for axis, targets in moved.items():
        positions[axis] = there = np.concatenate([targets, targets[::-1]])
        forward = np.sign(targets[-1] - targets[0])
        directions[axis] = np.repeat([forward, -forward], len(targets))
        first = np.abs(targets - targets[0]) + OVERTRAVEL
        since[axis] = np.concatenate([first, np.abs(targets[::-1] - targets[-1]) + OVERTRAVEL])
        longest = np.maximum(longest, np.abs(np.diff(there, prepend=there[0])))
    time = np.cumsum(DWELL_S + longest / RAPID)
    velocity = dict.fromkeys(machine.axes, still)
    return Rows(positions, directions, velocity, since, time, np.full(count, np.nan), float(time[-1]))


def _again(once: Rows, repeats: int) -> Rows:
    def tiled(values: Mapping[str, Array]) -> dict[str, Array]:
        return {axis: np.tile(array, repeats) for axis, array in values.items()}

    pause = once.lasts + 2 * DWELL_S
    time = np.concatenate([once.time + pause * k for k in range(repeats)])
    feed = np.tile(once.feed, repeats)
    rows = (tiled(once.positions), tiled(once.directions), tiled(once.velocity), tiled(once.since_reversal))
    return Rows(*rows, time, feed, float(time[-1]))
