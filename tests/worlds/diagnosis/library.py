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

PITCHES = {"linear": (7.0, 22.0), "rotary": (6.0, 40.0)}  # mm, deg
PITCHES_TRIED, FINE = 6, 25
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
SEARCHED = ("warm_up", "reversal_spike", "reversal_spike_time", "reversal_spike_path")  # with a decay that is sought
NOT_TURNS = ("cyclic",)  # along and across; all else turns as well


@dataclass(frozen=True, eq=False)
class Candidate:
    """columns: (n, k), mm per unit, at one point of the grid of its searched parameters."""

    name: Name
    columns: Array


@dataclass(frozen=True)
class Search:
    """Points of searched parameters: pitches: mm or deg, some of each axis where there are none here; taus: s, of a
    warm-up; decays: mm or deg, times: s, of spikes; only: the one candidate that is wanted.
    """

    pitches: tuple[float, ...] = ()
    taus: tuple[float, ...] = (600.0, 1500.0, 3000.0, 6000.0, 15000.0)
    decays: tuple[float, ...] = (1.0, 2.5, 5.0, 10.0, 25.0)
    times: tuple[float, ...] = (0.05, 0.15, 0.4, 1.0)
    only: Name | None = None


COARSE = Search()


def fine(name: Name, pitch: float) -> Search:
    """One candidate, as finely as a diagnosis may search."""
    pitches = tuple(pitch * np.linspace(0.99, 1.01, 5)) if pitch else ()
    taus, decays, times = (tuple(np.geomspace(*ends, FINE)) for ends in ((400.0, 2e4), (0.5, 40.0), (0.03, 2.0)))
    return Search(pitches, taus, decays, times, name)


def may_act_on(kind: str, component: str) -> bool:
    """Whether a kind may act on a component error, such as EXX."""
    along = component[1] == component[2]
    if kind in ALONG:
        return along
    return kind not in NOT_TURNS or along or component[1] in LINEAR


def candidates(design: Design, search: Search = COARSE) -> Iterator[Candidate]:
    """Every candidate of the library at every point."""
    rows, homes = row_state(design.machine, design.plan), home_state(design.machine, design.plan)
    jac, run, only = design.jacobian, design.plan.run, search.only
    for component in design.machine.components:
        if not np.any(jac.here[component]) or (only is not None and only.component != component):
            continue
        there = zip(_terms(design, component, rows, search), _terms(design, component, homes, search), strict=True)
        for (name, term), (_, term_home) in there:
            if only in (None, name):
                here, home = jac.here[component][:, None], jac.home[component][:, None]
                yield Candidate(name, here * term - home * term_home[run])
    yield from _lobes(design, only)
    yield from _steps(design, only)


def _lobes(design: Design, only: Name | None) -> Iterator[Candidate]:
    name = Name("ballbar_lobes")
    _, theta = reading_context(design.machine, design.plan)
    if np.any(theta) and only in (None, name):
        bars = (theta != 0.0)[:, None]
        yield Candidate(name, bars * np.column_stack([np.cos(3 * theta), np.sin(3 * theta)]))


def _steps(design: Design, only: Name | None) -> Iterator[Candidate]:
    """A step of one run between every two readings; only where it is asked for: no other effect is like it."""
    if only is None or only.kind != "laser_step":
        return
    rows = np.flatnonzero(np.array([run.id in only.runs for run in design.plan.runs])[design.plan.run])
    for start in range(1, len(rows)):
        columns = np.zeros((design.plan.count, 1))
        columns[rows[start:]] = 1.0
        yield Candidate(only, columns)


def _terms(design: Design, component: str, state: State, search: Search) -> Iterator[tuple[Name, Array]]:
    """Name and term, (n, k), of every kind that acts on a component."""
    for kind, term in (*_cyclic(component, state, search), *_forms(design, component, state, search)):
        needed = NEEDS.get(kind)
        wanted = search.only is not None or needed is None or needed in design.columns
        if may_act_on(kind, component) and wanted:
            yield Name(kind, component), term
    s = design.machine.share(component[2], state.positions[component[2]])
    for axis in design.machine.axes:
        if axis != component[2]:
            other = design.machine.share(axis, state.positions[axis])
            yield Name("cross_axis", component, axis), _column(s * other**2)


def _cyclic(component: str, state: State, search: Search) -> Iterator[tuple[str, Array]]:
    axis = component[2]
    some = np.geomspace(*PITCHES["linear" if axis in LINEAR else "rotary"], PITCHES_TRIED)
    for pitch in search.pitches or some:
        angle = 2 * np.pi * state.positions[axis] / pitch
        yield "cyclic", np.column_stack([np.cos(angle), np.sin(angle)])


def _forms(design: Design, component: str, state: State, search: Search) -> Iterator[tuple[str, Array]]:
    axis = component[2]
    q, way, since = state.positions[axis], state.directions[axis], state.since[axis]
    s, warm = design.machine.share(axis, q), _air(design, state) - WARM
    yield "backlash", _column(way / 2)
    yield "backlash_slope", _column(way * (s - 0.5))
    yield "thermal_expansion", _column(q * warm)
    yield "thermal_offset", _column(warm)
    yield "drift", _column(state.time)
    yield "servo_lag", _column(-state.velocity[axis])
    for tau in search.taus:
        yield "warm_up", _column(s * np.exp(-state.time / tau))
    for decay in search.decays:
        yield "reversal_spike", _column(way * np.exp(-since / decay))
    for tau in search.times:
        yield "reversal_spike_time", _column(way * np.exp(-state.turned[axis] / tau))
    for decay in search.decays:
        yield "reversal_spike_path", _column(way * np.exp(-state.path[axis] / decay))


def _air(design: Design, state: State) -> Array:
    """What a thermometer shows at these rows; of homes, when their run began."""
    if state.time.size == design.plan.count:
        return design.plan.temperature
    return np.array([design.plan.temperature[design.plan.rows(k)[0]] for k in range(len(design.plan.runs))])


def _column(values: Array) -> Array:
    return np.asarray(values, float)[:, None]
