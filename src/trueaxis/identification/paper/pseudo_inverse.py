"""Least squares of many small systems at once: the connected parts of a sparse system, each by its singular values."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_array, csc_array, csr_array
from scipy.sparse.csgraph import connected_components

from trueaxis.identification.paper.grid import IntArray
from trueaxis.measurement.machine import FloatArray

LARGEST_PART = 500  # unknowns; every one then depends on every reading of its runs: time grows with the third power


class TooLargeError(ValueError):
    """Too many unknowns hang together; `unknowns` says how many."""

    def __init__(self, unknowns: int) -> None:
        self.unknowns = unknowns
        super().__init__(f"{unknowns} unknowns must be solved together")


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class PseudoInverse:
    """Minimum-norm least-squares inverse of a matrix (m, k).

    inverse: (k, m); null: (k, k - rank), an orthonormal basis of what the equations do not see; condition: the
    largest ratio of singular values kept within a part; ranks: (rank, unknowns) of the parts, each pair once.
    """

    inverse: csr_array
    null: csc_array
    rank: int
    condition: float
    ranks: tuple[tuple[int, int], ...]


def pseudo_inverse(matrix: csr_array, tolerance: float) -> PseudoInverse:
    """Invert part by part; singular values below tolerance times the largest of their part count as zero.

    Raises TooLargeError where a part has more than LARGEST_PART unknowns.
    """
    m, k = matrix.shape
    across = coo_array(matrix)
    graph = coo_array((np.ones(across.nnz), (across.row, m + across.col)), shape=(m + k, m + k))
    label = connected_components(graph, directed=False)[1].astype(np.int64)
    row_label, column_label = label[:m], label[m:]
    inverse: list[tuple[IntArray, IntArray, FloatArray]] = []
    null: list[tuple[IntArray, FloatArray]] = []
    rank, condition, ranks = 0, 1.0, set()
    for rows, columns in _stacks(row_label, column_label):
        dense = _dense(matrix, rows, columns)
        left, singular, right = np.linalg.svd(dense, full_matrices=False)
        kept = singular > tolerance * singular[:, :1]
        factor = np.divide(1.0, singular, out=np.zeros_like(singular), where=kept)
        found = np.einsum("gsk,gs,gms->gkm", right, factor, left)[:, :, : rows.shape[1]]
        at_row = np.repeat(rows[:, np.newaxis, :], columns.shape[1], axis=1)
        at_column = np.repeat(columns[:, :, np.newaxis], rows.shape[1], axis=2)
        inverse.append((at_column.ravel(), at_row.ravel(), found.ravel()))
        null += [(columns[g], right[g, s]) for g, s in zip(*np.nonzero(~kept), strict=True)]
        of_parts = kept.sum(axis=1)
        rank += int(of_parts.sum())
        ranks |= {(int(r), columns.shape[1]) for r in of_parts}
        smallest = np.where(kept, singular, np.inf).min(axis=1)
        condition = max(condition, float(np.max(singular[:, 0] / smallest)))
    return PseudoInverse(
        inverse=_assembled(inverse, k, m),
        null=_null(null, k),
        rank=rank,
        condition=condition,
        ranks=tuple(sorted(ranks)),
    )


def _stacks(row_label: IntArray, column_label: IntArray) -> list[tuple[IntArray, IntArray]]:
    """Parts of one shape together: rows (parts, m) and columns (parts, k). Unknowns without equation: m = 0."""
    rows, columns = _members(row_label), _members(column_label)
    shapes: dict[tuple[int, int], list[int]] = {}
    for label, members in columns.items():
        shapes.setdefault((len(rows.get(label, ())), len(members)), []).append(label)
    stacks = []
    for (m, k), labels in sorted(shapes.items()):
        if k > LARGEST_PART:
            raise TooLargeError(k)
        of_rows = np.array([rows.get(label, ()) for label in labels], dtype=np.int64).reshape(len(labels), m)
        stacks.append((of_rows, np.array([columns[label] for label in labels], dtype=np.int64)))
    return stacks


def _members(labels: IntArray) -> dict[int, IntArray]:
    order = np.argsort(labels, kind="stable")
    values, first = np.unique(labels[order], return_index=True)
    return dict(zip(values.tolist(), np.split(order, first[1:]), strict=True))


def _dense(matrix: csr_array, rows: IntArray, columns: IntArray) -> FloatArray:
    """(parts, max(m, k), k): rows of zeros are added where there are fewer equations than unknowns."""
    dense = np.zeros((rows.shape[0], max(rows.shape[1], columns.shape[1]), columns.shape[1]))
    place = np.zeros(matrix.shape[1], dtype=np.int64)
    place[columns] = np.arange(columns.shape[1])
    block = matrix[rows.ravel()].tocoo()
    part, row = np.divmod(block.row, max(rows.shape[1], 1))
    dense[part, row, place[block.col]] = block.data
    return dense


def _assembled(pieces: list[tuple[IntArray, IntArray, FloatArray]], k: int, m: int) -> csr_array:
    if not pieces:
        return csr_array((k, m))
    rows, columns, values = (np.concatenate(part) for part in zip(*pieces, strict=True))
    return coo_array((values, (rows, columns)), shape=(k, m)).tocsr()


def _null(vectors: list[tuple[IntArray, FloatArray]], k: int) -> csc_array:
    if not vectors:
        return csc_array((k, 0))
    rows = np.concatenate([columns for columns, _ in vectors])
    place = np.repeat(np.arange(len(vectors)), [columns.size for columns, _ in vectors])
    values = np.concatenate([values for _, values in vectors])
    return coo_array((values, (rows, place)), shape=(k, len(vectors))).tocsc()
