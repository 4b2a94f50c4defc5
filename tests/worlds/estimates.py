"""What the package's estimate makes of worlds, beside the oracle: predictions at random points of the volume.

All is judged from home, where work offsets are touched off: the deviation of the tool point less that at home.
"""

import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tests.kept import derived
from tests.worlds.design import Design, draw_design
from tests.worlds.files import spec_toml, write_world
from tests.worlds.machine import Array
from tests.worlds.oracle import Oracle, oracle, prediction_columns
from tests.worlds.readings import measure
from tests.worlds.shop import Unknown, every_unknown
from tests.worlds.truth import SIZES, Truth, draw_machine, random_points
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.observations import Observations, observations
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.setting import USUAL, EstimationOptions
from trueaxis.measurement.data import read_data
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, home_of, load_model
from trueaxis.model.uncertainty import tool_uncertainty

POINTS = 200
TOOL = np.zeros((3, 1))
WITHIN = 1.96  # standard uncertainties: a 95 % interval
WRONG = 3.0
# what [prior] says: nothing, the sizes about which machines are drawn, or sizes that are wrong
GIVEN: Mapping[str, Mapping[str, float]] = {
    "default": {},
    "right": SIZES,
    "3 times": {name: WRONG * size for name, size in SIZES.items()},
    "a third": {name: size / WRONG for name, size in SIZES.items()},
}
# What the package expects of set-ups, mm, rad or 1, by kind of unknown (docs/estimation.md): before any reading nobody
# knows more. A zero of a straightness line is that of its reflector, anywhere.
EXPECTED: Mapping[str, float] = {
    "zero": 3e-3,
    "zero across": 0.1,
    "drift": 1e-3,
    "slope": 50e-6,
    **dict.fromkeys(("centre_X", "centre_Y", "centre_Z"), 50e-3),
    "length": 20e-3,
    "scale": 1e-6,
    "cosine": 0.5e-6,
}
CLASSES = {
    "translation": ("translation_um", 1e-3),
    "rotation": ("rotation_urad", 1e-6),
    "location rad": ("location_urad", 1e-6),
    "location mm": ("location_um", 1e-3),
}


@dataclass(frozen=True, eq=False)
class World:
    """A design, and what all of its machines share.

    model: the package's kernels of its machine, with the default [prior]; models: by GIVEN; plan: as the package reads
    it; points: axis -> (n,); oracles: by family of curves and whether the set-ups are
    known; columns: by family, the derivative at the points.
    """

    design: Design
    models: Mapping[str, MachineModel]
    plan: Observations
    points: Mapping[str, Array]
    oracles: dict[tuple[str, bool], Oracle]
    columns: dict[str, Array]

    @property
    def model(self) -> MachineModel:
        return self.models["default"]


@dataclass(frozen=True)
class Outcome:
    """Of one machine, um, root mean squares of a coordinate over points: true deviation, error of the estimate, of the
    oracle, of the same fit where it does not know the family of the curves but takes all for draws of the prior, of
    that where it knows the size of a class, not of every error, and of that where it knows every size, but not the
    set-ups, and expects of them what the package does; u of the estimate; coverage, oracle_coverage: share of the
    coordinates within 1.96 u; sizes: class -> given, true and estimated, mm or rad, where the true one is the geometric
    mean over the members; seconds: of the estimate.
    """

    true: float
    error: float
    oracle: float
    one_family: float
    class_sizes: float
    set_ups_expected: float
    u: float
    coverage: float
    oracle_coverage: float
    sizes: Mapping[str, tuple[float, float, float]]
    seconds: float
    found: Estimate


def world(seed: int, folder: Path, axes: int | None = None) -> World:
    """Write and read a design; derive its kernels where that has not been done yet."""
    design = draw_design(seed, axes)
    truth = draw_machine(design.machine, seed)
    write_world(folder, design, truth, measure(design, truth, seed), sessions=design.ingredients["says_sessions"])
    kernels = derived(folder / "machine.toml")
    models = {}
    for name, sizes in reversed(list(GIVEN.items())):  # the default comes last and stays
        (folder / "machine.toml").write_text(spec_toml(design.machine, prior=sizes))
        models[name] = load_model(folder / "machine.toml", folder / "errors.json", kernels)
    data = read_data(folder / "data", models["default"])
    plan = observations(str(folder), data.setup.runs, data.readings)
    return World(design, models, plan, random_points(design.machine, seed, POINTS), {}, {})


def outcome(one: World, seed: int, curves: str = "smooth", given: str = "default") -> Outcome:
    """Draw a machine, measure it, estimate it."""
    return outcome_of(one, draw_machine(one.design.machine, seed, curves=curves), seed, given)


def outcome_of(
    one: World, truth: Truth, seed: int, given: str = "default", options: EstimationOptions = USUAL
) -> Outcome:
    """Measure a machine, estimate it."""
    reading = measure(one.design, truth, seed).reading
    model = one.models[given]
    dimensions = {name: model.errors.parameters[name] for name in model.dimensions}
    start = time.process_time()
    known = ErrorValues(machine=model.name, parameters=dimensions)
    found = estimate(model, replace(one.plan, reading=reading.copy()), known, options)
    seconds = time.process_time() - start
    positions = np.array([one.points[axis] for axis in model.axes])
    covariance = covariance_of(found.layout, found.spread)
    u = tool_uncertainty(model.with_values(found.values), covariance, positions, TOOL, datum=home_of(model)).u.T
    true = truth.deviation(one.points, TOOL[:, 0], "home")
    off = deviations(model.with_values(found.values), positions) - true
    of_oracle, u_of_oracle = _oracle(one, truth, reading)
    drawn = replace(truth, family="prior")
    of_one_family, _ = _oracle(one, drawn, reading)
    of_class_sizes, _ = _oracle(one, replace(drawn, sizes=_class_sizes(model, truth)), reading)
    of_expected, _ = _oracle(one, drawn, reading, set_ups_known=False)
    return Outcome(
        true=rms_um(true),
        error=rms_um(off),
        oracle=rms_um(of_oracle - true),
        one_family=rms_um(of_one_family - true),
        class_sizes=rms_um(of_class_sizes - true),
        set_ups_expected=rms_um(of_expected - true),
        u=rms_um(u),
        coverage=float((np.abs(off) <= WITHIN * u).mean()),
        oracle_coverage=float((np.abs(of_oracle - true) <= WITHIN * u_of_oracle).mean()),
        sizes=_sizes(model, truth, found),
        seconds=seconds,
        found=found,
    )


def _oracle(one: World, truth: Truth, reading: Array, set_ups_known: bool = True) -> tuple[Array, Array]:
    """Prediction and standard uncertainty of the oracle, (n, 3) each, mm."""
    family, machine = truth.family, one.design.machine
    yardstick = (family, set_ups_known)
    if yardstick not in one.oracles:
        one.oracles[yardstick] = oracle(one.design if set_ups_known else _set_ups_expected(one.design), family)
    if family not in one.columns:
        one.columns[family] = prediction_columns(machine, family, one.points, TOOL[:, 0], "home")
    fit = one.oracles[yardstick].fit(truth.sizes, reading)
    return fit.predict(one.points, TOOL[:, 0], "home", one.columns[family])


def _set_ups_expected(design: Design) -> Design:
    """What its readings look like to somebody who knows the noise, but nothing of the set-ups."""
    across = {run.id for run in design.plan.runs if run.across}

    def expected(unknown: Unknown) -> Unknown:
        kind = "zero across" if unknown.kind == "zero" and unknown.scope in across else unknown.kind
        return replace(unknown, spread=EXPECTED[kind])

    shop = design.shop
    every = [expected(one) for one in every_unknown(design.machine, design.plan)]
    others = [one for one in shop.unknowns if one.kind not in EXPECTED]  # creep, a bar that warms up
    return replace(design, shop=replace(shop, unknowns=(*every, *others)))


def _sizes(model: MachineModel, truth: Truth, found: Estimate) -> dict[str, tuple[float, float, float]]:
    prior = model.prior
    given = dict(
        zip(CLASSES, (prior.translation, prior.rotation, prior.location_angle, prior.location_length), strict=True)
    )
    return {
        kind: (
            given[kind],
            float(np.exp(np.mean(np.log([truth.sizes[name] for name in names])))),
            given[kind] * found.factors[kind],
        )
        for kind, names in _classes(model, truth).items()
    }


def _class_sizes(model: MachineModel, truth: Truth) -> dict[str, float]:
    """Name of an error -> root mean square of the sizes of its class, mm or rad: as a spec can state them."""
    return {
        name: float(np.sqrt(np.mean([truth.sizes[other] ** 2 for other in names])))
        for names in _classes(model, truth).values()
        for name in names
    }


def _classes(model: MachineModel, truth: Truth) -> dict[str, list[str]]:
    """Class of sizes -> names of its component and location errors."""
    found: dict[str, list[str]] = {}
    for name in truth.sizes:
        if name in truth.curves:
            kind = "translation" if name[1] in "XYZ" else "rotation"
        else:
            kind = f"location {model.machine.parameter_unit(name)}"
        found.setdefault(kind, []).append(name)
    return found


def deviations(model: MachineModel, positions: Array) -> Array:
    """(n, 3), mm, of the origin of the tool frame, from home."""
    (found,) = model.view_deviations([("tool_in_workpiece", TOOL)], positions)
    found = found - model.view_deviations([("tool_in_workpiece", TOOL)], home_of(model))[0]
    return np.asarray(found.T, float)


def rms_um(vectors: Array) -> float:
    """Root mean square of a coordinate of vectors (n, 3), mm."""
    return 1e3 * float(np.sqrt(np.mean(vectors**2)))
