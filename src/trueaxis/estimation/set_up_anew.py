"""Which runs an instrument was set up anew for, where no session says so."""

from collections.abc import Hashable, Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.set_up import ball_of
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Run

NIGHT = 6 * 3600.0  # s without a reading: longer than the pauses of a shift, shorter than a night
IN_SPINDLE = ("laser", "probe")  # take the place of the ball of a ball bar


@dataclass(frozen=True, slots=True)
class Taken:
    """A run with readings. index: among the runs; start, end: s, of its readings; 0 where no clock tells them."""

    index: int
    start: float = 0.0
    end: float = 0.0


def taken_runs(run: IntArray, time: FloatArray | None) -> list[Taken]:
    """As they were taken: by their clock, else as they stand in setup.toml.

    run: (n,), index of the run of each reading; time: (n,), s, or None.
    """
    present: list[int] = np.unique(run).tolist()
    if time is None or not np.isfinite(time).all():
        return [Taken(index) for index in present]
    clocks = ((index, time[run == index]) for index in present)
    return sorted((Taken(k, float(one.min()), float(one.max())) for k, one in clocks), key=lambda one: one.start)


def set_ups(runs: Sequence[Run], taken: Sequence[Taken]) -> dict[int, int]:
    """Of each run of a laser or ball bar, by index, the number of its set-up among those of its device.

    A laser is on one line at a time, and a ball bar on one ball: what it comes back to after another, or after a night,
    was set up anew; and a ball bar after something else was in the spindle. Where sessions are named, they say it.
    taken: in the order in which they were taken.
    """
    found: dict[int, int] = {}
    last: dict[tuple[str, Hashable], tuple[Hashable, int, float]] = {}
    for one in taken:
        run = runs[one.index]
        if run.instrument in IN_SPINDLE:
            last |= {key: (None, number, end) for key, (_, number, end) in last.items() if key[0] == "ballbar"}
        if run.instrument not in ("laser", "ballbar"):
            continue
        key = run.instrument, run.device
        place = ball_of(run)[1] if run.instrument == "ballbar" else (run.target, run.reference, run.direction)
        before, number, end = last.get(key, (None, -1, one.start))
        number += place != before or one.start - end > NIGHT
        last[key] = place, number, one.end
        found[one.index] = 0 if run.session else number
    return found
