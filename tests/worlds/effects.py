"""What a machine hides beside geometric errors: effects that a diagnosis knows, written anew and not quite as it
writes them, and effects that it does not know.

Flaws are those of real ones: lost motion that is taken up over some tenths of a millimetre and varies along the travel,
a second harmonic, a pitch off any grid, a structure that follows the temperature late, a lag that depends on the feed.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from tests.worlds.machine import Array, Flags, Machine
from tests.worlds.plan import Plan

WARM = 20.0  # degC at which thermal effects are none


@dataclass(frozen=True)
class Effect:
    """size: amplitude in the first parameter of the kind (mm, rad, s and their quotients; of laser_cosine the angle).

    component: on which it acts, EXX; of a squareness the name of the location error that the spec leaves out; of
    point_offset the letter of the shift; axis: the other axis of a cross_axis; runs: of effects of runs, and of a
    ballbar_length that is of one session;
    end: of point_offset, target or reference; shape: seed of what the size does not say (phase, pitch, moment ...).
    """

    kind: str
    component: str = ""
    size: float = 0.0
    axis: str = ""
    runs: tuple[str, ...] = ()
    end: str = "target"
    shape: int = 0

    def draw(self) -> np.random.Generator:
        """The same numbers each time."""
        return np.random.default_rng([self.shape, sum(map(ord, self.kind))])


@dataclass(frozen=True, eq=False)
class State:
    """Of rows, or of the homes of runs; axis -> (n,) and (n,), as in Plan; started: s, when each row's run began."""

    machine: Machine
    positions: Mapping[str, Array]
    directions: Mapping[str, Array]
    since: Mapping[str, Array]
    path: Mapping[str, Array]
    turned: Mapping[str, Array]
    velocity: Mapping[str, Array]
    time: Array
    feed: Array
    soaked: Array
    started: Array

    def share(self, effect: Effect) -> Array:
        axis = effect.component[2]
        return self.machine.share(axis, self.positions[axis])

    def way(self, effect: Effect) -> Array:
        return self.directions[effect.component[2]]

    def flank(self, effect: Effect, taken_up: float) -> Array:
        """-1 right after a reversal to 1 when the slack is taken up, times the direction."""
        return self.way(effect) * (2.0 * np.tanh(self.since[effect.component[2]] / taken_up) - 1.0)


Term = Callable[[Effect, State], Array]
ReadingTerm = Callable[[Effect, Plan, Array, Array], Array]


def component_term(effect: Effect, state: State) -> Array:
    """What an effect of ON_COMPONENTS adds to its component error, (n,), mm or rad."""
    return np.asarray({**_KNOWN, **_UNKNOWN}[effect.kind](effect, state), float)


def reading_term(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    """What an effect of ON_READINGS adds to all readings, (n,), mm; along: ideal displacement since home; theta: polar
    angle of a bar, rad.
    """
    return np.asarray({**_KNOWN_OF_READINGS, **_UNKNOWN_OF_READINGS}[effect.kind](effect, plan, along, theta), float)


def _backlash(effect: Effect, state: State) -> Array:
    source = effect.draw()
    taken_up, waves, phase = source.uniform(0.1, 1.0), source.uniform(0.5, 1.5), source.uniform(0, 2 * np.pi)
    varied = 1.0 + 0.05 * np.sin(2 * np.pi * waves * state.share(effect) + phase)
    return effect.size / 2 * varied * state.flank(effect, taken_up)


def _backlash_slope(effect: Effect, state: State) -> Array:
    source, s = effect.draw(), state.share(effect) - 0.5
    bent = s + source.uniform(-0.15, 0.15) * (s**2 - 1 / 12)
    return effect.size * bent * state.flank(effect, source.uniform(0.1, 1.0))


def _cyclic(effect: Effect, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    pitch = source.uniform(7.3, 21.7) if axis in "XYZ" else source.uniform(6.1, 38.3)
    first, second = source.uniform(0, 2 * np.pi, 2)
    angle = 2 * np.pi * state.positions[axis] / pitch
    return np.asarray(effect.size * (np.cos(angle + first) + 0.15 * np.cos(2 * angle + second)), float)


def _thermal_expansion(effect: Effect, state: State) -> Array:
    bent = 1.0 + 0.05 * (state.share(effect) - 0.5)
    return effect.size * state.positions[effect.component[2]] * bent * (state.soaked - WARM)


def _thermal_offset(effect: Effect, state: State) -> Array:
    return effect.size * (state.soaked - WARM) * (1.0 + 0.02 * (state.soaked - WARM))


def _warm_up(effect: Effect, state: State) -> Array:
    tau = effect.draw().uniform(1500.0, 6000.0)
    course = 0.9 * np.exp(-state.time / tau) + 0.1 * np.exp(-4 * state.time / tau)
    return effect.size * state.share(effect) * course


def _drift(effect: Effect, state: State) -> Array:
    period = effect.draw().uniform(2e4, 4e4)
    return effect.size * (state.time + 400.0 * np.sin(2 * np.pi * state.time / period))


def _servo_lag(effect: Effect, state: State) -> Array:
    speed = np.nan_to_num(state.feed) / 60.0
    return -effect.size * state.velocity[effect.component[2]] * (1.0 - 0.05 * speed / 60.0)


def _reversal_spike(effect: Effect, state: State) -> Array:
    source, since = effect.draw(), state.since[effect.component[2]]
    rise, decay = source.uniform(0.1, 0.3), source.uniform(3.0, 12.0)
    faster = 1.0 + 0.1 * np.nan_to_num((state.feed - 2500.0) / 1500.0)
    return effect.size * faster * state.way(effect) * (1.0 - np.exp(-since / rise)) * np.exp(-since / decay)


def _reversal_spike_time(effect: Effect, state: State) -> Array:
    """Of the time since the reversal: none where the axis stands."""
    source, passed = effect.draw(), state.turned[effect.component[2]]
    rise, tau = source.uniform(0.01, 0.03), source.uniform(0.1, 0.6)
    return effect.size * state.way(effect) * (1.0 - np.exp(-passed / rise)) * np.exp(-passed / tau)


def _reversal_spike_path(effect: Effect, state: State) -> Array:
    """Of the way along the path since the reversal, whichever axis moves."""
    source, passed = effect.draw(), state.path[effect.component[2]]
    rise, decay = source.uniform(0.1, 0.3), source.uniform(3.0, 20.0)
    return effect.size * state.way(effect) * (1.0 - np.exp(-passed / rise)) * np.exp(-passed / decay)


def _cross_axis(effect: Effect, state: State) -> Array:
    s, b = state.share(effect), state.machine.share(effect.axis, state.positions[effect.axis])
    return effect.size * s * (0.95 + 0.05 * s) * (0.93 * b**2 + 0.07 * b**3)


def _local_bump(effect: Effect, state: State) -> Array:
    """A worn spot that shows in one direction alone."""
    source = effect.draw()
    off = (state.share(effect) - source.uniform(0.25, 0.75)) / source.uniform(0.02, 0.06)
    return np.where(state.way(effect) > 0, effect.size * np.exp(-0.5 * off**2), 0.0)


def _direction_wave(effect: Effect, state: State) -> Array:
    source = effect.draw()
    wave = np.sin(2 * np.pi * source.uniform(2.5, 5.0) * state.share(effect) + source.uniform(0, 2 * np.pi))
    return effect.size * state.way(effect) * wave


def _warm_lost_motion(effect: Effect, state: State) -> Array:
    return effect.size * state.way(effect) * (state.soaked - WARM)


def _odd_step(effect: Effect, state: State) -> Array:
    """A joint of two rails: a step whose sign is that of the direction."""
    return effect.size * state.way(effect) * np.sign(state.share(effect) - effect.draw().uniform(0.25, 0.75))


def _stick_slip(effect: Effect, state: State) -> Array:
    source, since = effect.draw(), state.since[effect.component[2]]
    length = source.uniform(0.05, 0.12) * float(np.ptp(state.machine.travel(effect.component[2])))
    tooth = 2.0 * np.mod(np.where(np.isfinite(since), since, 0.0) / length, 1.0) - 1.0
    return effect.size * state.way(effect) * state.share(effect) * tooth


def _relaxation(effect: Effect, state: State) -> Array:
    """A run that settles within a minute or two after its start."""
    tau = effect.draw().uniform(30.0, 80.0)
    return effect.size * np.abs(state.way(effect)) * np.exp(-(state.time - state.started) / tau)


def of_runs(plan: Plan, runs: tuple[str, ...]) -> Flags:
    """(n,), rows of these runs. Raises ValueError where there is no such run."""
    chosen = [index for index, run in enumerate(plan.runs) if run.id in runs]
    if len(chosen) != len(runs):
        raise ValueError(f"of the runs {runs} some are not in the plan")
    return np.isin(plan.run, chosen)


def _of(plan: Plan, instrument: str) -> Flags:
    return np.isin(plan.run, [index for index, run in enumerate(plan.runs) if run.instrument == instrument])


def _laser_cosine(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    return np.where(of_runs(plan, effect.runs), (np.cos(effect.size) - 1.0) * along, 0.0)


def _laser_scale(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    varied = 1.0 + 0.02 * np.sin(2 * np.pi * plan.time / 9000.0)
    return np.where(_of(plan, "laser"), effect.size * varied * along, 0.0)


def _laser_step(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    own = of_runs(plan, effect.runs)
    start, end = plan.time[own].min(), plan.time[own].max()
    moment = start + effect.draw().uniform(0.3, 0.7) * (end - start)
    return np.where(own, effect.size * 0.5 * (1.0 + np.tanh((plan.time - moment) / 1.5)), 0.0)


def _reading_zero(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    return np.where(of_runs(plan, effect.runs), effect.size, 0.0)


def _reading_slope(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    """A reflector that does not lie along the motion of a straightness line, mm per mm of the axis that moves."""
    found = np.zeros(plan.count)
    for index, run in enumerate(plan.runs):
        rows = plan.rows(index)
        moving = [axis for axis, values in plan.at(rows).items() if np.ptp(values) > 0]
        if run.id in effect.runs:
            found[rows] = effect.size * (plan.positions[moving[0]][rows] - (run.home or {})[moving[0]])
    return found


def _ballbar_length(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    own = of_runs(plan, effect.runs) if effect.runs else _of(plan, "ballbar")
    return np.where(own, effect.size * (1.0 + 0.02 * (plan.temperature - WARM)), 0.0)


def _ballbar_lobes(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    first, second = effect.draw().uniform(0, 2 * np.pi, 2)
    lobes = np.cos(3 * theta + first) + 0.08 * np.cos(6 * theta + second)
    return np.where(_of(plan, "ballbar"), effect.size * lobes, 0.0)


def _chatter(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    """A neighbour's machine that ran during the run in which it is said to."""
    source = effect.draw()
    wave = np.sin(2 * np.pi * plan.time / source.uniform(31.0, 97.0))
    return np.where(of_runs(plan, effect.runs), effect.size * wave, 0.0)


def _dragged_lobes(effect: Effect, plan: Plan, along: Array, theta: Array) -> Array:
    """A socket that drags: five lobes whose sign is that of the sense of rotation."""
    way = np.zeros_like(theta)
    for index, run in enumerate(plan.runs):
        if run.plane:
            way[plan.rows(index)] = 1.0 if "-ccw" in run.id else -1.0
    return effect.size * way * np.cos(5 * theta + effect.draw().uniform(0, 2 * np.pi))


_KNOWN: Mapping[str, Term] = {
    "backlash": _backlash,
    "backlash_slope": _backlash_slope,
    "cyclic": _cyclic,
    "thermal_expansion": _thermal_expansion,
    "thermal_offset": _thermal_offset,
    "warm_up": _warm_up,
    "drift": _drift,
    "servo_lag": _servo_lag,
    "reversal_spike": _reversal_spike,
    "reversal_spike_time": _reversal_spike_time,
    "reversal_spike_path": _reversal_spike_path,
    "cross_axis": _cross_axis,
}
_UNKNOWN: Mapping[str, Term] = {
    "local_bump": _local_bump,
    "direction_wave": _direction_wave,
    "warm_lost_motion": _warm_lost_motion,
    "odd_step": _odd_step,
    "stick_slip": _stick_slip,
    "relaxation": _relaxation,
}
_KNOWN_OF_READINGS: Mapping[str, ReadingTerm] = {
    "laser_cosine": _laser_cosine,
    "laser_scale": _laser_scale,
    "laser_step": _laser_step,
    "reading_zero": _reading_zero,
    "reading_slope": _reading_slope,
    "ballbar_length": _ballbar_length,
    "ballbar_lobes": _ballbar_lobes,
}
_UNKNOWN_OF_READINGS: Mapping[str, ReadingTerm] = {"chatter": _chatter, "dragged_lobes": _dragged_lobes}
ON_COMPONENTS, ON_READINGS = (*_KNOWN, *_UNKNOWN), (*_KNOWN_OF_READINGS, *_UNKNOWN_OF_READINGS)
ON_POINTS = ("point_offset", "ballbar_centre")  # a point is elsewhere than the set-up says
ON_LOCATIONS = ("squareness",)  # a location error that the spec leaves out
KNOWN = (*_KNOWN, *_KNOWN_OF_READINGS, *ON_POINTS, *ON_LOCATIONS)
OUTSIDE = (*_UNKNOWN, *_UNKNOWN_OF_READINGS)
OF_RUNS = ("laser_cosine", "laser_step", "reading_zero", "reading_slope", "chatter", *ON_POINTS)
