"""The effects of a machine before any reading: at which values what readings will tell of them is linearised."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.amplitudes import amplitude_names, searched_names
from trueaxis.estimation.effects.faults import missing_columns
from trueaxis.estimation.effects.search import grid_points
from trueaxis.estimation.effects.signature import Ground, RunRows, all_rows, ground_of
from trueaxis.estimation.effects.start import zero
from trueaxis.estimation.effects.unknowns import EffectUnknown, EffectUnknowns, member_at, sized
from trueaxis.estimation.observations import Observations
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel

ASSUMED = 5e-3  # mm: what an effect is assumed to change a reading by at most: worth a name, and no misfit of machines


@dataclass(frozen=True, slots=True, eq=False)
class PlannedEffects:
    """unknowns: the effects that can be planned for; lacking: columns that the others depend on and the runs lack."""

    unknowns: EffectUnknowns
    lacking: Mapping[Effect, tuple[str, ...]]


def planned_effects(
    model: MachineModel, observed: Observations, given: ErrorValues, values: Sequence[EffectValues] = ()
) -> PlannedEffects:
    """The effects of the machine whose values are not given; a squareness is unknown as the location error it adds.

    values: at which effects are linearised. Where they are silent: where the effect changes nothing, if its u does not
    depend on how large it is; else as large as changes a reading by ASSUMED, with the parameters that are searched in
    the middle of their grids.
    """
    if not model.machine.effects:
        return PlannedEffects(EffectUnknowns(), {})
    ground, kinds = ground_of(model, observed), model.machine.kinds
    chosen = all_rows(observed, ground)
    filled = ground_of(model, replace(observed, context=ground.context.filled()))
    known = {identity(one.effect) for one in given.effects}
    stated = {identity(one.effect): one.parameters for one in values}
    members: list[EffectUnknown] = []
    lacking: dict[Effect, tuple[str, ...]] = {}
    for effect in model.machine.effects:
        kind = kinds[effect.kind]
        if identity(effect) in known or kind.place == "location":
            continue
        if missing := missing_columns(ground, effect, kind, chosen):
            lacking[effect] = tuple(missing)
            continue
        parameters = stated.get(identity(effect))
        start = _assumed(filled, effect, kind, chosen) if parameters is None else member_at(effect, kind, parameters)
        members.append(sized(start, filled, chosen))
    return PlannedEffects(EffectUnknowns(tuple(members), filled), lacking)


def _assumed(ground: Ground, effect: Effect, kind: Kind, chosen: Sequence[RunRows]) -> EffectUnknown:
    """The effect at values that are as good as any."""
    if all(one.role == "linear" for one in kind.parameters):
        return zero(effect, kind)
    points = grid_points(ground, effect, kind)
    free, k = searched_names(kind), len(amplitude_names(kind))
    searched = [points[len(points) // 2][name] for name in free]
    still = EffectUnknown(effect=effect, kind=kind, values=np.array([*np.zeros(k), *searched]), free=free)
    largest = np.zeros(k)
    for rows in chosen:
        largest = np.maximum(largest, np.abs(still.columns(ground, rows)[:, :k]).max(axis=0, initial=0.0))
    amplitudes = np.divide(ASSUMED / k, largest, out=np.zeros(k), where=largest > 0.0)
    return still.at(np.array([*amplitudes, *searched]))
