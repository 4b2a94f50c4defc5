import math
from dataclasses import replace
from typing import get_args

import pytest

from tests.reporting.diagnosis import builders
from trueaxis.diagnosis.further_runs.of_plan import NextRun, Placed
from trueaxis.diagnosis.judging.structure import Check, StructureClass
from trueaxis.diagnosis.result import Gain, Stage, Verdict
from trueaxis.effects.kind import Effect
from trueaxis.reporting.diagnosis.text import summary_text


@pytest.mark.parametrize("verdict", get_args(Verdict))
def test_the_verdict_is_the_first_word(verdict: Verdict) -> None:
    text = summary_text(builders.diagnosis(verdict))
    assert text.startswith(f"{verdict}: ")
    assert text.endswith("\n")
    assert text.isascii()
    assert text.count("left out as outliers: 1 reading\n") == 1


def test_a_cause_on_the_console() -> None:
    lines = summary_text(builders.diagnosis("ambiguous")).splitlines()
    for line in (
        "  where: positioning error of the X axis (EXX)",
        "  term: width/2*direction",
        "  width = 6.10 um +/- 0.20 um (k = 2)",
        "  evidence: p 1e-12, 2.10 um RMS, held-out RMS lower by 84 %",
        "  cannot be distinguished from: Servo lag in EXX",
        "  run that would tell: circles in XY at another feed, both directions, separates it from servo_lag EXX: "
        "smallest distinguishable backlash EXX: 0.40 um with it, 9.0 um without it",
        "next: circles in XY at another feed, both directions, to separate backlash EXX from servo_lag EXX: smallest "
        "distinguishable backlash EXX: 0.40 um with it, 9.0 um without it",
        "RMS: given 4.10, refitted 3.20, extended 0.310 um; noise floor 0.300 um",
        "held-out residuals have 1.03 times the predicted scatter: as expected",
    ):
        assert line in lines


def test_runs_for_effects_that_are_no_causes_are_left_to_the_report() -> None:
    """The console says what to do about the verdict; which two drifts look alike does not concern a backlash."""
    drifts = tuple(Placed(Effect(kind=kind, component="EZZ")) for kind in ("drift", "thermal_offset"))
    plain = builders.diagnosis("ambiguous")
    other = replace(plain.next_runs[0], run="laser, Z moving", pairs=((drifts[0], drifts[1:]),))
    noise = NextRun(instrument="laser")
    text = summary_text(replace(plain, next_runs=(*plain.next_runs, other, noise)))
    assert "next: circles in XY at another feed" in text
    assert "next: every run of the laser three times" in text
    assert "laser, Z moving" not in text
    assert "report.html names 1 more run, to distinguish effects of which these readings show nothing\n" in text
    assert "report.html names" not in summary_text(plain)


def test_an_own_kind_is_told_by_its_formula() -> None:
    diagnosis = builders.diagnosis("explained")
    own = replace(diagnosis.causes[0], effect=Effect(kind="table_sag", component="EZY"), remainder=True)
    text = summary_text(replace(diagnosis, causes=(own,)))
    assert f"term: {own.formula}\n" in text
    assert "this cause leaves a remainder unexplained" in text


def test_structure_without_a_cause_is_described() -> None:
    text = summary_text(builders.diagnosis("unexplained_structure"))
    assert (
        "looks like: lines of X, between directions: differs by the direction of approach (3.00 um RMS, p 1e-9)" in text
    )
    assert "cause" not in text.replace("no cause is named", "").replace("no known cause explains", "")


def test_of_many_classes_the_largest_are_named_and_the_others_counted() -> None:
    """One structure makes many fire; that all together is too much is the least telling of them."""
    diagnosis = builders.diagnosis("unexplained_structure")
    checks = [
        Check(structure=StructureClass.LINE_LOCAL, place=f"X{k}", p_value=1e-9, fired=True, rms=k * 1e-3)
        for k in range(1, 8)
    ]
    checks.append(Check(structure=StructureClass.LACK_OF_FIT, place="laser", p_value=1e-9, fired=True, rms=1.0))
    lines = [line for line in summary_text(replace(diagnosis, checks=tuple(checks))).splitlines() if "looks" in line]
    assert [line.split(": ")[1] for line in lines[:5]] == [f"lines of X{k}, locally" for k in (7, 6, 5, 4, 3)]
    assert lines[5:] == ["looks like: 3 more classes, smaller or the same seen otherwise (report.html)"]


def test_stale_values_are_said_with_place_size_and_uncertainty() -> None:
    lines = summary_text(builders.diagnosis("recalibrate")).splitlines()
    assert lines[1:3] == [
        "stale: EYY from 300 to 400 mm by 0.700 um, u 0.10 um (p of the whole change 1e-9)",
        "stale: EC0X by -5.20 urad, u 0.40 urad (p of the whole change 2e-7)",
    ]
    beside = summary_text(replace(builders.diagnosis("explained"), stale=builders.STALE))
    assert "stale: EYY from 300 to 400 mm" in beside


@pytest.mark.parametrize(
    ("standardised", "judged"),
    [
        (0.6, "less than predicted: the assumed noise is too large"),
        (1.4, "more than noise and the uncertainty of the values explain"),
    ],
)
def test_a_scatter_that_is_not_as_predicted_is_said(standardised: float, judged: str) -> None:
    diagnosis = builders.diagnosis("explained")
    text = summary_text(replace(diagnosis, gain=replace(diagnosis.gain, standardised=standardised)))
    assert f"held-out residuals have {standardised:.2f} times the predicted scatter: {judged}\n" in text


def test_held_out_readings_that_tell_nothing_are_said_to() -> None:
    """All of them taken up by what is unknown of their instruments."""
    diagnosis = builders.diagnosis("explained")
    nothing = Stage(math.nan, math.nan, math.nan)
    text = summary_text(
        replace(diagnosis, gain=Gain(rms=diagnosis.gain.rms, held_out=nothing, split="3 passes", floor=3e-4))
    )
    assert "held-out RMS (3 passes): none, the zeros of their instruments absorb all of these readings\n" in text
    assert "nan" not in text
    assert "scatter" not in text


def test_readings_whose_noise_is_unknown_are_not_said_to_agree() -> None:
    found = builders.diagnosis("no_discrepancy")
    laser, ballbar = found.noise
    half = summary_text(replace(found, noise=(laser, replace(ballbar, white=0.02, origin="unknown"))))
    assert "readings of laser agree" in half
    assert "ballbar cannot be judged" in half
    none = summary_text(replace(found, noise=tuple(replace(one, origin="unknown") for one in found.noise)))
    assert "agree" not in none
    assert "cannot be judged" in none
