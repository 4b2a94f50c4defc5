"""Where axes turn back in a run, and what has passed since: their own way, the way along the path, and time."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray

BoolArray = npt.NDArray[np.bool_]
IntArray = npt.NDArray[np.int64]
SECONDS = 60.0  # of a minute: feeds are in mm/min


@dataclass(frozen=True, slots=True, eq=False)
class Reversals:
    """The last reversal of each axis before each reading of a run, in the order of reading: (n_axes, n) each.

    row: the reading from which it is counted, -1 where there was none; share: of the step after that reading, on which
    the axis turned: below 0 where it turned before the reading; beyond: by how much farther the axis has come since
    than from that reading, mm or deg; stood: whether nobody knows how long the axis stood at that reading.
    """

    row: IntArray
    share: FloatArray
    beyond: FloatArray
    stood: BoolArray

    def since_row(self, counted: FloatArray) -> FloatArray:
        """(n_axes, n): what has passed since `row` of what counts up along the readings, (n,) or (n_axes, n); infinite
        before the first reversal.
        """
        counted = np.broadcast_to(counted, self.row.shape)
        at = np.take_along_axis(counted, np.maximum(self.row, 0), axis=1)
        found: FloatArray = np.where(self.row < 0, np.inf, counted - at)
        return found

    def since(self, counted: FloatArray) -> FloatArray:
        """(n_axes, n): the same since the axis turned, between two readings."""
        found = self.since_row(counted)
        turned = self.share != 0.0
        if turned.any():
            steps = np.diff(np.broadcast_to(counted, self.row.shape), append=np.nan, axis=1)
            found[turned] -= (self.share * np.take_along_axis(steps, np.maximum(self.row, 0), axis=1))[turned]
        return found


def reversals_of_standing(directions: FloatArray, path: FloatArray) -> Reversals:
    """Of axes that are read while they stand, approaching from directions (n_axes, n): +1, -1, or 0, which changes
    nothing. path: (n_axes, n).

    An axis turns at the reading before its direction changed; at the target itself, just beyond it, where it comes to
    it from the side away from the reading before; and before the first target (ISO 230-1, approach from one side).
    """
    changed = _changes(directions)
    returned = np.diff(path, prepend=path[:, :1], axis=1) * directions < 0.0
    row = np.maximum.accumulate(np.where(returned, np.arange(path.shape[1]), changed), axis=1)
    moved = np.maximum.accumulate(directions != 0.0, axis=1)
    first = np.maximum(np.argmax(directions != 0.0, axis=1) - 1, 0)[:, np.newaxis]
    turned = np.where((row < 0) & moved, first, row)
    return Reversals(turned, np.zeros(path.shape), np.zeros(path.shape), (row > changed) | (row < 0))


def reversals_on_the_way(axes: Sequence[str], directions: FloatArray, path: FloatArray) -> Reversals:
    """Of axes that are read while they move steadily: where the velocity along the path passes zero.

    Velocities are those of the middles of the steps, linear in between, which is exact for a parabola. A run is taken
    to have begun earlier on the same curve, as that of a ball bar does: an axis may have turned before its first
    reading. Cost in proportion to the readings.
    """
    row, way = _changes(directions), _way(axes, path)
    share, beyond = np.zeros(path.shape), np.zeros(path.shape)
    for one in _turns(row, directions, path, way):
        mine = (row[one.axis] == one.row) & (way > one.at)
        row[one.axis, mine] = one.after - 1
        share[one.axis, mine] = (one.at - way[one.after - 1]) / (way[one.after] - way[one.after - 1])
        beyond[one.axis, mine] = one.gone - abs(path[one.axis, one.after] - path[one.axis, one.after - 1])
    return Reversals(row, share, beyond, np.zeros(path.shape, dtype=bool))


def beside_reversals(axes: Sequence[str], directions: FloatArray, path: FloatArray, reach: float) -> BoolArray:
    """(n,): readings on the way, of which it is anybody's choice on which side of a reversal they were taken.

    They are those at which an axis is no farther than `reach`, mm or deg, from where it turned, be that before the
    first reading, and those between there and where its direction changes; where the path does not show where it
    turned, the two beside the change.
    """
    row, way = _changes(directions), _way(axes, path)
    found, last = np.zeros(way.size, dtype=bool), way.size - 1
    changes = {(axis, turn) for axis in range(len(axes)) for turn in np.unique(row[axis]).tolist() if turn >= 0}
    for one in _turns(row, directions, path, way):
        changes.discard((one.axis, one.row))
        at = path[one.axis, one.after] - np.sign(directions[one.axis, one.after]) * one.gone
        far = np.abs(path[one.axis] - at) > reach
        first, then = one.row, one.row + 1  # from -1 and 0 on where it turned before the first
        while first >= 0 and not (far[first] and way[first] < one.at):
            found[first], first = True, first - 1
        while then <= last and not (far[then] and way[then] > one.at):
            found[then], then = True, then + 1
    for _, turn in changes:
        found[turn : turn + 2] = True
    return found


@dataclass(frozen=True, slots=True, kw_only=True)
class _Turn:
    """Where an axis turned. row: the reading before its direction changed, -1 where that was before the first; after:
    the first reading after it turned, or nearly; at: its place along the way; gone: how far the axis has come from
    there to that reading.
    """

    axis: int
    row: int
    after: int
    at: float
    gone: float


def _turns(row: IntArray, directions: FloatArray, path: FloatArray, way: FloatArray) -> list[_Turn]:
    """Those that the path shows. row: see `_changes`; way: (n,), along the path."""
    found, count = [], way.size
    middle = 0.5 * (way[1:] + way[:-1])
    for axis in range(path.shape[0] if count > 2 else 0):
        velocity = np.diff(path[axis]) / np.diff(way)
        bent = np.diff(velocity) / np.diff(middle)
        for turn in np.unique(row[axis, row[axis] < count - 2]).tolist():
            after = max(turn, 0) + 1
            # the chord to the reading before the change still had the old direction where the axis turned after it
            late = turn >= 0 and velocity[after - 1] * directions[axis, after] <= 0.0
            at_once = turn <= 0 and not late  # before the middle of the first step
            one = after - 1 if late or at_once else after - 2
            # of a chord about the very place where it turned the velocity may be 0
            before = one - 1 if velocity[one] == 0.0 and one > 0 else one
            turned = velocity[one] * bent[one] > 0.0 if at_once else velocity[before] * velocity[one + 1] < 0.0
            if turned:
                at = float(min(middle[one] - velocity[one] / bent[one], way[after]))
                gone = 0.5 * abs(float(bent[one])) * (float(way[after]) - at) ** 2
                found.append(_Turn(axis=axis, row=turn, after=after, at=at, gone=gone))
    return found


def _way(axes: Sequence[str], path: FloatArray) -> FloatArray:
    """(n,): along the path, mm; by the number of the reading where the linear axes stand."""
    steps = _steps(axes, path)
    return np.cumsum(steps) if (steps[1:] > 0.0).all() else np.arange(float(path.shape[1]))


def distance_since(turned: Reversals, path: FloatArray) -> FloatArray:
    """(n_axes, n), mm or deg: the way of each axis since it turned back last; infinite before it did."""
    return turned.since_row(np.cumsum(np.abs(np.diff(path, prepend=path[:, :1], axis=1)), axis=1)) + turned.beyond


def path_since(turned: Reversals, axes: Sequence[str], path: FloatArray) -> FloatArray:
    """(n_axes, n), mm: the way along the path of all linear axes since each axis turned back last."""
    return turned.since(np.cumsum(_steps(axes, path)))


def time_since(turned: Reversals, time: FloatArray, duration: FloatArray) -> FloatArray:
    """(n_axes, n), s: the time since each axis turned back in the run, infinite before; NaN where nothing tells it.

    time: (n,), s, NaN where unknown; duration: (n,), s, of the way to each reading, which tells where times do not: NaN
    where it is unknown, too.
    """
    told = np.where(turned.stood, np.inf, turned.since(time))
    gaps = np.isnan(duration)
    unknown = turned.since(np.cumsum(gaps, dtype=np.float64)) > 0.0
    summed = turned.since(np.cumsum(np.where(gaps, 0.0, duration)))
    found: FloatArray = np.where(told >= 0.0, told, np.where(unknown, np.nan, summed))
    return found


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


def _changes(directions: FloatArray) -> IntArray:
    """(n_axes, n): the reading before the last change of direction, -1 before the first."""
    rows = np.arange(directions.shape[1])
    last = np.maximum.accumulate(np.where(directions != 0.0, rows, 0), axis=1)
    held = np.take_along_axis(directions, last, axis=1)
    changed = np.zeros(directions.shape, dtype=bool)
    changed[:, 1:] = held[:, 1:] * held[:, :-1] < 0.0
    found: IntArray = np.maximum.accumulate(np.where(changed, rows - 1, -1), axis=1)
    return found
