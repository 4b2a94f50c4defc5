"""What identification needs to know of a machine model."""

from collections.abc import Mapping
from typing import Protocol, Self

import numpy as np
import numpy.typing as npt

from trueaxis.error_name import ErrorName
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray, MeasuredMachine
from trueaxis.model.errors import ErrorValues
from trueaxis.view import View

IntArray = npt.NDArray[np.int64]


class IdentifiedMachine(MeasuredMachine, Protocol):
    """A machine model whose error values can be exchanged and whose readings can be differentiated."""

    @property
    def name(self) -> str:
        """The machine's name."""
        ...

    @property
    def components(self) -> tuple[ErrorName, ...]:
        """Motion-error components (ISO 230-1 names)."""
        ...

    @property
    def location_errors(self) -> tuple[str, ...]:
        """Named position errors, the columns of the sensitivities after the components."""
        ...

    @property
    def parameters(self) -> tuple[str, ...]:
        """Every named parameter: dimensions, then location errors."""
        ...

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Axis -> lowest and highest commanded position, mm or deg."""
        ...

    def with_values(self, errors: ErrorValues) -> Self:
        """The same machine with other error values."""
        ...

    def view_sensitivity(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        """(3, n_components + n_location_errors, n): derivative of the deviation by each error, error-free machine."""
        ...


def component_axes(machine: IdentifiedMachine) -> IntArray:
    """(n_components,): the row of the axis positions that each component depends on."""
    return np.array([machine.axes.index(name.axis) for name in machine.components], dtype=np.int64)


def lever(machine: IdentifiedMachine) -> float:
    """The length (mm) that makes rotations comparable with translations: the longest travel of a linear axis."""
    spans = [high - low for axis, (low, high) in machine.travel.items() if axis in LINEAR]
    return max([span for span in spans if span > 0.0], default=1.0)


def units(machine: IdentifiedMachine) -> tuple[str, ...]:
    """`mm` or `rad` of each component and then of each location error.

    A location error is a rotation where what it does depends on the point it is done to.
    """
    home = np.zeros((len(machine.axes), 2))
    points = np.array([[0.0, 1.0], [0.0, 2.0], [0.0, 4.0]])
    found = [name.unit for name in machine.components]
    turns = np.zeros(len(machine.location_errors), dtype=bool)
    views: tuple[View, ...] = ("tool_in_bed", "workpiece_in_bed")
    for view in views:
        effect = machine.view_sensitivity(view, home, points)[:, len(machine.components) :]
        turns |= (np.abs(effect[:, :, 1] - effect[:, :, 0]) > 1e-6).any(axis=0)
    return (*found, *("rad" if turn else "mm" for turn in turns))


def scales(machine: IdentifiedMachine) -> FloatArray:
    """(n_components + n_location_errors,): the size of each error that counts as much as 1 mm, mm or rad."""
    return np.array([1.0 if unit == "mm" else 1.0 / lever(machine) for unit in units(machine)])
