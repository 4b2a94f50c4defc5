"""Tables of identified components to polynomials: by the paper's procedure (Sects. 4.2-4.3) or by held-out positions.

The positions are held out in parts, every tenth position in turn (each one where there are ten or fewer). For the
paper's procedure every part repeats the whole of it: order, F and t tests, stepwise selection. The other choice, which
does not overfit, is the lowest order whose squared errors exceed those of the best by no more than the standard error
of that difference over the parts.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.error_name import ErrorName
from trueaxis.estimation.machine import IntArray
from trueaxis.identification.polynomial import OptimalFit, PolynomialFit, fit_optimal, fit_terms
from trueaxis.identification.polynomial.records import Samples
from trueaxis.identification.polynomial.regression import scaled_powers, weighted_system
from trueaxis.identification.report import CurveOrderReport
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import Curve, FloatArray, PolynomialCurve, TableCurve

_FEWEST = 3  # positions away from zero
LEAST_SHARE = 1e-6  # of the largest u: smaller ones weigh so much more that rounding decides, and all weigh alike
MOST_PARTS = 10
Fit = Callable[[Samples], PolynomialFit]


def ordered_curves(
    curves: Mapping[str, Curve], choice: Literal["polynomial", "held-out"]
) -> tuple[dict[str, Curve], tuple[str, ...], tuple[CurveOrderReport, ...]]:
    """The curves, notes on those that stay as they are, and both choices of powers with their held-out errors."""
    fits = fit_tables(curves)
    checked = held_out(fits)
    found, notes = polynomial_curves(curves, fits)
    if choice == "held-out":
        notes = tuple(note for note in notes if "stays a table" in note)
        for name, one in checked.items():
            coefficients, u = tuple(one.fit.coefficients.tolist()), tuple(one.fit.u.tolist())
            found[name] = PolynomialCurve(
                powers=one.fit.powers, coefficients=coefficients, u=u, measured=curves[name].measured
            )
    orders = tuple(
        CurveOrderReport(
            name=name,
            by_paper=fits[name].after.powers,
            by_held_out=one.fit.powers,
            held_out_by_paper=one.rms_optimal,
            held_out=one.rms,
            unit=ErrorName(name).unit,
        )
        for name, one in checked.items()
    )
    return found, notes, orders


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


@dataclass(frozen=True, slots=True, eq=False)
class HeldOut:
    """Of one component: the polynomial of all powers up to the order chosen, its held-out rms, and that of the paper's
    procedure, mm or rad.
    """

    fit: PolynomialFit
    rms: float
    rms_optimal: float


def held_out(fits: Mapping[str, OptimalFit], *, max_order: int = 7) -> dict[str, HeldOut]:
    """For each optimal polynomial, its values being those it was fitted to."""
    return {name: _held_out(fit, max_order) for name, fit in fits.items()}


def _held_out(optimal: OptimalFit, max_order: int) -> HeldOut:
    samples = optimal.samples
    highest = min(max_order, _fewest_left(samples) - 1)
    errors = np.array([_errors(samples, _of_order(order)) for order in range(1, highest + 1)])
    order = _lowest(errors) + 1
    of_paper = _errors(samples, lambda part: _optimal(part, max_order, optimal.alpha))
    total = float(samples.weights.sum())
    return HeldOut(
        fit_terms(samples, tuple(range(1, order + 1))),
        float(np.sqrt(errors[order - 1].sum() / total)),
        float(np.sqrt(of_paper.sum() / total)),
    )


def _lowest(errors: FloatArray) -> int:
    """Row of the lowest order that is as good as the best; errors: (n_orders, n_parts)."""
    best = int(errors.sum(axis=1).argmin())
    excess = errors - errors[best]
    spread = excess.std(axis=1, ddof=1) * np.sqrt(errors.shape[1]) if errors.shape[1] > 1 else np.zeros(len(errors))
    good = excess.sum(axis=1) <= spread
    good[best] = True
    return int(np.argmax(good))


def _errors(samples: Samples, fit: Fit) -> FloatArray:
    """(n_parts,): weighted sums of squared errors at positions held out."""
    part = _parts(samples)
    found = []
    for number in range(int(part.max()) + 1):
        out = part == number
        rest = Samples(positions=samples.positions[~out], values=samples.values[~out], weights=samples.weights[~out])
        off = samples.values[out] - fit(rest).at(samples.positions[out])
        found.append(float(samples.weights[out] @ off**2))
    return np.array(found)


def _parts(samples: Samples) -> IntArray:
    _, place = np.unique(samples.positions, return_inverse=True)
    return np.asarray(place).ravel() % MOST_PARTS


def _fewest_left(samples: Samples) -> int:
    """Different positions that are left when a part is held out, at the least."""
    count = np.unique(samples.positions).size
    return count - -(-count // MOST_PARTS)


def _of_order(order: int) -> Fit:
    return lambda samples: fit_terms(samples, tuple(range(1, order + 1)))


def _optimal(samples: Samples, max_order: int, alpha: float) -> PolynomialFit:
    return fit_optimal(
        samples.positions, samples.values, weights=samples.weights, max_order=max_order, alpha=alpha
    ).after
