"""A sphere cycle that is written along the bed and along the workpiece is one measurement."""

from dataclasses import replace

import numpy as np

from tests.estimation.test_steps import begun
from tests.generator.dmu60p import cubic_errors
from tests.identification.data import mixed_data
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.runs import measured_runs
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.context import Context

HOME = {"X": 0.0, "Y": 0.0, "Z": 0.0}
COUNT = 5


def probe(name: str, frame: str, direction: tuple[float, float, float]) -> Run:
    tip, sphere = PointOn("tool", (0.0, 0.0, -100.0)), PointOn("workpiece", (50.0, 20.0, 30.0))
    return Run(id=name, instrument="probe", target=tip, reference=sphere, frame=frame, home=HOME, direction=direction)  # type: ignore[arg-type]


def frames(data: Observations) -> list[int]:
    return [one.frames for one in measured_runs(data)]


def test_rows_of_both_frames_at_the_same_places_count_as_one_measurement() -> None:
    runs = (
        probe("bx", "bed", (1.0, 0.0, 0.0)),
        probe("by", "bed", (0.0, 1.0, 0.0)),
        probe("wx", "workpiece", (1.0, 0.0, 0.0)),
    )
    at = np.random.default_rng(1).uniform(0.0, 300.0, (3, COUNT))
    data = Observations(
        source="",
        runs=runs,
        run=np.repeat(np.arange(3), COUNT),
        positions=np.hstack([at] * 3),
        reading=np.zeros(3 * COUNT),
    )
    assert frames(data) == [2, 2, 2]
    elsewhere = data.positions.copy()
    elsewhere[0, -1] += 1.0
    assert frames(replace(data, positions=elsewhere)) == [1, 1, 1]
    time = np.tile(np.arange(float(COUNT)), 3)
    known = replace(Context.at_rest(3, 3 * COUNT), time=time)
    assert frames(replace(data, context=known)) == [2, 2, 2]
    later = np.where(data.run == 2, time + 60.0, time)  # measured again, along the workpiece
    assert frames(replace(data, context=replace(known, time=later))) == [1, 1, 1]
    other = replace(runs[2], session="the day after")
    assert frames(replace(data, runs=(*runs[:2], other))) == [1, 1, 1]


def test_each_of_the_two_tells_half_as_much() -> None:
    state, _, _ = begun(mixed_data(cubic_errors(), 3, seed=1))
    first = state.runs[0]
    twice = replace(state, runs=(replace(first, frames=2), *state.runs[1:]))
    column = np.ones((first.reading.size, 1))
    alone, one_of_two = (each.whitening(0, first.kept())(column) for each in (state, twice))
    assert np.allclose(alone**2, 2.0 * one_of_two**2)
