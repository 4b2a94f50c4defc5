"""A step in one run looks like noise of that run, until the noise is estimated beside it."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.diagnosis.result import Diagnosis


@pytest.fixture(scope="module")
def given() -> Prepared:
    design = Design(lines=1, repeats=4, targets=7, samples=24)
    return prepared(Case(seed=4, design=design, noise="none", given="exact"))


def said(given: Prepared, run: str, first: int, last: int, size: float) -> Diagnosis:
    """size: mm, added to readings of a run from the first on, up to but without the last."""
    readings = given.data.readings
    noise = SIGMA * np.random.default_rng(7).standard_normal(readings.reading.size)
    mine = readings.run == readings.run_ids.index(run)
    off = np.where(mine & (readings.seq >= first) & (readings.seq < last), size, 0.0)
    return diagnose(
        given.model, replace(given.data, readings=replace(readings, reading=readings.reading + noise + off))
    )


@pytest.mark.parametrize("size", [8.0, -30.0])
def test_a_step_near_the_start_of_a_short_run_has_its_name(given: Prepared, size: float) -> None:
    found = said(given, "Y1-2", 4, 99, size * SIGMA)
    assert [cause.effect.label for cause in found.causes] == ["laser_step of Y1-2"]
    assert found.misfits == ()


def test_two_spoilt_readings_are_no_step(given: Prepared) -> None:
    found = said(given, "Y1-2", 5, 7, 30.0 * SIGMA)
    assert found.causes == ()
    assert {one.run for one in found.outliers} == {"Y1-2"}


def test_noise_alone_is_no_step(given: Prepared) -> None:
    assert said(given, "Y1-2", 0, 0, 0.0).verdict == "no_discrepancy"
