"""What a first plan promises and what the estimate makes of its readings.

`python -m tests.plan.promise [SEEDS]` prints, for machines of this repository, the u of the tool point that `plan
--with` promises and the error of predictions at random points from readings of machines drawn from the prior.
"""

import sys
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np

from tests.plan.data import model
from trueaxis.estimation.curve_prior import CurvePrior
from trueaxis.estimation.estimate import estimate
from trueaxis.estimation.instruments import OWN_SIZES, own_kinds
from trueaxis.estimation.layout import Layout, layout_of
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.runs import measured_runs
from trueaxis.estimation.tool_point import Datum, moved_by, volume
from trueaxis.identify.weighting import NoiseModel
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.setup import Instrument
from trueaxis.plan.method import PlanOptions, Proposed, first_plan
from trueaxis.runtime.errors import ErrorValues

TOOL = ((0.0, 0.0, 0.0),)
NOISE = 1e-3  # mm
NAMES = ("dmu60p", "cframe_mill", "bridge_cmm", "gantry_mill", "trunnion_mill", "dmu60p_5axis", "headhead_mill")


@dataclass(frozen=True)
class Outcome:
    """Root mean squares over the volume, mm: promised u, error of predictions, and the true deviation."""

    promised: float
    error: float
    true: float


def plan_of(name: str, hours: float | None, instruments: tuple[Instrument, ...], datum: Datum = "home") -> Proposed:
    options = PlanOptions(given=ErrorValues(name), noise=NoiseModel(um=1e3 * NOISE), tools=TOOL, datum=datum)
    return first_plan(model(name), options, instruments, hours)


def prior_sizes(layout: Layout) -> FloatArray:
    """(n,): standard deviations that [prior] and the instruments say, mm, rad or 1."""
    curves = [np.exp(CurvePrior(basis).log_weights(np.zeros(2))[0]) for basis in layout.bases]
    rest = np.ones(layout.count - sum(basis.degree for basis in layout.bases))
    return np.concatenate([*curves, rest]) * layout.sizes


def readings(layout: Layout, observed: Observations, unknowns: FloatArray, seed: int) -> FloatArray:
    """(n,), mm: of the exact model, with the own unknowns of every run and noise drawn."""
    draw = np.random.default_rng(seed)
    runs = measured_runs(observed)
    kinds = [own_kinds(one.rows.run, layout.straightness[one.rows.index]) for one in runs]
    own = [np.array([OWN_SIZES[kind] for kind in of_run]) * draw.standard_normal(len(of_run)) for of_run in kinds]
    found = np.zeros(observed.reading.size)
    for one, left in zip(runs, residuals_of(layout, runs, unknowns, own, ErrorValues(layout.model.name)), strict=True):
        found[one.rows.at] = one.reading - left
    return found + NOISE * draw.standard_normal(found.size)


def outcome(name: str, made: Proposed, seed: int, datum: Datum = "home") -> Outcome:
    """Of one machine drawn from the prior, its noise and sizes being estimated."""
    observed = made.planned.observed
    layout = layout_of(model(name), observed, ErrorValues(name))
    truth = prior_sizes(layout) * np.random.default_rng(1000 + seed).standard_normal(layout.count)
    found = estimate(model(name), replace(observed, reading=readings(layout, observed, truth, seed)))
    moved = moved_by(layout, volume(model(name)), TOOL, datum)
    count = moved.shape[0] / 3.0
    off = moved @ (found.unknowns - truth)[: layout.of_machine]
    spread = moved @ made.expected.spread[: layout.of_machine]
    true = moved @ truth[: layout.of_machine]
    return Outcome(*(float(np.linalg.norm(part) / np.sqrt(count)) for part in (spread, off, true)))


def ratio(each: list[Outcome]) -> float:
    """Error over promised u, root mean square over machines."""
    return float(np.sqrt(np.mean([(one.error / one.promised) ** 2 for one in each])))


def main() -> int:
    seeds = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    print("machine         instruments            hours  runs  plan s  u from home: promised  error  ratio   best fit: "
          "promised  error  ratio  (um)")  # fmt: skip
    for name in NAMES:
        for instruments in (("laser", "ballbar"), ("laser", "ballbar", "probe")):
            start = perf_counter()
            made = plan_of(name, None, instruments)
            took = perf_counter() - start
            text = []
            for datum in ("home", "best-fit"):
                each = [outcome(name, made, seed, datum) for seed in range(seeds)]
                error = 1e3 * float(np.sqrt(np.mean([one.error**2 for one in each])))
                text.append(f"{1e3 * each[0].promised:8.3g}  {error:8.3g}  {ratio(each):5.2f}")
            hours = made.report.after.minutes / 60.0
            print(f"{name:<14}  {' '.join(instruments):<22} {hours:5.1f} {len(made.runs):5d}  {took:6.1f}     "
                  + "      ".join(text), flush=True)  # fmt: skip
    return 0


if __name__ == "__main__":
    sys.exit(main())
