"""Signatures of what a diagnosis may take an effect for: forms as docs/effects.md states them, at points of a grid.

These are rivals, and serve the limits alone; the effects that worlds hide (effects.py) have other, imperfect forms.
What the flat unknowns of instruments imitate anyhow (a scale, a cosine, a length, a centre) is no rival.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tests.hidden_effects.power.grade import Name
from tests.worlds.design import Design
from tests.worlds.effects import WARM, State
from tests.worlds.machine import LINEAR, Array
from tests.worlds.readings import home_state, reading_context, row_state

TAUS = (600.0, 1500.0, 3000.0, 6000.0, 15000.0)  # s, of a warm-up
DECAYS = (1.0, 2.5, 5.0, 10.0, 25.0)  # mm or deg, of a spike
TIMES = (0.05, 0.15, 0.4, 1.0)  # s, of a spike
PITCHES = {"linear": (7.0, 22.0), "rotary": (6.0, 40.0)}  # mm, deg
PITCHES_TRIED = 6
NEEDS = {  # column without which nobody can know a kind
    "thermal_expansion": "temperature_c",
    "thermal_offset": "temperature_c",
    "warm_up": "time_s",
    "drift": "time_s",
    "laser_step": "time_s",
    "servo_lag": "feed",
    "reversal_spike_time": "feed",
}
ALONG = ("thermal_expansion", "warm_up", "servo_lag", "reversal_spike", "reversal_spike_time", "reversal_spike_path")
NOT_TURNS = ("cyclic",)  # along and across; all else turns as well


@dataclass(frozen=True, eq=False)
class Candidate:
    """columns: (n, k), mm per unit, at one point of the grid of its searched parameters."""

    name: Name
    columns: Array


def may_act_on(kind: str, component: str) -> bool:
    """Whether a kind may act on a component error, such as EXX."""
    along = component[1] == component[2]
    if kind in ALONG:
        return along
    return kind not in NOT_TURNS or along or component[1] in LINEAR


def candidates(design: Design, pitch: float = 0.0) -> Iterator[Candidate]:
    """Every candidate of the library at every point; with a pitch, mm or deg, cyclic ones of that pitch alone."""
    rows, homes = row_state(design.machine, design.plan), home_state(design.machine, design.plan)
    jac, run = design.jacobian, design.plan.run
    for component in design.machine.components:
        if not np.any(jac.here[component]):
            continue
        there = zip(_terms(design, component, rows, pitch), _terms(design, component, homes, pitch), strict=True)
        for (name, term), (_, term_home) in there:
            here, home = jac.here[component][:, None], jac.home[component][:, None]
            yield Candidate(name, here * term - home * term_home[run])
    _, theta = reading_context(design.machine, design.plan)
    if np.any(theta) and not pitch:
        bars = (theta != 0.0)[:, None]
        yield Candidate(Name("ballbar_lobes"), bars * np.column_stack([np.cos(3 * theta), np.sin(3 * theta)]))


def _terms(design: Design, component: str, state: State, pitch: float) -> Iterator[tuple[Name, Array]]:
    """Name and term, (n, k), of every kind that acts on a component."""
    for kind, term in _forms(design, component, state, pitch):
        needed = NEEDS.get(kind)
        if may_act_on(kind, component) and (needed is None or needed in design.columns):
            yield Name(kind, component), term
    s = design.machine.share(component[2], state.positions[component[2]])
    for axis in design.machine.axes if not pitch else ():
        if axis != component[2]:
            other = design.machine.share(axis, state.positions[axis])
            yield Name("cross_axis", component, axis), _column(s * other**2)


def _forms(design: Design, component: str, state: State, pitch: float) -> Iterator[tuple[str, Array]]:
    axis = component[2]
    low, high = PITCHES["linear" if axis in LINEAR else "rotary"]
    for each in [pitch] if pitch else np.geomspace(low, high, PITCHES_TRIED).tolist():
        angle = 2 * np.pi * state.positions[axis] / each
        yield "cyclic", np.column_stack([np.cos(angle), np.sin(angle)])
    if pitch:
        return
    q, way, since = state.positions[axis], state.directions[axis], state.since[axis]
    s, warm = design.machine.share(axis, q), _air(design, state) - WARM
    yield "backlash", _column(way / 2)
    yield "backlash_slope", _column(way * (s - 0.5))
    yield "thermal_expansion", _column(q * warm)
    yield "thermal_offset", _column(warm)
    yield "drift", _column(state.time)
    yield "servo_lag", _column(-state.velocity[axis])
    for tau in TAUS:
        yield "warm_up", _column(s * np.exp(-state.time / tau))
    for decay in DECAYS:
        yield "reversal_spike", _column(way * np.exp(-since / decay))
    speed = np.nan_to_num(state.feed) / 60.0
    passed = np.divide(since, speed, out=np.full_like(since, np.inf), where=(speed > 0) & np.isfinite(since))
    for tau in TIMES:
        yield "reversal_spike_time", _column(way * np.exp(-passed / tau))


def _air(design: Design, state: State) -> Array:
    """What a thermometer shows at these rows; of homes, when their run began."""
    if state.time.size == design.plan.count:
        return design.plan.temperature
    return np.array([design.plan.temperature[design.plan.rows(k)[0]] for k in range(len(design.plan.runs))])


def _column(values: Array) -> Array:
    return np.asarray(values, float)[:, None]
