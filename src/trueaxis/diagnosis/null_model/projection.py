"""The whitened base as an orthonormal basis, and what it leaves of readings and signatures."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy.linalg import qr

from trueaxis.diagnosis.null_model.by_run import ByRun
from trueaxis.diagnosis.null_model.rows import as_slice
from trueaxis.diagnosis.null_model.whiten import RANK
from trueaxis.diagnosis.result import FloatArray, IntArray
from trueaxis.estimation.factors import decomposed

LEAST = 1e-4  # share of a column's length that must be left of it, for it to explain anything
TOLD = 1e-6  # of the largest eigenvalue of products of columns, below which rounding is all there is
SLIGHT = 1e-3  # standard deviations of the noise that matter to nobody


def _nothing() -> FloatArray:
    return np.zeros((0, 0))


@dataclass(frozen=True, eq=False)
class Projection:
    """What is no news: columns that are free, columns that may be there in part, and causes that are named.

    basis: (n, rank), orthonormal columns that span the base. soft: (n, k), orthonormal directions in which readings
    also vary by chance, their standard deviation d against the noise told by shrink: (k,), 1 - 1/sqrt(1 + d^2): the
    noise has the covariance 1 + soft d^2 soft' there. causes: (n, j), orthonormal after both.
    """

    basis: ByRun
    soft: FloatArray = field(default_factory=_nothing)
    shrink: FloatArray = field(default_factory=lambda: np.zeros(0))
    causes: FloatArray = field(default_factory=_nothing)

    @property
    def rank(self) -> int:
        """Number of combinations that are free."""
        return int(self.basis.weights.shape[1]) + int(self.causes.shape[1] if self.causes.size else 0)

    @property
    def left(self) -> FloatArray:
        """(n,): share of each reading's variance that is free neither by the base nor by causes."""
        found = 1.0 - self.basis.squares()
        return np.asarray(found - np.sum(self.causes**2, axis=1) if self.causes.size else found)

    @property
    def by_chance(self) -> FloatArray:
        """(n, k): how readings vary by chance, one standard deviation each."""
        if not self.soft.size:
            return np.zeros((int(self.basis.starts[-1]), 0))
        return np.asarray(self.soft * np.sqrt((1.0 - self.shrink) ** -2 - 1.0))

    def rest(self, columns: FloatArray) -> FloatArray:
        """What is left of columns (n,) or (n, k), independent and of variance 1 where it is noise alone."""
        left = self._rooted(columns - self.basis @ self.basis.transposed(columns))
        return np.asarray(left - self.causes @ (self.causes.T @ left)) if self.causes.size else left

    def inner(self, columns: FloatArray, rows: IntArray) -> FloatArray:
        """(rank + k, m): B'a such that rest(a)' rest(b) = a'b - (B'a)'(B'b) for any columns a and b.

        columns: (n_rows, m), zero but in those rows, ascending, of whole runs.
        """
        parts, here = [self.basis.transposed(columns, rows)], as_slice(rows)
        if self.soft.size:
            inside = self.soft[here].T @ columns
            parts.append(np.sqrt(1.0 - (1.0 - self.shrink) ** 2)[:, np.newaxis] * inside)
        return np.vstack([*parts, self.inner_causes[here].T @ columns])

    @cached_property
    def inner_causes(self) -> FloatArray:
        """(n, j): what of B is due to causes."""
        return self._rooted(self.causes) if self.causes.size else np.zeros((int(self.basis.starts[-1]), 0))

    def rest_transposed(self, columns: FloatArray) -> FloatArray:
        """(n, k): their products with any columns are those of `columns` with what is left of them."""
        if self.causes.size:
            columns = columns - self.causes @ (self.causes.T @ columns)
        rooted = self._rooted(columns)
        return np.asarray(rooted - self.basis @ self.basis.transposed(rooted))

    def products(self, rows: IntArray, columns: FloatArray) -> FloatArray:
        """(k, k): of what is left of columns (n_rows, k), zero but in those rows, of whole runs."""
        held = self.inner(columns, rows)
        return np.asarray(columns.T @ columns - held.T @ held)

    def explaining(
        self, rows: IntArray, columns: FloatArray, residual: FloatArray, products: FloatArray | None = None
    ) -> tuple[FloatArray, int]:
        """(k,), the combination of columns of which most is left, `rest`, of what is left of the readings, (n,).

        And of how many it is the best. columns: (n_rows, k), zero but in those rows, of whole runs; products: of them,
        where they are known. From products of the columns, for a quarter of what an orthonormal basis costs.
        """
        whole = np.sum(columns**2, axis=0)
        gram = self.products(rows, columns) if products is None else products
        kept = np.diag(gram) > LEAST**2 * whole
        size = np.sqrt(np.diag(gram)[kept])
        values, vectors = np.linalg.eigh(gram[np.ix_(kept, kept)] / np.outer(size, size))
        told = values > TOLD * values.max(initial=0.0)
        turned = vectors[:, told] / np.sqrt(values[told]) / size[:, np.newaxis]
        inside = turned.T @ (columns[:, kept].T @ self._rooted(residual)[rows])
        found = np.zeros(kept.size)
        found[kept] = turned @ inside
        return found, int(np.count_nonzero(told))

    def extended(self, columns: FloatArray) -> "Projection":
        """The projection that takes further columns (n, k) away, too: causes that are named."""
        more = self.rest(columns)
        size = np.linalg.norm(columns, axis=0)
        left = np.linalg.norm(more, axis=0)
        kept = more[:, left > RANK * size]
        if kept.shape[1] == 0:
            return self
        kept -= self.basis @ self.basis.transposed(kept)  # of what is left of a column hardly any, rounding is a part
        fresh = orthonormal(kept / np.linalg.norm(kept, axis=0))
        causes = np.hstack([self.causes, fresh]) if self.causes.size else fresh
        return Projection(self.basis, self.soft, self.shrink, causes)

    def softened(self, columns: FloatArray) -> "Projection":
        """With further chance in the readings: columns (n, k), whitened, each times its standard deviation."""
        if columns.shape[1] == 0:
            return self
        left = columns - self.basis @ self.basis.transposed(columns)
        q, r = np.linalg.qr(left)
        turned, deviation, _ = decomposed(r)
        kept = deviation > SLIGHT
        shrink = 1.0 - 1.0 / np.sqrt(1.0 + deviation[kept] ** 2)
        return Projection(self.basis, q @ turned[:, kept], shrink)

    def _rooted(self, columns: FloatArray) -> FloatArray:
        if not self.soft.size:
            return columns
        inside = self.soft.T @ columns
        scaled = self.shrink * inside if inside.ndim == 1 else self.shrink[:, np.newaxis] * inside
        return np.asarray(columns - self.soft @ scaled)


def spanned(columns: ByRun) -> ByRun:
    """(n, rank): an orthonormal basis of columns (n, p), whitened."""
    return replace(columns, weights=orthonormal(columns.weights))


def orthonormal(columns: FloatArray) -> FloatArray:
    """(n, rank): an orthonormal basis of what columns (n, p) span; the triangular factor tells the rank.

    The cost grows with n p^2.
    """
    size = np.sqrt(np.einsum("ij,ij->j", columns, columns))
    scaled = columns / size if (size > 0.0).all() else columns[:, size > 0.0] / size[size > 0.0]
    if scaled.shape[1] == 0:
        return np.zeros((columns.shape[0], 0))
    q, r = qr(scaled, mode="economic", overwrite_a=True, check_finite=False)
    left, singular, _ = decomposed(r)
    rank = int(np.count_nonzero(singular > RANK * singular[0]))
    return np.asarray(q @ left[:, :rank])
