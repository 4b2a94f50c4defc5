"""Where the parameters that a term is not linear in are searched."""

from collections.abc import Mapping
from itertools import product

import numpy as np

from trueaxis.effects.kind import Kind, Parameter
from trueaxis.measure.machine import FloatArray

PERIODS = 150  # per range of the axis: the shortest pitch searched
FEWEST_PERIODS = 2.0
STEPS_PER_PERIOD = 3  # of frequency, per 1/range: the next frequency is still within a tenth of the power
TIMES = 6  # time constants, from a twentieth of the time covered to twice it
WAYS = 6  # decay lengths, from a two-thousandth of the range of the axis to a twentieth
MOST_MOMENTS = 400
BETWEEN = 9  # points of the finer grid between the neighbours of a point

Point = Mapping[str, float]


def grid_of(kind: Kind, positions: FloatArray | None, time: FloatArray) -> tuple[Point, ...]:
    """Values of the parameters with the role `grid`; one empty point where there is none.

    positions: (n,), of the axis whose component error the effect acts on, mm or deg; None for an effect on readings;
    time: (n,), s, of the readings that it may be in, NaN where unknown.
    """
    searched = [one for one in kind.parameters if one.role == "grid"]
    each = [_values(one, positions, time) for one in searched]
    return tuple(dict(zip((one.name for one in searched), point, strict=True)) for point in product(*each))


def finer(points: tuple[Point, ...], place: int) -> tuple[Point, ...]:
    """A grid of one parameter between the neighbours of a point; in its inverse, in which frequencies are even.

    Points of several parameters stay as they are.
    """
    if len(points) == 1 or len(points[0]) != 1:
        return points
    (name,) = points[0]
    ends = [points[max(place - 1, 0)][name], points[min(place + 1, len(points) - 1)][name]]
    if min(ends) > 0.0:
        values = 1.0 / np.linspace(1.0 / ends[0], 1.0 / ends[1], BETWEEN)
    else:
        values = np.linspace(ends[0], ends[1], BETWEEN)
    return tuple({name: float(value)} for value in values)


def _values(parameter: Parameter, positions: FloatArray | None, time: FloatArray) -> list[float]:
    if parameter.grid == "given":
        return list(parameter.values)
    known = time[np.isfinite(time)]
    if parameter.grid == "moment":
        return _moments(known)
    if parameter.grid == "time":
        span = float(np.ptp(known)) if known.size else 0.0
        return _geometric(span / 20.0, 2.0 * span, TIMES) if span > 0.0 else [1.0]
    span = float(np.ptp(positions)) if positions is not None and positions.size else 0.0
    if span == 0.0:
        return [1.0]
    if parameter.grid == "reversal":
        return _geometric(span / 2000.0, span / 20.0, WAYS)
    count = int((PERIODS - FEWEST_PERIODS) * STEPS_PER_PERIOD) + 1
    return [span / float(periods) for periods in np.linspace(FEWEST_PERIODS, PERIODS, count)]


def _geometric(low: float, high: float, count: int) -> list[float]:
    return [float(value) for value in np.geomspace(low, high, count)]


def _moments(time: FloatArray) -> list[float]:
    """Between neighbouring moments, two readings at least before and after; a part of them where there are many."""
    at = np.unique(time)
    between = 0.5 * (at[1:] + at[:-1])[1:-1]
    if between.size > MOST_MOMENTS:
        between = between[np.linspace(0, between.size - 1, MOST_MOMENTS).astype(np.int64)]
    return [float(moment) for moment in between] or [float(at.mean()) if at.size else 0.0]
