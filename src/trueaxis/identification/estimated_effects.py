"""The effects of an estimate: their values with uncertainty, their report, and their part of the covariance."""

from dataclasses import replace

import numpy as np

from trueaxis.estimation.effects.unknowns import unit_in
from trueaxis.estimation.gauge import covariance_of
from trueaxis.estimation.judgement import NINE_TENTHS, open_counts
from trueaxis.estimation.result import Estimate
from trueaxis.identification.report import FROM_READINGS, EffectParameterReport, EffectReport
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.covariance import Covariance
from trueaxis.model.effect_values import identity
from trueaxis.model.errors import ErrorValues

ZERO = "zero: the readings would make its square negative"


def with_uncertainty(values: ErrorValues, found: Estimate) -> ErrorValues:
    """The values with the uncertainties of the effects that were estimated, NaN where the readings are silent."""
    own = {identity(one.effect): place for place, one in enumerate(found.layout.effects.members)}
    return replace(
        values,
        effects=tuple(
            replace(one, u=_spread(found, own[identity(one.effect)])) if identity(one.effect) in own else one
            for one in values.effects
        ),
    )


def effect_reports(values: ErrorValues, found: Estimate) -> tuple[EffectReport, ...]:
    """Of every effect with a value; values: with uncertainty."""
    own = {identity(one.effect): place for place, one in enumerate(found.layout.effects.members)}
    reports = []
    for one in values.effects:
        origin = ZERO if one.effect in found.zeroed else "given"
        if identity(one.effect) in own:
            silent = _silent(found, own[identity(one.effect)])
            origin = "undetermined" if silent.all() else "partly undetermined" if silent.any() else FROM_READINGS
        parameters = []
        for parameter in found.layout.model.kinds[one.effect.kind].parameters:
            u = one.u.get(parameter.name, np.nan)
            parameters.append(
                EffectParameterReport(
                    name=parameter.name,
                    value=one.parameters.get(parameter.name, 0.0),
                    u=None if np.isnan(u) else u,
                    unit=unit_in(parameter.unit, one.effect),
                    role=parameter.role,
                )
            )
        reports.append(EffectReport(one.effect.label, tuple(parameters), origin))
    return tuple(reports)


def covariances(found: Estimate, usual: bool) -> Covariance:
    """See `covariance_with_effects`; usual: whether the one by the usual sizes of instrument unknowns stands beside."""
    covariance, expected = covariance_with_effects(found), found.as_expected
    if not usual or expected is None:
        return covariance
    by_usual = replace(found, spread=expected.spread, of_prior=expected.of_prior)
    return replace(covariance, usual=covariance_with_effects(by_usual))


def covariance_with_effects(found: Estimate) -> Covariance:
    """Of curves, location errors and parameters of effects; what is not defined, as the phase of nothing, is open."""
    covariance = covariance_of(found.layout, found.spread, found.of_prior)
    covariance = replace(covariance, open=found.open[: found.layout.of_machine])
    members = found.layout.effects.members
    if not members:
        return covariance
    assert isinstance(covariance.root, np.ndarray)
    derivatives = [_at(found, place)[1] for place in range(len(members))]
    spreads = [np.nan_to_num(by) @ found.spread[_at(found, place)[0]] for place, by in enumerate(derivatives)]
    silent = [_undefined(found, place) for place in range(len(members))]
    undefined = np.concatenate([np.zeros(covariance.root.shape[0], dtype=bool), *silent])
    return replace(
        covariance,
        root=np.vstack(
            [covariance.root, *(np.where(at[:, None], 0.0, one) for at, one in zip(silent, spreads, strict=True))]
        ),
        open=np.hstack(
            [
                np.vstack(
                    [covariance.open, np.zeros((undefined.size - covariance.open.shape[0], covariance.open.shape[1]))]
                ),
                np.eye(undefined.size)[:, undefined],
            ]
        ),
        effects=tuple(one.effect.label for one in members),
        effect_parameters=tuple(tuple(parameter.name for parameter in one.kind.parameters) for one in members),
    )


def _at(found: Estimate, place: int) -> tuple[slice, FloatArray]:
    """Where the unknowns of a member stand, and (m, count) the derivative of its parameters by them."""
    effects, first = found.layout.effects, found.layout.of_effects.start
    mine = effects.slices()[place]
    rows = slice(first + mine.start, first + mine.stop)
    return rows, effects.members[place].by_values(found.unknowns[rows])


def _silent(found: Estimate, place: int) -> np.ndarray:
    """(count,): unknowns of a member of which the readings say nothing, or only together with what is open."""
    rows, _ = _at(found, place)
    u, opened = (np.linalg.norm(root[rows], axis=1) for root in (found.spread, found.open))
    return np.asarray((u > NINE_TENTHS * found.scale[rows]) | open_counts(opened, u))


def _undefined(found: Estimate, place: int) -> np.ndarray:
    """(m,): parameters of a member that have no uncertainty: not told by the readings, chosen of several, undefined."""
    _, by_values = _at(found, place)
    told_by_silent = (np.abs(np.nan_to_num(by_values)) * _silent(found, place) > 0.0).any(axis=1)
    return np.asarray(told_by_silent | np.isnan(by_values).any(axis=1) | ~by_values.any(axis=1))


def _spread(found: Estimate, place: int) -> dict[str, float]:
    rows, by_values = _at(found, place)
    u = np.linalg.norm(np.nan_to_num(by_values) @ found.spread[rows], axis=1)
    u = np.where(_undefined(found, place), np.nan, u)
    names = (parameter.name for parameter in found.layout.effects.members[place].kind.parameters)
    return dict(zip(names, u.tolist(), strict=True))
