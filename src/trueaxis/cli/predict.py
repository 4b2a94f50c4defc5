"""trueaxis predict: the deviation of the tool point at given axis positions."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, option, size
from trueaxis.cli.draws import add_draws, draws_of
from trueaxis.cli.grid import add_points, points_of
from trueaxis.cli.progress import progress
from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.draws import faults_of_draws
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.jobs.predict import predicted, refusal, with_draws
from trueaxis.machine import read_machine
from trueaxis.measurement.points import dump_predicted
from trueaxis.model.model import load_model
from trueaxis.model.uncertainty import covariance_file, load_uncertainty
from trueaxis.monte_carlo.drawn import drawn_columns

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Predict where the tool point really is, for each row of --at or each node of --grid. The columns of --at are axis
positions (mm, rotary axes deg); optionally tool_x, tool_y, tool_z, the point in the tool frame, mm; and, for machines
with effects, dir_X ... (direction of approach), time_s and temperature_c. The deviation, actual minus ideal on the
exact model, is written after these columns as dx, dy, dz (mm, workpiece frame), and its standard uncertainty as u_dx,
u_dy, u_dz. u is empty where it is unknown, or where the deviation rests on values that no reading determined.
u_prior_dx, u_prior_dy, u_prior_dz are the part of u that rests on [prior] of the spec, the rest comes from the
readings; the squares of both parts add up."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "predict", help="the deviation of the tool point at given axis positions", description=DESCRIPTION
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    add_points(parser)
    parser.add_argument(
        "--covariance", type=Path, metavar="FILE.npz",
        help="covariance of the error values (default: the file that they name, else their stated uncertainties)",
    )  # fmt: skip
    parser.add_argument(
        "--datum", choices=("machine", "home", "best-fit"), default="machine",
        help="reference of deviations and uncertainties: the error-free machine; the tool point at home (every axis "
        "at 0, or at the nearest end of its travel); or the rigid placement of the "
        "workpiece, a shift and a small rotation, that fits the points best (%(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--max-u", type=size, metavar="MM",
        help="write nothing, exit code 1, if a standard uncertainty is larger; unknown or not determined counts as "
        "infinite",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=file_to_write, required=True, metavar="OUT", help="table to write, .csv or .parquet"
    )
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    add_draws(parser)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Predict and write; raises InputError with the faults of every file."""
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors, "--at": args.at, "--covariance": args.covariance}
    outputs = {"--out": args.out, "--picture": args.picture}
    found = overwritten(inputs, outputs, args.kernels)
    machine = read_machine(args.machine)
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
        covariance = load_uncertainty(args.errors, model.errors, machine, args.covariance)
        found += overwritten({"the covariance of --errors": covariance_file(args.errors, model.errors)}, outputs)
    with gathering(found):
        points, grid = points_of(args, machine)
    if args.draws is not None and not found:
        at_once = args.datum == "best-fit"
        found += faults_of_draws(covariance, points.positions.shape[1], str(args.errors), option, at_once=at_once)
    draws = draws_of(args, found)
    if found:
        raise InputError(found)
    predictions = predicted(
        model,
        covariance,
        points.positions,
        points.tool,
        points.context,
        datum=args.datum,
        source=("--grid" if args.at is None else str(args.at), str(args.errors)),
    )
    refused = refusal(predictions, args.max_u)
    if draws is not None and not refused:
        with progress() as show:
            predictions = with_draws(predictions, model, covariance, points.context, args.datum, draws, show)
    for sentence in predictions.notes:
        print(f"note: {sentence}")
    if refused:
        print(f"{named(args.out)}: not written: {refused}")
        return 1
    further = () if predictions.drawn is None else drawn_columns(predictions.drawn)
    table = dump_predicted(points, predictions.deviation, args.out.suffix, predictions.u, predictions.u_prior, further)
    written = {args.out: table}
    if args.picture is not None:
        written[args.picture] = replace(predictions, grid=grid).picture()
    write_files(written)
    print(f"{named(args.out)}: {points.positions.shape[1]} points")
    return 0
