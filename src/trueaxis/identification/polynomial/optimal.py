"""The optimal polynomial of an error component (Sects. 4.2-4.3 of the paper), by stepwise regression, and its verdict.

Stepwise by Akaike's criterion, as R's step(direction = "both") does it.
"""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from trueaxis.identification.polynomial.records import (
    OptimalFit,
    PolynomialFit,
    Samples,
    Step,
    StepReason,
    checked_samples,
)
from trueaxis.identification.polynomial.regression import ReducedSystem, empty_fit, fit_terms, reduced_system

MAX_ORDER = 7
"""The order of the paper's polynomials before optimisation (Eq. 49)."""


def fit_optimal(
    positions: ArrayLike,
    values: ArrayLike,
    *,
    weights: ArrayLike | None = None,
    max_order: int = MAX_ORDER,
    order: int | None = None,
    alpha: float = 0.05,
) -> OptimalFit:
    """Fit the optimal polynomial without constant term to discrete values of one error component.

    positions: (n,) mm or deg; values: (n,) mm or rad; weights: (n,) proportional to 1/u^2, u being the
    standard uncertainties of the values (only their ratios count: the residuals set the level, as in R's lm).
    `order` starts from all powers up to it instead of the order that the mean square error picks among
    1..max_order.

    1. The order is the one of least residual mean square RSS / (n - order), the lowest of equals.
    2. All powers up to it are fitted. If their F test fails at `alpha`, the component has no polynomial: it
       stays empty.
    3. Stepwise regression by AIC, both directions, within those powers.
    4. While the F test or a t test fails, the least significant term leaves for good and step 3 is repeated
       without it.

    Raises ValueError on values that are not finite, on shapes that differ, on fewer than two points, on
    positions that are all zero, and on an `order` that the points do not determine.
    """
    return fit_samples(checked_samples(positions, values, weights), max_order=max_order, order=order, alpha=alpha)


def fit_samples(
    samples: Samples, *, max_order: int = MAX_ORDER, order: int | None = None, alpha: float = 0.05
) -> OptimalFit:
    """`fit_optimal` for samples that are at hand. Where their covariance is known, AIC picks the order as well."""
    _check_options(max_order, order, alpha)
    if samples.all_zero:
        empty = empty_fit(samples)
        verdict = "every value is zero: the polynomial is empty"
        return OptimalFit(
            samples=samples,
            alpha=alpha,
            mean_squares=(),
            order=0,
            before=empty,
            after=empty,
            steps=(),
            passed=False,
            verdict=verdict,
        )
    system = reduced_system(samples, max_order if order is None else order)
    if order is not None and system.order < order:
        raise ValueError(f"the {samples.values.size} points determine powers up to {system.order} only, not {order}")
    mean_squares = tuple(system.mean_square(_all_up_to(tried)) for tried in range(1, system.order + 1))
    # with a known covariance the residual mean square says little; Mallows' Cp, which is then the AIC, judges
    judged = [system.aic(_all_up_to(tried)) for tried in range(1, system.order + 1)] if system.known else mean_squares
    chosen = order if order is not None else int(np.argmin(judged)) + 1
    before = fit_terms(samples, _all_up_to(chosen))
    steps: tuple[Step, ...] = (Step("start", "", before.powers, before.aic),)
    after = empty_fit(samples)
    if before.f_p_value < alpha:
        after, more = _reduce_until_significant(samples, system, before.powers, alpha)
        steps += more
    passed, verdict = after.significant(alpha), _verdict_of(before, after, alpha)
    return OptimalFit(
        samples=samples,
        alpha=alpha,
        mean_squares=mean_squares,
        order=chosen,
        before=before,
        after=after,
        steps=steps,
        passed=passed,
        verdict=verdict,
    )


def _reduce_until_significant(
    samples: Samples, system: ReducedSystem, scope: tuple[int, ...], alpha: float
) -> tuple[PolynomialFit, tuple[Step, ...]]:
    """Alternate the AIC search with removing the least significant term; the scope shrinks, so it ends."""
    powers, steps = step_by_aic(system, scope, scope)
    fit = fit_terms(samples, powers)
    while fit.powers and not fit.significant(alpha):
        worst = fit.powers[int(np.argmax(fit.p_values))]
        reason: StepReason = "t test" if fit.p_values.max() >= alpha else "F test"
        scope = tuple(power for power in scope if power != worst)
        powers = tuple(power for power in fit.powers if power != worst)
        steps += (Step(reason, f"-{worst}", powers, system.aic(powers)),)
        powers, more = step_by_aic(system, powers, scope)
        steps += more
        fit = fit_terms(samples, powers)
    return fit, steps


def _all_up_to(order: int) -> tuple[int, ...]:
    return tuple(range(1, order + 1))


def _check_options(max_order: int, order: int | None, alpha: float) -> None:
    if max_order < 1 or (order is not None and order < 1):
        raise ValueError("the order of a polynomial without constant term is at least 1")
    if not 0 < alpha < 1:
        raise ValueError(f"the significance level alpha lies between 0 and 1, not at {alpha}")


def step_by_aic(
    system: ReducedSystem, start: tuple[int, ...], scope: tuple[int, ...]
) -> tuple[tuple[int, ...], tuple[Step, ...]]:
    """Powers at which no term put in (out of `scope`) or taken out lowers the AIC, and the steps there.

    Of equally good moves the first counts, staying before leaving out before putting in, as in R. Every move
    lowers the AIC, so that no model comes twice and the search ends.
    """
    powers, criterion = start, system.aic(start)
    steps: list[Step] = []
    while True:
        candidates = [(system.aic(to), to, change) for change, to in _neighbours(powers, scope)]
        best, to, change = min(candidates, key=lambda candidate: candidate[0], default=(criterion, powers, ""))
        if best >= criterion:
            return powers, tuple(steps)
        powers, criterion = to, best
        steps.append(Step("AIC", change, powers, criterion))


def _neighbours(powers: tuple[int, ...], scope: tuple[int, ...]) -> Iterator[tuple[str, tuple[int, ...]]]:
    for power in powers:
        yield f"-{power}", tuple(other for other in powers if other != power)
    for power in scope:
        if power not in powers:
            yield f"+{power}", tuple(sorted((*powers, power)))


def _verdict_of(before: PolynomialFit, after: PolynomialFit, alpha: float) -> str:
    """One sentence on what the optimisation found."""
    if not after.powers:
        return (
            f"no polynomial describes the values at the {alpha:g} level "
            f"(F test of the order-{len(before.powers)} equation: p = {before.f_p_value:.3g})"
        )
    kept = ", ".join(f"x^{power}" if power > 1 else "x" for power in after.powers)
    return (
        f"{len(after.powers)} of {len(before.powers)} terms kept ({kept}); "
        f"F test p = {after.f_p_value:.3g}, largest t test p = {after.p_values.max():.3g}, both below {alpha:g}"
    )


def statistics_table(fit: OptimalFit, unit: str, units_per_si: float) -> str:
    """Statistics before and after optimisation side by side, after the paper's Fig. 15.

    unit: what the residual standard error is shown in (um, urad); units_per_si: how many of them make one mm
    or rad. Where the covariance of the values is known it is in units of their standard uncertainty.
    """
    both = (fit.before, fit.after)
    if fit.samples.whitening is not None:
        unit, units_per_si = "in u", 1.0
    rows: list[list[str]] = [["", "before", "after"], ["terms", *(str(len(side.powers)) for side in both)]]
    for label, name, factor in (
        (f"residual standard error ({unit})", "residual_standard_error", units_per_si),
        ("R^2 (uncentred)", "r_squared", 1.0),
        ("adjusted R^2", "adjusted_r_squared", 1.0),
        ("AIC", "aic", 1.0),
        ("p of the equation (F)", "f_p_value", 1.0),
    ):
        rows.append([label, *(_figure(getattr(side, name) * factor) for side in both)])
    sides = [dict(zip(side.powers, side.p_values, strict=True)) for side in both]
    for power in fit.before.powers:
        rows.append([f"p of x^{power} (t)", *(_figure(side.get(power, math.nan)) for side in sides)])
    return "\n".join(f"{label:<32}{left:>14}{right:>14}" for label, left, right in rows)


def _figure(value: float) -> str:
    """A dash where an equation without terms has no such figure."""
    return f"{value:.5g}" if math.isfinite(value) else "-"
