"""A routine: named inputs and outputs and the assignments between them, in three stages.

The arguments that routines of a machine share say what each is, its rows, shape and unit.

`batch` is computed once per call (it depends on constants alone), `preparation` once per point and holds the cosines
and sines of rotary axes, `body` once per point and is plain arithmetic, but for the terms of effects, which call
functions. Both emitters and the documents print this record.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import count

import sympy as sp

from trueaxis.derivation import symbols
from trueaxis.derivation.chain import Vector
from trueaxis.derivation.expressions import operations, renamed
from trueaxis.derivation.sharing import Assignment, shared
from trueaxis.machine.machine import ROTARY, Machine

_RADIAN_PER_DEGREE = sp.Float(math.radians(1.0), 17)  # the very double that both emitters print
_XYZ = ("x", "y", "z")


@dataclass(frozen=True, kw_only=True)
class Argument:
    """An array of a routine: `shape` without the point index; `rows` names its entries in C order.

    per_point: whether each point has its own values (then the point index comes last).
    """

    name: str
    rows: tuple[str, ...]
    shape: tuple[int, ...]
    per_point: bool
    unit: str
    description: str


@dataclass(frozen=True, kw_only=True)
class Routine:
    """See the module. `operations` counts additions, multiplications, divisions and roots per point."""

    name: str
    summary: str
    source: str
    inputs: tuple[Argument, ...]
    outputs: tuple[Argument, ...]
    batch: tuple[Assignment, ...]
    preparation: tuple[Assignment, ...]
    body: tuple[Assignment, ...]
    operations: int
    batch_operations: int


class Binder:
    """Gives names to intermediate results, so that expressions stay as short as they were derived."""

    def __init__(self, prefix: str = "_bound") -> None:
        """prefix: of the names; two binders whose assignments meet in one routine need two."""
        self.assignments: list[Assignment] = []
        self._prefix = prefix

    def bind(self, value: sp.Expr) -> sp.Expr:
        """The value itself where it is a number or a symbol, else a new symbol that stands for it."""
        value = sp.sympify(value)
        negative = value.is_Mul and len(value.args) == 2 and value.args[0] is sp.S.NegativeOne
        if value.is_Atom or (negative and value.args[1].is_Atom):
            return value
        name = symbols.named(f"{self._prefix}{len(self.assignments)}")
        self.assignments.append((name, value))
        return name

    def bind_all(self, values: Iterable[sp.Expr]) -> tuple[sp.Expr, ...]:
        """Each value bound."""
        return tuple(self.bind(value) for value in values)


def build(
    name: str,
    summary: str,
    source: str,
    inputs: Sequence[Argument],
    outputs: Sequence[Argument],
    results: Mapping[str, sp.Expr],
    bound: Sequence[Assignment] = (),
) -> Routine:
    """Share common subexpressions, drop what is not needed, order, and sort the assignments into their stages.

    results: the value of every row of every output. bound: assignments that the results refer to.
    """
    targets = [target for target, _ in bound] + [symbols.named(row) for row in results]
    values = [value for _, value in bound] + list(results.values())
    common, values = shared(values, (symbols.named(f"_shared{k}") for k in count()))
    needed = {row for output in outputs for row in output.rows}
    ordered = _ordered(_without_copies([*common, *zip(targets, values, strict=True)], needed), needed)
    stages = _staged(ordered, inputs)
    batch, preparation, body = (_renamed(stage, ordered, needed) for stage in stages)
    return Routine(
        name=name,
        summary=summary,
        source=source,
        inputs=tuple(inputs),
        outputs=tuple(outputs),
        batch=batch,
        preparation=preparation,
        body=body,
        operations=sum(operations(value) for _, value in preparation + body),
        batch_operations=sum(operations(value) for _, value in batch),
    )


def _without_copies(assignments: Sequence[Assignment], needed: set[str]) -> list[Assignment]:
    """A result that merely copies an intermediate value becomes that value's name."""
    names: dict[sp.Symbol, sp.Symbol] = {}
    made = {target for target, _ in assignments}
    for target, value in assignments:
        if target.name in needed and value in made and value.name not in needed and value not in names:
            names[value] = target
    if not names:
        return list(assignments)
    copies = set(names.values())
    return [(names.get(target, target), renamed(value, names)) for target, value in assignments if target not in copies]


def _ordered(assignments: Sequence[Assignment], needed: set[str]) -> list[Assignment]:
    """Depth first from the needed results, so that each value is made shortly before it is used."""
    values = dict(assignments)
    done: dict[sp.Symbol, sp.Expr] = {}

    def visit(target: sp.Symbol) -> None:
        if target in done:
            return
        for symbol in sorted(values[target].free_symbols & values.keys(), key=order.__getitem__):
            visit(symbol)
        done[target] = values[target]

    order = {target: index for index, (target, _) in enumerate(assignments)}
    for target, _ in assignments:
        if target.name in needed:
            visit(target)
    return list(done.items())


def _staged(ordered: Sequence[Assignment], inputs: Sequence[Argument]) -> tuple[list[Assignment], ...]:
    rows = [row for argument in inputs if argument.per_point for row in argument.rows]
    trigonometry = [
        (make(axis), function(_RADIAN_PER_DEGREE * symbols.position(axis)))
        for axis in ROTARY
        if axis.lower() in rows
        for make, function in ((symbols.cosine, sp.cos), (symbols.sine, sp.sin))
    ]
    free = {symbol for _, value in ordered for symbol in value.free_symbols}
    preparation = [(target, value) for target, value in trigonometry if target in free]
    varying = {symbols.named(row) for row in rows} | {target for target, _ in preparation}
    batch: list[Assignment] = []
    body: list[Assignment] = []
    outputs = set()
    for target, value in ordered:
        if value.free_symbols & varying:
            varying.add(target)
            body.append((target, value))
        elif target.name.startswith("_"):
            batch.append((target, value))
        else:
            outputs.add(target)
            body.append((target, value))  # a result that is the same for all points is still stored per point
    return batch, preparation, body


def _renamed(stage: Sequence[Assignment], ordered: Sequence[Assignment], needed: set[str]) -> tuple[Assignment, ...]:
    temporary = [target for target, _ in ordered if target.name not in needed]
    names = {target: symbols.named(f"w{index}") for index, target in enumerate(temporary)}
    return tuple((names.get(target, target), renamed(value, names)) for target, value in stage)


def positions_argument(machine: Machine) -> Argument:
    """`positions` (n_axes, n): commanded axis positions."""
    unit = "mm, rotary axes deg" if any(axis in ROTARY for axis in machine.axes) else "mm"
    rows = tuple(axis.lower() for axis in machine.axes)
    return Argument(
        name="positions",
        rows=rows,
        shape=(len(rows),),
        per_point=True,
        unit=unit,
        description=f"commanded positions of {' '.join(machine.axes)}",
    )


def errors_argument(machine: Machine) -> Argument:
    """`errors` (n_components, n): component errors at the points."""
    return Argument(
        name="errors",
        rows=machine.components,
        shape=(len(machine.components),),
        per_point=True,
        unit="mm, rad",
        description="component errors at the point",
    )


def parameters_argument(machine: Machine) -> Argument:
    """`parameters` (n_parameters,): dimensions and location errors."""
    count = (len(machine.parameters),)
    return Argument(
        name="parameters",
        rows=machine.parameters,
        shape=count,
        per_point=False,
        unit="mm, rad",
        description="home positions and location errors",
    )


def point_argument(seen: str, *, per_point: bool = True, name: str = "point", prefix: str = "r") -> Argument:
    """`point` (3, n) or (3,): a point in the frame of its body."""
    return vector_argument(
        name, tuple(prefix + axis for axis in _XYZ), f"point in the {seen} frame", per_point=per_point
    )


def vector_argument(name: str, rows: tuple[str, ...], description: str, *, per_point: bool = True) -> Argument:
    """A vector of three lengths, mm."""
    return Argument(name=name, rows=rows, shape=(len(rows),), per_point=per_point, unit="mm", description=description)


def by_row(rows: tuple[str, ...], values: Vector) -> dict[str, sp.Expr]:
    """Row -> its value."""
    return dict(zip(rows, values, strict=True))
