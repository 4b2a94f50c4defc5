"""The report of the global method: values, uncertainty, and what is open, in words."""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.machine import units
from trueaxis.identify.global_fit.describe_effects import effect_shares, effect_unknowns
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.measured_range import measured_ranges
from trueaxis.identify.global_fit.result import OPEN, GlobalResult
from trueaxis.identify.report import ComponentReport, InstrumentReport, Known, LocationReport
from trueaxis.identify.words import Share, enumerated, slope_unit, split_apart, together, unit_of
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import Undetermined

PERFECT = "the instruments are taken for perfect"
RULES = {
    "convention": "least-squares lines of the straightness are level (ISO 230-1)",
    "known": "given",
}


@dataclass(frozen=True, slots=True)
class _Part:
    """One component's share of a null vector: the orders that take part and their scaled values."""

    component: str
    orders: tuple[int, ...]
    values: tuple[float, ...]


def curves(result: GlobalResult) -> dict[str, PolynomialCurve]:
    """Components in plain powers with standard uncertainties, NaN where open."""
    plan = result.layout
    found = {}
    measured = measured_ranges(Design(plan, result.observed))
    for place, component in enumerate(plan.components):
        mine = plan.of_component(place)
        u = None
        if result.covariance is not None:
            back = plan.basis_of(place).powers
            variance = np.einsum("ki,kl,li->i", back, result.covariance[mine, mine], back)
            touched = (np.abs(back) * result.open[mine, np.newaxis] > 0.0).any(axis=0)
            u = np.where(touched, np.nan, np.sqrt(np.maximum(variance, 0.0)))
        curve = plan.curve(place, result.unknowns, u)
        found[plan.machine.components[component]] = replace(curve, measured=measured[place])
    return found


def location_u(result: GlobalResult) -> dict[str, float]:
    """Standard uncertainties of the location errors that were unknown, NaN where open."""
    if result.covariance is None:
        return {}
    mine = result.layout.of_locations
    u = np.sqrt(np.diag(result.covariance)[mine])
    u = np.where(result.open[mine], np.nan, u)
    return dict(zip(result.layout.names()[result.layout.components.size :], u.tolist(), strict=True))


def locations(result: GlobalResult) -> tuple[LocationReport, ...]:
    """Values of the location errors and where they come from."""
    plan, machine = result.layout, result.layout.machine
    unit = units(machine)[len(machine.components) :]
    u = location_u(result)
    found = []
    for index, name in enumerate(machine.location_errors):
        if index not in plan.locations:
            found.append(LocationReport(name, result.given.parameters.get(name, 0.0), None, unit[index], "given"))
            continue
        place = int(plan.offset[-1]) + int(np.flatnonzero(plan.locations == index)[0])
        origin = "from the readings"
        if result.open[place]:
            origin = "undetermined: " + (PERFECT if _by_instruments(result, place) else "solution of least norm")
        elif result.gauge.settled[place].any():
            origin = RULES["convention"]
        spread = u.get(name, np.nan)
        found.append(
            LocationReport(
                name, float(result.unknowns[place]), None if np.isnan(spread) else spread, unit[index], origin
            )
        )
    return tuple(found)


def components(result: GlobalResult) -> tuple[ComponentReport, ...]:
    """Largest value and uncertainty of each component over the positions of the readings."""
    plan = result.layout
    place_of = {int(component): place for place, component in enumerate(plan.components)}
    found = []
    for index, name in enumerate(plan.machine.components):
        if index not in place_of:
            known: Known = "given" if name in result.given.motion_errors else "not measured"
            found.append(ComponentReport(name, known, 0.0, None, unit_of(name)))
            continue
        place = place_of[index]
        mine = plan.of_component(place)
        basis = plan.basis_of(place)(plan.knots[plan.axis[place]])
        opened = result.open[mine]
        if unseen(result, mine):
            known = "not measured"
        else:
            known = "determined" if not opened.any() else "undetermined" if opened.all() else "partly"
        u = None
        if result.covariance is not None and not opened.any():
            variance = np.einsum("kn,kl,ln->n", basis, result.covariance[mine, mine], basis)
            u = float(np.sqrt(np.max(variance, initial=0.0)))
        largest = float(np.max(np.abs(result.unknowns[mine] @ basis), initial=0.0))
        found.append(ComponentReport(name, known, largest, u, unit_of(name)))
    return tuple(found)


def unseen(result: GlobalResult, mine: slice) -> bool:
    """Whether no reading holds any of these unknowns."""
    return not result.factors.vectors[mine].any() or bool(np.abs(result.factors.vectors[mine]).max() < OPEN)


def undetermined(result: GlobalResult) -> tuple[Undetermined, ...]:
    """Everything that the readings leave open, and what was done about it."""
    found = [_settled(result, vector) for vector in result.gauge.settled.T]
    plan = result.layout
    missing = [part.name for part in components(result) if part.known == "not measured"]
    silent = np.zeros(plan.count, dtype=bool)
    for place in range(plan.components.size):
        silent[plan.of_component(place)] = unseen(result, plan.of_component(place))
    for place in range(plan.of_effects.start, plan.of_effects.stop):
        silent[place] = unseen(result, slice(place, place + 1))
    seen = [
        vector
        for vector in result.gauge.null.T
        if not silent[np.abs(vector) > OPEN].all() and _machine_names(result, vector)
    ]
    found += [_open(result, vectors) for vectors in _overlapping(result, seen)]
    found += [
        Undetermined(f"{name}: no reading holds it, it is left at zero", (label,))
        for (name, label), still in zip(effect_unknowns(result), silent[plan.of_effects], strict=True)
        if still
    ]
    if missing:
        found.append(Undetermined(f"{enumerated(missing)}: no run holds them, they are left at zero", tuple(missing)))
    return tuple(found)


def instrument_values(result: GlobalResult) -> tuple[InstrumentReport, ...]:
    """The unknowns of the instruments."""
    plan, found = result.layout, []
    for unknown, place in zip(plan.instruments.unknowns, range(plan.of_machine, plan.count), strict=True):
        origin, u = "from the readings", None
        if result.open[place]:
            origin = "undetermined: " + PERFECT
        elif result.covariance is not None:
            u = float(np.sqrt(result.covariance[place, place]))
        found.append(InstrumentReport(unknown.name, float(result.unknowns[place]), u, unknown.unit, origin))
    return tuple(found)


def instrument_notes(result: GlobalResult) -> tuple[str, ...]:
    """What the readings cannot tell of the instruments, where it does not matter to the machine."""
    own = [v for v in result.gauge.null.T if not any(_machine_names(result, v))]
    return tuple(
        f"{enumerated([share.what for share in _instrument_shares(result, vector)])}: only a combination is determined"
        for vector in own
    )


def _by_instruments(result: GlobalResult, place: int) -> bool:
    """Whether an unknown is open only along with those of instruments."""
    mine = result.gauge.null[:, np.abs(result.gauge.null[place]) > OPEN]
    return bool((np.abs(mine[result.layout.of_instruments]).max(axis=0, initial=0.0) > OPEN).all())


def _settled(result: GlobalResult, vector: FloatArray) -> Undetermined:
    shares = _location_shares(result, vector)
    others = [*_component_shares(result, vector), *effect_shares(result, vector, _lead(result, vector))]
    partners = [part.component for part in _parts(result, vector)]
    names = [share.what for share in shares]
    text = f"{split_apart(names, partners, [*shares, *others])}; {names[0]}: {RULES['convention']}"
    return Undetermined(text, (*names, *partners))


def _overlapping(result: GlobalResult, vectors: list[FloatArray]) -> list[list[FloatArray]]:
    """Vectors that share names, directly or through others, together."""
    groups: list[tuple[set[str], list[FloatArray]]] = []
    for vector in vectors:
        names, together_with = _names(result, vector), [vector]
        apart = []
        for other, members in groups:
            if other & names:
                names |= other
                together_with = members + together_with
            else:
                apart.append((other, members))
        groups = [*apart, (names, together_with)]
    return [members for _, members in groups]


def _names(result: GlobalResult, vector: FloatArray) -> set[str]:
    return _machine_names(result, vector) | {share.what for share in _instrument_shares(result, vector)}


def _machine_names(result: GlobalResult, vector: FloatArray) -> set[str]:
    located = (share.what for share in _location_shares(result, vector))
    own = (share.what for share in effect_shares(result, vector, _lead(result, vector)))
    return {*located, *(part.component for part in _parts(result, vector)), *own}


def _open(result: GlobalResult, vectors: list[FloatArray]) -> Undetermined:
    machine = result.layout.machine
    names = set().union(*(_names(result, vector) for vector in vectors))
    of_effects = [name for name, _ in effect_unknowns(result)]
    ordered = tuple(name for name in (*machine.location_errors, *machine.components, *of_effects) if name in names)
    own = [f"the {unknown.name}" for unknown in result.layout.instruments.unknowns if f"the {unknown.name}" in names]
    simplest = min(vectors, key=lambda vector: int(np.count_nonzero(np.abs(vector) > OPEN)))
    of_machine = [
        *_location_shares(result, simplest),
        *_component_shares(result, simplest),
        *effect_shares(result, simplest, _lead(result, simplest)),
    ]
    orders = sorted({order for vector in vectors for part in _parts(result, vector) for order in part.orders})
    count = "1 combination" if len(vectors) == 1 else f"{len(vectors)} combinations"
    of_instruments = all(_instrument_shares(result, vector) for vector in vectors)
    text = (
        f"{enumerated([*ordered, *own])}: {count} undetermined{_ranges(orders)}; for one, "
        f"{together([*_per_largest(of_machine), *_per(_instrument_shares(result, simplest), of_machine)])} "
        f"changes no reading; {PERFECT if of_instruments else 'the solution of least norm is given'}"
    )
    return Undetermined(text, ordered)


def _per_largest(shares: list[Share]) -> list[Share]:
    """The same combination per unit of its first rotation (or first part), which comes first."""
    first = _leading(shares)
    return _per([first, *(share for share in shares if share is not first)], shares)


def _per(shares: list[Share], all_shares: list[Share]) -> list[Share]:
    return [Share(share.what, share.value / _leading(all_shares).value, share.unit) for share in shares]


def _leading(shares: list[Share]) -> Share:
    return next((share for share in shares if share.unit.startswith("rad")), shares[0])


def _parts(result: GlobalResult, vector: FloatArray) -> list[_Part]:
    plan = result.layout
    found = []
    for place, component in enumerate(plan.components):
        values = vector[plan.of_component(place)]
        taking_part = np.flatnonzero(np.abs(values) > OPEN)
        if taking_part.size:
            orders = tuple((taking_part + 1).tolist())
            found.append(_Part(plan.machine.components[component], orders, tuple(values[taking_part].tolist())))
    return found


def _location_shares(result: GlobalResult, vector: FloatArray) -> list[Share]:
    plan, machine = result.layout, result.layout.machine
    unit = units(machine)[len(machine.components) :]
    start = int(plan.offset[-1])
    lead = _lead(result, vector)
    return [
        Share(machine.location_errors[p], float(vector[start + i] * plan.scale[start + i] / lead), unit[p])
        for i, p in enumerate(plan.locations)
        if abs(vector[start + i]) > OPEN
    ]


def _instrument_shares(result: GlobalResult, vector: FloatArray) -> list[Share]:
    plan = result.layout
    lead = _lead(result, vector)
    own = vector[plan.of_instruments] * plan.scale[plan.of_instruments] / lead
    return [
        Share(f"the {unknown.name}", float(value), unknown.unit)
        for unknown, value, scaled in zip(plan.instruments.unknowns, own, vector[plan.of_instruments], strict=True)
        if abs(scaled) > OPEN
    ]


def _component_shares(result: GlobalResult, vector: FloatArray) -> list[Share]:
    """Slopes where a component takes part by its first order alone, else its largest value over the positions."""
    plan = result.layout
    lead = _lead(result, vector)
    found = []
    for part in _parts(result, vector):
        place = int(np.flatnonzero(plan.components == plan.machine.components.index(part.component))[0])
        mine, basis = plan.of_component(place), plan.basis_of(place)
        own = vector[mine] * plan.scale[mine] / lead
        if part.orders == (1,):
            found.append(Share(part.component, float(own[0] * basis.per_position), slope_unit(part.component)))
        else:
            curve = own @ basis(plan.knots[plan.axis[place]])
            far = float(curve[int(np.abs(curve).argmax())])
            found.append(Share(f"{part.component} at its largest", far, unit_of(part.component)))
    return found


def _lead(result: GlobalResult, vector: FloatArray) -> float:
    """What the shares are given per: the first location error that takes part, else the largest unknown."""
    plan = result.layout
    located = vector[plan.of_locations]
    first = np.flatnonzero(np.abs(located) > OPEN)
    at = int(plan.offset[-1]) + int(first[0]) if first.size else int(np.abs(vector).argmax())
    return float(vector[at] * plan.scale[at])


def _ranges(orders: list[int]) -> str:
    if not orders:
        return ""
    told = f"{orders[0]} to {orders[-1]}" if len(orders) > 2 else enumerated([str(order) for order in orders])
    return f" (polynomial orders {told})"
