"""The readings of one bidirectional positioning test."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]

MOST_TARGETS, MOST_CYCLES = 2000, 1000  # more is a table whose columns are confused
FARTHEST_TARGET = 1e5  # mm
FEWEST_CYCLES = 2  # of an axis up to its longest; of a diagonal 1, which gives no R and A
LARGEST_DEVIATION = 10.0  # mm: beyond it target and reading are not in one unit, or not of one position


Unit = Literal["mm", "deg"]  # of a linear axis, of a rotary one
# Beyond it the standard tests an axis otherwise: one approach of each target and direction suffices (6.2).
LONGEST_AXIS: dict[Unit, float] = {"mm": 2000.0, "deg": 360.0}


@dataclass(frozen=True, slots=True)
class PositioningTest:
    """Targets P_i, (m,), and the positions P_ij measured there, (m, n), by direction of approach; mm or deg (`unit`).

    positive: approached in the positive direction of the axis (the standard's upward arrow); negative: in the
    negative one. m targets, at least 2; n cycles, at least 2, of axes beyond LONGEST_AXIS 1. Every value is finite.
    """

    targets: FloatArray
    positive: FloatArray
    negative: FloatArray
    unit: Unit = "mm"

    def swapped(self) -> "PositioningTest":
        """The same readings where the labels of direction were the wrong way round."""
        return replace(self, positive=self.negative, negative=self.positive)


def too_few(what: str, count: int, span: float = 0.0, unit: Unit = "mm", fewest_cycles: int = FEWEST_CYCLES) -> str:
    """What is wrong with this many targets or cycles; empty where there are enough. span: of the targets, in `unit`."""
    single = fewest_cycles == 1 or span > LONGEST_AXIS[unit]
    if count >= 2 or (what == "cycle" and count == 1 and single):
        return ""
    return f"has {count} {what}{'' if count == 1 else 's'}: an evaluation needs at least 2, the standard's test 5"
