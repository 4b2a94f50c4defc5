"""`identify --method global`: all readings at once, on the exact model."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from trueaxis.faults import Fault, InputError
from trueaxis.identify.global_fit import describe
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.instruments import instruments
from trueaxis.identify.global_fit.layout import layout
from trueaxis.identify.global_fit.least_squares import Factors, factors, gauge
from trueaxis.identify.global_fit.order import choose_orders
from trueaxis.identify.global_fit.result import AUTO_DEGREE, HIGHEST_AUTO, GlobalOptions, GlobalResult
from trueaxis.identify.global_fit.robust import variance_factor
from trueaxis.identify.global_fit.solve import Solution, residuals, solve, solve_robust
from trueaxis.identify.global_fit.write_up import identification
from trueaxis.identify.machine import IdentifiedMachine
from trueaxis.identify.noise import Noise, noise
from trueaxis.identify.observations import Observations
from trueaxis.identify.report import Identification
from trueaxis.identify.weighting import NoiseModel, Weighting, weighting
from trueaxis.measure.columns import BoolArray
from trueaxis.measure.machine import FloatArray
from trueaxis.runtime.errors import ErrorValues


def identify_global(
    machine: IdentifiedMachine, observed: Observations, options: GlobalOptions | None = None
) -> Identification:
    """Least squares over all readings, weighted by their noise: Gauss-Newton steps on the exact model.

    The derivative is that of the error-free machine throughout: it is wrong by the size of the errors (1e-4 or
    less), so that each step leaves that share of the last one. Memory: a piece of the design matrix and a few
    matrices of n_unknowns squared. Raises InputError where the readings hold no unknown at all.
    """
    options = options or GlobalOptions()
    return identification(fit_global(machine, observed, options))


def fit_global(machine: IdentifiedMachine, observed: Observations, options: GlobalOptions) -> GlobalResult:
    """The fit before it is put in words; as `identify_global`."""
    given = replace(options.known or ErrorValues(machine.name), u={}, undetermined=())
    if options.squareness == "known":
        zeros = dict.fromkeys(machine.location_errors, 0.0)
        given = replace(given, parameters={**zeros, **given.parameters})
    machine = machine.with_values(given)
    weighted = weighting(observed, NoiseModel(options.noise_um, options.noise_by_group, options.repeats))
    unknown = instruments(machine, observed, options.instruments)
    degree, orders = options.degree, None
    if degree == AUTO_DEGREE:
        full = Design(layout(machine, observed, given, HIGHEST_AUTO, unknown), observed, weighted.roots)
        orders = choose_orders(full, residuals(full, given, np.zeros(full.layout.count)), HIGHEST_AUTO)
        degree = orders.degrees
    assert isinstance(degree, int | Mapping)
    plan = layout(machine, observed, given, degree, unknown)
    design = Design(plan, observed, weighted.roots)
    triangle, held = design.triangle()
    if not held.any():
        raise InputError([Fault(observed.source, "", "no reading holds an unknown", "runs that move an axis")])
    found = factors(triangle)
    moved = gauge(plan, found.null, level=options.squareness == "convention")
    solution = solve(design, found, moved, given)
    if options.robust:
        solution = solve_robust(design, solution, moved, given, options.robust, weighted.sigma, held)
    spread, variance = _spread(solution, weighted, held, found, options)
    covariance = None
    if spread.sigma is not None:
        size = plan.scale[:, np.newaxis] * moved.projector
        covariance = variance * (size @ found.covariance() @ size.T)
    return GlobalResult(
        layout=plan,
        observed=observed,
        given=given,
        options=options,
        factors=found,
        gauge=moved,
        held=int(held.sum()),
        unknowns=solution.unknowns * plan.scale,
        covariance=covariance,
        open=np.abs(moved.null).max(axis=1, initial=0.0) > describe.OPEN,
        residual=solution.residual,
        roots=weighted.roots,
        robust_weight=solution.weight,
        iterations=solution.iterations,
        change=solution.change,
        noise=spread,
        groups=weighted.groups,
        orders=orders,
    )


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
