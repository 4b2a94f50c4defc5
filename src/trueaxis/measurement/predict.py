"""The deviation of the tool point, seen by the workpiece."""

import numpy as np

from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.believable import MOST_SIZES
from trueaxis.model.context import Context
from trueaxis.model.model import MachineModel

ROUNDING = 1e-9  # mm: what a machine without errors may seem to deviate by


def deviations(
    machine: MachineModel, positions: FloatArray, tool: FloatArray, datum: FloatArray | None = None
) -> FloatArray:
    """Actual minus ideal position of tool points in the workpiece frame (Eq. 4), (3, n), mm, exact model.

    positions: (n_axes, n), mm or deg; tool: (3, n), in the tool frame, mm; datum: (n_axes, 1), mm or deg, the position
    at which the deviation of each tool point is taken as zero, of axes that have not moved yet; None: the error-free
    machine.
    """
    if tool.shape[1] and (tool == tool[:, :1]).all():
        tool = np.ascontiguousarray(tool[:, :1])  # one point for all positions is what the fastest kernels take
    with np.errstate(all="ignore"):  # of error values that are none, which `check_predicted` tells
        deviation = machine.deviation(positions, tool)
        if datum is None:
            return deviation
        at_datum = np.repeat(datum, tool.shape[1], axis=1)
        still = machine.in_context(Context.at_rest(len(machine.axes), tool.shape[1]))
        return deviation - still.deviation(at_datum, tool)


def check_predicted(deviation: FloatArray, expected: FloatArray, file: str) -> None:
    """Raise InputError where a deviation is none that a machine has: curves that run away beyond what was measured,
    parameters of effects in another unit.

    deviation: (3, n), mm; expected: (n,), length that the prior lets expect, mm; file: the error values.
    """
    limit = MOST_SIZES * expected + ROUNDING
    wrong = np.flatnonzero(~(np.abs(deviation) <= limit).all(axis=0))
    if len(wrong):
        row = wrong[0]
        largest = np.abs(deviation[:, row]).max()
        problem = f"at {len(wrong)} of {deviation.shape[1]} points the tool would deviate too far: {largest:.6g} mm"
        remedy = f"at most {limit[row]:.4g} mm, {MOST_SIZES:g} times the prior; positions that were measured"
        raise InputError([Fault(file, "", f"{problem} in row {row + 1}", remedy)])
