"""What an error curve looks like before anything is measured: Legendre coefficients that shrink with their order."""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre

from trueaxis.measurement.machine import FloatArray
from trueaxis.model.bases import LegendreBasis

DEGREE = 14  # waves of a quarter of the travel are resolved; what is finer counts as noise of the instrument
SHAPE = ("waves", "falling")  # logarithms of both are estimated
WAVES, WAVES_FACTOR = 3.0, 2.0  # order up to which a curve holds about as much of each order, and its spread
FALLING, FALLING_FACTOR = 3.0, 1.6  # power by which it falls beyond: as a Matern process of a few derivatives


@dataclass(frozen=True, slots=True)
class CurvePrior:
    """Independent normal coefficients; that of order k has the variance size^2 w^2 (2k + 1) (1 + (k/waves)^2)^-falling.

    2k + 1 makes every order below `waves` count the same: the mean square of a Legendre polynomial is 1/(2k + 1). w is
    such that the root mean square of the curve over the travel is `size` on average. basis: of the axis.
    """

    basis: LegendreBasis

    def log_weights(self, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(degree,): logarithms of the standard deviations for size 1; (2, degree): derivatives by the `shape`.

        shape: (2,), logarithms of waves / WAVES and falling / FALLING.
        """
        waves, falling = WAVES * np.exp(shape[0]), FALLING * np.exp(shape[1])
        order = np.arange(1.0, self.basis.degree + 1.0)
        ratio = (order / waves) ** 2
        log = 0.5 * (np.log(2.0 * order + 1.0) - falling * np.log1p(ratio))
        by_shape = np.stack([falling * ratio / (1.0 + ratio), -0.5 * falling * np.log1p(ratio)])
        # the mean square of P_k less its value at home: 1/(2k+1) + P_k(home)^2
        share = np.exp(2.0 * log) * (1.0 / (2.0 * order + 1.0) + self._at_home() ** 2)
        total = float(share.sum())
        return log - 0.5 * np.log(total), by_shape - (by_shape @ share / total)[:, np.newaxis]

    def _at_home(self) -> FloatArray:
        low, high = self.basis.low, self.basis.high
        scaled = (2.0 * self.basis.home - low - high) / ((high - low) or 1.0)
        return np.asarray(legendre.legvander(np.array([scaled]), self.basis.degree)[0, 1:])
