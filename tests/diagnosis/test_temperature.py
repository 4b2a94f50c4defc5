"""The thermometer's flicker goes, the course of the temperature stays, and runs without one are no obstacle."""

from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest

from tests.diagnosis.prepared import SMALL, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.temperature import Course
from trueaxis.diagnosis.null_model.temperature import assumed, smoothed
from trueaxis.diagnosis.procedure import diagnose
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


def warm_shop(monkeypatch: pytest.MonkeyPatch) -> None:
    """5 K above the reference, and 3 K up and down in the course of the campaign."""

    def air(course: Course, time: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        return np.asarray(25.0 + 3.0 * np.sin(1.6 * np.pi * time / course.duration + course.phase))

    monkeypatch.setattr(Course, "air", air)


@pytest.mark.parametrize(("seed", "component"), [(1016, "EYY"), (1017, "EXX"), (1018, "EZZ")])
def test_growth_is_told_by_the_runs_that_have_a_temperature(
    monkeypatch: pytest.MonkeyPatch, seed: int, component: str
) -> None:
    """Every second run has none: it was as warm as any other, and nobody wrote it down.

    Of growth that followed the time as well as the temperature either name may be given, and no other.
    """
    warm_shop(monkeypatch)
    growth_of = f"thermal_expansion {component}"
    design = Design(lines=2, repeats=3, targets=16, samples=72, feeds=(1000.0,))
    growth = Hidden("thermal_expansion", component, size=-1.2e-5)
    given = prepared(Case(seed, design=design, effects=(growth,), given="exact"))
    temperature, run = given.data.readings.temperature, given.data.readings.run
    assert temperature is not None
    some = with_temperature(given.data, np.where(run % 2 == 1, np.nan, temperature))
    said = diagnose(given.model, some)
    (cause,) = said.causes
    names = [cause.effect.label, *(one.effect.label for one in cause.rivals)]
    assert names in ([growth_of], [f"warm_up {component}", growth_of])
    if names == [growth_of]:
        assert cause.parameters[0].value == pytest.approx(growth.size, rel=0.15)
    (without,) = [one for one in said.absences if one.lack == "temperature"]
    assert without.runs == tuple(given.data.readings.run_ids[1::2])


def test_a_run_without_a_temperature_is_as_warm_as_the_others() -> None:
    """On average, and not as it is where none has one; a gap within a run stays."""
    readings = prepared(Case(seed=1, design=SMALL, noise="none", given="exact")).data.readings
    levels = np.where(readings.run == 0, 30.0, np.where(readings.run == 1, np.nan, 20.0))
    gap = int(np.flatnonzero(readings.run == 0)[3])
    levels[gap] = np.nan
    found = assumed(replace(readings, temperature=levels)).temperature
    assert found is not None
    runs = len(readings.run_ids)
    np.testing.assert_allclose(found[readings.run == 1], (30.0 + 20.0 * (runs - 2)) / (runs - 1))
    np.testing.assert_array_equal(found[readings.run != 1], levels[readings.run != 1])
    nothing = replace(readings, temperature=np.full_like(levels, np.nan))
    assert assumed(nothing) is nothing
