"""Readings that no noise explains: single ones, or two neighbours, that their repeats do not share."""

import numpy as np
from scipy.special import ndtri

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray

EXPECTED = 0.05  # good readings that are taken for outliers, of a whole data set
NEIGHBOURS = 2  # more than two spoilt readings in a row are not chance
SHARED = 0.5  # of a deviation, that its repeats show as well: then it is structure
ALIKE = 0.5  # of the largest one: a large outlier lifts the slow noise of its whole run, and smaller ones wait
HALF = 0.6745  # of a normal distribution lies within so many standard deviations
MOST = 0.1  # of a run, or two readings of a short one: where more are off, the model is


def spoilt(
    noise: Noise,
    scale: float,
    steps: FloatArray,
    residual: FloatArray,
    repeats: IntArray,
    readings: int,
    rounds: int | None = None,
) -> BoolArray:
    """(n,): outliers of one run. residual: (n,), mm; repeats: (n,), the same number where the same place was read;
    readings: of the whole data set; rounds: after which the search ends, else when nothing is left.
    """
    limit = float(-ndtri(0.5 * EXPECTED / max(readings, 1)))
    found = np.zeros(residual.size, dtype=bool)
    most = max(MOST * residual.size, NEIGHBOURS)
    for _ in range(rounds or int(most) + 1):
        good = np.flatnonzero(~found)
        if good.size < 3:
            break
        between = np.diff(np.cumsum(steps)[good], prepend=0.0)
        whiten = Whitening(noise, between, scale)
        z = np.abs(whiten.weighed(residual[good])) / np.sqrt(whiten.weights())
        z[_shared(residual[good], repeats[good])] = 0.0
        peaks = (z > max(limit, ALIKE * float(z.max()))) & (z >= _largest_around(z))
        if not peaks.any():
            break
        found[good[peaks]] = True
    return found & ~long(found) if found.sum() <= most else np.zeros(residual.size, dtype=bool)


def excess(residual: FloatArray, scale: float) -> float:
    """By what residuals of a run, (n,), mm, exceed a noise that is known, mm; 1 at least.

    A gross outlier pulls the values along, and with them good readings of its run: the largest residual goes first, the
    others wait. A noise that is estimated from the residuals is then as large by itself.
    """
    return max(1.0, float(np.median(np.abs(residual))) / (HALF * scale))


def _largest_around(z: FloatArray) -> FloatArray:
    padded = np.pad(z, 2, constant_values=-np.inf)
    return np.asarray(np.max([padded[k : k + z.size] for k in range(5)], axis=0))


def _shared(residual: FloatArray, repeats: IntArray) -> BoolArray:
    """(n,): whether the repeats of a reading deviate like it."""
    found = np.zeros(residual.size, dtype=bool)
    order = np.argsort(repeats, kind="stable")
    first = np.flatnonzero(np.diff(repeats[order], prepend=-1))
    count = np.diff(first, append=order.size)
    for many in np.unique(count[count > 1]).tolist():  # all places that were read as often at once
        mine = order[first[count == many][:, np.newaxis] + np.arange(many)]
        own = residual[mine]
        others = np.stack([np.median(np.delete(own, k, axis=1), axis=1) for k in range(many)], axis=1)
        found[mine] = others * np.sign(own) > SHARED * np.abs(own)
    return found


def long(found: BoolArray) -> BoolArray:
    """(n,): those of more than NEIGHBOURS in a row: they are no chance."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], found.astype(np.int8), [0]])))
    many = np.zeros(found.size, dtype=bool)
    for first, last in edges.reshape(-1, 2):
        many[first:last] = last - first > NEIGHBOURS
    return many
