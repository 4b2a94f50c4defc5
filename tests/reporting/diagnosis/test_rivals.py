"""Rivals of a cause in words: other effects by their names, the same effect by its period."""

from dataclasses import replace

from tests.reporting.diagnosis import builders
from trueaxis.diagnosis.result import Estimate, Evidence
from trueaxis.reporting.diagnosis.quantity import ascii_only
from trueaxis.reporting.diagnosis.tables import rivals
from trueaxis.reporting.diagnosis.text import summary_text
from trueaxis.reporting.diagnosis.words import headline


def rival(pitch: float) -> Evidence:
    return Evidence(
        effect=builders.CYCLIC,
        evidence=50.0,
        p_value=1e-50,
        tries=40.0,
        freedom=2,
        parameters=(Estimate("pitch", pitch, 0.016, "mm"),),
        differs_by="pitch",
    )


def test_pitches_that_cannot_be_told_apart_are_listed_with_the_digits_that_are_known() -> None:
    pitches = [21.091, 10.4, 31.01, 12.7, 8.8, 66.3]
    cause = replace(
        builders.cause(builders.CYCLIC),
        parameters=(Estimate("amplitude", 1.8e-3, 1e-4, "mm"), Estimate("pitch", 16.0, 0.016, "mm")),
        rivals=(*map(rival, pitches), builders.RIVAL),
    )
    found = replace(builders.diagnosis("ambiguous"), causes=(cause,))
    assert ascii_only(headline(found)) == (
        "Cyclic in EYY of pitch 16.000 mm, 21.091 mm, 10.400 mm, 31.010 mm or 3 more or Servo lag in EXX: "
        "these readings cannot tell which."
    )
    said = summary_text(found)
    assert (
        "cannot be distinguished from: pitch 21.091 mm, pitch 10.400 mm, pitch 31.010 mm, pitch 12.700 mm, 3 more"
        in said
    )
    assert [ascii_only(row[0]) for row in rivals(cause).rows[1:3]] == ["pitch 21.091 mm", "pitch 10.400 mm"]
