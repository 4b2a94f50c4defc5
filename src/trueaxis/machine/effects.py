"""[[effect]]: the terms that a machine has beside its geometric errors."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from difflib import get_close_matches

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.library import BY_NAME
from trueaxis.effects.placement import allows
from trueaxis.error_name import DIRECTIONS, ROTATIONS, ErrorName, rotation_about
from trueaxis.machine.effect_kinds import component_errors
from trueaxis.machine.fields import Fields, shown
from trueaxis.machine.machine import AXES, Body

ENDS = ("target", "reference")

_KEYS = ("component", "axis", "runs", "end")


def read_effects(top: Fields, bodies: Sequence[Body] | None, own: Iterable[Kind]) -> tuple[Effect, ...]:
    """The effects of a machine, in the order of the spec; complains of every fault.

    bodies: None while they are in doubt; nothing is then said of component errors and axes. own: the machine's kinds.
    """
    kinds = BY_NAME | {kind.name: kind for kind in own}
    found: dict[Effect, Effect] = {}
    for fields in top.tables("effect"):
        name = fields.text("kind")
        kind = kinds.get(name or "")
        if kind is None:
            if name is not None:
                close = get_close_matches(name, kinds, n=3, cutoff=0.5)
                right = " or ".join(close) if close else f"one of {' '.join(kinds)}"
                fields.fault("kind", f"there is no kind {shown(name)}", right)
            fields.known.update(_KEYS)
            fields.refuse_others()
            continue
        effect = _read_effect(fields, kind, bodies)
        same = replace(effect, runs=tuple(sorted(effect.runs)))
        if same in found:
            fields.complain(fields.path, f"{effect.label} is there already", "each effect once")
        found.setdefault(same, effect)
    return tuple(found.values())


def with_squareness(bodies: Sequence[Body], effects: Iterable[Effect]) -> tuple[Body, ...]:
    """The bodies with the position errors that effects of the place `location` add, named as the effect's component."""
    added = [effect.component for effect in effects if effect.component and _is_location(effect)]
    names = [name for text in added if (name := ErrorName.parse(text)) and name.is_location]
    return tuple(_with_errors(body, [name for name in names if name.axis == body.moves]) for body in bodies)


def _is_location(effect: Effect) -> bool:
    kind = BY_NAME.get(effect.kind)
    return kind is not None and kind.place == "location"


def _with_errors(body: Body, names: Iterable[ErrorName]) -> Body:
    errors = dict(body.position_errors) | {name.direction: str(name) for name in names}
    ordered = tuple((direction, errors[direction]) for direction in DIRECTIONS if direction in errors)
    return replace(body, position_errors=ordered)


def _read_effect(fields: Fields, kind: Kind, bodies: Sequence[Body] | None) -> Effect:
    allowed = set(_keys(kind))
    for key in _KEYS:
        if key in fields.raw and key not in allowed:
            fields.fault(key, f"an effect of the kind {kind.name} has none", "leave it out")
        fields.known.add(key)
    component = fields.text("component") if "component" in allowed else None
    axis = fields.choice("axis", AXES) if "axis" in allowed else None
    runs = (fields.texts("runs") or ()) if "runs" in allowed else ()
    end = (fields.choice("end", ENDS) or ENDS[0]) if "end" in allowed else None
    fields.refuse_others(", ".join(("kind", *_keys(kind))))
    if bodies is not None and component is not None:
        if kind.place == "location":
            _check_location(fields, component, bodies)
        else:
            _check_component(fields, kind, component, bodies)
    if "axis" in allowed:
        _check_axis(fields, component, bodies)
    return Effect(kind=kind.name, component=component, axis=axis, runs=runs, end=end)


def _keys(kind: Kind) -> Iterator[str]:
    if kind.place in ("component", "location"):
        yield "component"
    if kind.other_axis:
        yield "axis"
    if kind.by_run:
        yield "runs"
    if kind.place == "point" and kind.instruments == ("laser",):  # of a ball bar, it is the ball on the workpiece
        yield "end"


def _check_component(fields: Fields, kind: Kind, component: str, bodies: Sequence[Body]) -> None:
    there = component_errors(bodies)
    right = [name for name in there if allows(kind, name)]
    remedy = f"one of {' '.join(right)}" if right else "this machine has none that it may act on"
    if component not in there:
        fields.fault("component", f"{shown(component)} is no component error of this machine", remedy)
    elif component not in right:
        fields.fault("component", f"{kind.name} does not act on {component}", remedy)


def _check_axis(fields: Fields, component: str | None, bodies: Sequence[Body] | None) -> None:
    axis = fields.raw.get("axis")
    name = ErrorName.parse(component or "")
    own = name.axis if name else None
    others = [other for other in _axes(bodies or ()) if other != own]
    right = f"the other axis, one of {' '.join(others)}" if others else "the other axis"
    if axis is None:
        fields.fault("axis", "is missing", right)
    elif axis == own:
        fields.fault("axis", f"{axis} is the axis of {component} itself", right)
    elif bodies is not None and axis in AXES and axis not in others:
        fields.fault("axis", f"this machine has no axis {axis}", right)


def _axes(bodies: Sequence[Body]) -> list[str]:
    moved = {body.moves for body in bodies}
    return [axis for axis in AXES if axis in moved]


def _check_location(fields: Fields, component: str, bodies: Sequence[Body]) -> None:
    """A rotation of the body that an axis moves, not about the axis's own line, which the body does not have yet."""
    possible = [
        turn.location_error(axis) for axis in _axes(bodies) for turn in ROTATIONS if turn != rotation_about(axis)
    ]
    there = {
        direction.location_error(body.moves): (body, direction, parameter)
        for body in bodies
        for direction, parameter in body.position_errors
        if body.moves
    }
    free = [name for name in possible if name not in there]
    names = {name for body in bodies for _, name in body.position_errors}
    names |= {part for body in bodies for part in body.position if isinstance(part, str)}
    right = f"one of {' '.join(free)}" if free else "leave it out: this machine has all of them"
    name = ErrorName.parse(component)
    if name in there:
        body, direction, parameter = there[name]
        has = f"body {body.number} ({body.name}) has the position error {direction} already, {parameter}"
        fields.fault("component", has, right)
    elif component not in free:
        fields.fault("component", f"{shown(component)} is no squareness of an axis of this machine", right)
    elif component in names:
        fields.fault("component", f"the name {component} is that of another parameter", "another name for that one")
