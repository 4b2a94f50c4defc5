"""What each candidate does to the readings: sensitivity of the reading times the term of the effect.

Nothing here is written for an instrument by hand: sensitivities come from the derived kernels, terms from the kernels
`effect_...`.
"""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trueaxis.diagnosis.causes.candidates import grid_of
from trueaxis.diagnosis.causes.largest import extent, most_of_component
from trueaxis.diagnosis.causes.signature import Fitted, Memory, Readings, Signature, Terms
from trueaxis.diagnosis.null_model.temperature import warmer
from trueaxis.diagnosis.result import FloatArray, IntArray
from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import concerns, used_variables
from trueaxis.error_name import DISPLACEMENTS, ErrorName
from trueaxis.estimation.jacobian import places_of
from trueaxis.machine.machine import LINEAR
from trueaxis.measurement.reading_model import measuring_frame, sensed_directions
from trueaxis.measurement.setup import PointOn, Run
from trueaxis.model.effect_terms import component_term, component_variables, reading_term, reading_variables, term_of
from trueaxis.model.model import MachineModel
from trueaxis.view import view_of


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
        signature = Signature(
            effect=effect,
            kind=kind,
            terms=found.values,
            place=place,
            lever=lever,
            support=support,
            size=size,
            points=points,
            missing=missing,
            most=most_of_component(readings.model, ErrorName(effect.component), kind),
        )
        return _with_free_runs(readings, signature)
    if kind.place == "reading":
        terms = _of_reading(readings, effect, kind, points, support)
    else:
        terms = (_of_point if kind.place == "point" else _of_location)(readings, effect)[support]
    missing = "" if np.isfinite(terms).all() else _missing(readings)
    terms = np.nan_to_num(terms) if missing else terms
    return Signature(
        effect=effect,
        kind=kind,
        terms=terms,
        place=slice(None),
        lever=np.ones(support.size),
        support=support,
        size=size,
        points=points,
        missing=missing,
        most=extent(readings.model) if kind.place == "point" else np.inf,
    )


def _with_free_runs(readings: Readings, signature: Signature) -> Signature:
    """With an amplitude more for each run whose temperature is assumed: what it changes there if that is another.

    So an effect that follows the temperature is told by the runs that have one.
    """
    rows, kind, support = readings.rows, signature.kind, signature.support
    linear = all(one.role in ("linear", "grid") for one in kind.parameters)
    if "T" not in used_variables(kind) or not linear:
        return signature
    run = rows.run[support]
    free = np.unique(run[rows.assumed[support]])
    if not free.size:
        return signature
    changed = replace(readings, context=warmer(readings.context), memory=Memory())
    found = _of_component(changed, signature.effect, kind, signature.points)
    terms = signature.terms[signature.place]
    change = (found.values[found.place[support]] - terms)[:, :, :1]
    of_runs = change * (run[:, np.newaxis] == free)[:, np.newaxis, :]
    return replace(signature, terms=np.concatenate([terms, of_runs], axis=2), place=slice(None), free=free.size)


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


def directions_of(readings: Readings, cause: Fitted) -> list[FloatArray]:
    """(n,) each: by what the readings change with each parameter of a cause, where they do."""
    _, derivatives = parameter_signature(readings, cause.effect, cause.values)
    return [column for column in derivatives.T if column.any()]


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
