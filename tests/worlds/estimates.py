"""What the package's estimate makes of worlds, beside the oracle: predictions at random points of the volume."""

import contextlib
import io
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tests.worlds.design import Design, draw_design
from tests.worlds.files import write_world
from tests.worlds.machine import Array
from tests.worlds.oracle import oracle
from tests.worlds.readings import measure
from tests.worlds.truth import Truth, draw_machine, random_points
from trueaxis.cli import main
from trueaxis.estimation.estimate import Estimate, estimate
from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.observations import Observations, observations
from trueaxis.measure.data import read_data
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel, load_model
from trueaxis.runtime.uncertainty import home_of, tool_uncertainty

POINTS = 200
TOOL = np.zeros((3, 1))


@dataclass(frozen=True)
class World:
    """A design with the package's kernels of its machine, and its plan as the package reads it."""

    design: Design
    model: MachineModel
    plan: Observations


@dataclass(frozen=True)
class Outcome:
    """Of one machine, um, root mean squares over points, of vectors: true deviation, error of the estimate and of the
    oracle, u of the estimate; coverage: share of the coordinates within 1.96 u. From home, where not said otherwise.
    """

    true: float
    error: float
    oracle: float
    u: float
    coverage: float
    machine_error: float
    machine_oracle: float
    found: Estimate


def world(seed: int, folder: Path, axes: int | None = None) -> World:
    """Write, derive and read a design."""
    design = draw_design(seed, axes)
    truth = draw_machine(design.machine, seed)
    write_world(folder, design, truth, measure(design, truth, seed))
    with contextlib.redirect_stdout(io.StringIO()):
        assert main(["derive", str(folder / "machine.toml"), "--out", str(folder / "kernels")]) == 0
    model = load_model(folder / "machine.toml", folder / "errors.json", folder / "kernels")
    data = read_data(folder / "data", model)
    return World(design, model, observations(str(folder), data.setup.runs, data.readings))


def outcome(one: World, seed: int, curves: str = "smooth") -> Outcome:
    """Draw a machine, measure it, estimate it."""
    truth = draw_machine(one.design.machine, seed, curves=curves)
    data = measure(one.design, truth, seed)
    dimensions = {name: one.model.errors.parameters[name] for name in one.model.dimensions}
    given = ErrorValues(one.model.name, dimensions)
    found = estimate(one.model, replace(one.plan, reading=data.reading.copy()), given)
    points = random_points(one.design.machine, seed, POINTS)
    positions = np.array([points[axis] for axis in one.model.axes])
    model = one.model.with_values(found.values)
    best = oracle(one.design, curves).fit(truth.sizes, data.reading)
    covariance = covariance_of(found.layout, found.spread)
    u = tool_uncertainty(model, covariance, positions, TOOL, datum=home_of(model)).u.T
    off = deviations(model, positions, home=True) - truth.deviation(points, TOOL[:, 0], "home")
    return Outcome(
        true=rms_um(truth.deviation(points, TOOL[:, 0], "home")),
        error=rms_um(off),
        oracle=rms_um(_off(best.predict(points, TOOL[:, 0], "home")[0], truth, points, "home")),
        u=rms_um(u),
        coverage=float((np.abs(off) <= 1.96 * u).mean()),
        machine_error=rms_um(_off(deviations(model, positions, home=False), truth, points, "machine")),
        machine_oracle=rms_um(_off(best.predict(points, TOOL[:, 0])[0], truth, points, "machine")),
        found=found,
    )


def deviations(model: MachineModel, positions: Array, *, home: bool) -> Array:
    """(n, 3), mm, of the origin of the tool frame."""
    (found,) = model.view_deviations([("tool_in_workpiece", TOOL)], positions)
    if home:
        found = found - model.view_deviations([("tool_in_workpiece", TOOL)], home_of(model))[0]
    return np.asarray(found.T, float)


def rms_um(vectors: Array) -> float:
    """Root mean square of the lengths of vectors (n, 3), mm."""
    return 1e3 * float(np.sqrt(np.mean(np.sum(vectors**2, axis=1))))


def _off(predicted: Array, truth: Truth, points: Mapping[str, Array], datum: str) -> Array:
    return np.asarray(predicted - truth.deviation(points, TOOL[:, 0], datum), float)
