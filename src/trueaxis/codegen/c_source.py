"""The C kernels: one function per routine, whose loop over the points a compiler vectorises; and those of a control.

For the cycle of a control they take one point a call, and give the kinematics of the machine as it is.
"""

import textwrap
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from trueaxis.c_prefix import c_prefix
from trueaxis.codegen.meta import ABI, spec_name
from trueaxis.codegen.paper_layout import TITLE
from trueaxis.codegen.printers import CPrinter, rows_text, variable_names
from trueaxis.codegen.templates import environment
from trueaxis.derivation.effect_terms import Sign, Step
from trueaxis.derivation.expressions import called
from trueaxis.derivation.routine import Argument, Routine
from trueaxis.derivation.sharing import Assignment
from trueaxis.derivation.symbols import describe
from trueaxis.machine.machine import LINEAR, ROTARY, Machine

# Points per block where cosines and sines are computed ahead of the arithmetic: they stay in the first-level cache.
BLOCK = 512
_WIDTH = 116

# What the functions use beside the arguments' names; the macros of stddef.h and math.h that a name may not be.
_TAKEN = frozenset(
    "n stride start count i j block size_t ptrdiff_t wchar_t max_align_t cos sin sqrt exp tanh fabs step sign".split()
) | frozenset(
    "NULL NAN INFINITY HUGE_VAL HUGE_VALF HUGE_VALL MATH_ERRNO MATH_ERREXCEPT math_errhandling offsetof".split()
)
_HELPERS = {"sign": Sign, "step": Step}
_DEVIATION, _CORRECTION = "tool_in_workpiece_deviation", "correction"


@dataclass(frozen=True)
class Layout:
    """How arrays with a value per point lie: sizes: first arguments; star: of a pointer; rows: how many there are, in
    words; index: of a row.
    """

    sizes: tuple[str, ...]
    star: str
    rows: str
    index: str


OF_POINTS = Layout(("size_t n, size_t stride",), "*TRUEAXIS_RESTRICT ", "{} rows of stride", "[{} * stride + i]")
OF_ONE_POINT = Layout((), "*", "{} values", "[{}]")


@dataclass(frozen=True)
class TrigonometryText:
    """A cosine or sine of one point, kept in an array of one block."""

    name: str
    array: str
    value: str


@dataclass(frozen=True)
class Declaration:
    """What the header prints of one routine."""

    name: str
    comment: tuple[str, ...]
    signature: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class FunctionText(Declaration):
    """What the source prints of one routine; calls: whether its body calls functions, which is not vectorised.

    zeros: outputs and their numbers of rows where all are zero whatever is given, such as the sensitivity of a chain
    without axes: written row by row, since of a loop that writes 132 rows at once gcc takes half a minute.
    """

    unused: tuple[str, ...]
    constants: tuple[str, ...]
    batch: tuple[str, ...]
    positions: tuple[str, ...]
    preparation: tuple[TrigonometryText, ...]
    calls: bool
    rows: tuple[str, ...]
    body: tuple[str, ...]
    stores: tuple[str, ...]
    zeros: tuple[tuple[str, int], ...]


def c_source(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> str:
    """The text of kernels.c; spec: how it is named there. Same input, same bytes."""
    return environment().get_template("kernels.c.j2").render(source_context(machine, routines, spec))


def c_header(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> str:
    """The text of kernels.h; spec: how it is named there."""
    return environment().get_template("kernels.h.j2").render(header_context(machine, routines, spec))


def source_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of kernels.c.j2."""
    functions = [function_text(c_prefix(machine.name), routine) for routine in routines]
    return shared_context(machine, spec) | {"functions": functions, "block": BLOCK, "helpers": helpers(routines)}


def helpers(routines: Iterable[Routine]) -> list[str]:
    """The functions of C that the routines call and C has not."""
    used = {function for routine in routines for _, value in routine.batch + routine.body for function in called(value)}
    return [name for name, function in _HELPERS.items() if function in used]


def header_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of kernels.h.j2."""
    prefix = c_prefix(machine.name)
    functions = [declaration(prefix, routine) for routine in routines]
    return shared_context(machine, spec) | {"functions": functions, "abi": ABI, "legend": legend(machine)}


def shared_context(machine: Machine, spec: str) -> dict[str, Any]:
    """The variables that every template of C has."""
    return {
        "paper_title": TITLE,
        "turning": any(axis in ROTARY for axis in machine.axes),
        "digest": machine.digest,
        "prefix": c_prefix(machine.name),
        "spec": spec or spec_name(machine),
        "title": _commentable(machine.title),
    }


def legend(machine: Machine) -> list[str]:
    """Rows and units of the arrays that the functions share, in lines of a comment."""
    texts = describe(machine)
    shared = {
        "positions": [axis.lower() for axis in machine.axes],
        "errors": machine.components,
        "parameters": machine.parameters,
    }
    lines = [
        f"{name}: {', '.join(f'{row} {texts[row].unit}' for row in rows) or 'none'}" for name, rows in shared.items()
    ]
    return [part for line in lines for part in textwrap.wrap(_commentable(line), _WIDTH, subsequent_indent="    ")]


def declaration(prefix: str, routine: Routine, layout: Layout = OF_POINTS) -> Declaration:
    """A routine as the header prints it."""
    return Declaration(f"{prefix}_{routine.name}", tuple(_comment(routine, layout)), tuple(_signature(routine, layout)))


def function_text(prefix: str, routine: Routine, layout: Layout = OF_POINTS) -> FunctionText:
    """A routine as the source prints it."""
    names = variable_names(routine, _TAKEN | {f"{target.name}_block" for target, _ in routine.preparation})
    printer = CPrinter(names)
    varying = [a for a in routine.inputs if a.per_point]
    body = _used(routine.body)
    batch = _used(routine.batch)
    used = body | batch | _used(routine.preparation)
    constants = [
        _declared(names[row], f"{a.name}[{k}]")
        for a in routine.inputs
        if not a.per_point
        for k, row in enumerate(a.rows)
        if row in body | batch
    ]
    outputs = [(row, f"{a.name}{layout.index.format(k)}") for a in routine.outputs for k, row in enumerate(a.rows)]
    stored = dict(outputs)
    direct = {target.name: value for target, value in routine.body if target.name in stored and target.name not in body}
    head = declaration(prefix, routine, layout)
    return FunctionText(
        name=head.name,
        comment=head.comment,
        signature=head.signature,
        unused=tuple(a.name for a in routine.inputs if used.isdisjoint(a.rows)),
        constants=tuple(constants),
        batch=tuple(_assigned(assignment, printer) for assignment in routine.batch),
        positions=tuple(_loads(varying, _used(routine.preparation), names, layout)),
        preparation=tuple(
            TrigonometryText(names[target.name], f"{names[target.name]}_block", printer.doprint(value))
            for target, value in routine.preparation
        ),
        calls=any(called(value) for _, value in routine.body),
        rows=tuple(_loads(varying, body, names, layout)),
        body=tuple(_assigned(assignment, printer) for assignment in routine.body if assignment[0].name not in direct),
        stores=tuple(
            _wrapped(f"{place} = {printer.doprint(direct[row]) if row in direct else names[row]};")
            for row, place in outputs
        ),
        zeros=tuple((a.name, len(a.rows)) for a in routine.outputs)
        if all(direct.get(row) == 0 for row in stored)
        else (),
    )


def _used(assignments: Iterable[Assignment]) -> set[str]:
    return {symbol.name for _, value in assignments for symbol in value.free_symbols}


def _loads(arguments: Iterable[Argument], used: set[str], names: Mapping[str, str], layout: Layout) -> Iterable[str]:
    for argument in arguments:
        for k, row in enumerate(argument.rows):
            if row in used:
                yield _declared(names[row], f"{argument.name}{layout.index.format(k)}")


def _declared(name: str, value: str) -> str:
    return _wrapped(f"const double {name} = {value};")


def _assigned(assignment: Assignment, printer: CPrinter) -> str:
    target, value = assignment
    return _declared(printer.doprint(target), printer.doprint(value))


def _wrapped(line: str) -> str:
    """Broken where it is too long; the template indents what follows a line's end."""
    if len(line) <= _WIDTH - 8:
        return line
    return "\n".join(
        textwrap.wrap(line, _WIDTH - 8, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False)
    )


def _signature(routine: Routine, layout: Layout) -> list[str]:
    arrays = [f"const double {layout.star}{a.name}" for a in routine.inputs]
    arrays += [f"double {layout.star}{a.name}" for a in routine.outputs]
    return [*layout.sizes, *arrays]


def _comment(routine: Routine, layout: Layout) -> Iterable[str]:
    yield from textwrap.wrap(_commentable(routine.summary), _WIDTH)
    operations = f"Operations: {routine.operations} per point"
    operations += f", {routine.batch_operations} once per call." if routine.batch_operations else "."
    yield _commentable(f"Source: {routine.source}. {operations}")
    for title, arguments in (("in", routine.inputs), ("out", routine.outputs)):
        for a in arguments:
            size = (layout.rows if a.per_point else OF_ONE_POINT.rows).format(len(a.rows))
            text = f"{title} {a.name}: {size}, {a.unit}; {a.description} ({rows_text(a)})"
            yield from textwrap.wrap(_commentable(text), _WIDTH, subsequent_indent="    ", break_on_hyphens=False)


def _commentable(text: str) -> str:
    """Text that ends no comment and starts none."""
    return " ".join(text.replace("*/", "* /").replace("/*", "/ *").split())


def control_sources(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, str]:
    """control.c and control.h by name; none of a machine without three linear axes, whose tool cannot be moved freely.

    spec: how it is named there. Same input, same bytes.
    """
    if _CORRECTION not in {routine.name for routine in routines}:
        return {}
    contexts = {
        "control.c": control_context(machine, routines, spec),
        "control.h": control_header_context(machine, routines, spec),
    }
    return {name: environment().get_template(f"{name}.j2").render(context) for name, context in contexts.items()}


def control_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of control.c.j2."""
    chosen = _of_one_point(machine, routines)
    return _shared(machine, spec) | {
        "functions": [function_text(_prefix(machine), routine, OF_ONE_POINT) for routine in chosen],
        "helpers": helpers(chosen),
        "linear": [machine.axes.index(axis) for axis in machine.axes if axis in LINEAR],
    }


def control_header_context(machine: Machine, routines: tuple[Routine, ...], spec: str = "") -> dict[str, Any]:
    """The variables of control.h.j2."""
    chosen = _of_one_point(machine, routines)
    return _shared(machine, spec) | {
        "functions": [declaration(_prefix(machine), routine, OF_ONE_POINT) for routine in chosen],
        "legend": legend(machine),
    }


def _shared(machine: Machine, spec: str) -> dict[str, Any]:
    return shared_context(machine, spec) | {"axes": len(machine.axes), "components": len(machine.components)}


def _prefix(machine: Machine) -> str:
    return f"{c_prefix(machine.name)}_point"


def _of_one_point(machine: Machine, routines: tuple[Routine, ...]) -> list[Routine]:
    """The exact deviation, the moves that take it back, and the terms of effects on component errors."""
    effects = {f"effect_{name}" for name, kind in machine.kinds.items() if kind.place == "component"}
    return [routine for routine in routines if routine.name in {_DEVIATION, _CORRECTION} | effects]
