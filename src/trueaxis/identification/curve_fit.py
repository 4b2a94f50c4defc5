"""Tables of identified components to optimal polynomials (Sects. 4.2-4.3 of the paper)."""

from collections.abc import Mapping

import numpy as np

from trueaxis.identification.polynomial import OptimalFit, fit_optimal
from trueaxis.identification.polynomial.powers import scaled_powers, weighted_system
from trueaxis.identification.polynomial.samples import Samples
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import Curve, FloatArray, PolynomialCurve, TableCurve

_FEWEST = 3  # positions away from zero
LEAST_SHARE = 1e-6  # of the largest u: smaller ones weigh so much more that rounding decides, and all weigh alike


def fit_tables(curves: Mapping[str, Curve], *, max_order: int = 7, alpha: float = 0.05) -> dict[str, OptimalFit]:
    """The optimal polynomial of each table with enough positions, weighted by its uncertainties where it has them.

    Position zero is left out: there every polynomial without a constant is zero anyway.
    """
    fits: dict[str, OptimalFit] = {}
    for name, curve in curves.items():
        if not isinstance(curve, TableCurve):
            continue
        samples = _samples(curve)
        if samples.positions.size < _FEWEST:
            continue
        fits[name] = fit_optimal(
            samples.positions, samples.values, weights=samples.weights, max_order=max_order, alpha=alpha
        )
    return fits


def _samples(curve: TableCurve) -> Samples:
    """The values of a table away from position 0, weighted where all have an uncertainty."""
    away = np.array(curve.positions) != 0.0
    weights = np.ones(np.count_nonzero(away))
    if curve.u is not None:
        u = np.array(curve.u)[away]
        if np.isfinite(u).all() and (u > LEAST_SHARE * u.max(initial=0.0)).all():
            weights = (u.max(initial=0.0) / u) ** 2
    return Samples(positions=np.array(curve.positions)[away], values=np.array(curve.values)[away], weights=weights)


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
            coefficients, u = tuple(after.coefficients.tolist()), tuple(after.u.tolist())
            found[name] = PolynomialCurve(powers=after.powers, coefficients=coefficients, u=u, measured=curve.measured)
        else:
            notes.append(f"{name} is left at zero: no polynomial term is significant")
    return found, tuple(notes)


def in_polynomials(covariance: Covariance, tables: Mapping[str, Curve], curves: Mapping[str, Curve]) -> Covariance:
    """The covariance of tables after polynomials have replaced them: their values are linear in those of the tables.

    A component that has no polynomial among `curves` keeps its covariance: what is left at zero is as uncertain as its
    values were.
    """
    return covariance.smoothed(
        {
            name: _smoothing(table, curve.powers)
            for name, table in tables.items()
            if isinstance(table, TableCurve) and isinstance(curve := curves.get(name), PolynomialCurve)
        }
    )


def _smoothing(table: TableCurve, powers: tuple[int, ...]) -> FloatArray:
    """(n, n): values of the fitted polynomial at the positions of a table, by the values of the table."""
    samples = _samples(table)
    design, _, exponent = weighted_system(samples, powers)
    away = np.array(table.positions) != 0.0
    coefficients = np.zeros((len(powers), len(table.positions)))
    coefficients[:, away] = np.linalg.pinv(design) * np.sqrt(samples.weights)
    return np.asarray(scaled_powers(np.array(table.positions), powers, exponent) @ coefficients)
