"""Readings that do not belong to their series: far from their repeats, and from their neighbours."""

import numpy as np

from trueaxis.diagnose.result import BoolArray, FloatArray, IntArray, Outlier
from trueaxis.diagnose.rows import Rows

FAR = 5.0  # robust standard deviations
WINDOW = 7  # readings of the running median
FEWEST = 3  # readings of one target, for their median to tell which is off
GAUSSIAN_MAD = 0.674489750196082


def outliers(rows: Rows, values: FloatArray) -> tuple[BoolArray, tuple[Outlier, ...]]:
    """(n,) which rows to keep, and those left out. values: (n,) mm, readings less what is expected.

    A series that jumps has many readings far from their repeats, side by side: those stay, a jump is no outlier.
    """
    deviation = _from_repeats(rows, values)
    known = np.isfinite(deviation)
    if not known.any():
        return np.ones(rows.size, dtype=bool), ()
    scale = _scale(rows, values)
    if scale == 0.0:
        return np.ones(rows.size, dtype=bool), ()
    z = np.where(known, deviation / scale, 0.0)
    far = np.abs(z) > FAR
    same = rows.run[1:] == rows.run[:-1]
    near = np.abs(z) > 0.5 * FAR
    neighbour = np.zeros(rows.size, dtype=bool)
    neighbour[1:] |= near[:-1] & same
    neighbour[:-1] |= near[1:] & same
    off = far & ~neighbour
    found = tuple(
        Outlier(rows.runs[rows.run[at]].id, int(rows.seq[at]), float(deviation[at]), float(z[at]))
        for at in np.flatnonzero(off)
    )
    return ~off, found


def _scale(rows: Rows, values: FloatArray) -> float:
    """Robust standard deviation of a reading, mm: from differences of neighbouring repeats, their course taken away.

    Of the distances from the median of three a third are 0: they would make the scale too small.
    """
    order = np.lexsort((rows.run * 10**6 + rows.passing, rows.target))
    pairs = rows.target[order[1:]] == rows.target[order[:-1]]
    first, second = order[:-1][pairs], order[1:][pairs]
    difference = np.full(rows.size, np.nan)
    difference[second] = values[second] - values[first]
    for index in rows.present:
        mine = rows.of_run(index)
        difference[mine] -= _course(difference[mine])
    known = difference[np.isfinite(difference)]
    # of WINDOW readings the median is one itself: what is left of it is 0, of the others a little too small
    known = known[known != 0.0]
    return float(np.median(np.abs(known))) / GAUSSIAN_MAD / np.sqrt(2.0) if known.size else 0.0


def _from_repeats(rows: Rows, values: FloatArray) -> FloatArray:
    """(n,): distance from the median of the readings of the same target, offsets of passes taken away; NaN if few."""
    level = _less_medians(values, rows.run * 10**6 + rows.passing)
    found = np.full(rows.size, np.nan)
    order = np.argsort(rows.target, kind="stable")
    first = np.flatnonzero(np.diff(rows.target[order], prepend=-1))
    for mine in np.split(order, first[1:]):
        if mine.size >= FEWEST:
            found[mine] = level[mine] - np.median(level[mine])
    for index in rows.present:
        mine_of_run = rows.of_run(index)
        found[mine_of_run] -= _course(found[mine_of_run])
    return found


def _course(deviation: FloatArray) -> FloatArray:
    """(n,): running median of a run, 0 where it is not known: what drifts or jumps is no outlier."""
    half = WINDOW // 2
    padded = np.pad(deviation, half, constant_values=np.nan)
    windows = np.lib.stride_tricks.sliding_window_view(padded, WINDOW)
    known = np.isfinite(windows).any(axis=1)
    found = np.zeros(deviation.size)
    found[known] = np.nanmedian(windows[known], axis=1)
    return found


def _less_medians(values: FloatArray, group: IntArray) -> FloatArray:
    found = values.copy()
    order = np.argsort(group, kind="stable")
    first = np.flatnonzero(np.diff(group[order], prepend=-1))
    for mine in np.split(order, first[1:]):
        found[mine] -= np.median(values[mine])
    return found
