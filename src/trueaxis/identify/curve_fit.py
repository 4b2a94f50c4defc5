"""Tables of identified components to optimal polynomials (Sects. 4.2-4.3 of the paper)."""

from collections.abc import Mapping

import numpy as np

from trueaxis.identify.polynomial import fit_optimal
from trueaxis.runtime.curves import Curve, PolynomialCurve, TableCurve


def polynomial_curves(curves: Mapping[str, Curve]) -> tuple[dict[str, Curve], tuple[str, ...]]:
    """Each table as its optimal polynomial, weighted by its uncertainties where it has them.

    A component with no significant term is left out: zero. What cannot be fitted stays a table, with a note.
    """
    found: dict[str, Curve] = {}
    notes: list[str] = []
    for name, curve in curves.items():
        if not isinstance(curve, TableCurve):
            found[name] = curve
            continue
        fitted = _polynomial(curve)
        if fitted is None:
            found[name] = curve
            notes.append(f"{name} stays a table: too few positions for a polynomial")
        elif fitted.powers:
            found[name] = fitted
        else:
            notes.append(f"{name} is left at zero: no polynomial term is significant")
    return found, tuple(notes)


def _polynomial(curve: TableCurve) -> PolynomialCurve | None:
    positions, values = np.array(curve.positions), np.array(curve.values)
    away = positions != 0.0  # where every polynomial without a constant is zero anyway
    if np.count_nonzero(away) < 3:
        return None
    weights = None
    if curve.u is not None:
        u = np.array(curve.u)[away]
        if np.isfinite(u).all() and (u > 0.0).all():
            weights = (u.max() / u) ** 2
    after = fit_optimal(positions[away], values[away], weights=weights).after
    return PolynomialCurve(
        tuple(after.powers), tuple(np.asarray(after.coefficients).tolist()), tuple(np.asarray(after.u).tolist())
    )
