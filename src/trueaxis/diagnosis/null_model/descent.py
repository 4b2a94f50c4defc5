"""The least of a function within bounds, by Newton's method with an information in place of the curvature.

Minus the logarithm of a likelihood is one whose slope is cheap and whose curvature is not; the average information is
nearly as good (Gilmour, Thompson and Cullis, Biometrics 51, 1995). What is at a bound, or nearly, and pressed towards
it goes there by itself and leaves the others alone (Bertsekas, SIAM J. Control Optim. 20, 1982): else no step of
variances, of which some are zero, would go down.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from trueaxis.diagnosis.result import FloatArray

MOST_STEPS = 100
NO_GAIN = 1e-2  # of a step: functions as near as that, logarithms of likelihoods, say the same
NEARLY = 0.1  # standard deviations, by the information, from a bound
ROUNDING = 1e-6  # of the information: directions of which less is known than rounding allows stay short
# of the damping, in units of the information of each parameter: at the start, the least that is told from none and the
# most; by what it falls where a step goes down as far as it should, and how it rises where none does
FIRST, LEAST, MOST = 1.0, 1e-2, 1e6
FALLS, RISES = 3.0, 4.0
AS_TOLD = 0.25  # share of what the information says of a step, from which it may be trusted further


@dataclass(frozen=True, slots=True, eq=False)
class Here:
    """At some parameters (n,): value, slope (n,), and information (n, n), positive semidefinite."""

    value: float
    slope: FloatArray
    information: FloatArray


def least(
    tell: Callable[[FloatArray], Here], start: FloatArray, low: FloatArray, high: FloatArray
) -> tuple[FloatArray, float]:
    """Parameters (n,) between low and high, (n,), where nothing near is lower to NO_GAIN, and the value there.

    start: (n,), within them. After MOST_STEPS, or where no step goes down, it is where the descent has come to. Steps
    are damped as far as they have gone beyond (Marquardt, J. Soc. Ind. Appl. Math. 11, 1963): from afar the information
    is no curvature, and halving each step anew took twice as many values.
    """
    x, at, damping, rises = start, tell(start), FIRST, RISES
    for _ in range(MOST_STEPS):
        step, gain = _step(x, at, low, high, damping)
        if gain < NO_GAIN / max(damping, 1.0) or damping > MOST:
            break
        there = np.clip(x + step, low, high)
        after, moved = tell(there), there - x
        lower = at.value - after.value
        if not lower > 0.0:
            damping, rises = max(rises * damping, FIRST / 10.0), 2.0 * rises
            continue
        told = -float(at.slope @ moved) - 0.5 * float(moved @ at.information @ moved)
        x, at, rises = there, after, RISES
        if lower > AS_TOLD * told:
            damping = damping / FALLS if damping / FALLS > LEAST else 0.0
        if lower < NO_GAIN and damping < FIRST:
            break
    return x, at.value


def _step(x: FloatArray, at: Here, low: FloatArray, high: FloatArray, damping: float) -> tuple[FloatArray, float]:
    """(n,), and by how much the value is lower along it, nearly."""
    known = np.sqrt(np.maximum(np.diag(at.information), np.finfo(float).tiny))
    reach = NEARLY / known
    down, up = (x - low < reach) & (at.slope >= 0.0), (high - x < reach) & (at.slope <= 0.0)
    free = ~(down | up)
    step = np.where(down, low - x, np.where(up, high - x, 0.0))
    scaled = (at.information / np.outer(known, known))[np.ix_(free, free)]
    scaled.ravel()[:: len(scaled) + 1] += ROUNDING + damping
    step[free] = np.linalg.solve(scaled, -(at.slope / known)[free]) / known[free]
    return step, -float(at.slope @ step)
