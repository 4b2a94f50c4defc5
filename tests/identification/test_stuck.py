"""Instruments that were read no more are named, coarse displays are not."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, cubic_errors
from tests.identification.data import dmu60p_model, mixed_data
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.observations import Observations
from trueaxis.identification.stuck import Stuck, stuck_runs
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues

pytestmark = pytest.mark.usefixtures("values_alone")


def found(change: Callable[[FloatArray, Observations], FloatArray], count: int = 24) -> list[Stuck]:
    """In the paper's runs and two circles with noise of 0.3 um, changed."""
    observed = mixed_data(cubic_errors(), count, seed=3)
    observed = replace(observed, reading=change(observed.reading.copy(), observed))
    model = dmu60p_model()
    known = {name: PARAMETERS[name] for name in model.dimensions if name in PARAMETERS}
    return list(stuck_runs(observed, estimate(model, observed, ErrorValues(machine=model.name, parameters=known))))


def held(reading: FloatArray, observed: Observations) -> FloatArray:
    rows = np.flatnonzero(observed.run == 3)
    reading[rows[8:]] = reading[rows[8]]
    return reading


def test_a_run_whose_display_was_held_is_named() -> None:
    (one,) = found(held)
    assert (one.run, one.count, one.of_run, one.seq) == (mixed_data(cubic_errors(), 24).runs[3].id, 16, 24, 8)
    assert f"run {one.run}: 16 of its 24 readings, from seq 8 on, are all" in str(one)


def test_sound_readings_and_a_few_that_are_the_same_are_not() -> None:
    def few(reading: FloatArray, observed: Observations) -> FloatArray:
        rows = np.flatnonzero(observed.run == 3)
        reading[rows[9]] = reading[rows[8]]
        return reading

    assert found(lambda reading, _: reading) == []
    assert found(few) == []


def test_a_display_of_a_micrometre_on_a_flat_axis_is_sound() -> None:
    """All of its readings are the same, since noise is smaller than the step."""

    def coarse(reading: FloatArray, observed: Observations) -> FloatArray:
        reading[observed.run == 3] = 4e-3
        return np.asarray(np.round(reading, 3))

    assert found(coarse) == []


def test_readings_without_noise_are_sound() -> None:
    """All errors but one are zero: whole runs are zero."""
    assert found(lambda _, observed: np.where(observed.run == 0, 1e-5 * observed.positions[0], 0.0)) == []
