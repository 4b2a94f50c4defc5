"""trueaxis init: the spec of a new machine, and error values that are all zero."""

import argparse
import re
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from trueaxis.cli.arguments import file_to_write
from trueaxis.cli.paths import named
from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.files import write_files
from trueaxis.io.plain_text import shown
from trueaxis.machine.machine import AXES, LINEAR
from trueaxis.machine.new_spec import new_spec
from trueaxis.machine.read import parse_machine
from trueaxis.machine.structure_code import AxisOrder, StructureCodeError, parse_structure
from trueaxis.model.errors import ErrorValues, dump_errors

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]

STEM = r"[A-Za-z][A-Za-z0-9_-]{0,99}"
DESCRIPTION = """\
Write the spec of a new machine with all error components and the usual location errors, and NAME_errors.json, error
values that are all zero. What the structure code does not say (where rotary axes lie, which way commands count) is in
the spec as comments. docs/machine.md has every key."""


def add_parser(subparsers: "Subparsers") -> None:
    """Add this command to the command line."""
    parser = subparsers.add_parser("init", help="the spec of a new machine, with zero errors", description=DESCRIPTION)
    parser.add_argument("spec", type=file_to_write, metavar="NAME.toml", help="the spec, to be written; no old file")
    parser.add_argument(
        "--structure", required=True, metavar="CODE",
        help='order of the axes, such as "[w C\' Y\' b X Z t]" (ISO 10791-6), YFXZ or XZ+YC',
    )  # fmt: skip
    parser.add_argument(
        "--travel", type=_travel, action="extend", nargs="+", default=[], metavar="AXIS=LOW:HIGH",
        help="ends of the travel of each linear axis, mm, and of rotary axes, deg (-360:360): X=0:600 Z=-150:0",
    )  # fmt: skip
    parser.add_argument(
        "--sense", type=_sense, action="extend", nargs="+", default=[], metavar="AXIS=-1",
        help="axes whose positive commands move their slide in the negative direction",
    )  # fmt: skip
    parser.set_defaults(run=run)


def run(args: argparse.Namespace) -> int:
    """Write both files; raises InputError with every fault."""
    errors = args.spec.with_name(f"{args.spec.stem}_errors.json")
    found = _faults_of_name(args.spec)
    order = AxisOrder((), ())
    try:
        order = parse_structure(args.structure)
    except StructureCodeError as problem:
        remedy = "such as [w C' Y' b X Z B t], YFXZ or XZB+YC"
        found.append(Fault("--structure", shown(args.structure), f"cannot be read: {problem}", remedy))
    else:
        found += _faults_of_axes(order, [axis for axis, _ in args.travel], [axis for axis, _ in args.sense])
    if found:
        raise InputError(found)
    text = new_spec(args.spec.stem, args.structure, order, dict(args.travel), dict(args.sense))
    machine = parse_machine(text, Faults(str(args.spec)))
    values = dump_errors(
        ErrorValues(machine.name), components=machine.components, parameters=machine.parameters, effects=()
    )
    contents = {args.spec: text, errors: values}
    if found := [fault for path, content in contents.items() for fault in _faults_of_place(path, content)]:
        raise InputError(found)
    write_files(contents)
    print(f"{machine.name}: axes {' '.join(machine.axes)}, {len(machine.components)} error components, location errors")
    print(f"  {' '.join(machine.location_errors) or 'none'}")
    print(f"written: {named(args.spec)}, {named(errors)}; next: trueaxis derive {named(args.spec)}")
    return 0


def _faults_of_name(spec: Path) -> list[Fault]:
    if spec.suffix == ".toml" and re.fullmatch(STEM, spec.stem):
        return []
    right = "a letter, then letters, digits, _ and -, 100 at most, and .toml"
    return [Fault(str(spec), "", "is no name of a spec: the machine is named like its file", right)]


def _faults_of_place(path: Path, content: str) -> list[Fault]:
    """What is there already is the user's own work, unless it is the same."""
    if not path.exists() or (path.is_file() and path.read_bytes() == content.encode()):
        return []
    return [Fault(str(path), "", "is there already, and is something else", "another name, or remove it")]


def _faults_of_axes(order: AxisOrder, travels: Sequence[str], senses: Sequence[str]) -> list[Fault]:
    axes = order.workpiece + order.tool
    found = []
    for option, named_axes in (("--travel", travels), ("--sense", senses)):
        for axis in dict.fromkeys(named_axes):
            if axis not in axes:
                found.append(Fault(option, axis, "is no axis of the structure", f"axes {' '.join(sorted(axes))}"))
            elif named_axes.count(axis) > 1:
                found.append(Fault(option, axis, "is given more than once", "once for each axis"))
    found += [
        Fault("--travel", axis, "is missing", f"{axis}=LOW:HIGH, mm")
        for axis in LINEAR
        if axis in axes and axis not in travels
    ]
    return found


def _travel(text: str) -> tuple[str, tuple[float, float]]:
    axis, equals, ends = text.partition("=")
    low, colon, high = ends.partition(":")
    try:
        travel = float(low), float(high)
    except ValueError:
        travel = float("nan"), float("nan")
    if axis not in AXES or not equals or not colon or not travel[0] < travel[1]:
        raise argparse.ArgumentTypeError(f"{text!r} is not AXIS=LOW:HIGH, such as X=0:600 (mm, rotary axes deg)")
    return axis, travel


def _sense(text: str) -> tuple[str, int]:
    axis, _, sense = text.partition("=")
    if axis not in AXES or sense not in ("1", "+1", "-1"):
        raise argparse.ArgumentTypeError(f"{text!r} is not AXIS=-1 or AXIS=1")
    return axis, int(sense)
