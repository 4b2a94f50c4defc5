"""Degrees of freedom of the noise that a test stands on: of each instrument its own, few where little is repeated."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trueaxis.diagnosis.result import FloatArray, IntArray, NoiseOf
from trueaxis.diagnosis.rows import Rows, as_slice
from trueaxis.estimation.runs import noise_groups


@dataclass(frozen=True, eq=False)
class Freedom:
    """of_rows: (n,), degrees of freedom of the noise of each reading's instrument; sigma: (n,), mm."""

    of_rows: FloatArray
    sigma: FloatArray

    @cached_property
    def _each(self) -> FloatArray:
        return np.unique(self.of_rows)

    def of(self, rows: IntArray, columns: FloatArray) -> float:
        """For a test of columns (n_rows, k), mm, zero but in those rows: by Satterthwaite's approximation."""
        here = as_slice(rows)
        of_rows = self.of_rows[here]
        weight = np.einsum("ij,ij->i", columns, columns) / self.sigma[here] ** 2
        whole, inverse = max(float(weight.sum()), 1e-300), 0.0
        for own in self._each:
            inverse += (float(weight[of_rows == own].sum()) / whole) ** 2 / own
        return float(1.0 / max(inverse, 1e-300))


def freedom_of(rows: Rows, sigma: FloatArray, noise: Sequence[NoiseOf]) -> Freedom:
    """From the noise of the instruments; sigma: (n,), mm."""
    of = {one.group: one.freedom for one in noise}
    per_run = np.array([of.get(group, 1.0) for group in noise_groups(rows.runs)])
    return Freedom(per_run[rows.run], sigma)
