"""The spec of a new machine, and error values that are all zero."""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from trueaxis.io.faults import Fault, Faults, InputError
from trueaxis.io.files import write_files
from trueaxis.io.safe_text import shown
from trueaxis.jobs.given import Spelled, argument
from trueaxis.jobs.outputs import named
from trueaxis.jobs.typed import AnyPath, typed
from trueaxis.machine.machine import LINEAR, Machine
from trueaxis.machine.read import parse_machine
from trueaxis.machine.structure_code import AxisOrder, StructureCodeError, new_spec, parse_structure
from trueaxis.model.errors import ErrorValues, dump_errors

STEM = r"[A-Za-z][A-Za-z0-9_-]{0,99}"
Travel = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class NewMachine:
    """machine: as the new spec tells it; files: the spec, and the error values, all zero. Printed, it is what
    `trueaxis init` says.
    """

    machine: Machine
    files: tuple[Path, Path]

    def __str__(self) -> str:
        machine, (spec, errors) = self.machine, self.files
        return (
            f"{machine.name}: axes {' '.join(machine.axes)}, {len(machine.components)} error components, location "
            f"errors\n  {' '.join(machine.location_errors) or 'none'}\n"
            f"written: {named(spec)}, {named(errors)}; next: trueaxis derive {named(spec)}\n"
        )

    def _repr_html_(self) -> str:
        return self.machine._repr_html_()


@typed
def init(
    spec: AnyPath, structure: str, travel: Mapping[str, Travel], *, sense: Mapping[str, int] | None = None
) -> NewMachine:
    """Write the spec of a new machine, with all error components and the usual location errors, and beside it
    NAME_errors.json, error values that are all zero.

    spec: NAME.toml, the name is that of the machine; structure: the order of the axes, such as "[w C' Y' b X Z t]" (ISO
    10791-6); travel: lowest and highest position by axis, mm, of rotary axes deg (-360 to 360); sense: -1 for axes
    whose positive commands move their slide in the negative direction. Raises InputError with every fault: a file that
    is there already, axes that the structure does not have. Raises ValueError for values of another form.
    """
    for axis, ends in travel.items():
        low, high = ends if len(ends) == 2 else (math.nan, math.nan)
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            raise ValueError(f"travel[{axis!r}]: expected (lowest, highest), mm or deg; given {ends}")
    for axis, sign in (sense or {}).items():
        if sign not in (1, -1):
            raise ValueError(f"sense[{axis!r}]: expected 1 or -1; given {sign}")
    return new_machine(Path(spec), structure, tuple(travel.items()), tuple((sense or {}).items()))


def new_machine(
    spec: Path,
    structure: str,
    travels: Sequence[tuple[str, Travel]],
    senses: Sequence[tuple[str, int]],
    spelled: Spelled = argument,
) -> NewMachine:
    """As `init`, with pairs of axes and values."""
    errors = spec.with_name(f"{spec.stem}_errors.json")
    found = _faults_of_name(spec)
    order = AxisOrder((), ())
    try:
        order = parse_structure(structure)
    except StructureCodeError as problem:
        remedy = "such as [w C' Y' b X Z B t], YFXZ or XZB+YC"
        found.append(Fault(spelled("structure"), shown(structure), f"cannot be read: {problem}", remedy))
    else:
        found += _faults_of_axes(order, [axis for axis, _ in travels], [axis for axis, _ in senses], spelled)
    if found:
        raise InputError(found)
    text = new_spec(spec.stem, structure, order, dict(travels), dict(senses))
    machine = parse_machine(text, Faults(str(spec)))
    values = dump_errors(
        ErrorValues(machine=machine.name), components=machine.components, parameters=machine.parameters, effects=()
    )
    contents = {spec: text, errors: values}
    if found := [fault for path, content in contents.items() for fault in _faults_of_place(path, content)]:
        raise InputError(found)
    write_files(contents)
    return NewMachine(machine=machine, files=(spec, errors))


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


def _faults_of_axes(order: AxisOrder, travels: Sequence[str], senses: Sequence[str], spelled: Spelled) -> list[Fault]:
    axes = order.workpiece + order.tool
    found = []
    for option, named_axes in ((spelled("travel"), travels), (spelled("sense"), senses)):
        for axis in dict.fromkeys(named_axes):
            if axis not in axes:
                found.append(Fault(option, axis, "is no axis of the structure", f"axes {' '.join(sorted(axes))}"))
            elif named_axes.count(axis) > 1:
                found.append(Fault(option, axis, "is given more than once", "once for each axis"))
    found += [
        Fault(spelled("travel"), axis, "is missing", f"{axis}=LOW:HIGH, mm")
        for axis in LINEAR
        if axis in axes and axis not in travels
    ]
    return found
