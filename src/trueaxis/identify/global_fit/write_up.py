"""The outcome of the global method as error values, covariance and report."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import scipy.linalg

from trueaxis.estimation.machine import lever
from trueaxis.estimation.repeats import copied_runs
from trueaxis.identify.fit_quality import Residuals, expected_sizes, known_noise, quality
from trueaxis.identify.global_fit import describe, describe_effects
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE
from trueaxis.identify.global_fit.result import GlobalResult
from trueaxis.identify.global_fit.robust import DOUBTED, TUNING
from trueaxis.identify.notes import dimension_notes, weak_notes
from trueaxis.identify.report import (
    BlockReport,
    ComponentReport,
    DoubtedReading,
    Identification,
    IdentificationReport,
    NoiseGroupReport,
    OrderReport,
)
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.bases import unmeasured_basis
from trueaxis.runtime.covariance import Covariance, factor
from trueaxis.runtime.effect_values import EffectValues, in_order


def identification(result: GlobalResult) -> Identification:
    """Values, report and covariance."""
    plan = result.layout
    undetermined = describe.undetermined(result)
    fitted = plan.values(result.unknowns, result.given)
    doubted = float(np.mean(result.robust_weight < DOUBTED))
    judged = quality(residuals_of(result), result.observed.runs, doubted)
    values = replace(
        fitted,
        motion_errors={**fitted.motion_errors, **describe.curves(result), **result.given.motion_errors},
        u=describe.location_u(result),
        undetermined=undetermined,
        effects=_effects(result),
        fit=judged.fit,
    )
    block = BlockReport(
        runs=tuple(run.id for run in result.observed.runs),
        components=(*plan.names(), *(one.effect.label for one in plan.effects.members)),
        equations=result.held,
        unknowns=plan.count,
        rank=result.factors.rank,
        condition=result.factors.condition,
    )
    found = describe.components(result)
    report = IdentificationReport(
        machine=plan.machine.name,
        method="global",
        squareness=describe.RULES[result.options.squareness],
        readings=result.observed.reading.size,
        left_out=(),
        lever=lever(plan.machine),
        rank_tolerance=RANK_TOLERANCE,
        blocks=(block,),
        iterations=result.iterations,
        last_change=result.change,
        residual_rms_um=float(np.sqrt(np.mean(result.residual**2))) * 1e3,
        freedom=result.noise.freedom,
        noise_um=result.noise.um,
        noise_origin=result.noise.origin,
        locations=describe.locations(result),
        components=found,
        undetermined=undetermined,
        quality=judged,
        notes=(
            *dimension_notes(plan.machine, result.given),
            *weak_notes(found),
            *describe.instrument_notes(result),
        ),
        instruments=describe.instrument_values(result),
        noise_groups=tuple(NoiseGroupReport(group.group, group.um, group.freedom) for group in result.groups),
        noise_ratio=_noise_ratio(result),
        robust=_robust(result),
        doubted=_doubted(result),
        orders=_orders(result),
        effects=describe_effects.effects(result),
    )
    return Identification(values, report, _covariance(result, found))


def residuals_of(result: GlobalResult) -> Residuals:
    """The residuals, those of readings that robustness weighs down by as much smaller."""
    observed, machine = result.observed, result.layout.machine
    known = None if result.noise.origin.startswith("from the") and not result.groups else result.noise.sigma
    return Residuals(
        observed.run,
        np.ones(observed.reading.size),
        result.robust_weight * result.residual**2,
        known_noise(observed, known, result.roots),
        expected_sizes(machine, observed.runs, observed.run, observed.positions),
        result.noise.freedom,
        tuple(copied_runs(observed).tolist()) if known is None else (),
    )


def _effects(result: GlobalResult) -> tuple[EffectValues, ...]:
    """Those given and those found, in the order of the spec."""
    found = (*result.given.effects, *describe_effects.effect_values(result))
    ground = result.layout.effects.ground
    return found if ground is None else in_order(found, ground.model.machine.effects)


def _covariance(result: GlobalResult, components: Sequence[ComponentReport]) -> Covariance:
    """Of the machine's values alone, whatever the instruments' are.

    What the convention settles is among the open combinations: it matters only where it moves the tool.
    """
    plan = result.layout
    n = plan.of_machine
    null = np.hstack([result.gauge.settled, result.gauge.null])[:n] * plan.scale[:n, np.newaxis]
    by_unknown, undefined = _by_unknown(result)
    root = None
    if result.covariance is not None:
        root = factor(by_unknown @ result.covariance[:n, :n] @ by_unknown.T)
    names = plan.names()[: plan.components.size]
    measured = Covariance(
        machine=plan.machine.name,
        components=names,
        bases=tuple(plan.basis_of(place) for place in range(plan.components.size)),
        locations=plan.names()[plan.components.size :],
        root=root,
        open=np.hstack([by_unknown @ null[:, null.any(axis=0)], undefined]),
        effects=tuple(one.effect.label for one in plan.effects.members),
        effect_parameters=tuple(
            tuple(parameter.name for parameter in one.kind.parameters) for one in plan.effects.members
        ),
        of_prior=0,
    )
    return measured.with_open_components(
        {
            one.name: unmeasured_basis(plan.machine.travel, one.name)
            for one in components
            if one.known == "not measured" and one.name not in names
        }
    )


def _by_unknown(result: GlobalResult) -> tuple[FloatArray, FloatArray]:
    """(values, unknowns): derivative of the machine's values by its unknowns; (values, d): unit vectors of values that
    are not defined, such as the phase of nothing.
    """
    plan = result.layout
    blocks = [describe_effects.effect_at(result, place)[1] for place in range(len(plan.effects.members))]
    found = np.asarray(scipy.linalg.block_diag(np.eye(plan.of_effects.start), *blocks))
    lacking = np.flatnonzero(np.isnan(found).any(axis=1))
    found[lacking] = 0.0
    return found, np.eye(found.shape[0])[:, lacking]


def _noise_ratio(result: GlobalResult) -> float | None:
    if result.noise.origin.startswith("from the residuals") or result.noise.sigma is None or result.noise.freedom <= 0:
        return None
    used = result.roots * np.sqrt(result.robust_weight) * result.residual
    return float(np.sqrt(used @ used / result.noise.freedom)) / result.noise.sigma


def _robust(result: GlobalResult) -> str:
    kind = result.options.robust
    return f"{kind.capitalize()}, tuning {TUNING[kind]:g}" if kind else ""


def _doubted(result: GlobalResult) -> tuple[DoubtedReading, ...]:
    """The readings that count for less than half, the least first."""
    observed, weight = result.observed, result.robust_weight
    rows = np.flatnonzero(weight < DOUBTED)
    scale = result.noise.sigma or np.nan
    found = [
        DoubtedReading(
            run=observed.runs[observed.run[row]].id,
            seq=int(row if observed.seq is None else observed.seq[row]),
            weight=float(weight[row]),
            residual_um=float(result.residual[row]) * 1e3,
            z=float(result.roots[row] * result.residual[row] / scale),
        )
        for row in rows
    ]
    return tuple(sorted(found, key=lambda one: (-abs(one.z), one.run, one.seq)))


def _orders(result: GlobalResult) -> OrderReport | None:
    orders = result.orders
    if orders is None:
        return None
    return OrderReport(
        orders.degrees,
        orders.highest,
        orders.parts,
        orders.held_out_full_um,
        orders.held_out_um,
        orders.held_out_none_um,
    )
