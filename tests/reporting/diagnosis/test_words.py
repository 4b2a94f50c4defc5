import math

import pytest

from trueaxis.diagnosis.result import Gain, Stage
from trueaxis.effects.kind import Effect
from trueaxis.identification.words import enumerated
from trueaxis.reporting.diagnosis.gain_words import held_out_warning
from trueaxis.reporting.diagnosis.quantity import (
    ascii_only,
    equals_p,
    percent,
    probability,
    quantity,
    with_expanded,
    written,
)
from trueaxis.reporting.diagnosis.words import effect_title, in_words, joint


@pytest.mark.parametrize(
    ("value", "u", "unit", "told"),
    [
        (0.0061, 0.0002, "mm", "6.10 um +/- 0.40 um (k = 2)"),
        (10.0, 0.013, "mm", "10.000 mm +/- 0.026 mm (k = 2)"),
        (-0.000123456, 0.0000021, "mm", "-0.1235 um +/- 0.0042 um (k = 2)"),
        (12e-6, 1.1e-6, "rad", "12.0 urad +/- 2.2 urad (k = 2)"),
        (1.234, 0.05, "rad", "1.23 rad +/- 0.10 rad (k = 2)"),
        (0.0004, 0.00001, "s", "0.400 ms +/- 0.020 ms (k = 2)"),
        (1.1e-5, 1e-7, "mm/mm/K", "11.00 um/m/K +/- 0.20 um/m/K (k = 2)"),
        (2e-6, 1e-7, "1", "2.00 um/m +/- 0.20 um/m (k = 2)"),
        (1e-6, 1e-7, "mm/s", "3.60 um/h +/- 0.72 um/h (k = 2)"),
        (0.002, 0.0001, "mm/K", "2.00 um/K +/- 0.20 um/K (k = 2)"),
        (0.5, 150.0, "mm", "0 mm +/- 300 mm (k = 2)"),
        (60188.0, 95737.0, "s", "60000 s +/- 190000 s (k = 2)"),
        (0.0061, math.nan, "mm", "6.10 um"),
        (0.5, 0.05, "1", "0.50 +/- 0.10 (k = 2)"),
    ],
)
def test_a_size_with_its_expanded_uncertainty(value: float, u: float, unit: str, told: str) -> None:
    assert ascii_only(with_expanded(value, u, unit)) == told


def test_numbers_without_an_end() -> None:
    assert quantity(math.nan, "mm") == "unknown"
    assert ascii_only(quantity(0.0, "mm")) == "0 um"
    assert ascii_only(probability(0.0)) == "below 1e-12"
    assert probability(0.034) == "0.034"


@pytest.mark.parametrize(
    ("effect", "title", "where"),
    [
        (Effect(kind="backlash", component="EXX"), "Backlash in EXX", "positioning error of the X axis (EXX)"),
        (Effect(kind="backlash", component="ECC"), "Backlash in ECC", "positioning error of the C axis (ECC)"),
        (Effect(kind="cyclic", component="EYX"), "Cyclic in EYX", "straightness of the X axis in Y (EYX)"),
        (Effect(kind="drift", component="EXC"), "Drift in EXC", "error motion of the C axis in X (EXC)"),
        (Effect(kind="drift", component="EAZ"), "Drift in EAZ", "rotation of the Z axis about X (EAZ)"),
        (
            Effect(kind="cross_axis", component="EXX", axis="Y"),
            "Cross axis in EXX with Y",
            "positioning error of the X axis (EXX)",
        ),
        (
            Effect(kind="squareness", component="EC0X"),
            "Squareness in EC0X",
            "squareness: location error EC of the X axis (EC0X)",
        ),
        (Effect(kind="laser_scale"), "Laser scale", "readings of the instrument"),
        (Effect(kind="laser_cosine", runs=("X1", "X2")), "Laser cosine of X1, X2", "readings of X1, X2"),
        (
            Effect(kind="point_offset", runs=("X1",), end="reference"),
            "Point offset of the reference of X1",
            "set-up of X1",
        ),
    ],
)
def test_an_effect_in_words(effect: Effect, title: str, where: str) -> None:
    assert effect_title(effect) == title
    assert joint(effect) == where


def test_lists_in_words() -> None:
    assert [enumerated(list("abc"[:n]), "or") for n in range(4)] == ["", "a", "a or b", "a, b or c"]


def test_numbers_for_people_and_their_console_form() -> None:
    for told, people, console in (
        (written(-0.031, ".2g"), "\N{MINUS SIGN}0.031", "-0.031"),
        (written(-0.001, ".2f"), "0.00", "0.00"),
        (written(9.31, "+.1f"), "+9.3", "+9.3"),
        (written(math.nan, ".2f"), "\N{EN DASH}", "-"),
        (probability(2.34e-12), "2.3 \u00d7 10\u207b\u00b9\u00b2", "2.3e-12"),
        (equals_p(2.34e-12), "p = 2.3 \u00d7 10\u207b\u00b9\u00b2", "p = 2.3e-12"),
        (equals_p(1.0), "p above 0.5", "p above 0.5"),
        (equals_p(0.0), "p below 1 \u00d7 10\u207b\u00b9\u00b2", "p below 1e-12"),
        (percent(-0.031), "\N{MINUS SIGN}3 %", "-3 %"),
        (with_expanded(-0.0061, 0.0002, "mm"), "\N{MINUS SIGN}6.10 \u00b5m \u00b1 0.40 \u00b5m (k = 2)",
         "-6.10 um +/- 0.40 um (k = 2)"),
    ):  # fmt: skip
        assert told.replace("\N{NO-BREAK SPACE}", " ") == people
        assert ascii_only(told) == console


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "tell cross_axis EYY with Z from laser_cosine of Y4-1",
            "tell cross axis in EYY with Z from laser cosine of Y4-1",
        ),
        ("backlash_slope EC0X and backlash EAX", "backlash slope in EC0X and backlash in EAX"),
        ("without time_s: warm_up and my_own cannot be seen", "without time_s: warm up and my own cannot be seen"),
        ("structure is left (0.31 um in all)", "structure is left (0.31 \u00b5m in all)"),
        ("the run my_own_warm_up", "the run my_own_warm_up"),
    ],
)
def test_labels_in_words_and_nothing_else(text: str, told: str) -> None:
    assert in_words(text, {"my_own"}).replace("\N{NO-BREAK SPACE}", " ") == told


def test_a_held_out_figure_above_that_of_the_given_values_is_explained() -> None:
    said = held_out_warning(gain((0.4, 0.3, 0.9), 2.5))
    assert said.startswith(
        "held-out readings are predicted worse (extended 0.900 um) than by the given values (0.400 um): "
    )
    assert "they show something that the other readings do not" in said
    assert held_out_warning(gain((0.4, 0.5, 0.45), 1.02)) == ""  # as uncertain as it is said to be


@pytest.mark.parametrize("held", [(0.4, 0.39, 0.3), (0.4, 0.4000001, 0.4), (math.nan, math.nan, math.nan)])
def test_where_none_is_nothing_is_said(held: tuple[float, float, float]) -> None:
    assert held_out_warning(gain(held, 1.0)) == ""


def gain(held: tuple[float, float, float], standardised: float) -> Gain:
    """held: um."""
    return Gain(
        rms=Stage(1e-3, 1e-3, 1e-3),
        held_out=Stage(*(1e-3 * one for one in held)),
        split="whole runs",
        floor=3e-4,
        standardised=standardised,
    )
