"""The readings that identification works on, and which of them repeat a place: the pure error of an instrument."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np
import polars as pl

from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.context import context_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import DirectionArray, IntArray, Readings
from trueaxis.measurement.setup import Device, Run, Vector
from trueaxis.model.context import Context
from trueaxis.view import Frame

MOSTLY, FEWEST_COPIES = 0.5, 3  # a coarse display makes some repeats equal, hardly ever most of them
DECIMALS = 6  # of mm and deg, within which commanded positions are the same


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Observations:
    """Readings taken (plan rows left out), one per row.

    source: where they come from, named in faults; run: (n,), index into runs; positions: (n_axes, n), commanded,
    mm or deg; reading: (n,), mm; seq: (n,), number of the row in its run; directions: (n_axes, n), by which way each
    axis came there (-1, 0, +1); context: what effects depend on besides positions; all None where nothing is known of
    them.
    """

    source: str
    runs: tuple[Run, ...]
    run: IntArray
    positions: FloatArray
    reading: FloatArray
    seq: IntArray | None = None
    directions: DirectionArray | None = None
    context: Context | None = None

    def of(self, keep: "IntArray") -> "Observations":
        """Those of some rows."""
        return Observations(
            source=self.source,
            runs=self.runs,
            run=self.run[keep],
            positions=self.positions[:, keep],
            reading=self.reading[keep],
            seq=None if self.seq is None else self.seq[keep],
            directions=None if self.directions is None else self.directions[:, keep],
            context=None if self.context is None else self.context.of(keep),
        )

    def exchanged(self, one: int, other: int) -> "Observations":
        """As if the readings of one run, with their positions, were those of the other, and the other way round."""
        return replace(self, run=np.select([self.run == one, self.run == other], [other, one], self.run))

    def turned(self, one: int, direction: Vector) -> "Observations":
        """As if one run had sensed in another direction."""
        runs = [replace(run, direction=direction) if k == one else run for k, run in enumerate(self.runs)]
        return replace(self, runs=tuple(runs))

    def framed(self, indices: Collection[int], frame: Frame) -> "Observations":
        """As if some runs were written in a frame."""
        runs = [replace(run, frame=frame) if k in indices else run for k, run in enumerate(self.runs)]
        return replace(self, runs=tuple(runs))

    def of_unknown_length(self, indices: Collection[int], u: float) -> "Observations":
        """As if the lengths of some runs were known to u, mm, whatever is stated."""
        devices = [replace(run.device or Device(id=""), length_u=u) for run in self.runs]
        pairs = enumerate(zip(self.runs, devices, strict=True))
        return replace(self, runs=tuple(replace(run, device=one) if k in indices else run for k, (run, one) in pairs))


def observations(source: str, runs: Sequence[Run], readings: Readings, only: Collection[str] = ()) -> Observations:
    """The rows that have a reading; only: of these runs, if any are named. Raises InputError where none has."""
    chosen = [index for index, run in enumerate(runs) if not only or run.id in only]
    taken = (~readings.planned & np.isin(readings.run, chosen)).nonzero()[0]
    if taken.size == 0:
        remedy = "take them, or make some with simulate"
        raise InputError([Fault(source, "column reading", "is a plan: there is no reading in it", remedy)])
    everything = Observations(
        source=source,
        runs=tuple(runs),
        run=readings.run,
        positions=readings.positions,
        reading=readings.reading,
        seq=readings.seq,
        directions=readings.directions,
        context=context_of(runs, readings),
    )
    return everything.of(taken)


def places(observed: Observations) -> IntArray:
    """(n,): equal for readings of one run at the same positions that were approached from the same side."""
    columns = {"run": observed.run}
    for axis, positions in enumerate(np.round(observed.positions, DECIMALS) + 0.0):
        columns[f"position {axis}"] = positions
    if observed.directions is not None:
        for axis, directions in enumerate(observed.directions):
            columns[f"direction {axis}"] = directions
    ranks = pl.DataFrame(columns).select(pl.struct(pl.all()).rank("dense").alias("place"))
    return ranks["place"].to_numpy().astype(np.int64) - 1


def copied_runs(observed: Observations) -> IntArray:
    """Runs, by index, most of whose repeats are equal to the last digit: rows that were copied have no noise."""
    place = places(observed)
    count = np.bincount(place)
    _, reading = np.unique(observed.reading, return_inverse=True)
    pairs, times = np.unique(np.stack([place, reading]), axis=1, return_counts=True)
    run_of_place = np.zeros(count.size, dtype=np.int64)
    run_of_place[place] = observed.run
    repeats = np.bincount(run_of_place, weights=count - 1, minlength=len(observed.runs))
    equal = np.bincount(run_of_place[pairs[0]], weights=times - 1, minlength=len(observed.runs))
    return np.flatnonzero((equal >= FEWEST_COPIES) & (equal > MOSTLY * repeats))


def pure_error(observed: Observations, group: IntArray, groups: int) -> tuple[FloatArray, IntArray]:
    """Sum of squares (mm^2) and degrees of freedom of readings about the mean of their place, by group: (groups,) each.

    group: (n,), of each reading; readings at one place are of one group.
    """
    place = places(observed)
    count = np.bincount(place)
    mean = np.bincount(place, weights=observed.reading) / count
    squares = (observed.reading - mean[place]) ** 2
    first = np.zeros(count.size, dtype=np.int64)
    first[place] = group
    freedom = np.bincount(first, weights=count - 1, minlength=groups)
    total = np.bincount(group, weights=squares, minlength=groups).astype(np.float64)
    return total, freedom.astype(np.int64)
