"""Tables of identified components to optimal polynomials (Sects. 4.2-4.3 of the paper)."""

from collections.abc import Mapping

import numpy as np

from trueaxis.identify.polynomial import OptimalFit, fit_optimal
from trueaxis.runtime.curves import Curve, PolynomialCurve, TableCurve

_FEWEST = 3  # positions away from zero


def fit_tables(curves: Mapping[str, Curve], *, max_order: int = 7, alpha: float = 0.05) -> dict[str, OptimalFit]:
    """The optimal polynomial of each table with enough positions, weighted by its uncertainties where it has them.

    Position zero is left out: there every polynomial without a constant is zero anyway.
    """
    fits: dict[str, OptimalFit] = {}
    for name, curve in curves.items():
        if not isinstance(curve, TableCurve):
            continue
        positions, values = np.array(curve.positions), np.array(curve.values)
        away = positions != 0.0
        if np.count_nonzero(away) < _FEWEST:
            continue
        weights = None
        if curve.u is not None:
            u = np.array(curve.u)[away]
            if np.isfinite(u).all() and (u > 0.0).all():
                weights = (u.max() / u) ** 2
        fits[name] = fit_optimal(positions[away], values[away], weights=weights, max_order=max_order, alpha=alpha)
    return fits


def polynomial_curves(
    curves: Mapping[str, Curve], fits: Mapping[str, OptimalFit]
) -> tuple[dict[str, Curve], tuple[str, ...]]:
    """The curves with each fitted table replaced by its polynomial, and notes on those that are not.

    A component with no significant term is left out: zero. A table without a fit stays a table.
    """
    found: dict[str, Curve] = {}
    notes: list[str] = []
    for name, curve in curves.items():
        if name not in fits:
            found[name] = curve
            if isinstance(curve, TableCurve):
                notes.append(f"{name} stays a table: too few positions for a polynomial")
        elif (after := fits[name].after).powers:
            coefficients, u = (tuple(np.asarray(part).tolist()) for part in (after.coefficients, after.u))
            found[name] = PolynomialCurve(tuple(after.powers), coefficients, u, curve.measured)
        else:
            notes.append(f"{name} is left at zero: no polynomial term is significant")
    return found, tuple(notes)
