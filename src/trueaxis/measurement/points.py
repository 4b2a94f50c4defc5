"""points.csv: axis positions and the tool point at each, and the deviation of the tool point there."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import polars as pl

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.measurement.columns import approaches, check_columns, note, numbers, positions, time_feed_temperature
from trueaxis.measurement.limits import FARTHEST_POINT
from trueaxis.measurement.machine import FloatArray, MachineAxes
from trueaxis.measurement.table import read_table, table_bytes
from trueaxis.model.believable import MOST_SIZES
from trueaxis.model.context import Context
from trueaxis.model.model import MachineModel

TOOL_COLUMNS = ("tool_x", "tool_y", "tool_z")
CONTEXT_COLUMNS = ("time_s", "temperature_c")
DEVIATION_COLUMNS = ("dx", "dy", "dz")
UNCERTAINTY_COLUMNS = ("u_dx", "u_dy", "u_dz")
PRIOR_COLUMNS = ("u_prior_dx", "u_prior_dy", "u_prior_dz")  # the parts of these that rest on the prior
ROUNDING = 1e-9  # mm: what a machine without errors may seem to deviate by


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """Points of the working volume.

    frame: the columns of the file, in its order, as numbers; positions: (n_axes, n), commanded, mm or deg; tool:
    (3, n), the point in the tool frame, mm; context: approach directions, 0 where the file gives none, time and
    temperature, NaN where it gives none, of axes that stand and have not turned back.
    """

    frame: pl.DataFrame
    positions: FloatArray
    tool: FloatArray
    context: Context


def read_points(path: Path, machine: MachineAxes) -> Points:
    """Read points of a machine. Raises InputError with every fault of the file."""
    table = read_table(path)
    faults = Faults(str(path))
    names = tuple(f"dir_{axis}" for axis in machine.axes)
    check_columns(table, machine, faults, required=(), optional=(*TOOL_COLUMNS, *names, *CONTEXT_COLUMNS))
    commanded = positions(table, machine, faults)
    tool = np.zeros((3, table.frame.height))
    for row, name in enumerate(TOOL_COLUMNS):
        if name in table.frame.columns:
            tool[row] = numbers(table, name, faults)
            far = np.abs(tool[row]) > FARTHEST_POINT
            note(table, name, far, faults, "is too far", remedy=f"mm, at most {FARTHEST_POINT:g}")
    present = table.frame.columns
    context = time_feed_temperature(table, faults)
    given = {name: approaches(table, name, faults) for name in names if name in present}
    faults.raise_if_any()
    known = {**dict(zip(machine.axes, commanded, strict=True)), **dict(zip(TOOL_COLUMNS, tool, strict=True))}
    known |= context | given
    frame = pl.DataFrame({name: pl.Series(known[name]) for name in present}).fill_nan(None)
    return Points(frame, commanded, tool, _context(names, given, context, table.frame.height))


def points_at(positions: FloatArray, tool: FloatArray, machine: MachineAxes) -> Points:
    """Points of no file: axes that have not moved yet, time and temperature not known.

    positions: (n_axes, n), mm or deg; tool: (3, n), mm.
    """
    rows = {**dict(zip(machine.axes, positions, strict=True)), **dict(zip(TOOL_COLUMNS, tool, strict=True))}
    names = tuple(f"dir_{axis}" for axis in machine.axes)
    return Points(pl.DataFrame(rows), positions, tool, _context(names, {}, {}, positions.shape[1]))


def _context(
    names: tuple[str, ...], given: dict[str, FloatArray], columns: dict[str, FloatArray], count: int
) -> Context:
    nothing = np.full(count, np.nan)
    time, temperature = (columns.get(name, nothing) for name in CONTEXT_COLUMNS)
    context = Context.at_rest(len(names), count, time, temperature)
    directions = np.array([np.nan_to_num(given.get(name, np.zeros(count))) for name in names])
    return replace(context, directions=directions)


def dump_predicted(
    points: Points,
    deviation: FloatArray,
    suffix: str,
    u: FloatArray | None = None,
    u_prior: FloatArray | None = None,
    further: Sequence[tuple[tuple[str, ...], FloatArray]] = (),
) -> bytes:
    """The columns of the points, dx, dy, dz (mm) and, where given, u_dx ... and u_prior_dx ..., as CSV or Parquet.

    deviation: (3, n), mm; suffix: `.parquet` for Parquet; u: (3, n), standard uncertainties, u_prior: (3, n), the parts
    of them that rest on the prior, mm, NaN where unknown; further: names and rows of columns behind these.
    """
    added = [pl.Series(name, row) for name, row in zip(DEVIATION_COLUMNS, deviation, strict=True)]
    for names, rows in ((UNCERTAINTY_COLUMNS, u), (PRIOR_COLUMNS, u_prior), *further):
        if rows is not None:
            added += [pl.Series(name, row).fill_nan(None) for name, row in zip(names, rows, strict=True)]
    return table_bytes(points.frame.with_columns(added), suffix)


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
