"""What options of `plan` do not go together, and what has replaced options that it had."""

import argparse
from dataclasses import dataclass, field
from typing import Any

from trueaxis.cli.arguments import option as option_of
from trueaxis.io.faults import Fault
from trueaxis.jobs.outputs import overwritten
from trueaxis.jobs.plan_request import PlanRequest, faults_of_request, outputs_of


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


def faults_of_options(args: argparse.Namespace, request: PlanRequest) -> list[Fault]:
    """All of them; nothing is read for it."""
    found = [
        Fault(option, "", f"is no option any more: {one.why}", one.instead)
        for option, one in RETIRED.items()
        if getattr(args, option[2:].replace("-", "_")) is not None
    ]
    inputs = {"MACHINE.toml": args.machine, "--data": args.data, "--known": args.known, "--effects": args.effects}
    outputs = {"--report": args.report, "--picture": args.picture, **outputs_of(request, args.data)}
    found += overwritten(inputs, outputs, args.kernels)
    return found + faults_of_request(request, args.data, option_of, writes=True)
