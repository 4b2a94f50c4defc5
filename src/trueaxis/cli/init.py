"""trueaxis init: the spec of a new machine, and error values that are all zero."""

import argparse
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, option
from trueaxis.jobs.init import new_machine
from trueaxis.machine.machine import AXES

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Write the spec of a new machine with all error components and the usual location errors, and NAME_errors.json, error
values that are all zero. Comments in the spec mark what the structure code does not say (positions of rotary axes,
directions of commands). docs/machine.md has every key."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("init", help="the spec of a new machine, with zero errors", description=DESCRIPTION)
    parser.add_argument(
        "spec", type=file_to_write, metavar="NAME.toml", help="the spec to write; the file must not exist"
    )
    parser.add_argument(
        "--structure", required=True, metavar="CODE",
        help='order of the axes, such as "[w C\' Y\' b X Z t]" (ISO 10791-6), YFXZ or XZ+YC',
    )  # fmt: skip
    parser.add_argument(
        "--travel", type=_travel, action="extend", nargs="+", default=[], metavar="AXIS=LOW:HIGH",
        help="ends of the travel of each linear axis, mm, and of rotary axes, deg (-360:360): X=0:600 Z=-150:0",
    )  # fmt: skip
    parser.add_argument(
        "--sense", type=_sense, action="extend", nargs="+", default=[], metavar="AXIS=-1",
        help="axes whose positive commands move their slide in the negative direction",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Write both files; raises InputError with every fault."""
    print(new_machine(args.spec, args.structure, args.travel, args.sense, option), end="")
    return 0


def _travel(text: str) -> tuple[str, tuple[float, float]]:
    axis, equals, ends = text.partition("=")
    low, colon, high = ends.partition(":")
    try:
        travel = float(low), float(high)
    except ValueError:
        travel = float("nan"), float("nan")
    if axis not in AXES or not equals or not colon or not travel[0] < travel[1]:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not AXIS=LOW:HIGH, the lower end first, such as X=0:600 (mm, deg)"
        )
    return axis, travel


def _sense(text: str) -> tuple[str, int]:
    axis, _, sense = text.partition("=")
    if axis not in AXES or sense not in ("1", "+1", "-1"):
        raise argparse.ArgumentTypeError(f"{text!r} is not AXIS=-1 or AXIS=1")
    return axis, int(sense)
