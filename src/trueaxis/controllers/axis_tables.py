"""Compensation of single axes: how far a linear axis is off as a function of one axis, and nothing else.

A control that has no model of its machine adds up tables, each the correction of one axis by the position of one axis.
Of all such sums the one used here leaves the least over the volume of the travels: the mean over the positions of the
other axes, at every node of a regular grid (the main effects of a factorial design). An error that grows with the
distance of another axis (Abbe) is then taken as it is in the middle of that axis's travel; the rest remains.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from trueaxis.error_name import positioning_error
from trueaxis.machine.machine import LINEAR
from trueaxis.model.context import Context
from trueaxis.model.curves import FloatArray
from trueaxis.model.model import MachineModel, home_of

MOST_POINTS = 200  # of a table by default: what the smallest control takes (SINUMERIK 808D, 828D)
OTHERS = 5  # positions of each other axis over which is averaged: exact for curves up to the third power
ROUND_STEPS = (1.0, 2.0, 5.0)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class AxisTable:
    """How far axis `of` is off where axis `by` stands at `positions` (n,), mm or deg.

    forward, backward: (n,), mm or deg: actual minus commanded in the direction in which commands of `of` count, zero at
    home, approached by `by` in the positive and in the negative direction. They differ where the error values have
    effects of direction.
    """

    of: str
    by: str
    positions: FloatArray
    forward: FloatArray
    backward: FloatArray

    @property
    def mean(self) -> FloatArray:
        """(n,): of both directions of approach, for a control that knows but one table."""
        return (self.forward + self.backward) / 2.0

    @property
    def reversal(self) -> float:
        """Mean difference of the two directions, positive minus negative, mm or deg (B of ISO 230-2)."""
        return float((self.forward - self.backward).mean())

    @property
    def step(self) -> float:
        """Distance of the nodes, mm or deg."""
        return float(self.positions[-1] - self.positions[0]) / (self.positions.size - 1)

    def rounded(self, digits: int) -> "AxisTable":
        """With values as they are written."""
        return replace(self, forward=np.round(self.forward, digits), backward=np.round(self.backward, digits))


def nodes(travel: tuple[float, float], step: float | None, most: int = MOST_POINTS) -> FloatArray:
    """(n,): regular positions from end to end, at most `step` apart; without a step the finest round one that needs no
    more than `most` positions.
    """
    low, high = travel
    if step is None:
        step = round_step((high - low) / (most - 1))
    return np.linspace(low, high, node_count(travel, step))


def node_count(travel: tuple[float, float], step: float) -> int:
    """How many regular positions from end to end are at most `step` apart."""
    return max(1, math.ceil((travel[1] - travel[0]) / step - 1e-9)) + 1


def round_step(least: float) -> float:
    """The least of 1, 2, 5, 10, 20 ... (and 0.1, 0.2 ...) that is not below."""
    decade = 10.0 ** math.floor(math.log10(least))
    return next(one * decade for one in (*ROUND_STEPS, 10.0) if one * decade >= least * (1.0 - 1e-12))


def axis_tables(
    model: MachineModel, tool: FloatArray, pairs: Sequence[tuple[str, str]], step: float | None
) -> tuple[AxisTable, ...]:
    """A table for each pair (of, by). tool: (3, 1), point in the tool frame, mm. Rotary axes stand at home.

    Raises ValueError for a pair of a rotary axis with another axis.
    """
    grids = {axis: nodes(model.travel[axis], step) for _, axis in pairs}
    off = {axis: _off(model, tool, axis, at) for axis, at in grids.items() if axis in LINEAR}
    tables = []
    for of, by in pairs:
        if by in LINEAR and of in LINEAR:
            row = LINEAR.index(of)
            forward, backward = off[by][0][row], off[by][1][row]
        elif of == by:
            forward, backward = _turned_off(model, by, grids[by])
        else:
            raise ValueError(f"no table of {of} by {by}")
        at_home = float(home_of(model)[model.axes.index(by), 0])
        zero = float(np.interp(at_home, grids[by], (forward + backward) / 2.0))
        tables.append(AxisTable(of=of, by=by, positions=grids[by], forward=forward - zero, backward=backward - zero))
    return tuple(tables)


def approached(model: MachineModel, count: int, directions: FloatArray) -> Context:
    """All axes stand, long after they came by these directions, (n_axes,)."""
    still = Context.at_rest(len(model.axes), count)
    return replace(still, directions=np.repeat(directions[:, np.newaxis], count, axis=1))


def _off(model: MachineModel, tool: FloatArray, axis: str, at: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(3, n) each: by how much X, Y, Z are off, mean over the other linear axes, approached forward and backward."""
    home = home_of(model)[:, 0]
    others = [
        np.linspace(*model.travel[name], OTHERS) if name in LINEAR and name != axis else home[row : row + 1]
        for row, name in enumerate(model.axes)
    ]
    around = np.array(list(product(*others))).T  # (n_axes, m)
    positions = np.repeat(around, at.size, axis=1)
    row = model.axes.index(axis)
    positions[row] = np.tile(at, around.shape[1])
    found = []
    for sign in (1.0, -1.0):
        directions = np.zeros(len(model.axes))
        directions[row] = sign
        here = model.in_context(approached(model, positions.shape[1], directions))
        moves = model.correction(positions, here.deviation(positions, tool))
        linear = [model.axes.index(name) for name in LINEAR]
        found.append(moves[linear].reshape(3, around.shape[1], at.size).mean(axis=1))
    return found[0], found[1]


def _turned_off(model: MachineModel, axis: str, at: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(n,) each, deg: by how much a rotary axis is off, approached forward and backward."""
    name = positioning_error(axis)
    if name not in model.components:
        return np.zeros(at.size), np.zeros(at.size)
    row = model.axes.index(axis)
    positions = np.repeat(home_of(model), at.size, axis=1)
    positions[row] = at
    sense = model.machine.mover(axis).sense
    found = []
    for sign in (1.0, -1.0):
        directions = np.zeros(len(model.axes))
        directions[row] = sign
        here = model.in_context(approached(model, at.size, directions))
        errors = here.component_errors(positions)[model.components.index(name)]
        found.append(np.degrees(errors) * sense)
    return found[0], found[1]


def plain(value: float, digits: int) -> str:
    """Decimal digits without an exponent, without zeros at the end, never -0."""
    text = f"{value:.{digits}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
