"""Values of the effects of a machine, to and from the objects of an error-values file."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any

import numpy as np
import numpy.typing as npt

from trueaxis.effects.kind import Effect, Kind
from trueaxis.io.faults import Faults
from trueaxis.model.curve_json import read_u, u_value
from trueaxis.model.strict_json import JsonPath, key_path, number, shown

FloatArray = npt.NDArray[np.float64]
Identity = tuple[str, str | None, str | None, tuple[str, ...], str | None]
_KEYS = ("kind", "component", "axis", "runs", "end", "parameters", "u")


@dataclass(frozen=True, slots=True)
class EffectValues:
    """One effect with its parameters by name, and their standard uncertainties, NaN where unknown."""

    effect: Effect
    parameters: Mapping[str, float]
    u: Mapping[str, float] = field(default_factory=dict)

    def vector(self, kind: Kind) -> FloatArray:
        """(m,): the parameters in the order of the effect's kind, zero where nothing is said."""
        return np.array([self.parameters.get(one.name, 0.0) for one in kind.parameters])


def identity(effect: Effect) -> Identity:
    """What makes two effects the same: everything but the order of runs; the end is the target unless said."""
    end = None if effect.end == "target" else effect.end
    return effect.kind, effect.component, effect.axis, tuple(sorted(effect.runs)), end


def in_order(values: Sequence[EffectValues], effects: Sequence[Effect]) -> tuple[EffectValues, ...]:
    """The values in the order of the effects; those of other effects follow as they came."""
    places = {identity(effect): index for index, effect in enumerate(effects)}
    return tuple(sorted(values, key=lambda one: places.get(identity(one.effect), len(effects))))


def read_effects(
    entries: Any, effects: Sequence[Effect], kinds: Mapping[str, Kind], faults: Faults
) -> tuple[EffectValues, ...]:
    """The values under `effects`, in the order of the machine's effects. Each must be one of the machine's.

    A parameter that is not named is a fault: a pitch of zero is no pitch.
    """
    if not isinstance(entries, list):
        faults.add("effects", f"{shown(entries)} is not a list")
        return ()
    known = {identity(effect): effect for effect in effects}
    found: dict[Any, EffectValues] = {}
    for index, entry in enumerate(entries):
        path: JsonPath = ("effects", index)
        named = _effect(entry, path, faults)
        if named is None:
            continue
        effect = known.get(identity(named))
        if effect is None:
            told = ", ".join(one.label for one in effects)
            remedy = f"the machine's effects are: {told}" if told else "add it to the machine's spec as [[effect]]"
            faults.add(key_path(path), f"the machine has no effect {named.label}", remedy)
        elif identity(effect) in found:
            faults.add(key_path(path), f"{named.label} is given more than once", "keep one")
        else:
            kind = kinds[effect.kind]
            found[identity(effect)] = EffectValues(
                effect, _parameters(entry, kind, path, faults), _uncertainties(entry, kind, path, faults)
            )
    return in_order(tuple(found.values()), effects)


def effect_object(values: EffectValues) -> dict[str, Any]:
    """The JSON object of one effect."""
    effect = values.effect
    found: dict[str, Any] = {"kind": effect.kind}
    if effect.component is not None:
        found["component"] = effect.component
    if effect.axis is not None:
        found["axis"] = effect.axis
    if effect.runs:
        found["runs"] = list(effect.runs)
    if effect.end is not None:
        found["end"] = effect.end
    found["parameters"] = {name: float(value) for name, value in values.parameters.items()}
    if values.u:
        found["u"] = {name: u_value(u) for name, u in values.u.items()}
    return found


def _effect(entry: Any, path: JsonPath, faults: Faults) -> Effect | None:
    """Which effect an entry is of; None when a fault was noted."""
    before = len(faults.found)
    if not isinstance(entry, dict):
        faults.add(key_path(path), f"{shown(entry)} is not an effect", 'give {"kind": ..., "parameters": {...}}')
        return None
    for key in entry:
        if key not in _KEYS:
            faults.add(key_path((*path, key)), "is not a key of an effect", f"known: {', '.join(_KEYS)}")
    if "kind" not in entry:
        faults.add(key_path((*path, "kind")), "is missing", "the name of a kind")
    for key in ("kind", "component", "axis", "end"):
        if key in entry and not isinstance(entry[key], str):
            faults.add(key_path((*path, key)), f"{shown(entry[key])} is not a text")
    runs = entry.get("runs", [])
    if not isinstance(runs, list) or not all(isinstance(run, str) for run in runs):
        faults.add(key_path((*path, "runs")), f"{shown(runs)} is not a list of run ids")
    if len(faults.found) > before:
        return None
    return Effect(
        kind=entry["kind"],
        component=entry.get("component"),
        axis=entry.get("axis"),
        runs=tuple(runs),
        end=entry.get("end"),
    )


def _parameters(entry: dict[str, Any], kind: Kind, path: JsonPath, faults: Faults) -> dict[str, float]:
    given = _named(entry, "parameters", kind, path, faults)
    found = {}
    for one in kind.parameters:
        place = (*path, "parameters", one.name)
        if one.name not in given:
            faults.add(key_path(place), "is missing", one.meaning)
            continue
        found[one.name] = value = number(given[one.name], place, faults)
        if one.is_divisor and value <= 0.0:
            faults.add(key_path(place), f"{value!r} is not above 0", one.meaning)
    return found


def _uncertainties(entry: dict[str, Any], kind: Kind, path: JsonPath, faults: Faults) -> dict[str, float]:
    given = _named(entry, "u", kind, path, faults)
    names = [one.name for one in kind.parameters if one.name in given]
    return {name: read_u(given[name], (*path, "u", name), faults) for name in names}


def _named(entry: dict[str, Any], key: str, kind: Kind, path: JsonPath, faults: Faults) -> dict[str, Any]:
    """The object under a key, whose names must be parameters of the kind; empty, with a fault, where it is none."""
    given = entry.get(key, {})
    if not isinstance(given, dict):
        faults.add(key_path((*path, key)), f"{shown(given)} is not an object")
        return {}
    known = [one.name for one in kind.parameters]
    for name in given:
        if name not in known:
            close = get_close_matches(name, known, n=1)
            remedy = f"did you mean {close[0]}?" if close else f"known: {', '.join(known)}"
            faults.add(key_path((*path, key, name)), f"{kind.name} has no parameter {name}", remedy)
    return given
