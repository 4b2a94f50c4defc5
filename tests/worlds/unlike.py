"""What the estimate makes of machines that are unlike what its prior expects, beside usual ones of the same designs.

    python -m tests.worlds.unlike --out FILE --designs 7 --first 7001 --machines 4 --kinds usual large
    python -m tests.worlds.unlike --out FILE --dense --designs 4 --machines 3 --kinds usual kinked
    python -m tests.worlds.unlike --out FILE --axes 5 --designs 8 --kinds usual turning
    python -m tests.worlds.unlike --out FILE --table

usual: as they are drawn; large: the positioning error of one linear axis is 5 to 10 times as large as translational
errors of the machine are; scale: the same, of a slope that is added; kinked: positioning errors of linear axes are
what a table of a control leaves, straight lines between 15 to 50 positions; turning: half of the mean square of every
error of a rotary axis that turns round repeats with the turn. --dense: only designs of 31 targets or more, with a fifth
of the noise; --axes: of so many axes, of five only those with an axis that turns round;
--no-harmonics: as if the estimate knew no turns. A line of JSON is a machine;
what is in FILE already is not done again.
"""

import argparse
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tests.worlds.curves import Curve, Span
from tests.worlds.design import Design, draw_design
from tests.worlds.estimates import TOOL, WITHIN, Outcome, World, deviations, outcome_of, rms_um, world
from tests.worlds.machine import Array, Machine
from tests.worlds.truth import Truth, draw_machine, span_of
from trueaxis.error_name import ErrorName
from trueaxis.estimation import curve_prior
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.estimation.judgement import judged_component, judged_location
from trueaxis.estimation.result import Estimate
from trueaxis.estimation.setting import USUAL, EstimationOptions
from trueaxis.model.errors import ErrorValues

Source = np.random.Generator

LARGE = (5.0, 10.0)  # times as large as translational errors of the machine are
KNOTS = (15, 51)  # of a table
TIMES = 6  # of a turn, up to which errors repeat
TURN = 360.0  # deg
LEFT = 0.3  # of a size: what a table is off by at its positions, one standard deviation, beside a smooth curve
DENSE, QUIET = 31, 0.2  # targets of a line; share of the noise of the design that is left
ALONG = 60  # positions over a travel
SEEDS_APART = 1000
FIGURES = ("true", "error", "oracle", "one_family", "set_ups_expected", "u", "coverage", "oracle_coverage")


def usual(truth: Truth, source: Source) -> Truth:
    return truth


def large(truth: Truth, source: Source) -> Truth:
    """One positioning error of a linear axis is far larger than other translational errors."""
    name, factor = _chosen(truth, source), float(source.uniform(*LARGE)) * _typical(truth)
    curve, size = truth.curves[name], truth.sizes[name]
    curves = {**truth.curves, name: replace(curve, coefficients=curve.coefficients * factor / size)}
    return replace(truth, curves=curves, sizes={**truth.sizes, name: factor})


def scale(truth: Truth, source: Source) -> Truth:
    """One linear axis has a scale that is off."""
    name, size = _chosen(truth, source), float(source.uniform(*LARGE)) * _typical(truth)
    span = span_of(truth.machine, name[2])
    slope = size * float(source.choice([-1.0, 1.0])) * 12.0**0.5 / (span.high - span.low)

    def line(at: Array) -> Array:
        return np.asarray(slope * (np.clip(at, span.low, span.high) - span.home), float)

    curves = {**truth.curves, name: truth.curves[name].plus(line)}
    return replace(truth, curves=curves, sizes={**truth.sizes, name: float(np.hypot(size, truth.sizes[name]))})


def kinked(truth: Truth, source: Source) -> Truth:
    """Positioning errors of linear axes are what a table of a control leaves."""
    curves = dict(truth.curves)
    for name in positioning(truth):
        curves[name] = table(source, curves[name], span_of(truth.machine, name[2]), truth.sizes[name])
    return replace(truth, curves=curves)


def table(source: Source, curve: Curve, span: Span, size: float) -> Curve:
    """Straight lines between positions at which it is near a smooth curve; zero at home."""
    knots = np.linspace(span.low, span.high, int(source.integers(*KNOTS)))
    values = curve(knots) + LEFT * size * source.standard_normal(knots.size)
    values -= np.interp(span.home, knots, values)
    return Curve(lambda at: np.interp(at, knots, values)[:, None], np.ones(1))


def turning(truth: Truth, source: Source) -> Truth:
    """Errors of rotary axes that turn round are half what repeats with the turn, each up to six times, from order to
    order less, by more or less.
    """
    curves = dict(truth.curves)
    for name in repeating(truth):
        span, size = span_of(truth.machine, name[2]), truth.sizes[name]
        weights = np.repeat(np.arange(1.0, TIMES + 1) ** -source.uniform(0.0, 2.0), 2)
        amplitudes = size * weights / np.linalg.norm(weights) * source.standard_normal(2 * TIMES)
        half = replace(curves[name], coefficients=curves[name].coefficients * 0.5**0.5)
        curves[name] = half.plus(waves(span, amplitudes * 0.5**0.5))
    return replace(truth, curves=curves)


def waves(span: Span, amplitudes: Array) -> Callable[[Array], Array]:
    """Zero at home; amplitudes: (2 k,), of cosines and sines of 1 .. k times the angle."""
    times = np.arange(1, amplitudes.size // 2 + 1)

    def of_turn(at: Array) -> Array:
        angles = np.deg2rad(np.clip(at, span.low, span.high))[..., None] * times
        return np.asarray(np.cos(angles) @ amplitudes[::2] + np.sin(angles) @ amplitudes[1::2], float)

    return lambda at: of_turn(at) - of_turn(np.array(span.home))


def repeating(truth: Truth) -> list[str]:
    """Errors of rotary axes that turn round."""
    return [name for name in truth.curves if turns_round(truth.machine, name[2])]


def turns_round(machine: Machine, axis: str) -> bool:
    return axis not in machine.linear and float(np.ptp(machine.travel(axis))) >= TURN


KINDS: Mapping[str, Callable[[Truth, Source], Truth]] = {
    one.__name__: one for one in (usual, large, scale, kinked, turning)
}


def positioning(truth: Truth) -> list[str]:
    """Positioning errors of linear axes."""
    return [name for name in truth.curves if name[1] == name[2]]


def _chosen(truth: Truth, source: Source) -> str:
    return str(source.choice(positioning(truth)))


def _typical(truth: Truth) -> float:
    """Geometric mean of the sizes of translational errors, as they are drawn about it, mm."""
    sizes = [size for name, size in truth.sizes.items() if name in truth.curves and name[1] in "XYZ"]
    return float(np.exp(np.mean(np.log(sizes))))


def quiet(design: Design) -> Design:
    """With little noise."""
    shop = design.shop
    less = {name: QUIET * getattr(shop, name) for name in ("white", "slow_mm", "walk_mm", "resolution")}
    return replace(design, shop=replace(shop, **less))


def line_of(one: World, kind: str, number: int, options: EstimationOptions = USUAL) -> dict[str, object]:
    """What is kept of a machine of a kind."""
    seed = SEEDS_APART * one.design.seed + number
    usual_one = draw_machine(one.design.machine, seed, curves=("smooth", "prior")[number % 2])
    truth = KINDS[kind](usual_one, np.random.default_rng([seed, 31]))
    found = outcome_of(one, truth, seed, options=options)
    unlike = [name for name in truth.curves if truth.curves[name] is not usual_one.curves[name]]
    own = np.array([curve_figures(found, truth, name) for name in unlike or positioning(truth)])
    readings, bases = found.found.readings, found.found.layout.bases
    return {
        "design": one.design.seed,
        "machine": number,
        "kind": kind,
        **{name: float(f"{getattr(found, name):.5g}") for name in FIGURES},
        "told": float(f"{without_the_prior(one, truth, found.found):.5g}"),
        "curve": [float(f"{value:.5g}") for value in np.sqrt(np.mean(own[:, :2] ** 2, axis=0))],
        "curve_coverage": float(np.mean(own[:, 2])),
        "higher": sum(basis.degree > DEGREE for basis in bases),
        "named": len(readings.contradicting) + len(readings.misread),
        "seconds": round(found.seconds, 2),
    }


def without_the_prior(one: World, truth: Truth, found: Estimate) -> float:
    """Root mean square of what the estimate is off by, um, if values that rest on the prior were left at zero."""
    layout, unknowns = found.layout, found.unknowns.copy()
    for place, component in enumerate(layout.components):
        if judged_component(found, component).determined == "prior":
            unknowns[layout.offsets[place] : layout.offsets[place + 1]] = 0.0
    for place, name in enumerate(layout.locations):
        if judged_location(found, name).determined == "prior":
            unknowns[layout.offsets[-1] + place] = 0.0
    dimensions = {name: one.model.errors.parameters[name] for name in one.model.dimensions}
    known = ErrorValues(machine=one.model.name, parameters=dimensions)
    model = one.model.with_values(layout.values(unknowns, known))
    positions = np.array([one.points[axis] for axis in model.axes])
    return rms_um(deviations(model, positions) - truth.deviation(one.points, TOOL[:, 0], "home"))


def curve_figures(outcome: Outcome, truth: Truth, name: str) -> tuple[float, float, float]:
    """Of an error over its travel: root mean squares of what it is off and of its u, um or urad; coverage."""
    found, span = outcome.found, span_of(truth.machine, name[2])
    layout, at = found.layout, np.linspace(span.low, span.high, ALONG)
    place = layout.components.index(ErrorName(name))
    rows = slice(layout.offsets[place], layout.offsets[place + 1])
    columns = layout.bases[place](at).T
    off = columns @ found.unknowns[rows] - truth.curves[name](at)
    u = np.linalg.norm(columns @ found.spread[rows], axis=1)
    unit = 1e3 if name[1] in "XYZ" else 1e6
    return unit * _rms(off), unit * _rms(u), float((np.abs(off) <= WITHIN * u).mean())


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, metavar="FILE", required=True)
    parser.add_argument("--table", action="store_true", help="print what is in FILE")
    parser.add_argument("--designs", type=int, default=12, metavar="N", help="%(default)s")
    parser.add_argument("--first", type=int, default=7001, metavar="SEED", help="of the first design (%(default)s)")
    parser.add_argument("--machines", type=int, default=4, metavar="M", help="of each kind and design (%(default)s)")
    parser.add_argument("--kinds", nargs="+", choices=tuple(KINDS), default=tuple(KINDS))
    parser.add_argument("--dense", action="store_true")
    parser.add_argument("--axes", type=int, choices=(3, 5), default=3, help="%(default)s")
    parser.add_argument("--no-harmonics", action="store_true")
    parser.add_argument("--degree", type=int, metavar="N", help="of all curves (as readings tell)")
    args = parser.parse_args(arguments)
    if args.no_harmonics:
        curve_prior.HARMONICS = 0
    if not args.table:
        designs, options = _designs(args.first, args.designs, args.dense, args.axes), replace(USUAL, degree=args.degree)
        measure_all(args.out, designs, args.kinds, args.machines, options)
    print("\n".join(tables(_lines(args.out))))
    return 0


def _designs(first: int, count: int, dense: bool, axes: int) -> list[Design]:
    found: list[Design] = []
    seed = first
    while len(found) < count:
        design = draw_design(seed, axes)
        seed += 1
        if axes == 5 and not any(turns_round(design.machine, axis) for axis in design.machine.axes):
            continue
        if not dense:
            found.append(design)
        elif design.habits.targets >= DENSE and design.ingredients["laser"]:
            found.append(quiet(design))
    return found


def measure_all(
    out: Path, designs: Sequence[Design], kinds: Sequence[str], machines: int, options: EstimationOptions
) -> None:
    done = {(line["design"], line["kind"], line["machine"]) for line in _lines(out)}
    out.parent.mkdir(parents=True, exist_ok=True)
    with out.open("a") as results:
        for design in designs:
            left = [(kind, k) for kind in kinds for k in range(machines) if (design.seed, kind, k) not in done]
            if not left:
                continue
            one = replace(
                world(design.seed, out.parent / "worlds" / str(design.seed), len(design.machine.axes)), design=design
            )
            for kind, number in left:
                results.write(json.dumps(line_of(one, kind, number, options)) + "\n")
                results.flush()


def _lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []


COLUMNS = (
    *("doing nothing", "off", "u", "coverage", "over the fit that knows the sizes", "worse than nothing", "worst"),
    *("without what rests on the prior", "curves off", "their u", "their coverage", "seconds"),
)


def tables(lines: Sequence[Mapping[str, Any]]) -> list[str]:
    """As Markdown, a row for each kind: root mean squares, um; ratios are geometric means."""
    found = ["| machines | of | " + " | ".join(COLUMNS) + " |", "|---" * (len(COLUMNS) + 2) + "|"]
    for kind in KINDS:
        of = [line for line in lines if line["kind"] == kind]
        if not of:
            continue
        each = {name: np.array([line[name] for line in of], float) for name in (*FIGURES, "told", "seconds")}
        curve, true, error = np.array([line["curve"] for line in of], float), each["true"], each["error"]
        cells = [
            *(f"{_rms(each[name]):.2f}" for name in ("true", "error", "u")),
            f"{each['coverage'].mean():.3f}",
            f"{_geometric(error / each['one_family']):.3f}",
            f"{int((error > true).sum())}",
            f"{float(np.max(error / true)):.2f}",
            f"{_geometric(each['told'] / error):.3f}",
            *(f"{_rms(one):.2f}" for one in curve.T),
            f"{np.mean([line['curve_coverage'] for line in of]):.3f}",
            f"{each['seconds'].mean():.1f}",
        ]
        found.append(f"| {kind} | {len(of)} | " + " | ".join(cells) + " |")
    return found


def _geometric(ratios: Array) -> float:
    return float(np.exp(np.mean(np.log(ratios))))


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2)))


if __name__ == "__main__":
    raise SystemExit(main())
