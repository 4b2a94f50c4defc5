"""Write a world as files, or print what worlds are made of.

    python -m tests.worlds SEED --out DIR [--effect KIND COMPONENT SIZE] [--worn COMPONENT SIZE] [--sessions]
    python -m tests.worlds --table N [--first SEED] [--machines M] [--curves prior]
    python -m tests.worlds --estimate N [--first SEED] [--machines M] [--curves prior]

DIR gets machine.toml, errors.json, data/setup.toml, data/readings.csv and, in DIR/truth, points.csv with random points
of the working volume and deviations.csv with the true deviation at each. SIZE is in mm, rad, s as docs/effects.md has
it.
"""

import argparse
import tempfile
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.worlds.design import Design, draw_design
from tests.worlds.effects import OF_RUNS, ON_COMPONENTS, ON_LOCATIONS, ON_READINGS, Effect
from tests.worlds.estimates import outcome, world
from tests.worlds.files import deviations_csv, points_csv, write_world
from tests.worlds.oracle import Figures, figures, oracle
from tests.worlds.readings import measure, measure_all
from tests.worlds.stale import worn_at
from tests.worlds.truth import draw_machine, random_points

POINTS = 200
COLUMNS = ("true", "error", "oracle", "u", "machine_error", "machine_oracle")
TOOL_POINT = np.zeros(3)
WRITTEN = tuple(kind for kind in (*ON_COMPONENTS, *ON_READINGS, *ON_LOCATIONS) if kind not in (*OF_RUNS, "cross_axis"))


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int, nargs="?", help="of the design, its machine and its noise")
    parser.add_argument("--out", type=Path, metavar="DIR")
    parser.add_argument("--axes", type=int, choices=(3, 5), help="default: drawn")
    parser.add_argument("--curves", choices=("smooth", "prior"), default="smooth")
    parser.add_argument("--effect", nargs=3, action="append", default=[], metavar=("KIND", "COMPONENT", "SIZE"))
    parser.add_argument("--worn", nargs=2, metavar=("COMPONENT", "SIZE"), help="errors.json: the truth before a wear")
    parser.add_argument(
        "--sessions",
        action="store_true",
        help="say in setup.toml which runs are of one session, and what devices resolve",
    )
    parser.add_argument("--table", type=int, metavar="N", help="designs FIRST to FIRST + N - 1 as a table")
    parser.add_argument(
        "--estimate", type=int, metavar="N", help="the package's estimate on as many designs, as a table"
    )
    parser.add_argument("--first", type=int, default=1, metavar="SEED")
    parser.add_argument(
        "--machines", type=int, default=4, metavar="M", help="of each design of the table (%(default)s)"
    )
    args = parser.parse_args(arguments)
    unknown = [kind for kind, _, _ in args.effect if kind not in WRITTEN]
    if unknown:
        parser.error(f"no effect that can be written so: {', '.join(unknown)}; there are {', '.join(WRITTEN)}")
    if args.table:
        print_table(range(args.first, args.first + args.table), args.machines, args.curves)
        return 0
    if args.estimate:
        print_estimates(range(args.first, args.first + args.estimate), args.machines, args.curves)
        return 0
    if args.seed is None or args.out is None:
        parser.error("give SEED and --out DIR, or --table N")
    write(args)
    return 0


def write(args: argparse.Namespace) -> None:
    design = draw_design(args.seed, args.axes)
    hidden = [
        Effect(kind, "" if component == "-" else component, float(size), shape=number)
        for number, (kind, component, size) in enumerate(args.effect, start=1)
    ]
    truth = draw_machine(design.machine, args.seed, curves=args.curves).hiding(*hidden)
    given = worn_at(truth, args.worn[0], float(args.worn[1]), args.seed) if args.worn else None
    data = measure(design, truth, args.seed)
    write_world(args.out, design, truth, data, given, sessions=args.sessions)
    points = random_points(design.machine, args.seed, POINTS)
    (args.out / "truth").mkdir(exist_ok=True)
    (args.out / "truth" / "points.csv").write_text(points_csv(design.machine, points, TOOL_POINT))
    deviation = truth.deviation(points, TOOL_POINT)
    (args.out / "truth" / "deviations.csv").write_text(deviations_csv(deviation))


def print_table(seeds: Sequence[int], machines: int, curves: str) -> None:
    """A line per design, then a line per ingredient with the medians of its designs."""
    print("                            machine datum, um       home datum, um")
    print("seed  axes  readings  runs   true  oracle  its u    true  oracle   coverage  whitened  structure; not there")
    rows: list[tuple[Design, Figures]] = []
    for seed in seeds:
        design = draw_design(seed)
        found = judge(design, machines, curves)
        rows.append((design, found))
        missing = " ".join(name for name in design.ingredients if name.startswith("no_") and design.ingredients[name])
        print(
            f"{seed:4d}  {len(design.machine.axes):4d}  {design.plan.count:8d}  {len(design.plan.runs):4d}  "
            f"{found.true_um:5.1f}  {found.error_um:6.2f}  {found.u_um:5.2f}   "
            f"{found.home_true_um:5.1f}  {found.home_error_um:6.2f}   "
            f"{found.coverage:8.3f}  {found.whitened:8.3f}  {design.machine.structure}; {missing}",
            flush=True,
        )
    print("\ningredient            designs  oracle/true  oracle/true from home  coverage  whitened (medians)")
    for name in rows[0][0].ingredients:
        own = [found for design, found in rows if design.ingredients[name]]
        middle = [
            float(np.median(values)) if values else float("nan")
            for values in (
                [found.error_um / found.true_um for found in own],
                [found.home_error_um / found.home_true_um for found in own],
                [found.coverage for found in own],
                [found.whitened for found in own],
            )
        ]
        print(f"{name:21s} {len(own):8d}  {middle[0]:11.3f}  {middle[1]:21.3f}  {middle[2]:8.3f}  {middle[3]:8.3f}")


def print_estimates(seeds: Sequence[int], machines: int, curves: str) -> None:
    """A line per design, root mean squares over its machines, then a line per ingredient, medians of its designs."""
    print("                            from home, um                                machine datum")
    print(
        "seed  axes  readings  runs   true  estimate  oracle  ratio      u  coverage  ratio  worse than nothing; most"
    )
    rows: list[tuple[Design, float, float, float]] = []
    for seed in seeds:
        with tempfile.TemporaryDirectory() as folder:
            one = world(seed, Path(folder))
            each = [outcome(one, 1000 * seed + number, curves) for number in range(machines)]
        mean = {name: _rms([getattr(found, name) for found in each]) for name in COLUMNS}
        coverage = float(np.mean([found.coverage for found in each]))
        worse = sum(found.error > found.true for found in each)
        most = max(found.error / found.true for found in each)
        ratio, beside = mean["error"] / mean["oracle"], mean["machine_error"] / mean["machine_oracle"]
        rows.append((one.design, ratio, mean["error"] / mean["true"], coverage))
        not_converged = sum(not found.found.converged for found in each)
        plan, axes = one.design.plan, len(one.design.machine.axes)
        print(
            f"{seed:4d}  {axes:4d}  {plan.count:8d}  {len(plan.runs):4d}  {mean['true']:5.1f}  {mean['error']:8.2f}  "
            f"{mean['oracle']:6.2f}  {ratio:5.2f}  {mean['u']:5.2f}  {coverage:8.3f}  {beside:5.2f}  "
            f"{worse} of {machines}, {most:.2f}" + (f"; {not_converged} not converged" if not_converged else ""),
            flush=True,
        )
    print("\ningredient            designs  estimate/oracle  estimate/true  coverage (medians)")
    for name in rows[0][0].ingredients:
        own = [row[1:] for row in rows if row[0].ingredients[name]]
        if own:
            middle = np.median(np.array(own), axis=0)
            print(f"{name:21s} {len(own):8d}  {middle[0]:15.2f}  {middle[1]:13.2f}  {middle[2]:8.3f}")


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))


def judge(design: Design, machines: int, curves: str) -> Figures:
    """The oracle's figures over some machines of a design."""
    seeds = [1000 * design.seed + number for number in range(machines)]
    truths = [draw_machine(design.machine, seed, curves=curves) for seed in seeds]
    half = oracle(design, curves)
    pairs = zip(truths, measure_all(design, truths, seeds), strict=True)
    fits = [half.fit(truth.sizes, data.reading) for truth, data in pairs]
    return figures(fits, truths, random_points(design.machine, design.seed, POINTS), TOOL_POINT)


if __name__ == "__main__":
    raise SystemExit(main())
