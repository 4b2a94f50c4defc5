"""Programs compensated for effects: modes, batches, readers, and what the report says of each effect."""

import json
import math
import tracemalloc
from collections.abc import Mapping

import numpy as np
import pytest

from tests.compensation.control import Bench, execute
from tests.compensation.extended_model import extended
from tests.compensation.test_effects import BACKLASH, CASES, SQUARENESS, circle, coefficients
from tests.compensation.test_streaming import wave
from trueaxis.compensation.settings import Settings
from trueaxis.effects.kind import Effect
from trueaxis.model.model import MachineModel

NO_SQUARENESS = (0.0, 0.0, 0.0)
LAG = Effect(kind="servo_lag", component="EXX")


def plain(effects: Mapping[Effect, Mapping[str, float]]) -> MachineModel:
    """No errors but the effects."""
    return extended({}, NO_SQUARENESS, effects)


def everything() -> MachineModel:
    effects = {effect: values for case in CASES.values() for effect, values in case.effects.items()}
    effects[Effect(kind="backlash", component="EZZ")] = {"width": -0.008}
    return extended(coefficients(), SQUARENESS, effects)


@pytest.mark.parametrize("batch", [5, 17, 100])
def test_the_size_of_batches_does_not_show(bench: Bench, batch: int) -> None:
    text = "G1 F1000\n".join(wave(150).split("G1 F500\n"))
    whole = bench.run(text, everything())
    first = bench.report
    assert first.take_ups > 15
    assert bench.run(text, everything(), batch_points=batch) == whole
    assert bench.report.take_ups == first.take_ups
    assert bench.report.notes == first.notes


def test_memory_does_not_grow_with_the_program(bench: Bench) -> None:
    peaks = []
    for blocks in (24_000, 48_000):  # both more than is read at once
        text = wave(blocks)
        tracemalloc.start()
        bench.run(text, plain(BACKLASH | {LAG: {"tau": 0.001}}), batch_points=2000)
        peaks.append(tracemalloc.get_traced_memory()[1] - len(text) - bench.out.stat().st_size)
        tracemalloc.stop()
    assert peaks[1] < 1.2 * peaks[0]


def test_increments_and_inches_get_to_the_same_places(bench: Bench) -> None:
    ways = {
        "absolute": "G21 G90\nG0 X0. Y0. Z0.\nG1 X25.4 F600\nX12.7 Y25.4\nX38.1\nM30\n",
        "increments": "G21 G90\nG0 X0. Y0. Z0.\nG91\nG1 X25.4 F600\nX-12.7 Y25.4\nX25.4\nM30\n",
        "inches": "G20 G90\nG0 X0. Y0. Z0.\nG1 X1. F23.62204724\nX.5 Y1.\nX1.5\nM30\n",
    }
    ends = {}
    for name, text in ways.items():
        model = plain(BACKLASH | {LAG: {"tau": 0.001}})
        ends[name] = execute(bench.run(text, model, resolution=1e-4))
        assert bench.report.take_ups == 3  # X starts; X turns and Y starts; X turns
    for found in ends.values():
        assert found.shape == ends["absolute"].shape
        assert np.abs(found - ends["absolute"]).max() < 2.6e-4


@pytest.mark.parametrize(
    ("feeds", "per_second"),
    [
        ("F600", 10.0),
        ("G94 F600.", 10.0),
        ("G20 F10\nG21", 254.0 / 60.0),
        ("F300\nF600", 10.0),
        ("G95 F0.1", math.nan),
        ("G95 F0.1\nG94 F600", 10.0),
        ("F600\nG4 F2", 10.0),
        ("G1", math.nan),
    ],
)
def test_velocity_is_the_feed_in_force(bench: Bench, feeds: str, per_second: float) -> None:
    """A lead of tau v in the midst of a long line."""
    out = bench.run(f"G0 X0. Y0. Z0.\n{feeds}\nG1 X100.\nM30\n", plain({LAG: {"tau": 0.01}}))
    at = execute(out)[0]
    if math.isnan(per_second):
        assert at.tolist() == [0.0, 100.0]
        assert any("without a known F" in note for note in bench.report.notes)
        return
    ramp = 0.05 * per_second
    inside = (at > 2 * ramp) & (at < 100.0 - 2 * ramp)
    assert inside.any()
    # the cuts are at halves of the line, so the lead is what is left of the binary fraction
    step = 100.0 / 2**16
    leads = [
        min(((x - 0.01 * per_second) / step) % 1.0, 1.0 - ((x - 0.01 * per_second) / step) % 1.0) for x in at[inside]
    ]
    assert max(leads) * step <= 0.00051


def test_velocity_of_a_slanted_line_is_shared_by_its_axes(bench: Bench) -> None:
    model = plain({LAG: {"tau": 0.01}, Effect(kind="servo_lag", component="EYY"): {"tau": 0.01}})
    at = execute(bench.run("G0 X0. Y0. Z0.\nG1 X30. Y40. F600\nM30\n", model))
    lead = at - np.outer([0.6, 0.8, 0.0], at[0] * 0.6 + at[1] * 0.8)
    assert np.abs(lead).max() < 0.001  # along the line all the way
    assert at.shape[1] > 4


def test_apt_feeds_and_circles(bench: Bench) -> None:
    text = (
        "UNITS/MM\nFROM/0,0,0\nFEDRAT/600,MMPM\nGOTO/100,0,0\nCIRCLE/50,0,0,0,0,1,50\nGOTO/0,0,0\nGOTO/100,0,0\nFINI\n"
    )
    out = bench.run(text, plain(BACKLASH | {LAG: {"tau": 0.01}}), language="apt")
    at = execute(out)
    assert bench.report.take_ups >= 4
    assert np.ptp(np.hypot(at[0, 5:] - 50.0, at[1, 5:])) > 0.05
    assert not any("without a known F" in note for note in bench.report.notes)


def test_every_effect_is_accounted_for(bench: Bench, capsys: pytest.CaptureFixture[str]) -> None:
    effects = {
        Effect(kind="backlash", component="EXX"): {"width": -0.01},
        Effect(kind="thermal_expansion", component="EXX"): {"coefficient": 1e-5},
        Effect(kind="drift", component="EYY"): {"rate": 1e-6},
        Effect(kind="ballbar_length"): {"length": 0.01},
    }
    text = "G0 X0. Y0. Z0.\nG1 X100. F600\nX50.\nM30\n"
    at = execute(bench.run(text, plain(effects)))
    told = {one.effect: (one.compensated, one.how) for one in bench.report.effects}
    assert told["backlash EXX"] == (True, "by blocks that take up what a reversal changes")
    assert told["thermal_expansion EXX"] == (True, "temperature taken as 20 degC; another: --temperature")
    assert told["drift EYY"] == (False, "depends on time: say --time")
    assert told["ballbar_length"] == (False, "an instrument's: no error of the machine")
    assert at[0, -1] == pytest.approx(49.995)
    assert (at[1] == 0.0).all()

    warm = execute(bench.run(text, plain(effects), temperature=25.0, time=1000.0))
    assert warm[0, -1] == pytest.approx(50.0 * (1.0 - 5e-5) - 0.005, abs=0.0006)
    assert warm[1] == pytest.approx(-0.001 + 0.0 * warm[1])
    told = {one.effect: (one.compensated, one.how) for one in bench.report.effects}
    assert told["thermal_expansion EXX"] == (True, "at 25 degC")
    assert told["drift EYY"] == (True, "1000 s after the start")
    shown = bench.told
    assert "effect ballbar_length: left alone, an instrument's" in shown
    assert "2 blocks that take up reversals" in shown
    tree = json.loads(bench.report.to_json())
    assert {one["effect"]: one["compensated"] for one in tree["effects"]}["drift EYY"] is True
    assert tree["take_ups"] == 2


def test_without_effects_nothing_is_said_or_put_in(bench: Bench) -> None:
    out = bench.run(circle("G2", 1000.0), extended(coefficients(), SQUARENESS, {}))
    assert bench.report.effects == ()
    assert bench.report.take_ups == 0
    assert "effect" not in bench.told
    only_instrument = extended(coefficients(), SQUARENESS, {Effect(kind="ballbar_length"): {"length": 0.01}})
    assert bench.run(circle("G2", 1000.0), only_instrument) == out


@pytest.mark.parametrize("name", ["temperature", "time"])
def test_options_must_be_finite(name: str) -> None:
    with pytest.raises(ValueError, match=f"{name} is nan"):
        Settings(**{name: math.nan})  # type: ignore[arg-type]


def test_words_due_at_the_end_of_a_block_stay_there(bench: Bench) -> None:
    model = plain({Effect(kind="backlash", component="EXX"): {"width": -0.010}})
    text = "G21 G90\nG0 X0. Y0. Z0.\nG0 X10.\nN7 G1 X5. F100 M3\nX0. M0\nX3. M5 (end)\n"
    assert bench.run(text, model).decode().splitlines()[2:] == [
        "G0 X10.005",
        "N7 G1 X9.995 F100 M3",
        "X4.995",
        "X-0.005 M0",
        "X0.005 (end)",
        "X3.005 M5",
    ]
