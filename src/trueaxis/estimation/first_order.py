"""First-order readings: how each reading depends on each error, at the error-free machine."""

import numpy as np

from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import column, home_positions, sensed_points
from trueaxis.measurement.setup import Run


def sensed(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    """(n_components + n_location_errors, n): mm of reading per mm or rad of error acting at each position.

    positions: (n_axes, n). For a ball bar the direction sensed is that of the bar on the error-free machine.
    """
    return _projected(machine, run, positions)


def sensed_at_home(machine: IdentifiedMachine, run: Run) -> FloatArray:
    """(n_components + n_location_errors, 1): what the zero of the reading takes away; zero for a ball bar."""
    home = home_positions(run, machine.axes)
    if home is None:
        return np.zeros((len(machine.components) + len(machine.location_errors), 1))
    return _projected(machine, run, home)


def _projected(machine: IdentifiedMachine, run: Run, positions: FloatArray) -> FloatArray:
    total = np.zeros((len(machine.components) + len(machine.location_errors), positions.shape[1]))
    for one in sensed_points(machine, run, positions):
        sensitivity = machine.view_sensitivity(one.view, positions, column(one.point))
        total += np.einsum("in,ijn->jn", one.direction, sensitivity)
    return total
