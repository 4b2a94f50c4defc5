"""What each candidate does to the readings: sensitivity of the reading times the term of the effect.

Nothing here is written for an instrument by hand: sensitivities come from the derived kernels, terms from the kernels
`effect_...`.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from threading import Lock

import numpy as np

from trueaxis.diagnosis.grids import grid_of
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray
from trueaxis.diagnosis.rows import Rows, as_slice
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import concerns
from trueaxis.error_name import DISPLACEMENTS
from trueaxis.estimation.first_order import sensed
from trueaxis.estimation.jacobian import places_of
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.reading_context import reading_context_of
from trueaxis.measurement.reading_model import measuring_frame, sensed_directions
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.effect_terms import component_term, component_variables, reading_term, reading_variables, term_of
from trueaxis.model.model import MachineModel
from trueaxis.view import view_of


@dataclass(frozen=True, slots=True, eq=False)
class Signature:
    """Signature of a candidate at all points of its grid: its term times the lever by which readings sense it.

    support: (n_support,), ascending, rows of the runs where it may differ from 0; terms: (t, n_points, k), per unit of
    the k linear amplitudes, shared with other candidates; place: (n_support,), which of the terms each row has, all of
    them in order where it is a slice; lever: (n_support,), mm per unit; size: the number of all rows; points: values of
    the searched parameters; missing: what the data lack for it, empty where nothing.
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


@dataclass(frozen=True, slots=True, eq=False)
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
    return Readings(model, rows, rows.context, reading_context_of(model, rows.runs, rows), sensitivity, Memory())


def signature_of(
    readings: Readings, effect: Effect, points: tuple[Mapping[str, float], ...] | None = None
) -> Signature:
    """The signature at the points of the grid, or at other points."""
    kept = readings.memory.signatures.get(effect)
    if kept is not None and points in (None, kept.points):
        return kept
    found = _signature(
        readings, effect, grid_of(_kind(readings, effect), effect, readings.rows) if points is None else points
    )
    if points is None:
        readings.memory.keep(found)
    return found


def _kind(readings: Readings, effect: Effect) -> Kind:
    return readings.model.machine.kinds[effect.kind]


def _signature(readings: Readings, effect: Effect, points: tuple[Mapping[str, float], ...]) -> Signature:
    kind, size = _kind(readings, effect), readings.rows.size
    support = _support(readings, effect, kind)
    if kind.place == "component":
        assert effect.component is not None
        lever = readings.sensitivity[readings.model.components.index(effect.component)][support]
        found = _of_component(readings, effect, kind, points)
        place = found.place[support]
        # what the component does not reach is not spoilt by what is unknown there
        missing = "" if found.known[place[lever != 0.0]].all() else _missing(readings)
        return Signature(effect, kind, found.values, place, lever, support, size, points, missing)
    if kind.place == "reading":
        terms = _of_reading(readings, effect, kind, points, support)
    else:
        terms = (_of_point if kind.place == "point" else _of_location)(readings, effect)[support]
    missing = "" if np.isfinite(terms).all() else _missing(readings)
    terms = np.nan_to_num(terms) if missing else terms
    return Signature(effect, kind, terms, slice(None), np.ones(support.size), support, size, points, missing)


def parameter_signature(readings: Readings, effect: Effect, values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(n,) the signal of an effect with parameters (m,), mm, and (n, m) its derivatives."""
    model, rows = readings.model, readings.rows
    kind = model.machine.kinds[effect.kind]
    if kind.place == "component":
        assert effect.component is not None
        lever = readings.sensitivity[model.components.index(effect.component)]
        term = component_term(model.kernels, model.machine, effect, values, rows.positions, readings.context)
        found = np.where(lever == 0.0, 0.0, term * lever)
        return found[0], found[1:].T
    if kind.place == "reading":
        mine = np.array([concerns(kind, effect, run) for run in rows.runs])[rows.run]
        term = reading_term(model.kernels, model.machine, effect, values, readings.reading)
        found = np.where(mine, term, 0.0)
        return found[0], found[1:].T
    columns = (_of_point if kind.place == "point" else _of_location)(readings, effect)[:, 0]
    return columns @ values, columns


def basis_parameters(kind: Kind) -> tuple[dict[str, float], ...]:
    """Values of the parameters not searched on a grid, for each linear amplitude: the term there is its signature.

    Of a phase: amplitude 1 at phase 0, where the derivative by the phase is the signature of the other amplitude.
    """
    linear = [one.name for one in kind.parameters if one.role in ("linear", "root")]
    phases = [one.name for one in kind.parameters if one.role == "phase"]
    if phases:
        return ({linear[0]: 1.0, phases[0]: 0.0},)
    return tuple({other: float(name == other) for other in linear} for name in linear)


def _support(readings: Readings, effect: Effect, kind: Kind) -> IntArray:
    """Rows of the runs that the effect names, or that its component error reaches at all."""
    rows = readings.rows
    if effect.runs:
        there = [index for index in rows.present if rows.runs[index].id in effect.runs]
    elif kind.place == "component" and effect.component is not None:
        reached = readings.sensitivity[readings.model.components.index(effect.component)] != 0.0
        there = np.unique(rows.run[reached]).tolist()
    else:
        there = rows.present
    parts = [np.arange(part.start, part.stop) for part in map(rows.of_run, there)]
    return np.concatenate([np.zeros(0, dtype=np.int64), *parts])


def _vectors(kind: Kind, points: tuple[Mapping[str, float], ...]) -> list[FloatArray]:
    """Parameter vectors of the kind: for each point each basis amplitude."""
    names = [one.name for one in kind.parameters]
    return [
        np.array([{**point, **basis}.get(name, 0.0) for name in names])
        for point in points
        for basis in basis_parameters(kind)
    ]


def _columns(readings: Readings, kind: Kind, points: tuple[Mapping[str, float], ...], given: FloatArray) -> FloatArray:
    """(n, points, amplitudes): the terms of all basis amplitudes at all points, column by column in memory, as they are
    whitened. given: (v, n), what they depend on.
    """
    rows = [0, *(1 + place for place, one in enumerate(kind.parameters) if one.role == "phase")]
    vectors = _vectors(kind, points)
    found = np.empty((len(vectors), len(rows), given.shape[1]))
    for place, vector in enumerate(vectors):
        found[place] = term_of(readings.model.kernels, kind, vector, given)[rows]
    return found.reshape(len(points), -1, given.shape[1]).transpose(2, 0, 1)


def _of_component(readings: Readings, effect: Effect, kind: Kind, points: tuple[Mapping[str, float], ...]) -> Terms:
    """Over all rows, those that are alike once."""
    model, rows = readings.model, readings.rows
    found = readings.memory.terms(effect, points)
    if found is None:
        given = component_variables(model.kernels, model.machine, effect, rows.positions, readings.context)
        place = places_of(given)
        alike = np.zeros(int(place.max()) + 1, dtype=np.int64)
        alike[place] = np.arange(place.size)
        terms = _columns(readings, kind, points, given[:, alike])
        known = np.asarray(np.isfinite(terms).all(axis=(1, 2)))
        found = Terms(terms if known.all() else np.nan_to_num(terms), place, known)
        readings.memory.keep_terms(effect, points, found)
    return found


def _of_reading(
    readings: Readings, effect: Effect, kind: Kind, points: tuple[Mapping[str, float], ...], support: IntArray
) -> FloatArray:
    model, rows = readings.model, readings.rows
    mine = np.array([concerns(kind, effect, run) for run in rows.runs])[rows.run[support]]
    given = reading_variables(model.kernels, model.machine, effect, readings.reading.of(support))
    return np.where(mine[:, np.newaxis, np.newaxis], _columns(readings, kind, points, given), 0.0)


def _of_point(readings: Readings, effect: Effect) -> FloatArray:
    """What the point's coordinates change: the body that carries it is turned by its motion and by its errors."""
    model, rows = readings.model, readings.rows
    errors = model.in_context(readings.context).component_errors(rows.positions)
    columns = np.zeros((rows.size, 1, 3))
    for index in rows.present:
        run = rows.runs[index]
        if not concerns(_kind(readings, effect), effect, run):
            continue
        mine = rows.of_run(index)
        end = effect.end or ("target" if run.target.on == "workpiece" else "reference")
        positions = np.ascontiguousarray(rows.positions[:, mine])
        moved = _carried(model, run, getattr(run, end), positions, np.ascontiguousarray(errors[:, mine]))
        sign = 1.0 if end == "target" else -1.0
        sensed_part = sign * np.einsum("in,ikn->nk", sensed_directions(model, run, positions), moved)
        # the zero of a laser takes a constant away: the offset of the run does the same
        columns[mine, 0] = sensed_part if run.instrument == "ballbar" else sensed_part - sensed_part[0]
    return columns


def _carried(model: MachineModel, run: Run, point: PointOn, positions: FloatArray, errors: FloatArray) -> FloatArray:
    """(3, 3, n): by how much the actual point moves in the measuring frame for each unit of its coordinates."""
    frame = measuring_frame(run)
    if point.on == frame:
        return np.repeat(np.eye(3)[:, :, np.newaxis], positions.shape[1], axis=2)
    view = view_of(point.on, frame)
    at = [np.array(point.point)[:, np.newaxis] + offset for offset in (np.zeros((3, 1)), *np.eye(3)[:, :, np.newaxis])]
    places = [
        model.view_ideal(view, positions, one)
        + model.view_deviation_of(view, positions, errors, model.parameter_values, one)
        for one in at
    ]
    return np.stack([place - places[0] for place in places[1:]], axis=1)


def _of_location(readings: Readings, effect: Effect) -> FloatArray:
    """A rotation before the motion of a linear axis is the same rotation after it and a straightness of its slope."""
    model, rows = readings.model, readings.rows
    direction, axis = effect.error.direction, effect.error.axis
    body = model.machine.mover(axis)
    turn, along = np.zeros(3), np.zeros(3)
    turn[LINEAR.index(direction.line)] = 1.0
    along[LINEAR.index(axis)] = float(body.sense)
    slope = np.cross(turn, along)
    at = rows.positions[rows.axes.index(axis)]
    column = _sensitivity(readings, direction.motion_error(axis)).copy()
    for place, displacement in enumerate(DISPLACEMENTS):
        if slope[place]:
            column += _sensitivity(readings, displacement.motion_error(axis)) * slope[place] * at
    return column[:, np.newaxis, np.newaxis]


def _sensitivity(readings: Readings, component: str) -> FloatArray:
    components = readings.model.components
    if component not in components:
        return np.full(readings.rows.size, np.nan)
    return np.asarray(readings.sensitivity[components.index(component)])


def _missing(readings: Readings) -> str:
    lacking = [
        name
        for name, values in (
            ("time_s", readings.context.time),
            ("temperature_c", readings.context.temperature),
            ("feed", readings.context.velocity),
            ("time_s", readings.context.time_since),
        )
        if np.isnan(values).any()
    ]
    return ", ".join(dict.fromkeys(lacking)) if lacking else "motion errors that the spec leaves out"
