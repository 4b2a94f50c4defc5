"""Grades by hand: a campaign that counts wrongly would prove anything."""

import pytest

from tests.hidden_effects.power.grade import Name, Said, grade, upper_limit

A, B, C = Name("backlash", "EXX"), Name("cyclic", "EYY"), Name("drift", "EZZ")


@pytest.mark.parametrize(
    ("truth", "said", "expected"),
    [
        ((A,), Said("explained", ((A,),)), "unique"),
        ((A,), Said("ambiguous", ((A, B),)), "in set"),
        ((A,), Said("ambiguous", ((B, A),)), "in set"),
        ((A,), Said("explained", ((B,),)), "wrong"),
        ((A,), Said("explained", ((A,), (B,))), "wrong"),
        ((A,), Said("unexplained_structure", ((B,),)), "wrong"),
        ((A,), Said("unexplained_structure"), "unexplained"),
        ((A,), Said("unexplained_structure", ((A,),)), "unexplained"),
        ((A,), Said("recalibrate"), "silent"),
        ((A, B), Said("explained", ((A,), (B,))), "unique"),
        ((A, B), Said("ambiguous", ((A,), (B, C))), "in set"),
        ((A, B), Said("explained", ((A,),)), "partial"),
        ((A, B), Said("ambiguous", ((A, B),)), "partial"),
        ((), Said("explained", ((A,),)), "wrong"),
        ((), Said("no_discrepancy"), "silent"),
        ((), Said("failed: IndexError()"), "failed"),
    ],
)
def test_grades(truth: tuple[Name, ...], said: Said, expected: str) -> None:
    assert grade(truth, said) == expected


def test_upper_limits_are_those_of_the_tables() -> None:
    assert upper_limit(0, 300) == pytest.approx(1 - 0.05 ** (1 / 300), rel=1e-9)  # the rule of three
    assert upper_limit(4, 920) == pytest.approx(0.00993, abs=2e-5)
    assert upper_limit(3, 3) == 1.0
