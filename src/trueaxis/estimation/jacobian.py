"""The derivative of readings by the unknowns, run by run and piece by piece."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.effects.signature import RunRows as EffectRows
from trueaxis.estimation.factors import common, few_of
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.instruments import own_columns, shared_column
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.machine import IntArray
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_model import home_positions
from trueaxis.measurement.setup import Run

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


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Derivative:
    """Of m readings of a run. own: (m, k), by the run's own unknowns, per mm or rad; few: (u, r), in which the readings
    at the u places where they were taken change, orthonormal over the run but for those of effects; place: (m,), that
    of each reading; others: (r, n), by the other unknowns, per scaled unit; of_run: whether the few are those of all
    pieces of the run.
    """

    own: FloatArray
    few: FloatArray
    place: IntArray
    others: FloatArray
    of_run: bool = False

    @property
    def by_few(self) -> FloatArray:
        """(m, r)."""
        return self.few[self.place]

    @property
    def by_others(self) -> FloatArray:
        """(m, n)."""
        return np.asarray(self.by_few @ self.others)

    def change(self, own: FloatArray, others: FloatArray) -> FloatArray:
        """(m, ...): of the readings, by own unknowns (k, ...), mm or rad, and the others, scaled, (n, ...)."""
        return np.asarray((self.few @ (self.others @ others))[self.place] + self.own @ own)

    def of(self, rows: BoolArray) -> "Derivative":
        """Of some readings."""
        return self if rows.all() else replace(self, own=self.own[rows], place=self.place[rows])


def derivatives(layout: Layout, rows: RunRows) -> Iterator[Derivative]:
    """Of the readings of a run, piece by piece in their order."""
    return beside_effects(layout, rows, without_effects(layout, rows))


def without_effects(layout: Layout, rows: RunRows) -> Iterator[Derivative]:
    """As if none of the effects changed a reading: the same at all their values, but for those that move points."""
    count = rows.positions.shape[1]
    longest = max(PIECE // max(layout.count, 1), 1)
    run = layout.effects.set_up(rows.run)
    zeroed = home_positions(rows.run, layout.model.axes)
    at_home = np.zeros((1, layout.count))
    if zeroed is not None:
        _of_machine(layout, sensed_at_home(layout.model, run), zeroed, at_home)
    for start in range(0, count, longest):
        part = slice(start, min(start + longest, count))
        positions = np.ascontiguousarray(rows.positions[:, part])
        straight = layout.straightness[rows.index]
        own = own_columns(layout.model, rows.run, straight, positions, rows.passed[part])
        own[:, list(layout.silent.get(rows.index, ()))] = 0.0
        place = places_of(positions)
        first = np.zeros(int(place.max()) + 1, dtype=np.int64)
        first[place[::-1]] = np.arange(place.size)[::-1]
        positions = np.ascontiguousarray(positions[:, first])
        found = np.zeros((layout.count, positions.shape[1])).T  # column by column in memory, as LAPACK has it
        _of_machine(layout, sensed(layout.model, run, positions), positions, found)
        if zeroed is not None:
            found -= at_home
        for column, unknown in enumerate(layout.shared, layout.of_machine):
            if rows.index in unknown.runs:
                found[:, column] = layout.sizes[column] * shared_column(layout.model, rows.run, unknown, positions)
        few, others = few_of(found)
        yield Derivative(own=own, few=few, place=place, others=others)


def beside_effects(layout: Layout, rows: RunRows, parts: Iterable[Derivative]) -> Iterator[Derivative]:
    """Those of a run without effects, with the columns of the effects at their values."""
    if not layout.effects.count:
        yield from parts
        return
    run = layout.effects.set_up(rows.run)
    home = sensed_at_home(layout.model, run)
    each = np.eye(layout.effects.count, layout.count, layout.of_effects.start)
    start = 0
    for one in parts:
        part = slice(start, start + one.place.size)
        start = part.stop
        here = sensed(layout.model, run, np.ascontiguousarray(rows.positions[:, part]))
        # effects depend on more than on where the axes are
        columns = layout.effects.columns(EffectRows(rows.index, rows.at[part], here, home))
        acting = columns.any(axis=0) | one.of_run
        yield replace(
            one,
            few=np.hstack([one.by_few, columns[:, acting]]),
            place=np.arange(one.place.size),
            others=np.vstack([one.others, each[acting]]),
        )


def with_common_few(parts: Sequence[Derivative]) -> tuple[Derivative, ...]:
    """The pieces of a run as combinations of the same few."""
    if len(parts) < 2:
        return tuple(parts)
    turned, others = common([one.others for one in parts])
    return tuple(
        replace(one, few=one.few @ by, others=others, of_run=True) for one, by in zip(parts, turned, strict=True)
    )


def pieces(layout: Layout, rows: RunRows) -> Iterator[tuple[slice, FloatArray, FloatArray]]:
    """(rows, (m, k) by the run's own unknowns per mm or rad, (m, n) by the others per scaled unit), in order."""
    start = 0
    for one in derivatives(layout, rows):
        part = slice(start, start + one.place.size)
        yield part, one.own, one.by_others
        start = part.stop


def places_of(positions: FloatArray) -> IntArray:
    """(m,): the same number for the same positions (n_axes, m); in the order of the positions."""
    order = np.lexsort(positions)
    new = (np.diff(positions[:, order]) != 0.0).any(axis=0)
    if new.all():
        return np.arange(order.size)
    place = np.empty(order.size, dtype=np.int64)
    place[order] = np.concatenate([[0], np.cumsum(new)])
    return place


def _of_machine(layout: Layout, sensitivity: FloatArray, positions: FloatArray, into: FloatArray) -> None:
    """Columns (n, of_machine), the first of `into`, from sensitivities (n_components + n_location_errors, n)."""
    model = layout.model
    offsets = layout.offsets
    cache: dict[tuple[int, object], FloatArray] = {}
    for name, basis, first in zip(layout.components, layout.bases, offsets.tolist(), strict=False):
        axis = model.axes.index(name.axis)
        if (axis, basis) not in cache:
            at = positions[axis]
            cache[axis, basis] = basis(at[:1] if (at == at[0]).all() else at)  # most axes of a line stand
        scaled = sensitivity[model.components.index(name)] * layout.sizes[first]
        np.multiply(scaled, cache[axis, basis], out=into.T[first : first + basis.count])
    start = len(model.components)
    rows = [start + model.location_errors.index(name) for name in layout.locations]
    into[:, offsets[-1] : layout.of_machine] = sensitivity[rows].T * layout.sizes[offsets[-1] : layout.of_machine]
