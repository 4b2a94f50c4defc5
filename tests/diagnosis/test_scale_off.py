"""The scale of a laser that is off in one of two sessions: named where the values given are right beside it alone."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, FloatArray, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import signature_of
from trueaxis.diagnosis.extend import named_effects
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.effects.kind import Effect
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.setup import Device

STATED = 0.5e-6


@cache
def given() -> Prepared:
    return prepared(
        Case(seed=1, design=Design(lines=3, repeats=2, targets=15, ball_bar=False), noise="none", given="exact")
    )


def afternoon(run: str) -> bool:
    return run.startswith(("X3", "Y2", "Y3", "Z3"))


def in_two_sessions(stated: float | None) -> MeasuredData:
    """By one laser, in the morning and in the afternoon."""
    data, laser = given().data, Device(id="L1", scale_u=stated)
    runs = tuple(replace(run, device=laser, session="pm" if afternoon(run.id) else "am") for run in data.setup.runs)
    return replace(data, setup=replace(data.setup, runs=runs))


def said(added: FloatArray, stated: float | None = STATED) -> Diagnosis:
    """added: (n,), mm, to readings of the machine as given."""
    data = in_two_sessions(stated)
    scatter = SIGMA * np.random.default_rng(4).standard_normal(added.size)
    readings = replace(data.readings, reading=data.readings.reading + scatter + added)
    return diagnose(given().model, replace(data, readings=readings), DiagnoseOptions(extend=lambda _: given().model))


def scaled(by: float, only: str = "") -> FloatArray:
    """(n,), mm: what a scale adds to the readings of the afternoon; only: of lines of that axis."""
    rows = given().rows
    along = signature_of(readings_of(given().model, rows), Effect(kind="laser_scale"), ({},)).over_all()[:, 0]
    mine = [k for k, run in enumerate(rows.runs) if afternoon(run.id) and run.id.startswith(only)]
    return np.asarray(np.where(np.isin(rows.run, mine), by * along, 0.0))


@pytest.mark.parametrize("by", [12e-6, -40e-6])
def test_a_session_whose_scale_is_off_is_named_with_its_size(by: float) -> None:
    found = said(scaled(by))
    (cause,) = found.causes
    assert found.verdict == "explained"
    assert cause.effect.kind == "laser_scale"
    assert cause.effect.runs
    assert all(map(afternoon, cause.effect.runs))
    (k,) = cause.parameters
    assert k.value == pytest.approx(by, abs=3.0 * k.u)
    assert k.u < 2.0 * STATED
    assert named_effects(found) == ()  # no machine has it
    assert found.gain.rms.given < 2.0 * SIGMA  # what the machine is given is judged without it
    assert all(abs(one.change) < 4.0 * one.u for one in found.errors if one.change is not None)  # and identified anew


@pytest.mark.parametrize(
    ("by", "stated", "only"),
    [
        (0.0, STATED, ""),
        (1e-6, STATED, ""),  # as its device states
        (6e-6, None, ""),  # nothing is stated: lasers are so far off
        (30e-6, STATED, "X"),  # of one axis alone it is none of the laser
    ],
)
def test_no_scale_is_named(by: float, stated: float | None, only: str) -> None:
    found = said(scaled(by, only), stated)
    named = [effect for one in found.causes for effect in (one.effect, *(rival.effect for rival in one.rivals))]
    assert "laser_scale" not in [effect.kind for effect in named]
