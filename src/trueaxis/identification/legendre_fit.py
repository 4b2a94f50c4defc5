"""Curves of an estimate to optimal polynomials: generalised least squares with the posterior covariance.

Which powers a component needs is judged by the covariance that it has where all other values are as estimated: sums of
errors are often known better than each of them, and a term that such a sum needs is significant. The curve is taken at
as many positions as it has coefficients; other positions make no difference. The coefficients of all polynomials,
together with the curves that stay and the location errors, are then the least squares of the whole posterior.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import lstsq

from trueaxis.identification.polynomial import OptimalFit, Samples, fit_samples
from trueaxis.identification.polynomial.regression import empty_fit, scale_exponent, scaled_powers, to_position_powers
from trueaxis.machine.machine import Machine
from trueaxis.model.bases import LegendreBasis
from trueaxis.model.covariance import Covariance
from trueaxis.model.curves import FloatArray, LegendreCurve, PolynomialCurve
from trueaxis.model.errors import ErrorValues

# Directions of a covariance below this share of its largest are kept as if they were of that size: a levelled
# straightness has no slope, exactly. A millionth of a prior of 20 um is beyond what anything measures.
LEAST_SHARE = 1e-6
# Distance of a polynomial from the curve, root mean square over the travel, over the standard uncertainty that the
# curve has where all other values are as estimated: the expected error grows by an eighth of u at most. Measured by
# tests/identification/fit_loss.py: a third leaves twice as many curves without a polynomial and is no better at the
# tool.
NEAR = 0.5


def whitening(root: FloatArray) -> FloatArray:
    """(n, n): makes values independent, of standard deviation 1; root: (n, r), of their covariance, of like units."""
    left, singular, _ = np.linalg.svd(root, full_matrices=True)
    size = np.zeros(root.shape[0])
    size[: singular.size] = singular
    return np.asarray(left.T / np.maximum(size, LEAST_SHARE * size.max(initial=0.0))[:, np.newaxis])


def fit_legendre(
    errors: ErrorValues, covariance: Covariance, machine: Machine, *, max_order: int, alpha: float
) -> tuple[dict[str, OptimalFit], tuple[str, ...]]:
    """The optimal polynomial of every Legendre curve that the readings tell of, without terms where none is
    significant; and the names of the curves that rest on the prior.
    """
    known = covariance.root is not None and bool(_dense(covariance).any())
    white = _whitened(_dense(covariance), covariance, machine) if known else None
    silent = {name for item in errors.undetermined for name in item.parameters}
    silent |= {name for name, by in errors.determined.items() if by == "prior"}
    fits: dict[str, OptimalFit] = {}
    resting: list[str] = []
    for name, curve in errors.motion_errors.items():
        if not isinstance(curve, LegendreCurve) or not curve.coefficients:
            continue
        if name in silent:
            resting.append(name)
            continue
        own = white[:, covariance.rows_of(name)] if white is not None and name in covariance.components else None
        fits[name] = _nearest(curve, own, min(max_order, curve.basis.degree), alpha)
    return fits, tuple(resting)


def _nearest(curve: LegendreCurve, white: FloatArray | None, max_order: int, alpha: float) -> OptimalFit:
    """The optimal polynomial where it is as near to the curve as NEAR says, else that of the lowest order that is; one
    without terms where none is. white: see `legendre_samples`.

    The curve is the best estimate there is: that of least expected error. A polynomial adds the square of its distance
    from it to the mean square of the error, which is u^2.
    """
    samples = legendre_samples(curve, white, max_order)
    optimal = fit_samples(samples, max_order=max_order, alpha=alpha)
    if white is None or not optimal.after.powers:
        return optimal
    of_curve = curve.basis(samples.positions).T @ np.linalg.inv(np.linalg.qr(white, mode="r"))
    allowed = NEAR * float(np.linalg.norm(of_curve))
    higher = (
        fit_samples(samples, max_order=max_order, order=order, alpha=alpha)
        for order in range(optimal.order + 1, max_order + 1)
    )
    for fit in (optimal, *higher):
        if float(np.linalg.norm(fit.after.at(samples.positions) - samples.values)) <= allowed:
            return fit
    verdict = (
        f"no polynomial up to order {max_order} is nearer to the curve than {NEAR:.2g} times its standard uncertainty"
    )
    return replace(optimal, after=empty_fit(samples), passed=False, verdict=verdict)


def _whitened(root: FloatArray, covariance: Covariance, machine: Machine) -> FloatArray:
    """(n, n): makes all values independent; root: (n, r), of their covariance."""
    sizes = _sizes(covariance, machine)
    return whitening(root / sizes[:, np.newaxis]) / sizes


def legendre_samples(curve: LegendreCurve, white: FloatArray | None, order: int) -> Samples:
    """Values at as many positions as there are coefficients, evenly over the travel, and their whitening.

    One more where there are harmonics: evenly over whole turns, every turn would be sampled at the same angles.

    white: (n, count), columns of a whitening of all values, None where no covariance is known. What polynomials of the
    `order` cannot follow counts as an uncertainty of each value: a curve is no polynomial, and where it is hardly known
    it would otherwise take up what is left elsewhere.
    """
    basis = curve.basis
    grid = np.linspace(basis.low, basis.high, basis.count + 1 + bool(basis.harmonics))
    positions = np.delete(grid, int(np.argmin(np.abs(grid - basis.home))))
    values, whiten = curve(positions), None
    if white is not None:
        given_others = np.linalg.inv(np.linalg.qr(white, mode="r"))  # a root of the covariance, the others as they are
        rest = discrepancy(positions, values, basis.home, tuple(range(1, order + 1)))
        whiten = whitening(np.hstack([basis(positions).T @ given_others, rest * np.eye(positions.size)]))
    return Samples(
        positions=positions, values=values, weights=np.ones(positions.size), whitening=whiten, home=basis.home
    )


def discrepancy(positions: FloatArray, values: FloatArray, home: float, powers: tuple[int, ...]) -> float:
    """Residual standard deviation of values (n,) about their least-squares polynomial of these powers, zero at home."""
    design = scaled_powers(positions, powers, scale_exponent(positions), home)
    rest = values - design @ lstsq(design, values)[0]
    return float(np.sqrt(rest @ rest / max(positions.size - len(powers), 1)))


@dataclass(frozen=True, slots=True)
class _Terms:
    """A polynomial among the unknowns: their columns, and terms (s / 2^exponent)^power less those at home."""

    columns: slice
    powers: tuple[int, ...]
    exponent: int
    home: float


def with_polynomials(
    errors: ErrorValues, covariance: Covariance, machine: Machine, fits: Mapping[str, OptimalFit]
) -> tuple[ErrorValues, Covariance]:
    """Values with the significant polynomials in place of their Legendre curves, and their covariance.

    It stays that of the curves, and by how much the values change comes to it: polynomials are no better known. A curve
    without a significant polynomial stays a Legendre curve. Polynomials of curves without a covariance are taken as
    they are.
    """
    chosen = {name: fit for name, fit in fits.items() if fit.after.powers}
    curves = dict(errors.motion_errors)
    for name, fit in chosen.items():
        by_itself = _Terms(slice(0), fit.after.powers, 0, fit.after.home)
        curves[name] = _polynomial(by_itself, fit.after.coefficients, None, 0, errors.motion_errors[name].measured)
    alone = replace(errors, motion_errors=curves)
    known = {name: fit for name, fit in chosen.items() if fit.samples.whitening is not None}
    if not known:
        return alone, covariance
    design, start, terms = _design(errors, covariance, known)
    root = _dense(covariance)
    white = _whitened(np.hstack([root, _discrepancies(errors, covariance, known)]), covariance, machine)
    whole = white @ design
    units = np.linalg.norm(whole, axis=0)
    by_values = lstsq(whole / units, white)[0] / units[:, np.newaxis]
    numbers = by_values @ start
    changed = design @ numbers - start
    return (
        _changed(alone, covariance, terms, changed, numbers, by_values @ root),
        _with_change(covariance, root, changed),
    )


def _design(
    errors: ErrorValues, covariance: Covariance, fits: Mapping[str, OptimalFit]
) -> tuple[FloatArray, FloatArray, dict[str, _Terms]]:
    """New values less `start` as a linear function of numbers: coefficients of polynomials, changes of other values.

    The design (n, k), start (n,), zero but for the curves that polynomials replace, and the columns of each polynomial.
    """
    start = np.zeros(covariance.count)
    columns: list[FloatArray] = []
    found: dict[str, _Terms] = {}
    unit = np.eye(covariance.count)
    for name in covariance.components:
        rows, curve = covariance.rows_of(name), errors.motion_errors.get(name)
        if name in fits and isinstance(curve, LegendreCurve):
            samples, powers = fits[name].samples, fits[name].after.powers
            exponent, first = scale_exponent(samples.positions), len(columns)
            terms = scaled_powers(samples.positions, powers, exponent, samples.home)
            part, basis = np.zeros((covariance.count, len(powers))), curve.basis.polynomials
            part[rows][: basis.degree] = lstsq(basis(samples.positions).T, terms)[0]
            start[rows] = curve.coefficients
            columns += list(part.T)
            found[name] = _Terms(slice(first, len(columns)), powers, exponent, samples.home)
        elif isinstance(curve, LegendreCurve):
            columns += list(unit[rows])
    of_curves = sum(basis.count for basis in covariance.bases)
    columns += [unit[row] for row, name in enumerate(covariance.locations, of_curves) if name in errors.parameters]
    return np.array(columns).T, start, found


def _discrepancies(errors: ErrorValues, covariance: Covariance, fits: Mapping[str, OptimalFit]) -> FloatArray:
    """(n, m): columns of what polynomials cannot follow, in the coefficients of the curves."""
    columns = []
    for name, fit in fits.items():
        curve = errors.motion_errors[name]
        assert isinstance(curve, LegendreCurve)
        positions = fit.samples.positions
        rest = discrepancy(positions, fit.samples.values, fit.samples.home, fit.after.powers)
        part = np.zeros((covariance.count, positions.size))
        part[covariance.rows_of(name)] = rest * _by_values(curve.basis, positions)
        columns.append(part)
    return np.hstack(columns)


def _by_values(basis: LegendreBasis, positions: FloatArray) -> FloatArray:
    """(count, m): coefficients by values at positions (m,). Harmonics and polynomials are not told apart by all of a
    turn: of those that come to the same the smallest.
    """
    at = basis(positions).T
    return np.asarray(np.linalg.pinv(at, rcond=LEAST_SHARE) if basis.harmonics else np.linalg.inv(at))


def _changed(
    errors: ErrorValues,
    covariance: Covariance,
    terms: Mapping[str, _Terms],
    changed: FloatArray,
    numbers: FloatArray,
    root: FloatArray,
) -> ErrorValues:
    """Values after the joint fit; root: (k, r), of the numbers."""
    curves = dict(errors.motion_errors)
    for name in covariance.components:
        curve = curves.get(name)
        if name in terms and curve is not None:
            one = terms[name]
            curves[name] = _polynomial(
                one, numbers[one.columns], root[one.columns], covariance.of_prior, curve.measured
            )
        elif isinstance(curve, LegendreCurve):
            moved = np.array(curve.coefficients) + changed[covariance.rows_of(name)]
            curves[name] = replace(curve, coefficients=tuple(moved.tolist()))
    of_curves = sum(basis.count for basis in covariance.bases)
    parameters = dict(errors.parameters)
    for row, location in enumerate(covariance.locations, of_curves):
        if location in parameters:
            parameters[location] += float(changed[row])
    return replace(errors, parameters=parameters, motion_errors=curves)


def _polynomial(
    terms: _Terms,
    coefficients: FloatArray,
    root: FloatArray | None,
    of_prior: int | None,
    measured: tuple[float, float] | None,
) -> PolynomialCurve:
    """Of terms that are zero at home, with a constant where home is not 0; root: (k, r), of the coefficients."""
    powers = terms.powers
    both = coefficients[:, np.newaxis] if root is None else np.column_stack([coefficients, root])
    both = to_position_powers(both.T, powers, terms.exponent).T
    if terms.home:
        both = np.vstack([-(terms.home ** np.array(powers, dtype=np.float64)) @ both, both])
        powers = (0, *powers)
    found = PolynomialCurve(powers=powers, coefficients=tuple(both[:, 0].tolist()), measured=measured)
    if root is None:
        return found
    u = np.linalg.norm(both[:, 1:], axis=1)
    found = replace(found, u=tuple(u.tolist()))
    if of_prior is None:
        return found
    parts = np.split(both[:, 1:], [root.shape[1] - of_prior], axis=1)
    readings, prior = (tuple(np.linalg.norm(part, axis=1).tolist()) for part in parts)
    return replace(found, u_readings=readings, u_prior=prior)


def _with_change(covariance: Covariance, root: FloatArray, changed: FloatArray) -> Covariance:
    """With the change of the values as one further column, before those of the prior."""
    at = root.shape[1] - (covariance.of_prior or 0)
    usual = covariance.usual and _with_change(covariance.usual, _dense(covariance.usual), changed)
    return replace(covariance, root=np.insert(root, at, changed, axis=1), usual=usual)


def _dense(covariance: Covariance) -> FloatArray:
    assert covariance.root is not None
    return covariance.root if isinstance(covariance.root, np.ndarray) else np.asarray(covariance.root.toarray())


def _sizes(covariance: Covariance, machine: Machine) -> FloatArray:
    """(n,): of the prior, mm or rad, so that values of all units are alike."""
    prior = machine.prior
    sizes = [prior.of_component(name) for name in covariance.components]
    each = np.repeat(sizes, [basis.count for basis in covariance.bases])
    located = [prior.of_location(name, machine.parameter_unit(name)) for name in covariance.locations]
    others = covariance.count - each.size - len(located)
    return np.concatenate([each, located, np.ones(others)])
