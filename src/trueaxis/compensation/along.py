"""Corrections along a motion, compared: what subdivision goes by."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.orientation import ToolAxis, angle


class Along(Protocol):
    """What subdivision asks of positions (n_axes, n) along motions."""

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """First correction of the axes, (n_axes, n), mm and deg; model: the machine at those positions."""

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:
        """How far two corrections lie apart, (n,), in shares of what is allowed between words."""


@dataclass(frozen=True, slots=True)
class PointAlong:
    """The tool point alone, by the linear axes; tolerance mm."""

    axes: tuple[str, ...]
    tool_point: FloatArray
    tolerance: float

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """Eq. (55) once."""
        return model.correction(positions, -model.deviation(positions, self.tool_point))

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:  # noqa: ARG002
        """By the linear axes."""
        rows = list(linear_rows(self.axes))
        return np.asarray(np.sqrt(((correction[rows] - straight[rows]) ** 2).sum(axis=0)) / self.tolerance)


@dataclass(frozen=True, slots=True, kw_only=True)
class PoseAlong:
    """Tool point and tool axis, by all axes; tolerance mm, orientation_tolerance rad."""

    model: ErrorModel
    tool_point: FloatArray
    tool_axis: ToolAxis
    tolerance: float
    orientation_tolerance: float

    def correction(self, model: ErrorModel, positions: FloatArray) -> FloatArray:
        """The turns of the rotary axes, then Eq. (55), once."""
        error = self.tool_axis.wanted(positions) - self.tool_axis.on(model).actual(positions)
        turned = positions + self.tool_axis.turning(positions).step(positions, error)[0]
        off = self._ideal(positions) - self._ideal(turned) - model.deviation(turned, self.tool_point)
        return np.asarray(turned - positions + model.correction(turned, off))

    def apart(self, positions: FloatArray, correction: FloatArray, straight: FloatArray) -> FloatArray:
        """By tool point and tool axis, whichever is the larger share."""
        here, there = positions + correction, positions + straight
        point = np.sqrt(((self._ideal(here) - self._ideal(there)) ** 2).sum(axis=0))
        axis = angle(self.tool_axis.wanted(here), self.tool_axis.wanted(there))
        return np.asarray(np.maximum(point / self.tolerance, axis / self.orientation_tolerance))

    def _ideal(self, positions: FloatArray) -> FloatArray:
        return self.model.ideal(positions, self.tool_point)
