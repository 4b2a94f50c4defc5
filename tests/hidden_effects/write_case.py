"""Write measured data that hide effects, as files to try `trueaxis diagnose` on.

    python -m tests.hidden_effects.write_case FOLDER [--effect KIND COMPONENT SIZE ...] [--seed N] [--machine NAME]
                                              [--noise KIND] [--given KIND] [--lasers-only] [--lines N]

FOLDER gets machine.toml, errors.json, data/setup.toml and data/readings.csv; nothing in them tells what is hidden.
SIZE is in mm, rad, s as docs/effects.md has the first parameter of the kind; an effect on readings has the COMPONENT -.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path

from tests.hidden_effects import hidden, noise, outside
from tests.hidden_effects.case import Case, generate
from tests.hidden_effects.design import Design
from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machines import MACHINES

KINDS = (*hidden.OF_COMPONENTS, *hidden.OF_LOCATION, *outside.KINDS, "laser_scale", "ballbar_length", "ballbar_lobes")
GIVEN = ("exact", "identified", "stale", "zero")


def main(arguments: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--effect", nargs=3, action="append", default=[], metavar=("KIND", "COMPONENT", "SIZE"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--machine", choices=sorted(MACHINES), default="table_mill")
    parser.add_argument("--noise", choices=tuple(noise.KINDS), default="realistic")
    parser.add_argument("--given", choices=GIVEN, default="identified")
    parser.add_argument("--lasers-only", action="store_true", help="no circles")
    parser.add_argument("--lines", type=int, default=4, help="laser lines per axis (%(default)s)")
    args = parser.parse_args(arguments)
    unknown = [kind for kind, _, _ in args.effect if kind not in KINDS]
    if unknown:
        parser.error(f"no effect that can be written so: {', '.join(unknown)}; there are {', '.join(KINDS)}")
    effects = tuple(
        Hidden(kind, "" if component == "-" else component, size=float(size), shape=number)
        for number, (kind, component, size) in enumerate(args.effect, start=1)
    )
    design = Design(lines=args.lines, ball_bar=not args.lasers_only)
    case = Case(args.seed, args.machine, design, effects, noise=args.noise, given=args.given)
    generate(case).write(args.folder)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
