"""trueaxis predict: the deviation of the tool point at given axis positions."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.commands.paths import overwritten
from trueaxis.faults import InputError
from trueaxis.files import write_files
from trueaxis.identify.covariance import predicted_u, read_covariance
from trueaxis.input_files import gathering
from trueaxis.measure.context_needs import faults_of_points
from trueaxis.measure.points import dump_predicted, read_points
from trueaxis.measure.predict import check_predicted, predict
from trueaxis.runtime.model import load_model
from trueaxis.spec import read_machine

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Predict where the tool point really is. For each row of --at (a column per axis: mm, rotary axes deg; optionally tool_x,
tool_y, tool_z: the point in the tool frame, mm; dir_X ..., time_s and temperature_c: how the axes came there, when, how
warm, for machines with effects) the deviation, actual minus ideal, is computed on the exact model and
written as dx, dy, dz (mm, workpiece frame) behind the columns of the row; with --covariance (of identify) their
standard uncertainties, too, as u_dx, u_dy, u_dz: empty where a deviation rests on what the data could not determine."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "predict", help="the deviation of the tool point at given axis positions", description=DESCRIPTION
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    parser.add_argument("--at", type=Path, required=True, metavar="POINTS", help="axis positions, .csv or .parquet")
    parser.add_argument("--covariance", type=Path, metavar="FILE.npz", help="covariance of the error values")
    parser.add_argument("--out", type=Path, required=True, metavar="OUT", help="table to write, .csv or .parquet")
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Predict and write; raises InputError with the faults of every file."""
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors, "--at": args.at, "--covariance": args.covariance}
    found = overwritten(inputs, {"--out": args.out})
    machine = read_machine(args.machine)
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
    with gathering(found):
        points = read_points(args.at, machine)
    covariance = None
    if args.covariance is not None:
        with gathering(found):
            covariance = read_covariance(
                args.covariance, machine.name, machine.components, machine.location_errors, machine.effects
            )
    if found:
        raise InputError(found)
    if model.effect_values:
        if lacking := faults_of_points(model, points.context, str(args.at)):
            raise InputError(lacking)
        model = model.in_context(points.context)
    deviation = predict(model, points)
    check_predicted(deviation, str(args.errors))
    spread = None if covariance is None else predicted_u(model, covariance, points.positions, points.tool)
    write_files({args.out: dump_predicted(points, deviation, args.out.suffix, spread)})
    print(f"{args.out}: {deviation.shape[1]} points")
    return 0
