"""Effects of the kinds that a diagnosis knows, written anew and not quite as it writes them.

Each has flaws that real ones have: lost motion that is taken up over some tenths of a millimetre and varies along the
travel, a second harmonic, a structure that follows the temperature late, a lag that depends on the feed.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.hidden_effects.machine import Array, Machine
from tests.hidden_effects.state import Plan, State
from tests.hidden_effects.temperature import REFERENCE


@dataclass(frozen=True)
class Hidden:
    """size: the first parameter of the kind (width, amplitude, coefficient ...), mm, rad, s and their quotients;
    for laser_cosine the angle; for point_offset the shift along `shift`. axis: the other axis, or the shift's letter.
    component: also EC0X and the like, for a squareness. shape: seed of what the size does not say (phase, pitch ...);
    pitch: mm, of a cyclic error, where it is not drawn.
    """

    kind: str
    component: str = ""
    axis: str = ""
    runs: tuple[str, ...] = ()
    end: str = ""
    size: float = 0.0
    shift: str = ""
    shape: int = 0
    pitch: float = 0.0

    def draw(self) -> np.random.Generator:
        return np.random.default_rng([self.shape, sum(map(ord, self.kind))])


Term = Callable[[Hidden, Machine, State], Array]


def component_terms(effect: Hidden, machine: Machine, state: State) -> Array:
    """What an effect of _COMPONENT adds to its component error, (n,), mm or rad."""
    return _COMPONENT[effect.kind](effect, machine, state)


def reading_terms(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    """What an effect of _READING adds to the readings, (n,), mm.

    along: ideal displacement sensed since home, mm; theta: polar angle of a bar, rad.
    """
    return _READING[effect.kind](effect, plan, along, theta)


def _backlash(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    taken_up, waves, phase = source.uniform(0.1, 1.0), source.uniform(0.5, 1.5), source.uniform(0, 2 * np.pi)
    s = machine.share(axis, state.positions[axis])
    varied = 1.0 + 0.05 * np.sin(2 * np.pi * waves * s + phase)
    flank = 2.0 * np.tanh(state.since_reversal[axis] / taken_up) - 1.0
    return effect.size / 2 * varied * state.directions[axis] * flank


def _backlash_slope(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    s = machine.share(axis, state.positions[axis])
    bent = (s - 0.5) + source.uniform(-0.15, 0.15) * ((s - 0.5) ** 2 - 1 / 12)
    flank = 2.0 * np.tanh(state.since_reversal[axis] / source.uniform(0.1, 1.0)) - 1.0
    return effect.size * state.directions[axis] * flank * bent


def _cyclic(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    pitch = source.uniform(7.3, 21.7) if axis in "XYZ" else source.uniform(6.1, 38.3)
    first, second = source.uniform(0, 2 * np.pi, 2)
    angle = 2 * np.pi * state.positions[axis] / (effect.pitch or pitch)
    found: Array = effect.size * (np.cos(angle + first) + 0.15 * np.cos(2 * angle + second))
    return found


def _thermal_expansion(effect: Hidden, machine: Machine, state: State) -> Array:
    axis = effect.component[2]
    q = state.positions[axis]
    bent = 1.0 + 0.05 * (machine.share(axis, q) - 0.5)
    return effect.size * q * bent * (state.soaked - REFERENCE)


def _thermal_offset(effect: Hidden, machine: Machine, state: State) -> Array:
    warm = state.soaked - REFERENCE
    return effect.size * warm * (1.0 + 0.02 * warm)


def _warm_up(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    tau = source.uniform(1500.0, 6000.0)
    course = 0.9 * np.exp(-state.time / tau) + 0.1 * np.exp(-4 * state.time / tau)
    return effect.size * machine.share(axis, state.positions[axis]) * course


def _drift(effect: Hidden, machine: Machine, state: State) -> Array:
    source = effect.draw()
    period = source.uniform(2e4, 4e4)
    wave = 400.0 * np.sin(2 * np.pi * state.time / period)
    return effect.size * (state.time + wave)


def _servo_lag(effect: Hidden, machine: Machine, state: State) -> Array:
    axis = effect.component[2]
    speed = np.nan_to_num(state.feed / 60.0)
    return -effect.size * state.velocity[axis] * (1.0 - 0.05 * speed / 60.0)


def _reversal_spike(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    rise, decay = source.uniform(0.1, 0.3), source.uniform(3.0, 12.0)
    d = state.since_reversal[axis]
    faster = 1.0 + 0.1 * np.nan_to_num((state.feed - 2500.0) / 1500.0)
    with np.errstate(over="ignore"):
        return effect.size * faster * state.directions[axis] * (1.0 - np.exp(-d / rise)) * np.exp(-d / decay)


def _since_turn(axis: str, state: State) -> Array:
    """(n,), s: time since the axis turned, half a sample before it was seen to; infinite where it has not."""
    found = np.full(state.time.size, np.inf)
    for run in np.unique(state.run):
        rows = np.flatnonzero(state.run == run)
        rows = rows[np.argsort(state.seq[rows], kind="stable")]
        way, time = state.directions[axis][rows], state.time[rows]
        turned = np.inf
        for k in range(1, rows.size):
            if way[k] * way[k - 1] < 0.0:
                turned = 0.5 * (time[k] + time[k - 1])
            if np.isfinite(turned):
                found[rows[k]] = time[k] - turned
    return found


def _reversal_spike_time(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    rise, tau = source.uniform(0.01, 0.03), source.uniform(0.3, 1.5)
    passed = _since_turn(axis, state)
    return effect.size * state.directions[axis] * (1.0 - np.exp(-passed / rise)) * np.exp(-passed / tau)


def _reversal_spike_path(effect: Hidden, machine: Machine, state: State) -> Array:
    source, axis = effect.draw(), effect.component[2]
    rise, decay = source.uniform(0.1, 0.3), source.uniform(5.0, 30.0)
    passed = _since_turn(axis, state)
    known = np.isfinite(passed)
    path = np.where(known, np.where(known, passed, 0.0) * np.nan_to_num(state.feed) / 60.0, np.inf)
    return effect.size * state.directions[axis] * (1.0 - np.exp(-path / rise)) * np.exp(-path / decay)


def _cross_axis(effect: Hidden, machine: Machine, state: State) -> Array:
    axis = effect.component[2]
    s, b = machine.share(axis, state.positions[axis]), machine.share(effect.axis, state.positions[effect.axis])
    return effect.size * s * (0.95 + 0.05 * s) * (0.93 * b**2 + 0.07 * b**3)


def _laser_cosine(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    return np.where(_in_runs(effect, plan), (np.cos(effect.size) - 1.0) * along, 0.0)


def _laser_scale(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    varied = 1.0 + 0.02 * np.sin(2 * np.pi * plan.state.time / 9000.0)
    return np.where(plan.of_run("laser"), effect.size * varied * along, 0.0)


def _laser_step(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    mine = _in_runs(effect, plan)
    time = plan.state.time
    start, end = np.min(time[mine]), np.max(time[mine])
    moment = start + effect.draw().uniform(0.3, 0.7) * (end - start)
    step = 0.5 * (1.0 + np.tanh((time - moment) / 1.5))
    return np.where(mine, effect.size * step, 0.0)


def _ballbar_length(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    warmed = 1.0 + 0.02 * (plan.state.temperature - REFERENCE)
    return np.where(plan.of_run("ballbar"), effect.size * warmed, 0.0)


def _ballbar_lobes(effect: Hidden, plan: Plan, along: Array, theta: Array) -> Array:
    first, second = effect.draw().uniform(0, 2 * np.pi, 2)
    lobes = np.cos(3 * theta + first) + 0.08 * np.cos(6 * theta + second)
    return np.where(plan.of_run("ballbar"), effect.size * lobes, 0.0)


def _in_runs(effect: Hidden, plan: Plan) -> NDArray[np.bool_]:
    chosen = [index for index, run in enumerate(plan.runs) if run.id in effect.runs]
    if len(chosen) != len(effect.runs):
        raise ValueError(f"of the runs {effect.runs} some are not in the plan")
    return np.isin(plan.state.run, chosen)


_COMPONENT: Mapping[str, Term] = {
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
_READING: Mapping[str, Callable[[Hidden, Plan, Array, Array], Array]] = {
    "laser_cosine": _laser_cosine,
    "laser_scale": _laser_scale,
    "laser_step": _laser_step,
    "ballbar_length": _ballbar_length,
    "ballbar_lobes": _ballbar_lobes,
}
OF_COMPONENTS, OF_READINGS = tuple(_COMPONENT), tuple(_READING)
OF_SETUP = ("point_offset", "ballbar_centre")  # a point is elsewhere than the set-up says
OF_LOCATION = ("squareness",)  # a position error that the spec leaves out
KINDS = (*OF_COMPONENTS, *OF_READINGS, *OF_SETUP, *OF_LOCATION)
