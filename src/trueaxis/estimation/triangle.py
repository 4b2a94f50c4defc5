"""Upper triangles that say of unknowns what rows say: R of QR factorisations, never a product of a matrix with itself.

LAPACK's routines in blocks: on 450 unknowns they take half the time of `numpy.linalg.qr`, and where one side is a
triangle already a tenth.
"""

from collections.abc import Sequence

import numpy as np
from scipy.linalg.lapack import dgeqrt, dtpqrt, dtrtri

from trueaxis.measurement.machine import FloatArray

PANEL, FOLDED = 32, 16  # columns at a time, of rows and of rows below a triangle: the fastest from 250 to 450 columns


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
