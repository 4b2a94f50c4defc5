"""The noise of an instrument: white noise and a slow part that follows an Ornstein-Uhlenbeck process in time.

With D the matrix that takes away what is left of the slow part of the reading before, D V D' of the covariance V of a
run is tridiagonal, its Cholesky factor bidiagonal: time and memory grow with the number of readings alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cholesky_banded
from scipy.linalg.lapack import dtbtrs

from trueaxis.measurement.machine import FloatArray

BLOCK = 32  # rows of the factor that are divided by at once, as a dense matrix


@dataclass(frozen=True, slots=True)
class Noise:
    """white, slow: standard deviations, mm; lasts: time constant of the slow part, in typical steps of its runs."""

    white: float
    slow: float = 0.0
    lasts: float = 1.0

    @property
    def sigma(self) -> float:
        """Standard deviation of a reading."""
        return float(np.hypot(self.white, self.slow))

    def sized(self, factor: float) -> "Noise":
        """So many times as large."""
        return Noise(factor * self.white, factor * self.slow, self.lasts)

    def independent(self, steps: FloatArray) -> float:
        """As many independent readings as have a mean square that scatters as that of these, (n,) as in `Whitening`."""
        alike = beside = 0.0  # squares of correlations with earlier readings, their sum over all
        for kept in np.exp(-2.0 * np.maximum(steps[1:], 0.0) / self.lasts).tolist():
            alike = (alike + 1.0) * kept
            beside += alike
        share = (self.slow / self.sigma) ** 2 if self.sigma > 0.0 else 0.0
        return steps.size**2 / (steps.size + 2.0 * share**2 * beside)


class Whitening:
    """The inverse root of the covariance of one run's noise, applied to its rows piece by piece, in their order.

    steps: (n,), time since the reading before in typical steps, the first one is not used; scale: by what the noise of
    this run is larger than that of its instrument.
    """

    def __init__(self, noise: Noise, steps: FloatArray, scale: float = 1.0) -> None:
        kept = np.exp(-np.maximum(steps, 0.0) / noise.lasts) if noise.slow > 0.0 else np.zeros(steps.size)
        kept[:1] = 0.0
        white, slow = (scale * noise.white) ** 2, (scale * noise.slow) ** 2
        band = np.zeros((2, steps.size))
        band[0] = white * (1.0 + kept**2) + slow * (1.0 - kept**2)
        band[1, :-1] = -white * kept[1:]
        self._kept = kept
        self._factor = np.asarray(cholesky_banded(band, lower=True, check_finite=False))
        self._blocks: FloatArray | None = None
        self._at = 0
        self._before: FloatArray | None = None
        self._solved: FloatArray | None = None

    @classmethod
    def joined(cls, runs: "Sequence[Whitening]") -> "Whitening":
        """Of several runs, one after the other: they know nothing of each other."""
        found = cls.__new__(cls)
        found._kept = np.concatenate([one._kept for one in runs])
        found._factor = np.concatenate([one._factor for one in runs], axis=1)
        found._factor[1, np.cumsum([one._kept.size for one in runs]) - 1] = 0.0
        found._blocks, found._at, found._before, found._solved = None, 0, None, None
        return found

    @property
    def log_root(self) -> float:
        """Half the logarithm of the determinant of the covariance."""
        return float(np.log(self._factor[0]).sum())

    def __call__(self, columns: FloatArray) -> FloatArray:
        """The next rows (m, k), whitened."""
        rows = slice(self._at, self._at + columns.shape[0])
        self._at = rows.stop
        if columns.size == 0 or not self._kept.any():  # LAPACK's wrapper writes beyond arrays without columns
            return columns / self._factor[0, rows, np.newaxis]
        found = np.array(columns, order="F")
        found[1:] -= self._kept[rows][1:, np.newaxis] * columns[:-1]
        if self._before is not None and self._solved is not None:
            found[0] -= self._kept[rows.start] * self._before
            found[0] -= self._factor[1, rows.start - 1] * self._solved
        self._before = columns[-1].copy()
        solved = np.asarray(dtbtrs(self._factor[:, rows], found, uplo="L", trans="N", overwrite_b=1)[0])
        self._solved = solved[-1].copy()
        return solved

    def every(self, columns: FloatArray) -> FloatArray:
        """All rows (n, k), whitened, column by column in memory; may be asked again."""
        if columns.size == 0 or not self._kept.any():
            return np.asarray(columns / self._factor[0, :, np.newaxis], order="F")
        found = np.array(columns, order="F")
        found[1:] -= self._kept[1:, np.newaxis] * columns[:-1]
        return np.asarray(dtbtrs(self._factor, found, uplo="L", trans="N", overwrite_b=1)[0])

    def by_rows(self, columns: FloatArray) -> FloatArray:
        """All rows (n, k), whitened, row by row in memory as they come; they are overwritten. For many columns."""
        if not self._kept.any():
            columns /= self._factor[0, :, np.newaxis]
            return columns
        found, kept, before = np.empty_like(columns), self._kept[:, np.newaxis], columns[:1]
        for start, inverse in zip(range(0, columns.shape[0], BLOCK), self._by_blocks(), strict=True):
            part = columns[start : start + BLOCK]
            rows, last = part.shape[0], part[-1].copy()
            part[1:] -= kept[start + 1 : start + rows] * part[:-1]
            if start:
                part[0] -= kept[start] * before + self._factor[1, start - 1] * found[start - 1]
            before = last
            np.matmul(inverse[:rows, :rows], part, out=found[start : start + BLOCK])
        return found

    def _by_blocks(self) -> FloatArray:
        """(blocks, BLOCK, BLOCK): inverses of the blocks on the diagonal of the factor."""
        if self._blocks is None:
            count = -(-self._kept.size // BLOCK)
            padded = np.ones((2, count * BLOCK))
            padded[:, : self._kept.size] = self._factor
            root, below = padded.reshape(2, count, BLOCK, 1)
            found = np.zeros((count, BLOCK, BLOCK))
            for k in range(BLOCK):
                found[:, k, k] = 1.0
                found[:, k, :k] -= below[:, k - 1] * found[:, k - 1, :k]
                found[:, k] /= root[:, k]
            self._blocks = found
        return self._blocks

    def weighed(self, column: FloatArray) -> FloatArray:
        """(n,): the inverse of the covariance times a column of all rows."""
        return self.transposed(self(column[:, np.newaxis]))[:, 0]

    def transposed(self, columns: FloatArray) -> FloatArray:
        """The transpose of the inverse root times columns (n, k) of all rows."""
        if columns.size == 0:
            return columns.copy()
        solved, _ = dtbtrs(self._factor, columns, uplo="L", trans="T")
        found = np.asarray(solved)
        found[:-1] -= self._kept[1:, np.newaxis] * found[1:]
        return found

    def weights(self) -> FloatArray:
        """(n,): diagonal of the inverse of the covariance: one over the variance of a reading given the others."""
        root, below = self._factor
        ratio = below / root
        # diagonal of (L L')^-1, d_k = root_k^-2 + ratio_k^2 d_k+1: a triangle with one band, solved as such
        band = np.vstack([np.append(0.0, -(ratio[:-1] ** 2)), np.ones(root.size)])
        inverse = np.asarray(dtbtrs(band, (root**-2.0)[:, np.newaxis], uplo="U")[0], dtype=np.float64)[:, 0]
        beside = -ratio[:-1] * inverse[1:]  # its first subdiagonal
        found = inverse.copy()
        found[:-1] += self._kept[1:] ** 2 * inverse[1:] - 2.0 * self._kept[1:] * beside
        return found
