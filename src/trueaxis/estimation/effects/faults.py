"""Effects that the readings lack the columns for."""

from collections.abc import Sequence

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.signature import Ground, RunRows, is_in
from trueaxis.faults import Faults
from trueaxis.runtime.context import FloatArray
from trueaxis.runtime.effect_terms import component_axis, context_variables

COLUMNS = {"t": "time_s", "T": "temperature_c", "v": "feed"}


def check_columns(ground: Ground, effects: Sequence[tuple[Effect, Kind]], chosen: Sequence[RunRows]) -> None:
    """Raise InputError where readings that an effect is in lack what it depends on: time, temperature or feed."""
    faults = Faults(ground.observed.source)
    needed: dict[str, list[str]] = {}
    for effect, kind in effects:
        for column in _missing(ground, effect, kind, chosen):
            needed.setdefault(column, []).append(effect.label)
    for column, labels in needed.items():
        remedy = f"a value in every row of the runs that hold {'it' if len(labels) == 1 else 'them'}"
        faults.add(f"column {column}", f"is missing or has gaps, and {', '.join(labels)} cannot do without", remedy)
    faults.raise_if_any()


def _missing(ground: Ground, effect: Effect, kind: Kind, chosen: Sequence[RunRows]) -> list[str]:
    if not kind.expression:
        return []
    found = []
    for name in context_variables(ground.model.kernels, kind.name):
        column = COLUMNS.get(name.removesuffix("_b"))
        if column and any(_unknown(ground, effect, kind, name, rows) for rows in chosen):
            found.append(column)
    return list(dict.fromkeys(found))


def _unknown(ground: Ground, effect: Effect, kind: Kind, name: str, chosen: RunRows) -> bool:
    """Whether a reading of these rows holds the effect, and what the variable is of is not known there."""
    run = ground.observed.runs[chosen.index]
    if not is_in(effect, kind, run):
        return False
    missing = ~np.isfinite(_values(ground, effect, name)[chosen.rows])
    if kind.place == "component":
        lever = ground.model.components.index(effect.component or "")
        missing &= (chosen.here[lever] != 0.0) | (chosen.home[lever] != 0.0)
    return bool(missing.any())


def _values(ground: Ground, effect: Effect, name: str) -> FloatArray:
    if name == "t":
        return ground.context.time
    if name == "T":
        return ground.context.temperature
    axis = effect.axis if name.endswith("_b") else component_axis(effect)
    row: FloatArray = ground.context.velocity[ground.model.axes.index(axis or "")]
    return row
