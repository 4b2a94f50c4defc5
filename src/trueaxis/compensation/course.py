"""How the axes get along the motions of a path: direction, distance since the last reversal, velocity; and the machine
at its places, where effects depend on that.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.columns import columns_of
from trueaxis.compensation.machine import ErrorModel, FloatArray, linear_rows
from trueaxis.compensation.path import Path
from trueaxis.effects.placement import FARTHEST
from trueaxis.model.context import Context

LONG = 1e4  # s: no spike lasts so long; small enough for sums over many motions to keep their digits


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Course:
    """One column for each motion of a path; rows of arrays (n_axes, n) are the axes.

    direction: of each axis during the motion, +1, -1, or 0 where it has not moved yet. since (3, n_axes, n): distance
    (mm or deg), time (s) and way along the path (mm) since its last reversal at the start of the motion, FARTHEST
    before the first; gone (3, n_axes, n): what the motion adds to them.
    velocity: mm/s or deg/s, at the start, in the midst and at the end of the motion; ramp (n,): share of the motion
    over which the first passes into the second, and the second into the third, at most 1/2.
    """

    direction: FloatArray
    since: FloatArray
    gone: FloatArray
    velocity: tuple[FloatArray, FloatArray, FloatArray]
    ramp: FloatArray

    def context(self, motion: NDArray[np.int64], place: FloatArray, time: float, temperature: float) -> Context:
        """At shares `place` (n,) of the motions given; time s, temperature degC."""
        start, midst, end = (columns_of(part, motion) for part in self.velocity)
        ramp = self.ramp[motion]
        rising, falling = np.maximum(1.0 - place / ramp, 0.0), np.maximum(1.0 - (1.0 - place) / ramp, 0.0)
        way, passed, path = self.since[..., motion] + place * self.gone[..., motion]
        return Context(
            directions=columns_of(self.direction, motion),
            velocity=midst + rising * (start - midst) + falling * (end - midst),
            since_reversal=way,
            time_since=passed,
            path_since=path,
            time=np.full(motion.size, time),
            temperature=np.full(motion.size, temperature),
        )

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> "Course":
        """The course of pieces, from share `low` to `high` of the motions given.

        Velocity is linear within a piece: cutting goes by what bends.
        """
        at_low, at_half, at_high = (self.context(motion, place, 0.0, 0.0) for place in (low, 0.5 * (low + high), high))
        return Course(
            direction=at_low.directions,
            since=self.since[..., motion] + low * self.gone[..., motion],
            gone=(high - low) * self.gone[..., motion],
            velocity=(at_low.velocity, at_half.velocity, at_high.velocity),
            ramp=np.full(motion.size, 0.5),
        )

    def with_halts(self, motion: NDArray[np.int64], halt: NDArray[np.bool_]) -> "Course":
        """The course of the motions given, some of which go nowhere: in the state in which they would start."""
        start, midst, end = (columns_of(part, motion) for part in self.velocity)
        return Course(
            direction=columns_of(self.direction, motion),
            since=self.since[..., motion],
            gone=np.where(halt, 0.0, self.gone[..., motion]),
            velocity=(start, np.where(halt, start, midst), np.where(halt, start, end)),
            ramp=self.ramp[motion],
        )


@dataclass(frozen=True, slots=True, eq=False)
class Standing:
    """The axes between two motions, each (n_axes,), since (3, n_axes).

    extreme: farthest position reached in the present direction, corrections included, NaN where the axis has no known
    position; direction, since as in Course; velocity with which the next motion begins.
    """

    extreme: FloatArray
    direction: FloatArray
    since: FloatArray
    velocity: FloatArray

    @classmethod
    def at(cls, position: FloatArray) -> "Standing":
        """Axes that stand and have not moved yet."""
        still = np.zeros_like(position)
        return cls(position.copy(), still, np.full((3, position.size), FARTHEST), still)


def turnings(wanted: FloatArray, standing: Standing, band: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Direction of each axis during each motion, (n_axes, n), and the extremes after the last, (n_axes,).

    wanted: (n_axes, n), ends of the motions with what corrections displace them by: an axis that stands in the program
    is moved by those; NaN where the axis may stand anywhere. band: (n_axes, n), by how much it must come back from its
    extreme for a reversal.
    """
    direction = np.empty_like(wanted)
    extreme = standing.extreme.copy()
    for row, (places, bands) in enumerate(zip(wanted.tolist(), band.tolist(), strict=True)):
        way, far = float(standing.direction[row]), float(extreme[row])
        ways = []
        for place, least in zip(places, bands, strict=True):
            ahead = place - far
            if math.isnan(ahead):  # it stands nowhere yet, or may stand anywhere now
                way, far = 0.0, place
            elif way == 0.0:
                if abs(ahead) > least:
                    way, far = (1.0 if ahead > 0.0 else -1.0), place
            elif ahead * way >= 0.0:
                far = place
            elif -ahead * way > least:
                way, far = -way, place
            ways.append(way)
        direction[row] = ways
        extreme[row] = far
    return direction, extreme


def since_reversal(
    path: Path, direction: FloatArray, standing: Standing, duration: FloatArray, linear: Sequence[int]
) -> tuple[FloatArray, FloatArray]:
    """Distance, time and way along the path since the last reversal of each axis at the start of each motion, and what
    the motion adds to them; (3, n_axes, n).

    duration: (n,), s, 0 where a motion takes a time that is not known: then nothing of a spike is left after it;
    linear: rows of the linear axes.
    """
    span = np.nan_to_num(np.abs(path.points - path.origins))
    duration = np.where((duration == 0.0) & span.any(axis=0), LONG, duration)
    along = np.sqrt((span[list(linear)] ** 2).sum(axis=0))
    gone = np.stack([span, *(np.broadcast_to(each, span.shape) for each in (duration, along))])
    before = np.concatenate([standing.direction[:, None], direction[:, :-1]], axis=1)
    turned = direction * before < 0.0
    way = np.cumsum(gone, axis=2) - gone
    last = np.maximum.accumulate(np.where(turned, np.arange(path.size), -1), axis=1)
    at_last = np.take_along_axis(way, np.maximum(last, 0)[np.newaxis], axis=2)
    return np.where(last >= 0, way - at_last, standing.since[..., None] + way), gone


Rows = NDArray[np.int64] | NDArray[np.bool_] | slice


class ContextModel(ErrorModel, Protocol):
    """A machine whose errors depend on more than positions."""

    def in_context(self, context: Context) -> ErrorModel:
        """The machine at positions that are reached in the context given, one by one."""


@dataclass(frozen=True, slots=True)
class Placed:
    """A machine at n places, each with its own context; positions that are asked for belong to those places."""

    model: ContextModel
    context: Context
    actual: ErrorModel

    @classmethod
    def of_context(cls, model: ContextModel, context: Context) -> "Placed":
        """At the places of a context."""
        return cls(model, context, model.in_context(context))

    def of(self, rows: Rows) -> "Placed":
        """At some of the places."""
        return Placed.of_context(self.model, self.context.of(rows))

    @property
    def axes(self) -> tuple[str, ...]:
        """As ErrorModel has it, and so the rest."""
        return self.model.axes

    @property
    def travel(self) -> Mapping[str, tuple[float, float]]:
        """Lowest and highest position of each axis."""
        return self.model.travel

    def ideal(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Tool point of the error-free machine."""
        return self.model.ideal(positions, point)

    def deviation(self, positions: FloatArray, point: FloatArray) -> FloatArray:
        """Actual minus ideal tool point, in the context."""
        return self.actual.deviation(positions, point)

    def correction(self, positions: FloatArray, deviation: FloatArray) -> FloatArray:
        """Increments of the axes that move the ideal tool point."""
        return self.model.correction(positions, deviation)

    def orientation_ideal(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """A direction on the error-free machine."""
        return self.model.orientation_ideal(positions, direction)

    def orientation_deviation(self, positions: FloatArray, direction: FloatArray) -> FloatArray:
        """Actual minus ideal direction, in the context."""
        return self.actual.orientation_deviation(positions, direction)


def of_points(model: ErrorModel, rows: Rows) -> ErrorModel:
    """The machine for some of the points that it was to be asked about."""
    return model.of(rows) if isinstance(model, Placed) else model


class Placing(Protocol):
    """Gives the machine at places of the motions of a path."""

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:
        """At shares `place` (n,) of the motions with the indices `motion` (n,)."""

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> "Placing":
        """The same for a path of pieces, from share `low` to `high` of the motions given."""


@dataclass(frozen=True, slots=True)
class Everywhere:
    """A machine whose errors depend on positions alone."""

    model: ErrorModel

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:  # noqa: ARG002
        """The machine."""
        return self.model

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> Placing:  # noqa: ARG002
        """The machine."""
        return self


@dataclass(frozen=True, slots=True)
class OnCourse:
    """A machine along the course of its axes; time s, temperature degC."""

    model: ContextModel
    course: Course
    time: float
    temperature: float

    def at(self, motion: NDArray[np.int64], place: FloatArray) -> ErrorModel:
        """The machine in the contexts of those places."""
        return Placed.of_context(self.model, self.course.context(motion, place, self.time, self.temperature))

    def cut(self, motion: NDArray[np.int64], low: FloatArray, high: FloatArray) -> Placing:
        """Along the course of the pieces."""
        return OnCourse(self.model, self.course.cut(motion, low, high), self.time, self.temperature)


SMOOTH = np.cos(np.radians(10.0))  # of the largest turn between two moves that are run through without braking
RAMP = 0.05  # s


def cruising(path: Path, feed: FloatArray, axes: tuple[str, ...]) -> tuple[FloatArray, FloatArray]:
    """Velocity of the axes in the midst of each motion, (n_axes, n), mm/s or deg/s, and the motions' duration, (n,), s.

    feed: (n,), mm/min along the linear axes, or deg/min where they stand; NaN: not known. Velocity is 0 where it is not
    known, in rapids, and where nothing moves.
    """
    span = path.points - path.origins
    linear = list(linear_rows(axes))
    way = np.sqrt((span[linear] ** 2).sum(axis=0))
    way = np.where(way > 0.0, way, np.sqrt((span**2).sum(axis=0)))
    known = ~path.rapid & (way > 0.0) & (feed > 0.0)
    duration = np.where(known, way / np.where(known, feed / 60.0, 1.0), 0.0)
    return np.where(known, span / np.where(known, duration, 1.0), 0.0), duration


def at_vertices(velocity: FloatArray, owner: NDArray[np.int64], follows: NDArray[np.bool_]) -> FloatArray:
    """Velocity at the end of each motion but the last, (n_axes, n - 1): the mean of both sides where they run smoothly
    into each other, else 0.

    owner: (n,), move of each motion; follows: (n_moves,), whether the next may follow a move without a stop.
    """
    before, after = velocity[:, :-1], velocity[:, 1:]
    length = np.sqrt((before**2).sum(axis=0) * (after**2).sum(axis=0))
    with np.errstate(invalid="ignore", divide="ignore"):
        cosine = (before * after).sum(axis=0) / length
    same = owner[:-1] == owner[1:]
    smooth = (length > 0.0) & (same | (follows[owner[:-1]] & (cosine >= SMOOTH)))
    return np.where(smooth, 0.5 * (before + after), 0.0)


def ramps(duration: FloatArray) -> FloatArray:
    """Share of each motion over which the velocity at its ends passes into that of its midst, (n,)."""
    with np.errstate(divide="ignore"):
        return np.asarray(np.where(duration > 2.0 * RAMP, RAMP / duration, 0.5))
