"""A set-up whose zero or slope is many times that of the others is a cause of the instrument; usual ones are none."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, FloatArray, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature, signature_of
from trueaxis.diagnosis.extend import named_effects, start_values
from trueaxis.diagnosis.judging.instruments import _chance, _Unknown, instruments_off
from trueaxis.diagnosis.judging.off import Off
from trueaxis.diagnosis.null_model.base import WIDE, base_of
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.effects.kind import Effect
from trueaxis.estimation.instruments import SET_UP_FACTOR, STATED_FACTOR
from trueaxis.measurement.setup import Device

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


@pytest.mark.parametrize(("first", "named"), [(0.0, [("reading_zero", ("Y2-1",))]), (0.5, [])])
def test_a_run_that_disagrees_with_itself_has_no_zero_that_is_off(
    first: float, named: list[tuple[str, tuple[str, ...]]]
) -> None:
    """From a share of its readings on they are off: from the first one a zero, from the middle on no zero."""
    values, mine = readings(2), np.flatnonzero(places("Y2-1"))
    values[mine[int(first * mine.size) :]] += 0.1
    null = null_of(given().model, given().rows, values, None)
    off = instruments_off(null, np.zeros(null.rows.size))
    assert [(one.effect.kind, one.effect.runs) for one in off] == named


@pytest.mark.parametrize("size", [0.05, 0.5])
def test_large_errors_of_the_machine_are_no_cause_of_an_instrument(
    size: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A curve rougher and larger than [prior] has it; by the expected sizes alone a line is blamed for it."""
    effect = Effect(kind="cyclic", component="EXX")
    rough = signature_of(readings_of(given().model, given().rows), effect, ({"pitch": 16.7},)).over_all()[:, 0]
    assert found(readings(3) + size * rough) == ()
    monkeypatch.setattr("trueaxis.diagnosis.judging.instruments.WIDER", (WIDE,))
    assert found(readings(3) + size * rough) != ()


def test_a_faulty_instrument_on_a_machine_of_large_errors_is_named() -> None:
    base = base_of(given().model, given().rows)
    weights = 12.0 * base.expected[: base.of_machine] * np.random.default_rng(5).standard_normal(base.of_machine)
    values = readings(5) + base.machine.dense() @ weights
    values[places("Y2-1")] += 0.3
    assert Effect(kind="reading_zero", runs=("Y2-1",)) in [one.effect for one in found(values)]


@pytest.mark.parametrize("size", [0.08, -0.08])
def test_a_run_that_was_zeroed_elsewhere_is_named_with_its_size(size: float) -> None:
    values = readings(7)
    values[places("Y2-1")] += size
    (one,) = found(values)
    assert one.effect == Effect(kind="reading_zero", runs=("Y2-1",))
    assert one.values[0] == pytest.approx(size, abs=4.0 * USUAL)
    assert one.p_value < 1e-4
    assert np.abs(one.signal).max() == pytest.approx(abs(one.values[0]))
    assert not one.signal[~places("Y2-1")].any()


@pytest.mark.parametrize(("caused", "named"), [(0.0, 1), (0.06, 0), (0.002, 1)])
def test_a_zero_as_large_as_what_a_cause_does_in_its_run_is_not_of_the_instrument(caused: float, named: int) -> None:
    """The form of a cause may be as wrong at home, where the run is zeroed."""
    mine = places("Y2-1")
    signal = np.where(mine, caused * np.linspace(-1.0, 1.0, mine.size), 0.0)
    null = null_of(given().model, given().rows, readings(7) + signal + 0.08 * mine, 1e3 * SIGMA)
    assert len(instruments_off(null, signal)) == named


def test_runs_of_one_set_up_that_agree_are_one_cause() -> None:
    values = readings(8)
    values[places("X1-1", "X1-2")] += 0.2
    (one,) = found(values)
    assert one.effect == Effect(kind="reading_zero", runs=("X1-1", "X1-2"))


def test_the_diagnosis_names_the_instrument_and_extends_no_machine() -> None:

    case = prepared.__wrapped__(Case(seed=3, design=Design(lines=3, repeats=2, targets=15, samples=36), given="exact"))
    data = case.data
    shifted = data.readings.reading + 0.15 * (data.readings.run == data.readings.run_ids.index("Z1-2"))
    said = diagnose(case.model, replace(data, readings=replace(data.readings, reading=shifted)))
    assert said.verdict == "explained"
    assert [one.effect for one in said.causes] == [Effect(kind="reading_zero", runs=("Z1-2",))]
    assert said.causes[0].parameters[0].value == pytest.approx(0.15, abs=0.02)
    assert named_effects(said) == ()
    assert start_values(said) == ()


@cache
def straight() -> Prepared:
    plan = Design(lines=1, repeats=1, targets=15, straightness=True, samples=60)
    return prepared(Case(seed=1, design=plan, noise="none", given="exact"))


def test_a_straightness_line_is_measured_by_the_others_of_its_class() -> None:
    """Such lines may be some tenths of a millimetre off, but these are not."""
    rows, source = straight().rows, np.random.default_rng(4)
    names = [run.id for run in rows.runs]
    values = SIGMA * source.standard_normal(rows.size) + source.normal(0.0, USUAL, len(names))[rows.run]
    assert off_in(values) == []
    odd = "SYX"
    values[rows.run == names.index(odd)] += 0.2
    assert [one.effect for one in off_in(values)] == [Effect(kind="reading_zero", runs=(odd,))]


def test_a_ball_in_another_place_is_named_with_that() -> None:
    rows, source = straight().rows, np.random.default_rng(5)
    plane = tuple(run.id for run in rows.runs if run.instrument == "ballbar" and run.id.startswith("XY"))
    effect = Effect(kind="ballbar_centre", runs=plane)
    signal, _ = parameter_signature(readings_of(straight().model, rows), effect, np.array([6.0, -0.4, 0.0]))
    (one,) = off_in(SIGMA * source.standard_normal(rows.size) + signal)
    assert one.effect == effect
    assert one.values[:2] == pytest.approx([6.0, -0.4], abs=0.1)


def test_one_that_stands_alone_may_have_any_size_unless_its_device_says() -> None:
    bar = "ballbar length"
    alone = _Unknown(
        kind=bar,
        of=0,
        runs=(0,),
        size=20e-3,
        factor=SET_UP_FACTOR,
        value=60e-3,
        u=1e-3,
        column=np.zeros(1),
        squares=3600.0,
    )
    assert _chance(alone, ()) > 0.1
    assert _chance(replace(alone, size=1e-3, factor=STATED_FACTOR), ()) < 1e-4
    others = [replace(alone, of=k, value=value) for k, value in enumerate((1e-3, -1e-3, 5e-4, 0.0, -5e-4, 1e-3))]
    assert _chance(alone, others) < 1e-4


def off_in(values: FloatArray) -> list[Off]:
    case = straight()
    null = null_of(case.model, case.rows, values, 1e3 * SIGMA)
    return list(instruments_off(null, np.zeros(null.rows.size)))


@pytest.mark.parametrize("size", [0.012, -0.03])
def test_a_bar_that_is_longer_in_every_session_is_one_cause(size: float) -> None:
    """A session for each plane: at 12 um beyond 0.5 um nothing was said, at 30 um four zeros were named of six."""
    rows, device = given().rows, Device(id="bar", length_u=5e-4)
    runs = [
        replace(one, device=device, session=one.id[:2]) if one.instrument == "ballbar" else one for one in rows.runs
    ]
    bars = [one.id for one in runs if one.instrument == "ballbar"]
    assert len({one.session for one in runs if one.instrument == "ballbar"}) > 1
    zeros = np.random.default_rng(3).normal(0.0, 3e-4, len(runs))
    values = SIGMA * np.random.default_rng(4).standard_normal(rows.size) + zeros[rows.run] + size * places(*bars)
    null = null_of(given().model, replace(rows, runs=tuple(runs)), values, 1e3 * SIGMA)
    (off,) = instruments_off(null, np.zeros(null.rows.size))
    assert off.effect == Effect(kind="ballbar_length")
    assert off.values == pytest.approx([size], abs=5e-4)
