"""Squareness from the identified curves: Sect. 3.6 of the paper, or the least-squares convention of ISO 230-1.

ISO 230-1 reads the squareness off the least-squares reference lines of two axes, and the straightness from those
lines: a slope common to both is then part of the squareness alone.
"""

from dataclasses import dataclass
from itertools import combinations
from typing import Literal, Protocol

import numpy as np

from trueaxis.error_name import ROTATIONS
from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.identification.paper.grid import BoolArray, Grid, IntArray
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray
from trueaxis.view import View

Choice = Literal["convention", "from-angles", "known"]
NEGLIGIBLE = 1e-12


class Squareness(Protocol):
    """A rule that gives the location errors from the nodes.

    response: (n_location_errors, n_nodes), how the location errors follow from nodes found with none of them.
    """

    @property
    def response(self) -> FloatArray:
        """See the class."""
        ...

    def correction(self, nodes: FloatArray, locations: FloatArray) -> FloatArray:
        """What is to be added to the location errors so that the rule is met, the nodes going along, (n,)."""
        ...


@dataclass(frozen=True, slots=True, eq=False)
class Given:
    """Location errors stay as they are."""

    response: FloatArray

    def correction(self, nodes: FloatArray, locations: FloatArray) -> FloatArray:  # noqa: ARG002
        """Nothing."""
        return np.zeros_like(locations)


@dataclass(frozen=True, slots=True, eq=False)
class LevelLines:
    """The least-squares lines of the straightness are level."""

    response: FloatArray

    def correction(self, nodes: FloatArray, locations: FloatArray) -> FloatArray:  # noqa: ARG002
        """The slopes that the location errors take over."""
        return self.response @ nodes


@dataclass(frozen=True, slots=True, eq=False)
class AxisLine:
    """Direction in which an axis moves its body, seen from the bed, to first order: ideal + by_location @ values.

    ideal: (3,); by_location: (3, n_location_errors), 1/rad.
    """

    axis: str
    ideal: FloatArray
    by_location: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class LinesFromAngles:
    """Eqs. (39)-(43): axis lines from pitch and yaw, squareness from the angles between them.

    slopes: axis -> (3, n_nodes), slope c_uv1 of its line in each direction; angles: (pairs, n_location_errors).
    """

    lines: tuple[AxisLine, ...]
    slopes: dict[str, FloatArray]
    angles: FloatArray
    free: BoolArray
    by_location: FloatArray

    @property
    def response(self) -> FloatArray:
        """First order of the angles, nodes going along with the location errors."""
        own = self._inverse @ self._products()
        return np.asarray(np.linalg.solve(np.eye(own.shape[0]) - own @ self.by_location, own), dtype=np.float64)

    @property
    def _inverse(self) -> FloatArray:
        """(n_location_errors, pairs): the location errors that make given angles; rows of given ones are zero."""
        found = np.zeros(self.angles.T.shape)
        found[self.free] = np.linalg.pinv(self.angles[:, self.free])
        return found

    def correction(self, nodes: FloatArray, locations: FloatArray) -> FloatArray:
        """To the squareness of the lines that the nodes give."""
        directions = [line.ideal + self.slopes[line.axis] @ nodes for line in self.lines]
        unit = [direction / np.linalg.norm(direction) for direction in directions]
        departure = np.array([np.arcsin(a @ b) for a, b in combinations(unit, 2)])
        missing = departure - self.angles @ locations
        own = self._inverse @ self._products()
        return np.asarray(np.linalg.solve(np.eye(own.shape[0]) - own @ self.by_location, self._inverse @ missing))

    def _products(self) -> FloatArray:
        """(pairs, n_nodes): first order of the scalar products."""
        rows = [a.ideal @ self.slopes[b.axis] + b.ideal @ self.slopes[a.axis] for a, b in combinations(self.lines, 2)]
        return np.array(rows)


def squareness_rule(
    choice: Choice, machine: IdentifiedMachine, grid: Grid, reached: BoolArray, free: BoolArray, by_location: FloatArray
) -> Squareness:
    """The rule of a choice.

    reached: (n_nodes,), nodes that have values; free: (n_location_errors,), those that are not given;
    by_location: (n_nodes, n_location_errors), how the nodes go along with the location errors.
    """
    n_locations = len(machine.location_errors)
    linear = [axis for axis in machine.axes if axis in LINEAR]
    if choice == "known" or not free.any():
        return Given(np.zeros((n_locations, grid.count)))
    if choice == "convention":
        slopes = _straightness_slopes(grid, reached)
        go_along = slopes @ by_location
        go_along[:, ~free] = 0.0
        return LevelLines(-np.linalg.pinv(go_along, rcond=1e-9) @ slopes)
    lines = axis_lines(machine) if len(linear) > 1 else ()
    if not lines:
        return Given(np.zeros((n_locations, grid.count)))
    slopes_of = {line.axis: _line_slopes(grid, line.axis, reached) for line in lines}
    return LinesFromAngles(
        lines=lines, slopes=slopes_of, angles=angle_matrix(lines), free=free, by_location=by_location
    )


def accumulated_slope(positions: FloatArray, reference: int) -> FloatArray:
    """(n,): weights whose scalar product with an angle's values is c_uv1 of Eqs. (39)-(41).

    Eq. (39) sums angle times position outwards from the home knot `reference`, whose own term is no measured
    position and does not enter; Eq. (41) is the slope of the least-squares line through these sums (the printed
    second formula has a sum of v P where the sum of P belongs).
    """
    weights = np.zeros(positions.size)
    others = np.delete(np.arange(positions.size), reference)
    if others.size < 2:
        return weights
    slope = slope_weights(positions[others])
    for side in (others[others > reference], others[others < reference][::-1]):
        of_side = slope[np.searchsorted(others, side)]
        weights[side] = np.cumsum(of_side[::-1])[::-1] * positions[side]
    return weights


def covered(rule: Squareness) -> BoolArray:
    """(n_location_errors,): those that the rule gives a value."""
    return np.asarray((np.abs(rule.response) > NEGLIGIBLE).any(axis=1))


def _line_slopes(grid: Grid, axis: str, reached: BoolArray) -> FloatArray:
    """Direction u of the axis line: from the turn about the third direction."""
    found = np.zeros((3, grid.count))
    along = LINEAR.index(axis)
    for across in range(3):
        if across == along:
            continue
        name = ROTATIONS[3 - along - across].motion_error(axis)
        if name in grid.components:
            nodes, positions, reference = _reached_knots(grid, grid.components.index(name), reached)
            found[across, nodes] = accumulated_slope(positions, reference)
    return found


def _straightness_slopes(grid: Grid, reached: BoolArray) -> FloatArray:
    """(straightness components, n_nodes): slopes of the least-squares lines."""
    rows = []
    for index, name in enumerate(grid.components):
        if name.is_straightness:
            nodes, positions, _ = _reached_knots(grid, index, reached)
            row = np.zeros(grid.count)
            row[nodes] = slope_weights(positions)
            rows.append(row)
    return np.array(rows).reshape(len(rows), grid.count)


def _reached_knots(grid: Grid, component: int, reached: BoolArray) -> tuple[IntArray, FloatArray, int]:
    """Nodes of a component that have a value, the one of the reference among them, and the place of that one."""
    nodes = grid.nodes(component)
    axis = grid.axis[component]
    has = reached[nodes] | grid.fixed[nodes]
    place = int(np.count_nonzero(has[: grid.reference[axis]]))
    return nodes[has], grid.knots[axis][has], place


def axis_lines(machine: IdentifiedMachine) -> tuple[AxisLine, ...]:
    """The lines of the linear axes, each moved from 0 to its farthest position, rotary axes at 0."""
    return tuple(_axis_line(machine, axis) for axis in machine.axes if axis in LINEAR)


def angle_matrix(lines: tuple[AxisLine, ...]) -> FloatArray:
    """(pairs, n_location_errors): what each location error adds to the scalar product of two axes' directions.

    The scalar product is pi/2 minus the angle. Pairs in the order of `itertools.combinations`.
    """
    rows = [a.by_location.T @ b.ideal + b.by_location.T @ a.ideal for a, b in combinations(lines, 2)]
    return np.array(rows).reshape(len(rows), lines[0].by_location.shape[1] if lines else 0)


def _axis_line(machine: IdentifiedMachine, axis: str) -> AxisLine:
    far = max(machine.travel[axis], key=abs) or 1.0
    positions = np.zeros((len(machine.axes), 2))
    positions[machine.axes.index(axis), 1] = far
    origin = np.zeros((3, 1))
    views: tuple[View, ...] = ("tool_in_bed", "workpiece_in_bed")
    for view in views:
        ideal = machine.view_ideal(view, positions, origin)
        moved = (ideal[:, 1] - ideal[:, 0]) / far
        if moved.any():
            by_error = machine.view_sensitivity(view, positions, origin)[:, len(machine.components) :]
            return AxisLine(axis, moved, (by_error[:, :, 1] - by_error[:, :, 0]) / far)
    return AxisLine(axis, np.zeros(3), np.zeros((3, len(machine.location_errors))))


def slope_weights(positions: FloatArray) -> FloatArray:
    """(n,): weights whose scalar product with values at the positions is the slope of their least-squares line."""
    centred = positions - positions.mean()
    total = float(centred @ centred)
    return centred / total if total > 0.0 else np.zeros_like(centred)
