"""Outliers that are put in are found; jumps, drifts and everything that repeats are none."""

from functools import cache

import numpy as np
import numpy.typing as npt
import pytest

from tests.diagnose.prepared import SIGMA, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnose.rows import Rows
from trueaxis.diagnose.screening import outliers

FloatArray = npt.NDArray[np.float64]


@cache
def rows() -> Rows:
    return prepared(Case(seed=1, design=Design(lines=2, repeats=3), noise="none", given="exact")).rows


def noise(seed: int) -> FloatArray:
    return SIGMA * np.random.default_rng(seed).standard_normal(rows().size)


@pytest.mark.parametrize("size", [12.0, -12.0, 1000.0])
def test_a_reading_far_from_its_repeats_is_found_and_left_out(size: float) -> None:
    values = noise(1)
    places = [rows().of_run(0).start + 3, rows().of_run(4).start + 20, rows().of_run(11).stop - 2]
    values[places] += size * SIGMA
    keep, found = outliers(rows(), values)
    assert np.flatnonzero(~keep).tolist() == places
    assert [one.seq for one in found] == rows().seq[places].tolist()
    assert [one.run for one in found] == [rows().runs[rows().run[place]].id for place in places]
    for one in found:
        assert one.deviation == pytest.approx(size * SIGMA, abs=5 * SIGMA)
        assert one.z == pytest.approx(one.deviation / SIGMA, rel=0.3)


def test_in_clean_data_hardly_anything_is_left_out() -> None:
    """Five standard deviations: one reading in two million, here in 15 000."""
    assert sum(len(outliers(rows(), noise(seed))[1]) for seed in range(10)) <= 1


@pytest.mark.parametrize("kind", ["jump", "drift", "misfit", "offset"])
def test_what_is_no_outlier_stays(kind: str) -> None:
    values = noise(2)
    run = rows().of_run(7)
    size = run.stop - run.start
    if kind == "jump":
        values[run.start + size // 2 : run.stop] += 30 * SIGMA
    elif kind == "drift":
        values[run] += np.linspace(0.0, 60 * SIGMA, size)
    elif kind == "misfit":
        values += 100 * SIGMA * np.random.default_rng(3).standard_normal(int(rows().target.max()) + 1)[rows().target]
    else:
        values[run] += 1000 * SIGMA
    keep, found = outliers(rows(), values)
    assert keep.all()
    assert not found


def test_without_three_readings_of_a_target_nobody_can_tell() -> None:
    twice = prepared(Case(seed=1, design=Design(lines=1, repeats=2, targets=15), noise="none", given="exact")).rows
    laser = np.array([run.instrument == "laser" for run in twice.runs])[twice.run]
    values = SIGMA * np.random.default_rng(0).standard_normal(twice.size)
    values[np.flatnonzero(laser)[5]] += 1.0
    assert outliers(twice, values)[0].all()


def test_readings_that_repeat_to_the_last_digit() -> None:
    assert outliers(rows(), np.zeros(rows().size))[0].all()
