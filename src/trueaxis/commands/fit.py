"""`trueaxis fit`: identified tables to optimal polynomials."""

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.commands.arguments import file_to_write, share, size, whole
from trueaxis.commands.misfit import check_fit, misfit_option
from trueaxis.commands.paths import named, overwritten
from trueaxis.faults import Fault, InputError
from trueaxis.files import write_files
from trueaxis.input_files import gathering
from trueaxis.reporting.reliance import above_sentence, extent_sentences
from trueaxis.runtime.covariance import Covariance
from trueaxis.runtime.covariance_file import linked
from trueaxis.runtime.curves import TableCurve
from trueaxis.runtime.errors import ErrorValues, dump_errors
from trueaxis.runtime.extent import UncertaintyExtent, uncertainty_extent, volume_grid
from trueaxis.runtime.kernels import load_kernels
from trueaxis.runtime.model import MachineModel, load_errors
from trueaxis.runtime.uncertainty import covariance_file, load_uncertainty
from trueaxis.spec import Machine, read_machine
from trueaxis.spec.machine import component_unit

HIGHEST_ORDER = 15
NO_KERNELS = "there are no kernels of this machine (--kernels): the uncertainty of the tool point is not stated"

DESCRIPTION = """\
Replace the tables of an error-values file by optimal polynomials without a constant term, as in Sect. 4: the
order by the mean square error, an F test of the equation, t tests of its terms, terms chosen stepwise by AIC until both
tests pass. Shows the statistics before and after."""


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "fit",
        help="identified tables to optimal polynomials, with their statistics",
        description=DESCRIPTION,
        epilog="exit code: 0 done; 1 a component has no significant polynomial; 2 the input is wrong",
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--errors", type=Path, required=True, metavar="E.json", help="error values with tables")
    parser.add_argument(
        "--out", type=file_to_write, required=True, metavar="E.json", help="error values, to be written"
    )
    parser.add_argument(
        "--max-order", type=whole(1, HIGHEST_ORDER), default=7, metavar="N", help="highest power tried (%(default)s)"
    )
    parser.add_argument("--alpha", type=share, default=0.05, help="significance level of the tests (%(default)s)")
    misfit_option(parser)
    parser.add_argument(
        "--max-u", type=size, metavar="MM",
        help="write nothing, exit code 1, where a standard uncertainty of the tool point within the travel, relative "
        "to home, is larger; what is not known or not determined counts as infinite",
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
    # statsmodels and matplotlib take a second to import; only this command needs them here.
    from trueaxis.identify.curve_fit import fit_tables, in_polynomials, polynomial_curves  # noqa: PLC0415
    from trueaxis.identify.polynomial import statistics_table  # noqa: PLC0415
    from trueaxis.pictures.curves import curves_picture  # noqa: PLC0415

    file = args.out.with_suffix(".npz")
    found = overwritten(
        {"MACHINE.toml": args.machine, "--errors": args.errors},
        {"--out": args.out, "covariance of --out": file, "--picture": args.picture},
        args.kernels,
    )
    machine = read_machine(args.machine)
    errors = covariance = None
    with gathering(found):
        errors = load_errors(args.errors, machine)
        check_fit(errors, args.errors, args.accept_misfit)
        covariance = load_uncertainty(args.errors, errors, machine)
        read = {"the covariance of --errors": covariance_file(args.errors, errors)}
        found += overwritten(read, {"--out": args.out, "covariance of --out": file, "--picture": args.picture})
    if found or errors is None or covariance is None:
        raise InputError(found)
    fits = fit_tables(errors.motion_errors, max_order=args.max_order, alpha=args.alpha)
    if not fits:
        raise InputError([_nothing_to_fit(errors, args.errors)])
    curves, notes = polynomial_curves(errors.motion_errors, fits)
    fitted = replace(errors, motion_errors=curves, covariance=None)
    of_fitted = in_polynomials(covariance, errors.motion_errors, curves)
    contents: dict[Path, bytes | str] = {}
    if errors.covariance is not None:
        fitted, contents[file] = linked(fitted, of_fitted, args.out, file)
    contents[args.out] = dump_errors(
        fitted, components=machine.components, parameters=machine.parameters, effects=machine.effects
    )
    extent = _extent(args, machine, fitted, of_fitted)
    doubtful = () if extent is None else extent.components
    if args.picture is not None:
        tables = ((name, errors.motion_errors[name]) for name in fits)
        bars = {
            name: np.array(t.u)[np.array(t.positions) != 0.0] for name, t in tables if isinstance(t, TableCurve) and t.u
        }
        contents[args.picture] = curves_picture(fits, u=bars, undetermined=doubtful)
    refused = extent is not None and args.max_u is not None and extent.counted > args.max_u
    if not refused:
        write_files(contents)
    for name, fit in fits.items():
        unit, factor = ("um", 1e3) if component_unit(name) == "mm" else ("urad", 1e6)
        print(f"{name}: {fit.verdict}\n{statistics_table(fit, unit, factor)}\n")
    stated = [NO_KERNELS] if extent is None else extent_sentences(extent, "over the travel")
    for note in (*notes, *stated):
        print(f"note: {note}")
    if refused and extent is not None:
        print(f"{named(args.out)}: not written: {above_sentence(extent.counted, args.max_u)}")
        return 1
    print(f"written: {', '.join(map(named, contents))}")
    return 0 if all(fit.after.powers for fit in fits.values()) else 1


def _nothing_to_fit(errors: ErrorValues, file: Path) -> Fault:
    curves = errors.motion_errors.values()
    if curves and not any(isinstance(curve, TableCurve) for curve in curves):
        problem = "are polynomials already, without a table: there is nothing to fit"
        return Fault(str(file), "motion_errors", problem, "use these error values as they are")
    return Fault(str(file), "motion_errors", "has no table of three positions or more")


def _extent(
    args: argparse.Namespace, machine: Machine, fitted: ErrorValues, covariance: Covariance
) -> UncertaintyExtent | None:
    """The uncertainty of the tool point over the travel; None without kernels, which --max-u cannot do without."""
    try:
        model = MachineModel(machine, load_kernels(machine, args.machine, args.kernels), fitted)
    except InputError:
        if args.max_u is not None:
            raise
        return None
    return uncertainty_extent(model, covariance, volume_grid(model, covariance), np.zeros((3, 1)))
