"""Degrees of freedom of the noise that a test stands on: few where an instrument repeats little, and fewer yet for what
acts on a single run, whose readings alone tell by how much it is noisier than others.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from trueaxis.diagnosis.null_model.noise_fit import UNEVEN
from trueaxis.diagnosis.null_model.rows import Rows, as_slice
from trueaxis.diagnosis.null_model.whiten import Whitening
from trueaxis.diagnosis.result import FloatArray, IntArray, NoiseOf
from trueaxis.estimation.runs import noise_groups

MOST_UNEVEN = 3.0 * UNEVEN  # by which the noise of runs differs; beforehand UNEVEN is usual
PLACES = 200  # of it, over which is averaged


@dataclass(frozen=True, eq=False)
class Freedom:
    """of_rows: (n,), degrees of freedom of the noise of each reading's instrument; sigma: (n,), mm; run: (n,), of its
    run, by number; of_runs: (n_runs,), degrees of freedom of the noise of a run among that of its instrument.
    """

    of_rows: FloatArray
    sigma: FloatArray
    run: IntArray
    of_runs: FloatArray

    @cached_property
    def _each(self) -> FloatArray:
        return np.unique(self.of_rows)

    def of(self, rows: IntArray, columns: FloatArray) -> float:
        """For a test of columns (n_rows, k), mm, zero but in those rows: by Satterthwaite's approximation."""
        return float(1.0 / max(self._of_instruments(as_slice(rows), self._weight(rows, columns)), 1e-300))

    def of_cause(self, rows: IntArray, columns: FloatArray) -> float:
        """The same, and how the noise of runs differs from that of their instrument, independent of it, is uncertain
        too. For what is tested once more with the noise that is left beside it: a noise that is estimated without it
        holds it, and is no measure of it.
        """
        weight = self._weight(rows, columns)
        of_runs = np.bincount(self.run[as_slice(rows)], weight, self.of_runs.size)
        inverse = self._of_instruments(as_slice(rows), weight) + float(np.sum(of_runs**2 / self.of_runs))
        return float(1.0 / max(inverse, 1e-300))

    def _weight(self, rows: IntArray, columns: FloatArray) -> FloatArray:
        """(n_rows,): shares of the readings in a test."""
        weight = np.einsum("ij,ij->i", columns, columns) / self.sigma[as_slice(rows)] ** 2
        return np.asarray(weight / max(float(weight.sum()), 1e-300))

    def _of_instruments(self, here: IntArray | slice, weight: FloatArray) -> float:
        of_rows = self.of_rows[here]
        return sum(float(weight[of_rows == own].sum()) ** 2 / float(own) for own in self._each)


def freedom_of(rows: Rows, whitening: Whitening, noise: Sequence[NoiseOf]) -> Freedom:
    """From the noise of the instruments and of the runs."""
    of = {one.group: one.freedom for one in noise}
    per_run = np.array([of.get(group, 1.0) for group in noise_groups(rows.runs)])
    run = np.repeat(np.arange(len(whitening.runs)), np.diff(whitening.starts))
    return Freedom(per_run[rows.run], whitening.sigma, run, np.array([one.freedom for one in whitening.runs]))


def freedom_of_runs(logs: FloatArray, information: FloatArray) -> FloatArray:
    """(n_runs,): degrees of freedom of a variance whose logarithm is as uncertain as that of the noise of each run.

    logs, information: (n_runs,), likeliest logarithms of the scales if they differ by UNEVEN, and what readings tell of
    them. How much runs differ is told by how these scatter, and averaged over what it may be.
    """
    uneven = np.linspace(0.0, 1.0, PLACES + 1)[1:, np.newaxis] * MOST_UNEVEN
    told = information > 0.0
    each = information[told]
    alone = logs[told] * (each + UNEVEN**-2) / each  # what its readings say of a run, nothing else being known
    variance = uneven**2 + 1.0 / each
    unlikely = 0.5 * (np.log(variance) + alone**2 / variance).sum(axis=1) + 0.5 * (uneven[:, 0] / UNEVEN) ** 2
    weight = np.exp(unlikely.min() - unlikely)
    left = (weight @ (1.0 / (information + uneven**-2))) / weight.sum()
    return np.asarray(0.5 / left)
