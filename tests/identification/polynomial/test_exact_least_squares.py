"""Badly scaled powers cost no accuracy: against least squares in exact rational arithmetic."""

from fractions import Fraction

import numpy as np
import pytest
import statsmodels.api as sm
from numpy.typing import NDArray

from trueaxis.identification.polynomial import checked_samples, fit_terms
from trueaxis.identification.polynomial.regression import scale_exponent, to_position_powers

FloatArray = NDArray[np.float64]
ALL = tuple(range(1, 8))


def solved(matrix: list[list[Fraction]], right: list[list[Fraction]]) -> list[list[Fraction]]:
    """Solution of a regular system by elimination, exactly; `right` holds rows."""
    rows = [[*a, *b] for a, b in zip(matrix, right, strict=True)]
    size = len(rows)
    for i in range(size):
        pivot = next(j for j in range(i, size) if rows[j][i])
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for j in range(size):
            if j != i and rows[j][i]:
                factor = rows[j][i]
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i], strict=True)]
    return [row[size:] for row in rows]


def exact_fit(
    x: FloatArray, y: FloatArray, powers: tuple[int, ...]
) -> tuple[list[Fraction], list[float], list[Fraction]]:
    """Coefficients of x^k, their standard uncertainties and the fitted values, from the normal equations."""
    points, values = [Fraction(v) for v in x], [Fraction(v) for v in y]
    design = [[point**k for k in powers] for point in points]
    gram = [
        [sum((row[i] * row[j] for row in design), Fraction(0)) for j in range(len(powers))] for i in range(len(powers))
    ]
    moments = [
        sum((row[i] * v for row, v in zip(design, values, strict=True)), Fraction(0)) for i in range(len(powers))
    ]
    unit = [[Fraction(i == j) for j in range(len(powers))] for i in range(len(powers))]
    solution = solved(gram, [[m, *row] for m, row in zip(moments, unit, strict=True)])
    coefficients = [row[0] for row in solution]
    fitted = [sum((c * a for c, a in zip(coefficients, row, strict=True)), Fraction(0)) for row in design]
    rss = sum(((v - f) ** 2 for v, f in zip(values, fitted, strict=True)), Fraction(0))
    u = [float(rss / (len(points) - len(powers)) * row[i + 1]) ** 0.5 for i, row in enumerate(solution)]
    return coefficients, u, fitted


def noisy_curve(travel: float, n: int, start: float = 0.0) -> tuple[FloatArray, FloatArray]:
    x = np.linspace(start, travel, n)
    return x, 5e-6 * np.sin(x / 150.0) + np.random.default_rng(44).normal(0.0, 2.7e-7, n)


@pytest.mark.parametrize(("travel", "start"), [(700.0, 0.0), (540.0, -540.0), (0.007, 0.0), (7e5, 0.0)])
def test_order_seven_agrees_with_exact_arithmetic(travel: float, start: float) -> None:
    x, y = noisy_curve(travel, 36, start)
    fit = fit_terms(checked_samples(x, y), ALL)
    coefficients, u, fitted = exact_fit(x, y, ALL)
    assert fit.coefficients == pytest.approx([float(c) for c in coefficients], rel=1e-10, abs=0.0)
    assert fit.u == pytest.approx(u, rel=1e-10, abs=0.0)
    size = np.abs(y).max()
    assert np.abs(fit.at(x) - np.array([float(f) for f in fitted])).max() < 1e-11 * size


def test_the_inverse_of_the_normal_matrix_would_have_cost_digits_of_the_uncertainties() -> None:
    x, y = noisy_curve(700.0, 36)
    _, exact, _ = exact_fit(x, y, ALL)
    as_it_stands = sm.OLS(y, x[:, np.newaxis] ** np.array(ALL, dtype=np.float64)).fit(method="qr").bse
    ours = fit_terms(checked_samples(x, y), ALL).u
    assert np.abs(as_it_stands / exact - 1).max() > 1e3 * np.abs(ours / exact - 1).max()


def test_the_change_back_to_powers_of_the_position_is_exact() -> None:
    scaled = np.random.default_rng(1).normal(size=7)
    exponent = scale_exponent(np.array([-3.0, 700.0]))
    assert exponent == 10
    exact = [Fraction(c) / Fraction(2**exponent) ** k for c, k in zip(scaled, ALL, strict=True)]
    assert [Fraction(c) for c in to_position_powers(scaled, ALL, exponent)] == exact


@pytest.mark.parametrize(("largest", "exponent"), [(512.0, 9), (513.0, 10), (1.0, 0), (0.4, -1), (0.5, -1)])
def test_the_scale_is_the_power_of_two_next_above(largest: float, exponent: int) -> None:
    assert scale_exponent(np.array([0.0, -largest])) == exponent
