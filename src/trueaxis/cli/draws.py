"""The options of draws: how many, of what, by whom."""

import argparse
from pathlib import Path

from trueaxis.cli.arguments import file_to_write, noise_or_none, option, size, whole
from trueaxis.cluster.workers import MOST_WORKERS
from trueaxis.io.faults import Fault
from trueaxis.jobs.draws import faults_of_keep, faults_of_workers
from trueaxis.monte_carlo.settings import MOST_DRAWS, Draws

_OF_DRAWS = ("seed", "noise_um", "u_temperature", "either_direction", "workers", "scheduler", "keep")


def add_draws(parser: argparse.ArgumentParser, *, of_program: bool = False) -> None:
    """Declare --draws and what goes with it. of_program: of places of a program, which says from where axes come."""
    group = parser.add_argument_group("draws (GUM Supplement 1)")
    group.add_argument(
        "--draws", type=whole(2, MOST_DRAWS), metavar="N",
        help="draw all error values N times from their covariance, and give mean, standard deviation, 2.5 %% and 97.5 "
        "%% quantiles of each coordinate and of the length of the error vector; a note says whether they agree with u, "
        "which is linear; 1000000 for two digits of the quantiles",
    )  # fmt: skip
    group.add_argument("--seed", type=whole(0), metavar="S", help="seed of the random numbers (0)")
    group.add_argument(
        "--noise-um", type=noise_or_none, metavar="S",
        help="standard deviation of the repeatability of the tool point, in each coordinate, um (0)",
    )  # fmt: skip
    group.add_argument(
        "--u-temperature", type=size, metavar="K",
        help="standard uncertainty of the temperature, for effects that depend on it (0)",
    )  # fmt: skip
    if of_program:
        group.add_argument(
            "--draws-out", type=file_to_write, metavar="FILE",
            help="table to write, .parquet or .csv: the remaining error of the tool at points of the program",
        )  # fmt: skip
    else:
        group.add_argument(
            "--either-direction", action="store_const", const=True,
            help="draw the approach directions that are not given, for effects that depend on them, such as backlash",
        )  # fmt: skip
    group.add_argument(
        "--workers", type=whole(1, MOST_WORKERS), metavar="N",
        help="processes on this computer; more than 1 needs the extra trueaxis[cluster]; the result is the same (1)",
    )  # fmt: skip
    group.add_argument("--scheduler", metavar="ADDRESS", help="a running Dask scheduler, whose workers draw")
    group.add_argument(
        "--keep", type=Path, metavar="DIR",
        help="folder for the results of each block of 2000 points: the same command, run again after it was stopped, "
        "draws only the others",
    )  # fmt: skip


def draws_of(args: argparse.Namespace, found: list[Fault]) -> Draws | None:
    """What was asked for, None: no draws; faults of options that do not go together are added to those found."""
    given = {name: getattr(args, name) for name in _OF_DRAWS if getattr(args, name, None) is not None}
    out = getattr(args, "draws_out", None)
    if "draws_out" in args and (out is None) != (args.draws is None):
        found.append(Fault("--draws-out", "", "goes with --draws", "both, or neither"))
    if args.draws is None:
        found += [Fault(option(name), "", "goes with --draws", "add --draws N, or leave it out") for name in given]
        return None
    found += faults_of_workers(args.scheduler, option, workers=args.workers)
    found += faults_of_keep(args.keep)
    return Draws(count=args.draws, **given)
