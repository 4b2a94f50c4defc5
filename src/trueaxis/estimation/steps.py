"""Steps to the posterior mean: on the exact model, and to first order where readings would not tell."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from trueaxis.estimation.posterior import Posterior
from trueaxis.estimation.residuals import residuals_of
from trueaxis.estimation.state import State
from trueaxis.measurement.machine import FloatArray

NOTHING, LEAST_SHARE = 1e-3, 1e-3  # of a sum of squares in units of their variances; of a step
# root mean square, in standard deviations of the noise, of what the exact model is away from the derivatives. On eight
# data sets with wrong runs the exact model was asked 300 times for 1000
ALIKE = 0.01


def moved(state: State, posterior: Posterior, own_scales: Sequence[FloatArray]) -> State:
    """After the step to the posterior mean, or the part of it that does the exact model no harm.

    own_scales: prior standard deviations of the own unknowns of every run, as those of the posterior.
    """
    before = _misfit(state, posterior, own_scales)
    share = 1.0
    while share >= LEAST_SHARE:
        if stays_within(state, posterior, share):
            after = at_share(state, posterior, share)
            if _misfit(after, posterior, own_scales) <= before + NOTHING:
                return after
        share *= 0.5
    return state


def at_share(state: State, posterior: Posterior, share: float = 1.0) -> State:
    """After a share of the step to the posterior mean."""
    unknowns, own = _stepped(state, posterior, share)
    residual = tuple(residuals_of(state.layout, state.runs, unknowns, own, state.given))
    layout = state.layout.at(unknowns, state.given)
    return replace(state, layout=layout, unknowns=unknowns, own=own, residual=residual)


def stays_within(state: State, posterior: Posterior, share: float = 1.0) -> bool:
    """Whether a share of the step to the posterior mean leaves effects where their terms make sense."""
    return state.layout.effects.within(_stepped(state, posterior, share)[0][state.layout.of_effects])


def _stepped(state: State, posterior: Posterior, share: float) -> tuple[FloatArray, tuple[FloatArray, ...]]:
    unknowns = state.unknowns + share * (posterior.mean * state.layout.sizes - state.unknowns)
    own = tuple(now + share * (one.mean - now) for now, one in zip(state.own, posterior.own, strict=True))
    return unknowns, own


def _misfit(state: State, posterior: Posterior, own_scales: Sequence[FloatArray]) -> float:
    """Minus twice the logarithm of the posterior density, but for a constant: what the posterior mean minimises."""
    total = float(np.sum((state.unknowns / (posterior.scale * state.layout.sizes)) ** 2))
    for place, (one, own, scale) in enumerate(zip(state.runs, state.own, own_scales, strict=True)):
        white = state.whitening(place, one.kept())(state.residual[place][one.good][:, np.newaxis])
        total += float(np.sum(white**2)) + float(np.sum((own / scale) ** 2))
    return total


@dataclass(slots=True)
class Walk:
    """One step after another, each about as far from first order as it is long, by the last one on the exact model.

    bend: what a step of readings by one standard deviation of their noise was away from first order; away: what all
    steps since the last one on the exact model may be.
    """

    bend: float = np.inf
    away: float = 0.0

    def step(self, state: State, posterior: Posterior, own_scales: Sequence[FloatArray]) -> State:
        """As `moved`, on the exact model where readings would tell the difference."""
        # the derivatives change, or cost as much as the exact model does
        if not state.kept or state.layout.effects.curved:
            return moved(state, posterior, own_scales)
        there = _by_derivatives(state, posterior)
        # what is quadratic in a step from nothing is, of a further one, up to twice as much for its length
        away = self.away + 2.0 * self.bend * _apart(state, there)
        if away < ALIKE:
            self.away = away
            return there
        after = moved(state, posterior, own_scales)
        length = _apart(state, after)
        self.bend, self.away = (_apart(after, there) / length if length > 0.0 else np.inf), 0.0
        return after

    def ended(self, state: State) -> State:
        """With what the exact model leaves of the readings."""
        if self.away == 0.0:
            return state
        left = residuals_of(state.layout, state.runs, state.unknowns, state.own, state.given)
        return replace(state, residual=tuple(left))


def _by_derivatives(state: State, posterior: Posterior) -> State:
    """After the step to the posterior mean, to first order."""
    unknowns, own = _stepped(state, posterior, 1.0)
    others = (unknowns - state.unknowns) / state.layout.sizes
    residual = [
        rest - np.concatenate([part.change(there - here, others) for part in state.derivatives(place)])
        for place, (rest, here, there) in enumerate(zip(state.residual, state.own, own, strict=True))
    ]
    layout = state.layout.at(unknowns, state.given)
    return replace(state, layout=layout, unknowns=unknowns, own=own, residual=tuple(residual))


def _apart(one: State, other: State) -> float:
    """Root mean square of the differences of residuals, in standard deviations of their noise."""
    pairs = zip(one.runs, one.scales.tolist(), one.residual, other.residual, strict=True)
    squares = [((a - b) / (scale * one.noise[run.noise_group].sigma)) ** 2 for run, scale, a, b in pairs]
    return float(np.sqrt(np.mean(np.concatenate(squares))))
