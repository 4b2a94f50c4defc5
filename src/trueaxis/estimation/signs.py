"""Runs that read as if their sign were reversed: what the other runs expect of them, against what they read.

Where the noise is estimated, that estimate has taken a reversed run for noise: by it the run is hardly likelier
reversed. So every run that is likelier reversed at all is turned, noise and sizes are estimated anew, and the marginal
likelihoods of both are compared: the data are the same but for a sign.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from trueaxis.estimation.evidence import evidence_at, posterior_at
from trueaxis.estimation.own_part import by_shared, own_part_of
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.runs import MeasuredRun
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import State, linearised
from trueaxis.measurement.columns import BoolArray
from trueaxis.measurement.machine import FloatArray

# Logarithm of the ratio of likelihoods from which on a run is said to be reversed: were one run of a thousand reversed,
# one statement of a thousand would be wrong.
REVERSED = 2.0 * np.log(1e3)
# Likeliest runs that are turned on trial, each at the cost of an estimate. Of 20 worlds as they should be no run was
# likelier reversed at all, of 20 with one reversed that one alone; where the model is badly wrong all runs may be.
MOST_TRIALS = 4

Refit = Callable[[Sequence[MeasuredRun]], tuple[FloatArray, State]]  # sizes and state, of runs from the beginning


def reversed_runs(state: State, sizes: Sizes, x: FloatArray, posterior: Posterior, refit: Refit) -> dict[int, float]:
    """Index of each run with a direction that is likelier reversed, and the logarithm of the ratio of likelihoods.

    One after the other: the next beside those that were turned before. Where several runs are as likely as each other
    to be the one that is reversed, each is there. posterior: at the sizes x, of the state.
    """
    found: dict[int, float] = {}
    turned: set[int] = set()
    while True:
        odds = {place: odd for place, odd in log_ratios(state, sizes, x, posterior).items() if place not in turned}
        likeliest = sorted((place for place in odds if odds[place] > 0.0), key=lambda place: -odds[place])
        sure: dict[int, float] = {}
        following = (x, state)
        for place in likeliest[:MOST_TRIALS]:
            trial = refit(_turned(state.runs, place))
            gain = _gain(sizes, (x, state), trial)
            if gain > max([REVERSED, *sure.values()]):
                following = trial
            if gain > REVERSED:
                sure[place] = gain
        if not sure:
            return found
        best = max(sure, key=lambda place: sure[place])
        alike = [place for place in sure if sure[place] > sure[best] - REVERSED]
        found |= {state.runs[place].rows.index: sure[place] for place in sorted(alike, key=lambda place: -sure[place])}
        turned |= set(alike)
        x, state = following
        posterior = posterior_at(sizes, linearised(state), x)


def log_ratios(state: State, sizes: Sizes, x: FloatArray, posterior: Posterior) -> dict[int, float]:
    """Of each run with a direction, by its place: logarithm of how much likelier it is reversed, by the noise and sizes
    of the state.

    With p what the others expect of the whitened readings y of a run, and S the covariance of y - p, the ratio for -y
    and y is exp(-2 y' S^-1 p). S^-1 is what is left of 1 when the run's own unknowns and those that runs share are
    taken out, and S^-1 (y - p) is the residual of the estimate of all runs.
    """
    found = {}
    for place, one in enumerate(state.runs):
        if one.rows.run.direction is None:
            continue
        both = np.column_stack([one.reading, state.residual[place]])[one.good]
        y, residual = state.whitening(place, one.kept())(both).T
        rest = own_part_of(state, sizes, x, place).rest(y)
        shared = posterior.spread.T @ by_shared(state, place, rest[:, np.newaxis])
        found[place] = -2.0 * (float(y @ rest) - float(np.sum(shared**2)) - float(y @ residual))
    return found


def _turned(runs: Sequence[MeasuredRun], place: int) -> list[MeasuredRun]:
    """All readings count again."""
    whole = [replace(one, good=np.ones(one.reading.size, dtype=bool)) for one in runs]
    whole[place] = replace(whole[place], reading=-whole[place].reading)
    return whole


def _gain(sizes: Sizes, one: tuple[FloatArray, State], other: tuple[FloatArray, State]) -> float:
    """Logarithm of how much likelier readings are by the other estimate: those that count in both."""
    good = [a.good & b.good for a, b in zip(one[1].runs, other[1].runs, strict=True)]
    value, before = (evidence_at(sizes, linearised(_counting(state, good)), x) for x, state in (other, one))
    return value - before


def _counting(state: State, good: Sequence[BoolArray]) -> State:
    return replace(state, runs=tuple(replace(run, good=of) for run, of in zip(state.runs, good, strict=True)))


def mean_square(state: State) -> float:
    """Of the residuals that count, over their noise."""
    white = [
        state.whitening(place, one.kept())(state.residual[place][one.good][:, np.newaxis])
        for place, one in enumerate(state.runs)
    ]
    return float(np.mean(np.vstack(white) ** 2))
