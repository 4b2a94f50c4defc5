"""`trueaxis derive`: from a machine spec to its kernels and equations."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from trueaxis.cli.paths import named, overwritten
from trueaxis.io.faults import Fault, InputError
from trueaxis.machine import Machine, read_machine
from trueaxis.machine.machine import LINEAR
from trueaxis.machine.topology import format_lower_body_array, tool_senses
from trueaxis.measurement.data import MeasuredData, read_data
from trueaxis.measurement.setup import PointOn
from trueaxis.model.errors import ErrorValues
from trueaxis.model.kernels import numpy_kernels
from trueaxis.model.manifest import KERNEL_FILES
from trueaxis.model.model import MachineModel
from trueaxis.view import Carrier

if TYPE_CHECKING:
    from trueaxis.derivation.systems import RunPattern


def add_parser(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Declare the command."""
    parser = subparsers.add_parser(
        "derive",
        help="derive a machine's model: NumPy and C kernels, readable equations",
        description="Derive the error model of a machine from its spec and write OUT/NAME/: kernels.py, kernels.c, "
        "kernels.h, equations.md, manifest.json.",
        epilog="exit code: 0 written (or up to date), 1 --check found differences, 2 the spec is wrong",
    )
    parser.add_argument("machine", type=Path, metavar="MACHINE.toml", help="the machine spec")
    parser.add_argument(
        "--out", type=Path, default=Path("generated"), help="folder of generated machines (%(default)s)"
    )
    parser.add_argument(
        "--check", action="store_true", help="write nothing; say how OUT differs from what would be written"
    )
    parser.add_argument(
        "--runs",
        type=Path,
        help="folder of measured data or a plan, whose identification systems are derived (default: the spec's `runs`)",
    )
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Derive, then write or compare."""
    # SymPy takes a second to import; only this command needs it.
    from trueaxis.codegen.check import differences, write  # noqa: PLC0415
    from trueaxis.codegen.effect_check import faults_of_kinds  # noqa: PLC0415
    from trueaxis.codegen.meta import spec_label  # noqa: PLC0415
    from trueaxis.codegen.render import render  # noqa: PLC0415
    from trueaxis.derivation.model import derive_model  # noqa: PLC0415

    machine = read_machine(args.machine)
    folder = args.out / machine.name
    inputs = {"MACHINE.toml": args.machine, "--runs": args.runs}
    found = overwritten(inputs, {f"{name} of --out": folder / name for name in KERNEL_FILES})
    if found := [*found, *faults_of_kinds(machine, str(args.machine))]:
        raise InputError(found)
    model = derive_model(machine, identification_runs(machine, args.machine, args.runs))
    files = render(model, spec_label(args.machine, args.out))
    if args.check:
        differing = differences(folder, files)
        for line in differing:
            print(line)
        if differing:
            runs = f" --runs {args.runs}" if args.runs else ""
            print(f"{folder} differs from {args.machine}; run: trueaxis derive {args.machine} --out {args.out}{runs}")
            return 1
        print(f"{folder} is what {args.machine} derives to")
        return 0
    write(folder, files)
    print(
        f"{machine.title}: axes {' '.join(machine.axes)}, {len(machine.components)} motion errors, "
        f"{len(machine.location_errors)} location errors"
    )
    print("lower-body array over the bodies (bed first):")
    sys.stdout.write(format_lower_body_array(machine))
    if model.identification:
        print("identification systems in the order of solution:")
        for number, system in enumerate(model.identification.systems, 1):
            lack = f"   (singular at these points: rank {system.rank})" if system.rank < len(system.unknowns) else ""
            print(f"  {number}. {', '.join(system.runs)} -> {', '.join(system.unknowns)}{lack}")
    for name in files:
        print(f"wrote {named(folder / name)}")
    for line in _sense_sentences(machine, _tool_ranges(machine, files["kernels.py"], folder / "kernels.py")):
        print(line)
    return 0


def _tool_ranges(machine: Machine, kernels: bytes, path: Path) -> dict[str, tuple[float, float]]:
    """Coordinate of the workpiece, mm, from the lowest to the highest position of each linear axis that has a travel:
    of the origin of the tool frame, all other axes where they are nearest to 0, named dimensions 0.
    """
    model = MachineModel(machine, numpy_kernels(kernels, path), ErrorValues(machine.name))
    rest = np.array([float(np.clip(0.0, *machine.travel[axis])) for axis in machine.axes])
    found = {}
    for row, axis in enumerate(machine.axes):
        if axis in LINEAR and machine.mover(axis).travel is not None:
            ends = np.repeat(rest[:, np.newaxis], 2, axis=1)
            ends[row] = machine.travel[axis]
            first, last = model.view_ideal("tool_in_workpiece", ends, np.zeros((3, 1)))[LINEAR.index(axis)]
            found[axis] = (float(first), float(last))
    return found


def _sense_sentences(machine: Machine, ranges: dict[str, tuple[float, float]]) -> list[str]:
    """Where positive commands move the tool: an axis that counts the other way on the machine is a slip in the spec.

    ranges: from where to where on the workpiece, mm.
    """
    lines = []
    for axis, sense in tool_senses(machine).items():
        start, end = ranges.get(axis, (0.0, 0.0))
        there = f" of the workpiece, from {start:g} to {end:g} mm there" if axis in ranges else " of the workpiece"
        if sense > 0:
            lines.append(f"{axis}+ commands move the tool to {axis}+{there}")
        elif sense < 0:
            body = machine.mover(axis)
            moves = f"{axis}{'+' if body.sense > 0 else '-'}"
            change = "`sense = -1`" if body.sense > 0 else "no `sense = -1`"
            lines.append(
                f"{axis}+ commands move the tool to {axis}-{there}: {body.name} moves to {moves} "
                f"({change} where the control counts the other way)"
            )
        else:
            lines.append(f"{axis} commands move the tool and the workpiece together")
    if ranges:
        zero = "; named dimensions taken for 0" if machine.dimensions else ""
        lines.append(f"(the origin of the tool frame, other axes at 0 or as near to it as they go{zero})")
    return lines


def identification_runs(machine: Machine, spec: Path, given: Path | None = None) -> "tuple[RunPattern, ...]":
    """The runs of the folder given, else of the one that the spec names, whose identification systems are derived.

    Raises InputError where it is not there or its files are wrong.
    """
    folder = given or (spec.parent / machine.runs if machine.runs else None)
    if folder is None:
        return ()
    if not folder.is_dir():
        key = "--runs" if given else "key runs"
        raise InputError(
            [Fault(str(spec), key, f"there is no folder {folder}", "a folder with setup.toml and readings.csv")]
        )
    return run_patterns(machine, read_data(folder, machine))


def run_patterns(machine: Machine, data: MeasuredData) -> "tuple[RunPattern, ...]":
    """The laser and probe runs of a data set, as patterns: which axes move is seen from the readings."""
    from trueaxis.derivation.systems import RunPattern  # noqa: PLC0415  as in run

    patterns: list[RunPattern] = []
    for index, each in enumerate(data.setup.runs):
        if each.direction is None:
            continue  # a ball bar's reading is no linear form of the position
        rows = data.readings.of_run(index)
        positions = data.readings.positions[:, rows]
        moves = tuple(axis for axis, row in zip(machine.axes, positions, strict=True) if (row != each.home[axis]).any())
        patterns.append(RunPattern(each.id, moves, each.direction, each.frame, _end(each.target), _end(each.reference)))
    return tuple(patterns)


def _end(end: PointOn) -> tuple[Carrier, tuple[float, float, float]]:
    return end.on, end.point
