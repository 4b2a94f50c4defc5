"""What errors.json says of a machine: nothing, the truth, or what was true before the machine changed."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from tests.worlds.machine import Array, Machine
from tests.worlds.truth import Truth

DENSE = 401  # positions of a table over the travel


@dataclass(frozen=True)
class Given:
    """motion_errors: component -> object of errors.json; located: location error -> value."""

    motion_errors: Mapping[str, Any]
    located: Mapping[str, float]


def nothing_given(machine: Machine) -> Given:
    """Zeros."""
    return Given({}, dict.fromkeys(machine.locations, 0.0))


def truth_given(truth: Truth, at: Mapping[str, Array] | None = None) -> Given:
    """The curves as tables; at: axis -> positions, at which they are exact; else evenly spaced ones."""
    found = {}
    for name, curve in truth.curves.items():
        axis = name[2]
        ends = truth.machine.travel(axis)
        positions = np.linspace(*ends, DENSE) if at is None else np.unique(np.concatenate([at[axis], ends]))
        found[name] = {"basis": "table", "positions": positions.tolist(), "values": curve(positions).tolist()}
    return Given(found, dict(truth.located))


Change = Callable[[Array], Array]


def worn_at(truth: Truth, component: str, size: float, seed: int) -> Given:
    """The truth as it was before one component wore at one spot, by `size`, mm or rad."""
    return before(truth, component, wear(truth, component, size, seed))


def rescaled(truth: Truth, component: str, size: float) -> Given:
    """The truth as it was before one curve grew, by `size` at its largest, mm or rad."""
    return before(truth, component, growth(truth, component, size))


def wear(truth: Truth, component: str, size: float, seed: int) -> Change:
    """How a component changes that wears at one spot: positions -> mm or rad."""
    source = np.random.default_rng([seed, 31])
    low, high = truth.machine.travel(component[2])
    middle, half = source.uniform(0.2, 0.8), source.uniform(0.08, 0.2)

    def bump(q: Array) -> Array:
        off = np.abs((q - low) / (high - low) - middle) / half
        return np.asarray(size * 0.5 * (1.0 + np.cos(np.pi * np.minimum(off, 1.0))), float)

    return bump


def growth(truth: Truth, component: str, size: float) -> Change:
    """How a component changes that grows all over its travel."""
    curve = truth.curves[component]
    q = np.linspace(*truth.machine.travel(component[2]), DENSE)
    largest = float(np.max(np.abs(curve(q))))
    return lambda at: size / largest * curve(at)


def before(truth: Truth, component: str, change: Change) -> Given:
    """The truth as it was before a component changed."""
    given = truth_given(truth)
    old = dict(given.motion_errors)
    q = np.array(old[component]["positions"])
    old[component] = {**old[component], "values": (truth.curves[component](q) - change(q)).tolist()}
    return Given(old, given.located)
