"""What each candidate does to the readings: sensitivity of the reading times the term of the effect.

Nothing here is written for an instrument by hand: sensitivities come from the derived kernels, terms from the kernels
`effect_...`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from threading import Lock

import numpy as np

from trueaxis.diagnosis.null_model.null import Null
from trueaxis.diagnosis.null_model.roughness import Higher, higher_of
from trueaxis.diagnosis.null_model.rows import Rows, as_slice
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.first_order import sensed
from trueaxis.measurement.reading_effects import reading_context
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.model import MachineModel


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Fitted:
    """One cause with its parameters in the order of its kind; u: NaN where the readings do not tell.

    signal: (n,), mm, what it does to the readings.
    """

    effect: Effect
    kind: Kind
    values: FloatArray
    u: FloatArray
    signal: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Signature:
    """Signature of a candidate at all points of its grid: its term times the lever by which readings sense it.

    support: (n_support,), ascending, rows of the runs where it may differ from 0; terms: (t, n_points, k), per unit of
    the k linear amplitudes, shared with other candidates; place: (n_support,), which of the terms each row has, all of
    them in order where it is a slice; lever: (n_support,), mm per unit; size: the number of all rows; points: values of
    the searched parameters; missing: what the data lack for it, empty where nothing; free: how many of the amplitudes,
    the last, are of runs whose temperature is assumed; most: what amplitudes can be at all, with that standard
    deviation.
    """

    effect: Effect
    kind: Kind
    terms: FloatArray
    place: IntArray | slice
    lever: FloatArray
    support: IntArray
    size: int
    points: tuple[Mapping[str, float], ...]
    missing: str = ""
    free: int = 0
    most: float = np.inf

    def columns(self, points: slice) -> FloatArray:
        """(n_support, n_points, k), mm: those at some of the points."""
        by_point = self.terms[:, points].transpose(1, 2, 0)
        of_rows = by_point if isinstance(self.place, slice) else np.take(by_point, self.place, axis=2)
        return np.asarray((of_rows * self.lever).transpose(2, 0, 1))

    def rows_of(self, here: slice, points: slice) -> FloatArray:
        """(m, points k), mm: the columns at some of the points, of some places in the support, row by row in memory."""
        place = here if isinstance(self.place, slice) else self.place[here]
        chosen = self.terms[:, points]
        found = chosen[place].reshape(-1, chosen.shape[1] * chosen.shape[2])
        return np.asarray(found * self.lever[here, np.newaxis])

    def products(self, vectors: FloatArray) -> FloatArray:
        """(j, n_points, k): those with vectors (size, j)."""
        count, points, k = self.terms.shape
        mine = vectors[as_slice(self.support)].T * self.lever
        if not isinstance(self.place, slice):
            mine = np.stack([np.bincount(self.place, one, count) for one in mine])
        return np.asarray((mine @ self.terms.reshape(-1, points * k)).reshape(-1, points, k))

    def over_all(self, point: int = 0) -> FloatArray:
        """(size, k): the columns of one point over all rows."""
        found = np.zeros((self.size, self.terms.shape[2]))
        found[self.support] = self.columns(slice(point, point + 1))[:, 0]
        return found


@dataclass(frozen=True, slots=True, eq=False)
class Terms:
    """values: (t, points, k), each once, 0 where unknown; place: (n,), which of them each row has; known: (t,)."""

    values: FloatArray
    place: IntArray
    known: BoolArray


class Memory:
    """What need not be made again, as long as there is room: signatures of small grids, and terms.

    Terms of one kind on one axis are the same for all component errors of the axis; the last ones are kept in any case.
    Several threads may use it: what two of them make at once is the same.
    """

    ROOM = 1 << 28  # bytes

    def __init__(self) -> None:
        self._one_writes = Lock()
        self.signatures: dict[Effect, Signature] = {}
        self._left = self.ROOM
        self._terms: dict[object, Terms] = {}
        self._higher: Higher | None = None

    def higher(self, model: MachineModel, null: Null) -> Higher:
        """Degrees beyond those of the base, of the last base that was asked for."""
        kept = self._higher
        if kept is None or kept.base is not null.base:
            kept = self._higher = higher_of(model, null)
        return kept

    def keep(self, signature: Signature) -> None:
        """Keep the signature of a candidate on its whole grid, unless it would take too much of the room."""
        size = signature.terms.nbytes + signature.support.nbytes
        with self._one_writes:
            if size <= min(self._left, self.ROOM // 64):
                self.signatures[signature.effect] = signature
                self._left -= size

    def terms(self, effect: Effect, points: object) -> "Terms | None":
        """Those of a candidate at some points, or None."""
        return self._terms.get(_term_key(effect, points))

    def keep_terms(self, effect: Effect, points: object, found: "Terms") -> None:
        """Keep these, too, or instead of those before."""
        with self._one_writes:
            if found.values.nbytes + sum(one.values.nbytes for one in self._terms.values()) > self.ROOM:
                self._terms.clear()
            self._terms[_term_key(effect, points)] = found


def _term_key(effect: Effect, points: object) -> tuple[object, ...]:
    return effect.kind, effect.own_axis, effect.axis, repr(points)


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Readings:
    """What signatures are made from, of all rows: sensitivity: (n_components + n_location_errors, n)."""

    model: MachineModel
    rows: Rows
    context: Context
    reading: ReadingContext
    sensitivity: FloatArray
    memory: Memory


def readings_of(model: MachineModel, rows: Rows) -> Readings:
    """Contexts and sensitivities of the rows."""
    sensitivity = np.zeros((len(model.components) + len(model.location_errors), rows.size))
    for index in rows.present:
        mine = rows.of_run(index)
        sensitivity[:, mine] = sensed(model, rows.runs[index], np.ascontiguousarray(rows.positions[:, mine]))
    return Readings(
        model=model,
        rows=rows,
        context=rows.context,
        reading=reading_context(
            model, rows.runs, rows.run, rows.positions, rows.context.time, rows.context.temperature
        ),
        sensitivity=sensitivity,
        memory=Memory(),
    )
