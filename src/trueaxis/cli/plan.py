"""trueaxis plan: what runs will tell before they are made, and which runs to make."""

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write, positive, tool_point, whole
from trueaxis.cli.identify_options import noise_option
from trueaxis.cli.measured import read_measured
from trueaxis.cli.plan_faults import RETIRED, faults_of_options
from trueaxis.estimation.result import Estimate
from trueaxis.identification.notes import dimension_notes
from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import Fault, InputError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering, utf8_text
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import read_machine
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.measurement.active_compensation import active_file, moved_setup
from trueaxis.measurement.data import MeasuredData
from trueaxis.measurement.readings import dump_readings
from trueaxis.model.curves import Curve, PolynomialCurve
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_errors, load_model
from trueaxis.planning.extended import new_setup, setup_text
from trueaxis.planning.method import PlanOptions, Proposed, first_plan, judged_plan, proposed
from trueaxis.planning.propose import VOLUME
from trueaxis.planning.report import PlanReport
from trueaxis.planning.report_text import report_json, report_text
from trueaxis.planning.runs import PlannedRuns
from trueaxis.planning.slices import slices

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Say what the runs of --data will tell, before any reading is taken (readings that are there are not looked at): the
standard uncertainty to expect of every error and of the tool point over the volume, what of it rests on [prior] of the
spec, what is known only in combination, whether repeats tell the noise, the order of blocks for --method stepwise.
--propose N adds the runs that lower the uncertainty most per minute. --with, without --data, makes a first plan from
nothing. Exit code 1 where the runs tell nothing."""

MOST_PROPOSED = 100
INSTRUMENTS = ("laser", "ballbar", "probe")


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("plan", help="what runs will tell, and which to make", description=DESCRIPTION)
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--data", type=Path, metavar="DIR", help="folder with setup.toml, readings.csv: the plan")
    parser.add_argument(
        "--with", nargs="+", choices=INSTRUMENTS, default=[], metavar="NAME", dest="instruments",
        help="without --data: a first plan with laser, ballbar, probe, written to --out",
    )  # fmt: skip
    parser.add_argument(
        "--hours", type=positive, metavar="H",
        help="of measuring time for it (default: until no run lowers the uncertainty by a hundredth)",
    )  # fmt: skip
    parser.add_argument(
        "--runs", nargs="+", default=[], metavar="ID", help="judge these runs only (default: all of the folder)"
    )
    parser.add_argument(
        "--noise-um", type=noise_option, default=NoiseModel(), metavar="S",
        help="standard deviation of a reading, um, or of those of instruments or runs: laser=0.3,ballbar=0.5 (default: "
        "as [device] tables say, else 1)",
    )  # fmt: skip
    parser.add_argument(
        "--known", type=Path, metavar="E.json", help="values known beforehand: dimensions, location errors, components"
    )
    parser.add_argument(
        "--effects", type=Path, metavar="E.json",
        help="values of effects of the spec to plan for, where how well they are told depends on how large they are "
        "(default: such as change a reading by 5 um)",
    )  # fmt: skip
    parser.add_argument(
        "--location-errors-only", action="store_true", help="motion errors are no unknowns: known, or left at zero"
    )
    parser.add_argument(
        "--tool-point", type=tool_point, action="append", default=[], metavar="X,Y,Z",
        help="point in the tool frame, mm, whose uncertainty counts (0,0,0); given more than once: their mean",
    )  # fmt: skip
    parser.add_argument(
        "--propose", type=whole(1, MOST_PROPOSED), metavar="N",
        help="choose the N runs that add most per minute; with --out, write them",
    )  # fmt: skip
    parser.add_argument(
        "--propose-with", nargs="+", choices=INSTRUMENTS, default=[], metavar="NAME",
        help="of the runs to propose: laser, ballbar, probe (default: those of the plan)",
    )  # fmt: skip
    parser.add_argument(
        "--for", default=VOLUME, metavar="NAME", dest="wanted",
        help="what proposed runs are to tell best: volume (default: the tool point over the volume), a component such "
        "as EYX, or a location error",
    )  # fmt: skip
    parser.add_argument(
        "--datum", choices=("home", "best-fit"), default="home",
        help="what the tool point is known against by proposed runs: the tool point at home (default), or a workpiece "
        "placed where it fits best: balls and beams do not see a turn of the whole volume",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="another folder, to be written: the plan with the proposed runs"
    )
    parser.add_argument("--report", type=file_to_write, metavar="FILE", help="write the report as JSON, too")
    parser.add_argument(
        "--picture", type=file_to_write, metavar="FILE.png", help="draw the uncertainty of the tool point in the volume"
    )
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    for option, retired in RETIRED.items():
        parser.add_argument(option, help=f"gone: {retired.instead}", **retired.argument)
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Judge a plan or make one; raises InputError with the faults of every file."""
    found = faults_of_options(args)
    effects = _effects(args, found)
    contents: dict[Path, bytes | str] = {}
    if args.data is None:
        model, known = _model(args, found)
        options = _options(args, model, known, effects)
        made = first_plan(model, options, args.instruments, args.hours)
        if not made.runs:
            print(f"{named(args.out)}: not written: {_no_run(args)}")
            return 1
        report = PlanReport(machine=model.name, source="", expected=None, proposal=made.report)
        expected = made.expected
        contents |= _written(args, new_setup(model.name), args.out, made)
    else:
        read = read_measured(args, found)
        model, data = read.model, read.data
        _check_files(args, data)
        options = _options(args, model, read.known, effects)
        planned = PlannedRuns(str(args.data), data.setup.runs, data.readings)
        planned = planned.of(args.runs) if args.runs else planned
        report, expected = judged_plan(model, options, planned)
        if args.propose is not None:
            added = proposed(model, options, planned, args.propose, args.propose_with)
            report, expected = replace(report, proposal=added.report), added.expected
            if args.out is not None:
                setup = args.data / setup_file.FILE_NAME
                contents |= _written(args, utf8_text(setup, moved_setup(args.data, args.out)), setup, added)
    report = replace(report, caveats=dimension_notes(model, options.given))
    if args.report is not None:
        contents[args.report] = report_json(report)
    if args.picture is not None:
        contents[args.picture] = _picture(expected, options)
    write_files(contents)
    print(report_text(report), end="")
    if contents:
        print(f"written: {', '.join(map(named, contents))}")
    return 1 if report.nothing_determined else 0


def _no_run(args: argparse.Namespace) -> str:
    if args.hours is None:
        return "no run of these instruments tells anything of what is asked for"
    return f"no run that tells anything of what is asked for fits into {args.hours:g} h with its set-up"


def _model(args: argparse.Namespace, found: list[Fault]) -> tuple[MachineModel, ErrorValues | None]:
    """For a plan from nothing. Raises InputError with the faults of all files, after those found before."""
    machine = read_machine(args.machine)
    model = known = None
    with gathering(found):
        model = load_model(args.machine, None, args.kernels)
    if args.known is not None:
        with gathering(found):
            known = load_errors(args.known, machine)
    if found or model is None:
        raise InputError(found)
    return model, known


def _effects(args: argparse.Namespace, found: list[Fault]) -> tuple[EffectValues, ...]:
    """Values of --effects; faults of the file are added to those found. Raises InputError where the spec has any."""
    effects: tuple[EffectValues, ...] = ()
    if args.effects is not None:
        machine = read_machine(args.machine)
        with gathering(found):
            effects = load_errors(args.effects, machine).effects
    return effects


def _check_files(args: argparse.Namespace, data: MeasuredData) -> None:
    """Raise InputError where an output is the active compensation, or runs are named that are not there."""
    active = {"the active compensation of --data": active_file(args.data, data.setup)}
    found = overwritten(active, {"--report": args.report, "--picture": args.picture})
    ids = [run.id for run in data.setup.runs]
    found += [
        Fault("--runs", name, "is no run of the setup", f"of {', '.join(ids)}") for name in args.runs if name not in ids
    ]
    if found:
        raise InputError(found)


def _options(
    args: argparse.Namespace, model: MachineModel, known: ErrorValues | None, effects: tuple[EffectValues, ...]
) -> PlanOptions:
    given = known or ErrorValues(model.name)
    given = replace(given, u={}, undetermined=(), covariance=None, fit=None)
    if args.location_errors_only:
        zeros: dict[str, Curve] = dict.fromkeys(model.components, PolynomialCurve((), ()))
        given = replace(given, motion_errors={**zeros, **given.motion_errors})
    unknown: list[str] = [name for name in model.components if name not in given.motion_errors]
    unknown += [name for name in model.location_errors if name not in given.parameters]
    if args.wanted not in (VOLUME, *unknown):
        problem = "is no error that is to be identified"
        raise InputError([Fault("--for", args.wanted, problem, f"{VOLUME}, or one of {', '.join(unknown)}")])
    tools = tuple(args.tool_point) or ((0.0, 0.0, 0.0),)
    return PlanOptions(
        given=given, noise=args.noise_um, tools=tools, wanted=args.wanted, datum=args.datum, effects=effects
    )


def _written(args: argparse.Namespace, setup: str, file: Path, made: Proposed) -> dict[Path, bytes | str]:
    """The plan with the runs, as a folder of measured data. setup: the text that they are added to, of a file."""
    return {
        args.out / setup_file.FILE_NAME: setup_text(setup, made.runs, str(file)),
        args.out / readings_files.FILE_NAME: dump_readings(made.planned.readings),
    }


def _picture(expected: Estimate, options: PlanOptions) -> bytes:
    from trueaxis.reporting.pictures.tool_uncertainty import uncertainty_picture  # noqa: PLC0415  matplotlib takes long to import

    return uncertainty_picture(slices(expected, options.tools))
