"""What a first plan promises and what the estimate makes of its readings.

`python -m tests.planning.promise [SEEDS]` prints, for machines of this repository and for random ones, the u of the
tool point that `plan --with` promises and the error of predictions over the volume from readings of machines drawn from
the prior.
"""

import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter

import numpy as np

from tests.planning.data import model
from tests.worlds.estimates import world
from trueaxis.estimation.curve_prior import DEGREE, CurvePrior
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.instruments import CLASSES, own_kinds
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.setting import EstimationOptions
from trueaxis.estimation.tool_point import Datum, moved_by, volume
from trueaxis.identification.weighting import NoiseModel
from trueaxis.measurement.instrument_kinds import Instrument
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.method import PlanOptions, Proposed, first_plan

TOOL = ((0.0, 0.0, 0.0),)
DATUMS: tuple[Datum, ...] = ("home", "best-fit")
NOISE = 1e-3  # mm
KITS: tuple[tuple[Instrument, ...], ...] = (("laser", "ballbar"), ("laser", "ballbar", "probe"))
WORLDS = (901, 902, 903, 904, 905, 906)
NAMES = ("dmu60p", "cframe_mill", "bridge_cmm", "gantry_mill", "trunnion_mill", "dmu60p_5axis", "headhead_mill")


@dataclass(frozen=True)
class Outcome:
    """Root mean squares over the volume, mm: promised u, error of predictions, and the true deviation."""

    promised: float
    error: float
    true: float


@dataclass(frozen=True)
class Shop:
    """A machine, its dimensions being known, and the plan made for it."""

    machine: MachineModel
    given: ErrorValues
    made: Proposed


def shop(
    machine: MachineModel,
    hours: float | None,
    instruments: tuple[Instrument, ...],
    dimensions: Mapping[str, float] = {},
) -> Shop:
    given = ErrorValues(machine=machine.name, parameters=dict(dimensions))
    options = PlanOptions(given=given, noise=NoiseModel(um=1e3 * NOISE), tools=TOOL)
    return Shop(machine, given, first_plan(machine, options, instruments, hours))


def prior_sizes(layout: Layout) -> FloatArray:
    """(n,): standard deviations that [prior] and the instruments say, mm, rad or 1."""
    curves = [np.exp(CurvePrior(basis).log_weights(np.zeros(2))[0]) for basis in layout.bases]
    rest = np.ones(layout.count - sum(basis.degree for basis in layout.bases))
    return np.concatenate([*curves, rest]) * layout.sizes


def readings(layout: Layout, observed: Observations, unknowns: FloatArray, given: ErrorValues, seed: int) -> FloatArray:
    """(n,), mm: of the exact model, with the own unknowns of every run and noise drawn."""
    draw = np.random.default_rng(seed)
    runs = measured_runs(observed)
    kinds = [own_kinds(one.rows.run, layout.straightness[one.rows.index]) for one in runs]
    own = [np.array([CLASSES[kind].size for kind in of_run]) * draw.standard_normal(len(of_run)) for of_run in kinds]
    found = np.zeros(observed.reading.size)
    for one, left in zip(runs, residuals_of(layout, runs, unknowns, own, given), strict=True):
        found[one.rows.at] = one.reading - left
    return found + NOISE * draw.standard_normal(found.size)


def outcomes(one: Shop, seed: int) -> dict[Datum, Outcome]:
    """Of one machine drawn from the prior, its noise and sizes being estimated, against every datum."""
    observed, expected = one.made.planned.observed, one.made.expected
    layout = layout_of(one.machine.with_values(one.given), observed, one.given)
    truth = prior_sizes(layout) * np.random.default_rng(1000 + seed).standard_normal(layout.count)
    reading = readings(layout, observed, truth, one.given, seed)
    options = EstimationOptions(degree=DEGREE)  # of the curves that are drawn, and that plan counts by
    found = estimate(one.machine, replace(observed, reading=reading), one.given, options)
    machine, result = slice(layout.of_machine), dict[Datum, Outcome]()
    for datum in DATUMS:
        moved = moved_by(layout, volume(layout.model), TOOL, datum)
        parts = (expected.spread[machine], (found.unknowns - truth)[machine], truth[machine])
        size = [float(np.linalg.norm(moved @ part) / np.sqrt(moved.shape[0] / 3.0)) for part in parts]
        result[datum] = Outcome(*size)
    return result


def machines() -> Iterator[tuple[str, MachineModel, Mapping[str, float]]]:
    """Those of the repository, dimensions zero, and some drawn at random, with theirs."""
    for name in NAMES:
        yield name, model(name), {}
    for seed in WORLDS:
        with TemporaryDirectory() as folder:
            drawn = world(seed, Path(folder)).model
            structure = "".join(drawn.axes)
            yield f"random {seed} ({structure})", drawn, {n: drawn.errors.parameters[n] for n in drawn.dimensions}


def ratio(each: list[Outcome]) -> float:
    """Error over promised u, root mean square over machines."""
    return float(np.sqrt(np.mean([(one.error / one.promised) ** 2 for one in each])))


def main() -> int:
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    columns = ["machine", "instruments", "hours", "runs", "seconds"]
    columns += [f"{name} {what}" for name in DATUMS for what in ("promised", "error", "ratio")]
    print(f"| {' | '.join(columns)} |\n|{'---|' * len(columns)}")
    for name, machine, dimensions in machines():
        for instruments in KITS:
            start = perf_counter()
            one = shop(machine, None, instruments, dimensions)
            took = perf_counter() - start
            every = [outcomes(one, seed) for seed in range(seeds)]
            text = []
            for datum in DATUMS:
                each = [found[datum] for found in every]
                error = 1e3 * float(np.sqrt(np.mean([found.error**2 for found in each])))
                text.append(f"{1e3 * each[0].promised:.3g} | {error:.3g} | {ratio(each):.2f}")
            hours = one.made.report.after.minutes / 60.0
            head = f"| {name} | {', '.join(instruments)} | {hours:.1f} | {len(one.made.runs)} | {took:.1f}"
            print(" | ".join([head, *text]) + " |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
