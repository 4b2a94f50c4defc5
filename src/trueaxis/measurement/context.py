"""The context of readings: how each axis came to where it was read, how fast it moved, when and how warm it was."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run
from trueaxis.measurement.since_reversal import (
    SECONDS,
    distance_since_reversal,
    duration_by_feed,
    path_since_reversal,
    time_since_reversal,
)
from trueaxis.model.context import Context

IntArray = npt.NDArray[np.int64]


class Rows(Protocol):
    """Rows of readings: run (n,), index into the runs; seq (n,), order within the run; positions, directions
    (n_axes, n); time (s), feed (mm/min), temperature (degC): (n,), None where unknown, NaN where a cell is empty.
    """

    @property
    def axes(self) -> tuple[str, ...]:
        """Axis letters in the order X Y Z A B C."""
        ...

    @property
    def run(self) -> IntArray:
        """(n,), index into the runs."""
        ...

    @property
    def seq(self) -> IntArray:
        """(n,), order within the run."""
        ...

    @property
    def positions(self) -> FloatArray:
        """(n_axes, n), commanded, mm or deg."""
        ...

    @property
    def directions(self) -> npt.NDArray[np.int8] | FloatArray:
        """(n_axes, n), approach directions: +1, -1, 0."""
        ...

    @property
    def time(self) -> FloatArray | None:
        """(n,), s."""
        ...

    @property
    def feed(self) -> FloatArray | None:
        """(n,), mm/min."""
        ...

    @property
    def temperature(self) -> FloatArray | None:
        """(n,), degC."""
        ...


def context_of(runs: Sequence[Run], rows: Rows) -> Context:
    """The context of every row, with that of its run's home.

    Directions are those of the rows. What has passed since the last reversal is that of the commanded positions, from
    the reading before the direction changed. Laser and probe read standing axes, which come to the first target of a
    run from a reversal beyond it (ISO 230-1, approach from one side): ways count from the first target; since when the
    axis stands there, nobody knows, and the time since that reversal is infinite. A ball bar is read on the way: its
    velocities have the feed along the tangent of the path or, where no feed is given, follow from the times. Home is
    where laser and probe were zeroed before they read: no axis has moved or turned back yet, and time and temperature
    are those of the run's first row.
    """
    shape = rows.positions.shape
    count = shape[1]
    time, feed, temperature = (
        np.full(count, np.nan) if values is None else values for values in (rows.time, rows.feed, rows.temperature)
    )
    directions = rows.directions.astype(np.float64)
    velocity = np.zeros(shape)
    since, time_since, path_since = (np.full(shape, np.inf) for _ in range(3))
    home_time, home_temperature = np.full(count, np.nan), np.full(count, np.nan)
    order = np.lexsort((rows.seq, rows.run))
    starts = np.flatnonzero(np.diff(rows.run[order], prepend=-1))
    for mine in np.split(order, starts[1:]):
        if mine.size == 0:
            continue
        path, ways = rows.positions[:, mine], directions[:, mine]
        standing = runs[rows.run[mine[0]]].instrument != "ballbar"
        fed = np.full(mine.size, np.nan) if standing else feed[mine]  # how long an axis stood no feed tells
        since[:, mine] = distance_since_reversal(ways, path, turned_before=standing)
        time_since[:, mine] = time_since_reversal(ways, time[mine], duration_by_feed(rows.axes, path, fed))
        path_since[:, mine] = path_since_reversal(rows.axes, ways, path, turned_before=standing)
        home_time[mine], home_temperature[mine] = time[mine[0]], temperature[mine[0]]
        if not standing:
            velocity[:, mine] = path_velocity(rows.axes, path, feed[mine], time[mine])
    home = Context.at_rest(shape[0], count, home_time, home_temperature)
    return Context(
        directions=directions,
        velocity=velocity,
        since_reversal=since,
        time_since=time_since,
        path_since=path_since,
        time=time,
        temperature=temperature,
        home=home,
    )


def path_velocity(axes: Sequence[str], path: FloatArray, feed: FloatArray, time: FloatArray) -> FloatArray:
    """(n_axes, n): velocity of each axis along a path of commanded positions, mm/s or deg/s.

    path: (n_axes, n), in the order of reading, about evenly spaced; feed: (n,), mm/min, of the linear axes together;
    time: (n,), s, asked where the feed is NaN or a rotary axis turns: a control may mean the feed of the tool over the
    workpiece there. 0 where the path stands or turns back, NaN where neither is known.
    """
    linear = np.array([axis in "XYZ" for axis in axes])
    steps, passed = _differences(path), _differences(time[np.newaxis])[0]
    length = np.linalg.norm(steps[linear], axis=0)
    standing = ~steps.any(axis=0)
    fed = (feed > 0.0) & ~(steps[~linear].any(axis=0) & (passed > 0.0))
    duration = np.divide(length * SECONDS, feed, out=passed, where=fed)
    found: FloatArray = np.divide(steps, duration, out=np.full_like(steps, np.nan), where=duration > 0.0)
    found[:, standing & fed] = 0.0
    return found


def _differences(path: FloatArray) -> FloatArray:
    """Differences over two steps, (k, n), exact for a parabola: central ones, and from three points at the ends."""
    count = path.shape[1]
    if count < 3:
        return np.repeat(2.0 * (path[:, -1:] - path[:, :1]), count, axis=1)
    found = np.empty_like(path)
    found[:, 1:-1] = path[:, 2:] - path[:, :-2]
    found[:, 0] = -3.0 * path[:, 0] + 4.0 * path[:, 1] - path[:, 2]
    found[:, -1] = 3.0 * path[:, -1] - 4.0 * path[:, -2] + path[:, -3]
    return found
