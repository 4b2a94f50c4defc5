"""Columns as combinations of a few.

The hundreds of unknowns of a machine change the readings along a line or circle in but some twelve to fifty ways;
beyond these is rounding. So time and memory of all that is done with them grow with the few, not with the hundreds.
"""

from collections.abc import Sequence

import numpy as np
from scipy.linalg import qr

from trueaxis.measurement.machine import FloatArray

ROUNDING = 1e-15  # of the largest column of a run, as it enters a factor: what is less is not told from rounding


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
