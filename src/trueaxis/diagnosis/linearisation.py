"""What a first-order model would drop: terms of second order in the errors given, as the readings would show them."""

from typing import cast

import numpy as np

from trueaxis.diagnosis.audit import DETECTION
from trueaxis.diagnosis.result import FloatArray, SecondOrder
from trueaxis.diagnosis.search import Ground
from trueaxis.diagnosis.signature import Readings
from trueaxis.measurement.reading_geometry import column, sensed_points


def second_order_of(ground: Ground) -> SecondOrder:
    """How large the terms are, and whether these readings could show them at all."""
    terms = second_order(ground.readings)
    left = ground.base.rest(ground.whitening(terms))
    return SecondOrder(float(np.abs(terms).max(initial=0.0)), float(left @ left) > DETECTION)


def second_order(readings: Readings) -> FloatArray:
    """(n,), mm: exact less first-order deviations of the model as given, along what each instrument senses."""
    model, rows = readings.model, readings.rows
    errors = model.in_context(readings.context).component_errors(rows.positions)
    found = np.zeros(rows.size)
    for index in rows.present:
        run, mine = rows.runs[index], rows.of_run(index)
        positions = np.ascontiguousarray(rows.positions[:, mine])
        along = np.zeros(positions.shape[1])
        for one in sensed_points(model, run, positions):
            inputs = (positions, np.ascontiguousarray(errors[:, mine]), model.parameter_values, column(one.point))
            exact = model.kernels[f"{one.view}_deviation"](*inputs)
            dropped = exact - model.kernels[f"{one.view}_deviation_first_order"](*inputs)
            along += np.einsum("in,in->n", one.direction, dropped)
        found[mine] = along if run.instrument == "ballbar" else along - along[0]
    return cast(FloatArray, found)
