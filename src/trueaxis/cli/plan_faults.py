"""What options of `plan` do not go together, and what has replaced options that it had."""

import argparse
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from trueaxis.io.faults import Fault
from trueaxis.jobs.outputs import overwritten
from trueaxis.measurement import readings as readings_files
from trueaxis.measurement import setup as setup_file
from trueaxis.planning.propose import VOLUME


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


def faults_of_options(args: argparse.Namespace) -> list[Fault]:
    """All of them; nothing is read for it."""
    found = [
        Fault(option, "", f"is no option any more: {one.why}", one.instead)
        for option, one in RETIRED.items()
        if getattr(args, option[2:].replace("-", "_")) is not None
    ]
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--known": args.known, "--effects": args.effects}
    outputs = {"--report": args.report, "--picture": args.picture}
    same = args.out is not None and args.data is not None and args.out.resolve() == args.data.resolve()
    if args.out is not None and not same:
        outputs |= {f"{name} of --out": args.out / name for name in (setup_file.FILE_NAME, readings_files.FILE_NAME)}
    found += overwritten(inputs, outputs, args.kernels)
    if args.noise_um.repeats:
        found.append(Fault("--noise-um", args.noise_um.repeats, "a plan has no readings", "a number of micrometres"))
    found += _of_plan(args) if args.data is not None else _of_first_plan(args)
    return found + (_of_out(args.out, same=same) if args.out is not None else [])


def _of_plan(args: argparse.Namespace) -> list[Fault]:
    found = []
    if args.instruments:
        found.append(Fault("--with", "", "makes a plan from nothing", "--propose-with, or no --data"))
    if args.hours is not None:
        found.append(Fault("--hours", "", "goes with --with, from nothing", "--propose N"))
    if args.propose is None:
        if args.out is not None:
            found.append(Fault("--out", "", "is for proposed runs", "--propose N as well"))
        for option, used in (("--propose-with", args.propose_with), ("--for", args.wanted != VOLUME)):
            if used:
                found.append(Fault(option, "", "is for proposed runs", "--propose N as well"))
    if args.runs and args.out is not None:
        found.append(Fault("--out", "", "goes with all runs", "no --runs"))
    return found


def _of_first_plan(args: argparse.Namespace) -> list[Fault]:
    if not args.instruments:
        return [Fault("--data", "", "is missing", "a folder with a plan, or --with laser ballbar for a first one")]
    found = []
    if args.out is None:
        found.append(Fault("--out", "", "is missing", "the folder that the first plan is written to"))
    for option, used in (
        ("--runs", args.runs),
        ("--propose", args.propose),
        ("--propose-with", args.propose_with),
        ("--location-errors-only", args.location_errors_only),
    ):
        if used:
            found.append(Fault(option, "", "goes with a plan that is there", "--data DIR, or leave it out"))
    return found


def _of_out(out: Path, *, same: bool) -> list[Fault]:
    other = out / readings_files.PARQUET_NAME
    if same:
        return [Fault(str(out), "", "is the folder of the plan itself", "another folder for --out")]
    if other.exists():
        return [Fault(str(other), "", f"would stand beside the new {readings_files.FILE_NAME}", "remove it")]
    return []
