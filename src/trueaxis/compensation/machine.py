"""What compensation needs of a machine: its axes and where errors put the tool."""

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

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
