"""Plans to judge: on the checked-in kernels, in a few lines."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np

from tests.identify.data import HOME, UNIT
from trueaxis.estimation.observations import Observations
from trueaxis.measure.data import read_data
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import PointOn, Run, Vector
from trueaxis.plan.instruments import Assumptions
from trueaxis.plan.method import Plan, PlanOptions, plan_of, planned
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_model

ROOT = Path(__file__).parents[2]
KERNELS = ROOT / "generated"
IDEAL = Assumptions(ideal=True)
LEVER = 700.0  # mm: the longest travel of the dmu60p


@cache
def model(name: str = "dmu60p") -> MachineModel:
    return load_model(ROOT / "machines" / f"{name}.toml", None, KERNELS)


def folder(name: str) -> Observations:
    data = read_data(ROOT / "machines" / name, model().machine)
    return planned(name, data.setup.runs, data.readings)


def laser(run_id: str, along: str, point: Vector, reference: PointOn | None = None) -> Run:
    return Run(run_id, "laser", PointOn("tool", point), reference or PointOn("bed"), "bed", HOME, UNIT[along])


def path(axes: str, steps: Sequence[float], start: Mapping[str, float] | None = None) -> FloatArray:
    """(3, n): axes together at the positions, the others at home."""
    return np.array([list(steps) if axis in axes else [(start or HOME)[axis]] * len(steps) for axis in "XYZ"])


def observations(runs: Sequence[Run], positions: Sequence[FloatArray]) -> Observations:
    index = np.repeat(np.arange(len(runs)), [at.shape[1] for at in positions])
    return Observations("plan", tuple(runs), index, np.hstack(list(positions)), np.zeros(index.size))


def known_but(*names: str, machine: str = "dmu60p") -> ErrorValues:
    """Everything known to be zero but the components and location errors named."""
    one = model(machine)
    curves = {c: PolynomialCurve((), ()) for c in one.components if c not in names}
    return ErrorValues(one.name, {p: 0.0 for p in one.location_errors if p not in names}, dict(curves))


def plan(observed: Observations, options: PlanOptions | None = None, machine: str = "dmu60p") -> Plan:
    return plan_of(model(machine), observed, options or PlanOptions())
