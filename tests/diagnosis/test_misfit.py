"""Where no errors of the machine fit a run, the diagnosis names the run, and nothing beside it."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis import extend, procedure
from trueaxis.diagnosis.extend import Anew, Extend
from trueaxis.diagnosis.judging.misfit import Known, misfits
from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.outliers import null_of
from trueaxis.diagnosis.null_model.rows import rows_of
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.model.model import MachineModel
from trueaxis.reporting.diagnosis.text import summary_text

FEW = Design(lines=4, repeats=2, targets=11, samples=24)
X2 = ("X2-1", "X2-2")


def with_line_elsewhere(given: Prepared, wrong: tuple[str, ...]) -> MeasuredData:
    """Its readings are 0.1 mm off, all repeats alike."""
    readings = given.data.readings
    there = np.isin(readings.run, [readings.run_ids.index(name) for name in wrong])
    other = 0.1 * np.sin(readings.positions[given.model.axes.index(wrong[0][0])] / 40.0)
    return replace(given.data, readings=replace(readings, reading=readings.reading + other * there))


@pytest.mark.parametrize(("seed", "lines"), [(3, 3), (3, 4), (4, 4)])
def test_a_line_that_belongs_elsewhere_is_named_on_few_lines_and_targets(seed: int, lines: int) -> None:
    """All of its repeats, which agree with one another; not as the set-up of another line, nor beside a cause, nor as
    two causes that together are any curve of one line of four.
    """
    plan = replace(FEW, lines=lines)
    given = prepared(Case(seed, design=plan, effects=(Hidden("backlash", "EYY", size=0.01),), given="exact"))
    said = diagnose(given.model, with_line_elsewhere(given, X2))
    assert said.misfits == X2
    assert (said.verdict, said.causes, said.stale) == ("unexplained_structure", (), ())
    assert said.gain.rms.extended == pytest.approx(said.gain.rms.refitted)


def test_runs_that_no_values_fit_take_the_names_back(monkeypatch: pytest.MonkeyPatch) -> None:
    """As the values that are identified anew tell them, without another search."""
    given = prepared(
        Case(3, design=replace(FEW, lines=2), effects=(Hidden("backlash", "EYY", size=0.02),), given="exact")
    )
    seen: list[Diagnosis] = []

    def with_misfit(model: MachineModel, data: MeasuredData, found: Diagnosis, extend: Extend) -> Anew:
        seen.append(found)
        return Anew(misfits=("X1-1",))

    monkeypatch.setattr(procedure, "identified_anew", with_misfit)
    said = diagnose(given.model, given.data, DiagnoseOptions(extend=lambda _: given.model))
    assert [one.effect.component for one in seen[0].causes] == ["EYY"]
    assert (said.verdict, said.misfits, said.causes, said.values) == ("unexplained_structure", ("X1-1",), (), None)


def test_causes_are_told_where_the_values_of_the_machine_with_them_do_not_stand_still(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The diagnosis was lost with them."""
    given = prepared(Case(3, design=FEW, effects=(Hidden("servo_lag", "EXX", size=1e-4),), given="exact"))

    def restless(*_: object) -> None:
        raise NotConvergedError((), 30)

    monkeypatch.setattr(extend, "reidentified", restless)
    said = diagnose(given.model, given.data, DiagnoseOptions(extend=lambda _: given.model))
    assert [one.effect.component for one in said.causes] == ["EXX"]
    assert (said.verdict, said.values, said.settled) == ("explained", None, False)
    assert "no extended machine is written" in summary_text(said)


def null_model(given: Prepared, data: MeasuredData) -> Null:
    rows, model = rows_of(data), given.model
    expected = expected_readings(model, rows.runs, rows.run, rows.positions, rows.context)
    return null_of(model, rows, rows.reading - expected, None)


def named(given: Prepared, data: MeasuredData) -> tuple[str, ...]:
    null = null_model(given, data)
    nothing = np.zeros((null.rows.size, 0))
    return misfits(null, Known(nothing, nothing))


@pytest.mark.parametrize("machine", ["table_mill", "gantry"])
@pytest.mark.parametrize("seed", range(3))
def test_sound_runs_are_not_named_and_one_repeat_of_a_wrong_scale_is(machine: str, seed: int) -> None:
    source = np.random.default_rng(seed)
    plan = Design(
        lines=int(source.integers(2, 5)),
        repeats=int(source.integers(1, 4)),
        targets=int(source.integers(5, 16)),
        diagonals=bool(seed % 2),
        ball_bar=seed != 1,
        samples=24,
        feeds=(1000.0,),
    )
    given = prepared(Case(seed, machine=machine, design=plan, given="exact"))
    assert named(given, given.data) == ()
    readings = given.data.readings
    wrong = str(source.choice([name for name in readings.run_ids if name[0] in "XYZ" and "F" not in name]))
    there = readings.run == readings.run_ids.index(wrong)
    scaled = replace(readings, reading=np.where(there, 300.0, 1.0) * readings.reading)
    assert named(given, replace(given.data, readings=scaled))[:1] == (wrong,)


@pytest.mark.parametrize("seed", [0, 2, 3])
@pytest.mark.parametrize("run", [0, 9])
def test_a_run_noisier_than_its_instrument_is_no_wrong_run(seed: int, run: int) -> None:
    """Its noise is as large in what no error of a machine could be. As large and smooth it is a wrong one."""
    given = prepared(Case(seed, design=FEW, given="exact"))
    null = null_model(given, given.data)
    mine, nothing = null.rows.of_run(run), np.zeros((null.rows.size, 0))
    noise = np.random.default_rng(seed).standard_normal(null.values[mine].size)
    name = null.rows.runs[null.rows.run[mine][0]].id
    smooth = np.sqrt(2.0) * np.sin(null.rows.positions[null.rows.axes.index(name[0]), mine] / 40.0)
    found = []
    for further in (2.5 * SIGMA * noise, 10.0 * SIGMA * smooth):
        values = null.values.copy()
        values[mine] += further
        found.append(misfits(replace(null, values=values), Known(nothing, nothing)))
    assert found[0] == ()
    assert name in found[1]


def test_a_single_run_has_none_to_contradict() -> None:
    given = prepared(Case(3, design=FEW, given="exact"))
    null = null_model(given, with_line_elsewhere(given, X2))
    one = null.only(null.rows.run == null.rows.run[0])
    nothing = np.zeros((one.rows.size, 0))
    assert misfits(one, Known(nothing, nothing)) == ()


def test_a_wave_far_below_the_noise_is_no_wrong_run() -> None:
    """However many readings show it."""
    plan = replace(FEW, repeats=5, targets=41, one_run=True)
    given = prepared(Case(3, design=plan, given="exact", noise="white", sigma_um=1.0))
    readings = given.data.readings
    there = readings.run == readings.run_ids.index("X2")
    wave = np.sin(readings.positions[given.model.axes.index("X")] / 40.0)
    for size, expected in ((0.5e-3, ()), (0.1, ("X2",))):
        moved = replace(readings, reading=readings.reading + size * wave * there)
        assert named(given, replace(given.data, readings=moved)) == expected


def test_what_a_cause_does_in_a_run_is_no_misfit_of_the_run() -> None:
    """But without the cause it is."""
    given = prepared(Case(3, design=FEW, given="exact"))
    null = null_model(given, with_line_elsewhere(given, X2))
    there = np.isin(null.rows.run, [given.data.readings.run_ids.index(name) for name in X2])
    signal = there * np.sin(null.rows.positions[null.rows.axes.index("X")] / 40.0)
    nothing = np.zeros((null.rows.size, 0))
    assert misfits(null, Known(signal[:, np.newaxis], nothing)) == ()
    assert misfits(null, Known(nothing, nothing)) == X2
