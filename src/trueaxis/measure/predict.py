"""The deviation of the tool point, seen by the workpiece."""

import numpy as np

from trueaxis.faults import Fault, InputError
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.points import Points
from trueaxis.runtime.context import Context
from trueaxis.runtime.model import MachineModel


def predict(machine: MachineModel, points: Points, datum: FloatArray | None = None) -> FloatArray:
    """Actual minus ideal position of the tool points in the workpiece frame (Eq. 4), (3, n), mm, exact model.

    datum: (n_axes, 1), mm or deg, the position at which the deviation of each tool point is taken as zero, of axes that
    have not moved yet; None: the error-free machine.
    """
    tool = points.tool
    if tool.shape[1] and (tool == tool[:, :1]).all():
        tool = np.ascontiguousarray(tool[:, :1])  # one point for all positions is what the fastest kernels take
    deviation = machine.deviation(points.positions, tool)
    if datum is None:
        return deviation
    at_datum = np.repeat(datum, tool.shape[1], axis=1)
    still = machine.in_context(Context.at_rest(len(machine.axes), tool.shape[1]))
    return deviation - still.deviation(at_datum, tool)


def check_finite(deviation: FloatArray, errors_file: str) -> None:
    """Raise InputError where a deviation (3, n) is no number: parameters of effects that no machine has."""
    wrong = np.flatnonzero(~np.isfinite(deviation).all(axis=0))
    if wrong.size:
        problem = f"make the deviation at point {wrong[0] + 1} no finite number"
        raise InputError([Fault(errors_file, "effects", problem, "parameters that a machine has")])
