"""How uncertain the tool point is with given error values: JCGM 100:2008, 5.2, and what nothing determines.

The deviation is a first-order function of the error values within their size squared, so that u^2 of each coordinate is
J C J' with J its derivative by the values and C their covariance.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from trueaxis.effects.kind import Effect
from trueaxis.io.faults import Fault, InputError
from trueaxis.machine.machine import Machine
from trueaxis.model.best_fit import Placements
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance, digest_of_numbers, digest_of_values
from trueaxis.model.covariance_file import read_covariance
from trueaxis.model.curves import FloatArray
from trueaxis.model.effect_terms import component_term
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel, home_of
from trueaxis.model.own_uncertainty import own_uncertainty

OPEN_MOVES = 1e-6  # mm: what an undetermined combination of the prior's size moves the tool by before it counts
_ENTRIES = 4_000_000  # of the derivatives held at a time: 32 MB
_SAMPLES = 65  # positions of a travel at which the size of a curve is judged


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ToolUncertainty:
    """Of n tool points in the workpiece frame, mm.

    u: (3, n), standard uncertainty, NaN where it is not known or where `open` is not zero; u_prior: (3, n), the part of
    it that rests on the prior, NaN also where the parts are not known; the other part is that of the readings, and the
    squares of both add up to that of u. open: (3, n), by how much
    combinations that nothing determines move the point at the size that the prior allows, 0 where they do not.
    u_usual: (3, n), u by the usual sizes of instrument unknowns, where a covariance by these stands beside that by the
    sizes that readings make likely, by which `u` is; else None.
    """

    u: FloatArray
    u_prior: FloatArray
    open: FloatArray
    u_usual: FloatArray | None = None


def covariance_file(path: Path, errors: ErrorValues) -> Path | None:
    """The covariance file that error values read from `path` name."""
    return None if errors.covariance is None else path.parent / errors.covariance.file


def load_uncertainty(path: Path, errors: ErrorValues, machine: Machine, file: Path | None = None) -> Covariance:
    """What is known of the uncertainty of error values read from `path`.

    From `file` if given, else from the covariance file that the values name; where they name none, from their own
    standard uncertainties, as if these were independent. Raises InputError where the file is not of these values.
    """
    linked = covariance_file(path, errors)
    if file is None and linked is None:
        return own_uncertainty(machine, errors)
    found = file or linked or Path()
    if file is None and not found.exists():
        problem = f"{found}, the covariance of these values, is not there"
        raise InputError([Fault(str(path), "covariance", problem, "copy it as well, or remove the key covariance")])
    covariance = read_covariance(found, machine)
    if covariance.sha256_of_values not in (digest_of_values(errors), digest_of_numbers(errors)):
        problem = (
            f"{found} is the covariance of other values: these, or how they were judged (fit, determined, "
            "undetermined, measured), were edited, or it was written again since"
        )
        raise InputError(
            [Fault(str(path), "covariance", problem, "identify again: edited values have no uncertainty of their own")]
        )
    return covariance


def tool_uncertainty(
    model: MachineModel,
    covariance: Covariance,
    positions: FloatArray,
    tool: FloatArray,
    *,
    datum: FloatArray | Placements | None,
    context: Context | None = None,
) -> ToolUncertainty:
    """Uncertainty of the deviation of tool points.

    positions: (n_axes, n), mm or deg; tool: (3, 1) or (3, n), mm; datum: (n_axes, 1), the position at which the
    deviation is taken as zero (work offsets are touched off there with the same tool); or the placements of a workpiece
    with these points, the best fit of which is taken off; None: none. Without a datum what is open is judged by how it
    moves the point from where the origin of the tool frame is at home: a squareness that is a convention tilts the
    tool, and a longer tool shows that. context: of the positions, which effects depend on; None: axes stand and have
    not moved. Memory is bounded whatever n is.
    """
    n = positions.shape[1]
    known = [covariance] if covariance.usual is None else [covariance, covariance.usual]
    u, u_prior, opened = np.full((len(known), 3, n), np.nan), np.full((len(known), 3, n), np.nan), np.zeros((3, n))
    steps = open_steps(model.machine, covariance)
    columns = max(0 if one.root is None else int(one.root.shape[1]) for one in known)
    pieces = list(_pieces(n, max(covariance.count, columns, steps.shape[1])))

    def by_values(rows: slice) -> FloatArray:
        here, at = _of(tool, rows), np.ascontiguousarray(positions[:, rows])
        return derivative(model, covariance, at, here, None if context is None else context.of(rows))

    common = np.zeros((0, covariance.count))
    if isinstance(datum, Placements):
        common = np.zeros((datum.directions.shape[2], covariance.count))
        for rows in pieces:
            common += np.einsum("inr,ikn->rk", datum.directions[:, rows], by_values(rows))
    for rows in pieces:
        by_value = by_values(rows)
        if datum is None:
            moved = _rows(by_value - derivative(model, covariance, home_of(model), np.zeros((3, 1))))
        elif isinstance(datum, Placements):
            by_value = by_value - np.einsum("inr,rk->ikn", datum.directions[:, rows], common)
            moved = _rows(by_value)
        else:
            here = _of(tool, rows)
            by_value = by_value - derivative(model, covariance, _as_many(datum, here), here)
            moved = _rows(by_value)
        opened[:, rows] = np.abs(moved @ steps).max(axis=1, initial=0.0).reshape(3, -1)
        for place, one in enumerate(known):
            u[place, :, rows], u_prior[place, :, rows] = _u_and_prior(_rows(by_value), one)
    opened[opened <= OPEN_MOVES] = 0.0
    u[:, opened > 0.0] = u_prior[:, opened > 0.0] = np.nan
    return ToolUncertainty(u=u[0], u_prior=u_prior[0], open=opened, u_usual=None if covariance.usual is None else u[-1])


def _u_and_prior(by_value: FloatArray, covariance: Covariance) -> tuple[FloatArray, FloatArray]:
    """(3, m) each: u of tool points and the prior's part of it, NaN where not known; by_value: (3 m, n_values)."""
    unknown = np.full((3, by_value.shape[0] // 3), np.nan)
    if covariance.root is None:
        return unknown, unknown
    squares = (by_value @ covariance.root) ** 2
    u = np.sqrt(squares.sum(axis=1)).reshape(3, -1)
    if covariance.of_prior is None:
        return u, unknown
    return u, np.sqrt(squares[:, squares.shape[1] - covariance.of_prior :].sum(axis=1)).reshape(3, -1)


def _of(tool: FloatArray, rows: slice) -> FloatArray:
    """The tool points of some positions: (3, 1) stays one for all."""
    return tool if tool.shape[1] == 1 else np.ascontiguousarray(tool[:, rows])


def _rows(by_value: FloatArray) -> FloatArray:
    """(3 n, n_values) from (3, n_values, n)."""
    count = by_value.shape[0] * by_value.shape[2]
    return np.ascontiguousarray(by_value.transpose(0, 2, 1)).reshape(count, by_value.shape[1])


def _as_many(position: FloatArray, tool: FloatArray) -> FloatArray:
    """(n_axes, m): a position (n_axes, 1) for each of m tool points."""
    return np.repeat(position, tool.shape[1], axis=1)


def curve_u(covariance: Covariance, component: str, positions: FloatArray) -> FloatArray:
    """(n,): standard uncertainty of a curve at positions (n,), mm or deg. Raises ValueError where none is known."""
    if covariance.root is None:
        raise ValueError("the noise of the readings is unknown")
    by_value = covariance.bases[covariance.components.index(component)](positions).T
    root = covariance.root[covariance.rows_of(component)]
    return np.asarray(np.sqrt(((by_value @ root) ** 2).sum(axis=1)))


def prior_size(model: MachineModel, positions: FloatArray, tool: FloatArray) -> FloatArray:
    """(n,): length of the deviation of tool points that the prior sizes of all errors let expect, mm.

    One standard deviation: the root of the sum of the squares of every error's size times its sensitivity.
    """
    machine = model.machine
    sizes = [machine.prior.of_component(name) for name in machine.components]
    sizes += [machine.prior.of_location(name, machine.parameter_unit(name)) for name in machine.location_errors]
    found = np.empty(positions.shape[1])
    for rows in _pieces(positions.shape[1], len(sizes)):
        here = tool if tool.shape[1] == 1 else np.ascontiguousarray(tool[:, rows])
        by_error = _by_error(model, np.ascontiguousarray(positions[:, rows]), here)
        found[rows] = np.sqrt(((by_error * np.array(sizes)[:, np.newaxis]) ** 2).sum(axis=(0, 1)))
    return found


def derivative(
    model: MachineModel,
    covariance: Covariance,
    positions: FloatArray,
    tool: FloatArray,
    context: Context | None = None,
) -> FloatArray:
    """(3, n_values, n): of the deviation of tool points in the workpiece frame by the values, error-free machine.

    positions: (n_axes, n), mm or deg; tool: (3, 1) or (3, n), mm; context: of the positions. Without one effects are
    those of axes that stand and have not moved.
    """
    by_error = _by_error(model, positions, tool)
    parts = []
    for name, basis in zip(covariance.components, covariance.bases, strict=True):
        at = basis(positions[model.axes.index(name.axis)])
        parts.append(by_error[:, model.components.index(name), np.newaxis] * at)
    start = len(model.components)
    parts += [by_error[:, start + model.location_errors.index(name), np.newaxis] for name in covariance.locations]
    still = (context or Context.at_rest(len(model.axes), positions.shape[1])).filled()
    parts += _by_effects(model, by_error, positions, covariance.effects, still)
    return np.concatenate(parts, axis=1) if parts else np.zeros((3, 0, positions.shape[1]))


def _by_error(model: MachineModel, positions: FloatArray, tool: FloatArray) -> FloatArray:
    found = model.view_sensitivity("tool_in_workpiece", positions, np.ascontiguousarray(tool))
    return np.broadcast_to(found, (*found.shape[:2], positions.shape[1]))


def _by_effects(
    model: MachineModel, by_error: FloatArray, positions: FloatArray, labels: Sequence[str], context: Context
) -> list[FloatArray]:
    """(3, m, n) for each of the effects, at the model's values of them.

    Effects on readings and on points of a set-up move no tool: theirs is zero; a squareness is a location error.
    """
    by_label = {effect.label: effect for effect in model.effects}
    return [_by_effect(model, by_error, positions, by_label[label], context) for label in labels]


def _by_effect(
    model: MachineModel, by_error: FloatArray, positions: FloatArray, effect: Effect, context: Context
) -> FloatArray:
    kind = model.kinds[effect.kind]
    count = positions.shape[1]
    found = np.zeros((3, len(kind.parameters), count))
    if kind.place == "component":
        values = next((one for one in model.effect_values if identity(one.effect) == identity(effect)), None)
        vector = (values or EffectValues(effect, {})).vector(kind)
        term = component_term(model.kernels, model.machine, effect, vector, positions, context)
        found += by_error[:, model.components.index(effect.component or "")][:, np.newaxis] * term[np.newaxis, 1:]
    elif kind.place == "location":
        row = len(model.components) + model.location_errors.index(effect.component or "")
        found += by_error[:, row][:, np.newaxis]
    return found


def open_steps(machine: Machine, covariance: Covariance) -> FloatArray:
    """(n_values, d): the open combinations, each as large as the prior lets its largest part be.

    Parameters of effects count as values of their own unit: the prior has no size for them.
    """
    relative = []
    for name, basis in zip(covariance.components, covariance.bases, strict=True):
        at = basis(np.linspace(*machine.travel[name.axis], _SAMPLES))
        curve = covariance.open[covariance.rows_of(name)].T @ at
        relative.append(np.abs(curve).max(axis=1, initial=0.0) / machine.prior.of_component(name))
    start = sum(basis.count for basis in covariance.bases)
    for row, location in enumerate(covariance.locations, start):
        size = machine.prior.of_location(location, machine.parameter_unit(location))
        relative.append(np.abs(covariance.open[row]) / size)
    relative += list(np.abs(covariance.open[start + len(covariance.locations) :]))
    largest = np.max(np.array(relative).reshape(len(relative), covariance.open.shape[1]), axis=0, initial=0.0)
    return covariance.open / np.where(largest > 0.0, largest, 1.0)


def _pieces(count: int, values: int) -> Iterator[slice]:
    size = max(1, _ENTRIES // (3 * max(1, values)))
    for start in range(0, count, size):
        yield slice(start, min(start + size, count))
