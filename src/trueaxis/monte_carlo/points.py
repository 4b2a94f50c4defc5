"""What is drawn: the error vector of the tool point at many points, for draws of all that is uncertain about it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from trueaxis.model.best_fit import Placements
from trueaxis.model.context import Context
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray, evaluate_components
from trueaxis.model.effect_terms import component_term
from trueaxis.model.effect_values import identity
from trueaxis.model.model import MachineModel
from trueaxis.monte_carlo.settings import Draws

ENTRIES = 4_000_000  # of the largest array: 32 MB


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class DrawnPoints:
    """Points and what is known of them. positions: (n_axes, n), commanded, mm or deg; tool: (3, n), tool frame, mm;
    context: of the positions; covariance: of the error values. home: (n_axes, 1), mm or deg, where the error counts as
    zero; placements: of the workpiece, the best fit of which is taken off; None: neither. offset: (3, n), mm, by which
    the commanded positions of an error-free machine miss what is wanted; steps: (3, k, n), mm, by which words of their
    resolution may be off, each alike from -1/2 to 1/2 of it.
    """

    positions: FloatArray
    tool: FloatArray
    context: Context
    covariance: Covariance
    home: FloatArray | None
    placements: Placements | None
    offset: FloatArray
    steps: FloatArray
    draws: Draws

    def of(self, rows: slice) -> "DrawnPoints":
        """Some of the points; not where a best fit of all is taken off."""
        assert self.placements is None
        return replace(
            self,
            positions=self.positions[:, rows],
            tool=self.tool[:, rows],
            context=self.context.of(rows),
            offset=self.offset[:, rows],
            steps=self.steps[:, :, rows],
        )


class Drawing:
    """Makes draws of the error vectors of points, on the exact model."""

    def __init__(self, model: MachineModel, points: DrawnPoints) -> None:
        self._points, self._count = points, points.positions.shape[1]
        homes = 0
        tool, positions, context = points.tool, points.positions, points.context
        if points.home is not None:  # the same draw displaces the tool there
            one_tool = bool((tool == tool[:, :1]).all())
            homes = 1 if one_tool else self._count
            positions = np.hstack([positions, np.repeat(points.home, homes, axis=1)])
            tool = np.hstack([tool, tool[:, :homes]])
            context = _joined(context, Context.at_rest(len(model.axes), homes))
        self._homes = homes
        if (tool == tool[:, :1]).all():
            tool = tool[:, :1]
        self._positions, self._tool = np.ascontiguousarray(positions), np.ascontiguousarray(tool)
        self._context = context
        self._model = model
        values = replace(model.errors, effects=())
        axes = [model.axes.index(name.axis) for name in model.components]
        self._curves = evaluate_components(values.motion_errors, model.components, axes, self._positions)
        self._bases = [
            (
                model.components.index(name),
                points.covariance.rows_of(name),
                basis(positions[model.axes.index(name.axis)]),
            )
            for name, basis in zip(points.covariance.components, points.covariance.bases, strict=True)
        ]  # fmt: skip
        self._located = [model.parameters.index(name) for name in points.covariance.locations]
        self._effects = _effect_rows(model, points.covariance)

    def errors(self, generators: list[np.random.Generator], count: int) -> Iterator[FloatArray]:
        """(m, 3, n), mm, in pieces of bounded size, `count` draws in all."""
        of_values, of_noise, of_context = generators
        size = max(1, ENTRIES // (self._positions.shape[1] * max(len(self._model.components), 8)))
        for start in range(0, count, size):
            many = min(size, count - start)
            found = self._systematic(of_values, of_context, many)
            points = self._points
            if points.steps.size:
                shares = of_noise.uniform(-0.5, 0.5, (many, points.steps.shape[1], self._count))
                found += np.einsum("ikn,mkn->min", points.steps, shares)
            if points.draws.noise_um:
                found += 1e-3 * points.draws.noise_um * of_noise.standard_normal(found.shape)
            yield found

    def _systematic(self, of_values: np.random.Generator, of_context: np.random.Generator, many: int) -> FloatArray:
        root = self._points.covariance.root
        assert root is not None
        unit = of_values.standard_normal((many, root.shape[1]))
        steps = np.asarray((root @ unit.T).T)
        errors = np.repeat(self._curves[np.newaxis], many, axis=0)
        for row, rows, basis in self._bases:
            errors[:, row] += steps[:, rows] @ basis
        found = np.empty((many, 3, self._positions.shape[1]))
        start = sum(basis.count for basis in self._points.covariance.bases)
        for draw in range(many):
            parameters = self._model.parameter_values.copy()
            parameters[self._located] += steps[draw, start : start + len(self._located)]
            if self._effects or self._model.effect_values:
                self._add_effects(errors[draw], parameters, steps[draw], of_context)
            found[draw] = self._model.view_deviation_of(
                "tool_in_workpiece", self._positions, np.ascontiguousarray(errors[draw]), parameters, self._tool
            )
        return self._from_datum(found)

    def _add_effects(
        self, errors: FloatArray, parameters: FloatArray, steps: FloatArray, of_context: np.random.Generator
    ) -> None:
        """Add the effects of one draw to component errors (n_components, n) and parameters, in place."""
        model = self._model
        context = self._drawn_context(of_context)
        for values in model.effect_values:
            kind = model.kinds[values.effect.kind]
            vector = values.vector(kind)
            rows = self._effects.get(values.effect.label)
            change = np.zeros(vector.size) if rows is None else steps[rows]
            if kind.place == "component":
                term = component_term(
                    model.kernels, model.machine, values.effect, vector + change, self._positions, context
                )
                errors[model.components.index(values.effect.component or "")] += term[0]
            elif kind.place == "location":  # its value is among the parameters
                parameters[model.parameters.index(values.effect.component or "")] += change[0]

    def _drawn_context(self, source: np.random.Generator) -> Context:
        context, draws = self._context, self._points.draws
        if draws.either_direction:  # where a point does not say from which side
            sides = source.choice([-1.0, 1.0], (len(self._model.axes), self._count))
            given = context.directions[:, : self._count]
            directions = context.directions.copy()
            directions[:, : self._count] = np.where(given == 0.0, sides, given)
            context = replace(context, directions=directions)
        if draws.u_temperature:  # of the shop, the same at all points
            off = draws.u_temperature * source.standard_normal()
            context = replace(context, temperature=context.temperature + off)
        return context

    def _from_datum(self, found: FloatArray) -> FloatArray:
        there = found[:, :, : self._count] + self._points.offset
        if self._homes:
            there -= found[:, :, self._count :]
        if self._points.placements is not None:
            directions = self._points.placements.directions
            share = np.einsum("inr,min->mr", directions, there)
            there -= np.einsum("inr,mr->min", directions, share)
        return there


def with_length(errors: FloatArray) -> FloatArray:
    """(m, 4, n): x, y, z and the length of error vectors (m, 3, n)."""
    return np.concatenate([errors, np.linalg.norm(errors, axis=1)[:, np.newaxis]], axis=1)


def _effect_rows(model: MachineModel, covariance: Covariance) -> dict[str, npt.NDArray[np.int64]]:
    """Where the parameters of each effect stand among the values of the covariance, by its label."""
    known = {one.effect.label for one in model.effect_values} & {effect.label for effect in model.effects}
    start = sum(basis.count for basis in covariance.bases) + len(covariance.locations)
    found = {}
    for label, names in zip(covariance.effects, covariance.effect_parameters, strict=True):
        if label in known:
            found[label] = np.arange(start, start + len(names))
        start += len(names)
    assert len({identity(one.effect) for one in model.effect_values}) == len(model.effect_values)
    return found


def _joined(one: Context, other: Context) -> Context:
    return Context(
        directions=np.hstack([one.directions, other.directions]),
        velocity=np.hstack([one.velocity, other.velocity]),
        since_reversal=np.hstack([one.since_reversal, other.since_reversal]),
        time_since=np.hstack([one.time_since, other.time_since]),
        path_since=np.hstack([one.path_since, other.path_since]),
        time=np.concatenate([one.time, other.time]),
        temperature=np.concatenate([one.temperature, other.temperature]),
    )
