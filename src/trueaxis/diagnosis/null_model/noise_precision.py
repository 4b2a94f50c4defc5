"""The precision of the readings of a part: the inverse of their covariance, less what is free.

The covariance is that of the noise, run by run, and a misfit that readings of a target share. Its inverse is that of
the noise less the square of a few rows (Woodbury); so is what is left when columns are free. Matrices of all readings
times all are never made.
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.linalg import LinAlgError, block_diag
from scipy.linalg.lapack import dpotrf, dpotri, dtrtrs

from trueaxis.diagnosis.result import FloatArray, IntArray

# of the squares of free columns: where repeats tell nothing of them, a misfit that is huge leaves rounding; the next
# where one does not do. Of 216 data sets one asked for the second
ROUNDINGS = (1e-13, 1e-12, 1e-11)


@dataclass(frozen=True, slots=True, eq=False)
class Precision:
    """starts: (runs + 1,), first reading of each run; inverse: of the noise of each run; taken: (j, n), rows whose
    products are taken away from it.
    """

    starts: IntArray
    inverse: tuple[FloatArray, ...]
    taken: FloatArray

    def __matmul__(self, columns: FloatArray) -> FloatArray:
        """(n, k): times columns (n, k)."""
        each = zip(self.inverse, pairwise(self.starts.tolist()), strict=True)
        of_noise = np.concatenate([one @ columns[first:last] for one, (first, last) in each])
        return np.asarray(of_noise - self.taken.T @ (self.taken @ columns))

    def less(self, rows: FloatArray) -> "Precision":
        """With further rows (j, n) taken away."""
        return replace(self, taken=np.vstack([self.taken, rows]))

    def blocks(self) -> list[FloatArray]:
        """Of the readings of each run."""
        each = zip(self.inverse, pairwise(self.starts.tolist()), strict=True)
        return [one - self.taken[:, first:last].T @ self.taken[:, first:last] for one, (first, last) in each]

    def diagonal(self) -> FloatArray:
        """(n,)."""
        of_noise = np.concatenate([one.ravel()[:: len(one) + 1] for one in self.inverse])
        return np.asarray(of_noise - np.einsum("ij,ij->j", self.taken, self.taken))

    def within(self, columns: FloatArray) -> float:
        """Trace of columns' P columns, of columns (n, k)."""
        each = zip(self.inverse, pairwise(self.starts.tolist()), strict=True)
        of_noise = sum(float(np.vdot(columns[first:last], one @ columns[first:last])) for one, (first, last) in each)
        return of_noise - float(np.sum((self.taken @ columns) ** 2))

    def dense(self) -> FloatArray:
        """(n, n)."""
        return np.asarray(block_diag(*self.inverse) - self.taken.T @ self.taken)


def precision_of(
    noise: Sequence[FloatArray], repeated: FloatArray, misfit: float, own: FloatArray
) -> tuple[Precision, float]:
    """Of the covariance less what own columns (n, k) take, and half the logarithms of the determinants.

    noise: of the readings of each run, mm^2; repeated: (n, targets), 1 where a reading is of a target; misfit: mm.
    """
    starts = np.cumsum([0, *(len(one) for one in noise)])
    inverse, root = [], 0.0
    for one in noise:
        half = factor_of(one)
        root += float(np.log(np.diag(half)).sum())
        found, _ = dpotri(half, lower=1, overwrite_c=1)  # its lower triangle: zeros are above that of the factor
        found += found.T
        found.ravel("K")[:: len(found) + 1] *= 0.5
        inverse.append(found.T)  # row by row in memory, as all else is
    of_noise = Precision(starts, tuple(inverse), np.zeros((0, int(starts[-1]))))
    precision = of_noise
    if misfit > 0.0 and repeated.shape[1]:
        shared = of_noise @ repeated
        factor = factor_of(np.eye(repeated.shape[1]) + misfit**2 * (repeated.T @ shared))
        root += float(np.log(np.diag(factor)).sum())
        precision = precision.less(misfit * solved(factor, shared.T))
    if own.shape[1]:
        held = precision @ own
        factor = factor_less_misfit(own.T @ held, np.einsum("ij,ij->j", own, of_noise @ own))
        root += float(np.log(np.diag(factor)).sum())
        precision = precision.less(solved(factor, held.T))
    return precision, root


def factor_less_misfit(squares: FloatArray, whole: FloatArray) -> FloatArray:
    """Cholesky factor of squares (k, k). whole: (k,), no less than their diagonal before the misfit was taken away."""
    for times in (0.0, *ROUNDINGS):
        with suppress(LinAlgError):
            return factor_of(squares + np.diag(times * whole))
    raise LinAlgError("not positive definite")


def factor_of(matrix: FloatArray) -> FloatArray:
    """Lower Cholesky factor, by LAPACK itself: of matrices this small the checks of SciPy take longer than the work."""
    found, failed = dpotrf(matrix, lower=1, clean=1)
    if failed:
        raise LinAlgError("not positive definite")
    return np.asarray(found)


def solved(factor: FloatArray, columns: FloatArray) -> FloatArray:
    """Columns (n, k) divided by a lower factor (n, n)."""
    return np.asarray(dtrtrs(factor, columns, lower=1)[0]) if factor.size else columns  # LAPACK complains of empty ones
