"""What size of readings the prior sizes of the errors let expect, before anything is identified."""

import numpy as np

from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import component_axes, units
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions
from trueaxis.measurement.setup import Run
from trueaxis.model.model import MachineModel


def expected_size(machine: MachineModel, run: Run, positions: FloatArray) -> FloatArray:
    """(n,): standard deviation of readings of a run at positions (n_axes, n), mm: errors of their prior sizes together.

    Component errors are taken as independent at a position and at home, and equal where an axis has not left its home.
    """
    locations = len(machine.components)
    unit = units(machine)[locations:]
    sizes = [machine.prior.of_component(name) for name in machine.components]
    sizes += [machine.prior.of_location(name, of) for name, of in zip(machine.location_errors, unit, strict=True)]
    here, home = sensed(machine, run, positions), sensed_at_home(machine, run)
    share = here - home
    zeroed = home_positions(run, machine.axes)
    if zeroed is not None:
        moved = (positions != zeroed)[component_axes(machine)]
        share[:locations] = np.where(moved, np.hypot(here[:locations], home[:locations]), share[:locations])
    found: FloatArray = np.linalg.norm(share * np.array(sizes)[:, np.newaxis], axis=0)
    return found
