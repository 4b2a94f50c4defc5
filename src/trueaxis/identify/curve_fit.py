"""Tables of identified components to optimal polynomials (Sects. 4.2-4.3 of the paper)."""

from collections.abc import Mapping

import numpy as np

from trueaxis.identify.polynomial import OptimalFit, fit_optimal
from trueaxis.identify.polynomial.powers import to_position_powers, weighted_system
from trueaxis.identify.polynomial.samples import Samples
from trueaxis.runtime.bases import Basis, PowerBasis
from trueaxis.runtime.covariance import Covariance
from trueaxis.runtime.curves import Curve, FloatArray, PolynomialCurve, TableCurve

_FEWEST = 3  # positions away from zero


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
        if np.isfinite(u).all() and (u > 0.0).all():
            weights = (u.max(initial=0.0) / u) ** 2
    return Samples(np.array(curve.positions)[away], np.array(curve.values)[away], weights)


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
            found[name] = PolynomialCurve(after.powers, coefficients, u, curve.measured)
        else:
            notes.append(f"{name} is left at zero: no polynomial term is significant")
    return found, tuple(notes)


def in_polynomials(covariance: Covariance, tables: Mapping[str, Curve], curves: Mapping[str, Curve]) -> Covariance:
    """The covariance of tables as that of the polynomials that replace them: coefficients are linear in the values.

    A component that has no polynomial among `curves` keeps the covariance of its table: what is left at zero is as
    uncertain as its values were.
    """
    changes: dict[str, tuple[Basis, FloatArray]] = {}
    for name, table in tables.items():
        curve = curves.get(name)
        if isinstance(table, TableCurve) and isinstance(curve, PolynomialCurve):
            changes[name] = PowerBasis(curve.powers), _by_value(table, curve.powers)
    return covariance.in_bases(changes)


def _by_value(table: TableCurve, powers: tuple[int, ...]) -> FloatArray:
    """(n_powers, n_positions): derivative of the coefficients by the values of the table."""
    samples = _samples(table)
    design, _, exponent = weighted_system(samples, powers)
    found = np.zeros((len(powers), len(table.positions)))
    away = np.array(table.positions) != 0.0
    scaled = np.asarray(np.linalg.pinv(design), dtype=np.float64) * np.sqrt(samples.weights)
    found[:, away] = to_position_powers(scaled.T, powers, exponent).T
    return found
