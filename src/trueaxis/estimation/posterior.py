"""What readings say of the unknowns, once the sizes of errors and noise are given: a normal distribution.

Its covariance has two parts: the noise of the readings, and the prior of the machine. The error of the posterior mean
is K e - (1 - K J) a, with K its gain, J the derivative, e the noise and a what the machine differs by from its prior
mean. With Sigma the covariance and A that of the prior, 1 - K J is Sigma A^-1, so that the prior's part is
Sigma A^-1 Sigma. A is of the errors of the machine alone: unknowns of the instruments are part of what a reading is,
they count with the readings.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import solve_triangular

from trueaxis.estimation.factors import triangle_of
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class OwnPosterior:
    """A run's own unknowns, mm or rad: mean (k,); by_others (k, n) and alone (k, k) together a root of the covariance,
    the first in the columns of `Posterior.spread`.
    """

    mean: FloatArray
    by_others: FloatArray
    alone: FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class Posterior:
    """What the readings say of the scaled unknowns at some sizes.

    mean: (n,); spread: (n, r), a root of the covariance, whose last `of_prior` columns are the prior's part of it, the
    others that of the readings (0: not parted); scale: (n,), prior standard deviations; own: of each block;
    own_told: by class the sum of (1 - variance / prior variance)^2 of the unknowns of single runs; told: how many
    unknowns the readings tell, the sum of 1 - variance / prior variance.
    """

    mean: FloatArray
    spread: FloatArray
    scale: FloatArray
    own: tuple[OwnPosterior, ...]
    own_told: tuple[tuple[str, float], ...]
    told: float
    of_prior: int = 0


def prior_root(posterior: Posterior, of_machine: int) -> FloatArray:
    """(n, of_machine): a root of the prior's part; the machine's unknowns are the first ones."""
    known = posterior.spread[:of_machine] / posterior.scale[:of_machine, np.newaxis]
    return np.asarray(posterior.spread @ known.T)


def parted_root(each: Sequence[Posterior], mean: FloatArray, of_machine: int) -> tuple[FloatArray, int]:
    """(n, 2 n): a root of the covariance of a mixture of equal shares; how many of its last columns are the prior's.

    The means of the members differ from that of all, mean (n,), because their sizes do: this counts with the prior.
    """
    share = 1.0 / np.sqrt(len(each))
    between = [share * (one.mean - mean)[:, np.newaxis] for one in each]
    whole = triangle_of([np.hstack([*(share * one.spread for one in each), *between]).T]).T
    prior = triangle_of([np.hstack([*(share * prior_root(one, of_machine) for one in each), *between]).T]).T
    relative = solve_triangular(whole, prior, lower=True)
    # what is left: whole (1 - relative relative') whole'
    squares, directions = np.linalg.eigh(relative @ relative.T)
    readings = whole @ (directions * np.sqrt(np.clip(1.0 - squares, 0.0, 1.0)))
    return np.hstack([readings, prior]), prior.shape[1]
