"""Noise of a probe that came back to a few of its targets only."""

import numpy as np
import pytest

from trueaxis.diagnose.noise_of_runs import noise_of_runs
from trueaxis.diagnose.result import NoiseOf
from trueaxis.diagnose.rows import Rows
from trueaxis.measure.setup import PointOn, Run
from trueaxis.runtime.context import Context, ReadingContext

PROBE = Run("z", "probe", PointOn("tool"), PointOn("workpiece"), "workpiece", {"X": 0.0}, (0.0, 0.0, 1.0))
VALUES = np.array([0.0, 0.5, -0.4, 0.006, 0.3, -0.2, 0.003, 0.8, -0.4, 0.1, -0.7, 0.2, 0.9, -0.3, -0.1, 0.55])


def noise(targets: list[int]) -> NoiseOf:
    n = VALUES.size
    unknown = np.full(n, np.nan)
    rows = Rows(
        runs=(PROBE,),
        axes=("X",),
        row=np.arange(n),
        run=np.zeros(n, dtype=np.int64),
        seq=np.arange(n),
        positions=np.array([targets], dtype=np.float64),
        directions=np.ones((1, n)),
        reading=VALUES,
        time=None,
        temperature=None,
        feed=None,
        setup=np.zeros(n, dtype=np.int64),
        target=np.array(targets, dtype=np.int64),
        passing=np.array([targets[:place].count(one) for place, one in enumerate(targets)], dtype=np.int64),
        context=Context.at_rest(1, n, unknown, unknown),
    )
    reading = ReadingContext(np.zeros(n), unknown, unknown, unknown, unknown)
    return noise_of_runs(rows, reading, VALUES, None)[0]


def test_it_is_the_scatter_of_the_targets_read_again_not_that_of_all_targets() -> None:
    """Targets 0, 1 and 2 again: (0, 6, 3), (0.5, 0.55), (-0.4, -0.4): squares about their means 18e-6 + 1.25e-3 + 0."""
    found = noise([0, 1, 2, 0, 3, 4, 0, 5, 2, 6, 7, 8, 9, 10, 11, 1])
    assert found.freedom == 4
    assert found.sigma == pytest.approx(np.sqrt((18e-6 + 1.25e-3) / 4), rel=1e-12)
    assert found.origin == "repeats of 3 single targets"


def test_two_repeats_are_too_few() -> None:
    assert noise([0, 1, 2, 0, 3, 4, 0, 5, 6, 7, 8, 9, 10, 11, 12, 13]).origin != "repeats of 1 single targets"
