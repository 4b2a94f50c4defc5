"""What errors.json says of a machine: more or less what is true of it."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.polynomial import Chebyshev, Polynomial

from tests.hidden_effects.curves import Function
from tests.hidden_effects.machine import Machine

Source = np.random.Generator
Curve = dict[str, Any]

DEGREE, POINTS, DENSE = 12, 41, 401
LINEAR_MM, ANGULAR_RAD = 1.5e-4, 3e-7  # noise that an identification leaves at each of its points


@dataclass(frozen=True)
class Given:
    """motion_errors: component -> the object of errors.json; located: EC0X and the like -> rad or mm."""

    motion_errors: Mapping[str, Curve]
    located: Mapping[str, float]


def given_values(
    kind: str, source: Source, machine: Machine, curves: Mapping[str, Function], located: Mapping[str, float]
) -> Given:
    """Raises KeyError for a kind that is none."""
    make = _KINDS[kind]
    motion = {name: make(source, name, machine.travel[name[2]], curve) for name, curve in curves.items()}
    if kind == "zero":
        return Given({}, {})
    off = 0.0 if kind == "exact" else 5e-7
    return Given(motion, {name: value + off * source.normal() for name, value in located.items()})


def _table(source: Source, name: str, travel: tuple[float, float], curve: Function) -> Curve:
    positions = np.linspace(*travel, DENSE)
    return {"basis": "table", "positions": positions.tolist(), "values": curve(positions).tolist()}


def _polynomial(source: Source, name: str, travel: tuple[float, float], curve: Function) -> Curve:
    positions = np.linspace(*travel, POINTS)
    noise = (LINEAR_MM if name[1] in "XYZ" else ANGULAR_RAD) * source.standard_normal(POINTS)
    fitted = Chebyshev.fit(positions, curve(positions) + noise, DEGREE, domain=travel)
    coefficients = fitted.convert(kind=Polynomial).coef
    coefficients[0] = 0.0  # errors count from home
    return {"basis": "polynomial", "powers": list(range(1, DEGREE + 1)), "coefficients": coefficients[1:].tolist()}


def _nothing(source: Source, name: str, travel: tuple[float, float], curve: Function) -> Curve:
    return {}


_KINDS: Mapping[str, Callable[[Source, str, tuple[float, float], Function], Curve]] = {
    "exact": _table,
    "identified": _polynomial,
    "stale": _polynomial,
    "zero": _nothing,
}
