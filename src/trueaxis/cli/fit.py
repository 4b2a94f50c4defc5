"""`trueaxis fit`: identified curves to optimal polynomials."""

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trueaxis.cli.arguments import file_to_write, share, size, whole
from trueaxis.cli.misfit import check_fit, misfit_option
from trueaxis.error_name import ErrorName
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import Machine, read_machine
from trueaxis.model.covariance import Covariance
from trueaxis.model.covariance_file import linked
from trueaxis.model.curves import LegendreCurve, TableCurve
from trueaxis.model.errors import ErrorValues, dump_errors
from trueaxis.model.extent import UncertaintyExtent, travel_positions, uncertainty_extent
from trueaxis.model.kernels import load_kernels
from trueaxis.model.model import MachineModel, load_errors
from trueaxis.model.uncertainty import covariance_file, curve_u, load_uncertainty
from trueaxis.reporting.fitted_curves import curve_sentences
from trueaxis.reporting.reliance import above_sentence, extent_sentences, worth_nothing_sentences

if TYPE_CHECKING:
    from trueaxis.identification.polynomial import OptimalFit

HIGHEST_ORDER = 15
DRAWN = 101  # points of a curve in the picture
NO_KERNELS = "there are no kernels of this machine (--kernels): the uncertainty of the tool point is not stated"

DESCRIPTION = """\
Replace the curves of an error-values file by optimal polynomials that are zero at home, as in Sect. 4: the order by the
mean square error, an F test of the equation, t tests of its terms, terms chosen stepwise by AIC until both tests pass.
--statistics shows all figures. Curves are tables (method stepwise) or the Legendre curves of the estimate
(method global), which are fitted by generalised least squares with their posterior covariance. A Legendre curve stays
as it is where it rests on the prior, or where no significant polynomial is within half its standard uncertainty; the
picture shows the first kind dashed, with a band."""


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "fit",
        help="identified curves to optimal polynomials, with their statistics",
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
    from trueaxis.identification.curve_fit import fit_tables, in_polynomials, polynomial_curves  # noqa: PLC0415
    from trueaxis.identification.legendre_fit import fit_legendre, with_polynomials  # noqa: PLC0415
    from trueaxis.identification.polynomial import statistics_table  # noqa: PLC0415

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
    of_estimate, resting = fit_legendre(errors, covariance, machine, max_order=args.max_order, alpha=args.alpha)
    if not fits and not of_estimate:
        raise InputError([_nothing_to_fit(errors, args.errors)])
    fitted, of_fitted = with_polynomials(errors, covariance, machine, of_estimate)
    curves, notes = polynomial_curves(fitted.motion_errors, fits)
    fitted = replace(fitted, motion_errors=curves, covariance=None)
    of_fitted = in_polynomials(of_fitted, errors.motion_errors, curves)
    notes += curve_sentences([name for name, fit in of_estimate.items() if not fit.after.powers], resting)
    contents: dict[Path, bytes | str] = {}
    if errors.covariance is not None:
        fitted, contents[file] = linked(fitted, of_fitted, args.out, file)
    contents[args.out] = dump_errors(
        fitted, components=machine.components, parameters=machine.parameters, effects=machine.effects
    )
    extent = _extent(args, machine, fitted, of_fitted)
    doubtful = () if extent is None else extent.components
    if args.picture is not None:
        contents[args.picture] = _picture(errors, covariance, {**fits, **of_estimate}, doubtful, resting)
    refused = extent is not None and extent.refused(args.max_u, accepted=True)
    if not refused:
        write_files(contents)
    for name, fit in (*fits.items(), *of_estimate.items()):
        unit, factor = ("um", 1e3) if ErrorName(name).unit == "mm" else ("urad", 1e6)
        print(f"{name}: {fit.verdict}")
        if args.statistics:
            print(f"{statistics_table(fit, unit, factor)}\n")
    stated = [NO_KERNELS]
    if extent is not None:
        stated = extent_sentences(extent, "over the travel") + worth_nothing_sentences(extent)
    for note in (*notes, *stated):
        print(f"note: {note}")
    if refused and extent is not None:
        print(f"{named(args.out)}: not written: {above_sentence(extent.counted, args.max_u)}")
        return 1
    print(f"written: {', '.join(map(named, contents))}")
    return 0 if all(fit.after.powers for fit in fits.values()) else 1


def _picture(
    errors: ErrorValues,
    covariance: Covariance,
    fits: "Mapping[str, OptimalFit]",
    doubtful: Sequence[str],
    resting: Sequence[str],
) -> bytes:
    from trueaxis.reporting.pictures.curves import PriorCurve, curves_picture  # noqa: PLC0415

    bars, by_prior = {}, {}
    for name, fit in fits.items():
        curve = errors.motion_errors[name]
        if isinstance(curve, TableCurve) and curve.u:
            bars[name] = np.array(curve.u)[np.array(curve.positions) != 0.0]
        elif isinstance(curve, LegendreCurve) and covariance.root is not None:
            bars[name] = curve_u(covariance, name, fit.samples.positions)
    for name in resting:
        curve = errors.motion_errors[name]
        if isinstance(curve, LegendreCurve):
            at = np.linspace(curve.basis.low, curve.basis.high, DRAWN)
            u = np.zeros(at.size) if covariance.root is None else curve_u(covariance, name, at)
            by_prior[name] = PriorCurve(at, curve(at), u)
    grey = [name for name in doubtful if name not in by_prior]
    return curves_picture(fits, u=bars, undetermined=grey, by_prior=by_prior)


def _nothing_to_fit(errors: ErrorValues, file: Path) -> Fault:
    curves = errors.motion_errors.values()
    if any(isinstance(curve, LegendreCurve) for curve in curves):
        problem = "rest on the prior: no reading tells of them, so that there is nothing to fit"
        return Fault(str(file), "motion_errors", problem, "use these error values as they are, or measure more")
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
    return uncertainty_extent(model, covariance, travel_positions(model, covariance), np.zeros((3, 1)))
