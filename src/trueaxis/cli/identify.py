"""trueaxis identify: error values from measured data."""

import argparse
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from trueaxis.cli.arguments import file_to_write, noise, noise_urad, option, whole
from trueaxis.estimation.curve_prior import DEGREE
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.identification.paper.describe import FROM_ANGLES as FROM_ANGLES_WARNING
from trueaxis.identification.report_text import fit_text, report_json, report_text, runs_text
from trueaxis.identification.weighting import NoiseModel, Repeats
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.given import faults_of_runs
from trueaxis.jobs.identify import (
    DEGREE_WITHOUT_PRIOR,
    HIGHEST_DEGREE,
    Identified,
    MethodChoice,
    UnbelievableError,
    faults_of_choice,
    identify,
)
from trueaxis.jobs.load import DataFolder, Errors, errors_files, load_data, load_errors, load_model
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import read_machine
from trueaxis.measurement.active_compensation import active_file
from trueaxis.model.model import MachineModel

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Find the error motions and location errors of a machine from readings, on the exact model, with standard uncertainties.
Method global estimates all errors from all readings at once, with a prior ([prior] of the spec) and with the unknowns
of the instruments. It estimates noise and sizes of errors from the readings, and leaves out outliers. Method stepwise
is the paper's: point by point, run by run; each run gives the components that are not yet known from those before. The
report says what the readings do not determine; that alone is no failure (exit code 0). Exit code 1: the readings
determine nothing at all; or the fit has not converged, and nothing is written; or the fit is a misfit, whose values are
written and marked: residuals far above the noise that is stated or that repeats show, misread runs, or runs that
contradict the others."""
DEFAULT: Literal["convention"] = "convention"
MISFIT_USE = "compensate, fit and export take these values with --accept-misfit only"
WAY_ON = (
    "a machine that changes while it is measured (heat, a knock), lost motion or runs of another set-up keep a fit "
    "from standing still: diagnose says what readings show beside errors of the machine; --runs leaves runs out"
)
STEPWISE, GLOBAL = "stepwise", "global"
FROM_ANGLES: Literal["from-angles"] = "from-angles"
_REPEATS: dict[str, Repeats] = {"repeats": "instrument", "repeats-by-run": "run"}


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("identify", help="error values from measured data", description=DESCRIPTION)
    _add_files(parser)
    _add_method(parser)
    parser.set_defaults(run=run)


def _add_files(parser: argparse.ArgumentParser) -> None:
    """What is read and written."""
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--data", type=Path, required=True, metavar="DIR", help="folder with setup.toml, readings.csv")
    parser.add_argument(
        "--out", type=file_to_write, required=True, metavar="E.json", help="error values, to be written"
    )
    parser.add_argument(
        "--runs", nargs="+", default=[], metavar="ID", help="use the readings of these runs only (default: all)"
    )
    parser.add_argument(
        "--known",
        type=Path,
        metavar="E.json",
        help="known error values, which are not identified: dimensions, location errors, whole components",
    )
    parser.add_argument(
        "--covariance",
        type=file_to_write,
        metavar="FILE.npz",
        help="file for the covariance of the values (default: --out with the ending .npz)",
    )
    parser.add_argument("--report", type=file_to_write, metavar="FILE", help="write the report as JSON, too")
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )


def _add_method(parser: argparse.ArgumentParser) -> None:
    """How the errors are found."""
    parser.add_argument(
        "--method",
        type=_method_option,
        default=GLOBAL,
        metavar="global|stepwise",
        help="(default global; paper is another name of stepwise)",
    )
    parser.add_argument(
        "--prior",
        choices=("spec", "none"),
        default="spec",
        help="method global: spec (default): errors have the sizes of [prior], which the readings correct; none: no "
        "prior (least squares), errors that the readings do not determine are zero and are named",
    )
    parser.add_argument(
        "--squareness",
        type=_squareness_option,
        default=DEFAULT,
        metavar="convention|known|from-angles",
        help="source of the squareness: convention (default): the slope of the straightness, whose least-squares lines "
        "are level as in ISO 230-1; known: the file --known (zero if not in it); from-angles: the yaw and pitch "
        "curves by Sect. 3.6 of the paper, which docs/errata.md refutes (method stepwise; old name sect36)",
    )
    parser.add_argument(
        "--noise-um",
        type=noise_option,
        default=NoiseModel(),
        metavar="S",
        help="standard deviation of a reading, um; method global also: laser=0.3,ballbar=0.5,RUN=1 (by instrument or "
        "run), laser=repeats,ballbar=0.5, or repeats, repeats-by-run: from repeated readings of each instrument, of "
        "each run (default: from [device] tables, else from the residuals)",
    )
    add_noise_urad(parser)
    parser.add_argument(
        "--curves",
        choices=("table", "polynomial", "held-out"),
        help="method stepwise: components as tables of the measured positions (default), as polynomials by the paper's "
        "procedure, or as polynomials whose order is chosen by held-out positions",
    )
    parser.add_argument(
        "--degree",
        type=_degree_option,
        metavar="N",
        help=f"method global: highest order of the curves ({DEGREE}, or more where readings tell more; "
        f"with --prior none {DEGREE_WITHOUT_PRIOR})",
    )
    parser.add_argument(
        "--instruments",
        choices=("real", "ideal"),
        default="real",
        help="method global: unknowns of the instruments: real (default): zero and drift of every run, slope of "
        "straightness lines, centre and length of ball bars, zero and centre of probes, scale and alignment of lasers; "
        "ideal: none",
    )
    parser.add_argument("--robust", help="no longer an option: outliers are always left out")


def run(args: argparse.Namespace) -> int:
    """Identify and write; raises InputError with the faults of every file."""
    found = _faults_of_options(args)
    machine = read_machine(args.machine)
    known = None
    with gathering(found):
        model = load_model(args.machine, args.kernels)
    with gathering(found):
        data = load_data(args.data, machine)
        found += faults_of_runs(args.runs, data.data, option)
        found += overwritten(
            {"the active compensation of --data": active_file(args.data, data.data.setup)}, _outputs(args)
        )
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    if found:
        raise InputError(found)
    try:
        identified = _identify(args, model, data, known)
    except NotConvergedError as failure:
        print(f"trueaxis: {failure}; nothing was written", file=sys.stderr)
        print(f"trueaxis: residuals of the worst runs: {runs_text(failure.runs)}\ntrueaxis: {WAY_ON}", file=sys.stderr)
        return 1
    except UnbelievableError as failure:
        worst = failure.report.quality
        misfit = worst.fit.state == "misfit"  # the cause comes first: values are beyond belief because of it
        text = fit_text(worst) if misfit else f"residuals of the worst runs: {runs_text(worst.runs)}"
        print(f"trueaxis: {text}", file=sys.stderr)
        for fault in failure.faults:
            print(f"trueaxis: not written: {fault}", file=sys.stderr)
        return 1
    contents = errors_files(args.out, identified.errors, machine, args.covariance)
    if args.report is not None:
        contents[args.report] = report_json(identified.report)
    write_files(contents)
    if args.squareness == FROM_ANGLES:
        print(f"trueaxis: {FROM_ANGLES_WARNING}", file=sys.stderr)
    print(report_text(identified.report), end="")
    print(f"written: {', '.join(map(named, contents))}")
    judged = identified.report.quality
    if judged.fit.state == "misfit":
        print(f"trueaxis: MISFIT, {judged.reason}; {MISFIT_USE}", file=sys.stderr)
        return 1
    if identified.report.nothing_determined:
        print("trueaxis: the readings determine no error: the values are zero, or those of --known", file=sys.stderr)
        return 1
    return 0


def _identify(args: argparse.Namespace, model: MachineModel, data: DataFolder, known: Errors | None) -> Identified:
    return identify(
        model,
        data,
        runs=args.runs,
        known=known,
        noise_um=args.noise_um,
        noise_urad=args.noise_urad,
        squareness=args.squareness,
        prior=args.prior == "spec",
        ideal_instruments=args.instruments == "ideal",
        degree=args.degree,
        method="stepwise" if args.method == STEPWISE else "global",
        curves=args.curves,
    )


def _faults_of_options(args: argparse.Namespace) -> list[Fault]:
    found = []
    if args.robust is not None:
        remedy = "remove it: outliers are always left out, and counted in the report"
        found.append(Fault("--robust", "", "is no longer an option", remedy))
    choice = MethodChoice(
        method="stepwise" if args.method == STEPWISE else "global", squareness=args.squareness, curves=args.curves,
        known=args.known is not None, noise=replace(args.noise_um, urad=args.noise_urad), degree=args.degree,
        ideal_instruments=args.instruments == "ideal", prior=args.prior == "spec",
    )  # fmt: skip
    found += faults_of_choice(choice, option)
    if args.covariance is not None and args.covariance.suffix != ".npz":
        found.append(Fault(str(args.covariance), "", "is not a .npz file", "a name that ends in .npz"))
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--known": args.known}
    found += overwritten(inputs, _outputs(args), args.kernels)
    return found


def _outputs(args: argparse.Namespace) -> dict[str, Path | None]:
    covariance = args.covariance or args.out.with_suffix(".npz")
    return {"--out": args.out, "--report": args.report, "--covariance": covariance}


def _method_option(text: str) -> str:
    """A method; `paper` is another name of `stepwise`."""
    if text in (STEPWISE, "paper"):
        return STEPWISE
    if text == GLOBAL:
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not global or stepwise (or paper)")


def noise_option(text: str) -> NoiseModel:
    """`0.3`, `laser=0.3,ballbar=0.5`, `laser=repeats,ballbar=0.5`, `repeats` or `repeats-by-run`."""
    if text in _REPEATS:
        return NoiseModel(repeats=_REPEATS[text])
    if "=" not in text:
        return NoiseModel(um=noise(text))
    parts = [part.strip() for part in text.split(",")]
    if any(part.isdigit() for part in parts):
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=S,NAME=S: decimals have a point, as in laser=0.3")
    found: dict[str, float] = {}
    repeated = set()
    for part in parts:
        name, equals, value = (piece.strip() for piece in part.rpartition("="))
        if not (equals and name):
            raise argparse.ArgumentTypeError(f"{part!r} is not NAME=S")
        if name in found or name in repeated:
            raise argparse.ArgumentTypeError(f"{name} is given more than once")
        if value == "repeats":
            repeated.add(name)
        else:
            found[name] = noise(value)
    return NoiseModel(by_group=found, repeated=frozenset(repeated))


def add_noise_urad(parser: argparse.ArgumentParser) -> None:
    """The option --noise-urad."""
    parser.add_argument(
        "--noise-urad",
        type=noise_urad,
        metavar="S",
        help="standard deviation of a reading of angle instruments, urad (default: as that of lengths)",
    )


def _squareness_option(text: str) -> str:
    """A rule for the squareness; `sect36` is the old name of `from-angles`."""
    if text in (FROM_ANGLES, "sect36"):
        return FROM_ANGLES
    if text in ("convention", "known"):
        return text
    raise argparse.ArgumentTypeError(f"{text!r} is not convention, known or {FROM_ANGLES}")


def _degree_option(text: str) -> int:
    """An order of curves; `auto` has been replaced by what may be expected of curves."""
    if text == "auto":
        raise argparse.ArgumentTypeError(
            "auto is no longer a value: --prior spec keeps curves smooth; or give a number"
        )
    return whole(1, HIGHEST_DEGREE)(text)
