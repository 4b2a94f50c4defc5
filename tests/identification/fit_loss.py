"""What polynomials in place of the curves of an estimate cost: error of the predicted tool point before and after.

python -m tests.identification.fit_loss --first 401 --designs 10      # random designs, smooth curves, real shops
"""

import argparse
import tempfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tests.worlds.estimates import TOOL, World, deviations, rms_um, world
from tests.worlds.readings import measure
from tests.worlds.truth import draw_machine, random_points
from trueaxis.identification.estimated import IdentifyOptions, identify_estimated
from trueaxis.identification.legendre_fit import fit_legendre, with_polynomials
from trueaxis.identification.report import Identification
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import LegendreCurve
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import home_of
from trueaxis.model.uncertainty import tool_uncertainty

POINTS = 200


@dataclass(frozen=True, slots=True, kw_only=True)
class Loss:
    """From home, um, root mean squares of vectors: true deviation, error of the curves and of the polynomials;
    coverage of 1.96 u before and after; curves that became polynomials, and all.
    """

    true: float
    curves: float
    polynomials: float
    coverage: float
    coverage_after: float
    fitted: int
    components: int


def identified(one: World, seed: int) -> Identification:
    data = measure(one.design, draw_machine(one.design.machine, seed), seed)
    known = ErrorValues(
        machine=one.model.name, parameters={name: one.model.errors.parameters[name] for name in one.model.dimensions}
    )
    return identify_estimated(one.model, replace(one.plan, reading=data.reading.copy()), IdentifyOptions(known=known))


def loss(one: World, seed: int, max_order: int = 7) -> Loss:
    """Of one machine: drawn, measured, estimated, fitted."""
    found = identified(one, seed)
    fits, _ = fit_legendre(found.values, found.covariance, one.model.machine, max_order=max_order, alpha=0.05)
    fitted, covariance = with_polynomials(found.values, found.covariance, one.model.machine, fits)
    truth = draw_machine(one.design.machine, seed)
    points = random_points(one.design.machine, seed, POINTS)
    positions = np.array([points[axis] for axis in one.model.axes])
    true = truth.deviation(points, TOOL[:, 0], "home")

    def judged(values: ErrorValues, of: Covariance) -> tuple[float, float]:
        model = one.model.with_values(values)
        off = deviations(model, positions) - true
        u = tool_uncertainty(model, of, positions, TOOL, datum=home_of(model)).u.T
        return rms_um(off), float((np.abs(off) <= 1.96 * u).mean())

    before, after = judged(found.values, found.covariance), judged(fitted, covariance)
    curves = fitted.motion_errors.values()
    return Loss(
        true=rms_um(true),
        curves=before[0],
        polynomials=after[0],
        coverage=before[1],
        coverage_after=after[1],
        fitted=sum(not isinstance(curve, LegendreCurve) for curve in curves),
        components=len(curves),
    )


def main(arguments: Sequence[str] | None = None) -> None:
    """A row for each design."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=401)
    parser.add_argument("--designs", type=int, default=10)
    parser.add_argument("--max-order", type=int, default=7)
    parser.add_argument("--axes", type=int, choices=(3, 5))
    args = parser.parse_args(arguments)
    print("| seed | readings | doing nothing, um | curves | polynomials | ratio | coverage | after | fitted |")
    print("|---|---|---|---|---|---|---|---|---|")
    ratios = []
    for seed in range(args.first, args.first + args.designs):
        with tempfile.TemporaryDirectory() as folder:
            one = world(seed, Path(folder), args.axes)
            got = loss(one, seed, args.max_order)
        ratios.append(got.polynomials / got.curves)
        print(
            f"| {seed} | {one.plan.reading.size} | {got.true:.1f} | {got.curves:.2f} | {got.polynomials:.2f} | "
            f"{ratios[-1]:.3f} | {got.coverage:.3f} | {got.coverage_after:.3f} | {got.fitted} of {got.components} |",
            flush=True,
        )
    print(f"\nratio: median {np.median(ratios):.3f}, largest {max(ratios):.3f}")


if __name__ == "__main__":
    main()
