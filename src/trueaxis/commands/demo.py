"""`trueaxis demo`: the whole job on the paper's machine."""

import argparse
import sys
from pathlib import Path

from trueaxis.commands.arguments import positive, whole


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "demo",
        help="the whole job on the paper's machine, with pictures",
        description="Derive the model of the paper's machine, simulate its 18 laser runs with noise, identify the "
        "errors, fit optimal polynomials, compensate an S path and a ball-bar circle, and say what it gained. Every "
        "step is a command that is shown as you would type it; results and pictures are left in OUT.",
        epilog="exit code: 0 done, 1 a step failed",
    )
    parser.add_argument("--out", type=Path, default=Path("results"), help="folder for everything (%(default)s)")
    parser.add_argument(
        "--noise-um",
        type=positive,
        default=0.004,
        metavar="S",
        help="standard deviation of a laser reading, um (%(default)s: what the paper's residual error implies)",
    )
    parser.add_argument("--seed", type=whole(0), default=1, metavar="N", help="seed of the noise (%(default)s)")
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Run the demonstration."""
    # matplotlib and statsmodels take a second to import; only this command needs them here.
    from trueaxis.demo.steps import StepError, run_demo  # noqa: PLC0415

    try:
        summary = run_demo(args.out, args.noise_um, args.seed)
    except StepError as failure:
        print(f"trueaxis: {failure}", file=sys.stderr)
        return 1
    print(f"\n{summary}", end="")
    return 0
