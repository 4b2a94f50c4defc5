"""The least-squares solution with its null space, and the gauge that the convention sets in it."""

from dataclasses import dataclass

import numpy as np

from trueaxis.identify.global_fit.layout import Layout
from trueaxis.identify.null_space import reduced
from trueaxis.identify.straightness import is_straightness, slope_weights
from trueaxis.measure.machine import FloatArray

RANK_TOLERANCE = 1e-6  # singular values below it, relative to the largest, count as zero: rounded positions make some
GAUGE_TOLERANCE = 1e-9
ROUNDING = 1e-7  # of a null vector: what lies within the rank tolerance is not exact


@dataclass(frozen=True, slots=True, eq=False)
class Factors:
    """Singular values of the design matrix in scaled unknowns.

    vectors: (n, rank), right singular vectors of the singular values (rank,); null: (n, n - rank).
    """

    singular: FloatArray
    vectors: FloatArray
    null: FloatArray

    @property
    def rank(self) -> int:
        """How many combinations the readings determine."""
        return self.singular.size

    @property
    def condition(self) -> float:
        """Largest over smallest singular value kept."""
        return float(self.singular[0] / self.singular[-1]) if self.rank else 1.0

    def step(self, transposed: FloatArray) -> FloatArray:
        """Least-squares solution of least norm from (design transposed) @ residuals."""
        return self.vectors @ ((self.vectors.T @ transposed) / self.singular**2)

    def covariance(self) -> FloatArray:
        """(n, n), for readings of variance 1."""
        root = self.vectors / self.singular
        return root @ root.T


@dataclass(frozen=True, slots=True, eq=False)
class Gauge:
    """Moves within the null space: from the solution of least norm to the one of the conventions.

    First location errors level the least-squares lines of the straightness. Then, with these level, the unknowns of the
    instruments become as small as the readings allow: what cannot be told from a perfect instrument is taken for one.

    projector: (n, n); settled: (n, g), basis vectors led by a location error each, whose share the first convention
    settles; null: (n, d), what stays open, where the second has only chosen.
    """

    projector: FloatArray
    settled: FloatArray
    null: FloatArray


def factors(triangle: FloatArray, tolerance: float = RANK_TOLERANCE) -> Factors:
    """From the triangular factor of the design matrix."""
    _, singular, right = np.linalg.svd(triangle)
    rank = int(np.count_nonzero(singular > tolerance * singular.max(initial=0.0)))
    return Factors(singular[:rank], right[:rank].T, right[rank:].T)


def gauge(layout: Layout, null: FloatArray, level: bool) -> Gauge:
    """The gauge of a null space; level: whether straightness is levelled. Nothing is moved along other vectors."""
    n, instruments, locations = layout.count, layout.of_instruments, layout.of_locations
    basis, led = reduced(null, range(locations.start, locations.stop), ROUNDING)
    others, of_instruments = reduced(basis[:, led:], range(instruments.start, n), ROUNDING)
    projector, settled, rest = np.eye(n), np.zeros((n, 0)), basis[:, :led]
    if level and led:
        slopes = straightness_slopes(layout)
        moved = slopes @ basis[:, :led]
        size = np.abs(slopes).max(initial=0.0)
        tilts = np.abs(moved).max(axis=0, initial=0.0) > GAUGE_TOLERANCE * size
        settled, rest = basis[:, :led][:, tilts], basis[:, :led][:, ~tilts]
        projector -= settled @ (np.linalg.pinv(moved[:, tilts], rcond=GAUGE_TOLERANCE) @ slopes)
    chosen = projector @ others[:, :of_instruments]
    rest = projector @ np.hstack([rest, others[:, of_instruments:]])
    if of_instruments:
        smallest = np.eye(n)
        smallest[:, instruments] -= chosen @ np.linalg.pinv(chosen[instruments], rcond=GAUGE_TOLERANCE)
        projector, rest = smallest @ projector, smallest @ rest
    return Gauge(projector, settled, np.hstack([chosen, rest]))


def straightness_slopes(layout: Layout) -> FloatArray:
    """(straightness components, n_unknowns): slopes of least-squares lines over the positions of the readings."""
    rows = []
    for place, component in enumerate(layout.components):
        if is_straightness(layout.machine.components[component]):
            row = np.zeros(layout.count)
            mine = layout.of_component(place)
            knots = layout.knots[layout.axis[place]]
            row[mine] = layout.basis_of(place)(knots) @ slope_weights(knots) * layout.scale[mine]
            rows.append(row)
    return np.array(rows).reshape(len(rows), layout.count)
