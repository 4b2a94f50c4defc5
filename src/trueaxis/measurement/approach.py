"""Approach directions: the way by which each axis came to where it was read."""

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
DirectionArray = npt.NDArray[np.int8]


def approach_directions(seq: npt.NDArray[np.int64], positions: FloatArray, start: FloatArray | None) -> DirectionArray:
    """Approach directions of the rows of one run, (n_axes, n): +1, -1, or 0 where the axis has not moved yet.

    seq: (n,), the order in which the rows were read; positions: (n_axes, n); start: (n_axes,), where the run began
    (its home), or None where that is not known. An axis that stands still keeps its last direction: it still
    rests on the flank by which it came.
    """
    order = np.argsort(seq, kind="stable")
    path = positions[:, order]
    before = path[:, :1] if start is None else start[:, np.newaxis]
    steps = np.sign(np.diff(path, prepend=before, axis=1)).astype(np.int8)
    last = np.maximum.accumulate(np.where(steps != 0, np.arange(steps.shape[1]), 0), axis=1)
    found = np.empty_like(steps)
    found[:, order] = np.take_along_axis(steps, last, axis=1)
    return found
