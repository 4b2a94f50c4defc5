"""Component errors as machines have them: smooth on the scale of the travel, and no polynomials."""

from collections.abc import Callable, Mapping

import numpy as np

from tests.hidden_effects.machine import Array, Machine

Function = Callable[[Array], Array]

MOST_WAVES = 2.0  # over the travel: degree 12 then holds a curve to some hundredths of a micrometre
LINEAR_UM, ANGULAR_URAD = (1.0, 10.0), (5.0, 30.0)  # smallest and largest amplitude over the travel
SQUARENESS_URAD = 20.0


def smooth(source: np.random.Generator, travel: tuple[float, float], amplitude: float) -> Function:
    """A line and four sines of wavelengths and phases of their own; zero at position 0 (the machine's home)."""
    low, high = travel
    waves = source.uniform(0.3, MOST_WAVES, 4)
    phases = source.uniform(0.0, 2 * np.pi, 4)
    heights = source.normal(size=4) / (1 + waves)
    slope = source.normal()

    def raw(q: Array) -> Array:
        s = (np.asarray(q, float)[..., np.newaxis] - low) / (high - low)
        total: Array = slope * s[..., 0] + np.sum(heights * np.sin(2 * np.pi * waves * s + phases), axis=-1)
        return total

    at_home = raw(np.array(0.0))
    largest = np.max(np.abs(raw(np.linspace(low, high, 201)) - at_home))
    return lambda q: amplitude / largest * (raw(q) - at_home)


def component_errors(source: np.random.Generator, machine: Machine, share: float = 1.0) -> dict[str, Function]:
    """A curve for each component; share: of the usual sizes."""
    found = {}
    for name in machine.components:
        low, high = LINEAR_UM if name[1] in "XYZ" else ANGULAR_URAD
        unit = 1e-3 if name[1] in "XYZ" else 1e-6
        amplitude = share * unit * np.exp(source.uniform(np.log(low), np.log(high)))
        found[name] = smooth(source, machine.travel[name[2]], amplitude)
    return found


def location_values(source: np.random.Generator, machine: Machine, share: float = 1.0) -> dict[str, float]:
    """EC0X and the like -> rad or mm."""
    found = {}
    for joint in machine.joints:
        for direction in joint.located:
            unit = 1e-6 if direction[1] in "ABC" else 3e-4
            found[f"{direction}0{joint.moves}"] = float(share * unit * SQUARENESS_URAD * source.normal())
    return found


def total(curves: Mapping[str, Function], more: Mapping[str, Function]) -> dict[str, Function]:
    return {name: _sum(curves[name], more[name]) for name in curves}


def _sum(first: Function, second: Function) -> Function:
    return lambda q: first(q) + second(q)
