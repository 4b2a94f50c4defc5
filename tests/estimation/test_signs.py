"""A run that was read with the wrong sign is named, and no other data set is suspected."""

from dataclasses import replace

import numpy as np
import pytest

from tests.estimation.test_effects import KNOWN
from tests.generator.dmu60p import cubic_errors
from tests.identify.data import mixed_data
from tests.identify.effect_data import model_with
from trueaxis.estimation.observations import Observations
from trueaxis.identify.estimated import EstimateOptions, identify_estimated


@pytest.fixture(scope="module")
def readings() -> Observations:
    return mixed_data(cubic_errors(), seed=5)


def test_data_as_they_should_be_are_no_misfit(readings: Observations) -> None:
    found = identify_estimated(model_with(), readings, EstimateOptions(known=KNOWN))
    assert found.values.fit is not None
    assert found.values.fit.state == "converged"


def test_a_reversed_run_is_named(readings: Observations) -> None:
    of_run = np.array([run.id == "X-2" for run in readings.runs])[readings.run]
    wrong = replace(readings, reading=np.where(of_run, -readings.reading, readings.reading))
    found = identify_estimated(model_with(), wrong, EstimateOptions(known=KNOWN))
    assert found.values.fit is not None
    assert found.values.fit.state == "misfit"
    assert found.values.fit.runs[0] == "X-2"
    assert "as if its sign were reversed" in found.report.quality.reason
