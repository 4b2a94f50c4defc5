"""Degrees of freedom of the noise that a test stands on: few, where it stands on slopes that few runs tell."""

from dataclasses import dataclass
from itertools import pairwise

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

    @property
    def slopes(self) -> FloatArray:
        """(n, n_runs): the whitened slope of each run, zero elsewhere."""
        found = np.zeros((self.ramps.size, self.starts.size))
        for place, (first, last) in enumerate(pairwise([*self.starts, self.ramps.size])):
            found[first:last, place] = self.ramps[first:last]
        return found

    def of(self, through: FloatArray, inverse: FloatArray) -> float:
        """For a test of what is spanned by columns (n, k), whitened, base projected out.

        through: (n_runs, k), products of `slopes` with these; inverse: (k, k), that of their products with one another.
        """
        share = np.einsum("ri,ij,rj->r", through, inverse, through) / inverse.shape[0]
        total = min(float(share.sum()), 1.0)
        per_freedom = (1.0 - total) ** 2 / self.of_readings
        for freedom in np.unique(self.of_slopes[self.of_slopes > 0.0]):
            per_freedom += float(share[self.of_slopes == freedom].sum()) ** 2 / float(freedom)
        return float(1.0 / per_freedom)


def freedom_of(whitening: Whitening) -> Freedom:
    """From the noise of the runs."""
    return Freedom(
        min(one.freedom for one in whitening.noise),
        np.array([one.slope_freedom for one in whitening.noise]),
        whitening.ramps(),
        whitening.starts[:-1],
    )
