"""A run's own unknowns parted off: what its whitened readings say of everything else.

With V = 1 + own own' the covariance of a run's whitened readings by their noise and the run's own unknowns, in units of
their sizes, everything that is asked of a run beside them is a product with V^-1 or its root. Memory is that of a few
columns of the run; the derivative by the unknowns that runs share is made and used piece by piece.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.effects.search import Others, WhitenedRun
from trueaxis.estimation.factors import decomposed
from trueaxis.estimation.instruments import own_columns
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class OwnPart:
    """left: (n, k), orthonormal columns of the own unknowns; kept: (k,), what V^-1/2 leaves of each."""

    left: FloatArray
    kept: FloatArray

    def rest(self, rows: FloatArray) -> FloatArray:
        """V^-1 times whitened rows (n,) or (n, m)."""
        return self._less(rows, 1.0 - self.kept**2)

    def root(self, rows: FloatArray) -> FloatArray:
        """V^-1/2 times whitened rows (n,) or (n, m)."""
        return self._less(rows, 1.0 - self.kept)

    def _less(self, rows: FloatArray, share: FloatArray) -> FloatArray:
        return np.asarray(rows - self.left @ (share * (self.left.T @ rows).T).T)


def own_part(own: FloatArray) -> OwnPart:
    """own: (n, k), whitened columns of the own unknowns in units of their sizes, which may be 1e8 times the noise."""
    left, singular, _ = decomposed(own)
    return OwnPart(left, 1.0 / np.hypot(1.0, singular))


def own_part_of(state: State, sizes: Sizes, x: FloatArray, place: int) -> OwnPart:
    """Of the readings that count of the run at a place; x: the sizes."""
    rows = state.runs[place].kept()
    straight = state.layout.straightness[rows.index]
    own = own_columns(state.layout.model, rows.run, straight, rows.positions, rows.passed)
    return own_part(state.whitening(place, rows)(own * sizes.own_scale(state.own_kinds[place], x)))


def by_shared(state: State, place: int, columns: FloatArray) -> FloatArray:
    """(n_unknowns, q): whitened derivative of a run by the scaled unknowns, transposed, times columns (n, q)."""
    whiten = state.whitening(place, state.runs[place].kept())
    found, start = np.zeros((state.layout.count, columns.shape[1])), 0
    for one in state.derivatives_kept(place):
        part = slice(start, start + one.place.size)
        found += whiten(one.by_others).T @ columns[part]
        start = part.stop
    return found


def beside(state: State, sizes: Sizes, x: FloatArray, posterior: Posterior) -> Others:
    """Every run, one after another; x: the sizes of the posterior.

    With V the covariance of the readings by noise and everything that is estimated, products with V^-1 are those of
    whitened columns less what the run's own unknowns take and what the shared ones take; V^-1 times the readings is
    the whitened residual.
    """

    def runs() -> Iterator[WhitenedRun]:
        for place, one in enumerate(state.runs):
            part = own_part_of(state, sizes, x, place)

            def whiten(columns: FloatArray, place: int = place) -> FloatArray:
                return state.whitening(place, state.runs[place].kept())(columns)

            def shared(columns: FloatArray, place: int = place) -> FloatArray:
                return np.asarray(posterior.spread.T @ by_shared(state, place, columns))

            yield WhitenedRun(
                index=one.rows.index,
                rows=one.kept().at,
                whiten=whiten,
                rest=part.rest,
                shared=shared,
                residual=whiten(state.residual[place][one.good][:, np.newaxis])[:, 0],
            )

    return runs
