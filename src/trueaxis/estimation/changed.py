"""How much likelier readings become where those of some runs are changed, by the noise and sizes of a fit."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from trueaxis.estimation.fitted import Fitted
from trueaxis.estimation.own_part import by_shared, own_part_of
from trueaxis.estimation.posterior import Posterior
from trueaxis.measurement.machine import FloatArray


@dataclass(frozen=True, slots=True, eq=False, kw_only=True)
class ChangesOfRun:
    """What changes of a run's readings do. With y the whitened readings of all runs, p what is expected of them, P the
    inverse of the covariance of y - p and c a change of the run: linear: (m,), c' P (y - p); square: (m,), the run's
    own part of c' P c; shared: (n_unknowns, m), whose square is what the unknowns that runs share take from it; left:
    square of P (y - p) in this run; size: how many readings.
    """

    linear: FloatArray
    square: FloatArray
    shared: FloatArray
    left: float
    size: int


def changes_of_run(fitted: Fitted, posterior: Posterior, place: int, changes: Sequence[FloatArray]) -> ChangesOfRun:
    """place: of the run; changes: of its readings, (n,) each, mm; posterior: of what is fitted.

    P is what is left of 1 when the run's own unknowns and those that runs share are taken out, and P (y - p) is the
    residual of the estimate of all runs.
    """
    state = fitted.state
    one = state.runs[place]
    columns = np.column_stack([state.residual[place], *changes])[one.good]
    white = state.whitening(place, one.kept())(columns)
    left, change = white[:, 0], white[:, 1:]
    rest = own_part_of(state, fitted.sizes, fitted.x, place).rest(change)
    return ChangesOfRun(
        linear=left @ change,
        square=np.sum(change * rest, axis=0),
        shared=posterior.spread.T @ by_shared(state, place, rest),
        left=float(left @ left),
        size=left.size,
    )


def log_ratio(each: Sequence[tuple[ChangesOfRun, int]]) -> float:
    """Logarithm of how much likelier readings are with a change of several runs: of each the column that it is.

    Of density: that of a factor, by which readings were multiplied, is not in it. It is -(2 c' P (y - p) + c' P c) / 2.
    Sizes that were estimated with a fault may be far too small for readings without it: what is worse by them counts as
    by a normal distribution of unknown width, about the usual square of so many readings.
    """
    linear = sum(float(one.linear[column]) for one, column in each)
    shared = np.sum([one.shared[:, column] for one, column in each], axis=0)
    worse = 2.0 * linear + sum(float(one.square[column]) for one, column in each) - float(shared @ shared)
    if worse < 0.0:
        return -0.5 * worse
    size = sum(one.size for one, _ in each)
    usual = max(sum(one.left for one, _ in each), size)
    return -0.5 * size * float(np.log1p(worse / usual))
