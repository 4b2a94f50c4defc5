"""Least squares of chosen powers, and what every subset of the powers leaves, from a single QR factorisation.

The regression runs (statsmodels) on the orthonormal columns of the QR factorisation of the scaled powers; the
coefficients are linear contrasts of its parameters. Fitted values, F test and R^2 are those of the powers themselves,
and the standard errors do not pass through the inverse of R'R, which would square the condition number.

With A = QR for the powers 1..order, the residual sum of squares of any subset S of the terms is that of the small
system R[:, S] b = Q'y plus the part of y that no term reaches. Stepwise regression asks for dozens of subsets; each
costs one QR of at most order x (order + 1) numbers instead of a fit to all points.

700^7 beside 700 spans 17 decades. The position is divided by the power of two next above max |x|, so that every
scaled position lies in [-1, 1]; multiplying a coefficient by a power of two is exact in binary floating point, so that
the change back to powers of mm or deg costs nothing.
"""

from dataclasses import dataclass
from math import log

import numpy as np
from scipy.linalg import solve_triangular
from statsmodels.regression.linear_model import OLS

from trueaxis.identification.polynomial.records import FloatArray, PolynomialFit, Samples

RANK_TOLERANCE = 1e-7
"""Relative size of a power's part outside the lower powers, below which it is one of them (R's lm)."""


def fit_terms(samples: Samples, powers: tuple[int, ...]) -> PolynomialFit:
    """Fit sum of a_k x^k over `powers` (Eq. 46) with its F and t tests.

    The points must outnumber the terms and tell them apart. Where the residuals are rounding alone, they are
    taken to be as large as rounding can make them, so that every statistic stays finite. Where the covariance of the
    values is known, it stands, unless residuals are larger than it says: then it grows with them (Birge ratio).
    """
    if not powers or samples.all_zero:
        return empty_fit(samples)
    design, right, exponent = weighted_system(samples, powers)
    basis, triangle = np.linalg.qr(design)
    model = OLS(right, basis, hasconst=False)
    fit = model.fit(method="qr")
    floor = _rounding_floor(right) if samples.whitening is None else max(_rounding_floor(right), float(fit.df_resid))
    if fit.ssr <= floor:
        fixed = {"scale": floor / fit.df_resid}
        fit = model.fit(method="qr", cov_type="fixed scale", cov_kwds=fixed, use_t=True)
    to_scaled = solve_triangular(triangle, np.eye(len(powers)))
    tests = fit.t_test(to_scaled)
    covariance = to_position_powers(fit.cov_params(r_matrix=to_scaled), powers, exponent)
    rss = max(float(fit.ssr), _rounding_floor(right))
    return PolynomialFit(
        powers=powers,
        coefficients=to_position_powers(np.atleast_1d(tests.effect), powers, exponent),
        u=to_position_powers(np.atleast_1d(tests.sd).ravel(), powers, exponent),
        covariance=to_position_powers(covariance.T, powers, exponent),
        t_values=np.atleast_1d(tests.tvalue).ravel(),
        p_values=np.atleast_1d(tests.pvalue).ravel(),
        n_points=right.size,
        residual_df=int(fit.df_resid),
        rss=rss,
        residual_standard_error=float(np.sqrt(rss / fit.df_resid)),
        r_squared=float(fit.rsquared),
        adjusted_r_squared=float(fit.rsquared_adj),
        aic=_aic(rss, right.size, len(powers), known=samples.whitening is not None),
        f_statistic=float(fit.fvalue),
        f_p_value=float(fit.f_pvalue),
        home=samples.home,
    )


def empty_fit(samples: Samples) -> PolynomialFit:
    """The polynomial without terms: zero everywhere, all of the values left as residuals."""
    none = np.empty(0)
    size = samples.values.size
    rss = float(np.sum(samples.weighed(samples.values) ** 2))
    return PolynomialFit(
        powers=(),
        coefficients=none,
        u=none,
        covariance=np.empty((0, 0)),
        t_values=none,
        p_values=none,
        n_points=size,
        residual_df=size,
        rss=rss,
        residual_standard_error=float(np.sqrt(rss / size)),
        r_squared=0.0,
        adjusted_r_squared=0.0,
        aic=_aic(rss, size, 0, known=samples.whitening is not None),
        f_statistic=float("nan"),
        f_p_value=float("nan"),
    )


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ReducedSystem:
    """Sums of squares of every subset of the powers 1..order.

    order: highest power the points determine; n_points; triangle: R, (order, order); projection: Q'y,
    (order,); outside: sum of squares of y outside all terms; floor: sums of squares below this are rounding; known:
    whether the covariance of the values is known, so that the squares are in units of it.
    """

    order: int
    n_points: int
    triangle: FloatArray
    projection: FloatArray
    outside: float
    floor: float
    known: bool = False

    def rss(self, powers: tuple[int, ...]) -> float:
        """(Weighted) residual sum of squares of the model with these powers, never below the rounding floor."""
        columns = self.triangle[:, [power - 1 for power in powers]]
        within = 0.0
        if len(powers) < self.order:
            triangle = _triangle(np.column_stack([columns, self.projection]))
            within = float(triangle[len(powers), -1]) ** 2
        return max(self.outside + within, self.floor)

    def mean_square(self, powers: tuple[int, ...]) -> float:
        """Residual mean square RSS / (n - terms)."""
        return self.rss(powers) / (self.n_points - len(powers))

    def aic(self, powers: tuple[int, ...]) -> float:
        """Akaike's criterion as R's extractAIC.lm gives it: n log(RSS / n) + 2 terms."""
        return _aic(self.rss(powers), self.n_points, len(powers), known=self.known)


def _aic(rss: float, n_points: int, n_terms: int, *, known: bool = False) -> float:
    """Akaike's criterion n log(RSS / n) + 2 terms; -inf for a residual of zero. With a known variance RSS + 2 terms."""
    if known:
        return rss + 2.0 * n_terms
    return n_points * log(rss / n_points) + 2.0 * n_terms if rss > 0 else -float("inf")


def _triangle(matrix: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.qr(matrix, mode="r"), dtype=np.float64)


def reduced_system(samples: Samples, max_order: int) -> ReducedSystem:
    """Reduce the samples to the powers 1..order, order <= max_order being as high as the points determine.

    At least one degree of freedom is left for the residuals, and a power that the points cannot tell from the
    lower ones (too few distinct positions, or a short stretch far from 0) ends the list.
    """
    order = min(max_order, samples.positions.size - 1)
    design, right, _ = weighted_system(samples, tuple(range(1, order + 1)))
    triangle = _triangle(design)
    told_apart = np.abs(np.diag(triangle)) > RANK_TOLERANCE * np.linalg.norm(design, axis=0)
    if samples.whitening is not None:  # it has an inverse: the points alone tell powers apart
        told_apart = np.ones(order, dtype=bool)
    order = order if told_apart.all() else int(np.argmin(told_apart))
    basis, triangle = np.linalg.qr(design[:, :order])
    projection = basis.T @ right
    rest = right - basis @ projection
    rest -= basis @ (basis.T @ rest)
    return ReducedSystem(
        order=order,
        n_points=right.size,
        triangle=triangle,
        projection=projection,
        outside=float(rest @ rest),
        floor=_rounding_floor(right),
        known=samples.whitening is not None,
    )


def scale_exponent(positions: FloatArray) -> int:
    """Smallest integer e with max |x| <= 2^e."""
    mantissa, exponent = np.frexp(np.abs(positions).max())
    return int(exponent) - int(mantissa == 0.5)


def scaled_powers(positions: FloatArray, powers: tuple[int, ...], exponent: int, home: float = 0.0) -> FloatArray:
    """Columns (x / 2^exponent)^k less their value at home, shape (n, terms)."""
    orders = np.array(powers, dtype=np.float64)
    columns = np.power(np.ldexp(positions, -exponent)[:, np.newaxis], orders)
    return columns - np.power(np.ldexp(home, -exponent), orders) if home else columns


def to_position_powers(scaled: FloatArray, powers: tuple[int, ...], exponent: int) -> FloatArray:
    """Coefficients of x^k from coefficients of (x / 2^exponent)^k along the last axis of `scaled`; exact."""
    return np.ldexp(scaled, -exponent * np.array(powers, dtype=np.int64))


def weighted_system(samples: Samples, powers: tuple[int, ...]) -> tuple[FloatArray, FloatArray, int]:
    """Design (n, terms) and right-hand side (n,), rows as they count, and the exponent of the scale."""
    exponent = scale_exponent(samples.positions)
    design = samples.weighed(scaled_powers(samples.positions, powers, exponent, samples.home))
    return design, samples.weighed(samples.values), exponent


def _rounding_floor(right_hand_side: FloatArray) -> float:
    """Residual sum of squares at and below which a fit is exact as far as double precision can tell."""
    size = right_hand_side.size
    return float(right_hand_side @ right_hand_side) * size * (8 * float(np.finfo(np.float64).eps)) ** 2
