"""What structure of each class would be in the readings: columns over all rows, without any cause."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from trueaxis.diagnosis.causes.signature import Readings
from trueaxis.diagnosis.judging.structure import StructureClass
from trueaxis.diagnosis.null_model.rows import Rows, plane_of
from trueaxis.diagnosis.result import BoolArray, FloatArray
from trueaxis.error_name import ErrorName

DEGREE = 6
LOBES = 10
RIPPLE = 30  # lobes of a circle, half periods on a line: up to so many, beyond the coarse ones
BINS = 6
LATE = 3  # powers of the time over all runs: a start, an end, and a turn between


@dataclass(frozen=True, slots=True, eq=False)
class Structure:
    """One class at one place, see `Check`: columns (n, k) over all rows."""

    kind: StructureClass
    place: str
    columns: FloatArray


def structures(readings: Readings) -> Iterator[Structure]:
    """The classes that these readings can show."""
    rows, theta = readings.rows, readings.reading.theta
    ballbar = np.array([run.instrument == "ballbar" for run in rows.runs])[rows.run]
    for axis, name in enumerate(rows.axes):
        mine = ~ballbar & _led_by(rows, axis)
        if mine.any():
            yield from _of_lines(rows, axis, name, mine)
    for number in np.unique(rows.setup[ballbar]):
        mine = ballbar & (rows.setup == number)
        yield from _of_circles(rows, theta, mine)
    moving = [_moved_in(rows, axis) for axis in range(len(rows.axes))]
    for name, lever in zip(readings.model.components, readings.sensitivity, strict=False):  # locations come behind
        yield from _of_error(rows, name, lever, moving[rows.axes.index(name.axis)])


def _of_error(rows: Rows, name: ErrorName, lever: FloatArray, moving: BoolArray) -> Iterator[Structure]:
    """What an error may do that no curve over the position is, as all instruments sense it; lever: (n,), change of each
    reading per unit of the error, mm/mm or mm/rad; moving: (n,), rows of runs in which its axis moves.
    """
    axis = rows.axes.index(name.axis)
    seen = lever != 0.0
    moved = moving & seen
    if not moved.any():
        return
    at, way = rows.positions[axis], rows.directions[axis]
    scaled = _scaled(at, moved)
    odd = (lever * way * moved)[:, np.newaxis]
    yield Structure(StructureClass.ERROR_DIRECTION, name, legendre.legvander(scaled, 2 * DEGREE) * odd)
    since = rows.context.since_reversal[axis]
    after = moved & np.isfinite(since)
    if after.any():
        curve = legendre.legvander(_scaled(since, after), 2 * DEGREE)
        yield Structure(StructureClass.ERROR_AFTER_REVERSALS, name, curve * odd * after[:, np.newaxis])
    course = [_course(rows, moved)]
    if np.isfinite(rows.context.time[seen]).all():
        late = np.asarray(legendre.legvander(_scaled(rows.context.time, seen), LATE)[:, 1:], dtype=np.float64)
        course += [late, late * _scaled(at, seen)[:, np.newaxis]]  # the zero of a run hides what no position changes
    yield Structure(StructureClass.ERROR_COURSE, name, np.hstack(course) * lever[:, np.newaxis])


def _scaled(values: FloatArray, mine: BoolArray) -> FloatArray:
    """(n,): from -1 to 1 over those that count, 0 elsewhere."""
    least, most = values[mine].min(), values[mine].max()
    return np.where(mine, 2.0 * (np.where(mine, values, least) - least) / max(float(most - least), 1e-300) - 1.0, 0.0)


def _moved_in(rows: Rows, axis: int) -> BoolArray:
    """Rows of runs in which this axis moves."""
    found = np.zeros(rows.size, dtype=bool)
    for index in rows.present:
        mine = rows.of_run(index)
        found[mine] = np.ptp(rows.positions[axis, mine]) > 0.0
    return found


def _led_by(rows: Rows, axis: int) -> BoolArray:
    """Rows of runs in which this axis moves most."""
    found = np.zeros(rows.size, dtype=bool)
    for index in rows.present:
        span = np.ptp(rows.positions[:, rows.of_run(index)], axis=1)
        if span[axis] > 0.0 and int(np.argmax(span)) == axis:
            found[rows.of_run(index)] = True
    return found


def _of_lines(rows: Rows, axis: int, name: str, mine: BoolArray) -> Iterator[Structure]:
    at, way = rows.positions[axis], rows.directions[axis]
    scaled = _scaled(at, mine)
    curve = legendre.legvander(scaled, 2 * DEGREE) * mine[:, np.newaxis]
    lines = [mine & (rows.setup == number) for number in np.unique(rows.setup[mine])]
    odd = way[:, np.newaxis]
    yield Structure(StructureClass.LINE_DIRECTION, name, curve * odd)
    yield Structure(
        StructureClass.LINE_DIRECTION_BY_LINE,
        name,
        np.hstack([curve[:, :2] * odd * line[:, np.newaxis] for line in lines]),
    )
    if len(lines) > 1:
        yield Structure(
            StructureClass.LINE_BY_LINE,
            name,
            np.hstack([curve[:, 1 : DEGREE + 1] * line[:, np.newaxis] for line in lines]),
        )
    yield Structure(StructureClass.LINE_COURSE, name, _course(rows, mine))
    if rows.temperature is not None and (read := mine & np.isfinite(rows.temperature)).any():
        warm = np.where(read, rows.temperature - rows.temperature[read].mean(), 0.0)
        yield Structure(
            StructureClass.LINE_TEMPERATURE,
            name,
            np.stack([warm, warm * scaled, warm**2, warm**2 * scaled, warm * way, warm * warm * way], axis=1)
            * mine[:, np.newaxis],
        )
    waves = _waves(np.pi * 0.5 * (scaled + 1.0), range(2 * DEGREE + 1, RIPPLE + 1)) * mine[:, np.newaxis]
    yield Structure(StructureClass.LINE_RIPPLE, name, waves * odd)
    bins = _bins(scaled, 2 * BINS)
    yield Structure(
        StructureClass.LINE_LOCAL,
        name,
        np.hstack([bins * odd, bins]) * mine[:, np.newaxis],
    )


def _course(rows: Rows, mine: BoolArray) -> FloatArray:
    """(n, 3): polynomials of the place in each run, beyond a slope, which is noise."""
    found = np.zeros((rows.size, 3))
    for index in rows.present:
        part = rows.of_run(index)
        if mine[part].any():
            found[part] = legendre.legvander(np.linspace(-1.0, 1.0, part.stop - part.start), 4)[:, 2:]
    return found


def _waves(angle: FloatArray, orders: Iterable[int]) -> FloatArray:
    """(n, 2 orders): cosines and sines of multiples of an angle."""
    return np.stack([part(k * angle) for k in orders for part in (np.cos, np.sin)], axis=1)


def _bins(scaled: FloatArray, count: int) -> FloatArray:
    edge = np.clip(((scaled + 1.0) / 2.0 * count).astype(int), 0, count - 1)
    return np.asarray(np.eye(count)[edge])


def _of_circles(rows: Rows, theta: FloatArray, mine: BoolArray) -> Iterator[Structure]:
    angle, inside = np.where(mine, theta, 0.0), mine[:, np.newaxis]
    lobes = np.hstack([np.ones((rows.size, 1)), _waves(angle, range(1, LOBES + 1))]) * inside
    ripple = _waves(angle, range(LOBES + 1, RIPPLE + 1)) * inside
    sense = _sense(rows, theta)[:, np.newaxis]
    place = plane_of(rows, mine)
    yield Structure(StructureClass.CIRCLE_LOBES, place, lobes[:, 1:])
    yield Structure(StructureClass.CIRCLE_RIPPLE, place, ripple)
    yield Structure(StructureClass.CIRCLE_COURSE, place, _course(rows, mine))
    both = np.unique(sense[mine]).size > 1
    if both:
        yield Structure(StructureClass.CIRCLE_DIRECTION, place, lobes * sense)
        yield Structure(StructureClass.CIRCLE_RIPPLE_DIRECTION, place, ripple * sense)
    feeds = _feeds(rows, mine)
    if feeds is not None:
        fast = feeds[:, np.newaxis]
        yield Structure(StructureClass.CIRCLE_FEED, place, lobes * fast)
        if both:
            yield Structure(
                StructureClass.CIRCLE_DIRECTION_FEED,
                place,
                lobes * fast * sense,
            )
    moving = [axis for axis in range(len(rows.axes)) if np.ptp(rows.positions[axis, mine]) > 0.0]
    if not moving:
        return
    quarter = np.hstack([rows.directions[axis][:, np.newaxis] * mine[:, np.newaxis] for axis in moving])
    yield Structure(StructureClass.CIRCLE_REVERSALS, place, quarter)
    near = np.hstack(
        [
            np.exp(-_since_turn(rows, axis, mine) / decay)[:, np.newaxis] * rows.directions[axis][:, np.newaxis]
            for axis in moving
            for decay in (1.0, 4.0, 16.0)
        ]
    )
    yield Structure(StructureClass.CIRCLE_AFTER_REVERSALS, place, near * mine[:, np.newaxis])


def _since_turn(rows: Rows, axis: int, mine: BoolArray) -> FloatArray:
    found = np.full(rows.size, np.inf)
    for index in np.unique(rows.run[mine]):
        part = rows.of_run(int(index))
        way, at = rows.directions[axis, part], rows.positions[axis, part]
        turn = np.flatnonzero(np.diff(way) != 0.0) + 1
        if turn.size:
            last = np.searchsorted(turn, np.arange(way.size), side="right") - 1
            start = at[turn[np.maximum(last, 0)]]
            found[part] = np.where(last >= 0, np.abs(at - start), np.inf)
    return found


def _sense(rows: Rows, theta: FloatArray) -> FloatArray:
    """(n,): +1 where the polar angle grows in the run, -1 where it falls, 0 for lines."""
    found = np.zeros(rows.size)
    for index in rows.present:
        part = rows.of_run(index)
        if np.isfinite(theta[part]).all() and part.stop - part.start > 1:
            found[part] = np.sign(np.median(np.diff(np.unwrap(theta[part]))))
    return found


def _feeds(rows: Rows, mine: BoolArray) -> FloatArray | None:
    if rows.feed is None:
        return None
    feed = rows.feed[mine]
    if not np.isfinite(feed).all() or np.unique(feed).size < 2:
        return None
    found = np.zeros(rows.size)
    found[mine] = (feed - feed.mean()) / np.ptp(feed)
    return found
