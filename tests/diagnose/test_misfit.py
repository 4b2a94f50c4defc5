"""Where no errors of the machine fit a run, the diagnosis names the run, and nothing beside it."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from tests.diagnose.prepared import SMALL, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from trueaxis.diagnose.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnose.result import ErrorNow, FloatArray
from trueaxis.diagnose.rows import Rows
from trueaxis.effects.kind import Effect
from trueaxis.runtime.effect_values import EffectValues
from trueaxis.runtime.errors import Fit


def test_the_machine_is_extended_by_what_was_named() -> None:
    case = prepared(Case(3, design=SMALL, effects=(Hidden("backlash", "EYY", size=0.02),), given="exact"))
    extending: list[EffectValues] = []

    def identify(
        rows: Rows, signal: FloatArray, effects: Sequence[EffectValues]
    ) -> tuple[tuple[ErrorNow, ...], Fit | None]:
        assert not signal.any()
        extending.extend(effects)
        return (), None

    said = diagnose(case.model, case.data, DiagnoseOptions(identify=identify))
    assert said.misfits == ()
    (one,) = extending
    assert one.effect == said.causes[0].effect == Effect("backlash", "EYY")
    assert one.parameters == {each.name: each.value for each in said.causes[0].parameters}


PLAN = Design(lines=4, repeats=2, targets=15, samples=36)


@pytest.mark.parametrize("wrong", [("X2-1",), ("X2-1", "X2-2")])
def test_runs_that_belong_elsewhere_are_named_and_neither_a_cause_nor_stale_values(wrong: tuple[str, ...]) -> None:
    """One of the repeats, or all, which agree with one another."""
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
