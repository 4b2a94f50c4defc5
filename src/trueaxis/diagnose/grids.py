"""Where the parameters that a term is not linear in are searched."""

from collections.abc import Mapping
from itertools import product

import numpy as np

from trueaxis.diagnose.result import FloatArray
from trueaxis.diagnose.rows import Rows
from trueaxis.effects.kind import Effect, Kind, Parameter
from trueaxis.spec.machine import LINEAR

PERIODS = 120  # per range of the axis: the shortest pitch searched ...
PITCH_MM = 6.0  # ... or this one, on linear axes so long that it is the shorter: screws are no coarser for being long
FEWEST_PERIODS = 2.0
STEPS_PER_PERIOD = 2  # of frequency, per 1/range; what lies between is looked at where the evidence is best
TIMES = 6  # time constants, from a twentieth of the time covered to twice it
MOMENTS = 40  # of a run, at most about so many
LASTING = 5  # readings, at least, before and after a jump
WAYS = 6  # decay lengths, from a two-thousandth of the range of the axis to a twentieth


def grid_of(kind: Kind, effect: Effect, rows: Rows) -> tuple[Mapping[str, float], ...]:
    """The points of the grid: values of the parameters with the role `grid`; one empty point where there is none."""
    searched = [one for one in kind.parameters if one.role == "grid"]
    each = [_values(one, effect, rows) for one in searched]
    return tuple(dict(zip((one.name for one in searched), point, strict=True)) for point in product(*each))


def _values(parameter: Parameter, effect: Effect, rows: Rows) -> list[float]:
    if parameter.grid == "given":
        return list(parameter.values)
    if parameter.grid == "moment":
        return _moments(effect, rows)
    if parameter.grid == "time":
        span = 0.0 if rows.time is None else float(np.nanmax(rows.time) - np.nanmin(rows.time))
        return _geometric(span / 20.0, 2.0 * span, TIMES) if span > 0.0 else [1.0]
    assert effect.component is not None
    at = rows.positions[rows.axes.index(effect.component[2])]
    span = float(np.ptp(at))
    if span == 0.0:
        return [1.0]
    if parameter.grid == "reversal":
        return _geometric(span / 2000.0, span / 20.0, WAYS)
    most = max(PERIODS, round(span / PITCH_MM)) if effect.component[2] in LINEAR else PERIODS
    count = int((most - FEWEST_PERIODS) * STEPS_PER_PERIOD) + 1
    return [float(span / periods) for periods in np.linspace(FEWEST_PERIODS, most, count)]


def _geometric(low: float, high: float, count: int) -> list[float]:
    return [float(value) for value in np.geomspace(low, high, count)]


def _moments(effect: Effect, rows: Rows) -> list[float]:
    """Between neighbouring readings of the run; what lasts for a few readings at either end is no jump."""
    index = next(place for place, run in enumerate(rows.runs) if run.id == effect.runs[0])
    if rows.time is None:
        return [np.nan]
    times: FloatArray = rows.time[rows.of_run(index)]
    between = 0.5 * (times[1:] + times[:-1])[LASTING - 1 : -LASTING + 1]
    every = max(1, between.size // MOMENTS)
    return [float(moment) for moment in between[::every]] if between.size else [np.nan]
