"""Where the parameters that a term is not linear in are searched: one set of grids, for a fit and for a diagnosis."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from trueaxis.effects.kind import Effect, Kind, Parameter
from trueaxis.effects.placement import FARTHEST
from trueaxis.estimation.outliers import NEIGHBOURS
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.context import Context

PITCH_MM = 6.0  # shortest pitch on linear axes so long that it is the shorter: screws are no coarser for being long
SHORTEST_MM = 2.0  # pitch of the finest screws: an alias of any longer one may be taken for another
FEWEST_PERIODS = 2.0
# time constants, from the time by which a twentieth of the readings were taken to twice the time covered: of a day, or
# of several with pauses, in the first hour of which a machine warms up; so many times apart
EARLY, APART = 0.05, 2.1
# what a spike at a reversal dies away over: from a two-thousandth to a twentieth of what passes until the next
WAYS = 6
BETWEEN = 9  # points of the finer grid between the neighbours of a point
ZOOMS = 2  # a peak of a period is then known to a thirtieth of its width, which costs it a thousandth of its height

Point = Mapping[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Fineness:
    """How many points a grid has.

    periods: per range of the axis at the shortest pitch (`pitch`, mm, where that is shorter); per_period: steps of
    frequency, per 1/range; moments: of a jump, at most about so many; lasting: readings, at least, before and after it.
    """

    periods: int
    per_period: int
    moments: int
    lasting: int
    pitch: float = PITCH_MM


# Of an effect that the spec names: it is there, and the next frequency is still within a tenth of the power.
OF_FIT = Fineness(periods=150, per_period=3, moments=400, lasting=2)
# Of every cause that there may be: what lies between is looked at where the evidence is best. One or two readings at
# either end of a run are outliers, three are none.
OF_DIAGNOSIS = Fineness(periods=120, per_period=2, moments=40, lasting=NEIGHBOURS + 1)
# Of periods that one that was found may be an alias of.
OF_RIVALS = replace(OF_DIAGNOSIS, per_period=4, pitch=SHORTEST_MM)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Covered:
    """What the readings cover that may hold an effect.

    travel: range of the axis whose component error it acts on, mm or deg; linear: whether it is X, Y or Z; time: (n,),
    s, NaN where unknown; since: longest time (s) and way along the path (mm) since a reversal of the axis. 0 and empty
    where there is none.
    """

    time: FloatArray
    travel: float = 0.0
    linear: bool = True
    time_since: float = 0.0
    path_since: float = 0.0


def covered_by(effect: Effect, axes: tuple[str, ...], positions: FloatArray, context: Context) -> Covered:
    """positions: (n_axes, n), mm or deg, of all readings that may hold the effect; context: theirs.

    A spike is searched where axes are read on the way: where they stand, it has died away or is taken for something
    else.
    """
    axis = effect.own_axis
    if axis not in axes or not context.count:
        return Covered(time=context.time)
    row = axes.index(axis)
    moving = context.velocity[row] != 0.0
    time_since = context.time_since[row, moving if moving.any() else slice(None)]
    travel = float(np.ptp(positions[row]))
    return Covered(
        time=context.time,
        travel=travel,
        linear=axis in LINEAR,
        time_since=_longest(time_since),
        path_since=_longest(context.path_since[row]),
    )


def grid_of(kind: Kind, covered: Covered, fineness: Fineness) -> tuple[Point, ...]:
    """Values of the parameters with the role `grid`; one empty point where there is none."""
    searched = [one for one in kind.parameters if one.role == "grid"]
    each = [_values(one, covered, fineness) for one in searched]
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


def _longest(values: FloatArray) -> float:
    return float(values[values < FARTHEST].max(initial=0.0))  # none before the first reversal, none that is unknown


def _values(parameter: Parameter, covered: Covered, fineness: Fineness) -> list[float]:
    known = covered.time[np.isfinite(covered.time)]
    passed = {"reversal": covered.travel, "reversal_time": covered.time_since, "reversal_path": covered.path_since}
    if parameter.grid in passed:
        return _geometric(passed[parameter.grid] / 2000.0, passed[parameter.grid] / 20.0, WAYS)
    if parameter.grid == "moment":
        return moments(known, fineness) or [float(np.mean(known)) if known.size else 0.0]
    if parameter.grid == "time":
        since = known - known.min() if known.size else np.zeros(1)
        longest, early = 2.0 * float(since.max()), float(np.quantile(since, EARLY))
        shortest = early or longest / 40.0  # of a single moment, or few
        count = 1 + int(np.ceil(np.log(longest / shortest) / np.log(APART))) if longest > 0.0 else 1
        return _geometric(shortest, longest, count)
    return list(parameter.values) if parameter.grid == "given" else _pitches(covered, fineness)


def _geometric(low: float, high: float, count: int) -> list[float]:
    return [float(value) for value in np.geomspace(low, high, count)] if low > 0.0 else [1.0]


def _pitches(covered: Covered, fineness: Fineness) -> list[float]:
    span = covered.travel
    if span == 0.0:
        return [1.0]
    most = max(fineness.periods, round(span / fineness.pitch)) if covered.linear else fineness.periods
    count = int((most - FEWEST_PERIODS) * fineness.per_period) + 1
    return [span / float(periods) for periods in np.linspace(FEWEST_PERIODS, most, count)]


def moments(time: FloatArray, fineness: Fineness) -> list[float]:
    """Between neighbouring moments of times (n,), s, that are known; a part of them where there are many."""
    at = np.unique(time)
    between = 0.5 * (at[1:] + at[:-1])[fineness.lasting - 1 : -fineness.lasting + 1]
    every = max(1, between.size // fineness.moments)
    return [float(moment) for moment in between[::every]]
