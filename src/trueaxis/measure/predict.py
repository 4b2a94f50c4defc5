"""The deviation of the tool point, seen by the workpiece."""

import numpy as np

from trueaxis.faults import Fault, InputError
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.points import Points
from trueaxis.measure.readings_reader import LARGEST_READING
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
    with np.errstate(all="ignore"):  # of error values that are none, which `check_predicted` tells
        deviation = machine.deviation(points.positions, tool)
        if datum is None:
            return deviation
        at_datum = np.repeat(datum, tool.shape[1], axis=1)
        still = machine.in_context(Context.at_rest(len(machine.axes), tool.shape[1]))
        return deviation - still.deviation(at_datum, tool)


def check_predicted(deviation: FloatArray, file: str) -> None:
    """Raise InputError where a deviation is none that a reading could have: error values in another unit, or too large.

    deviation: (3, n), mm; file: the error values, which the fault is of.
    """
    wrong = np.flatnonzero(~(np.abs(deviation) <= LARGEST_READING).all(axis=0))
    if len(wrong):
        largest = np.abs(deviation[:, wrong[0]]).max()
        problem = f"at {len(wrong)} of {deviation.shape[1]} points the tool would deviate too far: {largest:.6g} mm"
        remedy = f"errors in mm and rad, deviations of at most {LARGEST_READING:g} mm"
        raise InputError([Fault(file, "", f"{problem} in row {wrong[0] + 1}", remedy)])
