"""trueaxis export: error values as compensation tables of a control, or as a module that it runs."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trueaxis.cli.arguments import misfit_option, option, positive, size, tool_point, uncertain_option
from trueaxis.controllers.formats import FORMATS
from trueaxis.controllers.linuxcnc import FILE_TYPES
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.export import ExportOptions, exported
from trueaxis.jobs.given import check_fit
from trueaxis.jobs.outputs import named
from trueaxis.machine import read_machine
from trueaxis.model.model import load_model
from trueaxis.model.uncertainty import covariance_file, load_uncertainty
from trueaxis.reporting.export import ACCEPT_WORSE

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Write error values as compensation tables that a control reads, or (linuxcnc-kins) as a module that it runs. The command
says which errors of the model they contain, how large the deviations of the tool point are over the travel, and what
remains of them with the interpolation of the control. docs/controllers has a page for each format: its source, the sign
with an example, limits, how to load it, how to verify it by measuring again, how to remove it."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser(
        "export", help="error values as compensation tables of a control", description=DESCRIPTION,
        epilog="exit code: 0 done; 1 refused for its uncertainty, by --max-correction, or because the error would be "
        "larger with the tables than without, nothing is written; 2 the input is wrong",
    )  # fmt: skip
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="its error values")
    parser.add_argument("--format", choices=FORMATS, required=True, help="format of the control")
    parser.add_argument(
        "--out", type=Path, required=True, metavar="PATH",
        help="file to write; a folder for heidenhain-com, linuxcnc-comp and linuxcnc-kins",
    )  # fmt: skip
    parser.add_argument(
        "--step", type=positive, metavar="MM",
        help="largest distance between positions of a table, mm or deg (default: the finest round one with up to 200 "
        "positions)",
    )  # fmt: skip
    parser.add_argument(
        "--tool-point", type=tool_point, default=(0.0, 0.0, 0.0), metavar="X,Y,Z",
        help="point in the tool frame for which tables of single axes are made; for linuxcnc-kins the point from which "
        "tool lengths are measured, mm (0,0,0)",
    )  # fmt: skip
    parser.add_argument(
        "--comp-file-type", type=int, choices=FILE_TYPES,
        help="COMP_FILE_TYPE of linuxcnc-comp: 0, where the joint really is (default); 1, what is added to the command",
    )  # fmt: skip
    misfit_option(parser)
    uncertain_option(parser, "the tables")
    parser.add_argument(
        ACCEPT_WORSE, action="store_true",
        help="write tables with which the error over the travel is larger than without them, such as one of several "
        "that are loaded together",
    )  # fmt: skip
    parser.add_argument(
        "--max-u", type=size, metavar="MM",
        help="write nothing, exit code 1, if a standard uncertainty of the tool point within the travel, relative "
        "to home, is larger; unknown or not determined counts as infinite",
    )  # fmt: skip
    parser.add_argument(
        "--max-correction", type=positive, metavar="MM",
        help="write nothing, exit code 1, if the tool point is off by more, relative to home (default: three times "
        "what [prior] of the spec expects there)",
    )  # fmt: skip
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Judge, write, say what remains; raises InputError with the faults of every file."""
    found: list[Fault] = []
    machine = read_machine(args.machine)
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
        check_fit(model.errors, str(args.errors), args.accept_misfit, option)
        covariance = load_uncertainty(args.errors, model.errors, machine)
    if found:
        raise InputError(found)
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors}
    inputs["the covariance of --errors"] = covariance_file(args.errors, model.errors)
    options = ExportOptions(
        step=args.step, max_u=args.max_u, max_correction=args.max_correction, accept_u=args.accept_u,
        accept_worse=args.accept_worse, kernels=args.kernels, file_type=args.comp_file_type,
    )  # fmt: skip
    tool = np.array(args.tool_point)[:, np.newaxis]
    try:
        done = exported(model, covariance, args.format, args.out, tool, options, inputs, option)
    except RefusedError as refused:
        print(refused.result.notes_text(), end="")
        for sentence in refused.reasons:
            print(f"{named(args.out)}: not written: {sentence}")
        return 1
    print(done, end="")
    print(f"written: {', '.join(map(named, done.files))}")
    return 0
