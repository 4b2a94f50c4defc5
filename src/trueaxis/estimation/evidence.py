"""The marginal likelihood of readings by the sizes, its best point, and the posterior there and about it.

The marginal likelihood of the readings, all unknowns integrated out, is maximised with the priors of the sizes. Its
derivative is exact (Fisher's identity): with u an unknown in units of its size, d log p / d log size is the sum of
E[u^2 | readings] - 1. The unknowns of single runs stay in blocks of their own, so that the cost of a point depends on
the number of runs and unknowns alone, not on that of the readings.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.linalg import hadamard, solve_triangular

from trueaxis.estimation.curve_prior import SHAPE
from trueaxis.estimation.factors import inverse, with_rows, with_triangle
from trueaxis.estimation.posterior import OwnPosterior, Posterior, parted_root
from trueaxis.estimation.reduce import OwnBlock, Reduced
from trueaxis.estimation.sizes import Sizes
from trueaxis.measurement.machine import FloatArray

MOST_STEPS = 60
NO_GAIN = 3e-4  # of a step, in the logarithm of the likelihood: likelihoods as near as that say the same
LEAST_CURVED = 0.1  # of the curvature that was expected along a step: one that told less is not learnt from
FARTHEST = 3.0  # standard deviations of a size from what was expected: beyond, the data are not of such a machine
PAIRS = 8  # of sizes over which the posterior is averaged, a power of 2
# Standard deviations of a size at which its two values are taken. The mean square of normal distributions with these
# two sizes is that of the normal distribution whose interval of 95 % holds as much of the mixture over all sizes, to
# 4 % where the size is known to a factor of 1.1 to 4 (1.19 to 1.29; of the mean square over all sizes the largest ones
# make nearly all: 6.8 times the middle one for a factor of 4, where 4.2 times holds 95 %).
NODE = 1.2
SAID = 3.0  # times what was expected of a size, from where on the contract has it reported
# Logarithm of how much likelier it must be than the size that was expected: half the square of 1.96, as 95 % ask
LIKELIER = 1.92


@dataclass(frozen=True, slots=True, eq=False)
class _Batch:
    """Blocks of the same kinds: own (m, k, k); others (m, k, n + 1), by the others, and readings."""

    kinds: tuple[str, ...]
    places: tuple[int, ...]
    own: FloatArray
    others: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Parted:
    """A batch with its own unknowns integrated out, at given sizes.

    v: (k,), their sizes; white: (m k, n + 1), whitened rows by the others in their sizes, and whitened readings; back,
    root: (m, k, k), mean of the own unknowns, in their sizes, per whitened reading, and a root of their covariance
    given the others; log_root: half the logarithm of the determinant.
    """

    batch: _Batch
    v: FloatArray
    white: FloatArray
    back: FloatArray
    root: FloatArray
    log_root: float

    def own(self, white: FloatArray) -> FloatArray:
        """(m, k, q): what the own unknowns are, in their sizes, by whitened readings (m k, q)."""
        return np.asarray(self.back @ white.reshape(*self.back.shape[:2], -1))

    def through(self, spread: FloatArray) -> FloatArray:
        """(m, k, n): the own unknowns by the columns of a root of the covariance of the others."""
        return self.own(-self.white[:, :-1] @ spread)

    def variances(self, through: FloatArray) -> FloatArray:
        """(m, k): of the own unknowns."""
        return np.asarray((self.root**2).sum(axis=2) + (through**2).sum(axis=2))


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class _Point:
    """What readings say at some sizes: value, the logarithm of the marginal likelihood but for a constant; scale: (n,),
    the prior standard deviations, and slope (2, n) their derivative by the shape; mean, spread: (n,), (n, n), in units
    of scale; own: of every batch (m, k), means in units of their sizes.
    """

    value: float
    scale: FloatArray
    slope: FloatArray
    mean: FloatArray
    spread: FloatArray
    parted: tuple[_Parted, ...]
    own: tuple[FloatArray, ...]


def best_sizes(
    sizes: Sizes, reduced: Reduced, start: FloatArray, held: Sequence[int] = (), gain: float = NO_GAIN
) -> tuple[FloatArray, Posterior]:
    """The sizes of largest marginal likelihood, looked for from `start` on, and the posterior at them.

    held: sizes that stay at the start; gain: of a step, in the logarithm of the likelihood, for which it is taken.

    By steps of Newton's method, halved until the likelihood grows; the information is at first the expected one, and
    then learns from the steps (the formula of Broyden, Fletcher, Goldfarb and Shanno).
    """
    batches = _batches(reduced.blocks)
    x, at = start, _point(sizes, reduced, batches, start)
    slope = _slope(sizes, at) - x
    information = sizes.information(_posterior(at), at.slope)
    for _ in range(MOST_STEPS):
        free = (np.abs(x) < FARTHEST) | (slope * x < 0.0)
        free[list(held)] = False
        step = np.zeros(x.size)
        step[free] = np.linalg.solve(information[np.ix_(free, free)], slope[free])
        while float(slope @ step) > gain:
            there = np.clip(x + step, -FARTHEST, FARTHEST)
            after = _point(sizes, reduced, batches, there)
            if after.value - 0.5 * float(there @ there) > at.value - 0.5 * float(x @ x):
                break
            step *= 0.5
        else:
            break
        slope_there = _slope(sizes, after) - there
        information = _learnt(information, there - x, slope - slope_there)
        x, at, slope = there, after, slope_there
    return x, _posterior(at)


def _learnt(information: FloatArray, step: FloatArray, change: FloatArray) -> FloatArray:
    """That a step lowered the slope by `change`; it stays positive definite."""
    told, expected = float(step @ change), information @ step
    if told <= LEAST_CURVED * float(step @ expected):
        return information
    before = np.outer(expected, expected) / float(step @ expected)
    return np.asarray(information - before + np.outer(change, change) / told)


def _batches(blocks: Sequence[OwnBlock]) -> list[_Batch]:
    members: dict[tuple[str, ...], list[int]] = {}
    for place, block in enumerate(blocks):
        members.setdefault(block.kinds, []).append(place)
    return [
        _Batch(
            kinds,
            tuple(places),
            np.stack([blocks[p].own for p in places]),
            np.stack([np.column_stack([blocks[p].others, blocks[p].readings]) for p in places]),
        )
        for kinds, places in members.items()
    ]


def _parted(batch: _Batch, v: FloatArray, scale: FloatArray) -> _Parted:
    """By singular values: a product of the block with its transpose would lose the noise beside sizes 1e8 times it."""
    left, singular, turned = np.linalg.svd(batch.own * v)
    size = np.hypot(1.0, singular)
    white = (left.transpose(0, 2, 1) / size[:, :, np.newaxis]) @ batch.others
    white[:, :, :-1] *= scale
    root = turned.transpose(0, 2, 1) / size[:, np.newaxis, :]
    back = root * singular[:, np.newaxis, :]
    return _Parted(
        batch=batch,
        v=v,
        white=white.reshape(-1, scale.size + 1),
        back=back,
        root=root,
        log_root=float(np.log(size).sum()),
    )


def _point(sizes: Sizes, reduced: Reduced, batches: Sequence[_Batch], x: FloatArray) -> _Point:
    log, slope = sizes.scale(x)
    scale = np.exp(log)
    n = scale.size
    parted = tuple(_parted(batch, sizes.own_scale(batch.kinds, x), scale) for batch in batches)
    triangle = np.zeros((n + 1, n + 1), order="F")
    triangle[:n, :n] = reduced.triangle * scale
    triangle[:n, n] = reduced.readings
    triangle = with_rows(triangle, np.vstack([*(one.white for one in parted), np.zeros((0, n + 1))]))
    triangle = with_triangle(triangle, np.eye(n, n + 1))
    spread = inverse(triangle[:n, :n])
    mean = spread @ triangle[:n, n]
    spread *= np.sign(np.diag(spread))  # what is drawn by it depends on no library
    log_root = float(np.log(np.abs(np.diag(triangle)[:n])).sum()) + sum(one.log_root for one in parted)
    value = -log_root - 0.5 * (float(triangle[n, n] ** 2) + reduced.rest) - reduced.log_root
    return _Point(
        value=value,
        scale=scale,
        slope=slope,
        mean=mean,
        spread=spread,
        parted=parted,
        own=tuple(one.own(one.white[:, n] - one.white[:, :n] @ mean)[:, :, 0] for one in parted),
    )


def _slope(sizes: Sizes, at: _Point) -> FloatArray:
    """(n_sizes,): derivative of the logarithm of the marginal likelihood."""
    of_own: list[tuple[str, float]] = []
    for one, means in zip(at.parted, at.own, strict=True):
        expected = means**2 + one.variances(one.through(at.spread)) - 1.0
        of_own += zip(one.batch.kinds, expected.sum(axis=0).tolist(), strict=True)
    return sizes.gradient(at.mean**2 + (at.spread**2).sum(axis=1) - 1.0, of_own, at.slope)


def _posterior(at: _Point) -> Posterior:
    own: dict[int, OwnPosterior] = {}
    own_told: list[tuple[str, float]] = []
    told = float(at.mean.size - (at.spread**2).sum())
    for one, means in zip(at.parted, at.own, strict=True):
        through = one.through(at.spread)
        left = one.variances(through)
        own_told += zip(one.batch.kinds, ((1.0 - left) ** 2).sum(axis=0).tolist(), strict=True)
        told += float((1.0 - left).sum())
        for place, mean, by_others, alone in zip(one.batch.places, means, through, one.root, strict=True):
            own[place] = OwnPosterior(mean * one.v, by_others * one.v[:, np.newaxis], alone * one.v[:, np.newaxis])
    found = tuple(own[place] for place in sorted(own))
    return replace(_of_shared(at), own=found, own_told=tuple(own_told), told=told)


def _of_shared(at: _Point) -> Posterior:
    """Without the unknowns of single runs."""
    spread = at.spread * at.scale[:, np.newaxis]
    return Posterior(mean=at.mean * at.scale, spread=spread, scale=at.scale, own=(), own_told=(), told=0.0)


def posterior_at(sizes: Sizes, reduced: Reduced, x: FloatArray) -> Posterior:
    """The posterior at sizes found before."""
    return _posterior(_point(sizes, reduced, _batches(reduced.blocks), x))


def evidence_at(sizes: Sizes, reduced: Reduced, x: FloatArray) -> float:
    """Logarithm of the marginal likelihood and of the prior of the sizes, but for a constant: see `best_sizes`."""
    return _point(sizes, reduced, _batches(reduced.blocks), x).value - 0.5 * float(x @ x)


def likelier(sizes: Sizes, reduced: Reduced, x: FloatArray) -> dict[str, float]:
    """Of every class of the machine's errors whose size, x, is further than SAID from what was expected: the logarithm
    of how much likelier the readings make it than the size that was expected, all other sizes being free.
    """
    best = evidence_at(sizes, reduced, x)
    ratios = {}
    for place, name in enumerate(sizes.of_errors):
        limit = float(np.log(SAID) / sizes.spread[place]) if sizes.spread[place] > 0.0 else np.inf
        if abs(x[place]) > limit:
            start = x.copy()
            start[place] = 0.0
            there, _ = best_sizes(sizes, reduced, start, held=[place])
            ratios[name] = best - evidence_at(sizes, reduced, there)
    return ratios


def averaged(sizes: Sizes, reduced: Reduced, x: FloatArray) -> Posterior:
    """The posterior at the best sizes, x, with the covariance about its mean over all sizes that the readings leave
    possible: their uncertainty is in it.

    Every size has two values in it, NODE standard deviations up and down of what the readings tell of it beside those
    before it, in combinations of which each has its opposite. The root of the covariance is that of its two parts.
    """
    batches = _batches(reduced.blocks)
    best = _posterior(_point(sizes, reduced, batches, x))
    root = np.linalg.cholesky(sizes.information(best, sizes.scale(x)[1]))
    steps = solve_triangular(root, NODE * _combinations(sizes).T, lower=True, trans="T").T
    points = [
        _point(sizes, reduced, batches, np.clip(x + sign * step, -FARTHEST, FARTHEST))
        for step in steps
        for sign in (1, -1)
    ]
    each = [_of_shared(one) for one in points]
    spread, of_prior = parted_root(each, best.mean, sizes.layout.of_machine)
    scale = np.sqrt(np.mean([one.scale**2 for one in each], axis=0))
    return replace(best, spread=spread, scale=scale, of_prior=of_prior)


def _combinations(sizes: Sizes) -> FloatArray:
    """(PAIRS, n_sizes): 1 and -1, up and down.

    Columns of a Hadamard matrix: the classes of the machine's errors and the shape of curves have one each, so that
    they are up and down together with every other size as often as not; the other sizes share those that are left.
    """
    count, classes = sizes.spread.size, len(sizes.of_errors)
    columns = np.empty(count, dtype=np.int64)
    columns[:classes], columns[-len(SHAPE) :] = np.arange(classes), classes + np.arange(len(SHAPE))
    own = classes + len(SHAPE)
    columns[classes : count - len(SHAPE)] = own + np.arange(count - own) % (PAIRS - own)
    return np.asarray(hadamard(PAIRS)[:, columns], dtype=np.float64)
