"""Measuring plans drawn at random, with readings of errors drawn at random: lines and circles with offsets.

`python -m tests.identification.random_plans 10` prints how the estimate ended on so many of them.
"""

import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.identification.weighting import NoiseModel
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import expected_readings
from trueaxis.measurement.setup import PointOn, Run, Vector
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_model
from trueaxis.model.uncertainty import tool_uncertainty
from trueaxis.view import Carrier

ROOT = Path(__file__).parents[2]
MACHINES = ("dmu60p", "gantry_mill", "bridge_cmm", "cframe_mill", "trunnion_mill", "headhead_mill", "dmu60p_5axis")
SIZES = {"mm": 0.01, "rad": 2e-5}
LOCATION = {"mm": 0.05, "rad": 5e-5}
KNOTS = 25


@dataclass(frozen=True, eq=False)
class Drawn:
    """A plan with its readings, and what is true of the machine."""

    model: MachineModel
    observed: Observations
    truth: ErrorValues
    noise_um: float


def model_of(name: str) -> MachineModel:
    return load_model(ROOT / "machines" / f"{name}.toml", None, ROOT / "generated", backend="numpy")


def drawn(rng: np.random.Generator, name: str, lines: int, circles: int, count: int, noise_um: float) -> Drawn:
    """`count` readings of each of so many lines and circles."""
    model = model_of(name)
    truth = errors(rng, model)
    model = model.with_values(ErrorValues(machine=model.name, parameters=dimensions(model, truth)))
    runs, positions = [], []
    for number in range(lines):
        runs.append(line_run(rng, model, f"line-{number}"))
        positions.append(line(rng, model, count))
    for number in range(circles):
        run, at = circle(rng, model, f"circle-{number}", count)
        runs.append(run)
        positions.append(at)
    index = np.repeat(np.arange(len(runs)), [at.shape[1] for at in positions])
    at = np.hstack(positions)
    reading = expected_readings(model.with_values(truth), runs, index, at) + rng.normal(
        0.0, noise_um * 1e-3, index.size
    )
    return Drawn(
        model,
        Observations(source="readings.csv", runs=tuple(runs), run=index, positions=at, reading=reading),
        truth,
        noise_um,
    )


def errors(rng: np.random.Generator, model: MachineModel) -> ErrorValues:
    """Cubic curves with something smooth on them, tabled finely, and location errors."""
    curves: dict[str, Curve] = {}
    for component in model.components:
        low, high = model.travel[component[2]]
        at = np.linspace(low, high, KNOTS)
        size = SIZES["mm" if component[1] in "XYZ" else "rad"]
        s = at / max(abs(low), abs(high), 1.0)
        smooth = 0.1 * np.sin(2.0 * np.pi * rng.uniform(0.5, 1.5) * s)
        values = size * (s * rng.normal(size=1) + s**2 * rng.normal(size=1) + s**3 * rng.normal(size=1) + smooth)
        power = np.polynomial.Polynomial.fit(at, values - np.interp(0.0, at, values), 7, domain=[-1.0, 1.0])
        coefficients = power.coef.tolist()[1:]
        curves[component] = PolynomialCurve(powers=tuple(range(1, 8)), coefficients=tuple(coefficients))
    units = [model.machine.parameter_unit(name) for name in model.location_errors]
    located = {n: float(LOCATION[u] * rng.normal()) for n, u in zip(model.location_errors, units, strict=True)}
    sizes = {name: float(rng.uniform(-50.0, 50.0)) for name in model.dimensions}
    return ErrorValues(machine=model.name, parameters={**sizes, **located}, motion_errors=curves)


def dimensions(model: MachineModel, truth: ErrorValues) -> dict[str, float]:
    return {name: truth.parameters[name] for name in model.dimensions}


def line_run(rng: np.random.Generator, model: MachineModel, run_id: str) -> Run:
    """A laser or probe with a random point; its direction an axis of the frame, or any."""
    direction = np.eye(3)[rng.integers(3)] if rng.random() < 0.7 else rng.normal(size=3)
    direction = direction / np.linalg.norm(direction)
    on: Carrier = "tool" if rng.random() < 0.6 else "workpiece"
    other: Carrier = "workpiece" if on == "tool" else "tool"
    reference = PointOn("bed") if rng.random() < 0.5 else PointOn(other, point(rng))
    instrument: Instrument = "laser" if rng.random() < 0.8 else "probe"
    home = {axis: float(min(max(0.0, low), high)) for axis, (low, high) in model.travel.items()}
    unit: Vector = tuple(direction.tolist())
    return Run(
        id=run_id,
        instrument=instrument,
        target=PointOn(on, point(rng)),
        reference=reference,
        frame="bed",
        home=home,
        direction=unit,
    )


def point(rng: np.random.Generator) -> Vector:
    x, y, z = rng.uniform(-200.0, 200.0, 3).tolist()
    return (x, y, z)


def line(rng: np.random.Generator, model: MachineModel, count: int) -> FloatArray:
    """(n_axes, count): one axis, two or all from anywhere to anywhere, the others anywhere."""
    moving = rng.choice(len(model.axes), size=rng.integers(1, min(3, len(model.axes)) + 1), replace=False)
    low, high = np.array([model.travel[axis] for axis in model.axes]).T
    start, end = (low + rng.random(low.size) * (high - low) for _ in range(2))
    end = np.where(np.isin(np.arange(low.size), moving), end, start)
    return np.asarray(start[:, np.newaxis] + np.linspace(0.0, 1.0, count) * (end - start)[:, np.newaxis])


def circle(rng: np.random.Generator, model: MachineModel, run_id: str, count: int) -> tuple[Run, FloatArray]:
    """A ball bar round a point anywhere, in the plane of two linear axes, the others anywhere."""
    linear = [row for row, axis in enumerate(model.axes) if axis in "XYZ"]
    low, high = np.array([model.travel[axis] for axis in model.axes]).T
    first, second = rng.choice(linear, size=2, replace=False)
    radius = float(0.45 * min(high[first] - low[first], high[second] - low[second], 600.0) * rng.uniform(0.4, 1.0))
    centre = low + rng.random(low.size) * (high - low)
    for row in (first, second):
        centre[row] = rng.uniform(low[row] + radius, high[row] - radius)
    turn = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    at = np.repeat(centre[:, np.newaxis], count, axis=1)
    at[first] += radius * np.cos(turn)
    at[second] += radius * np.sin(turn)
    tool = PointOn("tool", point(rng))
    ball = model.view_ideal("tool_in_workpiece", centre[:, np.newaxis], np.array(tool.point)[:, np.newaxis])[:, 0]
    x, y, z = ball.tolist()
    home = dict.fromkeys(model.axes, 0.0)
    return Run(
        id=run_id,
        instrument="ballbar",
        target=tool,
        reference=PointOn("workpiece", (x, y, z)),
        frame="workpiece",
        home=home,
        length=round(radius, 3),
    ), at


@dataclass(frozen=True)
class Outcome:
    """How a fit ended, and its residuals over the noise; of the tool point at positions anywhere: rms deviation and
    what the identified values are off by (um); share of the coordinates whose uncertainty is said to be open; of the
    others: median uncertainty (um), rms of what they are off by, in uncertainties.
    """

    state: str
    ratio: float
    deviation_um: float = np.nan
    off_um: float = np.nan
    open: float = np.nan
    u_um: float = np.nan
    off_in_u: float = np.nan


def outcome(one: Drawn, options: IdentifyOptions, points: int = 500) -> Outcome:
    """Identify, and compare with the truth."""
    known = ErrorValues(machine=one.model.name, parameters=dimensions(one.model, one.truth))
    try:
        found = identify_estimated(one.model, one.observed, replace(options, known=known))
    except NotConvergedError as failure:
        return Outcome("not converged", failure.runs[0].rms_um / one.noise_um)
    fit = found.values.fit
    assert fit is not None
    true, model = one.model.with_values(one.truth), one.model.with_values(found.values)
    low, high = np.array([model.travel[axis] for axis in model.axes]).T[..., np.newaxis]
    at = low + np.random.default_rng(0).random((len(model.axes), points)) * (high - low)
    deviation, guess = (each.deviation(at, np.zeros((3, 1))) for each in (true, model))
    u = tool_uncertainty(model, found.covariance, at, np.zeros((3, 1)), datum=None).u
    told = np.isfinite(u)
    return Outcome(
        fit.state,
        found.report.residual_rms_um / one.noise_um,
        _rms_um(deviation),
        _rms_um(deviation - guess),
        float(np.mean(~told)),
        float(np.median(u[told])) * 1e3 if told.any() else np.nan,
        float(np.sqrt(np.mean(((deviation - guess)[told] / u[told]) ** 2))) if told.any() else np.nan,
    )


def _rms_um(values: FloatArray) -> float:
    return float(np.sqrt(np.mean(values**2))) * 1e3


def main(count: int) -> None:
    """A line for each plan."""
    for seed in range(count):
        rng = np.random.default_rng(seed)
        name = MACHINES[seed % len(MACHINES)]
        lines, circles, readings = (int(rng.integers(*ends)) for ends in ((5, 40), (0, 8), (20, 250)))
        one = drawn(rng, name, lines, circles, readings, 0.3)
        end = outcome(one, IdentifyOptions(noise=NoiseModel(um=one.noise_um)))
        print(
            f"{seed:3d} {name:14s} {lines:3d} lines {circles:2d} circles {one.observed.reading.size:6d} readings: "
            f"{end.state:13s} residual/noise {end.ratio:8.3f}; anywhere off by {end.off_um:8.2f} of "
            f"{end.deviation_um:6.2f} um, open {end.open:4.0%}, else u {end.u_um:7.3g} um and off by "
            f"{end.off_in_u:5.2f} u",
            flush=True,
        )


if __name__ == "__main__":
    main(int(sys.argv[1]))
