"""points.csv: axis positions, and the tool point at each, at which the deviation is asked for."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.faults import Faults
from trueaxis.measure.columns import check_columns, numbers, positions
from trueaxis.measure.machine import MachineAxes
from trueaxis.measure.table import read_table, table_bytes

FloatArray = npt.NDArray[np.float64]

TOOL_COLUMNS = ("tool_x", "tool_y", "tool_z")
DEVIATION_COLUMNS = ("dx", "dy", "dz")
UNCERTAINTY_COLUMNS = ("u_dx", "u_dy", "u_dz")


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """Points of the working volume.

    frame: the columns of the file, in its order, as numbers; positions: (n_axes, n), commanded, mm or deg; tool:
    (3, n), the point in the tool frame, mm.
    """

    frame: pl.DataFrame
    positions: FloatArray
    tool: FloatArray


def read_points(path: Path, machine: MachineAxes) -> Points:
    """Read points of a machine. Raises InputError with every fault of the file."""
    table = read_table(path)
    faults = Faults(str(path))
    check_columns(table, machine, faults, required=(), optional=TOOL_COLUMNS)
    commanded = positions(table, machine, faults)
    tool = np.zeros((3, table.frame.height))
    for row, name in enumerate(TOOL_COLUMNS):
        if name in table.frame.columns:
            tool[row] = numbers(table, name, faults)
    faults.raise_if_any()
    known = {**dict(zip(machine.axes, commanded, strict=True)), **dict(zip(TOOL_COLUMNS, tool, strict=True))}
    frame = pl.DataFrame({name: pl.Series(known[name]) for name in table.frame.columns})
    return Points(frame, commanded, tool)


def dump_predicted(points: Points, deviation: FloatArray, suffix: str, u: FloatArray | None = None) -> bytes:
    """The columns of the points followed by dx, dy, dz (mm) and, where given, u_dx, u_dy, u_dz, as CSV or Parquet.

    deviation: (3, n), mm; suffix: `.parquet` for Parquet; u: (3, n), standard uncertainties, mm, NaN where unknown.
    """
    added = [pl.Series(name, row) for name, row in zip(DEVIATION_COLUMNS, deviation, strict=True)]
    if u is not None:
        added += [pl.Series(name, row).fill_nan(None) for name, row in zip(UNCERTAINTY_COLUMNS, u, strict=True)]
    return table_bytes(points.frame.with_columns(added), suffix)
