"""Which runs are taken, where and when, on one clock and with one course of temperature."""

from collections.abc import Iterator

import numpy as np

from tests.hidden_effects.circles import circle_runs
from tests.hidden_effects.design import Design
from tests.hidden_effects.lines import gauge_runs, laser_runs
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.rows import Rows
from tests.hidden_effects.state import Plan, RunPlan, State
from tests.hidden_effects.temperature import course

NEXT_RUN_S, NEXT_LINE_S = 60.0, 600.0


def plan_runs(machine: Machine, design: Design, source: np.random.Generator) -> Plan:
    """The campaign: the lines one after another, then the circles, with one clock and one course of temperature."""
    runs: list[RunPlan] = []
    rows: list[Rows] = []
    starts: list[float] = []
    clock, line = 0.0, ""
    for run, taken in _all_runs(machine, design, source):
        if line:
            clock += NEXT_RUN_S if run.line == line else NEXT_LINE_S
        runs.append(run)
        rows.append(taken)
        starts.append(clock)
        clock, line = clock + taken.lasts, run.line
    counts = [len(taken.time) for taken in rows]

    def joined(name: str) -> dict[str, Array]:
        return {axis: np.concatenate([getattr(taken, name)[axis] for taken in rows]) for axis in machine.axes}

    time = np.concatenate([start + taken.time for start, taken in zip(starts, rows, strict=True)])
    weather = course(design.temperature or "day", source, clock)
    state = State(
        run=np.repeat(np.arange(len(runs)), counts),
        seq=np.concatenate([np.arange(count) for count in counts]),
        positions=joined("positions"),
        directions=joined("directions"),
        velocity=joined("velocity"),
        since_reversal=joined("since_reversal"),
        time=time,
        temperature=weather.air(time),
        soaked=weather.structure(time),
        feed=np.concatenate([taken.feed for taken in rows]),
    )
    return Plan(tuple(runs), state)


def _all_runs(machine: Machine, design: Design, source: np.random.Generator) -> Iterator[tuple[RunPlan, Rows]]:
    if design.laser:
        yield from laser_runs(machine, design, source)
    if design.gauge:
        yield from gauge_runs(machine, design, source)
    if design.ball_bar:
        yield from circle_runs(machine, design)
