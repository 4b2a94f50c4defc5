"""Degrees of freedom of the noise that a test stands on: few, where it stands on slopes that few runs tell."""

from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.result import FloatArray, IntArray
from trueaxis.diagnose.whiten import Whitening


@dataclass(frozen=True, slots=True, eq=False)
class Freedom:
    """Satterthwaite's approximation over the components of the noise.

    of_readings: degrees of freedom of white and autocorrelated noise; of_slopes: (n_runs,), those of the slope of each
    run, of which runs of one instrument share one estimate; ramps: (n,), whitened slopes; starts: (n_runs,), first row.
    """

    of_readings: float
    of_slopes: FloatArray
    ramps: FloatArray
    starts: IntArray

    def of(self, columns: FloatArray) -> float:
        """For a test of what is spanned by orthonormal columns (n, k), whitened, base projected out."""
        if columns.shape[1] == 0 or not self.ramps.any():
            return self.of_readings
        through = np.add.reduceat(self.ramps[:, np.newaxis] * columns, self.starts, axis=0)
        share = np.sum(through**2, axis=1) / columns.shape[1]
        total = min(float(share.sum()), 1.0)
        inverse = (1.0 - total) ** 2 / self.of_readings
        for freedom in np.unique(self.of_slopes[self.of_slopes > 0.0]):
            inverse += float(share[self.of_slopes == freedom].sum()) ** 2 / float(freedom)
        return float(1.0 / inverse)


def freedom_of(whitening: Whitening) -> Freedom:
    """From the noise of the runs."""
    return Freedom(
        min(one.freedom for one in whitening.noise),
        np.array([one.slope_freedom for one in whitening.noise]),
        whitening.ramps(),
        whitening.starts[:-1],
    )
