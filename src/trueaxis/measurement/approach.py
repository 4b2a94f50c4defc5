"""The way by which each axis came to where it was read, from the order of the readings of a run."""

from collections.abc import Sequence

import numpy as np

from trueaxis.measurement.machine import FloatArray
from trueaxis.measurement.reading_geometry import home_positions
from trueaxis.measurement.readings import DirectionArray, IntArray
from trueaxis.measurement.setup import Run


def approach_directions(run: Run, axes: Sequence[str], seq: IntArray, positions: FloatArray) -> DirectionArray:
    """Directions of the rows of one run, (n_axes, n): +1, -1, or 0 where an axis has not moved yet.

    seq: (n,), the order in which the rows were read; positions: (n_axes, n), mm or deg. A laser or probe reads standing
    axes: the direction is that of the step from the reading before, at first from home. A ball bar is read on the way:
    it is that in which the axis moves there. An axis that stands still keeps its last direction: it still rests on the
    flank by which it came.
    """
    order = np.argsort(seq, kind="stable")
    path, home = positions[:, order], home_positions(run, axes)
    if run.instrument == "ballbar" and path.shape[1] > 2:
        moved = _velocities(path)
    else:
        moved = np.diff(path, prepend=path[:, :1] if home is None else home, axis=1)
    steps = np.sign(moved).astype(np.int8)
    last = np.maximum.accumulate(np.where(steps != 0, np.arange(steps.shape[1]), 0), axis=1)
    found = np.empty_like(steps)
    found[:, order] = np.take_along_axis(steps, last, axis=1)
    return found


def _velocities(path: FloatArray) -> FloatArray:
    """(n_axes, n): along the path, at each reading, of the parabola through it and its neighbours; 0 where an axis is
    in one place for all three.
    """
    steps = np.linalg.norm(np.diff(path, axis=1), axis=0)
    way = np.append(0.0, np.cumsum(steps)) if (steps > 0.0).all() else np.arange(float(path.shape[1]))
    found: FloatArray = np.gradient(path, way, axis=1, edge_order=2)
    found[:, 1:-1][(np.diff(path[:, 1:], axis=1) == 0.0) & (np.diff(path[:, :-1], axis=1) == 0.0)] = 0.0
    return found
