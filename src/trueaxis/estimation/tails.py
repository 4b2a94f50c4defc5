"""Tails of distributions as far out as evidence reaches."""

import numpy as np
from scipy.special import betaln, chdtrc, fdtrc, gammaln

SMALLEST = 1e-290  # of a probability that is told to all its digits
LN10 = float(np.log(10.0))
LEAST_P = 1e-12  # smaller probabilities are no figures for a reader: the tails of noise are not known so far out


def log_f_tail(value: float, k: float, freedom: float) -> float:
    """Natural logarithm of the probability that F with (k, freedom) degrees of freedom exceeds a value.

    SciPy gives up where the probability itself underflows; there the leading term of the incomplete beta function is
    exact to 1e-6 of the logarithm (NIST DLMF 8.17.7).
    """
    found = float(fdtrc(k, freedom, max(value, 0.0)))
    if found > SMALLEST:
        return float(np.log(found))
    a, b = 0.5 * freedom, 0.5 * k
    z = freedom / (freedom + k * value)
    return float(a * np.log(z) + (b - 1.0) * np.log1p(-z) - np.log(a) - betaln(a, b))


def log_chi2_tail(value: float, k: int) -> float:
    """Natural logarithm of the probability that chi^2 with k degrees of freedom exceeds a value.

    Where it underflows, the leading terms of the incomplete gamma function (NIST DLMF 8.11.2), to 1e-5.
    """
    found = float(chdtrc(k, max(value, 0.0)))
    if found > SMALLEST:
        return float(np.log(found))
    half, a = 0.5 * value, 0.5 * k
    return float(-half + (a - 1.0) * np.log(half) - gammaln(a) + np.log1p((a - 1.0) / half))
