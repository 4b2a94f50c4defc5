"""trueaxis report: error values as a document, beside an older file."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, tool_point
from trueaxis.io.faults import InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.report import documented, faults_of_page
from trueaxis.machine import read_machine
from trueaxis.model.model import load_errors, load_model
from trueaxis.model.uncertainty import covariance_file, load_uncertainty
from trueaxis.reporting.certificate_content import Known

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Write error values as a document of two printed pages: every error with its standard uncertainty and what determines it,
and the deviation of the tool point over the volume in figures and maps. With an older file it also shows what has
changed, by how much and by how many standard uncertainties."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("report", help="error values as a document to print", description=DESCRIPTION)
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="the error values")
    parser.add_argument("--against", type=Path, metavar="OLD.json", help="older error values to compare with")
    parser.add_argument(
        "--tool-point", type=tool_point, default=(0.0, 0.0, 0.0), metavar="X,Y,Z",
        help="point in the tool frame whose deviation is shown, mm (0,0,0)",
    )  # fmt: skip
    parser.add_argument("--out", type=file_to_write, required=True, metavar="FILE.html", help="page to write")
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Read, compare, write; raises InputError with the faults of every file."""
    inputs = {"MACHINE.toml": args.machine, "--errors": args.errors, "--against": args.against}
    found = [*faults_of_page(args.out, "--out"), *overwritten(inputs, {"--out": args.out}, args.kernels)]
    machine = read_machine(args.machine)
    now = before = None
    with gathering(found):
        model = load_model(args.machine, args.errors, args.kernels)
        now = Known(model, load_uncertainty(args.errors, model.errors, machine), str(args.errors))
        linked = {"the covariance of --errors": covariance_file(args.errors, model.errors)}
        found += overwritten(linked, {"--out": args.out})
    if args.against is not None:
        with gathering(found):
            errors = load_errors(args.against, machine)
            covariance = load_uncertainty(args.against, errors, machine)
            if now is not None:
                before = Known(now.model.with_values(errors), covariance, str(args.against))
    if found or now is None:
        raise InputError(found)
    print(documented(now, before, args.tool_point, args.out), end="")
    return 0
