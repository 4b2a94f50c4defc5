"""The report names curves that may be rougher than their orders can follow."""

import pytest

from tests.generator.machine import sine
from tests.identification.data import dmu60p_model, mixed_data, with_estimation
from tests.identification.test_instrument_notes import GIVEN
from trueaxis.identification.estimated import identify_estimated
from trueaxis.identification.report import Identification


def named(found: Identification) -> str:
    """The curves of the note, empty where there is none."""
    notes = [note for note in found.report.notes if "waves as fine as the curve can follow" in note]
    return notes[0] if notes else ""


@pytest.mark.parametrize("degree", [3, None])
def test_curves_that_end_at_an_order_which_readings_tell_are_named(degree: int | None) -> None:
    """EXX has one wave over its travel: three orders nearly follow it, 14 or more do."""
    data = mixed_data({"EXX": sine(0.02, 540.0), "EYX": sine(0.01, 1000.0)}, 21, seed=1)
    note = named(identify_estimated(dmu60p_model(), data, with_estimation(GIVEN, degree=degree)))
    if degree is None:
        assert not note
    else:
        assert "EXX" in note
        assert "(order 3)" in note
        assert "--degree 28 takes more orders" in note
