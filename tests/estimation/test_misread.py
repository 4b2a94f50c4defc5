"""A run that was read with the wrong sign, in the wrong unit or order is named; no other data set is suspected."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.estimation.test_effects import KNOWN
from tests.generator.dmu60p import cubic_errors
from tests.identification.data import mixed_data
from tests.identification.effect_data import model_with
from trueaxis.estimation import swapped as swapped_module
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.evidence import evidence_at
from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.misread import Fault, fault_ratios
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.state import linearised
from trueaxis.estimation.swapped import swap_ratios
from trueaxis.estimation.undone import undone_reading
from trueaxis.estimation.wrong_runs import WrongRuns
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import Device


@pytest.fixture(scope="module")
def readings() -> Observations:
    return mixed_data(cubic_errors(), seed=5)


def test_data_as_they_should_be_are_no_misfit(readings: Observations) -> None:
    found = identify_estimated(model_with(), readings, IdentifyOptions(known=KNOWN))
    assert found.values.fit is not None
    assert found.values.fit.state == "converged"


def test_a_reversed_run_is_named(readings: Observations) -> None:
    found = identify_estimated(model_with(), turned(readings, "X-2"), IdentifyOptions(known=KNOWN))
    assert found.values.fit is not None
    assert found.values.fit.state == "misfit"
    assert found.values.fit.runs == ("X-2",)
    assert "run X-2 reads as if the sign were reversed" in found.report.quality.reason


def test_a_reversed_run_that_the_noise_has_taken_is_named(readings: Observations) -> None:
    """Nine runs: the estimate takes what X-3 makes of them for slow noise, by which the run is as likely as not."""
    few = part(readings, [run.id for run in readings.runs[:9]])
    found = identify_estimated(model_with(), turned(few, "X-3"), IdentifyOptions(known=KNOWN))
    assert found.values.fit is not None
    assert found.values.fit.runs == ("X-3",)


def test_two_reversed_runs_are_named(readings: Observations) -> None:
    found = identify_estimated(model_with(), turned(readings, "X-1", "Y-5"), IdentifyOptions(known=KNOWN))
    assert found.values.fit is not None
    assert set(found.values.fit.runs) == {"X-1", "Y-5"}


def test_a_run_that_is_wrong_otherwise_is_named_beside_a_reversed_one(readings: Observations) -> None:
    """With X-2 undone Y-5 contradicts the others, whatever is wrong with it: it was not looked for."""
    wrong = turned(readings, "X-2")
    y5 = wrong.run == [run.id for run in wrong.runs].index("Y-5")
    elsewhere = replace(wrong, reading=wrong.reading + np.where(y5, 0.1 * np.sin(wrong.positions[1] / 40.0), 0.0))
    quality = identify_estimated(model_with(), elsewhere, IdentifyOptions(known=KNOWN)).report.quality
    assert quality.fit.state == "misfit"
    assert "run X-2 reads as if the sign were reversed" in quality.reason
    assert "run Y-5 contradicts all others, with that undone, too" in quality.reason


# lines of one axis differ by what its angles make of their offsets alone: three of them tell little of X, of Z more
@pytest.mark.parametrize("pair", [("X-1", "Y-5"), ("Z-7", "Z-8")])
def test_two_swapped_runs_are_named_together(readings: Observations, pair: tuple[str, str]) -> None:
    """They contradicted the others, or one of them was taken for reversed."""
    found = identify_estimated(model_with(), swapped(readings, *pair), IdentifyOptions(known=KNOWN))
    quality = found.report.quality
    assert quality.fit.state == "misfit"
    assert set(quality.fit.runs) == set(pair)
    assert f"runs {pair[0]} and {pair[1]} read as if each had the other's readings" in quality.reason


def test_two_runs_under_each_others_name_are_named_together(readings: Observations) -> None:
    """Their positions go along: readings alone in each other's place would be of other targets."""
    ids = [run.id for run in readings.runs]
    wrong = readings.exchanged(ids.index("X-1"), ids.index("Y-5"))
    found = identify_estimated(model_with(), wrong, IdentifyOptions(known=KNOWN))
    quality = found.report.quality
    assert set(quality.fit.runs) == {"X-1", "Y-5"}
    assert "runs X-1 and Y-5 read as if each had the other's readings" in quality.reason


def test_all_runs_of_an_instrument_are_named_together(readings: Observations) -> None:
    """Either of two may have the wrong sign; the unit is that of the smaller one."""
    lasers = [run.id for run in readings.runs if run.instrument == "laser"]
    found = identify_estimated(model_with(), turned(readings, *lasers), IdentifyOptions(known=KNOWN))
    assert found.report.quality.fit.runs == ("xy", "xz", *lasers)
    assert "both runs of ballbar, or all 18 runs of laser, read as if the sign were" in found.report.quality.reason
    small = scaled(scaled(readings, "xy", 1e-3), "xz", 1e-3)
    found = identify_estimated(model_with(), small, IdentifyOptions(known=KNOWN))
    assert found.report.quality.fit.runs == ("xy", "xz")
    assert "both runs of ballbar read as if the values were 1000 times too small" in found.report.quality.reason


def test_runs_while_the_same_axes_move_are_named_together(readings: Observations) -> None:
    """One set-up in two directions: of two such levels a sound calibrator was accused."""
    diagonals = [run.id for run in readings.runs if run.id.startswith("XZ-")]
    found = identify_estimated(model_with(), turned(readings, *diagonals), IdentifyOptions(known=KNOWN))
    assert set(found.report.quality.fit.runs) == set(diagonals)
    reason = "the 4 runs XZ-1x, XZ-2x, XZ-1z and XZ-2z of laser together read as if the sign were reversed"
    assert reason in found.report.quality.reason


def test_the_unit_of_an_instrument_is_the_one_that_makes_it_agree(readings: Observations) -> None:
    """An instrument in inches was said to be in metres: as far as noise goes any unit is as likely."""
    small = scaled(scaled(readings, "xy", 1.0 / 25.4), "xz", 1.0 / 25.4)
    found = identify_estimated(model_with(), small, IdentifyOptions(known=KNOWN))
    assert found.report.quality.reason.startswith("both runs of ballbar read as if inches were written for mm")


def test_of_three_instruments_the_one_that_the_others_contradict_is_named(readings: Observations) -> None:
    """Lines of X by a laser, of Y and Z by another, a ball bar."""
    other = Device(id="other")
    runs = tuple(
        replace(one, device=other if one.id[0] in "YZ" else Device(id="laser")) if one.instrument == "laser" else one
        for one in readings.runs
    )
    named = {one.id for one in runs if one.device is not None and one.device.id == "other"}
    found = estimate(model_with(), turned(replace(readings, runs=runs), *named), KNOWN).readings.misread
    assert {readings.runs[index].id for index, one in found.items() if one.sure} == named


def test_a_fault_is_as_much_likelier_undone_as_the_evidence_says(
    readings: Observations, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The marginal likelihoods of both, by the same sizes, noise and linearisation, from QR factors of all readings."""
    kept: list[tuple[Fitted, Posterior]] = []

    def keep(_: object, fitted: Fitted, posterior: Posterior) -> WrongRuns:
        kept.append((fitted, posterior))
        return WrongRuns()

    monkeypatch.setattr("trueaxis.estimation.estimate.wrong_runs", keep)
    estimate(model_with(), swapped(readings, "X-1", "Y-5"), KNOWN)
    estimate(model_with(), turned(readings, "xy", "xz"), KNOWN)
    (fitted, posterior), (reversed_bars, its_posterior) = kept
    state, names = fitted.state, [one.rows.run.id for one in fitted.state.runs]
    every = {frozenset(names[place] for place in swap.places): odds for swap, odds in
             swap_ratios(fitted, posterior).items()}  # fmt: skip
    assert max(every, key=lambda pair: every[pair]) == {"X-1", "Y-5"}
    pair = [names.index("X-1"), names.index("Y-5")]
    gain = by_evidence(fitted, {a: state.runs[b].reading for a, b in (pair, pair[::-1])})
    assert gain > 0.0
    assert every[frozenset({"X-1", "Y-5"})] == pytest.approx(gain, rel=1e-6)
    both = Fault((names.index("xy"), names.index("xz")), "reversed")
    gain = by_evidence(reversed_bars, {place: -reversed_bars.state.runs[place].reading for place in both.places})
    assert gain > 0.0
    assert fault_ratios(reversed_bars, its_posterior)[both] == pytest.approx(gain, rel=1e-6)


def by_evidence(fitted: Fitted, changed: Mapping[int, FloatArray]) -> float:
    """Logarithm of how much likelier readings are where some runs, by their places, have others."""
    state = fitted.state
    runs, residual = list(state.runs), list(state.residual)
    for place, reading in changed.items():
        runs[place] = replace(state.runs[place], reading=reading)
        residual[place] = state.residual[place] + reading - state.runs[place].reading
    after = replace(state, runs=tuple(runs), residual=tuple(residual))
    there, here = (evidence_at(fitted.sizes, linearised(one), fitted.x) for one in (after, state))
    return there - here


def test_repeats_of_a_run_are_never_swapped(readings: Observations) -> None:
    """Readings of two runs that are set up alike may be taken for each other."""
    one, other = (next(run for run in measured_runs(readings) if run.rows.run.id == name) for name in ("X-1", "X-2"))
    assert swapped_module._differ(one, other)
    twin = replace(one.rows.run, id="again")
    assert not swapped_module._differ(one, replace(one, rows=replace(one.rows, run=twin)))


@pytest.mark.parametrize(
    ("run", "factor", "how"),
    # a run that reads 1000 times too large is refused before, by the sizes of [prior] (test_believable_setup.py)
    [("circle", -1.0, "reversed"), ("circle", 1e-3, "small"), ("Y-5", 1e-3, "small")],
)
def test_a_sign_or_unit_is_named_of_any_instrument(readings: Observations, run: str, factor: float, how: str) -> None:
    """Ball bars were not looked at, nor units: the estimate took the run for slow noise and ended with exit 0."""
    named = next(
        one.id for one in readings.runs if one.id.startswith(run) or (run, one.instrument) == ("circle", "ballbar")
    )
    found = estimate(model_with(), scaled(readings, named, factor), KNOWN).readings.misread
    assert {readings.runs[index].id: one.how for index, one in found.items() if one.sure} == {named: how}


def test_all_readings_in_another_unit_are_a_misfit(readings: Observations) -> None:
    found = identify_estimated(
        model_with(), replace(readings, reading=1e-3 * readings.reading), IdentifyOptions(known=KNOWN)
    )
    assert found.values.fit is not None
    assert found.values.fit.state == "misfit"
    assert "are they in m?" in found.report.quality.reason


def test_a_display_that_shows_nothing_is_no_wrong_unit(readings: Observations) -> None:
    """Readings that are all equal, or that take two values, say nothing of their unit."""
    coarse = replace(readings, reading=np.where(readings.run == 0, np.round(readings.reading, 1), readings.reading))
    assert not np.ptp(coarse.reading[coarse.run == 0]) > 0.1
    one = measured_runs(coarse)[0]
    assert np.ptp(one.reading) > 0.0 or undone_reading(one, "small") is None
    assert 0 not in estimate(model_with(), coarse, KNOWN).readings.misread


def test_targets_from_the_other_end_are_undone_pass_by_pass() -> None:
    run = measured_runs(mixed_data(cubic_errors(), seed=5))[0]
    undone = undone_reading(run, "mirrored")
    assert undone is not None
    along = run.rows.positions[int(np.argmax(np.ptp(run.rows.positions, axis=1)))]
    there = {round(float(at), 6): value for at, value in zip(along, undone, strict=True)}
    ends = along.min() + along.max()
    assert all(there[round(float(ends - at), 6)] == value for at, value in zip(along, run.reading, strict=True))


@pytest.mark.parametrize("share", [0.3, 0.03])
@pytest.mark.parametrize(("wrong", "named"), [((), ()), (("X-2",), ("X-2",))])
def test_noise_that_is_stated_too_small_names_no_other_run(
    readings: Observations, share: float, wrong: tuple[str, ...], named: tuple[str, ...]
) -> None:
    """By it every ratio of likelihoods is wrong by 1 / share^2 in its logarithm, and all runs seem reversed."""
    noise = dict.fromkeys(range(len(readings.runs)), 3e-4 * share)
    found = estimate(model_with(), turned(readings, *wrong), KNOWN, EstimationOptions(noise=noise))
    assert tuple(readings.runs[index].id for index in found.readings.misread) == named


def scaled(data: Observations, run: str, factor: float) -> Observations:
    """With the readings of a run multiplied."""
    of = np.array([one.id == run for one in data.runs])[data.run]
    return replace(data, reading=np.where(of, factor, 1.0) * data.reading)


def turned(data: Observations, *runs: str) -> Observations:
    """With the sign of runs reversed."""
    wrong = np.array([run.id in runs for run in data.runs])[data.run]
    return replace(data, reading=np.where(wrong, -data.reading, data.reading))


def swapped(data: Observations, one: str, other: str) -> Observations:
    """With the readings of two runs in each other's place."""
    ids = [run.id for run in data.runs]
    first, second = (np.flatnonzero(data.run == ids.index(name)) for name in (one, other))
    reading = data.reading.copy()
    reading[first], reading[second] = data.reading[second], data.reading[first]
    return replace(data, reading=reading)


def part(data: Observations, runs: Sequence[str]) -> Observations:
    """The readings of some runs."""
    rows = np.array([run.id in runs for run in data.runs])[data.run]
    seq = None if data.seq is None else data.seq[rows]
    return replace(data, run=data.run[rows], positions=data.positions[:, rows], reading=data.reading[rows], seq=seq)
