"""What compensation needs of a machine: its axes and where errors put the tool; and the machine as a program sees it
under tool centre point control (G43.4, TRAORI, M128): by the tip, not by the axes.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]
Place = tuple[str, FloatArray]  # name, and axis positions, (n_axes, 1), mm and deg

LINEAR = "XYZ"
ROTARY = "ABC"


class ErrorModel(Protocol):
    """A machine with its errors, evaluated on arrays of axis positions.

    Positions are (n_axes, n) in the order of `axes`, mm for X Y Z and deg for A B C; `point` is P_T in the tool
    frame, mm, (3, 1) or (3, n); `direction` a unit vector of the tool frame of the same shapes.
    """

    @property
    def axes(self) -> tuple[str, ...]:
        """Axes the machine has, in the order X Y Z A B C."""

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Lowest and highest position of each axis, mm or deg."""

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point in the workpiece frame of the error-free machine, mm, (3, n)."""

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal tool point, workpiece frame, mm, (3, n)."""

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """Increments of the axes, (n_axes, n), that move the ideal tool point by `deviation`; rotary rows 0."""

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """The direction in the workpiece frame of the error-free machine, (3, n)."""

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """Actual minus ideal direction, workpiece frame, (3, n); the actual one need not be of length 1 exactly."""


def linear_rows(axes: tuple[str, ...]) -> tuple[int, ...]:
    """Rows of the linear axes in an array of positions."""
    return tuple(row for row, axis in enumerate(axes) if axis in LINEAR)


def rotary_rows(axes: tuple[str, ...]) -> tuple[int, ...]:
    """Rows of the rotary axes in an array of positions."""
    return tuple(row for row, axis in enumerate(axes) if axis in ROTARY)


def linear_jacobian(model: ErrorModel, positions: FloatArray, point: FloatArray) -> FloatArray:
    """Motion of the ideal tool point per mm of each linear axis, (3, n_linear, n).

    The ideal tool point is affine in the linear axes, so a step of 1 mm gives the derivative without truncation.
    """
    here = model.ideal(positions, point)
    columns = []
    for row in linear_rows(model.axes):
        moved = positions.copy()
        moved[row] += 1.0
        columns.append(model.ideal(moved, point) - here)
    return np.stack(columns, axis=1)


_ANYWHERE = 1e6  # mm: what the tip may be at says nothing of travel; the axes are looked at instead
_STEPS = 2  # the tool point is affine in the linear axes: one step is exact but for rounding


@dataclass(frozen=True, slots=True)
class PointControlled:
    """The machine `base` in positions of the tip."""

    base: ErrorModel

    @property
    def axes(self) -> tuple[str, ...]:
        """As ErrorModel has it, and so the rest."""
        return self.base.axes

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """That of rotary axes; the tip may be anywhere."""
        rows = linear_rows(self.base.axes)
        return {
            axis: (-_ANYWHERE, _ANYWHERE) if row in rows else self.base.travel[axis]
            for row, axis in enumerate(self.base.axes)
        }

    def axis_positions(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Where the control puts the axes, mm and deg, (n_axes, n)."""
        target = self.ideal(positions, point)
        found = positions.copy()
        for _ in range(_STEPS):
            found = found + self.base.correction(found, target - self.base.ideal(found, point))
        return found

    def tip_positions(self, axis_positions: FloatArray, point: FloatArray) -> FloatArray:
        """Positions of the tip for which the control puts the axes there: the other way round."""
        target = self.base.ideal(axis_positions, point)
        found = axis_positions.copy()
        for _ in range(_STEPS):
            found = found + self.correction(found, target - self.ideal(found, point))
        return found

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point of the error-free machine: where the program wants it, whatever the rotary axes."""
        return self.base.ideal(self._upright(positions), point)

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal tool point, with the axes where the control puts them."""
        return self.base.deviation(self.axis_positions(positions, point), point)

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """Increments of the positions of the tip."""
        return self.base.correction(self._upright(positions), deviation)

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """A direction on the error-free machine: rotary axes alone turn it."""
        return self.base.orientation_ideal(positions, direction)

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """Actual minus ideal direction; the linear axes are those of a tool of no length."""
        return self.base.orientation_deviation(self.axis_positions(positions, np.zeros((3, 1))), direction)

    def _upright(self, positions: FloatArray) -> FloatArray:
        upright = positions.copy()
        upright[list(rotary_rows(self.base.axes))] = 0.0
        return upright
