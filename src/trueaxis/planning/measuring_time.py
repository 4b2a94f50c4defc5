"""How long runs take: setting an instrument up, starting a run, taking readings.

These are round figures for one practised person, to weigh runs against one another; nobody's stop-watch. What counts is
that a set-up takes as long as hundreds of readings, and that runs with one set-up share it.
"""

from collections.abc import Hashable, Iterable

import numpy as np

from trueaxis.estimation.repeats import DECIMALS
from trueaxis.estimation.set_up import ball_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run

# aligning a beam or optics; a ball; a plate or sphere; clamping a sensor
SET_UP_MINUTES = {"laser": 20.0, "ballbar": 10.0, "probe": 10.0, "angle": 20.0, "displacement": 10.0}
RUN_MINUTES = 1.0  # zeroing, starting the program, storing
# moving and settling; a ball bar reads on the move; a sensor at rest is read over hours, which count by themselves
READING_SECONDS = {"laser": 5.0, "ballbar": 0.5, "probe": 5.0, "angle": 5.0, "displacement": 5.0}


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
    """Of runs with their positions, each set-up once."""
    total, done = 0.0, set[Hashable]()
    for run, positions in runs:
        total += run_minutes(run, positions.shape[1])
        key = set_up_of(run, positions)
        if key not in done:
            total += SET_UP_MINUTES[run.instrument]
            done.add(key)
    return total
