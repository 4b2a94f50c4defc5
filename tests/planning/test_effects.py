"""What a plan tells of the effects of the spec, against estimates from readings of the same plan."""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.estimation.test_effects import BACKLASH, COSINE, CYCLIC, KNOWN, LAG, LINEAR, THERMAL, WARM, cyclic
from tests.identification.effect_data import Term, measured, model_with
from tests.kept import derived
from tests.planning.data import ROOT, folder
from tests.planning.promise import NOISE, prior_sizes, readings
from trueaxis.cli.main import main
from trueaxis.effects.kind import Effect
from trueaxis.error_name import ErrorName
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.judgement import judged_component
from trueaxis.estimation.layout import layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.tool_point import ORIGIN
from trueaxis.identification.estimated_effects import with_uncertainty
from trueaxis.identification.weighting import NoiseModel
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.planning.judge import expected_with_effects
from trueaxis.planning.method import PlanOptions, judged_plan, proposed
from trueaxis.planning.report import ExpectedEffect, ProposalReport

PERIOD = {"amplitude": 2e-3, "phase": 1.0, "pitch": 13.7}
PLAY, BENDING = LINEAR["lateral play"][0], LINEAR["cross"][0]
TRUTH: dict[Effect, dict[str, float]] = {
    BACKLASH: {"width": 6e-3},
    PLAY: {"width": 8e-6},
    THERMAL: {"coefficient": 1.1e-5},
    BENDING: {"k": 5e-3},
    COSINE: {"angle": 4e-3},
    CYCLIC: PERIOD,
}
MILL = (
    re.sub("(?m)^runs.*", "", (ROOT / "machines" / "dmu60p.toml").read_text())
    + """
[[effect]]
kind = "backlash"
component = "EXX"

[[effect]]
kind = "cyclic"
component = "EZZ"

[[effect]]
kind = "warm_up"
component = "EYY"

[[effect]]
kind = "servo_lag"
component = "EXX"

[[effect]]
kind = "squareness"
component = "EB0X"
"""
)


@pytest.fixture(scope="module")
def clean() -> Observations:
    return measured()


def noise(observed: Observations) -> dict[int, float]:
    return dict.fromkeys(range(len(observed.runs)), NOISE)


def told(
    observed: Observations, *effects: Effect, given: ErrorValues = KNOWN, values: tuple[EffectValues, ...] = ()
) -> tuple[ExpectedEffect, ...]:
    return expected_with_effects(model_with(*effects), observed, given, noise(observed), values)[1]


def u_of(one: ExpectedEffect) -> dict[str, float]:
    return {parameter.name: np.nan if parameter.u is None else parameter.u for parameter in one.parameters}


@pytest.mark.usefixtures("values_alone")
def test_u_is_that_of_estimates_from_readings(clean: Observations) -> None:
    """Machines drawn from the prior, effects by terms of the independent generator; the estimate finds the sizes."""
    terms: dict[str, Term] = {"EZZ": cyclic}
    for name in ("backlash", "lateral play", "thermal", "cross"):
        terms |= LINEAR[name][1]
    added = measured(terms, LINEAR["angle"][2]).reading - clean.reading
    model = model_with(*TRUTH)
    at = tuple(EffectValues(effect, values) for effect, values in TRUTH.items())
    expected = dict(zip(TRUTH, told(clean, *TRUTH, values=at), strict=True))
    layout = layout_of(model.with_values(KNOWN), clean, KNOWN)
    off, ratio = [], []
    for seed in (11, 12, 13):
        machine = prior_sizes(layout) * np.random.default_rng(seed).standard_normal(layout.count)
        reading = readings(layout, replace(clean, reading=np.zeros(clean.reading.size)), machine, KNOWN, seed) + added
        found = estimate(model, replace(clean, reading=reading), KNOWN, EstimationOptions(noise=noise(clean)))
        for one in with_uncertainty(found.values, found).effects:
            for name, u in u_of(expected[one.effect]).items():
                ratio.append(one.u[name] / u)
                off.append((one.parameters[name] - TRUTH[one.effect][name]) / u)
    assert min(ratio) > 0.75
    assert max(ratio) < 1.35
    assert np.exp(np.mean(np.log(ratio))) == pytest.approx(1.0, abs=0.08)
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.4
    assert np.abs(off).max() < 4.0
    assert all(one.state == "data" and one.stated for one in expected.values())


def test_effects_make_the_errors_less_certain(clean: Observations) -> None:
    model, slow = model_with(WARM, CYCLIC), {"amplitude": 8e-3, "tau": 900.0}
    free, _ = expected_with_effects(model, clean, KNOWN, noise(clean), ())
    known = replace(KNOWN, effects=(EffectValues(WARM, slow), EffectValues(CYCLIC, PERIOD)))
    fixed, given = expected_with_effects(model, clean, known, noise(clean), ())
    machine = slice(free.layout.of_machine)
    u, less = (np.linalg.norm(one.spread[machine], axis=1) for one in (free, fixed))
    assert (u >= less * (1.0 - 1e-9)).all()
    assert (u > 1.05 * less).any()
    assert [one.state for one in given] == ["given", "given"]
    assert fixed.layout.effects.count == 0


def test_a_larger_effect_tells_its_period_better_and_its_size_as_well(clean: Observations) -> None:
    at = [EffectValues(CYCLIC, PERIOD | {"amplitude": size}) for size in (1e-3, 4e-3)]
    small, large = (u_of(told(clean, CYCLIC, values=(one,))[0]) for one in at)
    assert large["pitch"] == pytest.approx(small["pitch"] / 4.0, rel=1e-6)
    assert large["amplitude"] == pytest.approx(small["amplitude"], rel=1e-6)
    (assumed,) = told(clean, CYCLIC)
    assert not assumed.stated
    assert {one.name: one.value for one in assumed.parameters}["amplitude"] == pytest.approx(3.5e-3, rel=0.4)
    (linear,) = told(clean, BACKLASH)
    assert [one.value for one in linear.parameters] == [0.0]


def test_what_a_plan_cannot_tell_is_said(clean: Observations) -> None:
    assert clean.context is not None
    lines = clean.of(np.flatnonzero(np.array([run.instrument == "laser" for run in clean.runs])[clean.run]))
    cold = replace(clean, context=replace(clean.context, temperature=np.full(clean.reading.size, np.nan)))
    assert [one.state for one in told(lines, LAG)] == ["silent"]
    assert [one.u for one in told(lines, LAG)[0].parameters] == [None]
    lacking, other = told(cold, THERMAL, BACKLASH)
    assert (lacking.state, lacking.missing, other.state) == ("lacking", ("temperature_c",), "data")


@pytest.fixture(scope="module")
def mill(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    spec = tmp_path_factory.mktemp("mill") / "mill.toml"
    spec.write_text(MILL)
    return spec, derived(spec)


def planned(mill: tuple[Path, Path], folder: Path, *options: str) -> tuple[int, dict[str, Any]]:
    spec, kernels = mill
    out = folder / "report.json"
    words = ["plan", str(spec), "--data", str(ROOT / "machines" / "dmu60p_regular_runs"), "--noise-um", "0.3"]
    code = main([*words, "--kernels", str(kernels), "--report", str(out), *options])
    tree: dict[str, Any] = json.loads(out.read_text()) if out.exists() else {}
    return code, tree


def test_the_command_says_it_in_words(
    mill: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    code, tree = planned(mill, tmp_path, "--propose", "1")
    text = " ".join(capsys.readouterr().out.split())
    assert code == 0
    # lines in one direction: a jump between home and the first target, as any curve may have
    assert "backlash EXX: width" in text
    assert "no run separates it from the errors of the machine" in text
    assert "warm_up EYY: cannot be predicted: column time_s is missing or has gaps" in text
    assert "servo_lag EXX: no reading depends on it" in text
    assert "(assumed: --effects)" in text
    states = {one["effect"]: one["state"] for one in tree["expected"]["effects"]}
    assert list(states) == ["backlash EXX", "cyclic EZZ", "warm_up EYY", "servo_lag EXX"]
    assert list(states.values()) == ["errors", "data", "lacking", "silent"]
    assert "EB0X" in [one["name"] for one in tree["expected"]["locations"]], "a squareness is a location error"
    assert [one["effect"] for one in tree["proposal"]["after"]["effects"]] == list(states)


EXX = ErrorName("EXX")


def test_runs_are_chosen_beside_unknown_effects() -> None:
    """u of EXX before and after each run is that of the estimate to expect, lost motion of X among its unknowns."""
    plan = folder("dmu60p_regular_runs")
    mill = model_with(BACKLASH)
    found: dict[bool, ProposalReport] = {}
    for unknown in (True, False):
        given = KNOWN if unknown else replace(KNOWN, effects=(EffectValues(BACKLASH, {"width": 0.0}),))
        options = PlanOptions(given=given, noise=NoiseModel(um=0.3), tools=(ORIGIN,), wanted="EXX")
        proposal = proposed(mill, options, plan, 1, ("laser",))
        found[unknown] = proposal.report
        for planned, u in ((plan, proposal.report.before), (proposal.planned, proposal.report.added[-1].u)):
            _, after = judged_plan(mill, options, planned)
            assert u == pytest.approx(judged_component(after.levelled(), EXX).u_rms, rel=1e-3)
    assert found[True].before > 1.2 * found[False].before, "lines in one direction: a step at home may be lost motion"


def test_values_to_plan_for_are_read_and_checked(
    mill: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "sizes.json"
    entry: dict[str, Any] = {"kind": "cyclic", "component": "EZZ", "parameters": PERIOD | {"pitch": 20.0}}
    file.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "effects": [entry]}))
    code, tree = planned(mill, tmp_path, "--effects", str(file))
    assert code == 0
    assert "and pitch 20 mm" in " ".join(capsys.readouterr().out.split())
    (one,) = (each for each in tree["expected"]["effects"] if each["effect"] == "cyclic EZZ")
    assert one["stated"]
    entry["parameters"] = PERIOD | {"pitch": -1.0}
    file.write_text(json.dumps({"schema": 1, "machine": "dmu60p", "effects": [entry]}))
    code, _ = planned(mill, tmp_path, "--effects", str(file), "--known", str(tmp_path / "none.json"))
    errors = capsys.readouterr().err
    assert code == 2
    assert "effects[0].parameters.pitch: -1.0 is not above 0" in errors
    assert "none.json" in errors
