"""readings.csv or readings.parquet to arrays, with every fault at its line and column."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.io.faults import Faults
from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.columns import (
    approaches,
    check_columns,
    note,
    numbers,
    positions,
    shortened,
    texts,
    time_feed_temperature,
    whole_numbers,
)
from trueaxis.measurement.instrument_kinds import ARM, AT_REST
from trueaxis.measurement.machine import MachineAxes
from trueaxis.measurement.readings import DirectionArray, Readings, angle_rows
from trueaxis.measurement.setup import Run
from trueaxis.measurement.table import MOST_FAULTS, Table, read_table

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]

LARGEST_READING = 100.0  # mm, of an angle at ARM: a deviation beyond it is in another unit
DECIMALS = 6  # of mm and deg, within which positions are the same

_REQUIRED = ("run", "seq", "reading")
_OPTIONAL = ("time_s", "feed", "temperature_c")


def read_readings(path: Path, machine: MachineAxes, runs: Sequence[Run] | None) -> Readings:
    """Read the readings of a machine's runs.

    runs: those of the setup; None where the setup could not be read: what is left of the file is checked then.
    Raises InputError with every fault of the file.
    """
    table = read_table(path)
    faults = Faults(str(path))
    columns = table.frame.columns
    named = tuple(f"dir_{axis}" for axis in machine.axes)
    check_columns(table, machine, faults, required=_REQUIRED, optional=(*_OPTIONAL, *named))
    if table.frame.height == 0:
        faults.add("", "has no rows", "a row per reading, with an empty reading where it is still to be taken")
    commanded = positions(table, machine, faults)
    run_ids, run = _runs(table, runs, faults)
    seq = _seq(table, run, faults)
    optional = time_feed_temperature(table, faults)
    given = {name[4:]: approaches(table, name, faults) for name in named if name in columns}
    angle = angle_rows(run, runs or ())
    reading = _reading(table, angle, faults)
    check_at_rest(table, machine.axes, commanded, run, runs or (), faults)
    faults.raise_if_any()
    directions = _derived_directions(runs or (), machine.axes, (run, seq, commanded))
    for row, axis in enumerate(machine.axes):
        if axis in given:
            directions[row] = np.where(np.isnan(given[axis]), directions[row], given[axis]).astype(np.int8)
    return Readings(
        axes=machine.axes,
        run_ids=run_ids,
        run=run,
        seq=seq,
        positions=commanded,
        directions=directions,
        reading=reading,
        given_directions=tuple(given),
        time=optional.get("time_s"),
        feed=optional.get("feed"),
        temperature=optional.get("temperature_c"),
    )


def _runs(table: Table, runs: Sequence[Run] | None, faults: Faults) -> tuple[tuple[str, ...], IntArray]:
    """Ids in the order of the setup, and each row's index into them (-1 for an unknown run, which is noted)."""
    if "run" not in table.frame.columns:
        return (), np.full(table.frame.height, -1, dtype=np.int64)
    named = texts(table, "run", faults)
    present = named.filter(named != "").unique(maintain_order=True).to_list()
    ids = tuple(run.id for run in runs) if runs is not None else tuple(present)
    index = {name: number for number, name in enumerate(ids)}
    known = [name for name in present if name in index]
    unknown = [name for name in present if name not in index]
    for name in unknown[:MOST_FAULTS]:
        first = int((named == name).arg_max() or 0)
        remedy = f"runs {', '.join(ids[:MOST_FAULTS])}{' ...' if len(ids) > MOST_FAULTS else ''}"
        faults.add(table.place(first, "run"), f'the setup has no run "{shortened(name)}"', remedy)
    if len(unknown) > MOST_FAULTS:
        faults.add("column run", f"and so {len(unknown) - MOST_FAULTS} more runs")
    there = set(present)
    for name in (name for name in ids if name not in there):
        faults.add("column run", f'there is no row of run "{name}"', "remove the run from the setup, or read it")
    codes = named.replace_strict(known, [index[name] for name in known], default=-1, return_dtype=pl.Int64)
    return ids, codes.to_numpy().astype(np.int64)


def _seq(table: Table, run: IntArray, faults: Faults) -> IntArray:
    if "seq" not in table.frame.columns:
        return np.zeros(table.frame.height, dtype=np.int64)
    seq = whole_numbers(table, "seq", faults)
    if "run" in table.frame.columns:
        keys = pl.DataFrame({"run": run, "seq": seq})
        again = ~keys.select(pl.struct("run", "seq").is_first_distinct()).to_series().to_numpy() & (run >= 0)
        note(table, "seq", again, faults, "is given already in this run", remedy="a number of its own for each row")
    return seq


def _reading(table: Table, angle: npt.NDArray[np.bool_], faults: Faults) -> FloatArray:
    """(n,), mm, of angle instruments mm at ARM; angle: (n,), their rows."""
    if "reading" not in table.frame.columns:
        return np.full(table.frame.height, np.nan)
    values = numbers(table, "reading", faults, may_be_empty=True)
    scale = np.where(angle, ARM, 1.0)
    large = np.abs(values) > LARGEST_READING / scale
    remedy = f"readings are deviations in mm, at most {LARGEST_READING:g}"
    note(table, "reading", large & ~angle, faults, "is too large", remedy=remedy)
    remedy = f"readings of angle instruments are deviations in rad, at most {LARGEST_READING / ARM:g}"
    note(table, "reading", large & angle, faults, "is too large", remedy=remedy)
    return np.where(large, np.nan, values) * scale


def check_at_rest(
    table: Table,
    axes: Sequence[str],
    commanded: FloatArray,
    run: IntArray,
    runs: Sequence[Run],
    faults: Faults,
) -> None:
    """A displacement sensor stays at the pose at which it was zeroed: note rows elsewhere.

    commanded: (n_axes, n), mm or deg; run: (n,), index into runs, -1 for none.
    """
    for index, one in enumerate(runs):
        if one.instrument == AT_REST:
            for axis, at in zip(axes, commanded, strict=True):
                away = (run == index) & (np.abs(at - one.home[axis]) > 10.0**-DECIMALS)
                remedy = f"{one.home[axis]:g}, home of run {one.id}: a displacement sensor reads at one pose"
                note(table, axis, away, faults, "is not at home", remedy=remedy)


def _derived_directions(
    runs: Sequence[Run], axes: Sequence[str], rows_of_all: tuple[IntArray, IntArray, FloatArray]
) -> DirectionArray:
    """Approach directions from the order of seq; rows_of_all: run (n,), seq (n,), positions (n_axes, n)."""
    run, seq, commanded = rows_of_all
    found = np.zeros(commanded.shape, dtype=np.int8)
    by_run = np.argsort(run, kind="stable")
    ends = np.searchsorted(run[by_run], np.arange(len(runs) + 1))
    for one, start_row, end_row in zip(runs, ends, ends[1:], strict=False):
        rows = by_run[start_row:end_row]
        found[:, rows] = approach_directions(one, axes, seq[rows], commanded[:, rows])
    return found
