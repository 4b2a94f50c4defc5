"""Records of the computation as sentences: what to measure next, and what a single reading of a line has to say."""

import math
from dataclasses import replace

import pytest

from tests.reporting.diagnosis import builders
from trueaxis.diagnosis.further_runs.of_plan import NextRun, Placed, Separating
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.result import SecondOrder
from trueaxis.reporting.diagnosis.further import Proposal, absences, proposals, separating_run, warnings
from trueaxis.reporting.diagnosis.quantity import ascii_only

LOCAL = Check(structure=StructureClass.LINE_LOCAL, place="Y", p_value=1e-9, fired=True, rms=1e-3)
NOTHING_TO_MEASURE = Check(structure=StructureClass.LACK_OF_FIT, place="laser", p_value=1e-7, fired=True, rms=1e-3)


def told(*runs: NextRun) -> list[Proposal]:
    return [*proposals(replace(builders.diagnosis("explained"), next_runs=runs))]


def test_each_run_is_proposed_once_and_nothing_where_there_is_nothing_to_measure() -> None:
    line, noise = told(
        NextRun(check=LOCAL), NextRun(check=LOCAL), NextRun(check=NOTHING_TO_MEASURE), NextRun(instrument="laser")
    )
    assert line.run.startswith("the line of Y again")
    assert line.purpose == "see whether the structure returns (lines of Y, locally)"
    assert noise.run == "every run of the laser three times"


def test_what_a_run_separates_and_from_which_size_on() -> None:
    pairs = (
        (Placed(builders.BACKLASH), (Placed(builders.LAG),)),
        (Placed(builders.CYCLIC), (Placed(builders.CROSS),)),
    )
    (one,) = told(NextRun(run="a laser diagonal", times=3, pairs=pairs, told=replace(builders.APART, without=math.inf)))
    assert one.run == "a laser diagonal, 3 times"
    assert one.purpose == "separate backlash EXX from servo_lag EXX; also cyclic EYY from cross_axis EXX with Y"
    assert ascii_only(one.gain) == "smallest distinguishable backlash EXX: 0.40 um with it, none without it"


@pytest.mark.parametrize(
    ("separating", "sentence"),
    [
        (
            replace(builders.SEPARATING, left=(Placed(builders.CYCLIC),), needed=7),
            f"{builders.CIRCLES_AGAIN}, separates it from servo_lag EXX: smallest distinguishable backlash EXX: "
            "0.40 um with it, 9.0 um without it; the size found needs it about 7 times; "
            "cyclic EYY cannot be excluded by it",
        ),
        (
            Separating(cause=Placed(builders.BACKLASH), left=(Placed(builders.LAG),), broken_by="another feed"),
            "none of the runs considered separates it from servo_lag EXX; it takes: another feed",
        ),
        (
            Separating(
                cause=Placed(builders.BACKLASH),
                left=(Placed(replace(builders.BACKLASH, component="EBX")),),
                broken_by="circles in both directions",
            ),
            "none of the runs considered separates it from backlash EBX; it takes: the same motion read with the "
            "optic, or the ball, elsewhere on the tool or on the workpiece",
        ),
    ],
)
def test_what_tells_a_cause_from_its_rivals(separating: Separating, sentence: str) -> None:
    assert ascii_only(separating_run(separating)) == sentence


def test_rivals_of_the_same_effect_go_by_their_periods() -> None:
    at = [Placed(builders.CYCLIC, {"pitch": pitch}) for pitch in (16.0, 21.091, 10.4, 31.01, 12.7, 8.8, 66.3)]
    separating = Separating(cause=at[0], run="line Y1 again", apart=tuple(at[1:]), told=builders.APART)
    said = ascii_only(separating_run(separating))
    assert said.startswith("line Y1 again, separates it from 21.09 mm, 10.4 mm, 31.01 mm, 12.7 mm and 2 more: ")
    (one,) = told(NextRun(run="line Y1 again", pairs=((at[0], (at[1],)),), told=builders.APART))
    assert ascii_only(one.purpose) == "separate cyclic EYY of 16 mm from 21.09 mm"


def test_a_noise_that_no_repeats_tell_is_warned_of() -> None:
    diagnosis = builders.diagnosis("explained")
    unsure = replace(diagnosis.noise[0], origin="courses")
    (said,) = [text for text in warnings(replace(diagnosis, noise=(unsure,))) if text.startswith("noise of the laser")]
    assert (
        said
        == "noise of the laser: nothing is repeated, from the residuals of the null model; repeat runs to determine it"
    )


def test_terms_of_second_order_of_values_that_are_all_zero_are_no_news() -> None:
    diagnosis = builders.diagnosis("explained")
    without = replace(diagnosis, second_order=SecondOrder(0.0, seen=False))
    assert len(absences(diagnosis)) == len(absences(without)) + 1
