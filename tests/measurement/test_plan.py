"""machines/dmu60p_runs is the paper's measuring plan: points of Tables 4 and 5, an equal grid over each travel."""

from pathlib import Path

import numpy as np
import pytest

from tests.measurement.adapter import Dmu60pAxes
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.setup import PointOn, Vector

FOLDER = Path(__file__).parents[2] / "machines" / "dmu60p_runs"
STEPS = 27
LENGTHS = {"X": 540.0, "Y": 700.0, "Z": 600.0}

# id -> axes that move, direction, target, reference; points typed from Tables 4 and 5
TOOL: dict[str, tuple[str, str, Vector]] = {
    "X-1": ("X", "X", (167, 30, -195)),
    "X-2": ("X", "X", (185, 30, -175)),
    "X-3": ("X", "X", (232, 40, -164)),
    "Z-7": ("Z", "Z", (-100, -77, 125)),
    "Z-8": ("Z", "Z", (-54, -72, 125)),
    "Z-9": ("Z", "Z", (-54, -72, -165)),
    "XZ-1x": ("XZ", "X", (-75.2, 31.8, 58.3)),
    "XZ-2x": ("XZ", "X", (-75.2, 81.7, 58.3)),
    "XZ-1z": ("XZ", "Z", (-75.2, 31.8, 58.3)),
    "XZ-2z": ("XZ", "Z", (-75.2, 81.7, 58.3)),
}
WORKPIECE: dict[str, tuple[str, str, Vector, Vector | None]] = {
    "Y-4": ("Y", "Y", (45, -85, 64), None),
    "Y-5": ("Y", "Y", (45, -85, 115), None),
    "Y-6": ("Y", "Y", (150, -120, 84), None),
    "XY-1x": ("XY", "X", (130, 195, 75), (-187.8, 97, -49.127)),
    "XY-2x": ("XY", "X", (130, 195, 105), (-187.8, 97, -19.127)),
    "XY-1y": ("XY", "Y", (130, 195, 75), (-187.8, 97, -49.127)),
    "YZ-1y": ("YZ", "Y", (113, 20, 78), (-220, 93, -26)),
    "YZ-1z": ("YZ", "Z", (113, 20, 78), (-220, 93, -26)),
}
UNIT = {"X": (1.0, 0.0, 0.0), "Y": (0.0, 1.0, 0.0), "Z": (0.0, 0.0, 1.0)}


@pytest.fixture(scope="module")
def plan() -> MeasuredData:
    return read_data(FOLDER, Dmu60pAxes())


def test_the_runs_are_those_of_the_paper(plan: MeasuredData) -> None:
    runs = {run.id: run for run in plan.setup.runs}
    assert set(runs) == {*TOOL, *WORKPIECE}
    assert len(runs) == 18
    for run in runs.values():
        assert (run.instrument, run.frame, set(run.home.values())) == ("laser", "bed", {0.0})
    for name, (_, direction, point) in TOOL.items():
        assert runs[name].target == PointOn("tool", point)
        assert runs[name].reference == PointOn("bed")
        assert runs[name].direction == UNIT[direction]
    for name, (_, direction, point, against) in WORKPIECE.items():
        assert runs[name].target == PointOn("workpiece", point)
        assert runs[name].reference == (PointOn("tool", against) if against else PointOn("bed"))
        assert runs[name].direction == UNIT[direction]


def test_positions_are_an_equal_grid_of_nc_words_over_the_travel(plan: MeasuredData) -> None:
    axes_of = {name: row[0] for name, row in TOOL.items()} | {name: row[0] for name, row in WORKPIECE.items()}
    for index, run in enumerate(plan.setup.runs):
        rows = plan.readings.of_run(index)
        assert plan.readings.seq[rows].tolist() == list(range(STEPS + 1))
        for axis, positions in zip("XYZ", plan.readings.positions[:, rows], strict=True):
            moved = np.arange(STEPS + 1) * (LENGTHS[axis] / STEPS) if axis in axes_of[run.id] else np.zeros(STEPS + 1)
            assert np.abs(positions - moved).max() <= 0.0005
            assert np.array_equal(positions, np.round(positions, 3))


def test_linkages_stop_exactly_where_single_axis_runs_do(plan: MeasuredData) -> None:
    stops = {
        (axis, tuple(positions))
        for index in range(18)
        for axis, positions in zip("XYZ", plan.readings.positions[:, plan.readings.of_run(index)], strict=True)
        if positions.any()
    }
    assert len(stops) == 3


def test_it_is_a_plan(plan: MeasuredData) -> None:
    assert plan.readings.planned.all()
