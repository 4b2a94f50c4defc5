from dataclasses import replace
from typing import get_args

import pytest

from tests.diagnose.report import builders
from trueaxis.diagnose.report.text import summary_text
from trueaxis.diagnose.result import LACK_OF_FIT, Check, Verdict
from trueaxis.effects.kind import Effect


@pytest.mark.parametrize("verdict", get_args(Verdict))
def test_the_verdict_is_the_first_word(verdict: Verdict) -> None:
    text = summary_text(builders.diagnosis(verdict))
    assert text.startswith(f"{verdict}: ")
    assert text.endswith("\n")
    assert text.isascii()
    assert "warning: run X-2 has one outlier; it was left out\n" in text


def test_a_cause_on_the_console() -> None:
    lines = summary_text(builders.diagnosis("ambiguous")).splitlines()
    for line in (
        "  where: positioning error of the X axis (EXX)",
        "  term: width/2*direction",
        "  width = 6.10 um +/- 0.20 um (k = 2)",
        "  evidence: p 1e-12, 2.10 um RMS, held-out RMS lower by 84 %",
        "  cannot be told from: Servo lag in EXX",
        "  what would tell: circles in XY at another feed, both directions",
        "RMS: given 4.10, refitted 3.20, extended 0.310 um; noise floor 0.300 um",
    ):
        assert line in lines


def test_an_own_kind_is_told_by_its_formula() -> None:
    diagnosis = builders.diagnosis("explained")
    own = replace(diagnosis.causes[0], effect=Effect("table_sag", "EZY"), remainder=True)
    text = summary_text(replace(diagnosis, causes=(own,)))
    assert f"term: {own.formula}\n" in text
    assert "a remainder is left that this cause does not explain" in text


def test_structure_without_a_cause_is_described() -> None:
    text = summary_text(builders.diagnosis("unexplained_structure"))
    assert "looks like: odd in direction: structure that changes sign with the direction (3.00 um RMS, p 1e-9)" in text
    assert "cause" not in text.replace("no cause is named", "")


def test_of_many_classes_the_largest_are_named_and_the_others_counted() -> None:
    """One structure makes many fire; that all together is too much is the least telling of them."""
    diagnosis = builders.diagnosis("unexplained_structure")
    checks = [Check(f"class {k}", "seen so", 1e-9, fired=True, rms=k * 1e-3) for k in range(1, 8)]
    checks.append(Check(LACK_OF_FIT, "too much", 1e-9, fired=True, rms=1.0))
    lines = [line for line in summary_text(replace(diagnosis, checks=tuple(checks))).splitlines() if "looks" in line]
    assert [line.split(": ")[1] for line in lines[:5]] == [f"class {k}" for k in (7, 6, 5, 4, 3)]
    assert lines[5:] == ["looks like: 3 more classes, smaller or the same seen otherwise (report.html)"]
