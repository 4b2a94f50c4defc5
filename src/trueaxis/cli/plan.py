"""trueaxis plan: what runs will tell before they are made, and which runs to make.

What options do not go together is told, and what has replaced options that it had.
"""

import argparse
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trueaxis.cli.arguments import file_to_write, option, positive, tool_point, whole
from trueaxis.cli.arguments import option as option_of
from trueaxis.cli.identify import add_noise_urad, noise_option
from trueaxis.cli.measured import read_measured
from trueaxis.identification.weighting import NoiseModel
from trueaxis.io.faults import Fault, InputError, RefusedError
from trueaxis.io.files import write_files
from trueaxis.io.input_files import gathering
from trueaxis.jobs.given import faults_of_runs
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.jobs.plan import planned
from trueaxis.jobs.plan_request import MOST_PROPOSED, PlanRequest, faults_of_request, outputs_of
from trueaxis.jobs.tables import ORIGIN
from trueaxis.machine import read_machine
from trueaxis.measurement.active_compensation import active_file
from trueaxis.model.effect_values import EffectValues
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, load_errors, load_model
from trueaxis.planning.candidates import WITH_CANDIDATES
from trueaxis.planning.propose import VOLUME

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

DESCRIPTION = """\
Say how well the runs of --data will determine the errors, before any reading is taken (readings in the folder are
ignored): the standard uncertainty of every error and of the tool point over the volume, and the part of it that rests
on [prior] of the spec; errors known only in combination; whether repeats determine the noise; the order of blocks for
--method stepwise. --propose N adds the runs that lower the uncertainty most per minute. --with, without --data, makes a
first plan. Exit code 1: the runs determine nothing."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("plan", help="what runs will tell, and which to make", description=DESCRIPTION)
    _add_given(parser)
    _add_proposals(parser)
    _add_outputs(parser)
    for name, retired in RETIRED.items():
        parser.add_argument(name, help=f"no longer an option: {retired.instead}", **retired.argument)
    parser.set_defaults(run=run)


def _add_given(parser: argparse.ArgumentParser) -> None:
    """The machine, the runs, and what is known of both."""
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument("--data", type=Path, metavar="DIR", help="folder with setup.toml, readings.csv: the plan")
    parser.add_argument(
        "--with", nargs="+", choices=WITH_CANDIDATES, default=[], metavar="NAME", dest="instruments",
        help="without --data: a first plan with laser, ballbar, probe, angle, written to --out",
    )  # fmt: skip
    parser.add_argument(
        "--hours", type=positive, metavar="H",
        help="measuring time of the first plan (default: until no run lowers the uncertainty by a hundredth)",
    )  # fmt: skip
    parser.add_argument(
        "--runs", nargs="+", default=[], metavar="ID", help="judge these runs only (default: all of the folder)"
    )
    parser.add_argument(
        "--noise-um", type=noise_option, default=NoiseModel(), metavar="S",
        help="standard deviation of a reading, um; by instrument or run: laser=0.3,ballbar=0.5 (default: from "
        "[device] tables, else 1)",
    )  # fmt: skip
    add_noise_urad(parser)
    parser.add_argument(
        "--known", type=Path, metavar="E.json", help="known error values: dimensions, location errors, components"
    )
    parser.add_argument(
        "--effects", type=Path, metavar="E.json",
        help="values of effects of the spec to plan for, if their uncertainty depends on their size (default: effects "
        "that change a reading by 5 um)",
    )  # fmt: skip
    parser.add_argument(
        "--location-errors-only", action="store_true", help="error motions are no unknowns: known, or zero"
    )
    parser.add_argument(
        "--tool-point", type=tool_point, action="append", default=[], metavar="X,Y,Z",
        help="point in the tool frame, mm, whose uncertainty counts (0,0,0); given more than once: their mean",
    )  # fmt: skip


def _add_proposals(parser: argparse.ArgumentParser) -> None:
    """Which runs are proposed."""
    parser.add_argument(
        "--propose", type=whole(1, MOST_PROPOSED), metavar="N",
        help="choose the N runs that lower the uncertainty most per minute; with --out, write them",
    )  # fmt: skip
    parser.add_argument(
        "--propose-with", nargs="+", choices=WITH_CANDIDATES, default=[], metavar="NAME",
        help="instruments of the runs to propose: laser, ballbar, probe, angle (default: those of the plan)",
    )  # fmt: skip
    parser.add_argument(
        "--for", default=VOLUME, metavar="NAME", dest="wanted",
        help="error that proposed runs are to determine best: volume (default: the tool point over the volume), a "
        "component such as EYX, or a location error",
    )  # fmt: skip
    parser.add_argument(
        "--datum", choices=("home", "best-fit"), default="home",
        help="reference of the tool point for proposed runs: the tool point at home (default), or a workpiece placed "
        "where it fits best (balls and beams do not see a rotation of the whole volume)",
    )  # fmt: skip


def _add_outputs(parser: argparse.ArgumentParser) -> None:
    """What is written, and with which kernels."""
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


def run(args: argparse.Namespace) -> int:
    """Judge a plan or make one; raises InputError with the faults of every file."""
    request = PlanRequest(
        instruments=args.instruments, hours=args.hours, runs=args.runs, propose=args.propose,
        propose_with=args.propose_with, wanted=args.wanted, datum=args.datum,
        noise=replace(args.noise_um, urad=args.noise_urad),
        location_errors_only=args.location_errors_only, tools=tuple(args.tool_point) or (ORIGIN,), out=args.out,
    )  # fmt: skip
    found = _faults_of_options(args, request)
    effects = _effects(args, found)
    data = None
    if args.data is None:
        model, known = _model(args, found)
    else:
        read = read_measured(args, found)
        model, data, known = read.model, read.data, read.known
        active = {"the active compensation of --data": active_file(args.data, data.setup)}
        found = overwritten(active, {"--report": args.report, "--picture": args.picture})
        if found := found + faults_of_runs(request.runs, data, option):
            raise InputError(found)
    try:
        done = planned(model, data, known, effects, request, args.data, option)
    except RefusedError as refused:
        print(f"{named(args.out)}: not written: {refused}")
        return 1
    contents = {args.out / name: content for name, content in done.contents.items()}
    if args.report is not None:
        contents[args.report] = done.to_json()
    if args.picture is not None:
        contents[args.picture] = done.picture()
    write_files(contents)
    print(done, end="")
    if contents:
        print(f"written: {', '.join(map(named, contents))}")
    return 1 if done.report.nothing_determined else 0


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


@dataclass(frozen=True, slots=True)
class Retired:
    """An option that is gone: why, and what to use; argument: how it was given."""

    why: str
    instead: str
    argument: dict[str, Any] = field(default_factory=lambda: {"action": "store_true", "default": None})


RETIRED = {
    "--degree": Retired(
        "curves are smooth as the prior has it, of order 14 at most",
        "[prior] in the spec says how large errors are",
        {"default": None, "metavar": "N"},
    ),
    "--ideal-instruments": Retired(
        "instruments have unknowns as identify has them", "scale_u_ppm, length_u_um in [device] tables of setup.toml"
    ),
    "--unknown-linkage-lines": Retired("the zero and the alignment of every laser run are unknown", "leave it out"),
    "--unknown-zeros": Retired("the zero of every run is unknown", "leave it out"),
}


def _faults_of_options(args: argparse.Namespace, request: PlanRequest) -> list[Fault]:
    """All of them; nothing is read for it."""
    found = [
        Fault(option, "", f"is no longer an option: {one.why}", one.instead)
        for option, one in RETIRED.items()
        if getattr(args, option[2:].replace("-", "_")) is not None
    ]
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--known": args.known, "--effects": args.effects}
    outputs = {"--report": args.report, "--picture": args.picture, **outputs_of(request, args.data)}
    found += overwritten(inputs, outputs, args.kernels)
    return found + faults_of_request(request, args.data, option_of, writes=True)
