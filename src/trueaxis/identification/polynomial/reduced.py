"""All candidate models of one data set from a single QR factorisation.

With A = QR for the powers 1..order, the residual sum of squares of any subset S of the terms is that of the
small system R[:, S] b = Q'y plus the part of y that no term reaches. Stepwise regression asks for dozens of
subsets; each costs one QR of at most order x (order + 1) numbers instead of a fit to all points.
"""

from dataclasses import dataclass
from math import log

import numpy as np

from trueaxis.identification.polynomial.powers import rounding_floor, weighted_system
from trueaxis.identification.polynomial.samples import FloatArray, Samples

RANK_TOLERANCE = 1e-7
"""Relative size of a power's part outside the lower powers, below which it is one of them (R's lm)."""


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ReducedSystem:
    """Sums of squares of every subset of the powers 1..order.

    order: highest power the points determine; n_points; triangle: R, (order, order); projection: Q'y,
    (order,); outside: sum of squares of y outside all terms; floor: sums of squares below this are rounding; known:
    whether the covariance of the values is known, so that the squares are in units of it.
    """

    order: int
    n_points: int
    triangle: FloatArray
    projection: FloatArray
    outside: float
    floor: float
    known: bool = False

    def rss(self, powers: tuple[int, ...]) -> float:
        """(Weighted) residual sum of squares of the model with these powers, never below the rounding floor."""
        columns = self.triangle[:, [power - 1 for power in powers]]
        within = 0.0
        if len(powers) < self.order:
            triangle = _triangle(np.column_stack([columns, self.projection]))
            within = float(triangle[len(powers), -1]) ** 2
        return max(self.outside + within, self.floor)

    def mean_square(self, powers: tuple[int, ...]) -> float:
        """Residual mean square RSS / (n - terms)."""
        return self.rss(powers) / (self.n_points - len(powers))

    def aic(self, powers: tuple[int, ...]) -> float:
        """Akaike's criterion as R's extractAIC.lm gives it: n log(RSS / n) + 2 terms."""
        return aic(self.rss(powers), self.n_points, len(powers), known=self.known)


def aic(rss: float, n_points: int, n_terms: int, *, known: bool = False) -> float:
    """Akaike's criterion n log(RSS / n) + 2 terms; -inf for a residual of zero. With a known variance RSS + 2 terms."""
    if known:
        return rss + 2.0 * n_terms
    return n_points * log(rss / n_points) + 2.0 * n_terms if rss > 0 else -float("inf")


def _triangle(matrix: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.qr(matrix, mode="r"), dtype=np.float64)


def reduced_system(samples: Samples, max_order: int) -> ReducedSystem:
    """Reduce the samples to the powers 1..order, order <= max_order being as high as the points determine.

    At least one degree of freedom is left for the residuals, and a power that the points cannot tell from the
    lower ones (too few distinct positions, or a short stretch far from 0) ends the list.
    """
    order = min(max_order, samples.positions.size - 1)
    design, right, _ = weighted_system(samples, tuple(range(1, order + 1)))
    triangle = _triangle(design)
    told_apart = np.abs(np.diag(triangle)) > RANK_TOLERANCE * np.linalg.norm(design, axis=0)
    if samples.whitening is not None:  # it has an inverse: the points alone tell powers apart
        told_apart = np.ones(order, dtype=bool)
    order = order if told_apart.all() else int(np.argmin(told_apart))
    basis, triangle = np.linalg.qr(design[:, :order])
    projection = basis.T @ right
    rest = right - basis @ projection
    rest -= basis @ (basis.T @ rest)
    return ReducedSystem(
        order=order,
        n_points=right.size,
        triangle=triangle,
        projection=projection,
        outside=float(rest @ rest),
        floor=rounding_floor(right),
        known=samples.whitening is not None,
    )
