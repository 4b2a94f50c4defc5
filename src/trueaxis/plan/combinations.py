"""What a plan leaves open, in words."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.machine import IntArray, units
from trueaxis.identify.paper.steps import SolvedStep
from trueaxis.identify.words import Share, enumerated, slope_unit, split_apart, together, unit_of
from trueaxis.measure.machine import FloatArray
from trueaxis.plan.convention import Settled
from trueaxis.plan.expected import OPEN
from trueaxis.plan.order import Order
from trueaxis.plan.report import OpenReport
from trueaxis.plan.system import System, answers

SHOWN = 1e-6  # part of an instrument's unknown, per mm of the vector, below which it is rounding


@dataclass(frozen=True, slots=True)
class _Vector:
    """An open combination taken apart: parts of location errors, components and instruments; orders that take part."""

    shares: tuple[Share, ...]
    instruments: tuple[Share, ...]
    names: tuple[str, ...]
    sloping: tuple[str, ...]
    orders: tuple[int, ...]


def undetermined(whole: System, settled: Settled, order: Order | None) -> tuple[OpenReport, ...]:
    """The convention's combinations, singular blocks, then everything else that no reading sees."""
    found = [_by_convention(vector) for vector in _taken_apart(whole, settled_and_seen(whole, settled))]
    seen = [
        vector
        for vector, values in zip(_taken_apart(whole, settled.plain), settled.plain.T, strict=True)
        if (np.abs(values[whole.seen]) > OPEN).any()
    ]
    singular = _singular(order) if order is not None else []
    found += [item for item, _ in singular]
    groups = _overlapping(seen)
    touched = set(_names(whole, settled.open)) - {name for vector in seen for name in vector.names}
    found += [_open(whole, vectors, [names for _, names in singular]) for vectors in groups]
    if touched:
        resting = [name for name in _every(whole) if name in touched and name not in _not_seen(whole)]
        text = f"{enumerated(resting)}: by the convention they rest on what is undetermined above"
        found += [OpenReport(text, tuple(resting), 0, False)] if resting else []
    missing = _not_seen(whole)
    if missing:
        text = f"{enumerated(missing)}: no reading holds them"
        found.append(OpenReport(text, tuple(missing), _count(whole, missing), False))
    return tuple(found)


def settled_and_seen(whole: System, settled: Settled) -> FloatArray:
    """(n, g): what the convention settles, but for what no reading holds anyway."""
    held = np.abs(settled.settled[whole.seen]).max(axis=0, initial=0.0) > OPEN
    return settled.settled[:, held]


def _by_convention(vector: _Vector) -> OpenReport:
    located = [name for name in vector.names if name not in vector.sloping]
    if located:
        text = split_apart(located, vector.sloping, vector.shares)
        if vector.instruments:
            text += f" where {enumerated([share.what for share in vector.instruments])} goes along"
    else:
        hidden = enumerated([share.what for share in vector.instruments])
        text = f"slope of {enumerated(vector.sloping)}: not to be told from {hidden or 'others'}"
    rule = "least-squares lines of the straightness are level (ISO 230-1)"
    return OpenReport(f"{text}; convention: {rule}", vector.names, 1, True)


def _singular(order: Order) -> list[tuple[OpenReport, set[str]]]:
    """Blocks with fewer values than unknowns, with what makes them so."""
    if order.solved is None:
        return []
    found = []
    for one in order.solved.steps:
        if not one.null_columns:
            continue
        own = order.solved.null[:, list(one.null_columns)].tocsr()[one.nodes].toarray()
        taking = order.grid.component_of(one.nodes[np.abs(own).max(axis=1) > 0.0])
        names = [order.grid.components[c] for c in one.step.components if c in taking]
        short = [f"{rank} equations for {count} unknowns" for rank, count in one.inverse.ranks if rank < count]
        text = (
            f"{enumerated(names)}: at {_places(order, one)} {enumerated(short)} in runs "
            f"{enumerated(order.names(one.step))}, because {order.because(one)}"
        )
        found.append((OpenReport(text, tuple(names), one.nodes.size - one.inverse.rank, False), set(names)))
    return found


def _places(order: Order, one: SolvedStep) -> str:
    """`each Z position`, or how many."""
    parts = []
    for axis in dict.fromkeys(order.grid.components[c][2] for c in one.step.components):
        index = order.grid.axes.index(axis)
        knots = one.nodes - order.grid.offset[order.grid.component_of(one.nodes)]
        mine = np.unique(knots[order.grid.axis[order.grid.component_of(one.nodes)] == index]).size
        every = order.grid.knots[index].size - 1
        parts.append(f"each {axis} position" if mine == every else f"{mine} of {every} {axis} positions")
    return enumerated(parts)


def _open(whole: System, vectors: Sequence[_Vector], singular: Sequence[set[str]]) -> OpenReport:
    names = {name for vector in vectors for name in vector.names}
    ordered = [name for name in _every(whole) if name in names]
    simplest = min(vectors, key=lambda vector: len(vector.shares) + len(vector.instruments))
    orders = sorted({order for vector in vectors for order in vector.orders})
    count = "1 combination" if len(vectors) == 1 else f"{len(vectors)} combinations"
    text = f"{enumerated(ordered)}: {count} undetermined{_ranges(orders)}"
    resting = [name for name in ordered if not any(name in group for group in singular)]
    if any(group & names for group in singular) and resting:
        text += f"; {enumerated(resting)} are found with the help of what is singular above"
    example = together(_per_largest((*simplest.shares, *simplest.instruments)))
    text += f"; {'this' if len(vectors) == 1 else 'for one'}: {example} changes no reading"
    return OpenReport(text, tuple(ordered), len(vectors), False)


def _every(whole: System) -> tuple[str, ...]:
    machine = whole.layout.machine
    return (*machine.location_errors, *machine.components)


def _names(whole: System, vectors: FloatArray) -> list[str]:
    """What takes part in any of the vectors."""
    taking = np.abs(vectors).max(axis=1, initial=0.0) > OPEN
    return [name for place, name in enumerate(whole.layout.names()) if taking[_unknowns_of(whole, place)].any()]


def _per_largest(shares: Sequence[Share]) -> list[Share]:
    """The same per unit of the first rotation (or first part), which comes first."""
    first = next((share for share in shares if share.unit.startswith("rad")), shares[0])
    return [Share(s.what, s.value / first.value, s.unit) for s in (first, *(s for s in shares if s is not first))]


def _overlapping(vectors: Sequence[_Vector]) -> list[list[_Vector]]:
    """Vectors that share names, directly or through others, together."""
    groups: list[tuple[set[str], list[_Vector]]] = []
    for vector in vectors:
        names, members = set(vector.names), [vector]
        apart = []
        for other, theirs in groups:
            if other & names:
                names, members = names | other, theirs + members
            else:
                apart.append((other, theirs))
        groups = [*apart, (names, members)]
    return [members for _, members in groups]


def _not_seen(whole: System) -> list[str]:
    held = {name for place, name in enumerate(whole.layout.names()) if whole.seen[_unknowns_of(whole, place)].any()}
    every = (*whole.layout.machine.components, *whole.layout.machine.location_errors)
    return [name for name in every if name not in held | whole.given]


def _count(whole: System, names: Sequence[str]) -> int:
    places = [place for place, name in enumerate(whole.layout.names()) if name in names]
    return sum(_unknowns_of(whole, place).size for place in places)


def _unknowns_of(whole: System, place: int) -> IntArray:
    layout = whole.layout
    if place < layout.components.size:
        return np.arange(layout.count)[layout.of_component(place)]
    return np.array([int(layout.offset[-1]) + place - layout.components.size])


def _taken_apart(whole: System, vectors: FloatArray) -> list[_Vector]:
    if not vectors.shape[1]:
        return []
    responses = answers(whole, vectors)
    return [
        _vector(whole, vector, [answer[:, index] for answer in responses]) for index, vector in enumerate(vectors.T)
    ]


def _vector(whole: System, vector: FloatArray, responses: Sequence[FloatArray]) -> _Vector:
    """Per unit of its first location error, else of its largest unknown."""
    layout, machine = whole.layout, whole.layout.machine
    located = np.flatnonzero(np.abs(vector[layout.offset[-1] :]) > OPEN) + int(layout.offset[-1])
    at = int(located[0]) if located.size else int(np.abs(vector).argmax())
    lead = float(vector[at] * layout.scale[at])
    unit = units(machine)[len(machine.components) :]
    shares: list[Share] = []
    orders: set[int] = set()
    sloping: list[str] = []
    for unknown in located:
        index = int(layout.locations[unknown - layout.offset[-1]])
        value = float(vector[unknown] * layout.scale[unknown] / lead)
        shares.append(Share(machine.location_errors[index], value, unit[index]))
    for place, component in enumerate(layout.components):
        mine, name = layout.of_component(place), machine.components[component]
        taking = np.flatnonzero(np.abs(vector[mine]) > OPEN)
        if not taking.size:
            continue
        orders |= set((taking + 1).tolist())
        own, basis = vector[mine] * layout.scale[mine] / lead, layout.basis_of(place)
        if taking.tolist() == [0]:
            sloping.append(name)
            shares.append(Share(name, float(own[0] * basis.per_position), slope_unit(name)))
        else:
            curve = own @ basis(layout.knots[layout.axis[place]])
            far = float(curve[int(np.abs(curve).argmax())])
            shares.append(Share(f"{name} at its largest", far, unit_of(name)))
    instruments = [
        Share(name, float(value / lead), unit)
        for one, answer in zip(whole.unknowns, responses, strict=True)
        for name, unit, value in zip(one.names, one.units, answer, strict=True)
        if abs(value) > SHOWN
    ]
    names = tuple(share.what.split(" ")[0] for share in shares)
    return _Vector(tuple(shares), tuple(instruments), names, tuple(sloping), tuple(sorted(orders)))


def _ranges(orders: Sequence[int]) -> str:
    if not orders:
        return ""
    if len(orders) == 1:
        return f" (polynomial order {orders[0]})"
    told = f"{orders[0]} to {orders[-1]}" if len(orders) > 2 else enumerated([str(order) for order in orders])
    return f" (polynomial orders {told})"
