"""A machine of a design: its curves and location errors, and where its tool really is."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tests.worlds.curves import Curve, Span, draw_curve
from tests.worlds.effects import Effect
from tests.worlds.kinematics import coordinates
from tests.worlds.machine import Array, Machine

SIZES = {"translation_um": 8.0, "rotation_urad": 8.0, "location_urad": 20.0, "location_um": 15.0}
UNITS = {"um": 1e-3, "urad": 1e-6}
CLASS_SPREAD, COMPONENT_SPREAD = 0.4, 0.4  # of the logarithms of sizes


@dataclass(frozen=True, eq=False)
class Truth:
    """curves: component -> curve; located: location error -> mm or rad; sizes: of both, one standard deviation, mm or
    rad; family: of the curves; effects: what is hidden beside them.
    """

    machine: Machine
    curves: Mapping[str, Curve]
    located: Mapping[str, float]
    sizes: Mapping[str, float]
    family: str = "smooth"
    effects: tuple[Effect, ...] = ()

    def deviation(self, positions: Mapping[str, Array], tool_point: Array, datum: str = "machine") -> Array:
        """Actual minus ideal position of the tool point in the workpiece frame, (n, 3), mm, without hidden effects.

        positions: axis -> (n,), mm or deg; tool_point: (3,) or (n, 3), mm; datum: `machine`, or `home`: less the
        deviation with all axes at home.
        """
        found = _deviation(self, positions, tool_point)
        if datum == "home":
            home = {axis: np.array([self.machine.home(axis)]) for axis in self.machine.axes}
            found = found - _deviation(self, home, tool_point)
        return found

    def hiding(self, *effects: Effect) -> "Truth":
        """The same machine with effects beside its geometric errors."""
        located = dict(self.located)
        for effect in effects:
            if effect.kind == "squareness":
                located[effect.component] = located[effect.component] + effect.size
        return replace(self, effects=(*self.effects, *effects), located=located)


def span_of(machine: Machine, axis: str) -> Span:
    return Span(*machine.travel(axis), machine.home(axis))


def draw_machine(
    machine: Machine, seed: int, sizes: Mapping[str, float] | None = None, curves: str = "smooth"
) -> Truth:
    """A machine with random errors.

    sizes: about which sizes are drawn (log-normal), as SIZES; curves: `smooth` (no polynomials) or `prior` (draws of
    the prior that `prior_basis` states). Raises KeyError for other sizes or curves.
    """
    source = np.random.default_rng([seed, 11])
    about = {**SIZES, **(sizes or {})}
    classes = {name: about[name] * np.exp(CLASS_SPREAD * source.normal()) for name in SIZES}
    found: dict[str, Curve] = {}
    each: dict[str, float] = {}
    for name in machine.components:
        kind = "translation_um" if name[1] in "XYZ" else "rotation_urad"
        each[name] = _size(source, classes, kind)
        found[name] = draw_curve(source, curves, span_of(machine, name[2]), each[name])
    located = {}
    for name, direction in machine.locations.items():
        each[name] = _size(source, classes, "location_um" if direction[1] in "XYZ" else "location_urad")
        located[name] = each[name] * float(source.normal())
    return Truth(machine, found, located, each, curves)


def random_points(machine: Machine, seed: int, count: int = 200) -> dict[str, Array]:
    """Positions all over the travels, axis -> (n,)."""
    source = np.random.default_rng([seed, 12])
    return {axis: source.uniform(*machine.travel(axis), count) for axis in machine.axes}


def _size(source: np.random.Generator, classes: Mapping[str, float], kind: str) -> float:
    unit = UNITS[kind.rsplit("_", 1)[1]]
    return float(unit * classes[kind] * np.exp(COMPONENT_SPREAD * source.normal()))


def _deviation(truth: Truth, positions: Mapping[str, Array], tool_point: Array) -> Array:
    errors = {name: curve(positions[name[2]]) for name, curve in truth.curves.items()}
    view = (truth.machine, "tool", "workpiece", positions, tool_point)
    located = {name: np.array(value) for name, value in truth.located.items()}
    return coordinates(*view, errors, located) - coordinates(*view, {}, {})


def stacked(truths: Sequence[Truth], positions: Mapping[str, Array]) -> dict[str, Array]:
    """Component errors of several machines without their effects, component -> (m, n)."""
    distinct = {axis: np.unique(values, return_inverse=True) for axis, values in positions.items()}
    found = {}
    for name in truths[0].curves:
        at, where = distinct[name[2]]
        found[name] = np.array([truth.curves[name](at)[where] for truth in truths])
    return found
