"""Effects that the readings lack the columns for."""

from collections.abc import Sequence

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import concerns, used_variables
from trueaxis.estimation.effects.signature import Ground, RunRows
from trueaxis.io.faults import Faults
from trueaxis.model.context import FloatArray

COLUMNS = {"t": "time_s", "T": "temperature_c", "v": "feed", "d_time": "time_s (or, by ball bar, feed)"}


def check_columns(ground: Ground, effects: Sequence[tuple[Effect, Kind]], chosen: Sequence[RunRows]) -> None:
    """Raise InputError where readings that an effect is in lack what it depends on: time, temperature or feed."""
    faults = Faults(ground.observed.source)
    needed: dict[str, list[str]] = {}
    for effect, kind in effects:
        for column in missing_columns(ground, effect, kind, chosen):
            needed.setdefault(column, []).append(effect.label)
    for column, labels in needed.items():
        remedy = f"a value in every row of the runs that hold {'it' if len(labels) == 1 else 'them'}"
        faults.add(f"column {column}", f"is missing or has gaps, and {', '.join(labels)} cannot do without", remedy)
    faults.raise_if_any()


def missing_columns(ground: Ground, effect: Effect, kind: Kind, chosen: Sequence[RunRows]) -> list[str]:
    """Columns that an effect depends on and that readings which hold it lack."""
    found = []
    for name in used_variables(kind):
        column = COLUMNS.get(name.removesuffix("_b"))
        if column and any(_unknown(ground, effect, kind, name, rows) for rows in chosen):
            found.append(column)
    return list(dict.fromkeys(found))


def _unknown(ground: Ground, effect: Effect, kind: Kind, name: str, chosen: RunRows) -> bool:
    """Whether a reading of these rows holds the effect, and what the variable is of is not known there."""
    run = ground.observed.runs[chosen.index]
    if not concerns(kind, effect, run):
        return False
    missing = np.isnan(_values(ground, effect, name)[chosen.rows])
    if kind.place == "component":
        lever = ground.model.components.index(effect.component or "")
        missing &= (chosen.here[lever] != 0.0) | (chosen.home[lever] != 0.0)
    return bool(missing.any())


def _values(ground: Ground, effect: Effect, name: str) -> FloatArray:
    if name == "t":
        return ground.context.time
    if name == "T":
        return ground.context.temperature
    axis = effect.axis if name.endswith("_b") else effect.own_axis
    of_axes = ground.context.time_since if name.removesuffix("_b") == "d_time" else ground.context.velocity
    row: FloatArray = of_axes[ground.model.axes.index(axis or "")]
    return row
