"""`trueaxis derive`: from a machine spec to its kernels and equations."""

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path

from trueaxis.io.faults import InputError
from trueaxis.io.input_files import gathering
from trueaxis.jobs.derive import check_kinds, derive, faults_of_folder
from trueaxis.jobs.outputs import named, overwritten
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.machine import LINEAR
from trueaxis.machine.topology import format_lower_body_array, tool_senses
from trueaxis.model.manifest import KERNEL_FILES

# A positive turn about X, Y, Z takes the first of these to the second.
TURNS = {"A": ("Y", "Z"), "B": ("Z", "X"), "C": ("X", "Y")}


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "derive",
        help="derive a machine's model: NumPy and C kernels, readable equations",
        description="Derive the error model of a machine from its spec and write OUT/NAME/: kernels.py, kernels.c, "
        "kernels.h, equations.md, manifest.json; for a machine with three linear axes control.c and control.h as well.",
        epilog="exit code: 0 written (or up to date), 1 --check found differences, 2 the spec is wrong",
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument(
        "--out", type=Path, default=Path("generated"), help="folder of generated machines (%(default)s)"
    )
    parser.add_argument(
        "--check", action="store_true", help="write nothing; list the differences of OUT from what would be written"
    )
    parser.add_argument(
        "--runs",
        type=Path,
        help="folder of measured data or a plan, whose identification systems are derived (default: the spec's `runs`)",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Derive, then write or compare."""
    machine = read_machine(args.machine)
    inputs = {"MACHINE.toml": args.machine, "--runs": args.runs}
    outputs = {f"{name} of --out": args.out / machine.name / name for name in KERNEL_FILES}
    found = overwritten(inputs, outputs)
    if not args.check:
        found += faults_of_folder(machine, args.machine, args.out)
    with gathering(found):
        check_kinds(machine, args.machine)
    if found:
        raise InputError(found)
    done = derive(args.machine, args.out, runs=args.runs, check=args.check)
    if args.check:
        for line in done.differences:
            print(line)
        if done.differences:
            runs = f" --runs {args.runs}" if args.runs else ""
            print(
                f"{done.folder} differs from {args.machine}; run: trueaxis derive {args.machine} --out {args.out}{runs}"
            )
            return 1
        print(f"{done.folder} is what {args.machine} derives to")
        return 0
    print(
        f"{machine.title}: axes {' '.join(machine.axes)}, {len(machine.components)} error motions, "
        f"{len(machine.location_errors)} location errors"
    )
    print("lower-body array over the bodies (bed first):")
    sys.stdout.write(format_lower_body_array(machine))
    if done.systems:
        print("identification systems in the order of solution:")
        for number, system in enumerate(done.systems, 1):
            lack = f"   (singular at these points: rank {system.rank})" if system.rank < len(system.unknowns) else ""
            print(f"  {number}. {', '.join(system.runs)} -> {', '.join(system.unknowns)}{lack}")
    for file in done.files:
        print(f"wrote {named(file)}")
    for line in _sense_sentences(machine, done.tool_ranges):
        print(line)
    return 0


def _sense_sentences(machine: Machine, ranges: Mapping[str, tuple[float, float]]) -> list[str]:
    """Where positive commands move the tool: an axis that counts the other way on the machine is a slip in the spec.

    ranges: from where to where on the workpiece, mm.
    """
    lines = []
    for axis, sense in tool_senses(machine).items():
        if sense == 0:
            lines.append(f"{axis} commands move the tool and the workpiece together")
            continue
        verb, plus, minus = _ways(axis)
        there = " of the workpiece"
        if axis in ranges:
            there += ", from {:g} to {:g} mm there".format(*ranges[axis])
        if sense > 0:
            lines.append(f"{axis}+ commands {verb} the tool {plus}{there}")
        else:
            body = machine.mover(axis)
            way = plus if body.sense > 0 else minus
            change = "`sense = -1`" if body.sense > 0 else "no `sense = -1`"
            lines.append(
                f"{axis}+ commands {verb} the tool {minus}{there}: {body.name} {verb}s {way} "
                f"({change} where the control counts the other way)"
            )
    if ranges:
        zero = "; named dimensions taken for 0" if machine.dimensions else ""
        lines.append(f"(the origin of the tool frame, other axes at 0 or as near to it as they go{zero})")
    return lines


def _ways(axis: str) -> tuple[str, str, str]:
    """What commands of an axis do, and in words its positive and its negative way, right-handed."""
    if axis in LINEAR:
        return "move", f"to {axis}+", f"to {axis}-"
    first, second = TURNS[axis]
    return "turn", f"from {first}+ to {second}+", f"from {second}+ to {first}+"
