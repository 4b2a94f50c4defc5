"""`identify --method global`: all readings at once, on the exact model."""

from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.effects.unknowns import EffectUnknowns
from trueaxis.estimation.machine import IdentifiedMachine
from trueaxis.estimation.observations import Observations
from trueaxis.faults import Fault, InputError
from trueaxis.identify.fit_quality import NotConvergedError, run_residuals, stands_still
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.effects import (
    Degree,
    Setting,
    below_zero,
    start_of,
    started,
    trimmed,
    unknown_effects,
    with_locations,
    with_way_given,
    with_zeros,
)
from trueaxis.identify.global_fit.instruments import instruments
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE, Factors, Gauge, factors, gauge
from trueaxis.identify.global_fit.order import Orders, choose_orders
from trueaxis.identify.global_fit.result import AUTO_DEGREE, HIGHEST_AUTO, OPEN, GlobalOptions, GlobalResult
from trueaxis.identify.global_fit.robust import variance_factor
from trueaxis.identify.global_fit.solve import Solution, residuals, solve_robust
from trueaxis.identify.global_fit.write_up import identification, residuals_of
from trueaxis.identify.noise import Noise, noise
from trueaxis.identify.report import Identification
from trueaxis.identify.weighting import NoiseModel, Weighting, weighting
from trueaxis.measure.columns import BoolArray
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.errors import ErrorValues

# The steps use the derivative of the error-free machine, which is wrong by the size of the errors (1e-4 or so). Along
# combinations that the readings hold by less than that they can lead away; these then count as not determined.
RANK_TOLERANCES = (RANK_TOLERANCE, 1e-5, 1e-4, 1e-3)


def identify_global(
    machine: IdentifiedMachine, observed: Observations, options: GlobalOptions | None = None
) -> Identification:
    """Least squares over all readings, weighted by their noise: Gauss-Newton steps on the exact model.

    The derivative is that of the error-free machine throughout: it is wrong by the size of the errors (1e-4 or
    less), so that each step leaves that share of the last one. Where the term of an effect is not linear in its
    parameters, it is linearised anew at each step, from the best point of a grid on. Memory: a piece of the design
    matrix and a few matrices of n_unknowns squared. Raises InputError where the readings hold no unknown at all, or
    lack a column that an effect depends on; NotConvergedError where the fit does not stand still.
    """
    options = options or GlobalOptions()
    result = fit_global(machine, observed, options)
    if not result.converged:
        raise NotConvergedError(run_residuals(residuals_of(result), observed.runs), result.iterations)
    return identification(result)


def fit_global(machine: IdentifiedMachine, observed: Observations, options: GlobalOptions) -> GlobalResult:
    """The fit before it is put in words; as `identify_global`."""
    given = with_locations(machine, replace(options.known or ErrorValues(machine.name), u={}, undetermined=()))
    if options.squareness == "known":
        zeros = dict.fromkeys(machine.location_errors, 0.0)
        given = replace(given, parameters={**zeros, **given.parameters})
    machine = machine.with_values(given)
    weighted = weighting(observed, NoiseModel(options.noise_um, options.noise_by_group, options.repeats))
    unknown = unknown_effects(machine, observed, given, options.start)
    observed = unknown.observed or observed
    own = with_way_given(instruments(machine, observed, options.instruments), unknown, observed)
    setting = Setting(machine, observed, given, own, weighted.roots, options.squareness == "convention")
    degree, orders = options.degree, None
    highest = HIGHEST_AUTO if degree == AUTO_DEGREE else degree
    first = trimmed(setting, highest, unknown) if options.robust else setting
    effects = started(first, highest, unknown)
    if degree == AUTO_DEGREE:
        effects, orders = _chosen_orders(setting, first, effects)
        degree = orders.degrees
    fit = _fit(setting, first, degree, effects, options, weighted)
    zeroed = below_zero(fit.design.layout, fit.solution.unknowns)
    if zeroed:
        setting = replace(setting, given=with_zeros(given, zeroed))
        effects = effects.without(one.effect for one in zeroed)
        fit = _fit(setting, replace(first, given=setting.given), degree, effects, options, weighted)
    plan, found, solution = fit.design.layout, fit.factors, fit.solution
    spread, variance = _spread(solution, weighted, fit.held, found, options)
    covariance = None
    if spread.sigma is not None:
        size = plan.scale[:, np.newaxis] * fit.gauge.projector
        covariance = variance * (size @ found.covariance() @ size.T)
    return GlobalResult(
        layout=plan,
        observed=observed,
        given=setting.given,
        options=options,
        factors=found,
        gauge=fit.gauge,
        held=int(fit.held.sum()),
        unknowns=solution.unknowns * plan.scale,
        covariance=covariance,
        open=np.abs(fit.gauge.null).max(axis=1, initial=0.0) > OPEN,
        residual=solution.residual,
        roots=weighted.roots,
        robust_weight=solution.weight,
        iterations=solution.iterations,
        change=solution.change,
        noise=spread,
        groups=weighted.groups,
        orders=orders,
        zeroed=tuple(one.effect for one in zeroed),
        converged=_stands(fit, spread),
    )


@dataclass(frozen=True, slots=True, eq=False)
class _Fit:
    """A solution, and the design and its factors where it is; held: (n_readings,), readings that hold an unknown."""

    design: Design
    factors: Factors
    gauge: Gauge
    solution: Solution
    held: BoolArray


def _fit(
    setting: Setting,
    first: Setting,
    degree: Degree,
    effects: EffectUnknowns,
    options: GlobalOptions,
    weighted: Weighting,
) -> _Fit:
    design = setting.design(degree, effects)
    triangle, held = design.triangle()
    if not held.any():
        raise _nothing_held(setting)
    for least in RANK_TOLERANCES:
        found = factors(triangle, least)
        moved = gauge(design.layout, found.null, setting.level)
        if effects.curved and options.robust:
            solution = first.solved(first.design(degree, effects))
        else:
            solution = setting.solved(design, found, moved)
        fit = _Fit(design, found, moved, solution, held)
        if effects.curved or _stands(fit, _spread(solution, weighted, held, found, replace(options, robust=""))[0]):
            break
    if options.robust:

        def again(reweighted: Design, start: FloatArray) -> Solution:
            return setting.solved(reweighted, moved=moved, start=start, least=least)

        solution = solve_robust(design, solution, again, options.robust, weighted.sigma, held)
    if effects.curved:
        design = design.at(solution.unknowns, setting.given)
        triangle, held = design.triangle()
        found = factors(triangle)
        moved = gauge(design.layout, found.null, setting.level)
    return _Fit(design, found, moved, solution, held)


def _nothing_held(setting: Setting) -> InputError:
    return InputError([Fault(setting.observed.source, "", "no reading holds an unknown", "runs that move an axis")])


def _stands(fit: _Fit, spread: Noise) -> bool:
    """Whether the last step is none for readings of that noise."""
    root = fit.gauge.projector @ (fit.factors.vectors / fit.factors.singular)
    u = np.linalg.norm(root, axis=1)
    return fit.solution.still and stands_still(fit.solution.step, u, spread.sigma)


def _chosen_orders(setting: Setting, first: Setting, effects: EffectUnknowns) -> tuple[EffectUnknowns, Orders]:
    """Degrees by held-out readings, to first order: beside effects where a fit of the highest degree has them."""
    full = setting.design(HIGHEST_AUTO, effects)
    if effects.curved:
        full = full.at(first.solved(first.design(HIGHEST_AUTO, effects)).unknowns, setting.given)
    if not any(piece.any() for _, piece in full.pieces()):
        raise _nothing_held(setting)
    residual = residuals(full, setting.given, start_of(full))
    return full.layout.effects, choose_orders(full, residual, HIGHEST_AUTO)


def _spread(
    solution: Solution, weighted: Weighting, held: BoolArray, found: Factors, options: GlobalOptions
) -> tuple[Noise, float]:
    """The noise of a reading of weight 1, and the variance that goes with the normal matrix."""
    used = (weighted.roots * solution.residual)[held]  # a reading that holds no unknown says nothing of noise
    given = None if weighted.sigma is None else weighted.sigma * 1e3
    if not options.robust or not solution.scale:
        spread = noise(float(used @ used), used.size, found.rank, given, weighted.origin)
        return spread, 0.0 if spread.sigma is None else spread.sigma**2
    if given is None:
        spread = Noise(solution.scale, used.size - found.rank, "from the median of the residuals")
    else:
        spread = Noise(solution.scale, used.size - found.rank, weighted.origin)
    return spread, _robust_variance(used, solution.scale, found.rank, options)


def _robust_variance(used: FloatArray, scale: float, rank: int, options: GlobalOptions) -> float:
    freedom = used.size - rank
    factor = variance_factor(used / scale, options.robust, rank) if freedom > 0 else 1.0
    return scale**2 * factor
