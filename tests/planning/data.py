"""Plans to judge: on the checked-in kernels, in a few lines."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from tests.identification.data import HOME, UNIT
from trueaxis.measurement.data import read_data
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.model.model import MachineModel, load_model
from trueaxis.planning.candidates import Candidate
from trueaxis.planning.runs import PlannedRuns, no_runs

ROOT = Path(__file__).parents[2]
KERNELS = ROOT / "generated"


@cache
def model(name: str = "dmu60p") -> MachineModel:
    return load_model(ROOT / "machines" / f"{name}.toml", None, KERNELS)


def folder(name: str) -> PlannedRuns:
    data = read_data(ROOT / "machines" / name, model().machine)
    return PlannedRuns(name, data.setup.runs, data.readings)


def laser(run_id: str, along: str, point: Vector, reference: PointOn | None = None) -> Run:
    return Run(
        id=run_id,
        instrument="laser",
        target=PointOn("tool", point),
        reference=reference or PointOn("bed"),
        frame="bed",
        home=HOME,
        direction=UNIT[along],
    )


def path(axes: str, steps: Sequence[float], start: Mapping[str, float] | None = None) -> FloatArray:
    """(3, n): axes together at the positions, the others at home."""
    return np.array([list(steps) if axis in axes else [(start or HOME)[axis]] * len(steps) for axis in "XYZ"])


def runs(given: Sequence[Run], positions: Sequence[FloatArray]) -> PlannedRuns:
    added = [Candidate(run, at, "") for run, at in zip(given, positions, strict=True)]
    return no_runs("plan", "XYZ").with_added(added)
