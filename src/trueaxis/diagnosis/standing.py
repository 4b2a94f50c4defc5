"""The effects that the machine has already: their parameters are refitted, and their forms are no more exact."""

import numpy as np

from trueaxis.diagnosis.fitted import Fitted
from trueaxis.diagnosis.result import FloatArray
from trueaxis.diagnosis.signature import Readings
from trueaxis.diagnosis.signatures import parameter_signature


def standing_effects(readings: Readings) -> tuple[Fitted, ...]:
    """Those of the spec that have values, with their signals; a squareness is a location error of the base."""
    model, found = readings.model, []
    for one in model.errors.effects:
        kind = model.machine.kinds[one.effect.kind]
        if kind.place != "location":
            values = one.vector(kind)
            signal, _ = parameter_signature(readings, one.effect, values)
            found.append(
                Fitted(effect=one.effect, kind=kind, values=values, u=np.full(values.size, np.nan), signal=signal)
            )
    return tuple(found)


def refitted_columns(readings: Readings, standing: tuple[Fitted, ...]) -> FloatArray:
    """(n, k): derivatives of the readings by all of their parameters."""
    columns = [parameter_signature(readings, one.effect, one.values)[1] for one in standing]
    return np.hstack(columns) if columns else np.zeros((readings.rows.size, 0))
