"""Noise, outliers, sizes and unknowns in turn, until the noise stands still."""

import numpy as np

from trueaxis.estimation.evidence import best_sizes
from trueaxis.estimation.least_norm import least_norm
from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.sizes import Sizes
from trueaxis.estimation.state import (
    State,
    counting,
    linearised,
    same_readings,
    with_first_noise,
    with_noise,
    without_outliers,
)
from trueaxis.estimation.steps import Walk
from trueaxis.measurement.machine import FloatArray

LEAST_ROUNDS, MOST_ROUNDS = 5, 30  # in which noise, outliers and sizes are estimated
SEARCH_ROUNDS = 3  # before the start of an effect is searched: the noise then still holds it, and its start is rough
CONTINUED_ROUNDS = 2  # at least, of an estimate that goes on without some runs: noise and sizes are nearly there
# fits to the same readings, after which the noise goes on from what it was: before, it starts from how residuals differ
# from their neighbours. A first fit leaves values uncertain, which looks like slow noise, and would take hundreds of
# rounds to go: world 9041 of tests/worlds had a slow noise of 0.53 um where there is none
STEADY = 2
SETTLED = 0.03  # relative change of the noise: far below what readings tell of it
# gain of the logarithm of the likelihood for which the sizes move while the noise does: readings whose noise changes
# by SETTLED differ by as much. On eight data sets with wrong runs 7900 evaluations of the likelihood became 5100
ROUGHLY = 0.1
SEED = 20  # of the draws from which the noise is taken


class NothingHeldError(ValueError):
    """No reading depends on an error that is to be estimated."""


def settled(
    state: State, sizes: Sizes, most: int, x: FloatArray | None = None, least: int = LEAST_ROUNDS
) -> tuple[FloatArray, State, int]:
    """Noise, outliers, sizes and unknowns in turn, `most` times or until the noise stands still.

    x: sizes at first, if they are known.
    """
    draw = np.random.default_rng(SEED)
    walk = Walk()
    steady, sharp, counted = STEADY if x is not None else 0, False, set[bytes]()
    x = np.zeros(sizes.spread.size) if x is None else x
    for count in range(1, most + 1):
        found = linearised(state)
        if not found.holds(state.layout.of_machine):
            raise NothingHeldError("no reading holds an error of the machine")
        x, posterior = best_sizes(sizes, found, x, gain=ROUGHLY)
        posterior, _ = determined(sizes, posterior)
        before = walk.step(state, posterior, sizes.own_scales(x))
        noisy = with_noise(before, posterior, draw, steady >= STEADY)
        change = max(abs(np.log(one.sigma / before.noise[name].sigma)) for name, one in noisy.noise.items())
        state = without_outliers(noisy, posterior, sharp)
        # which readings count may go round in circles, near the limit of what is one too far: none of them is better
        again = same_readings(before, state) or counting(state) in counted
        counted.add(counting(state))
        if change < SETTLED and count >= least and again:
            if sharp:
                break
            sharp, state = True, without_outliers(noisy, posterior, sharp=True)
            if same_readings(before, state):
                break
        steady = steady + 1 if again else 0
        if steady < STEADY:
            state = with_first_noise(state)
    state = walk.ended(state)
    x, _ = best_sizes(sizes, linearised(state), x)
    return x, state, count


def determined(sizes: Sizes, posterior: Posterior) -> tuple[Posterior, FloatArray]:
    """The posterior, and without a prior what of it is open and zero: (n, d), in scaled unknowns."""
    if sizes.flat:
        return least_norm(posterior, sizes.layout.of_machine)
    return posterior, np.zeros((posterior.mean.size, 0))
