"""Instruments as they are: set up a little wrong in the generator, told apart from the machine by identification."""

from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import cubic_errors
from tests.generator.dmu60p import dmu60p as generator
from tests.generator.instruments import laser
from tests.generator.machine import Body, Generator, polynomial
from tests.identify.data import HOME, line, moving, observed, paper_data, paper_runs, tool
from tests.identify.machines import PlainMachine, dmu60p
from tests.identify.test_global import CONVENTION, KNOWN, bar, circle, mixed_data, off
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.set_up import is_straightness
from trueaxis.identify.global_fit.instruments import KINDS, instruments
from trueaxis.identify.global_fit.method import identify_global
from trueaxis.identify.report import Identification
from trueaxis.measure.setup import PointOn, Run

OFF_CENTRE, TOO_LONG = (0.21, -0.13, 0.07), 0.004


def joined(*parts: Observations) -> Observations:
    starts = np.cumsum([0, *(len(part.runs) for part in parts)])
    return Observations(
        "readings.csv",
        tuple(run for part in parts for run in part.runs),
        np.concatenate([part.run + start for part, start in zip(parts, starts, strict=False)]),
        np.hstack([part.positions for part in parts]),
        np.concatenate([part.reading for part in parts]),
    )


def value(found: Identification, name: str) -> float:
    (one,) = [entry for entry in found.report.instruments if entry.name.startswith(name)]
    assert one.origin == "from the readings"
    return one.value


def bars_set_up_wrong() -> Observations:
    """Two circles about a ball that does not stand where the set-up says, with a bar that is too long."""
    named = (bar("xy", 600.0), bar("xz", 680.0))
    at = [circle(dmu60p(), named[0], (0, 1), 36), circle(dmu60p(), named[1], (0, 2), 36)]
    real = []
    for run in named:
        point = np.array(run.reference.point) + OFF_CENTRE
        real.append(replace(run, reference=PointOn("workpiece", tuple(point.tolist()))))
    data = observed(generator(cubic_errors()), real, at)
    return replace(data, runs=named, reading=data.reading + TOO_LONG)


def test_centre_and_length_of_ball_bars_are_found_on_the_exact_model() -> None:
    truth = cubic_errors()
    data = joined(paper_data(generator(truth)), bars_set_up_wrong())
    found = identify_global(dmu60p(), data, KNOWN)
    assert max(off(found, truth, name) for name in truth) < 1e-10
    for coordinate, expected in zip("xyz", OFF_CENTRE, strict=True):
        assert value(found, f"centre {coordinate}") == pytest.approx(expected, abs=1e-10)
    assert value(found, "length") == pytest.approx(TOO_LONG, abs=1e-10)
    assert found.report.residual_rms_um < 1e-8
    ideal = identify_global(dmu60p(), data, replace(KNOWN, instruments=()))
    assert ideal.report.residual_rms_um > 1.0
    assert max(off(ideal, truth, name) for name in truth) > 1e-3


def test_a_bar_alone_cannot_tell_its_length_from_the_scales() -> None:
    found = identify_global(dmu60p(), bars_set_up_wrong(), replace(KNOWN, degree=1, noise_um=0.3))
    told = [item for item in found.values.undetermined if "length of the bar" in item.combination]
    assert told
    assert any({"EXX", "EYY", "EZZ"} <= set(item.parameters) for item in told)
    assert all(not np.isfinite(found.values.motion_errors[name].u).any() for name in ("EXX", "EYY", "EZZ"))  # type: ignore[arg-type]
    assert any(one.origin == "undetermined: the instruments are taken for perfect" for one in found.report.instruments)


def straightness(offset: float, slope: float) -> Observations:
    """X seen along Y: a run of its own line."""
    run = tool("S", "y", (167.0, 30.0, -195.0))
    data = observed(generator(cubic_errors()), [run], [line("X", 10)])
    return replace(data, reading=data.reading + offset + slope * data.positions[0])


def test_offset_and_slope_of_a_straightness_run_are_found() -> None:
    truth = cubic_errors()
    data = joined(paper_data(generator(truth)), straightness(0.005, 2e-5))
    found = identify_global(dmu60p(), data, KNOWN)
    assert [one.name for one in found.report.instruments] == ["offset of run S", "slope of run S"]
    assert value(found, "offset") == pytest.approx(0.005, abs=1e-11)
    assert value(found, "slope") == pytest.approx(2e-5, abs=1e-13)
    assert max(off(found, truth, name) for name in truth) < 1e-11


def test_a_straightness_run_alone_tells_no_squareness() -> None:
    """Without a line known, squareness is open; the value given is that of a perfect instrument, without u."""
    runs = [run for run in paper_runs() if moving(run) in "XYZ"]
    lasers = observed(generator(cubic_errors()), runs, [line(moving(run), 8) for run in runs])
    data = joined(lasers, straightness(0.0, 0.0))
    real = identify_global(dmu60p(), data, replace(CONVENTION, degree=3, noise_um=0.3))
    ideal = identify_global(dmu60p(), data, replace(CONVENTION, degree=3, noise_um=0.3, instruments=()))
    assert np.isnan(real.values.u["eps_xy"])
    assert np.isfinite(ideal.values.u["eps_xy"])
    assert real.values.parameters["eps_xy"] == pytest.approx(ideal.values.parameters["eps_xy"], abs=1e-11)
    assert any("eps_xy" in i.parameters and "slope of run S" in i.combination for i in real.values.undetermined)


def test_displacement_and_linkage_runs_are_no_straightness() -> None:
    data = paper_data(generator({}), 4)
    machine = dmu60p()
    assert not instruments(machine, data, KINDS).unknowns
    run = straightness(0.0, 0.0).runs[0]
    assert is_straightness(machine, run, line("X", 4))
    assert not is_straightness(machine, run, line("Y", 4)[:, :1])  # at rest
    assert not is_straightness(machine, run, line("XY", 4) + np.array([[0], [0], [0.1]]))


def test_unknowns_that_no_reading_holds_are_left_out() -> None:
    """A circle in the plane of its ball says nothing of the height of the ball."""
    run = bar("xy", 612.5 - 10.0 - 12.5 - 190.0)
    data = mixed_data(cubic_errors())
    at = circle(dmu60p(), run, (0, 1), 12)
    flat = Observations("", (run,), np.zeros(12, dtype=np.int64), at, np.zeros(12))
    names = [unknown.name for unknown in instruments(dmu60p(), flat, KINDS).unknowns]
    heights = [name for name in names if name.startswith("centre z")]
    assert len(names) - len(heights) == 3
    kinds = [unknown.kind for unknown in instruments(dmu60p(), data, ("length",)).unknowns]
    assert kinds == ["length", "length"]


BODIES = (
    Body(2, lower=1, moves="C", position=(100.0, 40.0, 0.0)),
    Body(3, lower=1, moves="X"),
    Body(4, lower=3, moves="Y"),
)
ROTARY = {"EXC": polynomial(p1=2e-5, p2=1e-8), "EAC": polynomial(p1=3e-8), "EYX": polynomial(p1=1e-5)}


@pytest.mark.parametrize("frame", ["bed", "workpiece"])
def test_sphere_on_a_turning_table_and_zero_of_the_probe(frame: str) -> None:
    """Written out: the sphere is off by c on the table, all readings by their zero; the set-up knows neither."""
    axes = ("X", "Y", "C")
    frames = {"bed": 1, "workpiece": 2, "tool": 4}
    truth = Generator(BODIES, axes, frames, {}, ROTARY)
    machine = PlainMachine(BODIES, axes, {"X": (0.0, 300.0), "Y": (0.0, 300.0), "C": (0.0, 360.0)}, frames, (), ())
    sphere, shifted, zero = np.array([80.0, 10.0, 50.0]), np.array([0.03, -0.02, 0.0]), np.array([0.011, -0.006, 0.004])
    turns = np.linspace(0.0, 350.0, 15)
    at = np.array([[160.0 + 0.3 * c, 50.0 + 0.2 * c, c] for c in turns.tolist()]).T
    home = {"X": 160.0, "Y": 50.0, "C": 0.0}
    runs, readings = [], []
    for name, direction in zip("xyz", np.eye(3), strict=True):
        runs.append(
            Run(
                name,
                "probe",
                PointOn("tool"),
                PointOn("workpiece", tuple(sphere.tolist())),
                frame,  # type: ignore[arg-type]
                home,
                tuple(direction.tolist()),
            )
        )
        for column in at.T:
            pose = dict(zip(axes, column.tolist(), strict=True))
            moved = []
            for actual, ball in ((True, sphere + shifted), (False, sphere)):
                target = truth.coordinates("tool", frame, pose, np.zeros(3), actual)
                target = target - truth.coordinates("tool", frame, home, np.zeros(3), actual)
                rest = truth.coordinates("workpiece", frame, pose, ball, actual)
                rest = rest - truth.coordinates("workpiece", frame, home, ball, actual)
                moved.append(target - rest)
            readings.append(float(direction @ (moved[0] - moved[1] + zero)))
    data = Observations("", tuple(runs), np.repeat(np.arange(3), turns.size), np.hstack([at] * 3), np.array(readings))
    found = instruments(machine, data, KINDS)
    names = [unknown.name.split(" of ")[0] for unknown in found.unknowns]
    expected = {
        "bed": ["zero x", "zero y", "zero z", "centre x", "centre y"],
        "workpiece": ["zero x", "zero y", "zero z"],
    }
    assert names == expected[frame]
    values = np.array([*zero, *shifted[:2]][: len(names)])
    without = np.concatenate(
        [
            [
                float(
                    laser(
                        truth,
                        dict(zip(axes, column.tolist(), strict=True)),
                        home,
                        direction=direction.tolist(),
                        frame=frame,
                        target=("tool", (0.0, 0.0, 0.0)),
                        reference=("workpiece", sphere.tolist()),
                    )
                )
                for column in at.T
            ]
            for direction in np.eye(3)
        ]
    )
    assert np.allclose(data.reading - found.added(machine, data, values), without, rtol=0, atol=1e-6)  # c times errors


def test_home_is_where_it_is_said_to_be() -> None:
    """The way of a slope is counted from home, wherever that is."""
    home = {**HOME, "X": 100.0}
    run = tool("S", "y", (0.0, 0.0, 0.0), home=home)
    data = observed(generator({}), [run], [line("X", 5)])
    offset, slope = instruments(dmu60p(), data, KINDS).columns(dmu60p(), data.runs, 0, data.positions).T
    assert np.allclose(offset, 1.0)
    assert np.allclose(slope * 700.0, data.positions[0] - 100.0)
