"""Where no errors of the machine fit a run, the diagnosis names the run, and nothing beside it."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SMALL, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose

PLAN = Design(lines=4, repeats=2, targets=15, samples=36)


def test_runs_that_belong_elsewhere_are_named_and_neither_a_cause_nor_stale_values() -> None:
    """All repeats of a line, which agree with one another."""
    wrong = ("X2-1", "X2-2")
    case = prepared(Case(3, design=PLAN, effects=(Hidden("backlash", "EYY", size=0.01),), given="exact"))
    readings = case.data.readings
    there = np.isin(readings.run, [readings.run_ids.index(name) for name in wrong])
    other = 0.1 * np.sin(readings.positions[case.model.axes.index("X")] / 40.0)
    said = diagnose(
        case.model, replace(case.data, readings=replace(readings, reading=readings.reading + other * there))
    )
    assert said.misfits[: len(wrong)] == wrong  # what nobody names beside them may make others differ, too
    assert (said.verdict, said.causes, said.stale) == ("unexplained_structure", (), ())
    assert said.gain.rms.extended == pytest.approx(said.gain.rms.refitted)


def test_runs_that_are_known_to_be_wrong_take_the_names_back() -> None:
    """By an estimate of all errors, which sees a reversed sign."""
    case = prepared(Case(3, design=SMALL, effects=(Hidden("backlash", "EYY", size=0.02),), given="exact"))
    said = diagnose(case.model, case.data, DiagnoseOptions(misfits=("X1-1",)))
    assert (said.verdict, said.misfits, said.causes) == ("unexplained_structure", ("X1-1",), ())
