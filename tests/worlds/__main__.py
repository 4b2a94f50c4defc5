"""Write a world as files, or print what worlds are made of.

    python -m tests.worlds SEED --out DIR [--effect KIND COMPONENT SIZE] [--worn COMPONENT SIZE] [--sessions] [--angles]
    python -m tests.worlds --table N [--first SEED] [--machines M] [--curves prior]
    python -m tests.worlds --shares N [--first SEED]

DIR gets machine.toml, errors.json, data/setup.toml, data/readings.csv and, in DIR/truth, points.csv with random points
of the working volume and deviations.csv with the true deviation at each. SIZE is in mm, rad, s as docs/effects.md has
it.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tests.worlds.angles import draw_angles, write_angles
from tests.worlds.design import Design, draw_design
from tests.worlds.effects import OF_RUNS, ON_COMPONENTS, ON_LOCATIONS, ON_READINGS, Effect
from tests.worlds.files import deviations_csv, points_csv, write_world
from tests.worlds.oracle import Figures, figures, oracle
from tests.worlds.readings import measure, measure_all
from tests.worlds.stale import worn_at
from tests.worlds.truth import draw_machine, random_points

POINTS = 200
TOOL_POINT = np.zeros(3)
WRITTEN = tuple(kind for kind in (*ON_COMPONENTS, *ON_READINGS, *ON_LOCATIONS) if kind not in (*OF_RUNS, "cross_axis"))


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("seed", type=int, nargs="?", help="of the design, its machine and its noise")
    parser.add_argument("--out", type=Path, metavar="DIR")
    parser.add_argument("--axes", type=int, choices=(3, 4, 5), help="default: drawn")
    parser.add_argument("--curves", choices=("smooth", "prior"), default="smooth")
    parser.add_argument("--effect", nargs=3, action="append", default=[], metavar=("KIND", "COMPONENT", "SIZE"))
    parser.add_argument("--worn", nargs=2, metavar=("COMPONENT", "SIZE"), help="errors.json: the truth before a wear")
    parser.add_argument(
        "--sessions",
        action="store_true",
        help="say in setup.toml which runs are of one session, and what devices resolve",
    )
    parser.add_argument("--angles", action="store_true", help="and angle runs of every axis, drawn apart from the rest")
    parser.add_argument("--table", type=int, metavar="N", help="designs FIRST to FIRST + N - 1 as a table")
    parser.add_argument("--shares", type=int, metavar="N", help="in how many of as many designs each ingredient is")
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
    if args.shares:
        print_shares(range(args.first, args.first + args.shares))
        return 0
    if args.seed is None or args.out is None:
        parser.error("give SEED and --out DIR, --table N or --shares N")
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
    if args.angles:
        write_angles(args.out, design, draw_angles(design, truth, args.seed))
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


def print_shares(seeds: Sequence[int]) -> None:
    """In how many of the designs each ingredient is, the rarest first."""
    designs = [draw_design(seed) for seed in seeds]
    share = {name: float(np.mean([design.ingredients[name] for design in designs])) for name in designs[0].ingredients}
    for name, value in sorted(share.items(), key=lambda one: one[1]):
        print(f"{name:24s} {value:5.0%}")


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
