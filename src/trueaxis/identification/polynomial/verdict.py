"""The outcome of a polynomial fit in words and as a table for people."""

import math

from trueaxis.identification.polynomial.records import OptimalFit, PolynomialFit


def verdict_of(before: PolynomialFit, after: PolynomialFit, alpha: float) -> str:
    """One sentence on what the optimisation found."""
    if not after.powers:
        return (
            f"no polynomial describes the values at the {alpha:g} level "
            f"(F test of the order-{len(before.powers)} equation: p = {before.f_p_value:.3g}): it is empty"
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
