"""Data spoilt on purpose: what was named in the sound data must not be named in these."""

from dataclasses import replace

import numpy as np

from tests.hidden_effects.data import Data


def tampered(how: str, data: Data, source: np.random.Generator) -> Data:
    """`swap_directions`: every axis has the approach directions of the next; `shuffle_time`: time and temperature of
    the readings in any order. Raises ValueError for anything else that is not empty.
    """
    state = data.plan.state
    if how == "swap_directions":
        axes = data.machine.linear
        swapped = {a: state.directions[b] for a, b in zip(axes, (*axes[1:], axes[0]), strict=True)}
        state = replace(state, directions=dict(state.directions) | swapped)
        return replace(data, plan=replace(data.plan, state=state))
    if how == "shuffle_time":
        order = source.permutation(len(state.time))
        state = replace(state, time=state.time[order], temperature=state.temperature[order])
        return replace(data, plan=replace(data.plan, state=state), thermometer=data.thermometer[order])
    if how:
        raise ValueError(f"{how} is no way to tamper with data")
    return data
