"""Least squares of chosen powers with statsmodels, and the statistics of R's summary.lm.

The regression runs on the orthonormal columns of the QR factorisation of the scaled powers; the coefficients
are linear contrasts of its parameters. Fitted values, F test and R^2 are those of the powers themselves, and
the standard errors do not pass through the inverse of R'R, which would square the condition number.
"""

import numpy as np
from scipy.linalg import solve_triangular
from statsmodels.regression.linear_model import OLS

from trueaxis.identification.polynomial.powers import rounding_floor, to_position_powers, weighted_system
from trueaxis.identification.polynomial.records import PolynomialFit
from trueaxis.identification.polynomial.reduced import aic
from trueaxis.identification.polynomial.samples import Samples


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
    floor = rounding_floor(right) if samples.whitening is None else max(rounding_floor(right), float(fit.df_resid))
    if fit.ssr <= floor:
        fixed = {"scale": floor / fit.df_resid}
        fit = model.fit(method="qr", cov_type="fixed scale", cov_kwds=fixed, use_t=True)
    to_scaled = solve_triangular(triangle, np.eye(len(powers)))
    tests = fit.t_test(to_scaled)
    covariance = to_position_powers(fit.cov_params(r_matrix=to_scaled), powers, exponent)
    rss = max(float(fit.ssr), rounding_floor(right))
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
        aic=aic(rss, right.size, len(powers), known=samples.whitening is not None),
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
        aic=aic(rss, size, 0, known=samples.whitening is not None),
        f_statistic=float("nan"),
        f_p_value=float("nan"),
    )
