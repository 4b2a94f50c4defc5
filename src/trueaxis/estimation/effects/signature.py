"""What effects add to readings, and the derivatives of it: sensitivity of the reading times the term of the effect.

Sensitivities come from the derived kernels of the machine, terms from those of the kinds. A point that is off has no
term: its columns are difference quotients of the exact reading. A squareness is a location error, and none here.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.effects.placement import concerns
from trueaxis.estimation.first_order import sensed, sensed_at_home
from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_effects import reading_context
from trueaxis.measurement.reading_model import expected_readings, home_positions
from trueaxis.model.context import Context, ReadingContext
from trueaxis.model.effect_terms import component_term, reading_term
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.model import MachineModel

STEP_OF_BAR = 1e-2  # mm: the distance of a ball bar is curved in its points
STEP_OF_LINE = 1.0  # mm: what laser and probe read is affine in theirs


@dataclass(frozen=True, slots=True, eq=False)
class Ground:
    """Readings of a machine with effects, and what the effects depend on; model: at the values to linearise at."""

    model: MachineModel
    observed: Observations
    context: Context
    reading: ReadingContext


@dataclass(frozen=True, slots=True, eq=False)
class RunRows:
    """Rows of one run with the sensitivities of their readings, here (n_components + n_location_errors, n) and at
    home (n_components + n_location_errors, 1).
    """

    index: int
    rows: IntArray
    here: FloatArray
    home: FloatArray


def ground_of(model: MachineModel, observed: Observations) -> Ground:
    """The readings with what effects depend on. Raises ValueError for observations without a context."""
    if observed.context is None:
        raise ValueError("readings of a machine with effects need the context in which they were taken")
    time, temperature = observed.context.time, observed.context.temperature
    found = reading_context(model, observed.runs, observed.run, observed.positions, time, temperature)
    return Ground(model, observed, observed.context, found)


def rows_of(ground: Ground, index: int, rows: IntArray) -> RunRows:
    """The rows with their sensitivities."""
    run, positions = ground.observed.runs[index], ground.observed.positions[:, rows]
    return RunRows(index, rows, sensed(ground.model, run, positions), sensed_at_home(ground.model, run))


def all_rows(observed: Observations, ground: Ground) -> list[RunRows]:
    """The rows of every run."""
    every = [np.flatnonzero(observed.run == index) for index in range(len(observed.runs))]
    return [rows_of(ground, index, rows) for index, rows in enumerate(every) if rows.size]


def reaches(ground: Ground, effect: Effect, kind: Kind, chosen: RunRows) -> bool:
    """Whether any of the readings may hold an effect with an expression."""
    if kind.place != "component":
        return concerns(kind, effect, ground.observed.runs[chosen.index])
    lever = ground.model.components.index(effect.component or "")
    return bool(chosen.here[lever].any() or chosen.home[lever].any())


def of_term(ground: Ground, effect: Effect, kind: Kind, parameters: FloatArray, chosen: RunRows) -> FloatArray:
    """(1 + m, n): what an effect with an expression adds to the readings, mm, then its derivative by each parameter.

    NaN where the context lacks what the effect depends on.
    """
    model, observed, rows = ground.model, ground.observed, chosen.rows
    run = observed.runs[chosen.index]
    if not reaches(ground, effect, kind, chosen):
        return np.zeros((1 + parameters.size, rows.size))
    if kind.place == "reading":
        return reading_term(model.kernels, model.machine, effect, parameters, ground.reading.of(rows))
    lever = model.components.index(effect.component or "")
    context = ground.context.of(rows)
    term = component_term(model.kernels, model.machine, effect, parameters, observed.positions[:, rows], context)
    total = _levered(chosen.here[lever], term)
    home = home_positions(run, model.axes)
    if home is not None and context.home is not None:
        at = np.repeat(home, rows.size, axis=1)
        term = component_term(model.kernels, model.machine, effect, parameters, at, context.home)
        total -= _levered(chosen.home[lever], term)
    return total


def by_differences(ground: Ground, effect: Effect, kind: Kind, index: int, rows: IntArray) -> FloatArray:
    """(m, n): derivative of the exact readings of a run by the coordinates of a point that is off."""
    observed, count = ground.observed, len(kind.parameters)
    run = observed.runs[index]
    found = np.zeros((count, rows.size))
    if not concerns(kind, effect, run):
        return found
    step = STEP_OF_BAR if run.length is not None else STEP_OF_LINE
    for place, parameter in enumerate(kind.parameters):
        ends = [_expected(ground, effect, {parameter.name: sign * step}, rows) for sign in (1.0, -1.0)]
        found[place] = (ends[0] - ends[1]) / (2.0 * step)
    return found


def _expected(ground: Ground, effect: Effect, moved: dict[str, float], rows: IntArray) -> FloatArray:
    """Exact readings with parameters of an effect moved."""
    values, model, observed = ground.model.errors, ground.model, ground.observed
    others = [one for one in values.effects if identity(one.effect) != identity(effect)]
    mine = [one.parameters for one in values.effects if identity(one.effect) == identity(effect)]
    before = mine[0] if mine else {}
    after = {**before, **{name: before.get(name, 0.0) + by for name, by in moved.items()}}
    model = model.with_values(replace(values, effects=(*others, EffectValues(effect, after))))
    return expected_readings(
        model, observed.runs, observed.run[rows], observed.positions[:, rows], ground.context.of(rows)
    )


def added_by(ground: Ground, effects: Sequence[EffectValues]) -> FloatArray:
    """(n,): what effects add to the exact readings, mm, beside whatever other error values the model has."""
    model, observed = ground.model, ground.observed
    ends = [
        expected_readings(
            model.with_values(replace(model.errors, effects=one)),
            observed.runs,
            observed.run,
            observed.positions,
            ground.context,
        )
        for one in (tuple(effects), ())
    ]
    return ends[0] - ends[1]


def _levered(lever: FloatArray, term: FloatArray) -> FloatArray:
    """A reading that the component does not reach is not spoilt by what is unknown there."""
    return np.where(lever == 0.0, 0.0, lever * term)
