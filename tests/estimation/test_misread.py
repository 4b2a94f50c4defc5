"""A run that was read with the wrong sign is named, and no other data set is suspected."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.estimation.test_effects import KNOWN
from tests.generator.dmu60p import cubic_errors
from tests.identification.data import mixed_data
from tests.identification.effect_data import model_with
from trueaxis.estimation.estimate import EstimationOptions, estimate
from trueaxis.estimation.observations import Observations
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated


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
    assert "as if its sign were reversed" in found.report.quality.reason


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


@pytest.mark.parametrize("share", [0.3, 0.03])
@pytest.mark.parametrize(("wrong", "named"), [((), ()), (("X-2",), ("X-2",))])
def test_noise_that_is_stated_too_small_names_no_other_run(
    readings: Observations, share: float, wrong: tuple[str, ...], named: tuple[str, ...]
) -> None:
    """By it every ratio of likelihoods is wrong by 1 / share^2 in its logarithm, and all runs seem reversed."""
    noise = dict.fromkeys(range(len(readings.runs)), 3e-4 * share)
    found = estimate(model_with(), turned(readings, *wrong), KNOWN, EstimationOptions(noise=noise))
    assert tuple(readings.runs[index].id for index in found.readings.misread) == named


def turned(data: Observations, *runs: str) -> Observations:
    """With the sign of runs reversed."""
    wrong = np.array([run.id in runs for run in data.runs])[data.run]
    return replace(data, reading=np.where(wrong, -data.reading, data.reading))


def part(data: Observations, runs: Sequence[str]) -> Observations:
    """The readings of some runs."""
    rows = np.array([run.id in runs for run in data.runs])[data.run]
    seq = None if data.seq is None else data.seq[rows]
    return replace(data, run=data.run[rows], positions=data.positions[:, rows], reading=data.reading[rows], seq=seq)
