"""`trueaxis demo`: the whole job on the paper's machine."""

import argparse
import sys
from pathlib import Path

from trueaxis.cli.arguments import positive, whole


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "demo",
        help="the whole job on the paper's machine, with pictures",
        description="Derive the model of the paper's machine, simulate laser readings with noise, identify the errors "
        "three ways (the paper's plan by its stepwise method and by the estimate, and a plan of the same measuring "
        "time that `plan` proposes), and give the error of the tool that remains with each. Then, at the noise that "
        "the paper's residuals imply, compensate its S path and its ball-bar circle, and compare with its own figures. "
        "Every step is a command, shown as you would type it; results and pictures are written to OUT. With --seeds "
        "only the three ways, over many seeds, at noise from 0.01 to 3 um.",
        epilog="exit code: 0 done, 1 a step failed",
    )
    parser.add_argument("--out", type=Path, default=Path("results"), help="folder for everything (%(default)s)")
    parser.add_argument(
        "--noise-um",
        type=positive,
        default=0.3,
        metavar="S",
        help="standard deviation of a laser reading, um, where the three ways are compared (%(default)s)",
    )
    parser.add_argument("--seed", type=whole(0), default=1, metavar="N", help="seed of the noise (%(default)s)")
    parser.add_argument(
        "--seeds", type=whole(2), metavar="N", help="mean and spread of N seeds as a table and a picture, in OUT"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run the demonstration."""
    # matplotlib and statsmodels take a second to import; only this command needs them here.
    from trueaxis.demo.steps import StepError, run_demo, run_study  # noqa: PLC0415

    try:
        summary = run_study(args.out, args.seeds) if args.seeds else run_demo(args.out, args.noise_um, args.seed)
    except StepError as failure:
        print(f"trueaxis: {failure}", file=sys.stderr)
        return 1
    print(f"\n{summary}", end="")
    return 0
