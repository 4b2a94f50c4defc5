"""What a plan will tell of the effects of the spec."""

from collections.abc import Mapping, Sequence

import numpy as np

from trueaxis.effects.kind import Effect, Kind
from trueaxis.estimation.effects.planned import planned_effects
from trueaxis.estimation.effects.unknowns import unit_in
from trueaxis.estimation.expected import expected
from trueaxis.estimation.judgement import TENTH
from trueaxis.estimation.observations import Observations
from trueaxis.estimation.result import Estimate
from trueaxis.identification.estimated_effects import with_uncertainty
from trueaxis.model.effect_values import EffectValues, identity
from trueaxis.model.errors import ErrorValues
from trueaxis.model.model import MachineModel
from trueaxis.planning.report import ExpectedEffect, ExpectedParameter


def expected_with_effects(
    model: MachineModel,
    observed: Observations,
    given: ErrorValues,
    noise: Mapping[int, float],
    values: Sequence[EffectValues],
) -> tuple[Estimate, tuple[ExpectedEffect, ...]]:
    """The estimate to expect, effects of the spec among its unknowns, and a report of them, in the order of the spec.

    noise: of every run, by index, mm; values: at which effects are linearised, see `planned_effects`. A squareness is
    a location error.
    """
    planned = planned_effects(model, observed, given, values)
    found = expected(model, observed, given, noise, planned.unknowns)
    stated = {identity(one.effect) for one in values}
    reports = []
    for effect in model.effects:
        kind = model.kinds[effect.kind]
        if kind.place == "location":
            continue
        if effect in planned.lacking:
            reports.append(ExpectedEffect(effect=effect.label, state="lacking", missing=planned.lacking[effect]))
        elif any(one.effect == effect for one in planned.unknowns.members):
            reports.append(_told(found, effect, kind, stated=identity(effect) in stated))
        else:
            reports.append(ExpectedEffect(effect=effect.label, state="given"))
    return found, tuple(reports)


def _told(found: Estimate, effect: Effect, kind: Kind, *, stated: bool) -> ExpectedEffect:
    values = next(one for one in with_uncertainty(found.values, found).effects if one.effect == effect)
    u = [values.u.get(one.name, np.nan) for one in kind.parameters]
    parameters = tuple(
        ExpectedParameter(
            name=one.name,
            value=values.parameters[one.name],
            u=None if np.isnan(own) else own,
            unit=unit_in(one.unit, effect),
            role=one.role,
        )
        for one, own in zip(kind.parameters, u, strict=True)
    )
    if all(one.u is None for one in parameters):
        return ExpectedEffect(effect=effect.label, state="silent", parameters=parameters, stated=stated)
    return ExpectedEffect(
        effect=effect.label,
        state="errors" if _among_errors(found, effect) else "data",
        parameters=parameters,
        stated=stated,
    )


def _among_errors(found: Estimate, effect: Effect) -> bool:
    """Whether u of the amplitudes would be a tenth or less if the errors of the machine were known."""
    effects, first = found.layout.effects, found.layout.of_effects.start
    (place,) = (k for k, one in enumerate(effects.members) if one.effect == effect)
    member, mine = effects.members[place], effects.slices()[place]
    start = first + mine.start
    spread = found.spread[start : start + member.count - len(member.free)]
    of_errors, _ = np.linalg.qr(found.spread[: found.layout.of_machine].T)
    beside = spread - (spread @ of_errors) @ of_errors.T
    return bool(np.linalg.norm(beside) < TENTH * np.linalg.norm(spread))
