"""Sizes of what is unknown of instruments that readings make far smaller than expected.

Such a size may come from a few values, and all that instruments and errors of the machine share then counts as the
machine's. So the posterior by the expected size is said beside the estimate.
"""

from dataclasses import dataclass

from trueaxis.estimation.evidence import SAID, posterior_at
from trueaxis.estimation.instruments import CLASSES
from trueaxis.estimation.posterior import parted_root
from trueaxis.estimation.reduce import Reduced
from trueaxis.estimation.sizes import Sizes
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class AsExpected:
    """What readings would say by the expected sizes of classes of instrument unknowns that come out less than 1 / SAID
    of them. classes: their names; spread: (n, r), a root of the covariance of the unknowns, all other sizes being as
    estimated; its last `of_prior` columns are the prior's part.
    """

    classes: tuple[str, ...]
    spread: FloatArray
    of_prior: int


def as_expected(sizes: Sizes, reduced: Reduced, x: FloatArray) -> AsExpected | None:
    """See `AsExpected`, at the sizes x; in scaled unknowns. None where no class is so small."""
    factors = sizes.factors(x)
    small = [name for name in sizes.names if name in CLASSES and factors[name] < 1.0 / SAID]
    if not small:
        return None
    there = x.copy()
    there[[sizes.names.index(name) for name in small]] = 0.0
    found = posterior_at(sizes, reduced, there)
    return AsExpected(tuple(small), *parted_root([found], found.mean, sizes.layout.of_machine))
