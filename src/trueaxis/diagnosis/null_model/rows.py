"""The readings that a diagnosis works on: sorted by run and order, each run one stretch of rows."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from trueaxis.diagnosis.null_model.temperature import assumed
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.estimation.runs import noise_groups
from trueaxis.estimation.set_up_anew import set_ups, taken_runs
from trueaxis.measurement.context import context_of
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reversals import beside_reversals
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context

REACH = 2e-3  # mm or deg, that an axis goes beyond a reversal before all of its play is taken up: a few micrometres
DECIMALS = 4  # mm or deg: positions that agree to a tenth of a micrometre are the same target


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Rows:
    """Readings taken, (n,) each unless said otherwise; rows of one run are neighbours, in the order of reading.

    row: place in the file; run: index into runs; positions, directions: (n_axes, n), mm or deg and -1, 0, +1; reading:
    mm; time (s), temperature (degC), feed (mm/min): None where the file has none. setup: the same number for runs that
    differ in their zero alone; mounted: for those of them whose instrument stayed as it was set up. target: rows with
    the same number were read at the same place, approached the same way at the same feed, with the same set-up;
    passing: number of the earlier rows of the same run with the same target. context: that of each row, from all rows
    of its run, with a temperature assumed where only other runs have one.
    """

    runs: tuple[Run, ...]
    axes: tuple[str, ...]
    row: IntArray
    run: IntArray
    seq: IntArray
    positions: FloatArray
    directions: FloatArray
    reading: FloatArray
    time: FloatArray | None
    temperature: FloatArray | None
    feed: FloatArray | None
    setup: IntArray
    mounted: IntArray
    target: IntArray
    passing: IntArray
    context: Context

    @property
    def size(self) -> int:
        """Number of readings."""
        return self.reading.size

    @property
    def assumed(self) -> BoolArray:
        """(n,): readings whose temperature is assumed."""
        if self.temperature is None:
            return np.zeros(self.size, dtype=bool)
        return np.asarray(np.isnan(self.temperature) & np.isfinite(self.context.temperature))

    def of_run(self, index: int) -> slice:
        """The rows of a run."""
        first, last = np.searchsorted(self.run, [index, index + 1])
        return slice(int(first), int(last))

    @property
    def present(self) -> list[int]:
        """Indices of the runs that have readings."""
        return [int(index) for index in np.unique(self.run)]

    def only(self, keep: BoolArray) -> "Rows":
        """Those of some rows, (n,)."""
        cut: dict[str, Any] = {}
        for one in fields(self):
            value = getattr(self, one.name)
            if isinstance(value, np.ndarray):
                cut[one.name] = value[..., keep]
            else:
                cut[one.name] = value.of(keep) if isinstance(value, Context) else value
        return Rows(**cut)


def rows_of(data: MeasuredData) -> Rows:
    """The readings taken; plan rows, and rows in which a moving axis has come from nowhere, are left out.

    So are samples of a ball bar that are so near to a reversal of an axis that their direction is anybody's choice.
    """
    readings, runs = data.readings, data.setup.runs
    taken = np.flatnonzero(~readings.planned)
    order = taken[np.lexsort((readings.seq[taken], readings.run[taken]))]
    run, positions = readings.run[order], readings.positions[:, order]
    directions = readings.directions[:, order].astype(np.float64)
    feed = None if readings.feed is None else readings.feed[order]
    keep = np.ones(order.size, dtype=bool)
    for index in np.unique(run):
        first, last = (int(end) for end in np.searchsorted(run, [index, index + 1]))
        mine = slice(first, last)
        moving = np.ptp(positions[:, mine], axis=1) > 10.0**-DECIMALS
        # an axis whose direction is nowhere known is no reason to drop a run: nothing of it turns with a direction
        told = moving & (directions[:, mine] != 0.0).any(axis=1)
        keep[mine] &= (directions[told, mine] != 0.0).all(axis=0)
        if runs[index].instrument == "ballbar":
            axes = [axis for axis, moves in zip(readings.axes, moving, strict=True) if moves]
            keep[mine] &= ~beside_reversals(axes, directions[moving, mine], positions[moving, mine], REACH)
    time = None if readings.time is None else readings.time[order]
    setup = _setups(runs, run, positions)[run]
    everything = Rows(
        runs=tuple(runs),
        axes=readings.axes,
        row=order,
        run=run,
        seq=readings.seq[order],
        positions=positions,
        directions=directions,
        reading=readings.reading[order],
        time=time,
        temperature=None if readings.temperature is None else readings.temperature[order],
        feed=feed,
        setup=setup,
        mounted=_mounted(runs, run, setup, time),
        target=_targets(setup, positions, directions, feed),
        passing=np.zeros(order.size, dtype=np.int64),
        context=context_of(runs, assumed(readings)).of(order),
    ).only(keep)
    return _with_passes(everything)


def plane_of(rows: Rows, mine: BoolArray) -> str:
    """The axes that move in some rows."""
    span = np.ptp(rows.positions[:, mine], axis=1)
    return "".join(name for name, way in zip(rows.axes, span, strict=True) if way > 10.0**-DECIMALS)


def _setups(runs: Sequence[Run], run: IntArray, positions: FloatArray) -> IntArray:
    """(n_runs,): the same number for runs that differ in their zero alone; for ball bars also the plane counts.

    What two devices read is no repeat: each has its own noise and scale.
    """
    known: dict[object, int] = {}
    said = []
    for index, (one, group) in enumerate(zip(runs, noise_groups(runs), strict=True)):
        mine = positions[:, run == index]
        moving = mine.size > 0 and one.instrument == "ballbar"
        plane = tuple(np.flatnonzero(np.ptp(mine, axis=1) > 10.0**-DECIMALS).tolist()) if moving else ()
        said.append((group, one.target, one.reference, one.frame, one.direction, one.length, plane))
    return np.array([known.setdefault(one, len(known)) for one in said], dtype=np.int64)


def _mounted(runs: Sequence[Run], run: IntArray, setup: IntArray, time: FloatArray | None) -> IntArray:
    """(n,): numbers of sessions, set-ups in them and what is set up, see `Rows`; time: (n,), s."""
    anew, known = set_ups(runs, taken_runs(run, time)), dict[object, int]()
    of_rows = (
        (runs[index].session, anew.get(index, 0), like)
        for index, like in zip(run.tolist(), setup.tolist(), strict=True)
    )
    return np.array([known.setdefault(one, len(known)) for one in of_rows], dtype=np.int64)


def _targets(setup: IntArray, positions: FloatArray, directions: FloatArray, feed: FloatArray | None) -> IntArray:
    moving = directions * (np.ptp(positions, axis=1, keepdims=True) > 0.0)
    parts = [setup[np.newaxis], np.round(positions, DECIMALS) + 0.0, moving]
    if feed is not None:
        parts.append(np.nan_to_num(feed, nan=-1.0)[np.newaxis])
    _, found = np.unique(np.vstack(parts), axis=1, return_inverse=True)
    return found.reshape(-1).astype(np.int64)


def _with_passes(rows: Rows) -> Rows:
    passing = np.zeros(rows.size, dtype=np.int64)
    pair = rows.run * (int(rows.target.max(initial=0)) + 1) + rows.target
    order = np.argsort(pair, kind="stable")
    first = np.flatnonzero(np.diff(pair[order], prepend=-1))
    count = np.diff(np.append(first, pair.size))
    passing[order] = np.arange(pair.size) - np.repeat(first, count)
    found = {one.name: getattr(rows, one.name) for one in fields(rows)}
    return Rows(**{**found, "passing": passing})


def runs_among(starts: IntArray, rows: IntArray) -> Iterator[tuple[int, slice]]:
    """Places of the runs that begin at starts, (n_runs + 1,), and their rows among some, ascending, of whole runs."""
    begins = np.searchsorted(rows, starts)
    for place in np.flatnonzero(np.diff(begins)).tolist():
        yield place, slice(int(begins[place]), int(begins[place + 1]))


def as_slice(rows: IntArray) -> IntArray | slice:
    """Rows, ascending, as a slice where they follow one another: what they choose is then no copy."""
    first, last = (int(rows[0]), int(rows[-1]) + 1) if rows.size else (0, 0)
    return slice(first, last) if last - first == rows.size else rows
