"""The derivative of readings by the unknowns, run by run and piece by piece."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.effects.signature import RunRows as EffectRows
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.instruments import own_columns, shared_column
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.machine import IntArray
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import home_positions
from trueaxis.measure.setup import Run

PIECE = 2**21  # entries held at a time: 16 MB


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class RunRows:
    """The readings of one run in the order in which they were taken.

    index: of the run; run: as it is set up; at: (n,), their places in the observations; positions: (n_axes, n);
    passed: (n,), share of the run's duration; steps: (n,), time since the reading before in typical steps.
    """

    index: int
    run: Run
    at: IntArray
    positions: FloatArray
    passed: FloatArray
    steps: FloatArray


def pieces(layout: Layout, rows: RunRows) -> Iterator[tuple[slice, FloatArray, FloatArray]]:
    """(rows, (m, k) by the run's own unknowns per mm or rad, (m, n) by the others per scaled unit), in order."""
    count = rows.positions.shape[1]
    longest = max(PIECE // max(layout.count, 1), 1)
    at_home = None
    run = layout.effects.set_up(rows.run)
    home = sensed_at_home(layout.model, run)
    zeroed = home_positions(rows.run, layout.model.axes)
    if zeroed is not None:
        at_home = _of_machine(layout, home, zeroed)
    for start in range(0, count, longest):
        part = slice(start, min(start + longest, count))
        positions = np.ascontiguousarray(rows.positions[:, part])
        found = np.zeros((positions.shape[1], layout.count))
        here = sensed(layout.model, run, positions)
        found[:, : layout.of_machine] = _of_machine(layout, here, positions)
        if at_home is not None:
            found[:, : layout.of_machine] -= at_home
        for place, unknown in enumerate(layout.shared, layout.of_machine):
            if rows.index in unknown.runs:
                found[:, place] = shared_column(layout.model, rows.run, unknown, positions)
        straight = layout.straightness[rows.index]
        own = own_columns(layout.model, rows.run, straight, positions, rows.passed[part])
        own[:, list(layout.silent.get(rows.index, ()))] = 0.0
        found *= layout.sizes
        if layout.effects.count:
            found[:, layout.of_effects] = layout.effects.columns(EffectRows(rows.index, rows.at[part], here, home))
        yield part, own, found


def _of_machine(layout: Layout, sensitivity: FloatArray, positions: FloatArray) -> FloatArray:
    """(n, of_machine) from sensitivities (n_components + n_location_errors, n)."""
    model = layout.model
    found = np.empty((positions.shape[1], layout.of_machine))
    offsets = layout.offsets
    cache: dict[tuple[int, object], FloatArray] = {}
    for name, basis, first in zip(layout.components, layout.bases, offsets.tolist(), strict=False):
        axis = model.axes.index(name[2])
        if (axis, basis) not in cache:
            cache[axis, basis] = basis.clamped(positions[axis])
        found[:, first : first + basis.degree] = (sensitivity[model.components.index(name)] * cache[axis, basis]).T
    start = len(model.components)
    rows = [start + model.location_errors.index(name) for name in layout.locations]
    found[:, offsets[-1] :] = sensitivity[rows].T
    return found
