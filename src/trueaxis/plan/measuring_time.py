"""How long runs take: setting an instrument up, starting a run, taking readings.

These are round figures for one practised person, to weigh runs against one another; nobody's stop-watch. What counts is
that a set-up takes as long as hundreds of readings, and that runs with one set-up share it.
"""

from collections.abc import Hashable, Iterable

from trueaxis.estimation.set_up import ball_of
from trueaxis.measure.setup import Run

SET_UP_MINUTES = {"laser": 20.0, "ballbar": 10.0, "probe": 10.0}  # aligning a beam; a ball; a plate or sphere
RUN_MINUTES = 1.0  # zeroing, starting the program, storing
READING_SECONDS = {"laser": 5.0, "ballbar": 0.5, "probe": 5.0}  # moving and settling; a ball bar reads on the move


def set_up_of(run: Run) -> Hashable:
    """What runs with one set-up have in common: the ball, the plate or sphere; of a laser the optics on their line."""
    if run.instrument == "ballbar":
        return (run.session, run.device, run.instrument, ball_of(run)[1])
    key = (run.session, run.device, run.instrument, run.target, run.reference, run.frame)
    return key if run.instrument == "probe" else (*key, run.direction)


def run_minutes(run: Run, readings: int) -> float:
    """Of a run whose instrument is set up."""
    return RUN_MINUTES + readings * READING_SECONDS[run.instrument] / 60.0


def minutes(runs: Iterable[tuple[Run, int]]) -> float:
    """Of runs with their numbers of readings, each set-up once."""
    total, done = 0.0, set[Hashable]()
    for run, readings in runs:
        total += run_minutes(run, readings)
        if set_up_of(run) not in done:
            total += SET_UP_MINUTES[run.instrument]
            done.add(set_up_of(run))
    return total
