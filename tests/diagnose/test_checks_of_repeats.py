"""Repeats of one place against those of the others: silent under noise, each check fires for what it is there for."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import numpy.typing as npt
import pytest
from statsmodels.regression.linear_model import OLS

from tests.diagnose.prepared import SIGMA, Field, drawn_noise, field
from tests.hidden_effects.design import Design
from trueaxis.diagnose.checks_of_repeats import checks_of_repeats
from trueaxis.diagnose.noise import REPEATS, contrasts, estimate_noise
from trueaxis.diagnose.noise_of_runs import noise_of_runs
from trueaxis.diagnose.result import Check, NoiseOf
from trueaxis.diagnose.rows import Rows, place_of

FloatArray = npt.NDArray[np.float64]
REALISTIC = NoiseOf("laser", 0.9 * SIGMA, 0.4 * SIGMA, 0.8, SIGMA, 1e6, "given")
PLACES = ["circles of XY", "circles of XZ", "circles of YZ", "lines of X", "lines of Y", "lines of Z"]


def where() -> Field:
    return field(Design(), REALISTIC)


def noise(seed: int) -> FloatArray:
    """(n,), mm: realistic noise, run by run."""
    rows, source = where().readings.rows, np.random.default_rng(seed)
    found = np.empty(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        found[mine] = drawn_noise(source, REALISTIC, mine.stop - mine.start)[:, 0]
    return found


def checked(values: FloatArray, noise_um: float | None = None) -> tuple[Check, ...]:
    readings = where().readings
    found = noise_of_runs(readings.rows, readings.reading, values, noise_um)
    return checks_of_repeats(readings.rows, values, readings.reading.theta, found)


def fired(values: FloatArray) -> list[str]:
    return [one.name for one in checked(values) if one.fired]


def at_place(name: str, of_run: Callable[[Rows, slice, np.random.Generator], FloatArray], seed: int = 5) -> FloatArray:
    """(n,): what every run of a place gets, drawn anew for each."""
    rows, source = where().readings.rows, np.random.default_rng(seed)
    found = np.zeros(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        if place_of(rows, np.arange(mine.start, mine.stop)) == name:
            found[mine] = of_run(rows, mine, source)
    return found


def wave(rows: Rows, mine: slice, source: np.random.Generator) -> FloatArray:
    along = np.linspace(0.0, 1.0, mine.stop - mine.start)
    return np.asarray(np.sin(2.0 * np.pi * (2.5 * along + source.uniform())))


def tilt(rows: Rows, mine: slice, source: np.random.Generator) -> FloatArray:
    return np.asarray(source.standard_normal() * np.linspace(-0.5, 0.5, mine.stop - mine.start))


def squared(rows: Rows, mine: slice, source: np.random.Generator) -> FloatArray:
    assert rows.temperature is not None
    warm = rows.temperature[mine] - 20.0
    return np.asarray(warm**2)


def test_places_are_those_of_the_campaign() -> None:
    readings = where().readings
    assert sorted({one.place for one in contrasts(readings.rows, noise(0), readings.reading.theta)}) == PLACES


def test_noise_alone_fires_nothing() -> None:
    draws = [checked(noise(seed)) for seed in range(40)]
    assert {one.name.split(",")[0] for one in draws[0]} == set(PLACES)
    count = len(draws[0])
    assert count == 6 * 2 + 3  # two differences of circles of a plane are too few for two slopes of temperature
    told = np.array([[one.p_value for one in checks] for checks in draws])
    # p values are multiplied by their number: those below 1 are one in so many
    assert np.count_nonzero(told < 1.0) == pytest.approx(told.size / count, abs=4 * np.sqrt(told.size / count))
    assert not [one for checks in draws for one in checks if one.fired]


@pytest.mark.parametrize("place", ["circles of XY", "lines of Y"])
def test_a_course_that_no_repeat_has_twice_is_told_where_it_is(place: str) -> None:
    found = fired(noise(1) + 4.0 * SIGMA * at_place(place, wave))
    assert f"{place}, course of repeats" in found
    assert {one.split(",")[0] for one in found} == {place}


def test_slopes_at_one_place_are_told() -> None:
    found = fired(noise(2) + 12.0 * SIGMA * at_place("lines of Z", tilt))
    assert found == ["lines of Z, slopes of repeats"]


def test_slopes_that_go_with_the_temperature_are_told_earlier() -> None:
    shape = at_place("lines of X", squared)
    found = fired(noise(3) + 2e-3 * shape)
    assert found == ["lines of X, slopes of repeats with temperature"]


def test_size_is_told() -> None:
    size = 20.0 * SIGMA
    shape = at_place("circles of YZ", wave)
    (found,) = [one for one in checked(noise(4) + size * shape) if one.name == "circles of YZ, course of repeats"]
    # two of four passes differ; offset, slope and second harmonic of a difference are nobody's
    assert found.rms == pytest.approx(size * np.sqrt(np.mean(shape**2) / 2.0), rel=0.5)


def test_the_f_test_of_slopes_is_that_of_statsmodels() -> None:
    readings = where().readings
    values = noise(6) + 5e-3 * at_place("lines of Y", squared)
    every = [one for one in contrasts(readings.rows, values, readings.reading.theta) if one.instrument == "laser"]
    others = estimate_noise([one for one in every if one.place != "lines of Y"], "laser")
    assert others is not None
    slopes, variances = np.array([one.slope(others) for one in every]).T
    scale = np.sqrt(variances + others.slope**2)
    warming = np.array([one.warming if one.place == "lines of Y" else np.zeros(2) for one in every])
    expected = OLS(slopes / scale, warming / scale[:, np.newaxis]).fit()
    checks = checked(values)
    (found,) = [one for one in checks if one.name == "lines of Y, slopes of repeats with temperature"]
    assert found.p_value == pytest.approx(min(1.0, expected.f_pvalue * len(checks)), rel=1e-6)
    assert found.p_value < 0.5


def test_noise_that_is_given_leaves_nothing_to_compare() -> None:
    assert checked(noise(7) + 4.0 * SIGMA * at_place("circles of XY", wave), noise_um=0.3) == ()


def test_one_place_has_no_others() -> None:
    readings = where().readings
    rows = readings.rows
    values = noise(8)
    theta = readings.reading.theta
    estimated = [replace(REALISTIC, origin=REPEATS)]
    one = np.array([place_of(rows, rows.run == index) == "lines of X" for index in rows.run])
    two = one | np.array([place_of(rows, rows.run == index) == "lines of Y" for index in rows.run])
    assert checks_of_repeats(rows.only(two), values[two], theta[two], estimated)
    assert checks_of_repeats(rows.only(one), values[one], theta[one], estimated) == ()


def test_a_straightness_whose_reference_is_aligned_anew_is_no_finding() -> None:
    there = field(Design(lines=2, targets=21, straightness=True, ball_bar=False), REALISTIC)
    rows, theta = there.readings.rows, there.readings.reading.theta
    source = np.random.default_rng(4)
    values, across = np.empty(rows.size), np.zeros(rows.size)
    for index in rows.present:
        mine = rows.of_run(index)
        values[mine] = drawn_noise(source, REALISTIC, mine.stop - mine.start)[:, 0]
        if rows.runs[index].id.startswith("SX"):
            across[mine] = 2e-5 * source.standard_normal() * rows.positions[0, mine]
    assert np.ptp(across) > 10.0 * SIGMA
    noises = noise_of_runs(rows, there.readings.reading, values + across, None)
    assert not [one.name for one in checks_of_repeats(rows, values + across, theta, noises) if one.fired]
    without = noise_of_runs(rows, there.readings.reading, values, None)
    assert [one.sigma for one in noises] == pytest.approx([one.sigma for one in without], rel=1e-6)
