"""What a polynomial is fitted to, and what a fit says: coefficients, uncertainty and statistics, before and after."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
StepReason = Literal["start", "AIC", "t test", "F test"]


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Samples:
    """Values of one error component at axis positions, ready to be fitted.

    positions: (n,) mm or deg; values: (n,) mm or rad; weights: (n,) proportional to 1/u^2, ones where not
    given; whitening: (n, n), makes the values independent with a standard deviation of 1 each, where their covariance
    is known: generalised least squares, without `weights`; home: the position, mm or deg, at which every term is zero.
    """

    positions: FloatArray
    values: FloatArray
    weights: FloatArray
    whitening: FloatArray | None = None
    home: float = 0.0

    @property
    def all_zero(self) -> bool:
        """Whether there is nothing to describe: every value is exactly zero."""
        return not self.values.any()

    def weighed(self, rows: FloatArray) -> FloatArray:
        """Rows (n,) or (n, m) as each counts: times the root of its weight, or whitened."""
        if self.whitening is not None:
            return np.asarray(self.whitening @ rows)
        root = np.sqrt(self.weights)
        return root * rows if rows.ndim == 1 else root[:, np.newaxis] * rows


def checked_samples(positions: ArrayLike, values: ArrayLike, weights: ArrayLike | None = None) -> Samples:
    """Samples from anything array-like; ValueError says everything that is wrong with them.

    At least two points, at least one of them away from position 0 (where every polynomial without a constant
    term is zero), are required; all numbers must be finite and weights positive. Positions may repeat.
    """
    x = np.array(positions, dtype=np.float64)
    y = np.array(values, dtype=np.float64)
    w = np.ones_like(y) if weights is None else np.array(weights, dtype=np.float64)
    faults: list[str] = []
    for name, array in (("positions", x), ("values", y), ("weights", w)):
        if array.ndim != 1:
            faults.append(f"{name} must be one-dimensional, not of shape {array.shape}")
        elif not np.isfinite(array).all():
            faults.append(f"{name} must be finite; see points {_places(~np.isfinite(array))}")
    if len({array.shape for array in (x, y, w)}) > 1:
        shapes = f"{x.shape}, {y.shape} and {w.shape}"
        faults.append(f"positions, values and weights must be of one length, not {shapes}")
    if not faults:
        if x.size < 2:
            faults.append(f"at least 2 points are needed to fit a term and judge it, not {x.size}")
        if not x.any():
            faults.append("no point lies away from position 0, where every term is zero")
        if (w <= 0).any():
            faults.append(f"weights must be positive; see points {_places(w <= 0)}")
    if faults:
        raise ValueError("; ".join(faults))
    for array in (x, y, w):
        array.setflags(write=False)
    return Samples(positions=x, values=y, weights=w)


def _places(wrong: NDArray[np.bool_]) -> str:
    found = np.flatnonzero(wrong)
    return ", ".join(map(str, found[:5])) + (" ..." if found.size > 5 else "")


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
