"""Columns of all readings, in each run combinations of a few (`estimation.factors`)."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.linalg import block_diag

from trueaxis.diagnosis.null_model.rows import runs_among
from trueaxis.diagnosis.null_model.whiten import RANK, Whitening
from trueaxis.diagnosis.result import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, slots=True, eq=False)
class ByRun:
    """(n, p) columns. starts: (n_runs + 1,), first row of each run; few: (m, r) of each run, orthonormal; weights: (sum
    of r, p): the columns of a run are its few times its rows of these. All products of columns are those of weights.
    """

    starts: IntArray
    few: tuple[FloatArray, ...]
    weights: FloatArray

    @property
    def ends(self) -> IntArray:
        """(n_runs + 1,): first row of each run among those of the weights."""
        return np.cumsum([0, *(one.shape[1] for one in self.few)])

    def __matmul__(self, right: FloatArray) -> FloatArray:
        """(n, ...): times (p, ...)."""
        inside = self.weights @ right
        each = [few @ inside[first:last] for few, (first, last) in zip(self.few, pairwise(self.ends), strict=True)]
        return np.concatenate([inside[:0], *each])

    def transposed(self, vectors: FloatArray, rows: IntArray | None = None) -> FloatArray:
        """(p, ...): products with vectors (n, ...), or (n_rows, ...), those of some whole runs and 0 elsewhere."""
        ends, inside, chosen = self.ends, [vectors[:0]], list[slice]()
        for place, here in runs_among(self.starts, np.arange(self.starts[-1]) if rows is None else rows):
            inside.append(self.few[place].T @ vectors[here])
            first = chosen.pop().start if chosen and chosen[-1].stop == ends[place] else ends[place]
            chosen.append(slice(first, ends[place + 1]))
        parts = [self.weights[one] for one in chosen]  # neighbours at once, so that nothing has to be copied
        weights = parts[0] if len(parts) == 1 else np.vstack([self.weights[:0], *parts])
        return np.asarray(weights.T @ np.concatenate(inside))

    def squares(self) -> FloatArray:
        """(n,): sum of the squares of each row."""
        each = ((few, few @ (weights @ weights.T)) for few, weights in self.parts())
        return np.concatenate([np.zeros(0), *(np.einsum("ij,ij->i", few, turned) for few, turned in each)])

    def dense(self) -> FloatArray:
        """(n, p), all numbers."""
        return self @ np.eye(self.weights.shape[1])

    def at(self, rows: IntArray) -> FloatArray:
        """(n_rows, p): of some rows, in any order."""
        found = np.empty((rows.size, self.weights.shape[1]))
        run = np.searchsorted(self.starts, rows, side="right") - 1
        for place, (few, weights) in enumerate(self.parts()):
            mine = run == place
            if mine.any():
                found[mine] = few[rows[mine] - self.starts[place]] @ weights
        return found

    def take(self, columns: IntArray | BoolArray | slice) -> "ByRun":
        """Some of the columns."""
        return replace(self, weights=self.weights[:, columns])

    def times(self, right: FloatArray) -> "ByRun":
        """Combinations of the columns, (p, q)."""
        return replace(self, weights=self.weights @ right)

    def beside(self, columns: FloatArray) -> "ByRun":
        """With further columns (n, k)."""
        return by_run(beside(self.parts(), np.split(columns, self.starts[1:-1])))

    def whitened(self, whiten: Whitening) -> "ByRun":
        """Made independent; of what a run's own unknowns hold rounding alone would be left."""
        parts = []
        for place, (few, weights) in enumerate(self.parts()):
            q, r = np.linalg.qr(whiten.of_run(place, few))
            white = r @ weights
            held = np.linalg.norm(white, axis=0) <= RANK * np.linalg.norm(weights, axis=0) / whiten.runs[place].sigma
            white[:, held] = 0.0
            parts.append((q, white))
        return _joined(parts) if parts else self

    def only(self, keep: BoolArray) -> "ByRun":
        """Of some rows, (n,): a run of which none is kept is none."""
        each = zip(self.parts(), np.split(keep, self.starts[1:-1]), strict=True)
        found = [(few[kept], weights) for (few, weights), kept in each if kept.any()]
        return by_run(found) if found else self.first(0)

    def first(self, count: int) -> "ByRun":
        """Of the first runs."""
        return ByRun(self.starts[: count + 1], self.few[:count], self.weights[: self.ends[count]])

    def of_run(self, place: int) -> FloatArray:
        """(r, p): the weights of a run."""
        ends = self.ends
        return self.weights[ends[place] : ends[place + 1]]

    def parts(self) -> Iterator[tuple[FloatArray, FloatArray]]:
        """Few (m, r) and weights (r, p) of each run."""
        return zip(self.few, (self.weights[first:last] for first, last in pairwise(self.ends)), strict=True)


def beside(
    parts: Iterable[tuple[FloatArray, FloatArray]], further: Iterable[FloatArray]
) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Columns (m, r) and weights (r, p) of each run with further columns (m, k) of each."""
    for (columns, weights), more in zip(parts, further, strict=True):
        yield np.hstack([columns, more]), block_diag(weights, np.eye(more.shape[1]))


def by_run(parts: Iterable[tuple[FloatArray, FloatArray]]) -> ByRun:
    """From columns (m, r) and weights (r, p) of each run."""
    turned = ((np.linalg.qr(columns), weights) for columns, weights in parts)
    return _joined([(q, r @ weights) for (q, r), weights in turned])


def of_basis(basis: FloatArray) -> ByRun:
    """A basis (n, rank), orthonormal, as that of a single run."""
    return ByRun(np.array([0, basis.shape[0]]), (basis,), np.eye(basis.shape[1]))


def _joined(parts: Sequence[tuple[FloatArray, FloatArray]]) -> ByRun:
    starts = np.cumsum([0, *(few.shape[0] for few, _ in parts)])
    return ByRun(starts, tuple(few for few, _ in parts), np.vstack([weights for _, weights in parts]))
