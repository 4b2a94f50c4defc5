"""What a hidden effect adds to the readings per unit of its size, as it is hidden: the generator's own form."""

from dataclasses import replace

import numpy as np

from tests.hidden_effects.power.grade import Name
from tests.worlds import effects as known
from tests.worlds.design import Design
from tests.worlds.effects import Effect, component_term, reading_term
from tests.worlds.machine import Array, Machine
from tests.worlds.readings import exact_readings, home_state, reading_context, row_state
from tests.worlds.truth import Truth

# sizes that nobody overlooks otherwise: in the unit of the first parameter
LARGEST_LENGTH, LARGEST_ANGLE = 0.1, 3e-4  # mm, rad
LARGEST = {
    "point_offset": 20.0,
    "laser_cosine": 0.02,
    "servo_lag": 0.01,
    "squareness": 3e-4,
    "laser_scale": 1e-4,
    "reading_slope": 1e-3,
    "reading_zero": 1.0,
    "ballbar_length": 1.0,
    "ballbar_centre": 1.0,
}
OVER = {"thermal_expansion": 1800.0, "thermal_offset": 3.0, "warm_lost_motion": 3.0, "drift": 2e4}  # mm K, K, K, s
ALONG = ("local_bump", "direction_wave", "odd_step", "stick_slip")  # one way alone, curves of the position
ALIKE = 0.01  # share of all that a curve does, by which values at one position may differ
ROOTS = ("laser_cosine",)  # readings go with the square


def largest(effect: Effect) -> float:
    """The largest size that somebody may have."""
    turns = effect.component[1:2] in ("A", "B", "C")
    size = LARGEST.get(effect.kind, LARGEST_ANGLE if turns else LARGEST_LENGTH)
    return size / OVER.get(effect.kind, 1.0)


def signature(design: Design, truth: Truth, effect: Effect) -> Array:
    """(n,), mm, of the effect at its size, to first order; exactly, where a point is off."""
    jac, plan = design.jacobian, design.plan
    if effect.kind in known.ON_COMPONENTS:
        rows, homes = row_state(design.machine, plan), home_state(design.machine, plan)
        here, home = jac.here[effect.component], jac.home[effect.component]
        return here * component_term(effect, rows) - home * component_term(effect, homes)[plan.run]
    if effect.kind in known.ON_READINGS:
        return reading_term(effect, plan, *reading_context(design.machine, plan))
    if effect.kind in known.ON_LOCATIONS:
        return jac.located[effect.component] * effect.size
    without, with_it = exact_readings(design, [truth, truth.hiding(effect)])
    return np.asarray(with_it - without, float)


def is_curve(design: Design, effect: Effect) -> bool:
    """Whether what readings show of an effect is one value at each position of its axis, in the one direction in which
    it is read: they do not tell it from a machine whose curve has changed.
    """
    if effect.kind not in ALONG:
        return False
    plan, axis = design.plan, effect.component[2]
    seen = design.jacobian.here[effect.component] != 0.0
    ways = np.unique(plan.directions[axis][seen])
    if np.count_nonzero(ways) > 1:
        return False
    term = component_term(replace(effect, size=1.0), row_state(design.machine, plan))[seen]
    _, place = np.unique(plan.positions[axis][seen].round(6), return_inverse=True)
    most, least = (np.full(place.max() + 1, end) for end in (-np.inf, np.inf))
    np.maximum.at(most, place, term)
    np.minimum.at(least, place, term)
    return bool(np.max(most - least) < ALIKE * np.ptp(term))


def name_of(machine: Machine, effect: Effect) -> Name:
    """What a right diagnosis calls it."""
    if effect.kind == "squareness":
        axis = next(b.moves for b in machine.bodies for _, name in b.located if name == effect.component)
        return Name(effect.kind, f"{machine.locations[effect.component]}0{axis}")
    if effect.kind in known.OF_RUNS or effect.runs:
        reference = effect.kind == "point_offset" and effect.end == "reference"
        return Name(effect.kind, runs=tuple(sorted(effect.runs)), end="reference" if reference else "")
    return Name(effect.kind, effect.component, effect.axis if effect.kind == "cross_axis" else "")


def pitch_of(effect: Effect) -> float:
    """Of a cyclic error, as effects.py draws it first, mm or deg; 0 of all else."""
    if effect.kind != "cyclic":
        return 0.0
    return float(effect.draw().uniform(*((7.3, 21.7) if effect.component[2] in "XYZ" else (6.1, 38.3))))
