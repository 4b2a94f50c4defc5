"""The NumPy kernels: one function per routine, in blocks of points that stay in cache.

Their record META is a Python literal that a person reads: what fits a line stands on one.
"""

import textwrap
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from trueaxis.codegen.meta import ABI, meta, spec_name
from trueaxis.codegen.paper_layout import TITLE
from trueaxis.codegen.printers import PythonPrinter, rows_text, variable_names
from trueaxis.codegen.templates import environment
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.derivation.sharing import Assignment
from trueaxis.machine.machine import ROTARY, Machine

# Points per block: the intermediate rows of a block stay in the processor's second-level cache.
BLOCK = 8192
_TAKEN = frozenset(("np", "at", "start", "stop", "block", "n"))  # what the functions use beside their arguments
_WIDTH = 118
_STEP = 4


@dataclass(frozen=True, kw_only=True)
class FunctionText:
    """What the template prints of one routine."""

    name: str
    arguments: tuple[str, ...]
    doc: tuple[str, ...]
    per_point: tuple[tuple[str, int], ...]
    fixed: tuple[tuple[str, tuple[int, ...]], ...]
    outputs: tuple[tuple[str, int], ...]
    returns: str
    constants: tuple[str, ...]
    batch: tuple[str, ...]
    rows: tuple[str, ...]
    preparation: tuple[str, ...]
    body: tuple[str, ...]


def numpy_source(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> str:
    """The text of kernels.py; spec: how it is named there."""
    spec = spec or spec_name(machine)
    return module_source(
        routines,
        meta(machine, routines),
        digest=machine.digest,
        spec=spec,
        command=f"trueaxis derive {spec}",
        title=machine.title,
        turning=any(axis in ROTARY for axis in machine.axes),
    )


def module_source(routines: tuple[Routine, ...], record: dict[str, Any], **texts: object) -> str:
    """The text of a module of kernels; record: its META; texts: further variables of the template."""
    return (
        environment()
        .get_template("kernels.py.j2")
        .render(
            texts,
            abi=ABI,
            paper_title=TITLE,
            meta=literal(record),
            block=BLOCK,
            functions=[_function(routine) for routine in routines],
        )
    )


def shape_text(argument: Argument) -> str:
    """`(3, n)`, `(18, 7)`, `(9,)`."""
    sizes = [str(size) for size in argument.shape] + (["n"] if argument.per_point else [])
    return f"({', '.join(sizes)}{',' if len(sizes) == 1 else ''})"


def _function(routine: Routine) -> FunctionText:
    names = variable_names(routine, _TAKEN)
    printer = PythonPrinter(names)
    used = {s.name for _, value in routine.batch + routine.preparation + routine.body for s in value.free_symbols}
    constants = [a for a in routine.inputs if not a.per_point]
    varying = [a for a in routine.inputs if a.per_point]
    places = {row: f"{a.name}[{k}, at]" for a in routine.outputs for k, row in enumerate(a.rows)}
    return FunctionText(
        name=routine.name,
        arguments=tuple(a.name for a in routine.inputs),
        doc=tuple(_doc(routine)),
        per_point=tuple((a.name, len(a.rows)) for a in varying),
        fixed=tuple((a.name, a.shape) for a in constants),
        outputs=tuple((a.name, len(a.rows)) for a in routine.outputs),
        returns=", ".join(_returned(a) for a in routine.outputs),
        constants=tuple(
            f"{names[row]} = float({a.name}[{', '.join(str(i) for i in _unravel(a, k))}])"
            for a in constants
            for k, row in enumerate(a.rows)
            if row in used
        ),
        batch=tuple(_line(assignment, printer) for assignment in routine.batch),
        rows=tuple(f"{names[row]} = {a.name}[{k}, at]" for a in varying for k, row in enumerate(a.rows) if row in used),
        preparation=tuple(_line(assignment, printer) for assignment in routine.preparation),
        body=tuple(
            _stored(assignment, places, used, printer)
            for assignment in routine.body
            if not _is_zero_output(assignment, places)
        ),
    )


def _doc(routine: Routine) -> list[str]:
    lines = [routine.summary, "", f"Source: {routine.source}. Operations: {routine.operations} per point"]
    lines[-1] += f", {routine.batch_operations} per call." if routine.batch_operations else "."
    lines += ["", "Arguments (float64):"]
    for arguments in (routine.inputs, routine.outputs):
        if arguments is routine.outputs:
            lines += ["", "Returns:"]
        for a in arguments:
            lines.append(f"    {a.name} {shape_text(a)}: {a.description} [{a.unit}]")
            rows = f"rows: {rows_text(a)}"
            lines += textwrap.wrap(
                rows, 108, initial_indent=" " * 8, subsequent_indent=" " * 12, break_on_hyphens=False
            )
    return lines


def _line(assignment: Assignment, printer: PythonPrinter) -> str:
    target, value = assignment
    return f"{printer.code(target)} = {printer.code(value)}"


def _stored(assignment: Assignment, places: dict[str, str], used: set[str], printer: PythonPrinter) -> str:
    target, value = assignment
    if target.name not in places:
        return _line(assignment, printer)
    kept = f"{printer.code(target)} = " if target.name in used else ""
    return f"{places[target.name]} = {kept}{printer.code(value)}"


def _is_zero_output(assignment: Assignment, places: dict[str, str]) -> bool:
    return assignment[0].name in places and assignment[1] == 0


def _unravel(argument: Argument, row: int) -> tuple[int, ...]:
    index: list[int] = []
    for size in reversed(argument.shape):
        index.insert(0, row % size)
        row //= size
    return tuple(index)


def _returned(argument: Argument) -> str:
    if len(argument.shape) == 1:
        return argument.name
    return f"{argument.name}.reshape({', '.join(str(size) for size in argument.shape)}, n)"


def literal(value: object, indent: int = 0, before: int = 0) -> str:
    """The literal of dicts, lists and scalars; before: columns taken on its first line by what leads to it."""
    flat = repr(value)
    if not isinstance(value, dict | list) or not value or max(indent, before) + len(flat) < _WIDTH:
        return flat
    pad = " " * (indent + _STEP)
    ends = "{}" if isinstance(value, dict) else "[]"
    if isinstance(value, list) and not any(isinstance(item, dict | list) for item in value):
        body = list(_filled(value, _WIDTH - len(pad)))
    else:
        items = value.items() if isinstance(value, dict) else (("", item) for item in value)
        body = [_entry(key, item, indent + _STEP) for key, item in items]
    inner = "\n".join(f"{pad}{line}" for line in body)
    return f"{ends[0]}\n{inner}\n{' ' * indent}{ends[1]}"


def _entry(key: object, item: object, indent: int) -> str:
    head = f"{key!r}: " if key else ""
    return f"{head}{literal(item, indent, indent + len(head) + 1)},"


def _filled(items: list[object], width: int) -> Iterator[str]:
    """As many items to a line as fit."""
    lines = [""]
    for item in items:
        text = f"{item!r},"
        if lines[-1] and len(lines[-1]) + 1 + len(text) > width:
            lines.append("")
        lines[-1] += f" {text}" if lines[-1] else text
    yield from lines
