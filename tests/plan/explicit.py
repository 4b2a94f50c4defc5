"""The equations of a plan made the long way: finite differences of the exact readings, all columns side by side."""

from collections.abc import Sequence

import numpy as np

from trueaxis.estimation.observations import Observations
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.curves import PolynomialCurve
from trueaxis.runtime.errors import ErrorValues
from trueaxis.runtime.model import MachineModel

STEP = 1e-4


def by_power(model: MachineModel, observed: Observations, name: str, power: int) -> FloatArray:
    """(n,): readings by (position / 100) ** power of a component, mm or rad; central difference."""

    def at(value: float) -> FloatArray:
        curve = PolynomialCurve((power,), (value / 100.0**power,))
        return readings(model, observed, ErrorValues(model.name, {}, {name: curve}))

    return (at(STEP) - at(-STEP)) / (2.0 * STEP)


def by_location(model: MachineModel, observed: Observations, name: str) -> FloatArray:
    """(n,): readings by a location error."""
    one, other = (readings(model, observed, ErrorValues(model.name, {name: value})) for value in (STEP, -STEP))
    return (one - other) / (2.0 * STEP)


def readings(model: MachineModel, observed: Observations, values: ErrorValues) -> FloatArray:
    return expected_readings(model.with_values(values), observed.runs, observed.run, observed.positions)


def design(model: MachineModel, observed: Observations, degree: int, extra: Sequence[FloatArray] = ()) -> FloatArray:
    """(n, unknowns): components by powers, location errors, then what else; columns of length one."""
    columns = [by_power(model, observed, c, k) for c in model.components for k in range(1, degree + 1)]
    columns += [by_location(model, observed, name) for name in model.location_errors]
    return np.column_stack([*columns, *extra])


def unit_columns(matrix: FloatArray) -> FloatArray:
    size = np.linalg.norm(matrix, axis=0)
    return matrix / np.where(size > 0.0, size, 1.0)


def rank(matrix: FloatArray) -> int:
    return int(np.linalg.matrix_rank(unit_columns(matrix), tol=1e-6))
