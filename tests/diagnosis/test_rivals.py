"""Periods that readings cannot tell apart are rivals of one another; one alone is right."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.pitches import WITHIN, drawn, graded
from trueaxis.diagnosis.extend import named_effects
from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose
from trueaxis.diagnosis.result import Cause, Diagnosis
from trueaxis.reporting.diagnosis.text import summary_text

LINES = Design(lines=2, repeats=3, targets=23, off=5.0, ball_bar=False)  # 68 mm apart on the gantry
PITCH = 16.0  # mm


def diagnosed(design: Design, seed: int = 1) -> Diagnosis:
    effect = Hidden("cyclic", "EXX", size=1.8e-3, shape=seed, pitch=PITCH)
    case = Case(seed, machine="gantry", design=design, noise="white", sigma_um=0.4, given="exact", effects=(effect,))
    given = prepared(case)
    return diagnose(given.model, given.data)


def pitches(cause: Cause) -> list[tuple[float, float]]:
    sets = (cause.parameters, *(one.parameters for one in cause.rivals))
    return [(one.value, one.u) for parameters in sets for one in parameters if one.name == "pitch"]


@pytest.mark.parametrize("seed", [1, 2])
def test_targets_off_an_even_spacing_tell_one_pitch_and_leave_nothing_stale(seed: int) -> None:
    said = diagnosed(LINES, seed)
    (cause,) = said.causes
    ((value, u),) = pitches(cause)
    assert abs(value - PITCH) <= WITHIN * u
    assert (said.verdict, said.stale) == ("explained", ())


def test_even_targets_leave_all_aliases_and_a_line_at_other_targets_would_tell() -> None:
    """One over each pitch is that of the true one, plus or minus multiples of one over the distance of targets."""
    said = diagnosed(replace(LINES, off=0.0))
    (cause,) = said.causes
    found = pitches(cause)
    step = 1490.0 / 22  # mm
    turns = np.array([step / value for value, _ in found])
    away = np.abs(turns - np.round(turns)) - abs(step / PITCH - round(step / PITCH))
    assert len(found) > 50  # two for each multiple, from 2 mm on
    assert np.abs(away).max() < 0.01
    assert min(abs(value - PITCH) / u for value, u in found) < WITHIN
    assert said.verdict == "ambiguous"
    assert named_effects(said) == ()
    assert cause.separating is not None
    assert "irregular distances" in cause.separating.run
    assert len(cause.separating.left) < 0.1 * len(found)
    assert "these readings cannot tell which" in summary_text(said)


def test_what_differs_by_less_than_forms_do_is_a_rival_however_large() -> None:
    """Along lines an error decays alike over the way, the path and the time; a hundred times the noise tells the forms
    apart, but no real error has one of them.
    """
    effect = Hidden("reversal_spike", "EXX", size=50e-3)
    design = replace(LINES, repeats=2)
    case = Case(1, machine="gantry", design=design, noise="white", sigma_um=0.3, given="exact", effects=(effect,))
    given = prepared(case)
    (cause,) = diagnose(given.model, given.data).causes
    found = [cause.effect, *(one.effect for one in cause.rivals)]
    assert {one.kind for one in found} == {"reversal_spike", "reversal_spike_path", "reversal_spike_time"}
    assert {one.component for one in found} == {"EXX"}


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 41))
def test_a_pitch_that_is_named_alone_is_right_on_plans_drawn_at_random(seed: int) -> None:
    case = drawn(seed)
    given = prepared(case)
    answer = graded(case, diagnose(given.model, given.data, DiagnoseOptions(ahead=False)))
    assert answer.pitch != "wrong", answer
