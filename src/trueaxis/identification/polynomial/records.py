"""What a polynomial fit says: coefficients, uncertainty and statistics, before and after optimisation."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from trueaxis.identification.polynomial.samples import FloatArray, Samples

StepReason = Literal["start", "AIC", "t test", "F test"]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PolynomialFit:
    """Least-squares polynomial without constant term; statistics as R's summary.lm gives them.

    powers: k of the terms x^k; coefficients, u (standard uncertainties), t_values, p_values: (terms,);
    covariance: (terms, terms); coefficients in mm/mm^k, mm/deg^k, rad/mm^k or rad/deg^k. r_squared and
    adjusted_r_squared are uncentred, there being no constant term. aic is n log(RSS/n) + 2 terms, or RSS + 2 terms
    where the covariance of the values is known; RSS is then in units of it. The F test (f_statistic, f_p_value) is that
    of the whole equation. An empty polynomial has no terms, R^2 of 0 and NaN in the F test. home: the position at which
    every term is zero.
    """

    powers: tuple[int, ...]
    coefficients: FloatArray
    u: FloatArray
    covariance: FloatArray
    t_values: FloatArray
    p_values: FloatArray
    n_points: int
    residual_df: int
    rss: float
    residual_standard_error: float
    r_squared: float
    adjusted_r_squared: float
    aic: float
    f_statistic: float
    f_p_value: float
    home: float = 0.0

    def at(self, positions: FloatArray) -> FloatArray:
        """Values (mm or rad) at positions (mm or deg), same shape."""
        return np.asarray(self._terms(positions) @ self.coefficients, dtype=np.float64)

    def u_at(self, positions: FloatArray) -> FloatArray:
        """Standard uncertainty of `at` from the covariance of the coefficients."""
        rows = self._terms(positions)
        variance = np.einsum("...i,ij,...j->...", rows, self.covariance, rows)
        return np.asarray(np.sqrt(np.maximum(variance, 0.0)), dtype=np.float64)

    def _terms(self, positions: FloatArray) -> FloatArray:
        terms = _powers(positions, self.powers)
        return terms - _powers(np.array(self.home), self.powers) if self.home else terms

    def significant(self, alpha: float) -> bool:
        """Whether the F test of the equation and the t test of every term are passed."""
        return bool(self.powers) and self.f_p_value < alpha and bool((self.p_values < alpha).all())


@dataclass(frozen=True, slots=True)
class Step:
    """One step of the optimisation: which power went out (-k) or came in (+k), why, and the AIC then."""

    reason: StepReason
    change: str
    powers: tuple[int, ...]
    aic: float


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class OptimalFit:
    """Outcome of the optimisation of Sect. 4.3.

    mean_squares: residual mean square of the orders 1, 2, ... that were tried; order: the one chosen; before:
    all powers up to it; after: the optimal polynomial, empty where no term describes the values; passed:
    whether `after` passes F and t tests.
    """

    samples: Samples
    alpha: float
    mean_squares: tuple[float, ...]
    order: int
    before: PolynomialFit
    after: PolynomialFit
    steps: tuple[Step, ...]
    passed: bool
    verdict: str


def _powers(positions: FloatArray, powers: tuple[int, ...]) -> FloatArray:
    exponents = np.array(powers, dtype=np.float64)
    return np.asarray(np.asarray(positions, dtype=np.float64)[..., np.newaxis] ** exponents, dtype=np.float64)
