"""What the base holds: an effect where it is far likelier than stale values, stale values where it is not."""

from dataclasses import replace

import numpy as np
import pytest

from tests.diagnosis.prepared import SIGMA, FloatArray, Prepared, prepared
from tests.hidden_effects.case import Case
from tests.hidden_effects.design import Design
from trueaxis.diagnosis.causes.signature import readings_of
from trueaxis.diagnosis.causes.signatures import parameter_signature
from trueaxis.diagnosis.extend import named_effects
from trueaxis.diagnosis.null_model import noise
from trueaxis.diagnosis.procedure import diagnose
from trueaxis.diagnosis.result import Diagnosis
from trueaxis.effects.kind import Effect
from trueaxis.reporting.diagnosis.text import summary_text
from trueaxis.reporting.diagnosis.words import headline

PLAN = Design(lines=2, repeats=2, targets=15, ball_bar=False)
BENT = Effect(
    kind="cross_axis", component="EXX", axis="Y"
)  # of two lines any curve of EXX and of a tilt would do the same


def given() -> Prepared:
    return prepared(Case(seed=5, design=PLAN, noise="none", given="exact"))


def said(added: FloatArray) -> Diagnosis:
    """added: (n,), mm, to readings of the machine as given."""
    case = given()
    readings = case.data.readings
    scatter = SIGMA * np.random.default_rng(3).standard_normal(readings.reading.size)
    return diagnose(
        case.model, replace(case.data, readings=replace(readings, reading=readings.reading + scatter + added))
    )


def test_an_effect_that_curves_could_imitate_is_named_instead_of_what_they_would_change() -> None:
    case = given()
    signal, _ = parameter_signature(readings_of(case.model, case.rows), BENT, np.array([1e-2]))
    found = said(signal)
    assert BENT.label in {
        one.label for cause in found.causes for one in (cause.effect, *(rival.effect for rival in cause.rivals))
    }
    assert found.stale == ()
    # no reading shows more than new values would explain: it is named beside them, and extends no machine
    assert found.verdict == "ambiguous"
    assert all(cause.or_changed and not cause.alone for cause in found.causes)
    assert named_effects(found) == ()
    assert "or changed values of " in headline(found)
    assert "held-out RMS no lower than with new values of the errors" in summary_text(found)


def test_noise_that_errors_as_large_as_expected_tell_names_nothing_instead(monkeypatch: pytest.MonkeyPatch) -> None:
    """How likely the changes are was said already: a worn place was a cyclic error of a third of a metre."""
    monkeypatch.setattr(noise, "REPEATS", noise.EXPECTED)
    case = given()
    signal, _ = parameter_signature(readings_of(case.model, case.rows), BENT, np.array([1e-2]))
    found = said(signal)
    assert found.causes == ()
    assert found.stale


@pytest.mark.parametrize("size", [4e-3, -1.5e-2])
def test_wear_stays_wear(size: float) -> None:
    case = given()
    readings = readings_of(case.model, case.rows)
    off = np.minimum(np.abs(case.rows.positions[1] - 400.0) / 200.0, 1.0)
    change = 0.5 * size * (1.0 + np.cos(np.pi * off))
    found = said(readings.sensitivity[readings.model.components.index("EYY")] * change)
    assert found.verdict == "recalibrate"
    assert found.causes == ()
    assert [one.component for one in found.stale] == ["EYY"]
