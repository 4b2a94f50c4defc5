"""The effects of the global method's report: values, uncertainty, and what of them is open."""

from dataclasses import replace

import numpy as np

from trueaxis.estimation.effects.unknowns import unit_in
from trueaxis.identify.global_fit.result import OPEN, GlobalResult
from trueaxis.identify.report import FROM_READINGS, EffectParameterReport, EffectReport
from trueaxis.identify.words import Share
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.effect_values import EffectValues, identity, in_order

ZERO = "zero: the readings would make its square negative"


def effect_values(result: GlobalResult) -> tuple[EffectValues, ...]:
    """The effects whose parameters were sought, with standard uncertainties, NaN where open."""
    plan = result.layout
    found = []
    for place, one in enumerate(plan.effects.values(result.unknowns[plan.of_effects])):
        if result.covariance is None:
            found.append(one)
            continue
        mine, by_values = effect_at(result, place)
        variance = np.einsum("mk,kl,ml->m", by_values, result.covariance[mine, mine], by_values)
        opened = (np.abs(np.nan_to_num(by_values)) * result.open[mine] > 0.0).any(axis=1)
        spread = np.where(opened | ~by_values.any(axis=1), np.nan, np.sqrt(variance))
        names = (parameter.name for parameter in plan.effects.members[place].kind.parameters)
        found.append(replace(one, u=dict(zip(names, spread.tolist(), strict=True))))
    return tuple(found)


def effects(result: GlobalResult) -> tuple[EffectReport, ...]:
    """Values of the machine's effects and where they come from."""
    plan, found = result.layout, []
    if plan.effects.ground is None:
        return ()
    machine = plan.effects.ground.model.machine
    sought = {identity(one.effect): (place, one) for place, one in enumerate(effect_values(result))}
    every = in_order((*result.given.effects, *(one for _, one in sought.values())), machine.effects)
    for one in every:
        origin = ZERO if one.effect in result.zeroed else "given"
        if identity(one.effect) in sought:
            place = sought[identity(one.effect)][0]
            mine, _ = effect_at(result, place)
            opened = result.open[mine]
            origin = "undetermined" if opened.all() else "partly undetermined" if opened.any() else FROM_READINGS
        parameters = []
        for parameter in machine.kinds[one.effect.kind].parameters:
            u = one.u.get(parameter.name, np.nan)
            parameters.append(
                EffectParameterReport(
                    parameter.name,
                    one.parameters.get(parameter.name, 0.0),
                    None if np.isnan(u) else u,
                    unit_in(parameter.unit, one.effect),
                    parameter.role,
                )
            )
        found.append(EffectReport(one.effect.label, tuple(parameters), origin))
    return tuple(found)


def effect_at(result: GlobalResult, place: int) -> tuple[slice, FloatArray]:
    """Where the unknowns of a member stand, and (m, count) the derivative of its parameters by them."""
    plan = result.layout
    member, mine = plan.effects.members[place], plan.effects.slices()[place]
    mine = slice(plan.of_effects.start + mine.start, plan.of_effects.start + mine.stop)
    return mine, member.by_values(result.unknowns[mine])


def effect_unknowns(result: GlobalResult) -> list[tuple[str, str]]:
    """Name of each unknown of effects, and the label of its effect."""
    return [(name, one.effect.label) for one in result.layout.effects.members for name in one.names]


def effect_shares(result: GlobalResult, vector: FloatArray, lead: float) -> list[Share]:
    """Those of effects in a combination that changes no reading, per `lead` (mm or rad)."""
    plan = result.layout
    own = vector[plan.of_effects]
    values = own * plan.scale[plan.of_effects] / lead
    units_of = [unit for one in plan.effects.members for unit in one.units]
    return [
        Share(name, float(value), unit)
        for (name, _), unit, value, scaled in zip(effect_unknowns(result), units_of, values, own, strict=True)
        if abs(scaled) > OPEN
    ]
