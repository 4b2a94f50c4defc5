"""Gauss-Newton on the exact model, plain or reweighted."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.identify.fit_quality import RESOLUTION
from trueaxis.identify.global_fit.design import Design
from trueaxis.identify.global_fit.least_squares import Factors, Gauge, factors, gauge
from trueaxis.identify.global_fit.robust import CONVERGED as SETTLED
from trueaxis.identify.global_fit.robust import MOST_ITERATIONS as MOST_REWEIGHTINGS
from trueaxis.identify.global_fit.robust import Robust, scale_of, weights
from trueaxis.measure.columns import BoolArray
from trueaxis.measure.machine import FloatArray
from trueaxis.measure.reading_model import expected_readings
from trueaxis.runtime.errors import ErrorValues

CONVERGED = 1e-14  # mm, rotations times the lever
MOST_ITERATIONS = 20
MOST_CURVED = 60  # where effects make the design matrix change with the values
MOST_HALVINGS = 12
NOTHING = 1e-12  # share of the squares by which they may fall for a step to be of no use
NEAR = 1e-6  # mm: steps below it are taken as they are, and where they do not shrink, that is rounding
GROWTH = 4.0  # of the squares: the steps lead away from the solution
MOST_PROMISED = 1e-3  # the same where columns change with the values, and the last step may be half of what is possible
STILL = 1e-6  # share of the squares, by which they may change in the last step


@dataclass(frozen=True, slots=True, eq=False)
class Solution:
    """unknowns: (n,), scaled; residual: (n_readings,), mm; iterations on the exact model and the last change (mm);
    step: (n,), the last one, scaled, infinite where the steps led away; still: whether the squares changed no more;
    weight: (n_readings,), robust weights, and scale (mm): 1 and None where the solution is that of least squares.
    """

    unknowns: FloatArray
    residual: FloatArray
    iterations: int
    change: float
    step: FloatArray
    still: bool
    weight: FloatArray
    scale: float | None = None


def solve(
    design: Design, found: Factors, moved: Gauge, given: ErrorValues, start: FloatArray | None = None
) -> Solution:
    """Least squares with the weights of the design. The derivative is that of the error-free machine throughout."""
    change, before, iteration = np.inf, np.inf, 0
    unknowns = np.zeros(design.layout.count) if start is None else start
    residual = residuals(design, given, unknowns)
    squares = first = _squares(design, residual)
    step, still = np.full(unknowns.size, np.inf), False
    while change > CONVERGED and iteration < MOST_ITERATIONS and not (iteration > 3 and change > 0.5 * before):
        following = moved.projector @ (unknowns + found.step(design.transposed(residual)))
        step = following - unknowns
        before, change = change, float(np.max(np.abs(step), initial=0.0))
        unknowns = following
        residual = residuals(design, given, unknowns)
        after = _squares(design, residual)
        iteration += 1
        if not after <= GROWTH * first + _rounding(design):
            return Solution(
                unknowns, residual, iteration, change, np.full(step.size, np.inf), False, np.ones(residual.size)
            )
        still, squares = abs(squares - after) <= STILL * squares + _rounding(design), after
    return Solution(unknowns, residual, iteration, change, step, still, np.ones(residual.size))


def solve_curved(
    design: Design, given: ErrorValues, level: bool, start: FloatArray, tolerance: float = CONVERGED
) -> Solution:
    """The same where columns change with the values: linearised anew at each step, which is halved until it is none
    for the worse. level: whether straightness is levelled (see `gauge`); tolerance: of the last change, mm.
    """
    change, before, iteration = np.inf, np.inf, 0
    unknowns, residual = start, residuals(design, given, start)
    last, still = np.full(start.size, np.inf), False
    while change > tolerance and iteration < MOST_CURVED and not (before < NEAR and change > 0.5 * before):
        here = design.at(unknowns, given)
        triangle, _ = here.triangle()
        found = factors(triangle)
        moved = gauge(here.layout, found.null, level)
        gradient = here.transposed(residual)
        step = found.step(gradient)
        promised = float(gradient @ step)
        following, after = _careful(here, given, moved, (unknowns, residual), step, promised)
        last = following - unknowns
        before, change = change, float(np.max(np.abs(last), initial=0.0))
        squares = _squares(design, after)
        # where no part of the step is for the better, what it promised says how far the solution is
        fell = max(_squares(design, residual) - squares, promised if change == 0.0 else 0.0)
        still = fell <= MOST_PROMISED * squares + _rounding(design)
        unknowns, residual = following, after
        iteration += 1
    return Solution(unknowns, residual, iteration, change, last, still, np.ones(residual.size))


def _careful(
    design: Design,
    given: ErrorValues,
    moved: Gauge,
    now: tuple[FloatArray, FloatArray],
    step: FloatArray,
    promised: float,
) -> tuple[FloatArray, FloatArray]:
    """Unknowns and residuals after the step or a part of it; now: those before; promised: by how much the squares fall
    after the whole step, were the model linear.
    """
    unknowns, residual = now
    squares = _squares(design, residual)
    for halving in range(MOST_HALVINGS):
        following = moved.projector @ (unknowns + 0.5**halving * step)
        if not design.within(following):
            continue
        after = residuals(design, given, following)
        near = float(np.max(np.abs(following - unknowns), initial=0.0)) < NEAR
        if near or _squares(design, after) <= squares:
            return following, after
        if promised <= NOTHING * squares:
            break  # where they grow nevertheless, the convention for what is open has changed: no part of it is better
    return now


def solve_robust(
    design: Design,
    start: Solution,
    again: Callable[[Design, FloatArray], Solution],
    kind: Robust,
    sigma: float | None,
    held: BoolArray,
) -> Solution:
    """Reweight and solve until no weight changes; again: solves with a weighted design, from unknowns; sigma: scale of
    a reading of weight 1 (mm), None: from the medians of the readings that are held: (n_readings,), those that hold an
    unknown.

    Tukey's function is not convex: Huber's solution is where it starts, and for it the scale is estimated.
    """
    roots = np.ones(start.residual.size) if design.roots is None else design.roots
    found = start
    stages: tuple[Robust, ...] = ("huber",) if kind == "huber" else ("huber", "tukey")
    for stage in stages:
        for _ in range(MOST_REWEIGHTINGS):
            scale = scale_of((roots * found.residual)[held]) if sigma is None else sigma
            if scale == 0.0:
                return replace(found, scale=0.0)  # most readings are met exactly: nothing to weigh by
            weight = weights(roots * found.residual / scale, stage)
            settled = float(np.abs(weight - found.weight).max()) < SETTLED
            if settled:
                break
            weighted = Design(design.layout, design.observed, roots * np.sqrt(weight))
            following = again(weighted, found.unknowns)
            step = following.step if np.isinf(following.step).any() else following.unknowns - found.unknowns
            iterations = found.iterations + following.iterations
            found = replace(following, weight=weight, scale=scale, iterations=iterations, step=step)
    return found


def residuals(design: Design, given: ErrorValues, unknowns: FloatArray) -> FloatArray:
    """(n_readings,), mm: reading less what the exact model with scaled unknowns expects."""
    plan, observed = design.layout, design.observed
    model = plan.machine.with_values(plan.values(unknowns * plan.scale, given))
    own = unknowns[plan.of_instruments]
    runs = plan.instruments.set_up(observed.runs, own)
    expected = expected_readings(model, runs, observed.run, observed.positions, observed.context)
    return observed.reading - expected - plan.instruments.added(plan.machine, observed, own)


def _rounding(design: Design) -> float:
    """Squares below which nothing is read, mm^2."""
    return design.observed.reading.size * RESOLUTION**2


def _squares(design: Design, residual: FloatArray) -> float:
    weighted = residual if design.roots is None else design.roots * residual
    return float(weighted @ weighted)
