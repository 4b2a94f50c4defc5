"""Axis positions of paths through the travels of a machine: lines, places, and ways that a tool point follows."""

from collections.abc import Iterator, Mapping
from itertools import product

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import column
from trueaxis.measurement.setup import Vector

SHARE = 0.5  # of the positions of a path that must be within the travels
TILT = 45.0  # deg: at which other rotary axes stand, besides home
TURN, STEPS = 180.0, 73  # deg: a rotary axis is turned this far to either side at most, in so many positions
FEWEST, MOST = 8, 25  # positions of a turn that are read
STATIONS = 16  # of a line: waves of an eighth of it are resolved
GRID, PLATE = 5, 400.0  # positions along a side, mm: of a calibrated plate that is probed


def follow_turn(machine: IdentifiedMachine, positions: FloatArray, tool: Vector, way: FloatArray) -> FloatArray | None:
    """(n_axes, m): positions with the linear axes such that a tool point is at `way` (3, n) in the workpiece frame.

    Of a turn the longest part that is within the travels, thinned out; None where it is short, or no axes reach it.
    """
    reached = _reached(machine, positions, tool, way)
    if reached is None:
        return None
    first, last = _longest(reached[1])
    if last - first < FEWEST:
        return None
    kept = np.unique(np.linspace(first, last - 1, min(last - first, MOST)).round().astype(np.int64))
    return np.ascontiguousarray(reached[0][:, kept])


def follow_circle(
    machine: IdentifiedMachine, positions: FloatArray, tool: Vector, way: FloatArray
) -> FloatArray | None:
    """The same for a way that ends where it began: all of it, else its longest arc, SHARE of it at least."""
    reached = _reached(machine, positions, tool, way)
    if reached is None:
        return None
    found, within = reached
    if within.all():
        return found
    first, last = _longest(np.tile(within, 2))
    if last - first < SHARE * within.size:
        return None
    return np.ascontiguousarray(np.tile(found, 2)[:, first:last])


def _longest(within: BoolArray) -> tuple[int, int]:
    """The first index of the longest row of true values, and that behind its last."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], within.astype(np.int8), [0]]))).reshape(-1, 2)
    first, last = max(edges.tolist(), key=lambda edge: edge[1] - edge[0], default=(0, 0))
    return first, last


def _reached(
    machine: IdentifiedMachine, positions: FloatArray, tool: Vector, way: FloatArray
) -> tuple[FloatArray, BoolArray] | None:
    """All positions, and (n,) whether each is within the travels; None where no linear axes reach the way."""
    linear = [index for index, axis in enumerate(machine.axes) if axis in LINEAR]
    start = positions.copy()
    start[linear] = 0.0
    seen = machine.view_ideal("tool_in_workpiece", start, column(tool))
    slopes = np.empty((positions.shape[1], 3, len(linear)))
    for place, index in enumerate(linear):
        moved = start.copy()
        moved[index] = 1.0
        slopes[:, :, place] = (machine.view_ideal("tool_in_workpiece", moved, column(tool)) - seen).T
    if len(linear) != 3 or np.abs(np.linalg.det(slopes)).min(initial=1.0) < 1e-6:
        return None
    found = start
    found[linear] = np.linalg.solve(slopes, (way - seen).T[:, :, np.newaxis])[:, :, 0].T
    found = np.round(found, 3) + 0.0
    limits = np.array([machine.travel[axis] for axis in machine.axes])
    within = np.asarray(((found >= limits[:, :1]) & (found <= limits[:, 1:])).all(axis=0))
    return found, within


def line(machine: IdentifiedMachine, ends: Mapping[str, tuple[float, float]]) -> FloatArray:
    """(n_axes, 2 STATIONS - 1): axes together from one share of their travels to another and back, the rest at home."""
    rows = {
        axis: np.linspace(at_share(machine, axis, first), at_share(machine, axis, last), STATIONS)
        for axis, (first, last) in ends.items()
    }
    return there_and_back(rows_of(machine, rows, STATIONS))


def grid(machine: IdentifiedMachine, plane: tuple[str, str], at: Mapping[str, float]) -> FloatArray:
    """(n_axes, 2 GRID^2 - 1): over a plate about the middle of the plane and back, the other axes at positions."""
    sides = []
    for axis in plane:
        low, high = machine.travel[axis]
        half = 0.5 * min(high - low, PLATE)
        sides.append(0.5 * (low + high) + np.linspace(-half, half, GRID))
    rows = {plane[0]: np.repeat(sides[0], GRID), plane[1]: np.tile(sides[1], GRID)}
    rows |= {axis: np.full(GRID**2, position) for axis, position in at.items()}
    return there_and_back(rows_of(machine, rows, GRID**2))


def rows_of(machine: IdentifiedMachine, rows: Mapping[str, FloatArray], count: int) -> FloatArray:
    """(n_axes, count): axes at their positions (count,), the rest at home, rounded as programs are."""
    home = home_position(machine)
    return np.round(np.array([rows.get(axis, np.full(count, home[axis])) for axis in machine.axes]), 3) + 0.0


def there_and_back(positions: FloatArray) -> FloatArray:
    """(n_axes, 2 n - 1): a path and the same backwards."""
    return np.ascontiguousarray(np.hstack([positions, positions[:, -2::-1]]))


def places(machine: IdentifiedMachine) -> list[FloatArray]:
    """(n_axes, 1) each: the middle of the linear travels, and every combination of their quarters; the rest at home."""
    linear, home = linear_axes(machine), home_position(machine)
    found = []
    for shares in [(0.5,) * len(linear), *product((0.25, 0.75), repeat=len(linear))]:
        at = {axis: at_share(machine, axis, share) for axis, share in zip(linear, shares, strict=True)}
        found.append(np.array([[at.get(axis, home[axis])] for axis in machine.axes]))
    return found


def tilted(machine: IdentifiedMachine, axis: str, place: FloatArray) -> Iterator[FloatArray]:
    """A place as it is, and with every other rotary axis at TILT."""
    yield place
    others = [machine.axes.index(other) for other in rotary_axes(machine) if other != axis]
    if others:
        limits = np.array([machine.travel[machine.axes[index]] for index in others])
        other = place.copy()
        other[others, 0] = np.clip(TILT, limits[:, 0], limits[:, 1])
        yield other


def turn(machine: IdentifiedMachine, axis: str, place: FloatArray) -> FloatArray:
    """(n_axes, STEPS): a rotary axis through its travel, TURN to either side at most, the others at a place."""
    low, high = machine.travel[axis]
    found = np.repeat(place, STEPS, axis=1)
    found[machine.axes.index(axis)] = np.linspace(max(low, -TURN), min(high, TURN), STEPS)
    return found


def at_share(machine: IdentifiedMachine, axis: str, share: float) -> float:
    """A share of the travel of an axis, mm or deg."""
    low, high = machine.travel[axis]
    return low + (high - low) * share


def home_position(machine: IdentifiedMachine) -> dict[str, float]:
    """Every axis at 0, or at the end of its travel next to it."""
    return {axis: min(max(0.0, low), high) for axis, (low, high) in machine.travel.items()}


def linear_axes(machine: IdentifiedMachine) -> list[str]:
    """In the order of the machine."""
    return [axis for axis in machine.axes if axis in LINEAR]


def rotary_axes(machine: IdentifiedMachine) -> list[str]:
    """In the order of the machine."""
    return [axis for axis in machine.axes if axis not in LINEAR]
