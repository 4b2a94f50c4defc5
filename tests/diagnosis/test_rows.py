"""Which readings a diagnosis works on."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.rows import TURNING, rows_of
from trueaxis.measurement.data import MeasuredData


@pytest.fixture(scope="module")
def given() -> Prepared:
    return prepared(Case(seed=5, design=Design(lines=1, repeats=1, targets=11, samples=64), given="exact"))


def circle_turned(given: Prepared, by: float) -> tuple[MeasuredData, np.ndarray, np.ndarray]:
    """The data with the samples of the first circle at other angles, and its places and angles, in their order."""
    readings = given.data.readings
    index = next(k for k, run in enumerate(given.data.setup.runs) if run.instrument == "ballbar")
    mine = np.flatnonzero(readings.run == index)
    mine = mine[np.argsort(readings.seq[mine])]
    x, y = (row for row in range(3) if np.ptp(readings.positions[row, mine]) > 1.0)
    middle = readings.positions[:, mine].mean(axis=1)
    radius = float(np.hypot(readings.positions[x, mine[0]] - middle[x], readings.positions[y, mine[0]] - middle[y]))
    angle = by + np.arange(mine.size) * 2.0 * np.pi / mine.size
    positions, directions = readings.positions.copy(), readings.directions.copy()
    positions[x, mine], positions[y, mine] = middle[x] + radius * np.cos(angle), middle[y] + radius * np.sin(angle)
    directions[x, mine], directions[y, mine] = -np.sign(np.sin(angle)), np.sign(np.cos(angle))
    changed = replace(readings, positions=positions, directions=directions)
    return MeasuredData(given.data.setup, changed), mine, np.abs(radius * (1.0 - np.abs(np.cos(angle))))


@pytest.mark.parametrize("by", [0.001, 0.03, 0.05])
def test_samples_beside_a_reversal_count_unless_they_are_at_it(given: Prepared, by: float) -> None:
    """A spike right after a reversal shows in the very next samples; only at the turn itself the direction is open."""
    data, mine, off_x = circle_turned(given, by)
    kept = np.isin(mine, rows_of(data).row)
    angle = by + np.arange(mine.size) * 2.0 * np.pi / mine.size
    off_y = off_x / (1.0 - np.abs(np.cos(angle))) * (1.0 - np.abs(np.sin(angle)))
    near = np.minimum(off_x, off_y)
    assert kept[near > 3.0 * TURNING].all()
    assert not kept[near < TURNING / 3.0].any()
    assert (near < TURNING / 3.0).any() == (by == 0.001)
