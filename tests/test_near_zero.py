"""Zeros of reports: what rounding leaves is 0, what an instrument may see stays."""

import pytest

from trueaxis.identification.words import small
from trueaxis.io.safe_text import plain_zero
from trueaxis.reporting.diagnosis.quantity import quantity


@pytest.mark.parametrize("value", [0.0, -0.0, 3.5e-22, -8e-24])
def test_what_rounding_leaves_is_zero(value: float) -> None:
    assert str(plain_zero(value)) == "0.0"
    assert small(value, "mm") == "0 um"
    assert small(value, "rad/mm") == "0 urad/mm"
    assert quantity(value, "rad").startswith("0")
    assert "10" not in quantity(value, "mm")


def test_small_values_stay() -> None:
    assert small(2e-9, "mm") == "2e-06 um"
    assert small(-4e-7, "rad") == "-0.4 urad"
    assert quantity(3e-9, "1/s").startswith("3")  # no length and no angle: it may be small without being zero
