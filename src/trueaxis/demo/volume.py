"""How far the tool of the true machine is off after compensation, over the whole volume.

Compensation takes away what is predicted: what is left is the true deviation less the predicted one, to first order.
Both are seen from home, where work offsets are touched off. The figure is the root mean square of the coordinates X, Y
and Z over random points; the length of the error vector is sqrt(3) times that.
"""

import numpy as np
from numpy.typing import NDArray

from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import home_of
from trueaxis.view import View

FloatArray = NDArray[np.float64]
POINTS, SEED = 4000, 1


def left_um(truth: MachineModel, values: ErrorValues | None) -> float:
    """Root mean square of a coordinate, um, of the true machine compensated with these values; None: not at all."""
    left = _from_home(truth)
    if values is not None:
        left = left - _from_home(truth.with_values(values))
    return 1e3 * float(np.sqrt(np.mean(left**2)))


def _from_home(machine: MachineModel) -> FloatArray:
    """(3, n): deviation of the tool point at random points, less that at home, mm."""
    draw = np.random.default_rng(SEED)
    positions = np.array([draw.uniform(*machine.travel[axis], POINTS) for axis in machine.axes])
    terms: list[tuple[View, FloatArray]] = [("tool_in_workpiece", np.zeros((3, 1)))]
    here, home = machine.view_deviations(terms, positions)[0], machine.view_deviations(terms, home_of(machine))[0]
    return np.asarray(here - home)
