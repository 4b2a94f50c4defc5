"""The context of readings: how each axis came to where it was read, how fast it moved, when and how warm it was.

What has passed since an axis turned back last is its own way, time, and the way along the path. What effects need to
know of readings or points is told as a fault for each column that lacks it.
"""

from collections.abc import Iterator, Sequence
from typing import Protocol

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Kind
from trueaxis.effects.placement import concerns, used_variables
from trueaxis.io.faults import Fault
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.reversals import (
    SECONDS,
    distance_since,
    duration_by_feed,
    path_since,
    reversals_of_standing,
    reversals_on_the_way,
    time_since,
)
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.model import MachineModel

IntArray = npt.NDArray[np.int64]
BoolArray = npt.NDArray[np.bool_]

_COLUMNS = {  # variables of an axis and what tells them
    "t": "time_s",
    "T": "temperature_c",
    "v": "feed (or time_s)",
    "d_time": "time_s (or, by ball bar, feed)",
}


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

    Directions are those of the rows. What has passed since the last reversal is that of the commanded positions. Laser
    and probe read standing axes, which come to the first target of a run from a reversal beyond it (ISO 230-1, approach
    from one side), and to a later one where the way from the reading before is against the direction: ways count from
    that target; since when the axis stands there, nobody knows, and the time since that reversal is infinite, as it is
    where no times are given: what passes within seconds is over when a standing axis is read. A ball bar is read on the
    way: an axis turns where its velocity along the path passes through zero, between two readings or before the first;
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
    since, times_since, ways_since = (np.full(shape, np.inf) for _ in range(3))
    home_time, home_temperature = np.full(count, np.nan), np.full(count, np.nan)
    order = np.lexsort((rows.seq, rows.run))
    starts = np.flatnonzero(np.diff(rows.run[order], prepend=-1))
    for mine in np.split(order, starts[1:]):
        if mine.size == 0:
            continue
        path, ways = rows.positions[:, mine], directions[:, mine]
        standing = runs[rows.run[mine[0]]].instrument != "ballbar"
        turned = reversals_of_standing(ways, path) if standing else reversals_on_the_way(rows.axes, ways, path)
        since[:, mine] = distance_since(turned, path)
        ways_since[:, mine] = path_since(turned, rows.axes, path)
        fed = np.full(mine.size, np.nan) if standing else feed[mine]  # how long an axis stood no feed tells
        passed = time_since(turned, time[mine], duration_by_feed(rows.axes, path, fed))
        times_since[:, mine] = np.where(np.isnan(passed), np.inf, passed) if standing else passed
        home_time[mine], home_temperature[mine] = time[mine[0]], temperature[mine[0]]
        if not standing:
            velocity[:, mine] = path_velocity(rows.axes, path, feed[mine], time[mine])
    home = Context.at_rest(shape[0], count, home_time, home_temperature)
    return Context(
        directions=directions,
        velocity=velocity,
        since_reversal=since,
        time_since=times_since,
        path_since=ways_since,
        time=time,
        temperature=temperature,
        home=home,
    )


def path_velocity(axes: Sequence[str], path: FloatArray, feed: FloatArray, time: FloatArray) -> FloatArray:
    """(n_axes, n): velocity of each axis along a path of commanded positions, mm/s or deg/s.

    path: (n_axes, n), mm or deg, in the order of reading; feed: (n,), mm/min, of the linear axes together; time: (n,),
    s, asked where the feed is NaN or a rotary axis turns: a control may mean the feed of the tool over the
    workpiece there. 0 where the path stands or turns back, NaN where neither is known.
    """
    linear = np.array([axis in "XYZ" for axis in axes])
    ways = np.linalg.norm(np.diff(path[linear], axis=1), axis=0)
    steps, passed = _differences(path, ways), _differences(time[np.newaxis], ways)[0]
    length = np.linalg.norm(steps[linear], axis=0)
    standing = ~steps.any(axis=0)
    fed = (feed > 0.0) & ~(steps[~linear].any(axis=0) & (passed > 0.0))
    duration = np.divide(length * SECONDS, feed, out=passed, where=fed)
    found: FloatArray = np.divide(steps, duration, out=np.full_like(steps, np.nan), where=duration > 0.0)
    found[:, standing & fed] = 0.0
    return found


def _differences(path: FloatArray, ways: FloatArray) -> FloatArray:
    """Differences over two steps, (k, n), of what comes (k, n), exact for a parabola: central ones, and from three
    points at the ends. ways: (n - 1,), mm, of each step; where the linear axes stand, steps count as even.
    """
    count = path.shape[1]
    if count < 3:
        return np.repeat(2.0 * (path[:, -1:] - path[:, :1]), count, axis=1)
    each = np.diff(path, axis=1)
    uneven = (ways[:-1] > 0.0) & (ways[1:] > 0.0)
    ratio = np.divide(ways[1:], ways[:-1], out=np.ones(count - 2), where=uneven)
    found = np.empty_like(path)
    found[:, 1:-1] = each[:, 1:] / ratio + each[:, :-1] * ratio
    found[:, 0] = (2.0 + ratio[0]) * each[:, 0] - each[:, 1] / ratio[0]
    found[:, -1] = (2.0 + 1.0 / ratio[-1]) * each[:, -1] - each[:, -2] * ratio[-1]
    return found


def faults_of_readings(
    machine: MachineModel, runs: Sequence[Run], readings: Readings, context: Context, asked: BoolArray, file: str
) -> list[Fault]:
    """What the readings lack for the machine's effects in the rows that are asked for, a fault for each column.

    context: of all rows; asked: (n,); file: of the readings, which the faults are of.
    """
    home = context.home or context
    zeroed = np.array([run.instrument != "ballbar" for run in runs])[readings.run]
    unknown = {
        "t": np.isnan(context.time) | (zeroed & np.isnan(home.time)),
        "T": np.isnan(context.temperature) | (zeroed & np.isnan(home.temperature)),
        "v": np.isnan(context.velocity).any(axis=0),
        "d_time": np.isnan(context.time_since).any(axis=0),
    }
    found = []
    for variable, effects in _needed(machine):
        wrong = np.zeros_like(asked)
        for values, kind in effects:
            concerned = np.array([concerns(kind, values.effect, run) for run in runs])
            wrong |= unknown[variable] & asked & concerned[readings.run]
        if wrong.any():
            rows = np.flatnonzero(wrong)
            first = rows[np.lexsort((readings.seq[rows], readings.run[rows]))[0]]
            problem = f'is not known in row {readings.seq[first]} of run "{readings.run_ids[readings.run[first]]}"'
            if zeroed[first] and variable in ("t", "T"):
                problem += " or where the run began"
            found.append(_fault(file, variable, problem, effects))
    return found


def faults_of_points(machine: MachineModel, context: Context, file: str) -> list[Fault]:
    """What points lack for the machine's effects on component errors, a fault for each column."""
    unknown = {"t": np.isnan(context.time), "T": np.isnan(context.temperature)}
    found = []
    for variable, effects in _needed(machine):
        mine = [(values, kind) for values, kind in effects if kind.place == "component"]
        if mine and variable in unknown and unknown[variable].any():
            found.append(_fault(file, variable, f"is not known at point {int(np.argmax(unknown[variable])) + 1}", mine))
    return found


def _needed(machine: MachineModel) -> Iterator[tuple[str, list[tuple[EffectValues, Kind]]]]:
    """What columns tell and the effects whose terms depend on it, of the own or the other axis."""
    terms = [(values, machine.kinds[values.effect.kind]) for values in machine.effect_values]
    for variable in _COLUMNS:
        mine = [(values, kind) for values, kind in terms if {variable, f"{variable}_b"} & set(used_variables(kind))]
        if mine:
            yield variable, mine


def _fault(file: str, variable: str, problem: str, effects: Sequence[tuple[EffectValues, Kind]]) -> Fault:
    told = ", ".join(values.effect.label for values, _ in effects)
    return Fault(file, f"column {_COLUMNS[variable]}", problem, f"a value: it is needed for {told}")
