"""Up to which order the curves go: as high as readings tell.

A basis that ends at an order which readings tell cannot follow what is beyond, though they tell that as well. The curve
is then bent by it, mostly beyond the targets, and u says nothing of it: it is by a prior in which nothing is beyond.
"""

from trueaxis.error_name import ErrorName
from trueaxis.estimation.layout import Layout
from trueaxis.estimation.posterior import Posterior
from trueaxis.measurement.machine import FloatArray

TOLD = 0.5  # share of the prior variance of an order that readings take away, from where on they tell it
LAST = 2  # orders: targets that lie evenly about the middle may tell the even ones alone
# Of curves whose last orders are told: seven waves over the travel. Of all 18 curves of three axes twice as many orders
# take some ten times as long, minutes, and what is rougher is said in the report.
HIGHEST_DEGREE = 28


def higher_degrees(layout: Layout, posterior: Posterior) -> dict[ErrorName, int]:
    """Of curves whose last orders are told, and may be followed by more. posterior: of the layout."""
    ended = told_to_their_end(layout, posterior.spread, posterior.scale)
    return {
        name: HIGHEST_DEGREE for name in ended if layout.bases[layout.components.index(name)].degree < HIGHEST_DEGREE
    }


def told_to_their_end(layout: Layout, spread: FloatArray, scale: FloatArray) -> tuple[ErrorName, ...]:
    """Curves whose last orders are told: what is beyond them is as well. spread: (n, r), a root of the covariance of
    the unknowns; scale: (n,), their prior standard deviations.
    """
    share = (spread**2).sum(axis=1) / scale**2
    each = zip(layout.components, layout.bases, layout.offsets[:-1].tolist(), strict=True)
    ends = ((name, basis.degree, first + basis.degree) for name, basis, first in each)
    return tuple(name for name, degree, end in ends if float(share[end - min(LAST, degree) : end].min()) < 1.0 - TOLD)
