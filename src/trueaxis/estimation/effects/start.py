"""The effects of a machine that are to be estimated, and the values from which their fit starts."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.amplitudes import searched_names
from trueaxis.estimation.effects.faults import check_columns
from trueaxis.estimation.effects.search import Others, searched_start
from trueaxis.estimation.effects.signature import all_rows, ground_of
from trueaxis.estimation.effects.unknowns import EffectUnknown, EffectUnknowns, member_at, sized
from trueaxis.estimation.observations import Observations
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel


@dataclass(frozen=True, slots=True, eq=False)
class Sought:
    """The effects whose parameters are sought: those that an estimate may start with at once, and those whose start is
    searched beside an estimate of everything else.
    """

    at_once: EffectUnknowns
    waiting: tuple[tuple[Effect, Kind], ...] = ()


def sought_effects(
    model: MachineModel, observed: Observations, given: ErrorValues, start: Sequence[EffectValues] = ()
) -> Sought:
    """The effects of the machine whose values are not given; a squareness is unknown as the location error it adds.

    start: values to start with, which spares a search.

    Raises InputError where the readings lack a column that an effect depends on.
    """
    if not model.machine.effects:
        return Sought(EffectUnknowns())
    ground, kinds = ground_of(model, observed), model.machine.kinds
    chosen = all_rows(observed, ground)
    check_columns(ground, [(effect, kinds[effect.kind]) for effect in model.machine.effects], chosen)
    ground = ground_of(model, replace(observed, context=ground.context.filled()))
    known = {identity(one.effect) for one in given.effects}
    starts = {identity(one.effect): one for one in start}
    at_once, waiting = [], []
    for effect in model.machine.effects:
        kind, own = kinds[effect.kind], starts.get(identity(effect))
        if identity(effect) in known or kind.place == "location":
            continue
        if own is not None and kind.place != "point":
            at_once.append(sized(member_at(effect, kind, own.parameters), ground, chosen))
        elif searched_names(kind) or kind.place == "point":
            waiting.append((effect, kind))
        else:
            at_once.append(sized(zero(effect, kind), ground, chosen))
    return Sought(EffectUnknowns(tuple(at_once), ground), tuple(waiting))


def with_searched(found: EffectUnknowns, effect: Effect, kind: Kind, others: Others) -> EffectUnknowns:
    """The effects and one more, where it explains most of what the others leave of the readings.

    A point that is off matters beside the machine's errors alone: it starts where it was set up.
    """
    assert found.ground is not None
    ground = found.ground
    member = zero(effect, kind) if kind.place == "point" else searched_start(ground, effect, kind, others)
    member = sized(member, ground, all_rows(ground.observed, ground))
    order = [identity(one) for one in ground.model.machine.effects]
    kept = [one for one in found.members if one.effect != effect]
    members = sorted((*kept, member), key=lambda one: order.index(identity(one.effect)))
    return replace(found, members=tuple(members))


def with_locations(model: MachineModel, given: ErrorValues) -> ErrorValues:
    """The values with those that effects give to location errors among the parameters: told once, not twice."""
    told = [one for one in given.effects if model.kinds[one.effect.kind].place == "location"]
    angles = {one.effect.component or "": float(one.vector(model.kinds[one.effect.kind])[0]) for one in told}
    left = tuple(one for one in given.effects if one not in told)
    return replace(given, parameters={**given.parameters, **angles}, effects=left)


def below_zero(effects: EffectUnknowns, values: FloatArray) -> tuple[EffectUnknown, ...]:
    """Effects whose term is proportional to a square that came out negative; values: (effects.count,), not scaled."""
    return tuple(
        one
        for one, mine in zip(effects.members, effects.slices(), strict=True)
        if any(parameter.role == "root" for parameter in one.kind.parameters)
        and (values[mine][: one.count - len(one.free)] < 0.0).any()
    )


def with_zeros(given: ErrorValues, members: Sequence[EffectUnknown]) -> ErrorValues:
    """What is given, and effects that are zero."""
    zeros = []
    for one in members:
        searched = one.searched(one.values)
        parameters = {each.name: searched.get(each.name, 0.0) for each in one.kind.parameters}
        zeros.append(EffectValues(one.effect, parameters))
    return replace(given, effects=(*given.effects, *zeros))


def zero(effect: Effect, kind: Kind) -> EffectUnknown:
    """The effect where it changes nothing."""
    return member_at(effect, kind, {one.name: 0.0 for one in kind.parameters})
