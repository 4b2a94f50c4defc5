"""What has passed since an axis turned back last: its own way, time, and the way along the path."""

from collections.abc import Sequence
from typing import cast

import numpy as np
import numpy.typing as npt

from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray

SECONDS = 60.0  # of a minute: feeds are in mm/min


def distance_since_reversal(directions: FloatArray, path: FloatArray, *, turned_before: bool = False) -> FloatArray:
    """(n_axes, n): the way of each axis since its direction changed last, mm or deg; infinite before the first change.

    directions: (n_axes, n), +1, -1, or 0, which changes nothing; path: (n_axes, n), both in the order of reading. The
    change is taken to have happened at the reading before the first one with the new direction. turned_before: the
    first direction of an axis is a change, too.
    """
    way = np.cumsum(np.abs(np.diff(path, prepend=path[:, :1], axis=1)), axis=1)
    return _since(way, _turnings(directions, turned_before=turned_before))


def path_since_reversal(
    axes: Sequence[str],
    directions: FloatArray,
    path: FloatArray,
    share: FloatArray | float = 0.0,
    *,
    turned_before: bool = False,
) -> FloatArray:
    """(n_axes, n), mm: the way along the path of all linear axes since each axis turned back, as above.

    share: (n_axes, n), of the step after the reading before, on which it turned.
    """
    way = np.cumsum(_steps(axes, path))
    return _since(np.broadcast_to(way, path.shape), _turnings(directions, turned_before=turned_before), share)


def turned_on_the_way(axes: Sequence[str], directions: FloatArray, path: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Where axes turn between readings of a steady motion, by velocities that are linear along the path between the
    middles of its steps: exact for a parabola.

    (n_axes, n) each: the share, of the step from the reading before its direction changed, at which each axis turned
    last (below 0 where it was a little earlier: the chord to that reading still had the old direction), and by how much
    farther the axis has come since than from that reading.
    """
    share, beyond = np.zeros(path.shape), np.zeros(path.shape)
    turned, count = _turnings(directions), path.shape[1]
    steps = _steps(axes, path)
    way = np.cumsum(steps) if (steps[1:] > 0.0).all() else np.arange(float(count))
    middle = 0.5 * (way[1:] + way[:-1])
    for axis in range(path.shape[0]):
        velocity = np.diff(path[axis]) / np.diff(way)
        for before in np.unique(turned[axis][(turned[axis] > 0) & (turned[axis] < count - 2)]).tolist():
            one = before - 1 if velocity[before] * directions[axis, before + 1] > 0.0 else before
            low, high = velocity[one : one + 2].tolist()
            if low * high >= 0.0:
                continue
            bent = (high - low) / (middle[one + 1] - middle[one])
            at = min(middle[one] - low / bent, way[before + 1])
            mine = turned[axis] == before
            share[axis, mine] = (at - way[before]) / (way[before + 1] - way[before])
            gone = 0.5 * abs(bent) * (way[before + 1] - at) ** 2
            beyond[axis, mine] = gone - abs(path[axis, before + 1] - path[axis, before])
    return share, beyond


def time_since_reversal(
    directions: FloatArray, time: FloatArray, duration: FloatArray, share: FloatArray | float = 0.0
) -> FloatArray:
    """(n_axes, n), s: the time since each axis turned back in the run, infinite before; NaN where nothing tells it.

    time: (n,), s, NaN where unknown; duration: (n,), s, of the way to each reading, which tells where times do not: NaN
    where it is unknown, too; share: (n_axes, n), of the step on which it turned.
    """
    turned = _turnings(directions)
    told = _since(np.broadcast_to(time, directions.shape), turned, share)
    gaps = np.isnan(duration)
    unknown = _since(np.broadcast_to(np.cumsum(gaps, dtype=np.float64), directions.shape), turned) > 0.0
    summed = _since(np.broadcast_to(np.cumsum(np.where(gaps, 0.0, duration)), directions.shape), turned, share)
    found = np.where(told >= 0.0, told, np.where(unknown, np.nan, summed))
    return cast(FloatArray, np.where(turned < 0, np.inf, found))


def duration_by_feed(axes: Sequence[str], path: FloatArray, feed: FloatArray) -> FloatArray:
    """(n,), s: how long the way to each reading takes at its feed (mm/min, of the linear axes together).

    0 for the first reading; NaN without a feed, and where rotary axes turn alone, of which it tells nothing.
    """
    steps = _steps(axes, path)
    turning = np.diff(path, prepend=path[:, :1], axis=1).any(axis=0) & (steps == 0.0)
    found: FloatArray = np.divide(steps * SECONDS, feed, out=np.full(steps.size, np.nan), where=(feed > 0.0) & ~turning)
    found[:1] = 0.0
    return found


def _steps(axes: Sequence[str], path: FloatArray) -> FloatArray:
    """(n,), mm: the way of the linear axes together to each reading."""
    linear = np.array([axis in LINEAR for axis in axes], dtype=bool)
    steps: FloatArray = np.linalg.norm(np.diff(path[linear], prepend=path[linear][:, :1], axis=1), axis=0)
    return steps


def _turnings(directions: FloatArray, *, turned_before: bool = False) -> npt.NDArray[np.int64]:
    """(n_axes, n): the reading at which each axis turned back last, -1 before the first time."""
    rows = np.arange(directions.shape[1])
    last = np.maximum.accumulate(np.where(directions != 0.0, rows, 0), axis=1)
    held = np.take_along_axis(directions, last, axis=1)
    changed = np.zeros(directions.shape, dtype=bool)
    changed[:, 1:] = held[:, 1:] * held[:, :-1] < 0.0
    turned = np.maximum.accumulate(np.where(changed, rows, 0), axis=1)
    found = np.where(turned > 0, turned - 1, -1)
    if turned_before:
        first = np.maximum(np.argmax(directions != 0.0, axis=1) - 1, 0)[:, np.newaxis]
        found = np.where((turned == 0) & (held != 0.0), first, found)
    return found


def _since(counted: FloatArray, turned: npt.NDArray[np.int64], share: FloatArray | float = 0.0) -> FloatArray:
    """(n_axes, n): what counts up along the readings (n_axes, n), from where it turned last; infinite before."""
    at_turn = np.take_along_axis(counted, np.maximum(turned, 0), axis=1)
    after = np.take_along_axis(counted, np.minimum(turned + 1, counted.shape[1] - 1), axis=1)
    at_turn = np.where(np.asarray(share) != 0.0, at_turn + share * (after - at_turn), at_turn)
    found: FloatArray = np.where(turned < 0, np.inf, counted - at_turn)
    return found
