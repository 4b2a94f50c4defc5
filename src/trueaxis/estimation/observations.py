"""The readings that identification works on."""

from collections.abc import Sequence
from dataclasses import dataclass

from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.context import context_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import DirectionArray, IntArray, Readings
from trueaxis.measurement.setup import Run
from trueaxis.model.context import Context


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


def observations(source: str, runs: Sequence[Run], readings: Readings) -> Observations:
    """The rows that have a reading. Raises InputError where none has."""
    taken = (~readings.planned).nonzero()[0]
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
