"""Readings that no noise explains: single ones, or two neighbours, that their repeats do not share.

A reading is judged against what all others let expect of it, by the noise that is left without it (deletion residuals;
Cook and Weisberg, Residuals and Influence in Regression, 1982): the estimate has bent towards it, and the noise of its
run was taken from it, too. The farthest reading is taken out, then the farthest of those that are left; the last one
that is too far for chance and all before it are outliers (Rosner, Technometrics 25, 1983): two that hide each other
are found.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.special import gammaln, ndtr, ndtri, stdtr

from trueaxis.estimation.machine import IntArray
from trueaxis.estimation.noise import Noise, Whitening
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray

FEWEST = 3  # readings of a run, of which one can be told from the others
EXPECTED = 0.05  # good readings that are taken for outliers, of a whole data set
NEIGHBOURS = 2  # more than two spoilt readings in a row are not chance
SHARED = 0.5  # of a deviation, that its repeats show as well: then it is structure
HALF = 0.6745  # of a normal distribution lies within so many standard deviations
MOST = 0.1  # of a run, or two readings of a short one: where more are off, the model is
# share of the runs whose noise says nothing of that of their instrument: something else is in it, as a step, which no
# reading is spoilt by; readings that say that such a run has the noise of its instrument
ELSEWISE, HARDLY = 0.05, 1.0
WINDOW = 128  # readings that are judged together, at the cost of their cube: two outliers raise their noise by little
ROUNDING = 1e-9  # of its weight, below which nothing is left of a reading
QUIET = 3.0  # standard deviations: a window of a long run, nothing left of which is beyond, has no further outlier
# share that noise has of the variance of a deletion residual, at least: where it is less, what the others let expect is
# less certain than a reading, and rests on how smooth curves are; such a residual counts as if it were as certain. On
# world 9 of tests/worlds two good readings at the end of a line were taken for outliers without it
HELD = 0.5


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Judged:
    """Readings of one run, in their order, and their noise as it was estimated.

    steps: (n,), time since the reading before in typical steps; left: (n,), mm, what the estimate leaves of them;
    shared: (n,), whether repeats deviate alike, see `shared_by_repeats`; good: (n,), those that the estimate is of;
    noise: of the run; chance: (n, j), mm, how the run varies besides, one standard deviation each; taken: (n, k), the
    inverse of the covariance of the good ones times a root of the covariance of what the estimate makes of them; usual:
    square of the noise of the instrument over that of the run; told: readings that say that the run has the noise of
    its instrument, infinite where its noise is known.
    """

    steps: FloatArray
    left: FloatArray
    shared: BoolArray
    good: BoolArray
    noise: Noise
    chance: FloatArray
    taken: FloatArray
    usual: float
    told: float


def covariance_of(noise: Noise, steps: FloatArray, chance: FloatArray) -> FloatArray:
    """(n, n), mm^2, of readings as in `Judged`."""
    at = np.cumsum(steps)
    found = chance @ chance.T
    if noise.slow > 0.0:
        found += noise.slow**2 * np.exp(np.abs(at[:, np.newaxis] - at) / -noise.lasts)
    found[np.diag_indices_from(found)] += noise.white**2
    return np.asarray(found)


def surely_none(left: FloatArray, noise: Noise, steps: FloatArray, usual: float, readings: int) -> bool:
    """Whether no reading of a run is far enough for an outlier, whatever the others let expect of it: which need not be
    worked out then. Arguments as in `Judged`, all readings good; readings: of the whole data set.

    What the others let expect makes a deviation at most 1 / sqrt(HELD) as large, and the noise that is left without the
    outliers is that of the instrument, or what half of the readings show. Of 48 runs of 75 readings seven in eight are
    done with in a tenth of the time.
    """
    if left.size < FEWEST:
        return True
    whiten = Whitening(noise, steps)
    away = np.abs(whiten.weighed(left)) / np.sqrt(whiten.weights())
    least = min(1.0, float(np.sqrt(usual)), float(np.median(away)) / HALF)
    far = -float(ndtri(0.5 * EXPECTED / readings)) * np.sqrt(HELD) * least
    return bool(away.max() <= far)


def spoilt(one: Judged, readings: int) -> BoolArray:
    """(n,): outliers of one run. readings: of the whole data set."""
    found = np.zeros(one.left.size, dtype=bool)
    if one.left.size < FEWEST:
        return found
    apart = ~one.shared
    for here in _windows(one):
        order, last = [], 0
        for place, square, squares, freedom in _farthest_first(one, here, apart[here]):
            order.append(here.start + place)
            if _by_chance(one, square, squares, freedom) < EXPECTED / readings:
                last = len(order)
        found[order[:last]] = True
    found &= apart
    return found & ~long(found) if found.sum() <= _most(found.size) else np.zeros_like(found)


def _by_chance(one: Judged, square: float, squares: float, freedom: float) -> float:
    """Probability of a good reading so far away. square: of its distance in variances of the noise of the run; squares:
    sum of the same of all that are left, of some degrees of freedom.

    The variance of the run about that of its instrument is, beforehand, a mixture of two inverse chi-squares: of as
    many degrees of freedom as say that the run has the noise of its instrument, or of hardly any.
    """
    if np.isinf(one.told):
        return 2.0 * float(ndtr(-np.sqrt(square)))
    told = np.array([one.told, HARDLY])
    whole, sums = told + freedom, told * one.usual + squares
    likely = np.log([1.0 - ELSEWISE, ELSEWISE]) + gammaln(0.5 * whole) - gammaln(0.5 * told)
    likely += 0.5 * (told * np.log(told * one.usual) - whole * np.log(sums))
    weights = np.exp(likely - likely.max())
    tails = 2.0 * stdtr(whole, -np.sqrt(square * whole / sums))
    return float(weights @ tails / weights.sum())


def _most(readings: int) -> float:
    return max(MOST * readings, NEIGHBOURS)


def _windows(one: Judged) -> Iterator[slice]:
    """Neighbours that are judged together; of a long run those that may hold an outlier."""
    count = -(-one.left.size // WINDOW)
    ends = np.linspace(0, one.left.size, count + 1).astype(np.int64).tolist()
    far = np.ones(one.left.size, dtype=bool)
    if count > 1:
        whiten = Whitening(one.noise, one.steps)
        far = np.abs(whiten.weighed(one.left)) > QUIET * np.sqrt(whiten.weights())
    for first, last in pairwise(ends):
        if far[first:last].any():
            yield slice(first, last)


def _farthest_first(one: Judged, here: slice, apart: BoolArray) -> Iterator[tuple[int, float, float, float]]:
    """The readings of a window, the farthest first, as many as may be outliers and one more, of a long run until none
    is far: its place; the square of its distance from what those after it let expect, in variances of that by the noise
    of the run; the sum of the same of those after it, and its degrees of freedom, zeros where the noise is known.
    apart: (m,), which may be outliers.
    """
    covariance = covariance_of(one.noise, one.steps[here], one.chance[here])
    good, left = one.good[here].copy(), one.left[here]
    precision = np.zeros_like(covariance)
    precision[np.ix_(good, good)] = np.linalg.inv(covariance[np.ix_(good, good)])
    weighed, out = precision @ left, np.flatnonzero(~good)
    alone = np.where(good, np.diag(precision), 1.0)
    before = _squares_of_left_out(covariance, precision, left, out)
    precision -= one.taken[here] @ one.taken[here].T

    def left_by(further: FloatArray) -> tuple[float, float]:
        if np.isinf(one.told):
            return 0.0, 0.0  # the noise of the run is known, whatever they are
        kept = good & apart  # what repeats share is no noise
        squares, free = (weighed[kept] ** 2 / alone[kept]).sum(), (np.diag(precision)[kept] / alone[kept]).sum()
        return float(squares + further.sum()), max(float(free), 0.0) + further.size

    order = np.argsort(-before, kind="stable")
    for number, k in enumerate(order.tolist(), 1):
        yield int(out[k]), float(before[k]), *left_by(before[order[number:]])
    least = QUIET**2 if one.left.size > WINDOW else 0.0  # a few outliers make a short run as noisy as they are far
    for _ in range(int(_most(good.size)) + 1 - out.size):
        free = np.diag(precision)
        told = good & apart & (free > ROUNDING * alone)
        squares = np.where(told, weighed**2 / np.maximum(free, HELD * alone), 0.0)
        place = int(np.argmax(squares))
        if squares[place] <= least:
            return
        column = precision[:, place] / precision[place, place]
        weighed -= column * weighed[place]
        precision -= np.outer(column, precision[place])
        precision[place], precision[:, place], weighed[place], good[place] = 0.0, 0.0, 0.0, False
        yield place, float(squares[place]), *left_by(before[:0])


def _squares_of_left_out(covariance: FloatArray, precision: FloatArray, left: FloatArray, out: IntArray) -> FloatArray:
    """(k,), in variances: of what readings that were left out are away from what the others let expect of them."""
    by_others = covariance[out] @ precision
    variance = np.diag(covariance)[out] - np.einsum("ij,ij->i", by_others, covariance[out])
    return np.asarray((left[out] - by_others @ left) ** 2 / variance)


def excess(residual: FloatArray, scale: float) -> float:
    """By what residuals of a run, (n,), mm, exceed a noise that is known, mm; 1 at least.

    A gross outlier pulls the values along, and with them good readings of its run: the largest residual goes first, the
    others wait. A noise that is estimated from the residuals is then as large by itself.
    """
    return max(1.0, float(np.median(np.abs(residual))) / (HALF * scale))


def shared_by_repeats(residual: FloatArray, repeats: IntArray) -> BoolArray:
    """(n,): whether the repeats of a reading deviate like it, which is structure. repeats: (n,), the same number where
    the same place was read.
    """
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
