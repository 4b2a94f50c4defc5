"""trueaxis plan: what runs can and cannot determine, before they are made."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.commands.arguments import file_to_write, noise, whole
from trueaxis.commands.measured import read_measured
from trueaxis.commands.paths import named, overwritten
from trueaxis.faults import Fault, InputError
from trueaxis.files import write_files
from trueaxis.input_files import utf8_text
from trueaxis.measure import readings as readings_files
from trueaxis.measure import setup as setup_file
from trueaxis.measure.active_compensation import active_file, moved_setup
from trueaxis.measure.readings import Readings, dump_readings
from trueaxis.plan.candidates import Candidate
from trueaxis.plan.extended import setup_text, with_runs
from trueaxis.plan.instruments import Assumptions
from trueaxis.plan.method import PlanOptions, judge, plan_of, planned
from trueaxis.plan.propose import propose
from trueaxis.plan.repair import repair
from trueaxis.plan.report_text import report_json, report_text
from trueaxis.plan.rows import of_runs
from trueaxis.runtime.curves import Curve, PolynomialCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.spec import Machine

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Say what the runs of --data can and cannot determine, and in which order, before any reading is taken (readings that
are there are not looked at): rank and condition, the order of blocks, the standard uncertainty to expect of each
error, combinations that stay open, location errors that are redundant. Where the plan is singular, points that would
mend it are sought; --propose N seeks the runs that would add most. Exit code 1 where the runs determine nothing."""

HIGHEST_DEGREE = 30
MOST_PROPOSED = 100
INSTRUMENTS = ("laser", "ballbar", "probe")


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("plan", help="what runs can and cannot determine", description=DESCRIPTION)
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--data", type=Path, required=True, metavar="DIR", help="folder with setup.toml, readings.csv")
    parser.add_argument(
        "--runs", nargs="+", default=[], metavar="ID", help="judge these runs only (default: all of the folder)"
    )
    parser.add_argument(
        "--noise-um", type=noise, default=1.0, metavar="S",
        help="standard deviation of a reading, um (1: what 1 um of every reading becomes)",
    )  # fmt: skip
    parser.add_argument(
        "--degree", type=whole(1, HIGHEST_DEGREE), default=7, metavar="N", help="highest power of a motion error (7)"
    )
    parser.add_argument(
        "--known", type=Path, metavar="E.json", help="values known beforehand: dimensions, location errors, components"
    )
    parser.add_argument(
        "--location-errors-only", action="store_true", help="motion errors are no unknowns: known, or left at zero"
    )
    parser.add_argument(
        "--ideal-instruments", action="store_true",
        help="nothing is unknown of the instruments; else straightness lines (offset and slope), ball bars (centre and "
        "length) and probes (zero, centre of the sphere) have unknowns of their own",
    )  # fmt: skip
    parser.add_argument(
        "--unknown-linkage-lines", action="store_true",
        help="laser lines along which two axes move are where they are, too: offset and slope unknown",
    )  # fmt: skip
    parser.add_argument("--unknown-zeros", action="store_true", help="the zero of laser and probe at home is not exact")
    parser.add_argument(
        "--propose",
        type=whole(1, MOST_PROPOSED),
        metavar="N",
        help="choose the N runs that would add most; with --out, write them",
    )
    parser.add_argument(
        "--propose-with", nargs="+", choices=INSTRUMENTS, default=[], metavar="NAME",
        help="of the runs to propose: laser, ballbar, probe (default: those of the plan)",
    )  # fmt: skip
    parser.add_argument(
        "--out", type=Path, metavar="DIR", help="another folder, to be written: the plan with the proposed runs"
    )
    parser.add_argument("--report", type=file_to_write, metavar="FILE", help="write the report as JSON, too")
    parser.add_argument(
        "--kernels", type=Path, default=Path("generated"), metavar="DIR", help="folder of derived kernels (%(default)s)"
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Judge a plan; raises InputError with the faults of every file."""
    found = _faults_of_options(args)
    read = read_measured(args, found)
    machine, model, data, known = read.model.machine, read.model, read.data, read.known
    if found := overwritten(
        {"the active compensation of --data": active_file(args.data, data.setup)}, {"--report": args.report}
    ):
        raise InputError(found)
    _check_runs(args.runs, [run.id for run in data.setup.runs])
    assumed = Assumptions(args.ideal_instruments, args.unknown_linkage_lines, args.unknown_zeros)
    if args.location_errors_only:
        known = _no_motion_errors(machine, known)
    options = PlanOptions(args.noise_um, args.degree, assumed, known)
    observed = planned(str(args.data), data.setup.runs, data.readings)
    if args.runs:
        ids = [run.id for run in data.setup.runs]
        observed = of_runs(observed, tuple(index for index, name in enumerate(ids) if name in args.runs))
    plan = plan_of(model, observed, options)
    report = judge(plan)
    report = replace(report, repair=repair(plan, report))
    contents: dict[Path, bytes | str] = {}
    if args.propose is not None:
        extended = propose(plan, args.propose, args.propose_with)
        report = replace(report, proposal=extended.proposal)
        if args.out is not None:
            contents = _extended(args, extended.runs, data.readings)
    if args.report is not None:
        contents[args.report] = report_json(report)
    write_files(contents)
    print(report_text(report), end="")
    if contents:
        print(f"written: {', '.join(map(named, contents))}")
    return 1 if report.nothing_determined else 0


def _check_runs(wanted: Sequence[str], there: Sequence[str]) -> None:
    found = [Fault("--runs", name, "is no run of the setup", f"of {', '.join(there)}") for name in wanted]
    found = [fault for fault in found if fault.place not in there]
    if found:
        raise InputError(found)


def _no_motion_errors(machine: Machine, known: ErrorValues | None) -> ErrorValues:
    """Every component known, at zero where nothing else is said."""
    known = known or ErrorValues(machine.name)
    zeros: dict[str, Curve] = dict.fromkeys(machine.components, PolynomialCurve((), ()))
    return replace(known, motion_errors={**zeros, **known.motion_errors})


def _extended(args: argparse.Namespace, runs: Sequence[Candidate], given: Readings) -> dict[Path, bytes | str]:
    setup = args.data / setup_file.FILE_NAME
    return {
        args.out / setup_file.FILE_NAME: setup_text(
            utf8_text(setup, moved_setup(args.data, args.out)), runs, str(setup)
        ),
        args.out / readings_files.FILE_NAME: dump_readings(with_runs(given, runs)),
    }


def _faults_of_options(args: argparse.Namespace) -> list[Fault]:
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--known": args.known}
    outputs = {"--report": args.report}
    if args.out is not None and args.out.resolve() != args.data.resolve():
        outputs |= {f"{name} of --out": args.out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)}
    found = overwritten(inputs, outputs, args.kernels)
    if args.ideal_instruments:
        for option in ("unknown_linkage_lines", "unknown_zeros"):
            if getattr(args, option):
                name = f"--{option.replace('_', '-')}"
                found.append(Fault(name, "", "does not go with --ideal-instruments", "one of them"))
    if args.out is None:
        return found
    if args.runs:
        found.append(Fault("--out", "", "goes with all runs", "no --runs"))
    if args.propose is None:
        found.append(Fault("--out", "", "is for proposed runs", "--propose N as well"))
    other = args.out / readings_files.PARQUET_NAME
    if args.out.resolve() == args.data.resolve():
        found.append(Fault(str(args.out), "", "is the folder of the plan itself", "another folder for --out"))
    elif other.exists():
        found.append(Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it"))
    return found
