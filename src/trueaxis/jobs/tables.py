"""Arrays as users give them, and results as they get them: frames of Polars and of pandas.

Arrays are checked against the machine; what has the wrong shape is told with the expected one.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, get_args

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import Fault, InputError
from trueaxis.jobs.typed import shown_value
from trueaxis.machine.machine import Machine
from trueaxis.model.curves import FloatArray
from trueaxis.model.grid import Grid
from trueaxis.model.model import MachineModel

ORIGIN = (0.0, 0.0, 0.0)  # of the tool frame, mm
Positions = Mapping[str, npt.ArrayLike] | npt.ArrayLike | pl.DataFrame | Grid
MOST_NODES = 1_000_000  # points of a grid: a kilobyte each while they are computed
LEAST_NODES = 2  # of an axis: the ends of its travel


def positions_of(model: MachineModel, positions: Positions) -> FloatArray:
    """(n_axes, n) axis positions, mm or deg.

    positions: by axis letter, numbers or (n,) each, axes that are left out stand at 0; a table (of Polars or pandas)
    with such columns; an array (n_axes, n) in the order of `model.axes`; or a grid. Raises ValueError with the
    argument, what was expected and what was given.
    """
    axes = model.axes
    if isinstance(positions, Grid):
        if faults := faults_of_grid(positions, model.machine):
            raise InputError(faults)
        return positions.positions(model.machine)
    if not isinstance(positions, Mapping) and (columns := getattr(positions, "columns", None)) is not None:
        positions = {str(name): np.asarray(positions[name]) for name in columns}  # type: ignore[index]
    if isinstance(positions, Mapping):
        if not positions:
            raise ValueError(f"positions: expected positions of some of {', '.join(axes)}; given none")
        if unknown := [name for name in positions if name not in axes]:
            raise ValueError(f"positions: {model.name} has no axis {', '.join(unknown)}, but {', '.join(axes)}")
        rows = [np.atleast_1d(_finite(f"positions[{axis!r}]", positions.get(axis, 0.0))) for axis in axes]
        if wrong := [f"{axis} {row.shape}" for axis, row in zip(axes, rows, strict=True) if row.ndim != 1]:
            raise ValueError(f"positions: expected numbers or arrays (n,), one for each axis; given {', '.join(wrong)}")
        lengths = {row.size for row in rows if row.size != 1}
        if len(lengths) > 1:
            shapes = ", ".join(f"{axis} {row.shape}" for axis, row in zip(axes, rows, strict=True))
            raise ValueError(f"positions: expected arrays of one length; given {shapes}")
        count = lengths.pop() if lengths else 1
        return np.stack([np.broadcast_to(row, (count,)) for row in rows])
    array = _finite("positions", positions)
    if array.ndim != 2 or array.shape[0] != len(axes):
        order = ", ".join(axes)
        raise ValueError(f"positions: expected shape ({len(axes)}, n), rows {order}; given {array.shape}")
    return np.ascontiguousarray(array)


def faults_of_grid(grid: Grid, machine: Machine, name: str = "positions") -> list[Fault]:
    """What is wrong with a grid of a machine. name: of the argument or the option."""
    found = []
    if unknown := [axis for axis in grid.counts if axis not in machine.axes]:
        found.append(Fault(name, "", f"{machine.name} has no axis {', '.join(unknown)}", f"{', '.join(machine.axes)}"))
    for axis, count in grid.counts.items():
        if not (isinstance(count, int) and count >= LEAST_NODES):
            found.append(Fault(name, axis, f"has {count} positions", f"a whole number, at least {LEAST_NODES}"))
    points = math.prod(grid.counts.values())
    if not found and not grid.counts:
        found.append(Fault(name, "", "has no axis", f"some of {', '.join(machine.axes)}"))
    if not found and points > MOST_NODES:
        found.append(Fault(name, "", f"has {points} points", f"{MOST_NODES} at most"))
    return found


def check_travel(model: MachineModel, positions: FloatArray) -> None:
    """Raise ValueError where a position (n_axes, n) is outside the travel: nothing is known of the machine there."""
    wrong = []
    for axis, row in zip(model.axes, positions, strict=True):
        low, high = model.travel[axis]
        if (outside := row[(row < low) | (row > high)]).size:
            wrong.append(f"{axis} = {outside[0]:.9g} is outside its travel, from {low:g} to {high:g}")
    if wrong:
        raise ValueError(f"positions: {'; '.join(wrong)}")


def tool_points(tool: npt.ArrayLike, count: int) -> FloatArray:
    """(3, count) points in the tool frame, mm; tool: (3,) for all of them, or (3, count). Raises ValueError."""
    array = _finite("tool", tool)
    if array.shape == (3,):
        return np.repeat(array[:, np.newaxis], count, axis=1)
    if array.shape != (3, count):
        raise ValueError(f"tool: expected shape (3,) or (3, {count}), mm; given {array.shape}")
    return array


def above_zero(**given: float | None) -> None:
    """Raise ValueError where a number is not finite and above 0; None: it was not given."""
    for name, value in given.items():
        if value is not None and not 0.0 < value < math.inf:
            raise ValueError(f"{name}: expected a finite number above 0; given {value}")


def at_least_zero(**given: float | None) -> None:
    """Raise ValueError where a number is not finite and at least 0; None: it was not given."""
    for name, value in given.items():
        if value is not None and not 0.0 <= value < math.inf:
            raise ValueError(f"{name}: expected a finite number, at least 0; given {value}")


def check_among(**given: tuple[object, Any]) -> None:
    """Raise ValueError where a value is none of its Literal; None: it was not given."""
    for name, (value, literal) in given.items():
        if value is not None and value not in get_args(literal):
            raise ValueError(f"{name}: expected one of {', '.join(get_args(literal))}; given {value!r}")


def _finite(name: str, values: npt.ArrayLike) -> FloatArray:
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "iuf" and array.size:
            raise ValueError
        array = array.astype(np.float64)
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected numbers; given {shown_value(values)}") from None
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers; {int((~np.isfinite(array)).sum())} are not")
    return array


class Tabular(ABC):
    """What has `to_polars` has `to_pandas`, too."""

    __slots__ = ()

    @abstractmethod
    def to_polars(self) -> pl.DataFrame:
        """The result as a table."""

    def to_pandas(self) -> Any:
        """The same as a pandas.DataFrame. Raises ModuleNotFoundError where pandas is not installed."""
        try:
            import pandas as pd  # noqa: PLC0415  half a second; only who asks for it needs it
        except ModuleNotFoundError:
            remedy = "pip install 'trueaxis[pandas]'"
            raise ModuleNotFoundError(f"to_pandas needs the package pandas: {remedy}", name="pandas") from None
        # column by column: Polars' own way asks for pyarrow, 40 MB and more, as well
        return pd.DataFrame({column.name: column.to_numpy() for column in self.to_polars()})
