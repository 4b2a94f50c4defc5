"""The thermometer's flicker goes, the course of the temperature stays."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest

from tests.diagnosis.prepared import SMALL, prepared
from tests.hidden_effects.case import Case
from trueaxis.diagnosis.rows import smoothed
from trueaxis.measurement.data import MeasuredData


def course(data: MeasuredData) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.int64]]:
    """One bend over all readings, so that each run has a stretch of it."""
    time = data.readings.time
    assert time is not None
    return 20.0 + 1.5 * np.sin((time - time.min()) / np.ptp(time) * 3.0), data.readings.run


def with_temperature(data: MeasuredData, temperature: npt.NDArray[np.float64] | None) -> MeasuredData:
    return replace(data, readings=replace(data.readings, temperature=temperature))


@pytest.fixture(scope="module")
def data() -> MeasuredData:
    return prepared(Case(seed=1, design=SMALL, noise="none", given="exact")).data


def test_flicker_is_removed_and_the_course_kept(data: MeasuredData) -> None:
    true, _ = course(data)
    flicker = 0.05 * np.random.default_rng(1).standard_normal(true.size)
    found = smoothed(with_temperature(data, true + flicker)).readings.temperature
    assert found is not None
    assert np.std(found - true) < 0.5 * np.std(flicker)
    without = smoothed(with_temperature(data, true)).readings.temperature
    assert without == pytest.approx(true, abs=1e-3)  # a run's stretch of a slow course is nearly a polynomial


def test_runs_do_not_flow_into_each_other(data: MeasuredData) -> None:
    """A jump between two runs is no flicker."""
    _, run = course(data)
    steps = 20.0 + run % 3
    found = smoothed(with_temperature(data, steps.astype(np.float64))).readings.temperature
    assert found == pytest.approx(steps, abs=1e-9)


def test_without_clock_or_thermometer_nothing_changes(data: MeasuredData) -> None:
    assert smoothed(with_temperature(data, None)).readings.temperature is None
    true, _ = course(data)
    given = replace(data, readings=replace(data.readings, time=None, temperature=true))
    assert smoothed(given) is given


def test_a_run_with_a_gap_in_its_temperature_stays_as_it_is(data: MeasuredData) -> None:
    true, run = course(data)
    noisy = true + 0.05 * np.random.default_rng(2).standard_normal(true.size)
    gap = int(np.flatnonzero(run == 0)[3])
    noisy[gap] = np.nan
    found = smoothed(with_temperature(data, noisy)).readings.temperature
    assert found is not None
    np.testing.assert_array_equal(found[run == 0], noisy[run == 0])
    assert np.isfinite(found[run != 0]).all()
    assert not np.array_equal(found[run == 1], noisy[run == 1])
