"""The readings of a set of measured data, as arrays, and the way by which each axis came to where it was read."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import polars as pl

from trueaxis.measurement.instrument_kinds import ANGLE, ARM
from trueaxis.measurement.setup import Run
from trueaxis.measurement.table import table_bytes

FloatArray = npt.NDArray[np.float64]
IntArray = npt.NDArray[np.int64]
FILE_NAME = "readings.csv"
PARQUET_NAME = "readings.parquet"
SHORT = 15  # digits that every number keeps on its way through binary
DirectionArray = npt.NDArray[np.int8]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Readings:
    """One row per reading, in the order of the file.

    axes: letters in the order X Y Z A B C; run_ids: in the order of the setup; run: (n,), index into run_ids;
    seq: (n,), order within the run; positions: (n_axes, n), commanded, mm or deg; directions: (n_axes, n), approach
    directions, as given or from the order of seq; given_directions: axes whose directions the file gave; reading:
    (n,), mm, of an angle instrument mm at ARM, NaN where the row is a plan; time (s), feed (mm/min), temperature
    (degC): (n,), None where the file has no such column, NaN where a cell is empty.
    """

    axes: tuple[str, ...]
    run_ids: tuple[str, ...]
    run: IntArray
    seq: IntArray
    positions: FloatArray
    directions: DirectionArray
    reading: FloatArray
    given_directions: tuple[str, ...] = ()
    time: FloatArray | None = None
    feed: FloatArray | None = None
    temperature: FloatArray | None = None

    @property
    def planned(self) -> npt.NDArray[np.bool_]:
        """(n,), true where the row has no reading yet."""
        return np.isnan(self.reading)

    def of_run(self, index: int) -> IntArray:
        """The rows of one run, in the order in which they were read."""
        rows = np.flatnonzero(self.run == index)
        return rows[np.argsort(self.seq[rows], kind="stable")]


def dump_readings(readings: Readings, runs: Sequence[Run], suffix: str = ".csv") -> bytes:
    """The content of readings.csv or, for the suffix `.parquet`, readings.parquet; numbers read back exactly.

    runs: of the set-up, in the order of run_ids.
    """
    return table_bytes(readings_frame(readings, runs), suffix)


def readings_frame(readings: Readings, runs: Sequence[Run]) -> pl.DataFrame:
    """The readings as a table with the columns of readings.csv, in its units."""
    columns: dict[str, pl.Series] = {
        "run": pl.Series(np.array(readings.run_ids, dtype=np.str_)[readings.run], dtype=pl.String),
        "seq": pl.Series(readings.seq),
    }
    if readings.time is not None:
        columns["time_s"] = pl.Series(readings.time)
    for axis, values in zip(readings.axes, readings.positions, strict=True):
        columns[axis] = pl.Series(values)
    for axis, approach in zip(readings.axes, readings.directions, strict=True):
        if axis in readings.given_directions:
            columns[f"dir_{axis}"] = pl.Series(approach)
    if readings.feed is not None:
        columns["feed"] = pl.Series(readings.feed)
    if readings.temperature is not None:
        columns["temperature_c"] = pl.Series(readings.temperature)
    columns["reading"] = pl.Series(_of_file(readings, runs))
    return pl.DataFrame(columns).fill_nan(None)


def angle_rows(run: IntArray, runs: Sequence[Run]) -> npt.NDArray[np.bool_]:
    """(n,): rows of angle instruments. run: (n,), index into runs, -1 for none."""
    return np.isin(run, [index for index, one in enumerate(runs) if one.instrument == ANGLE])


def _of_file(readings: Readings, runs: Sequence[Run]) -> FloatArray:
    """(n,): readings in the units of the file, mm or rad: those that read back as the same number, short where it
    is.
    """
    found = readings.reading.copy()
    for row in np.flatnonzero(angle_rows(readings.run, runs)):
        exact = float(found[row]) / ARM
        short = float(f"{exact:.{SHORT}g}")
        found[row] = short if short * ARM == found[row] else exact
    return found
