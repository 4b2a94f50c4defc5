"""A machine as a program sees it under tool centre point control (G43.4, TRAORI, M128): by the tip, not by the axes.

Positions X Y Z are then those of the axes that would bring the tip where it is if all rotary axes stood at 0: words
plus offsets, as ever. The tip is meant in the workpiece frame, which turns with the table. The control finds the linear
axes by its ideal chain, which is taken to be that of the spec.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows, rotary_rows

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
