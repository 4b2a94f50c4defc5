"""Plans to judge: on the checked-in kernels, in a few lines."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from tests.identify.data import HOME, UNIT
from trueaxis.measure.data import read_data
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import PointOn, Run, Vector
from trueaxis.plan.candidates import Candidate
from trueaxis.plan.runs import PlannedRuns, no_runs
from trueaxis.runtime.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]
KERNELS = ROOT / "generated"


@cache
def model(name: str = "dmu60p") -> MachineModel:
    return load_model(ROOT / "machines" / f"{name}.toml", None, KERNELS)


def folder(name: str) -> PlannedRuns:
    data = read_data(ROOT / "machines" / name, model().machine)
    return PlannedRuns(name, data.setup.runs, data.readings)


def laser(run_id: str, along: str, point: Vector, reference: PointOn | None = None) -> Run:
    return Run(run_id, "laser", PointOn("tool", point), reference or PointOn("bed"), "bed", HOME, UNIT[along])


def path(axes: str, steps: Sequence[float], start: Mapping[str, float] | None = None) -> FloatArray:
    """(3, n): axes together at the positions, the others at home."""
    return np.array([list(steps) if axis in axes else [(start or HOME)[axis]] * len(steps) for axis in "XYZ"])


def runs(given: Sequence[Run], positions: Sequence[FloatArray]) -> PlannedRuns:
    added = [Candidate(run, at, "") for run, at in zip(given, positions, strict=True)]
    return no_runs("plan", "XYZ").with_added(added)
