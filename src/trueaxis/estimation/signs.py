"""Runs that read as if their sign were reversed: what the other runs expect of them, against what they read."""

import numpy as np

from trueaxis.estimation.jacobian import pieces
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State
from trueaxis.measure.machine import FloatArray

# Logarithm of the ratio of likelihoods from which on a run is said to be reversed: were one run of a thousand reversed,
# one statement of a thousand would be wrong.
REVERSED = 2.0 * np.log(1e3)


def reversed_runs(state: State, sizes: Sizes, x: FloatArray, posterior: Posterior) -> dict[int, float]:
    """Index of each run with a direction that is likelier reversed, and the logarithm of the ratio of likelihoods.

    With p what the others expect of the whitened readings y of a run, and S the covariance of y - p, the ratio for -y
    and y is exp(-2 y' S^-1 p). S^-1 is what is left of 1 when the run's own unknowns and those that runs share are
    taken out, and S^-1 (y - p) is the residual of the estimate of all runs. posterior: at the sizes x, of the state.
    """
    found = {}
    for place, (one, kinds) in enumerate(zip(state.runs, state.own_kinds, strict=True)):
        if one.rows.run.direction is None:
            continue
        rest = state.residual[place][one.good]
        k = len(kinds)
        whiten = state.whitening(place, one.kept())
        columns, through = [], np.zeros((state.layout.count, k + 1))
        for part, own, others in pieces(state.layout, one.kept()):
            readings = rest[part] + others @ (state.unknowns / state.layout.sizes) + own @ state.own[place]
            scaled = own * sizes.own_scale(kinds, x)
            white = whiten(np.column_stack([scaled, readings, rest[part], others]))
            columns.append(white[:, : k + 2])
            through += white[:, k + 2 :].T @ white[:, : k + 1]
        whitened = np.vstack(columns)
        own, y, residual = whitened[:, :k], whitened[:, k], whitened[:, k + 1]
        # (1 + own' own)^-1 is the covariance of the run's own unknowns in units of their sizes
        own_part = np.linalg.solve(np.eye(k) + own.T @ own, own.T @ y)
        shared = posterior.spread.T @ (through[:, k] - through[:, :k] @ own_part)
        precise = float(y @ y) - float((own.T @ y) @ own_part) - float(shared @ shared)
        log_ratio = -2.0 * (precise - float(y @ residual))
        if log_ratio > REVERSED:
            found[one.rows.index] = log_ratio
    return found
