"""`trueaxis fit`: identified tables to optimal polynomials."""

import argparse
from dataclasses import replace
from pathlib import Path

import numpy as np

from trueaxis.commands.arguments import file_to_write, share, whole
from trueaxis.commands.paths import named, overwritten
from trueaxis.faults import Fault, InputError
from trueaxis.files import write_files
from trueaxis.runtime.curves import TableCurve
from trueaxis.runtime.errors import dump_errors, read_errors
from trueaxis.spec import read_machine
from trueaxis.spec.machine import component_unit

HIGHEST_ORDER = 15

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
    parser.add_argument(
        "--picture", type=file_to_write, metavar="P.png", help="draw values and polynomials, before and after"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Fit, show, write."""
    # statsmodels and matplotlib take a second to import; only this command needs them here.
    from trueaxis.identify.curve_fit import fit_tables, polynomial_curves  # noqa: PLC0415
    from trueaxis.identify.polynomial import statistics_table  # noqa: PLC0415
    from trueaxis.pictures.curves import curves_picture  # noqa: PLC0415

    faults = overwritten(
        {"MACHINE.toml": args.machine, "--errors": args.errors}, {"--out": args.out, "--picture": args.picture}
    )
    machine = read_machine(args.machine)
    components, parameters = machine.components, machine.parameters
    errors = read_errors(
        args.errors,
        machine=machine.name,
        components=components,
        parameters=parameters,
        effects=machine.effects,
        kinds=machine.kinds,
    )
    if faults:
        raise InputError(faults)
    fits = fit_tables(errors.motion_errors, max_order=args.max_order, alpha=args.alpha)
    if not fits:
        raise InputError([Fault(str(args.errors), "motion_errors", "has no table of three positions or more")])
    curves, notes = polynomial_curves(errors.motion_errors, fits)
    fitted = dump_errors(
        replace(errors, motion_errors=curves), components=components, parameters=parameters, effects=machine.effects
    )
    contents: dict[Path, bytes | str] = {args.out: fitted}
    if args.picture is not None:
        tables = ((name, errors.motion_errors[name]) for name in fits)
        bars = {
            name: np.array(t.u)[np.array(t.positions) != 0.0] for name, t in tables if isinstance(t, TableCurve) and t.u
        }
        contents[args.picture] = curves_picture(fits, u=bars)
    write_files(contents)
    for name, fit in fits.items():
        unit, factor = ("um", 1e3) if component_unit(name) == "mm" else ("urad", 1e6)
        print(f"{name}: {fit.verdict}\n{statistics_table(fit, unit, factor)}\n")
    for note in notes:
        print(f"note: {note}")
    print(f"written: {', '.join(map(named, contents))}")
    return 0 if all(fit.after.powers for fit in fits.values()) else 1
