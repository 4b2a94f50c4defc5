"""`identify --method global`: all readings at once, on the exact model."""

from dataclasses import replace

import numpy as np

from trueaxis.faults import Fault, InputError
from trueaxis.identify.global_fit import describe
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.layout import Layout, layout
from trueaxis.identify.global_fit.least_squares import RANK_TOLERANCE, Factors, Gauge, factors, gauge
from trueaxis.identify.global_fit.result import GlobalOptions, GlobalResult
from trueaxis.identify.machine import IdentifiedMachine, lever
from trueaxis.identify.noise import noise
from trueaxis.identify.notes import dimension_notes, weak_notes
from trueaxis.identify.observations import Observations
from trueaxis.identify.report import BlockReport, Identification, IdentificationReport
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.errors import ErrorValues

CONVERGED = 1e-14  # mm, rotations times the lever
MOST_ITERATIONS = 20


def identify_global(
    machine: IdentifiedMachine, observed: Observations, options: GlobalOptions | None = None
) -> Identification:
    """Least squares over all readings, equally weighted: Gauss-Newton steps on the exact model.

    The derivative is that of the error-free machine throughout: it is wrong by the size of the errors (1e-4 or
    less), so that each step leaves that share of the last one. Memory: a piece of the design matrix and a few
    matrices of n_unknowns squared. Raises InputError where the readings hold no unknown at all.
    """
    options = options or GlobalOptions()
    given = replace(options.known or ErrorValues(machine.name), u={}, undetermined=())
    if options.squareness == "known":
        zeros = dict.fromkeys(machine.location_errors, 0.0)
        given = replace(given, parameters={**zeros, **given.parameters})
    machine = machine.with_values(given)
    plan = layout(machine, observed, given, options.degree)
    design = Design(plan, observed)
    triangle, held = design.triangle()
    if not held.any():
        raise InputError([Fault(observed.source, "", "no reading holds an unknown", "runs that move an axis")])
    found = factors(triangle)
    moved = gauge(plan, found.null, level=options.squareness == "convention")
    scaled, residual, iterations, change = _solve(design, found, moved, given)
    used = residual[held]  # a reading that holds no unknown, as at home, says nothing of noise
    spread = noise(float(used @ used), used.size, found.rank, options.noise_um)
    covariance = None
    if spread.sigma is not None:
        size = plan.scale[:, np.newaxis] * moved.projector
        covariance = spread.sigma**2 * (size @ found.covariance() @ size.T)
    is_open = np.abs(moved.null).max(axis=1, initial=0.0) > describe.OPEN
    result = GlobalResult(
        plan, observed, given, options, found, moved, used.size, scaled * plan.scale, covariance, is_open, residual,
        iterations, change, spread,
    )  # fmt: skip
    return _identification(result)


def _solve(
    design: Design, found: Factors, moved: Gauge, given: ErrorValues
) -> tuple[FloatArray, FloatArray, int, float]:
    """Scaled unknowns, residuals (mm), iterations, and the last change (mm)."""
    plan, observed = design.layout, design.observed
    unknowns = np.zeros(plan.count)
    change, before, iteration = np.inf, np.inf, 0
    residual = _residual(plan, observed, given, unknowns)
    while change > CONVERGED and iteration < MOST_ITERATIONS and not (iteration > 3 and change > 0.5 * before):
        following = moved.projector @ (unknowns + found.step(design.transposed(residual)))
        before, change = change, float(np.max(np.abs(following - unknowns), initial=0.0))
        unknowns = following
        residual = _residual(plan, observed, given, unknowns)
        iteration += 1
    return unknowns, residual, iteration, change


def _residual(plan: Layout, observed: Observations, given: ErrorValues, unknowns: FloatArray) -> FloatArray:
    model = plan.machine.with_values(plan.values(unknowns * plan.scale, given))
    return observed.reading - expected_readings(model, observed.runs, observed.run, observed.positions)


def _identification(result: GlobalResult) -> Identification:
    plan = result.layout
    curves, u = describe.curves(result), describe.location_u(result)
    undetermined = describe.undetermined(result)
    found = describe.components(result)
    fitted = plan.values(result.unknowns, result.given)
    values = replace(
        fitted,
        motion_errors={**fitted.motion_errors, **curves, **result.given.motion_errors},
        u=u,
        undetermined=undetermined,
    )
    block = BlockReport(
        runs=tuple(run.id for run in result.observed.runs),
        components=plan.names(),
        equations=result.held,
        unknowns=plan.count,
        rank=result.factors.rank,
        condition=result.factors.condition,
    )
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
        notes=(*dimension_notes(plan.machine, result.given), *weak_notes(found)),
    )
    return Identification(values, report)
