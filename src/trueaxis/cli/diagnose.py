"""`trueaxis diagnose`: what a machine's model lacks, named from what it leaves unexplained in measured data."""

import argparse
import sys
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, cast

from trueaxis.cli.arguments import noise
from trueaxis.cli.measured import read_measured
from trueaxis.cli.progress import progress
from trueaxis.identification.fit_quality import NotConvergedError
from trueaxis.identification.notes import compensation_note
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering, input_bytes, utf8_text
from trueaxis.jobs.beside import beside, cores
from trueaxis.jobs.derive import identification_runs
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.read import parse_machine
from trueaxis.measurement.active_compensation import active_file
from trueaxis.measurement.data import MeasuredData
from trueaxis.model.covariance import Covariance
from trueaxis.model.errors import ErrorValues, dump_errors
from trueaxis.model.kernels import numpy_kernels
from trueaxis.model.manifest import KERNEL_FILES
from trueaxis.model.model import MachineModel
from trueaxis.model.uncertainty import load_uncertainty
from trueaxis.reporting.reliance import misfit_sentence

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern
    from trueaxis.diagnosis.extended_spec import Extended
    from trueaxis.diagnosis.result import Diagnosis
    from trueaxis.reporting.diagnosis.picture import Pictures

_DrawnAndDerived = tuple["Pictures", Mapping[str, bytes]]

DESCRIPTION = """\
Name what a machine's model lacks: of the causes that the effect library knows (backlash, cyclic errors, thermal growth,
servo lag, a laser or ball bar that is off ...) those that explain what the model with its error values leaves of the
readings, each with size, uncertainty, evidence, and rivals that the readings cannot tell it from. --out gets
diagnosis.json and report.html and, where causes were named, the extended model, ready for every other command:
NAME.toml (the spec with [[effect]] tables), errors.json (its values, identified anew) and generated/NAME/."""

EPILOG = """\
exit code: 0 the readings are noise, or named causes or a recalibration explain them; 1 several causes explain them
alike, or nothing that is known does; 2 the input is wrong and nothing was written"""

NO_ANSWER = ("ambiguous", "unexplained_structure")
DIAGNOSIS, REPORT, ERRORS, KERNELS = "diagnosis.json", "report.html", "errors.json", "generated"


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "diagnose", help="name what the model lacks, and extend it", description=DESCRIPTION, epilog=EPILOG
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument(
        "--errors", type=Path, metavar="E.json", help="its error values (default: all zero, as of a machine as built)"
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


@dataclass(frozen=True)
class Given:
    """What was read. covariance: of the error values; spec: its text as it must read in the folder to be written; runs:
    whose systems are derived.
    """

    model: MachineModel
    covariance: Covariance | None
    data: MeasuredData
    spec: str
    runs: "tuple[RunPattern, ...]"


def run(args: argparse.Namespace) -> int:
    """Diagnose, extend, write; raises InputError with the faults of every file and option."""
    # figures are drawn and a machine is derived by a second process, which gets ready for it meanwhile
    with progress() as show, beside("trueaxis.jobs.drawn_and_derived") as start:
        show("reading")
        given = _read(args)
        # only this command needs them, and not for wrong input
        from trueaxis.diagnosis.procedure import DiagnoseOptions, diagnose  # noqa: PLC0415
        from trueaxis.reporting.diagnosis.text import summary_text  # noqa: PLC0415

        extending = Extending(args.out, given, start)
        try:
            with ThreadPoolExecutor(cores()) as pool:
                options = DiagnoseOptions(args.noise_um, given.covariance, show, pool.map, extending)
                diagnosis = diagnose(given.model, given.data, options)
        except NotConvergedError as failure:
            show("")
            print(f"trueaxis: values of the extended machine: {failure}; nothing was written", file=sys.stderr)
            return 1
        show("report")
        contents = _contents(args.out, given, diagnosis, extending)
        write_files(contents)
    of_values = given.model.errors.fit
    if of_values is not None and of_values.state == "misfit":
        print(f"note: {misfit_sentence(of_values)}")
    print(summary_text(diagnosis), end="")
    if given.data.setup.compensation is not None and given.data.setup.compensation.file is not None:
        print(f"note: {compensation_note(given.data.setup, args.data)}")
    print(f"written: {', '.join(map(named, contents))}")
    left = [path for path in _outputs(args.out, given.model.name) if path not in contents and path.exists()]
    if left:
        print(f"left from before, no part of this diagnosis: {', '.join(map(named, left))}")
    return 1 if diagnosis.verdict in NO_ANSWER else 0


class Extending:
    """The model of the machine with the causes that a diagnosis names, which the second process draws and derives
    meanwhile. extended: None before it is called, and where none was named.
    """

    def __init__(self, out: Path, given: Given, start: "Callable[..., Callable[[], object]]") -> None:
        self.out, self.given, self.start = out, given, start
        self.extended: Extended | None = None
        self.misfits: tuple[str, ...] = ()

    def __call__(self, diagnosis: "Diagnosis") -> MachineModel:
        """See `Extend`; once for a diagnosis."""
        model = self.given.model
        self.extended, self.misfits = _extended(self.out, self.given, diagnosis), diagnosis.misfits
        self.second = cache(
            cast("Callable[[], _DrawnAndDerived]", self.start("drawn_and_derived", diagnosis, self.extended))
        )
        if self.extended is None:
            return model
        machine, kernels = self.extended.machine, model.kernels
        # kernels serve any machine with the same parameters: effects have theirs apart, location errors have not
        if machine.parameters != model.machine.parameters:
            kernels = numpy_kernels(self.second()[1]["kernels.py"], self.out / self.extended.spec)
        return MachineModel(machine, kernels, ErrorValues(machine.name))


def _contents(out: Path, given: Given, diagnosis: "Diagnosis", extending: Extending) -> dict[Path, bytes | str]:
    """Of every file that is written."""
    from trueaxis.reporting.diagnosis.html import report_html  # noqa: PLC0415
    from trueaxis.reporting.diagnosis.json_file import diagnosis_json  # noqa: PLC0415

    pictures, files = extending.second()
    if diagnosis.misfits != extending.misfits:  # names were taken back
        from trueaxis.reporting.diagnosis.pictures import pictures_of  # noqa: PLC0415 - seldom, and slow to import

        pictures = pictures_of(diagnosis)
    extended = extending.extended if diagnosis.values is not None else None
    spec = None if extended is None else extended.spec
    contents: dict[Path, bytes | str] = {
        out / DIAGNOSIS: diagnosis_json(diagnosis, spec, ERRORS if extended else None),
        out / REPORT: report_html(diagnosis, pictures),
    }
    if extended is not None and diagnosis.values is not None:
        machine = extended.machine
        contents[out / extended.spec] = extended.text
        contents[out / ERRORS] = dump_errors(
            diagnosis.values,
            components=machine.components,
            parameters=machine.parameters,
            effects=machine.effects,
        )
        contents |= {out / KERNELS / given.model.name / name: content for name, content in files.items()}
    return contents


def _read(args: argparse.Namespace) -> Given:
    from trueaxis.diagnosis.extended_spec import moved_spec  # noqa: PLC0415
    from trueaxis.diagnosis.rows import rows_of  # noqa: PLC0415

    found: list[Fault] = []
    if args.out.exists() and not args.out.is_dir():
        found.append(Fault(str(args.out), "", "is a file", "a folder for --out"))
    machine, text = None, ""
    runs: tuple[RunPattern, ...] = ()
    with gathering(found):
        machine = read_machine(args.machine)
    if machine is None:
        raise InputError(found)
    found += _overwritten(args, machine)
    with gathering(found):
        runs = identification_runs(machine, args.machine)
    with gathering(found):
        text = utf8_text(args.machine, input_bytes(args.machine))
        try:
            text = moved_spec(text, args.machine.parent, args.out)
        except ValueError:
            problem = "cannot be written for another folder"
            found.append(Fault(str(args.machine), "key runs", problem, "a text of one line in quotes"))
    measured = read_measured(argparse.Namespace(**vars(args), known=args.errors), found)
    covariance = None
    if measured.known is not None:
        with gathering(found):
            covariance = load_uncertainty(args.errors, measured.known, machine)
    if measured.data.readings.planned.all():
        remedy = "take them, or make some with simulate"
        found.append(Fault(str(args.data), "column reading", "is a plan: there is no reading in it", remedy))
    elif not found and rows_of(measured.data).size == 0:
        problem = "in none of them is it known from where all moving axes came, away from a reversal"
        found.append(Fault(str(args.data), "readings", problem, "columns dir_X ..., or more readings a run"))
    active = {"the active compensation of --data": active_file(args.data, measured.data.setup)}
    found += overwritten(active, {str(path.relative_to(args.out)): path for path in _outputs(args.out, machine.name)})
    if found:
        raise InputError(found)
    errors = measured.known or ErrorValues(machine.name)
    return Given(measured.model.with_values(errors), covariance, measured.data, text, runs)


def _overwritten(args: argparse.Namespace, machine: Machine) -> list[Fault]:
    inputs = {"MACHINE.toml": args.machine, "--data": args.data}
    inputs |= {} if args.errors is None else {"--errors": args.errors}
    outputs = _outputs(args.out, machine.name)
    return overwritten(inputs, {f"{path.relative_to(args.out)} of --out": path for path in outputs}, args.kernels)


def _outputs(out: Path, name: str) -> list[Path]:
    """Every file that may be written."""
    kernels = [out / KERNELS / name / file for file in KERNEL_FILES]
    return [out / DIAGNOSIS, out / REPORT, out / f"{name}.toml", out / ERRORS, *kernels]


def _extended(out: Path, given: Given, diagnosis: "Diagnosis") -> "Extended | None":
    """The machine with the causes that were named; None where none was."""
    from trueaxis.diagnosis.extend import named_effects  # noqa: PLC0415
    from trueaxis.diagnosis.extended_spec import Extended, extended_spec  # noqa: PLC0415

    effects = named_effects(diagnosis)
    if not effects:
        return None
    path = out / f"{given.model.name}.toml"
    text = extended_spec(given.spec, effects)
    return Extended(parse_machine(text, Faults(str(path))), given.runs, path.name, text)
