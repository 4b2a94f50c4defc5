"""The runs of a plan with their rows, whose readings are not looked at; with some left out, or with others added.

How long they take is setting an instrument up, starting a run, taking readings.

These are round figures for one practised person, to weigh runs against one another; nobody's stop-watch. What counts is
that a set-up takes as long as hundreds of readings, and that runs with one set-up share it.
"""

import tomllib
from collections.abc import Collection, Hashable, Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.observations import DECIMALS, Observations
from trueaxis.estimation.set_up import ball_of
from trueaxis.io.faults import Fault, InputError
from trueaxis.measurement.approach import approach_directions
from trueaxis.measurement.context import context_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.readings import Readings
from trueaxis.measurement.setup import Run, run_table, toml_text
from trueaxis.planning.candidates import Candidate

# aligning a beam or optics; a ball; a plate or sphere; clamping a sensor
SET_UP_MINUTES = {"laser": 20.0, "ballbar": 10.0, "probe": 10.0, "angle": 20.0, "displacement": 10.0}
RUN_MINUTES = 1.0  # zeroing, starting the program, storing
# moving and settling; a ball bar reads on the move; a sensor at rest is read over hours, which count by themselves
READING_SECONDS = {"laser": 5.0, "ballbar": 0.5, "probe": 5.0, "angle": 5.0, "displacement": 5.0}


@dataclass(frozen=True, slots=True, eq=False)
class PlannedRuns:
    """source: where they come from, named in faults; runs; readings: their rows."""

    source: str
    runs: tuple[Run, ...]
    readings: Readings

    @property
    def observed(self) -> Observations:
        """Every row, whether it has a reading or not; readings count as zero."""
        rows, nothing = self.readings, np.zeros(self.readings.run.size)
        context = context_of(self.runs, rows)
        return Observations(
            source=self.source,
            runs=self.runs,
            run=rows.run,
            positions=rows.positions,
            reading=nothing,
            seq=rows.seq,
            directions=rows.directions,
            context=context,
        )

    @property
    def paths(self) -> list[tuple[Run, FloatArray]]:
        """Every run with its positions (n_axes, n), in the order of its readings."""
        return [(run, self.readings.positions[:, self.readings.of_run(index)]) for index, run in enumerate(self.runs)]

    @property
    def to_take(self) -> list[tuple[Run, FloatArray]]:
        """Of `paths` those of which nothing has been read: what was measured has been taken down since."""
        measured = set(np.unique(self.readings.run[np.isfinite(self.readings.reading)]).tolist())
        return [path for index, path in enumerate(self.paths) if index not in measured]

    def of(self, ids: Collection[str]) -> "PlannedRuns":
        """Some of the runs alone, as if the others were not there."""
        kept = [index for index, run in enumerate(self.runs) if run.id in ids]
        rows, keep = self.readings, np.isin(self.readings.run, kept)

        def picked(column: FloatArray | None) -> FloatArray | None:
            return None if column is None else column[keep]

        readings = replace(
            rows,
            run_ids=tuple(rows.run_ids[index] for index in kept),
            run=np.searchsorted(np.array(kept), rows.run[keep]).astype(np.int64),
            seq=rows.seq[keep],
            positions=rows.positions[:, keep],
            directions=rows.directions[:, keep],
            reading=rows.reading[keep],
            time=picked(rows.time),
            feed=picked(rows.feed),
            temperature=picked(rows.temperature),
        )
        return replace(self, runs=tuple(self.runs[index] for index in kept), readings=readings)

    def with_added(self, added: Sequence[Candidate]) -> "PlannedRuns":
        """With new runs behind the others."""
        runs = (*self.runs, *(one.run for one in added))
        return replace(self, runs=runs, readings=_with_rows(self.readings, added))


def no_runs(source: str, axes: Sequence[str]) -> PlannedRuns:
    """A plan to which runs are added."""
    nothing, rows = np.zeros(0, dtype=np.int64), np.zeros((len(axes), 0))
    readings = Readings(
        axes=tuple(axes),
        run_ids=(),
        run=nothing,
        seq=nothing,
        positions=rows,
        directions=rows.astype(np.int8),
        reading=np.zeros(0),
    )
    return PlannedRuns(source, (), readings)


def _with_rows(given: Readings, added: Sequence[Candidate]) -> Readings:
    """With empty rows for every run added."""
    counts = [one.positions.shape[1] for one in added]
    seq = [np.arange(count) for count in counts]
    index = np.repeat(np.arange(len(added)) + len(given.run_ids), counts)
    directions = [
        approach_directions(one.run, given.axes, number, one.positions) for number, one in zip(seq, added, strict=True)
    ]
    empty = np.full(sum(counts), np.nan)

    def longer(column: FloatArray | None) -> FloatArray | None:
        return None if column is None else np.concatenate([column, empty])

    return Readings(
        axes=given.axes,
        run_ids=(*given.run_ids, *(one.run.id for one in added)),
        run=np.concatenate([given.run, index]),
        seq=np.concatenate([given.seq, *seq]),
        positions=np.hstack([given.positions, *(one.positions for one in added)]),
        directions=np.hstack([given.directions, *directions]),
        reading=np.concatenate([given.reading, empty]),
        given_directions=given.given_directions,
        time=longer(given.time),
        feed=longer(given.feed),
        temperature=longer(given.temperature),
    )


def setup_text(given: str, added: Sequence[Candidate], file: str) -> str:
    """The text of setup.toml with a [[run]] table for every run added.

    file: named in the fault. Raises InputError where tables cannot be added to the text.
    """
    text = given.rstrip("\n") + "\n" + "".join(f"\n# {one.what}\n{run_table(one.run)}" for one in added)
    try:
        count = len(tomllib.loads(text).get("run", []))
    except tomllib.TOMLDecodeError:
        count = 0
    if count != len(tomllib.loads(given).get("run", [])) + len(added):
        problem = "runs cannot be added behind its text"
        raise InputError([Fault(file, "key run", problem, "write the runs as [[run]] tables")])
    return text


def new_setup(machine: str) -> str:
    """The text of a setup.toml without runs."""
    return f"schema = 1\nmachine = {toml_text(machine)}\n"


def set_up_of(run: Run, positions: FloatArray) -> Hashable:
    """What runs with one set-up have in common: the ball, the plate or sphere; of a laser the optics and the line.

    positions: (n_axes, n), mm or deg.
    """
    if run.instrument == "ballbar":
        return (run.session, run.device, run.instrument, ball_of(run)[1])
    key = (run.session, run.device, run.instrument, run.target, run.reference, run.frame)
    if run.instrument == "probe":
        return key
    ends = [np.round(end(positions, axis=1), DECIMALS) + 0.0 for end in (np.min, np.max)] if positions.size else []
    return (*key, run.direction, *(tuple(end.tolist()) for end in ends))


def run_minutes(run: Run, readings: int) -> float:
    """Of a run whose instrument is set up."""
    return RUN_MINUTES + readings * READING_SECONDS[run.instrument] / 60.0


def minutes(runs: Iterable[tuple[Run, FloatArray]]) -> float:
    """Of runs with their positions, as they follow one another: what comes back to a set-up of a device that has been
    on another one is set up again.
    """
    total, stands = 0.0, dict[Hashable, Hashable]()
    for run, positions in runs:
        total += run_minutes(run, positions.shape[1])
        device, key = (run.instrument, run.device), set_up_of(run, positions)
        if stands.get(device) != key:
            total += SET_UP_MINUTES[run.instrument]
            stands[device] = key
    return total
