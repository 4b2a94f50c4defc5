"""The noise of a reading: given, or from what repeats and surplus readings leave over."""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, slots=True)
class Noise:
    """Standard deviation of a reading, mm (None: unknown); the degrees of freedom left; where it is from."""

    sigma: float | None
    freedom: int
    origin: str

    @property
    def um(self) -> float | None:
        """In micrometres."""
        return None if self.sigma is None else self.sigma * 1e3


def noise(squares: float, readings: int, rank: int, given_um: float | None, origin: str = "given") -> Noise:
    """From a sum of squared residuals (mm^2) of readings that determine `rank` unknowns, unless it is given."""
    freedom = readings - rank
    if given_um is not None:
        return Noise(given_um * 1e-3, freedom, origin)
    if freedom > 0:
        return Noise(float(np.sqrt(squares / freedom)), freedom, f"from the residuals, {freedom} degrees of freedom")
    return Noise(None, freedom, "unknown: no reading is left over to estimate it from, and none was given")
