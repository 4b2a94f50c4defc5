"""A set-up whose zero or slope is many times that of the others is a cause of the instrument; usual ones are none."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.diagnose.prepared import SIGMA, FloatArray, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnose.extend import named_effects, start_values
from trueaxis.diagnose.instruments import Off, instruments_off
from trueaxis.diagnose.null import null_of
from trueaxis.diagnose.procedure import diagnose
from trueaxis.effects.kind import Effect

USUAL = 2e-3  # mm, of the zeros of runs


@cache
def given() -> Prepared:
    return prepared(
        Case(seed=1, design=Design(lines=3, repeats=2, targets=15, samples=36), noise="none", given="exact")
    )


def readings(seed: int) -> FloatArray:
    """(n,) mm: noise, and a zero and a creep of every run as usual."""
    source, rows = np.random.default_rng(seed), given().rows
    zero, creep = source.normal(0.0, USUAL, (2, len(rows.runs)))
    passed = np.concatenate([np.linspace(0.0, 1.0, int((rows.run == k).sum())) for k in rows.present])
    return np.asarray(SIGMA * source.standard_normal(rows.size) + zero[rows.run] + 0.5 * creep[rows.run] * passed)


def found(values: FloatArray) -> tuple[Off, ...]:
    null = null_of(given().model, given().rows, values, 1e3 * SIGMA)
    return instruments_off(null, np.zeros(null.rows.size))


def places(*runs: str) -> np.ndarray:
    rows = given().rows
    return np.isin(rows.run, [k for k, run in enumerate(rows.runs) if run.id in runs])


@pytest.mark.parametrize("seed", range(5))
def test_usual_zeros_are_no_cause(seed: int) -> None:
    assert found(readings(seed)) == ()


@pytest.mark.parametrize("size", [0.08, -0.08])
def test_a_run_that_was_zeroed_elsewhere_is_named_with_its_size(size: float) -> None:
    values = readings(7)
    values[places("Y2-1")] += size
    (one,) = found(values)
    assert one.effect == Effect("reading_zero", runs=("Y2-1",))
    assert one.values[0] == pytest.approx(size, abs=4.0 * USUAL)
    assert one.p_value < 1e-4
    assert np.abs(one.signal).max() == pytest.approx(abs(one.values[0]))
    assert not one.signal[~places("Y2-1")].any()


def test_runs_of_one_set_up_that_agree_are_one_cause() -> None:
    values = readings(8)
    values[places("X1-1", "X1-2")] += 0.2
    (one,) = found(values)
    assert one.effect == Effect("reading_zero", runs=("X1-1", "X1-2"))


def test_the_diagnosis_names_the_instrument_and_extends_no_machine() -> None:

    case = prepared.__wrapped__(Case(seed=3, design=Design(lines=3, repeats=2, targets=15, samples=36), given="exact"))
    data = case.data
    shifted = data.readings.reading + 0.15 * (data.readings.run == data.readings.run_ids.index("Z1-2"))
    said = diagnose(case.model, replace(data, readings=replace(data.readings, reading=shifted)))
    assert said.verdict == "explained"
    assert [one.effect for one in said.causes] == [Effect("reading_zero", runs=("Z1-2",))]
    assert said.causes[0].parameters[0].value == pytest.approx(0.15, abs=0.02)
    assert named_effects(said) == ()
    assert start_values(said) == ()
