"""What readings say of the unknowns, once the sizes of errors and noise are given: a normal distribution."""

from dataclasses import dataclass

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
