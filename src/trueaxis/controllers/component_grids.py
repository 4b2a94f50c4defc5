"""Error components of an axis where it stands and, where effects ask for it, where other axes stand: on a grid."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.controllers.axis_tables import approached, nodes
from trueaxis.controllers.remaining import TakenOff, held_effects
from trueaxis.error_name import DIRECTIONS, ErrorName
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel, home_of

# Positions of each axis beside the one that moves. Between 20 equal steps a parabola over the travel (cross_axis) is
# off by 1/1600 of its height, a straight line; the grid has 20 times the records, not 200 times.
MOST_BESIDE = 21


@dataclass(frozen=True, slots=True, kw_only=True)
class ComponentGrid:
    """Errors of an axis. arguments: the axes on whose positions they depend, its own last; nodes: the positions of
    each, mm or deg.
    """

    arguments: tuple[str, ...]
    nodes: tuple[FloatArray, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Positions of each argument."""
        return tuple(one.size for one in self.nodes)

    @property
    def positions(self) -> FloatArray:
        """(n_arguments, n): every point of the grid, the last argument the fastest."""
        return np.array([one.ravel() for one in np.meshgrid(*self.nodes, indexing="ij")])


def arguments_of(model: MachineModel, axis: str) -> tuple[str, ...]:
    """The axes on whose positions the errors of an axis depend, its own last."""
    others = {
        one.effect.axis
        for one in held_effects(model)
        if one.effect.axis and ErrorName(one.effect.component or "").axis == axis
    }
    return (*(one for one in model.axes if one in others and one != axis), axis)


def grid_of(model: MachineModel, axis: str, step: float | None) -> ComponentGrid:
    """The positions at which the errors of an axis are written. step: largest distance of its own, mm or deg."""
    *others, own = arguments_of(model, axis)
    beside = [nodes(model.travel[other], None, MOST_BESIDE) for other in others]
    return ComponentGrid(arguments=(*others, own), nodes=(*beside, nodes(model.travel[own], step)))


def motion_errors(model: MachineModel, arguments: Sequence[str], positions: FloatArray) -> FloatArray:
    """(6, n): the error components of the last of the arguments in its body's frame, mean of both directions of
    approach, mm and rad. positions: (n_arguments, n), mm or deg; the other axes are at home.
    """
    count, axis = positions.shape[1], arguments[-1]
    everywhere = np.repeat(home_of(model), count, axis=1)
    everywhere[[model.axes.index(one) for one in arguments]] = positions
    found = np.zeros((6, count))
    for sign in (1.0, -1.0):
        directions = np.zeros(len(model.axes))
        directions[model.axes.index(axis)] = sign
        errors = model.in_context(approached(model, count, directions)).component_errors(everywhere)
        for index, direction in enumerate(DIRECTIONS):
            name = direction.motion_error(axis)
            if name in model.components:
                found[index] += errors[model.components.index(name)] / 2.0
    return found


def taken_by_components(model: MachineModel, tool: FloatArray, step: float | None) -> TakenOff:
    """What a control takes off that has the components on their grids, interpolated on straight lines."""
    from scipy.interpolate import RegularGridInterpolator  # noqa: PLC0415  half a second; few tables ask for it

    grids = [grid_of(model, axis, step) for axis in model.axes]
    known = []
    for grid in grids:
        values = motion_errors(model, grid.arguments, grid.positions).T.reshape(*grid.shape, 6)
        known.append(RegularGridInterpolator(grid.nodes, values))

    def taken(at: FloatArray, _: FloatArray) -> FloatArray:
        errors = np.zeros((len(model.components), at.shape[1]))
        for grid, interpolated in zip(grids, known, strict=True):
            rows = [model.axes.index(one) for one in grid.arguments]
            ends = np.array([(one[0], one[-1]) for one in grid.nodes])
            held = interpolated(np.clip(at[rows].T, *ends.T))
            for index, direction in enumerate(DIRECTIONS):
                name = direction.motion_error(grid.arguments[-1])
                if name in model.components:
                    errors[model.components.index(name)] = held[:, index]
        off = model.view_deviation_of("tool_in_workpiece", at, errors, model.parameter_values, tool)
        return model.correction(at, off)

    return taken
