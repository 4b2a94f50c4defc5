"""`trueaxis diagnose`: what a machine's model lacks, named from what it leaves unexplained in measured data."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import noise
from trueaxis.cli.measured import read_measured
from trueaxis.cli.progress import progress
from trueaxis.io.faults import InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.beside import beside
from trueaxis.jobs.derive import identification_runs
from trueaxis.jobs.diagnose import diagnosed, faults_of_data, faults_of_target, left_behind, outputs_of
from trueaxis.jobs.extending import SECOND, Given, spec_text
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import read_machine
from trueaxis.measurement.active_compensation import active_file
from trueaxis.model.errors import ErrorValues
from trueaxis.model.uncertainty import load_uncertainty

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern

DESCRIPTION = """\
Name what the model of a machine lacks. The residuals of the readings are searched for the causes of the effect library
(backlash, cyclic errors, thermal growth, servo lag, a laser or ball bar that is off ...). Each cause is reported with
its size, uncertainty and evidence, and with rivals that the readings cannot distinguish from it. --out gets
diagnosis.json and report.html and, if causes have a name that nothing rivals, the extended model for all other
commands: NAME.toml (the spec with [[effect]] tables), errors.json (its values, identified again), generated/NAME/."""

EPILOG = """\
exit code: 0 the readings are noise, or named causes or a recalibration explain them; 1 several causes explain them
alike, no known cause does, or the values of the machine with the causes have not converged; 2 the input is wrong and
nothing was written"""

NO_ANSWER = ("ambiguous", "unexplained_structure")


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "diagnose", help="name what the model lacks, and extend it", description=DESCRIPTION, epilog=EPILOG
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument(
        "--errors", type=Path, metavar="E.json", help="its error values (default: all zero, the nominal machine)"
    )
    parser.add_argument("--data", type=Path, required=True, metavar="DIR", help="folder with setup.toml, readings.csv")
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="folder to be written")
    parser.add_argument(
        "--noise-um",
        type=noise,
        metavar="S",
        help="standard deviation of a reading, um (default: from repeated readings)",
    )
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Diagnose, extend, write; raises InputError with the faults of every file and option."""
    # figures are drawn and a machine is derived by a second process, which gets ready for it meanwhile
    with progress() as show, beside(SECOND) as start:
        show("reading")
        given = _read(args)
        done = diagnosed(given, args.out, args.noise_um, start, show)
    print(done, end="")
    print(f"written: {', '.join(map(named, done.files))}")
    if left := left_behind(args.out, done):
        print(f"left from before, not part of this diagnosis: {', '.join(map(named, left))}")
    return 1 if done.verdict in NO_ANSWER or not done.diagnosis.settled else 0


def _read(args: argparse.Namespace) -> Given:
    found = faults_of_target(args.out)
    machine, text, covariance = None, "", None
    runs: tuple[RunPattern, ...] = ()
    with gathering(found):
        machine = read_machine(args.machine)
    if machine is None:
        raise InputError(found)
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--errors": args.errors}
    outputs = outputs_of(args.out, machine.name)
    found += overwritten(inputs, {f"{name} of --out": path for name, path in outputs.items()}, args.kernels)
    with gathering(found):
        runs = identification_runs(machine, args.machine)
    with gathering(found):
        text = spec_text(args.machine, args.out)
    measured = read_measured(argparse.Namespace(**vars(args), known=args.errors), found)
    if measured.known is not None:
        with gathering(found):
            covariance = load_uncertainty(args.errors, measured.known, machine)
    found += faults_of_data(measured.data, args.data, found)
    found += overwritten({"the active compensation of --data": active_file(args.data, measured.data.setup)}, outputs)
    if found:
        raise InputError(found)
    model = measured.model.with_values(measured.known or ErrorValues(machine=machine.name))
    return Given(model=model, covariance=covariance, data=measured.data, folder=args.data, spec=text, runs=runs)
