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

MOST_STEPS = 50
NO_GAIN = 1e-2  # of a step: functions as near as that, logarithms of likelihoods, say the same
LEAST_SHARE = 1e-3  # of a step, which is halved until it goes down
NEARLY = 0.1  # standard deviations, by the information, from a bound
ROUNDING = 1e-6  # of the information: directions of which less is known than rounding allows stay short


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

    start: (n,), within them. After MOST_STEPS, or where no step goes down, it is where the descent has come to.
    """
    x, at = start, tell(start)
    for _ in range(MOST_STEPS):
        step, gain = _step(x, at, low, high)
        share = 1.0
        while gain > NO_GAIN and share > LEAST_SHARE:
            there = np.clip(x + share * step, low, high)
            after = tell(there)
            if after.value < at.value:
                break
            share *= 0.5
        else:
            break
        gain, x, at = at.value - after.value, there, after
        if gain < NO_GAIN:
            break
    return x, at.value


def _step(x: FloatArray, at: Here, low: FloatArray, high: FloatArray) -> tuple[FloatArray, float]:
    """(n,), and by how much the value is lower along it, nearly."""
    known = np.sqrt(np.maximum(np.diag(at.information), np.finfo(float).tiny))
    reach = NEARLY / known
    down, up = (x - low < reach) & (at.slope >= 0.0), (high - x < reach) & (at.slope <= 0.0)
    free = ~(down | up)
    step = np.where(down, low - x, np.where(up, high - x, 0.0))
    scaled = (at.information / np.outer(known, known))[np.ix_(free, free)] + ROUNDING * np.eye(int(free.sum()))
    step[free] = np.linalg.solve(scaled, -(at.slope / known)[free]) / known[free]
    return step, -float(at.slope @ step)
