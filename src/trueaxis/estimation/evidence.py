"""The marginal likelihood of readings by the sizes, its best point, and the posterior there and about it.

The marginal likelihood of the readings, all unknowns integrated out, is maximised with the priors of the sizes. Its
derivative is exact (Fisher's identity): with u an unknown in units of its size, d log p / d log size is the sum of
E[u^2 | readings] - 1. The unknowns of single runs stay in blocks of their own, so that the cost of a point depends on
the number of runs and unknowns alone, not on that of the readings.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_triangular
from scipy.optimize import minimize

from trueaxis.estimation.parts import parted_root
from trueaxis.estimation.posterior import OwnPosterior, Posterior
from trueaxis.estimation.reduce import OwnBlock, Reduced, triangle_of
from trueaxis.estimation.sizes import Sizes
from trueaxis.measure.machine import FloatArray

MOST_STEPS = 60
REMEMBERED = 30  # steps: about as many as there are sizes
GRADIENT = 1e-2  # of the logarithm of the likelihood per standard deviation of a size: far below what a size matters
NO_GAIN = 3e-4  # of a step, in the logarithm of the likelihood: likelihoods as near as that say the same
FARTHEST = 3.0  # standard deviations of a size from what was expected: beyond, the data are not of such a machine
PAIRS, SEED = 8, 21  # of sizes over which the posterior is averaged


@dataclass(frozen=True, slots=True, eq=False)
class _Batch:
    """Blocks of the same kinds: own (m, k, k), others (m, k, n), readings (m, k)."""

    kinds: tuple[str, ...]
    places: tuple[int, ...]
    own: FloatArray
    others: FloatArray
    readings: FloatArray


def best_sizes(sizes: Sizes, reduced: Reduced, start: FloatArray) -> tuple[FloatArray, Posterior]:
    """The sizes of largest marginal likelihood, looked for from `start` on, and the posterior at them."""
    batches = _batches(reduced.blocks)
    value, _, posterior = _evidence(sizes, reduced, batches, start)
    # in units of what the readings and the prior leave open of each size: it halves the number of points
    unit = 1.0 / np.sqrt(np.diag(sizes.information(posterior, sizes.scale(start)[1])))

    def cost(scaled: FloatArray) -> tuple[float, FloatArray]:
        x = scaled * unit
        value, slope, _ = _evidence(sizes, reduced, batches, x)
        return 0.5 * float(x @ x) - value, (x - slope) * unit

    found = minimize(
        cost,
        start / unit,
        jac=True,
        method="L-BFGS-B",
        bounds=[(-farthest, farthest) for farthest in (FARTHEST / unit).tolist()],
        options={"maxiter": MOST_STEPS, "maxcor": REMEMBERED, "gtol": GRADIENT, "ftol": NO_GAIN / (1.0 + abs(value))},
    )
    best = np.asarray(found.x) * unit
    return best, _evidence(sizes, reduced, batches, best)[2]


def _batches(blocks: Sequence[OwnBlock]) -> list[_Batch]:
    members: dict[tuple[str, ...], list[int]] = {}
    for place, block in enumerate(blocks):
        members.setdefault(block.kinds, []).append(place)
    return [
        _Batch(
            kinds,
            tuple(places),
            np.stack([blocks[p].own for p in places]),
            np.stack([blocks[p].others for p in places]),
            np.stack([blocks[p].readings for p in places]),
        )
        for kinds, places in members.items()
    ]


@dataclass(frozen=True, slots=True, eq=False)
class _Parted:
    """A batch with its own unknowns integrated out, at given sizes.

    v: (k,), their sizes; others: (m, k, n) by unknowns in their sizes; white: (m, k, k), whitens what is left; gain,
    root: (m, k, k), mean of the own unknowns, in their sizes, per reading, and a root of their covariance given the
    others; log_root: half the logarithm of the determinant.
    """

    batch: _Batch
    v: FloatArray
    others: FloatArray
    white: FloatArray
    gain: FloatArray
    root: FloatArray
    log_root: float

    def rows(self) -> FloatArray:
        """(m k, n + 1): whitened rows by the others, and whitened readings."""
        both = np.concatenate([self.others, self.batch.readings[:, :, np.newaxis]], axis=2)
        return np.asarray(self.white @ both).reshape(-1, both.shape[2])


def _parted(batch: _Batch, v: FloatArray, scale: FloatArray) -> _Parted:
    """By singular values: a product of the block with its transpose would lose the noise beside sizes 1e8 times it."""
    left, singular, turned = np.linalg.svd(batch.own * v)
    size = np.hypot(1.0, singular)
    white = left.transpose(0, 2, 1) / size[:, :, np.newaxis]
    back = turned.transpose(0, 2, 1)
    gain = back @ (white * (singular / size)[:, :, np.newaxis])
    return _Parted(
        batch, v, batch.others * scale, white, gain, back / size[:, np.newaxis, :], float(np.log(size).sum())
    )


def _evidence(
    sizes: Sizes, reduced: Reduced, batches: Sequence[_Batch], x: FloatArray
) -> tuple[float, FloatArray, Posterior]:
    """Logarithm of the marginal likelihood but for a constant, its derivative, and the posterior."""
    log, slope = sizes.scale(x)
    scale = np.exp(log)
    n = scale.size
    parted = [_parted(batch, sizes.own_scale(batch.kinds, x), scale) for batch in batches]
    shared = np.column_stack([reduced.triangle * scale, reduced.readings])
    triangle = triangle_of([shared, *(one.rows() for one in parted), np.eye(n, n + 1)])
    spread = solve_triangular(triangle[:n, :n], np.eye(n))
    mean = spread @ triangle[:n, n]
    log_root = float(np.log(np.abs(np.diag(triangle)[:n])).sum()) + sum(one.log_root for one in parted)
    value = -log_root - 0.5 * (float(triangle[n, n] ** 2) + reduced.rest) - reduced.log_root
    variance = (spread**2).sum(axis=1)
    of_own: list[tuple[str, float]] = []
    own_told: list[tuple[str, float]] = []
    told = float(n - variance.sum())
    own: list[OwnPosterior] = [OwnPosterior(np.zeros(0), np.zeros((0, n)), np.zeros((0, 0)))] * len(reduced.blocks)
    for one in parted:
        kinds = one.batch.kinds
        means = (one.gain @ (one.batch.readings - one.others @ mean)[:, :, np.newaxis])[:, :, 0]
        through = -(one.gain @ one.others) @ spread
        left = (one.root**2).sum(axis=2) + (through**2).sum(axis=2)
        of_own += zip(kinds, (means**2 + left - 1.0).sum(axis=0).tolist(), strict=True)
        own_told += zip(kinds, ((1.0 - left) ** 2).sum(axis=0).tolist(), strict=True)
        told += float((1.0 - left).sum())
        for place, found, by_others, alone in zip(one.batch.places, means, through, one.root, strict=True):
            own[place] = OwnPosterior(found * one.v, by_others * one.v[:, np.newaxis], alone * one.v[:, np.newaxis])
    posterior = Posterior(
        mean=mean * scale,
        spread=spread * scale[:, np.newaxis],
        scale=scale,
        own=tuple(own),
        own_told=tuple(own_told),
        told=told,
    )
    return value, sizes.gradient(mean**2 + variance - 1.0, of_own, slope), posterior


def posterior_at(sizes: Sizes, reduced: Reduced, x: FloatArray) -> Posterior:
    """The posterior at sizes found before."""
    return _evidence(sizes, reduced, _batches(reduced.blocks), x)[2]


def evidence_at(sizes: Sizes, reduced: Reduced, x: FloatArray) -> float:
    """Logarithm of the marginal likelihood and of the prior of the sizes, but for a constant: see `best_sizes`."""
    return _evidence(sizes, reduced, _batches(reduced.blocks), x)[0] - 0.5 * float(x @ x)


def averaged(sizes: Sizes, reduced: Reduced, x: FloatArray) -> Posterior:
    """The posterior averaged over the sizes that the readings leave possible: their uncertainty is in it.

    Sizes are drawn about the best ones, x, in pairs that lie opposite each other, by what the readings tell of them.
    The root of its covariance is that of its two parts.
    """
    batches = _batches(reduced.blocks)
    best = _evidence(sizes, reduced, batches, x)[2]
    root = np.linalg.cholesky(sizes.information(best, sizes.scale(x)[1]))
    draws = np.random.default_rng(SEED).standard_normal((PAIRS, x.size))
    steps = solve_triangular(root, draws.T, lower=True, trans="T").T
    each = [
        _evidence(sizes, reduced, batches, np.clip(x + sign * step, -FARTHEST, FARTHEST))[2]
        for step in steps
        for sign in (1, -1)
    ]
    mean = np.mean([one.mean for one in each], axis=0)
    spread, of_prior = parted_root(each, mean, sizes.layout.of_machine)
    own = tuple(
        OwnPosterior(np.mean([one.own[place].mean for one in each], axis=0), of.by_others, of.alone)
        for place, of in enumerate(best.own)
    )
    scale = np.sqrt(np.mean([one.scale**2 for one in each], axis=0))
    return Posterior(
        mean=mean,
        spread=spread,
        scale=scale,
        own=own,
        own_told=best.own_told,
        told=best.told,
        of_prior=of_prior,
    )
