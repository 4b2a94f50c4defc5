"""Effects that no library of causes has: what is found of them must be called unexplained."""

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from tests.hidden_effects.hidden import Hidden
from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.state import Plan, State
from tests.hidden_effects.temperature import REFERENCE


def component_terms(effect: Hidden, machine: Machine, state: State) -> Array:
    """What an effect adds to its component error, (n,), mm or rad."""
    return _COMPONENT[effect.kind](effect, machine, state)


def reading_terms(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    """What an effect adds to the readings, (n,), mm."""
    return _READING[effect.kind](effect, plan, along, theta)


def _share(effect: Hidden, machine: Machine, state: State) -> Array:
    return machine.share(effect.component[2], state.positions[effect.component[2]])


def _way(effect: Hidden, state: State) -> Array:
    return state.directions[effect.component[2]]


def _local_bump(effect: Hidden, machine: Machine, state: State) -> Array:
    """A dent of a guide: narrow, felt on the way up only; with another axis, only near one place of that one."""
    source = effect.draw()
    at, width = source.uniform(0.3, 0.7), source.uniform(0.03, 0.06)
    bump = np.exp(-(((_share(effect, machine, state) - at) / width) ** 2))
    if effect.axis:
        b = machine.share(effect.axis, state.positions[effect.axis])
        bump = bump * np.exp(-(((b - source.uniform(0.2, 0.5)) / 0.2) ** 2))
    return effect.size * bump * 0.5 * (1.0 + _way(effect, state))


def _direction_wave(effect: Hidden, machine: Machine, state: State) -> Array:
    """Lost motion that swings along the travel and changes its sign."""
    source = effect.draw()
    wave = np.sin(2 * np.pi * (_share(effect, machine, state) / source.uniform(0.15, 0.3) + source.uniform()))
    return effect.size * _way(effect, state) * wave


def _warm_lost_motion(effect: Hidden, machine: Machine, state: State) -> Array:
    """Lost motion that grows with the temperature, through zero at 20 degC."""
    return effect.size * _way(effect, state) * (state.soaked - REFERENCE)


def _quadratic_in_temperature(effect: Hidden, machine: Machine, state: State) -> Array:
    """A bimetal that goes one way whether it warms or cools."""
    return effect.size * (state.soaked - REFERENCE) ** 2 * (1.0 + _share(effect, machine, state))


def _odd_step(effect: Hidden, machine: Machine, state: State) -> Array:
    """A joint of two rails: a step whose sign is that of the direction."""
    at = effect.draw().uniform(0.25, 0.75)
    return effect.size * _way(effect, state) * np.sign(_share(effect, machine, state) - at)


def _stick_slip(effect: Hidden, machine: Machine, state: State) -> Array:
    """A saw-tooth in the way since the reversal, larger towards the far end."""
    source, axis = effect.draw(), effect.component[2]
    low, high = machine.travel[axis]
    since = np.where(np.isfinite(state.since_reversal[axis]), state.since_reversal[axis], 0.0)
    tooth = 2.0 * np.mod(since / (source.uniform(0.05, 0.12) * (high - low)), 1.0) - 1.0
    return effect.size * _way(effect, state) * _share(effect, machine, state) * tooth


def _relaxation(effect: Hidden, machine: Machine, state: State) -> Array:
    """A run that settles within a minute or two after its start."""
    moving = np.abs(_way(effect, state))
    runs, index = np.unique(state.run, return_inverse=True)
    first = np.array([np.min(state.time[state.run == run]) for run in runs])
    return _array(effect.size * moving * np.exp(-(state.time - first[index]) / effect.draw().uniform(30.0, 80.0)))


def _array(values: Any) -> Array:
    return np.asarray(values, float)


def _dragged_lobes(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    """A socket that drags: five lobes of the bar whose sign is that of the sense of rotation.

    Lobes that are the same both ways would be one with smooth errors of the axes, since cos 5 theta is a polynomial
    of cos theta.
    """
    way = np.zeros_like(theta)
    for index, run in enumerate(plan.runs):
        if run.plane:
            rows = plan.state.run == index
            way[rows] = np.sign(np.mean(np.diff(np.unwrap(theta[rows]))))
    return _array(effect.size * way * np.cos(5 * theta + effect.draw().uniform(0, 2 * np.pi)))


def _chatter(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    """A neighbour's machine that ran for a while."""
    source, time = effect.draw(), plan.state.time
    lasts = float(np.max(time))
    start = source.uniform(0.1, 0.7) * lasts
    within = (time > start) & (time < start + 0.12 * lasts)
    return np.where(within, effect.size * np.sin(2 * np.pi * time / source.uniform(31.0, 97.0)), 0.0)


_COMPONENT: Mapping[str, Callable[[Hidden, Machine, State], Array]] = {
    "local_bump": _local_bump,
    "direction_wave": _direction_wave,
    "warm_lost_motion": _warm_lost_motion,
    "quadratic_in_temperature": _quadratic_in_temperature,
    "odd_step": _odd_step,
    "stick_slip": _stick_slip,
    "relaxation": _relaxation,
}
_READING: Mapping[str, Callable[[Hidden, Plan, Array, Array], Array]] = {
    "dragged_lobes": _dragged_lobes,
    "chatter": _chatter,
}
OF_COMPONENTS, OF_READINGS = tuple(_COMPONENT), tuple(_READING)
KINDS = (*OF_COMPONENTS, *OF_READINGS)
