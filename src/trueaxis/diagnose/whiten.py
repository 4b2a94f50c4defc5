"""Readings made independent: multiplied by the inverse root of the covariance of their noise, run by run.

Within a run the noise is white (variance w), autocorrelated (stationary AR(1), variance a, coefficient f from one
reading to the next) and has a random slope. With D the matrix that takes f times the reading before away, D V D' is
tridiagonal and its Cholesky factor bidiagonal: the cost grows with the number of readings alone.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.linalg import cholesky_banded
from scipy.linalg.lapack import dtbtrs

from trueaxis.diagnose.result import FloatArray, IntArray, NoiseOf

SHORT = 400  # readings of a run, up to which a matrix is quicker than the recursion


@dataclass(frozen=True, slots=True, eq=False)
class Whitening:
    """Inverse root of the covariance, one block per run. starts: (n_runs + 1,), first row of each run; noise: of each
    run, in their order.
    """

    starts: IntArray
    noise: tuple[NoiseOf, ...]

    def __call__(self, columns: FloatArray) -> FloatArray:
        """(n, k) whitened; columns: (n, k) or (n,)."""
        return self.part(np.arange(int(self.starts[-1])), columns)

    def part(self, rows: IntArray, columns: FloatArray) -> FloatArray:
        """Columns (n_rows, k) or (n_rows,) of some rows whitened; rows: ascending, those of whole runs, or none.

        Runs of one length and noise are done at once, short ones by one matrix: a factorisation each would cost more
        than the work.
        """
        flat = columns if columns.ndim == 2 else columns[:, np.newaxis]
        found = np.empty_like(flat, dtype=np.float64)
        for noise, at in self._alike(rows):
            count, size = at.shape
            if size <= SHORT and at[-1, -1] - at[0, 0] + 1 == at.size:  # one after another: no copies
                here = slice(at[0, 0], at[-1, -1] + 1)
                np.matmul(
                    _operator(noise, size),
                    flat[here].reshape(count, size, -1),
                    out=found[here].reshape(count, size, -1),
                )
            elif size <= SHORT:
                found[at] = np.matmul(_operator(noise, size), flat[at])
            else:
                every = flat[at.T].reshape(at.shape[1], -1)
                found[at.T] = whitened(noise, every).reshape(*at.T.shape, -1)
        return found.reshape(columns.shape)

    def back(self, columns: FloatArray) -> FloatArray:
        """(n, k) times the transpose: b such that b'a is the product of columns and a whitened, for any a."""
        found = np.empty_like(columns, dtype=np.float64)
        for noise, at in self._alike(np.arange(int(self.starts[-1]))):
            if at.shape[1] <= SHORT:
                found[at] = np.matmul(_operator(noise, at.shape[1]).T, columns[at])
            else:
                every = columns[at.T].reshape(at.shape[1], -1)
                found[at.T] = _back(noise, every).reshape(*at.T.shape, -1)
        return found

    def _alike(self, rows: IntArray) -> list[tuple[NoiseOf, IntArray]]:
        """Runs of one noise and length among the rows: their places in them, (n_runs, size)."""
        begins = np.searchsorted(rows, self.starts[:-1])
        there = np.isin(self.starts[:-1], rows)
        alike: dict[tuple[int, NoiseOf], list[int]] = {}
        for index in np.flatnonzero(there):
            size = int(self.starts[index + 1] - self.starts[index])
            alike.setdefault((size, self.noise[index]), []).append(int(begins[index]))
        return [(noise, np.array(at)[:, np.newaxis] + np.arange(size)) for (size, noise), at in alike.items()]

    def ramps(self) -> FloatArray:
        """(n,): the whitened slope of each run, in its own standard deviation: its share of the noise."""
        found = np.zeros(int(self.starts[-1]))
        for index, noise in enumerate(self.noise):
            first, last = int(self.starts[index]), int(self.starts[index + 1])
            if noise.slope > 0.0:
                found[first:last] = whitened(noise, noise.slope * ramp(last - first))
        return found


@lru_cache(maxsize=256)
def _operator(noise: NoiseOf, size: int) -> FloatArray:
    """(size, size): the matrix that whitens a run."""
    return whitened(noise, np.eye(size))


def whitening(run: IntArray, of_run: Sequence[NoiseOf]) -> Whitening:
    """For rows sorted by run, (n,); of_run: noise of the runs present, in order."""
    starts = np.append(np.flatnonzero(np.diff(run, prepend=-1)), run.size)
    return Whitening(starts.astype(np.int64), tuple(of_run))


def whitened(noise: NoiseOf, columns: FloatArray) -> FloatArray:
    """One run's columns, (n,) or (n, k), whitened."""
    flat = columns.reshape(columns.shape[0], -1)
    found = _stationary(noise, flat)
    if noise.slope > 0.0 and flat.shape[0] > 1:
        direction, shrink = _sloped(noise, flat.shape[0])
        found = found - np.outer(shrink, direction @ found)
    return found.reshape(columns.shape)


def ramp(size: int) -> FloatArray:
    """(size,), from -1/2 to 1/2: a slope over the whole run has height 1."""
    return np.linspace(-0.5, 0.5, size)


def tridiagonal(noise: NoiseOf, size: int) -> FloatArray:
    """Lower banded Cholesky factor (2, size) of D V D' of white and AR(1) noise."""
    f, white = noise.correlation, noise.white**2
    band = np.zeros((2, size))
    band[0] = white * (1.0 + f * f) + noise.correlated**2 * (1.0 - f * f)
    band[0, 0] = white + noise.correlated**2
    band[1, :-1] = -white * f
    return np.asarray(cholesky_banded(band, lower=True, check_finite=False))


def differenced(noise: NoiseOf, columns: FloatArray) -> FloatArray:
    """D times columns (n, k)."""
    found = columns.copy()
    found[1:] -= noise.correlation * columns[:-1]
    return found


def solved(factor: FloatArray, columns: FloatArray, *, transposed: bool = False) -> FloatArray:
    """The inverse of a lower banded factor (2, size), or of its transpose, times columns (size, k).

    Straight from LAPACK: SciPy's `solve_banded` factors the factor once more.
    """
    if columns.size == 0:  # written beyond by the wrapper of LAPACK's routine
        return columns.copy()
    found, _ = dtbtrs(factor, columns, uplo="L", trans="T" if transposed else "N")
    return np.asarray(found)


def _back(noise: NoiseOf, columns: FloatArray) -> FloatArray:
    """One run's columns (n, k) times the transpose of what whitens it."""
    if noise.slope > 0.0 and columns.shape[0] > 1:
        direction, shrink = _sloped(noise, columns.shape[0])
        columns = columns - np.outer(direction, shrink @ columns)
    if noise.correlated == 0.0 or noise.correlation == 0.0:
        return columns / noise.sigma
    found = solved(tridiagonal(noise, columns.shape[0]), columns, transposed=True)
    found[:-1] -= noise.correlation * found[1:]
    return found


def _sloped(noise: NoiseOf, size: int) -> tuple[FloatArray, FloatArray]:
    """(size,) the whitened slope d, and s, (size,): 1 - s d' is the inverse root of 1 + d d'."""
    direction = _stationary(noise, noise.slope * ramp(size)[:, np.newaxis])[:, 0]
    root = np.sqrt(1.0 + float(direction @ direction))
    return direction, direction / (root * (root + 1.0))


def _stationary(noise: NoiseOf, columns: FloatArray) -> FloatArray:
    if noise.correlated == 0.0 or noise.correlation == 0.0:
        return columns / noise.sigma
    return solved(tridiagonal(noise, columns.shape[0]), differenced(noise, columns))
