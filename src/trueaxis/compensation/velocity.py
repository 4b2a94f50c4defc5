"""Velocities of the axes along a path, from the programmed feed and the direction of the path.

How a control brakes at corners and stops is not in the program. There the velocity is taken as 0 and that of the path
as reached `RAMP` seconds of way further on: a lead for the lag of an axis must not carry the tool past a point at which
it stops.
"""

import numpy as np
from numpy.typing import NDArray

from trueaxis.compensation.machine import FloatArray, linear_rows
from trueaxis.compensation.path import Path

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
