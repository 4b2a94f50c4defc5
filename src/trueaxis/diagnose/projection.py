"""The whitened base as an orthonormal basis, and what it leaves of readings and signatures."""

from dataclasses import dataclass

import numpy as np

from trueaxis.diagnose.base import RANK
from trueaxis.diagnose.result import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Projection:
    """basis: (n, rank), orthonormal columns that span the base."""

    basis: FloatArray

    @property
    def rank(self) -> int:
        """Number of combinations that the readings determine."""
        return int(self.basis.shape[1])

    def rest(self, columns: FloatArray) -> FloatArray:
        """What the base leaves of columns (n,) or (n, k)."""
        left = columns - self.basis @ (self.basis.T @ columns)
        return np.asarray(left - self.basis @ (self.basis.T @ left))

    def extended(self, columns: FloatArray) -> "Projection":
        """The projection that takes further columns (n, k) away, too."""
        more = self.rest(columns)
        size = np.linalg.norm(columns, axis=0)
        left = np.linalg.norm(more, axis=0)
        kept = more[:, left > RANK * size]
        if kept.shape[1] == 0:
            return self
        return Projection(np.hstack([self.basis, orthonormal(kept / np.linalg.norm(kept, axis=0))]))


def orthonormal(columns: FloatArray) -> FloatArray:
    """(n, rank): an orthonormal basis of what columns (n, p) span; the triangular factor tells the rank.

    The cost grows with n p^2.
    """
    size = np.linalg.norm(columns, axis=0)
    scaled = columns[:, size > 0.0] / size[size > 0.0]
    if scaled.shape[1] == 0:
        return np.zeros((columns.shape[0], 0))
    q, r = np.linalg.qr(scaled)
    left, singular, _ = np.linalg.svd(r)
    rank = int(np.count_nonzero(singular > RANK * singular[0]))
    return np.asarray(q @ left[:, :rank])
