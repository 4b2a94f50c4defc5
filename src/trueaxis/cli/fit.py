"""`trueaxis fit`: identified curves to optimal polynomials."""

import argparse
from pathlib import Path

from trueaxis.cli.arguments import file_to_write, misfit_option, option, share, size, whole
from trueaxis.io.faults import InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.fit import HIGHEST_ORDER, fitted, refusal
from trueaxis.jobs.given import check_fit
from trueaxis.jobs.load import Errors
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import Machine, read_machine
from trueaxis.model.covariance_file import linked
from trueaxis.model.errors import ErrorValues, dump_errors
from trueaxis.model.kernels import load_kernels
from trueaxis.model.model import MachineModel, load_errors
from trueaxis.model.uncertainty import covariance_file, load_uncertainty

DESCRIPTION = """\
Replace the curves of error values by optimal polynomials that are zero at home, as in Sect. 4 of the paper: the order
by the mean square error, an F test of the equation, t tests of its terms, terms chosen stepwise by AIC until both tests
pass. --statistics shows all figures. Curves are tables (method stepwise) or the Legendre curves of the estimate (method
global), which are fitted by generalised least squares with their posterior covariance. A Legendre curve stays as it is
if it rests on the prior (dashed in the picture, with a band), or if no significant polynomial is within half its
standard uncertainty."""


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "fit",
        help="replace identified curves by optimal polynomials, with their statistics",
        description=DESCRIPTION,
        epilog="exit code: 0 done; 1 a table has no significant polynomial, or refused by --max-u; "
        "2 the input is wrong",
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="error values with curves")
    parser.add_argument(
        "--out", type=file_to_write, required=True, metavar="E.json", help="error values, to be written"
    )
    parser.add_argument(
        "--max-order", type=whole(1, HIGHEST_ORDER), default=7, metavar="N", help="highest power tried (%(default)s)"
    )
    parser.add_argument("--alpha", type=share, default=0.05, help="significance level of the tests (%(default)s)")
    misfit_option(parser)
    parser.add_argument(
        "--statistics", action="store_true", help="show the statistics of each equation, before and after, as a table"
    )
    parser.add_argument(
        "--max-u", type=size, metavar="MM",
        help="write nothing, exit code 1, if a standard uncertainty of the tool point within the travel, relative "
        "to home, is larger; unknown or not determined counts as infinite",
    )  # fmt: skip
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR",
        help="folder of derived kernels, for the uncertainty of the tool point (%(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--picture", type=file_to_write, metavar="P.png", help="draw values and polynomials, before and after"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Fit, show, write."""
    file = args.out.with_suffix(".npz")
    found = overwritten(
        {"MACHINE.toml": args.machine, "--errors": args.errors},
        {"--out": args.out, "covariance of --out": file, "--picture": args.picture},
        args.kernels,
    )
    machine = read_machine(args.machine)
    errors = None
    with gathering(found):
        values = load_errors(args.errors, machine)
        check_fit(values, str(args.errors), args.accept_misfit, option)
        errors = Errors(values, load_uncertainty(args.errors, values, machine), args.errors, machine)
        read = {"the covariance of --errors": covariance_file(args.errors, values)}
        found += overwritten(read, {"--out": args.out, "covariance of --out": file, "--picture": args.picture})
    if found or errors is None:
        raise InputError(found)
    done = fitted(machine, errors, _model(args, machine), max_order=args.max_order, alpha=args.alpha)
    fits, contents = done.errors.values, dict[Path, bytes | str]()
    if errors.values.covariance is not None:
        fits, contents[file] = linked(fits, done.errors.covariance, args.out, file)
    contents[args.out] = dump_errors(
        fits, components=machine.components, parameters=machine.parameters, effects=machine.effects
    )
    if args.picture is not None:
        contents[args.picture] = done.picture()
    refused = refusal(done, args.max_u)
    if not refused:
        write_files(contents)
    print(done.text(statistics=args.statistics), end="")
    if refused:
        print(f"{named(args.out)}: not written: {refused}")
        return 1
    print(f"written: {', '.join(map(named, contents))}")
    return 0 if done.significant else 1


def _model(args: argparse.Namespace, machine: Machine) -> MachineModel | None:
    """For the uncertainty of the tool point; None without kernels, which --max-u cannot do without."""
    try:
        return MachineModel(
            machine, load_kernels(machine, args.machine, args.kernels), ErrorValues(machine=machine.name)
        )
    except InputError:
        if args.max_u is not None:
            raise
        return None
