"""The optimal polynomial of an error component (Sects. 4.2-4.3 of the paper)."""

import numpy as np
from numpy.typing import ArrayLike

from trueaxis.identification.polynomial.records import OptimalFit, PolynomialFit, Step, StepReason
from trueaxis.identification.polynomial.reduced import ReducedSystem, reduced_system
from trueaxis.identification.polynomial.regression import empty_fit, fit_terms
from trueaxis.identification.polynomial.samples import Samples, checked_samples
from trueaxis.identification.polynomial.stepwise import step_by_aic
from trueaxis.identification.polynomial.verdict import verdict_of

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
    passed, verdict = after.significant(alpha), verdict_of(before, after, alpha)
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
