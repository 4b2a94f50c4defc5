"""The deviation of the tool point, seen by the workpiece."""

import numpy as np

from trueaxis.measure.machine import FloatArray, MeasuredMachine
from trueaxis.measure.points import Points


def predict(machine: MeasuredMachine, points: Points) -> FloatArray:
    """Actual minus ideal position of the tool points in the workpiece frame (Eq. 4), (3, n), mm, exact model."""
    tool = points.tool
    if tool.shape[1] and (tool == tool[:, :1]).all():
        tool = np.ascontiguousarray(tool[:, :1])  # one point for all positions is what the fastest kernels take
    (found,) = machine.view_deviations([("tool_in_workpiece", tool)], points.positions)
    return found
