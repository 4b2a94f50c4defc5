"""What an error curve looks like before anything is measured: Legendre coefficients that shrink with their order, and
of a rotary axis that turns round harmonics that shrink with theirs.
"""

from dataclasses import dataclass

import numpy as np

from trueaxis.machine.machine import ROTARY
from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import TURN, LegendreBasis

DEGREE = 14  # waves of a quarter of the travel are resolved; what is finer counts as noise of the instrument
SHAPE = ("waves", "falling")  # logarithms of both are estimated
WAVES, WAVES_FACTOR = 3.0, 2.0  # order up to which a curve holds about as much of each order, and its spread
FALLING, FALLING_FACTOR = 3.0, 1.6  # power by which it falls beyond: as a Matern process of a few derivatives

# Up to which order a turn is followed. Bearings, a table that is held off its middle and encoders with up to four heads
# repeat as often; what repeats with the teeth of a gear is a cyclic error.
HARMONICS = 8
MOST_TURNS = 10  # of a travel that has ends: cables and hoses allow no more


def harmonics_of(axis: str, travel: tuple[float, float]) -> int:
    """How many harmonics the curves of an axis have: those of a rotary axis that can turn round repeat with the turn.

    travel: mm or deg. Polynomials over two turns cannot follow what each turn repeats four times, and of what one turn
    tells they know nothing in the next.
    """
    return HARMONICS if axis in ROTARY and travel[1] - travel[0] >= TURN else 0


def range_of(travel: tuple[float, float], harmonics: int, read: FloatArray) -> tuple[float, float]:
    """Of the polynomials of an axis: its travel; of one without ends the positions that are read, (n,), and home, with
    a turn to either side.

    How a curve changes from turn to turn would be next to nothing over a travel of hundreds of turns.
    """
    low, high = travel
    if not harmonics or high - low <= MOST_TURNS * TURN:
        return travel
    near = np.append(read, min(max(0.0, low), high))
    return max(low, float(near.min()) - TURN), min(high, float(near.max()) + TURN)


@dataclass(frozen=True, slots=True)
class CurvePrior:
    """Independent normal coefficients; that of order k has the variance size^2 w^2 (2k + 1) (1 + (k/waves)^2)^-falling.

    2k + 1 makes every order below `waves` count the same: the mean square of a Legendre polynomial is 1/(2k + 1). w is
    such that the root mean square of the curve over the travel is `size` on average. basis: of the axis.

    Of a curve with harmonics the polynomials and these have half of the mean square each; cos and sin of k times the
    angle have a variance that falls with k^2.
    """

    basis: LegendreBasis

    def log_weights(self, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(count,): logarithms of the standard deviations for size 1; (2, count): derivatives by the `shape`.

        shape: (2,), logarithms of waves / WAVES and falling / FALLING.
        """
        waves, falling = WAVES * np.exp(shape[0]), FALLING * np.exp(shape[1])
        order = np.arange(1.0, self.basis.degree + 1.0)
        ratio = (order / waves) ** 2
        log = 0.5 * (np.log(2.0 * order + 1.0) - falling * np.log1p(ratio))
        by_shape = np.stack([falling * ratio / (1.0 + ratio), -0.5 * falling * np.log1p(ratio)])
        # the mean square of P_k less its value at home: 1/(2k+1) + P_k(home)^2
        at_home = self.basis.polynomials.at_home
        share = np.exp(2.0 * log) * (1.0 / (2.0 * order + 1.0) + at_home**2)
        total = float(share.sum())
        log -= 0.5 * np.log(total)
        by_shape -= (by_shape @ share / total)[:, np.newaxis]
        if not self.basis.harmonics:
            return log, by_shape
        # the mean square of cos and sin less their values at home together: 1 + 1
        weight = np.repeat(1.0 / np.arange(1.0, self.basis.harmonics + 1.0), 2)
        waves_log = np.log(weight / np.sqrt(float(weight @ weight)))
        return (
            np.concatenate([log, waves_log]) - 0.5 * np.log(2.0),
            np.hstack([by_shape, np.zeros((len(SHAPE), weight.size))]),
        )
