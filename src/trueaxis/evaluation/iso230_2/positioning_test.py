"""The readings of one bidirectional positioning test."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

MOST_TARGETS, MOST_CYCLES = 2000, 1000  # more is a table whose columns are confused
FARTHEST_TARGET = 1e5  # mm
LARGEST_DEVIATION = 10.0  # mm: beyond it target and reading are not in one unit, or not of one position


@dataclass(frozen=True, slots=True)
class PositioningTest:
    """Targets P_i, (m,) mm, and the positions P_ij measured there, (m, n) mm, by direction of approach.

    positive: approached in the positive direction of the axis (the standard's upward arrow); negative: in the
    negative one. m targets, at least 2; n cycles, at least 2. Every value is finite.
    """

    targets: FloatArray
    positive: FloatArray
    negative: FloatArray

    def swapped(self) -> "PositioningTest":
        """The same readings where the labels of direction were the wrong way round."""
        return replace(self, positive=self.negative, negative=self.positive)


def too_few(what: str, count: int) -> str:
    """What is wrong with this many targets or cycles; empty where there are enough."""
    if count >= 2:
        return ""
    return f"has {count} {what}{'' if count == 1 else 's'}: an evaluation needs at least 2, the standard's test 5"
