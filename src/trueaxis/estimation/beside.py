"""Readings beside a rough estimate of everything but one effect: where its start is searched."""

from collections.abc import Iterator

import numpy as np

from trueaxis.estimation.effects.search import Others, WhitenedRun
from trueaxis.estimation.own_part import by_shared, own_part_of
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State
from trueaxis.measurement.machine import FloatArray


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
