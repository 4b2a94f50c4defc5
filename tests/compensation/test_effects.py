"""Circles on a machine that moves in time: uncompensated, compensated for geometry alone, and for its effects too."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
import pytest

from tests.compensation.analytic_machine import FloatArray, XyzMachine, polynomial
from tests.compensation.control import Bench
from tests.compensation.extended_model import HIGH, LOW, extended
from tests.compensation.moving_machine import MovingMachine, executed
from trueaxis.effects.kind import Effect
from trueaxis.evaluation.circular_test import circularity

RADIUS, CENTRE = 150.0, (50.0, 20.0)
SQUARENESS = (5e-5, -3e-5, 4e-5)
FINE: dict[str, Any] = {"resolution": 1e-4, "chord_tolerance": 1e-4}
# of a machine without any error, by words of 0.001 and 0.0001 mm and as coarse chords: nothing can be rounder
FLOOR, FINE_FLOOR = 0.0017, 0.00022


def coefficients() -> dict[str, tuple[float, ...]]:
    random = np.random.default_rng(7)
    sizes = {f"E{kind}{axis}": 0.02 if kind in "XYZ" else 3e-5 for axis in "XYZ" for kind in "XYZABC"}
    return {name: tuple(size * random.uniform(-1.0, 1.0, 4)) for name, size in sizes.items()}


def circle(code: str, feed: float) -> str:
    """Two turns; the first brings every drive to one side of its play."""
    x, y = CENTRE
    turns = f"{code} I-{RADIUS:.1f} J0.\n" * 2
    return f"G21 G90\nG0 X0. Y0. Z0.\nG0 X{x + RADIUS:.1f} Y{y:.1f} Z-20.\nG1 F{feed:g}\n{turns}M30\n"


def roundness(machine: MovingMachine, program: bytes) -> float:
    """Circular deviation (mm) over a whole turn, ends of the program left out."""
    samples = executed(program)
    tool = machine.tool_path(samples)
    x, y = samples.commands[0] - CENTRE[0], samples.commands[1] - CENTRE[1]
    angles = np.unwrap(np.arctan2(y, x))
    turned = np.abs(angles - angles[1]) / (2.0 * np.pi)
    part = (turned > 0.9) & (turned < 1.9)
    radius = np.hypot(tool[0] - CENTRE[0], tool[1] + CENTRE[1])  # the workpiece moves with Y: -y in its frame
    return circularity(angles[part], radius[part] - RADIUS).deviation


def share(position: Any) -> Any:
    return (position - LOW) / (HIGH - LOW)


def cyclic(positions: FloatArray) -> FloatArray:
    return np.asarray(0.004 * np.cos(2.0 * np.pi * positions[0] / 10.0 + 0.3))


@dataclass(frozen=True)
class Case:
    """play, lag, friction, fades, bent: of MovingMachine; effects: what the model is told."""

    effects: Mapping[Effect, Mapping[str, float]]
    play: Mapping[str, Callable[[float], float]] = field(default_factory=dict)
    lag: Mapping[str, float] = field(default_factory=dict)
    friction: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    fades: Literal["way", "time", "path"] = "way"
    bent: Mapping[str, Callable[[FloatArray], FloatArray]] = field(default_factory=dict)
    feed: float = 1000.0
    blocks: tuple[int, int] = (2400, 2460)

    @property
    def machine(self) -> MovingMachine:
        rigid = XyzMachine({name: polynomial(*c) for name, c in coefficients().items()}, SQUARENESS)
        return MovingMachine(rigid, self.play, self.lag, self.friction, self.fades, self.bent)


PLAY = {"X": lambda _: 0.005, "Y": lambda _: 0.005}
# a drive with play of 0.010 stays behind by half of it: coming from below the slide stands lower
BACKLASH = {
    Effect(kind="backlash", component="EXX"): {"width": -0.010},
    Effect(kind="backlash", component="EYY"): {"width": -0.010},
}
CYCLIC = {Effect(kind="cyclic", component="EXX"): {"amplitude": 0.004, "phase": 0.3, "pitch": 10.0}}
SPIKE = {"height": -0.006, "decay": 0.5}
CASES = {
    "backlash": Case(BACKLASH, play=PLAY),
    "backlash_slope": Case(
        {**BACKLASH, Effect(kind="backlash_slope", component="EXX"): {"change": -0.004}},
        play={**PLAY, "X": lambda x: 0.005 + 0.004 * (share(x) - 0.5)},
    ),
    "cross_axis": Case(
        {
            Effect(kind="cross_axis", component="EXX", axis="Y"): {"k": 0.060},
            Effect(kind="cross_axis", component="EZY", axis="X"): {"k": 0.02},
        },
        bent={
            "EXX": lambda at: 0.060 * share(at[0]) * share(at[1]) ** 2,
            "EZY": lambda at: 0.020 * share(at[1]) * share(at[0]) ** 2,
        },
    ),
    "cyclic": Case(CYCLIC, bent={"EXX": cyclic}),
    "servo_lag, difference": Case(
        {Effect(kind="servo_lag", component="EXX"): {"tau": 0.001}}, lag={"X": 0.0015, "Y": 0.0005}
    ),
    "servo_lag, each": Case(
        {
            Effect(kind="servo_lag", component="EXX"): {"tau": 0.0015},
            Effect(kind="servo_lag", component="EYY"): {"tau": 0.0005},
        },
        lag={"X": 0.0015, "Y": 0.0005},
        feed=1500.0,
    ),
    "reversal_spike": Case(
        {Effect(kind="reversal_spike", component="EXX"): SPIKE, Effect(kind="reversal_spike", component="EYY"): SPIKE},
        friction={"X": (0.006, 0.5), "Y": (0.006, 0.5)},
    ),
    "reversal_spike_time": Case(
        {
            Effect(kind="reversal_spike_time", component=f"E{axis}{axis}"): {"height": -0.006, "tau": 0.7}
            for axis in "XY"
        },
        friction={"X": (0.006, 0.7), "Y": (0.006, 0.7)},
        fades="time",
    ),
    "reversal_spike_path": Case(
        {
            Effect(kind="reversal_spike_path", component=f"E{axis}{axis}"): {"height": -0.006, "decay": 12.0}
            for axis in "XY"
        },
        friction={"X": (0.006, 12.0), "Y": (0.006, 12.0)},
        fades="path",
    ),
    "play, lag and screw": Case(
        {**BACKLASH, **CYCLIC, Effect(kind="servo_lag", component="EXX"): {"tau": 0.001}},
        play=PLAY,
        lag={"X": 0.0015, "Y": 0.0005},
        bent={"EXX": cyclic},
        feed=1500.0,
    ),
}


@pytest.mark.parametrize("code", ["G2", "G3"])
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if CASES[name].fades != "way" else name for name in CASES]
)
def test_the_circle_is_as_round_as_words_allow(bench: Bench, name: str, code: str) -> None:
    case = CASES[name]
    program = circle(code, case.feed)
    without = roundness(case.machine, bench.run(program))
    geometry = roundness(case.machine, bench.run(program, extended(coefficients(), SQUARENESS, {})))
    model = extended(coefficients(), SQUARENESS, case.effects)
    coarse = roundness(case.machine, bench.run(program, model))
    fine = roundness(case.machine, bench.run(program, model, **FINE))
    assert bench.report.good
    assert without > 0.005
    assert geometry > 0.6 * without
    assert coarse < FLOOR + 0.0002
    assert fine < FINE_FLOOR + 0.00015
    assert fine < 0.1 * without


def test_the_floor_is_that_of_the_words(bench: Bench) -> None:
    perfect = MovingMachine(XyzMachine())
    assert roundness(perfect, bench.run(circle("G3", 1000.0))) == pytest.approx(FLOOR, rel=0.05)
    assert roundness(perfect, bench.run(circle("G3", 1000.0), **FINE)) == pytest.approx(FINE_FLOOR, rel=0.05)


def test_half_the_width_leaves_half_the_steps(bench: Bench) -> None:
    """Were the circle round by anything but the width, half of it would not show."""
    case = CASES["backlash"]
    half = {effect: {"width": -0.005} for effect in BACKLASH}
    program = circle("G3", 1000.0)
    found = roundness(case.machine, bench.run(program, extended(coefficients(), SQUARENESS, half), **FINE))
    assert found == pytest.approx(0.005, abs=0.0008)
    other_way = {effect: {"width": 0.010} for effect in BACKLASH}
    found = roundness(case.machine, bench.run(program, extended(coefficients(), SQUARENESS, other_way), **FINE))
    assert found > 0.015
    assert any("ahead" in note for note in bench.report.notes)


def test_play_is_taken_up_at_the_reversal_by_the_reversing_axis_alone(bench: Bench) -> None:
    model = extended({}, (0.0, 0.0, 0.0), {Effect(kind="backlash", component="EXX"): {"width": -0.010}})
    program = "G21 G90\nG0 X0. Y0. Z0.\nG1 X10. Y5. F600\nX-20. Y10. F700\nX-30.\n"
    assert bench.run(program, model).decode().splitlines()[2:] == [
        "G1 X0.005 Y0.000 F600",  # from where it stood, in the middle of the play, to its upper side
        "X10.005 Y5.000",
        "X9.995 Y5.000 F700",
        "X-20.005 Y10.000",
        "X-30.005",
    ]
    assert bench.report.take_ups == 2


def test_play_does_not_swallow_corrections_of_an_axis_that_stands(bench: Bench) -> None:
    """Squareness moves Y back while X moves: the play of Y must be taken up, although Y stands in the program."""
    machine = MovingMachine(XyzMachine({}, (5e-5, 0.0, 0.0)), {"Y": PLAY["Y"]})
    program = "G21 G90\nG0 X0. Y-50. Z0.\nG0 Y50.\nG1 X300. F1000\nX0.\nM30\n"
    straight = []
    for effects in ({}, {Effect(kind="backlash", component="EYY"): {"width": -0.010}}):
        out = bench.run(program, extended({}, (5e-5, 0.0, 0.0), effects), **FINE)
        samples = executed(out)
        tool = machine.tool_path(samples)
        fed = samples.time > samples.time[np.argmax(samples.commands[1] > 49.0)]
        straight.append(float(np.abs(tool[1] + 50.0)[fed].max()))
    assert straight[0] > 0.004
    assert straight[1] < 0.0001


def test_a_lead_for_lag_never_goes_past_a_stop(bench: Bench) -> None:
    """At 3 m/min a lead of 2 ms is 0.1 mm: at corners, stops and ends the commands are those of the program."""
    model = extended({}, (0.0, 0.0, 0.0), {Effect(kind="servo_lag", component="EXX"): {"tau": 0.002}})
    corner = "G21 G90\nG0 X0. Y0. Z0.\nG1 X50. F3000\nY50.\nX0.\nG4 P1\nX-50.\nM30\n"
    commands = executed(bench.run(corner, model)).commands
    assert commands[0].max() == pytest.approx(50.0)
    assert commands[0].min() == pytest.approx(-50.0)
    leads = [(25.0, 0.0, 25.1), (25.0, 50.0, 24.9), (-25.0, 50.0, -25.1)]
    for x, y, led in leads:
        machine = MovingMachine(XyzMachine(), lag={"X": 0.002})
        samples = executed(bench.run(corner, model))
        tool = machine.tool_path(samples)
        on = (np.abs(samples.commands[1] - y) < 1e-6) & (np.abs(samples.commands[0] - led) < 0.5)
        at = np.argmin(np.abs(tool[0][on] - x))
        assert samples.commands[0][on][at] == pytest.approx(led, abs=0.03)
