"""The deviation of the tool point, seen by the workpiece."""

from trueaxis.measure.machine import FloatArray, MeasuredMachine
from trueaxis.measure.points import Points


def predict(machine: MeasuredMachine, points: Points) -> FloatArray:
    """Actual minus ideal position of the tool points in the workpiece frame (Eq. 4), (3, n), mm, exact model."""
    return machine.view_deviation("tool_in_workpiece", points.positions, points.tool)
