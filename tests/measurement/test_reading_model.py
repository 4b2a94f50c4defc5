"""The one definition of a reading, against readings taken word for word on the independent machine."""

from dataclasses import replace

import numpy as np
import pytest

from tests.generator.dmu60p import PARAMETERS, TRAVEL, cubic_errors, dmu60p, sine_errors
from tests.generator.instruments import ball_bar, laser
from tests.generator.machine import Generator, polynomial
from tests.measurement.adapter import GeneratorModel
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import (
    Term,
    expected_reading,
    expected_readings,
    ideal_reading,
    measuring_frame,
    run_terms,
    sensed_directions,
)
from trueaxis.measurement.setup import PointOn, Run

ZERO = {"X": 0.0, "Y": 0.0, "Z": 0.0}
TOOL = PointOn("tool", (-187.8, 97.0, -49.127))
WORKPIECE = PointOn("workpiece", (130.0, 195.0, 75.0))
BED = PointOn("bed", (10.0, -20.0, 30.0))
AWAY = {"X": 100.0, "Y": 250.0, "Z": 333.0}


def laser_run(target: PointOn, reference: PointOn, **changes: object) -> Run:
    run = Run(
        id="R",
        instrument="laser",
        target=target,
        reference=reference,
        frame="bed",
        home=ZERO,
        direction=(1.0, 0.0, 0.0),
    )
    return replace(run, **changes)  # type: ignore[arg-type]


def bar_run(target: PointOn, reference: PointOn, length: float = 300.0) -> Run:
    return Run(
        id="B",
        instrument="ballbar",
        target=target,
        reference=reference,
        frame="bed",
        home=ZERO,
        direction=None,
        length=length,
    )


LASERS = [
    laser_run(TOOL, BED),
    laser_run(WORKPIECE, BED, direction=(0.0, 1.0, 0.0)),
    laser_run(WORKPIECE, TOOL, direction=(0.0, 0.0, 1.0)),
    laser_run(TOOL, WORKPIECE, frame="workpiece", direction=(0.6, 0.0, -0.8)),
    laser_run(TOOL, BED, frame="workpiece", direction=(0.0, 0.6, 0.8), home=AWAY),
    laser_run(WORKPIECE, BED, frame="workpiece", home=AWAY),
    laser_run(TOOL, PointOn("tool", (0.0, 0.0, 0.0)), direction=(0.0, 1.0, 0.0), home=AWAY),
]
BARS = [bar_run(TOOL, WORKPIECE, 480.0), bar_run(WORKPIECE, TOOL, 480.0), bar_run(TOOL, BED, 700.0)]
BARS.append(bar_run(WORKPIECE, BED, 500.0))


def poses(count: int) -> FloatArray:
    source = np.random.default_rng(7)
    return np.array([source.uniform(*TRAVEL[axis], count) for axis in "XYZ"])


def read_by_definition(machine: Generator, run: Run, positions: FloatArray) -> FloatArray:
    found = np.zeros(positions.shape[1])
    target, reference = (run.target.on, run.target.point), (run.reference.on, run.reference.point)
    for n, pose in enumerate(positions.T):
        at = dict(zip("XYZ", pose, strict=True))
        if run.length is not None:
            frame = "workpiece" if {run.target.on, run.reference.on} == {"tool", "workpiece"} else "bed"
            found[n] = ball_bar(machine, at, length=run.length, target=target, reference=reference, frame=frame)
        else:
            assert run.direction is not None
            found[n] = laser(
                machine, at, run.home, direction=run.direction, frame=run.frame, target=target, reference=reference
            )
    return found


@pytest.mark.parametrize(
    "run", [*LASERS, *BARS], ids=lambda run: f"{run.instrument} {run.target.on} {run.reference.on}"
)
@pytest.mark.parametrize("errors", [cubic_errors(), sine_errors()], ids=["cubic", "sine"])
def test_a_reading_is_what_its_definition_says(run: Run, errors: dict) -> None:  # type: ignore[type-arg]
    machine = dmu60p(errors)
    positions = poses(25)
    found = expected_reading(GeneratorModel(machine), run, positions)
    assert np.abs(found).max() > 1e-4
    assert np.abs(found - read_by_definition(machine, run, positions)).max() < 2e-13


def test_a_reading_at_home_is_zero_whatever_the_errors() -> None:
    home = np.array([[AWAY[axis]] for axis in "XYZ"])
    run = laser_run(TOOL, BED, home=AWAY)
    assert expected_reading(GeneratorModel(dmu60p(sine_errors())), run, home).tolist() == [0.0]


def test_without_errors_a_laser_reads_nothing_and_a_ball_bar_its_ideal_distance() -> None:
    model = GeneratorModel(dmu60p({}, {}))
    positions = np.array([[300.0, 0.0], [0.0, 0.0], [400.0, 7.0]])
    assert expected_reading(model, laser_run(TOOL, WORKPIECE), positions).tolist() == [0.0, 0.0]
    bar = bar_run(PointOn("tool"), PointOn("workpiece"), 500.0)
    assert expected_reading(model, bar, positions).tolist() == [0.0, -493.0]
    assert ideal_reading(model, bar, positions).tolist() == [0.0, -493.0]


def test_a_tiny_elongation_does_not_drown_in_the_length() -> None:
    """At |P| = length exactly, an elongation of 1e-13 mm is read to all its digits."""
    model = GeneratorModel(dmu60p({"EXX": polynomial(p1=1e-13 / 300)}, {}))
    bar = bar_run(PointOn("tool"), PointOn("workpiece"), 500.0)
    found = expected_reading(model, bar, np.array([[300.0], [0.0], [400.0]]))
    assert float(found[0]) == pytest.approx(0.6e-13, rel=1e-12)


def test_balls_that_meet_are_read_without_a_division_by_zero() -> None:
    bar = bar_run(PointOn("tool"), PointOn("workpiece"), 300.0)
    found = expected_reading(GeneratorModel(dmu60p({}, {})), bar, np.zeros((3, 1)))
    assert found.tolist() == [-300.0]


@pytest.mark.parametrize(
    ("run", "frame", "terms"),
    [
        (laser_run(TOOL, BED), "bed", (Term("tool_in_bed", 1.0, TOOL.point),)),
        (
            laser_run(WORKPIECE, TOOL),
            "bed",
            (Term("workpiece_in_bed", 1.0, WORKPIECE.point), Term("tool_in_bed", -1.0, TOOL.point)),
        ),
        (
            laser_run(TOOL, BED, frame="workpiece"),
            "workpiece",
            (Term("tool_in_workpiece", 1.0, TOOL.point), Term("bed_in_workpiece", -1.0, BED.point)),
        ),
        (bar_run(WORKPIECE, TOOL), "workpiece", (Term("tool_in_workpiece", -1.0, TOOL.point),)),
        (bar_run(TOOL, BED), "bed", (Term("tool_in_bed", 1.0, TOOL.point),)),
    ],
)
def test_the_terms_of_a_reading(run: Run, frame: str, terms: tuple[Term, ...]) -> None:
    assert measuring_frame(run) == frame
    assert run_terms(run) == terms


@pytest.mark.parametrize(
    "run", [*LASERS, *BARS], ids=lambda run: f"{run.instrument} {run.target.on} {run.reference.on}"
)
def test_terms_and_directions_give_the_reading_to_first_order(run: Run) -> None:
    """What identification builds its rows from: the reading less this form falls with the square of the errors."""
    positions = poses(10)

    def remainder(scale: float) -> float:
        errors = {name: (lambda s, f=f: scale * f(s)) for name, f in cubic_errors().items()}
        located = {name: scale * value if name.startswith("eps") else value for name, value in PARAMETERS.items()}
        model = GeneratorModel(dmu60p(errors, located))

        def sensed(at: FloatArray) -> FloatArray:
            return sum(  # type: ignore[return-value]
                term.sign * model.view_deviation(term.view, at, np.array(term.point)[:, None])
                for term in run_terms(run)
            )

        home = np.array([[run.home[axis]] for axis in "XYZ"])
        shift = sensed(positions) - (sensed(home) if run.length is None else 0.0)
        linear = (sensed_directions(model, run, positions) * shift).sum(axis=0)
        rest = expected_reading(model, run, positions) - ideal_reading(model, run, positions) - linear
        return float(np.abs(rest).max())

    assert remainder(1.0) < 1e-5
    if run.length is not None:
        assert remainder(1.0) / remainder(0.5) == pytest.approx(4.0, rel=0.05)


@pytest.mark.parametrize("axis", ["X", "Z"])
def test_single_axis_readings_are_those_of_the_paper(axis: str) -> None:
    """Eqs. (12) and (14) along the motion, worked by hand; errors small enough that products do not show."""
    curves = {
        f"E{d}{axis}": polynomial(p1=v)
        for d, v in zip("XYZABC", (2e-12, 3e-12, 5e-12, 7e-14, 11e-14, 13e-14), strict=True)
    }
    model = GeneratorModel(dmu60p(curves, {}))
    rx, ry, rz = 167.0, 30.0, -195.0
    direction = (1.0, 0.0, 0.0) if axis == "X" else (0.0, 0.0, 1.0)
    run = laser_run(PointOn("tool", (rx, ry, rz)), PointOn("bed"), direction=direction)
    positions = np.zeros((3, 1))
    positions["XYZ".index(axis)] = 500.0
    by_hand = 500.0 * (2e-12 - ry * 13e-14 + rz * 11e-14 if axis == "X" else 5e-12 - rx * 11e-14 + ry * 7e-14)
    assert float(expected_reading(model, run, positions)[0]) == pytest.approx(by_hand, rel=1e-6)


def test_rows_of_several_runs_are_read_each_by_its_own_run() -> None:
    model = GeneratorModel(dmu60p(cubic_errors()))
    positions = poses(6)
    rows = np.array([1, 0, 1, 1, 0, 0])
    runs = (LASERS[0], BARS[0])
    found = expected_readings(model, runs, rows, positions)
    for index, run in enumerate(runs):
        assert np.array_equal(found[rows == index], expected_reading(model, run, positions)[rows == index])
