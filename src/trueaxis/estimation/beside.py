"""Readings beside a rough estimate of everything but one effect: where its start is searched."""

from collections.abc import Iterator

import numpy as np

from trueaxis.estimation.effects.search import Others, WhitenedRun
from trueaxis.estimation.jacobian import pieces
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State
from trueaxis.measure.machine import FloatArray


def beside(state: State, sizes: Sizes, x: FloatArray, posterior: Posterior) -> Others:
    """Every run, one after another; x: the sizes of the posterior.

    With V the covariance of the readings by noise and everything that is estimated, products with V^-1 are those of
    whitened columns less what the run's own unknowns take and what the shared ones take; V^-1 times the readings is
    the whitened residual.
    """

    def runs() -> Iterator[WhitenedRun]:
        for place, (one, kinds) in enumerate(zip(state.runs, state.own_kinds, strict=True)):
            rows = one.kept()

            def whiten(columns: FloatArray, place: int = place) -> FloatArray:
                return state.whitening(place, state.runs[place].kept())(columns)

            columns = np.vstack([np.hstack([own, others]) for _, own, others in pieces(state.layout, rows)])
            columns = whiten(columns)
            k = len(kinds)
            left, singular, _ = np.linalg.svd(columns[:, :k] * sizes.own_scale(kinds, x), full_matrices=False)
            own = left * (singular / np.hypot(1.0, singular))
            others = columns[:, k:] - own @ (own.T @ columns[:, k:])
            yield WhitenedRun(
                index=one.rows.index,
                rows=rows.at,
                whiten=whiten,
                own=own,
                others=others @ posterior.spread,
                residual=whiten(state.residual[place][one.good][:, np.newaxis])[:, 0],
            )

    return runs
