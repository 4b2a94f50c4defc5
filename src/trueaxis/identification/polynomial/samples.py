"""Discrete values of one error component over its axis, checked before anything is fitted to them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]


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
