import json
import math
from dataclasses import replace
from typing import Any, get_args

import numpy as np
import pytest

from tests.reporting.diagnosis import builders
from trueaxis.diagnosis.result import Verdict
from trueaxis.reporting.diagnosis.json_file import diagnosis_json, noise


def load(verdict: Verdict) -> dict[str, Any]:
    text = diagnosis_json(builders.diagnosis(verdict), "dmu60p.toml", "errors.json")
    loaded: dict[str, Any] = json.loads(text, parse_constant=pytest.fail)  # NaN and Infinity are no JSON
    return loaded


@pytest.mark.parametrize("verdict", get_args(Verdict))
def test_the_keys_of_the_contract(verdict: Verdict) -> None:
    told = load(verdict)
    assert told["schema"] == 1
    assert told["verdict"] == verdict
    assert told["noise_um"] == pytest.approx(0.3, rel=0.01)
    assert told["gain"].keys() >= {"rms_um", "held_out_rms_um", "held_out"}
    assert (told["gain"]["held_out_standardised"], told["gain"]["floor_um"]) == (1.03, pytest.approx(0.3))
    for stage in ("rms_um", "held_out_rms_um"):
        assert list(told["gain"][stage]) == ["given", "refitted", "extended"]
    assert told["gain"]["held_out"] == "whole runs left out, one at a time"
    assert (told["extended_machine"], told["extended_errors"]) == ("dmu60p.toml", "errors.json")
    assert isinstance(told["causes"], list)


def test_a_cause_as_the_contract_has_it() -> None:
    (cause,) = load("explained")["causes"]
    assert (cause["effect"], cause["component"]) == ("backlash", "EXX")
    assert cause["parameters"] == {"width": {"value": 0.0061, "u": 0.0001, "unit": "mm"}}
    assert cause["evidence"]["p_value"] == 1e-12
    assert cause["evidence"]["held_out_gain"] == 0.84
    assert cause["evidence"]["rms_um"] == pytest.approx(2.1)
    assert cause["cannot_be_told_from"] == []


def test_stale_values_as_the_contract_has_them() -> None:
    of_curve, of_joint = load("recalibrate")["stale"]
    assert of_curve == {
        "component": "EYY",
        "from": 300.0,
        "to": 400.0,
        "value": 0.0007,
        "u": 0.0001,
        "unit": "mm",
        "p_value": 1e-9,
        "from_straight_line": False,
        "cannot_be_told_from": [],
    }
    assert (of_joint["from"], of_joint["to"], of_joint["unit"]) == (None, None, "rad")
    assert load("explained")["stale"] == []


def test_checks_carry_an_id_and_their_place() -> None:
    quiet, fired = load("unexplained_structure")["checks"]
    assert (quiet["id"], quiet["place"], quiet["fired"]) == ("line_by_line", "X", False)
    assert (fired["id"], fired["place"], fired["fired"]) == ("line_direction", "X", True)
    assert fired["check"] == "lines of X, between directions"


def test_rivals_are_named_as_causes_are() -> None:
    (cause,) = load("ambiguous")["causes"]
    (rival,) = cause["cannot_be_told_from"]
    assert (rival["effect"], rival["component"]) == ("servo_lag", "EXX")
    assert cause["separating"].startswith("circles in XY at another feed, both directions, separates it from servo_lag")


def test_gains_are_micrometres() -> None:
    assert load("explained")["gain"]["rms_um"] == pytest.approx({"given": 4.1, "refitted": 3.2, "extended": 0.31})


def test_what_is_no_number_is_null() -> None:
    told = load("explained")
    limits = {one["effect"]: one for one in told["limits"]}
    assert limits["cross_axis"]["detection"] is None
    assert limits["cross_axis"]["nearest"] is None
    assert limits["laser_cosine"]["isolation"] is None
    assert told["noise"][1]["freedom"] is None
    evidence = {one["effect"]: one["evidence"] for one in told["evidence"]}
    assert evidence["cross_axis"] is None
    assert evidence["backlash"] == 10.3


def test_axis_runs_and_end_are_told_where_an_effect_has_them() -> None:
    limits = {one["effect"]: one for one in load("explained")["limits"]}
    assert limits["cross_axis"]["axis"] == "Y"
    assert limits["laser_cosine"]["runs"] == ["X-2", "X-3"]
    assert limits["laser_cosine"]["of"] == "instrument"
    assert "component" not in limits["laser_cosine"]
    assert "of" not in limits["backlash"]
    assert limits["point_offset"]["end"] == "target"
    assert "axis" not in limits["backlash"]


def test_numbers_of_numpy_are_numbers() -> None:
    diagnosis = builders.diagnosis("no_discrepancy")
    check = replace(diagnosis.checks[0], p_value=np.float64(np.nan), fired=np.bool_(True))  # type: ignore[arg-type]
    told = json.loads(diagnosis_json(replace(diagnosis, checks=(check,)), None, None))
    assert told["checks"][0]["fired"] is True
    assert told["checks"][0]["p_value"] is None
    assert told["extended_machine"] is None


def test_the_noise_is_that_of_the_readings_and_not_of_the_instruments() -> None:
    diagnosis = builders.diagnosis("no_discrepancy")
    laser, bar = diagnosis.noise
    data = diagnosis.residuals
    share = float(np.mean(data.run < 9))  # nine lines, then the circles
    loud = replace(diagnosis, noise=(replace(laser, white=0.004, correlated=0.003), replace(bar, white=0.0)))
    assert noise(loud) == pytest.approx(0.005 * math.sqrt(share))
    assert math.isnan(noise(replace(diagnosis, noise=())))


def test_minus_signs_are_those_that_programs_read() -> None:
    diagnosis = builders.diagnosis("explained")
    (run,) = diagnosis.next_runs
    assert run.told is not None
    below = replace(run, told=replace(run.told, with_run=-0.3e-3))
    told = diagnosis_json(replace(diagnosis, next_runs=(below,)), None, None)
    assert "-0.30\N{NO-BREAK SPACE}\N{MICRO SIGN}m with it" in json.loads(told)["next_runs"][0]["gain"]
    assert "\N{MINUS SIGN}" not in told
