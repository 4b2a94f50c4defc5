"""Factors of matrices: upper triangles that say of unknowns what rows say, and columns as combinations of a few.

Triangles are R of QR factorisations, never a product of a matrix with itself, by LAPACK's routines in blocks: on 450
unknowns they take half the time of `numpy.linalg.qr`, and where one side is a triangle already a tenth.

The hundreds of unknowns of a machine change the readings along a line or circle in but some twelve to fifty ways;
beyond these is rounding. So time and memory of all that is done with them grow with the few, not with the hundreds.
"""

from collections.abc import Sequence

import numpy as np
from scipy.linalg import qr, svd
from scipy.linalg.lapack import dgeqrt, dtpqrt, dtrtri

from trueaxis.measurement.machine import FloatArray

PANEL, FOLDED = 32, 16  # columns at a time, of rows and of rows below a triangle: the fastest from 250 to 450 columns
ROUNDING = 1e-15  # of the largest column of a run, as it enters a factor: what is less is not told from rounding


def triangle_of(rows: Sequence[FloatArray]) -> FloatArray:
    """(min(m, n), n): R of m stacked rows of n columns."""
    m, n = sum(part.shape[0] for part in rows), rows[0].shape[1]
    stacked = np.zeros((m, n), order="F")
    np.concatenate(rows, out=stacked)
    if not stacked.size:
        return stacked
    found, _, _ = dgeqrt(min(PANEL, m, n), stacked, overwrite_a=1)
    return np.triu(found[:n])


def with_rows(triangle: FloatArray, rows: FloatArray) -> FloatArray:
    """(n, n): of a triangle (n, n) and rows (m, n) below it, which may be overwritten."""
    return _folded(triangle, rows, 0)


def with_triangle(triangle: FloatArray, other: FloatArray) -> FloatArray:
    """(n, n): of a triangle (n, n) and the first rows (m, n) of another, which may be overwritten.

    Large numbers belong into the first.
    """
    return _folded(triangle, other, other.shape[0])


def _folded(triangle: FloatArray, rows: FloatArray, triangular: int) -> FloatArray:
    if not rows.size:
        return triangle
    found, _, _, _ = dtpqrt(triangular, min(FOLDED, triangle.shape[0]), triangle, rows, overwrite_b=1)
    return np.asarray(found)


def inverse(triangle: FloatArray) -> FloatArray:
    """Of a triangle (n, n) without zeros on its diagonal."""
    return np.asarray(dtrtri(triangle)[0])


def few_of(columns: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(m, r) orthonormal and (r, p), whose product are columns (m, p), by QR with pivoting."""
    told = columns.any(axis=0)
    weights = np.zeros((0, columns.shape[1]))
    if not told.any():
        return np.zeros((columns.shape[0], 0)), weights
    q, r, order = qr(columns[:, told], mode="economic", pivoting=True, check_finite=False)
    size = np.abs(np.diag(r))
    rank = int(np.count_nonzero(size > ROUNDING * size[0]))
    weights = np.zeros((rank, columns.shape[1]))
    weights[:, np.flatnonzero(told)[order]] = r[:rank]
    return np.asarray(q[:, :rank]), weights


def common(weights: Sequence[FloatArray]) -> tuple[list[FloatArray], FloatArray]:
    """The few of all pieces, (r, p), from those of each, (r_i, p); and by what the columns of each are multiplied to
    become theirs, (r_i, r).
    """
    turned, together = few_of(np.vstack(weights))
    return np.split(turned, np.cumsum([one.shape[0] for one in weights])[:-1]), together


def decomposed(matrix: FloatArray, whole: bool = False) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Singular value decomposition: where LAPACK's divide and conquer gives up, by its older routine.

    whole: with the directions that belong to no singular value, too.
    """
    try:
        left, singular, right = np.linalg.svd(matrix, full_matrices=whole)
    except np.linalg.LinAlgError:
        left, singular, right = svd(matrix, full_matrices=whole, lapack_driver="gesvd")
    return left, singular, right
