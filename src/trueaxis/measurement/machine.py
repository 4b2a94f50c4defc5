"""What measuring needs to know of a machine, and of a machine model."""

from collections.abc import Mapping, Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from trueaxis.view import View

FloatArray = npt.NDArray[np.float64]


class MachineAxes(Protocol):
    """What measured data are checked against."""

    @property
    def name(self) -> str:
        """The machine's name."""
        ...

    @property
    def axes(self) -> tuple[str, ...]:
        """Axis letters in the order X Y Z A B C."""
        ...

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Axis -> lowest and highest commanded position, mm or deg."""
        ...


class MeasuredMachine(Protocol):
    """A machine model that can be measured: where points of one body are, seen from another.

    positions: (n_axes, n), mm or deg; point: (3, 1) or (3, n), mm, in the frame of the body that carries it.
    """

    @property
    def axes(self) -> tuple[str, ...]:
        """Axis letters in the order X Y Z A B C."""
        ...

    def view_ideal(self, view: View, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Coordinates on the error-free machine, (3, n), mm."""
        ...

    def view_deviations(self, points: Sequence[tuple[View, FloatArray]], positions: FloatArray) -> list[FloatArray]:
        """Actual minus ideal coordinates of points, each in its view, (3, n) each, mm, on the exact model."""
        ...
