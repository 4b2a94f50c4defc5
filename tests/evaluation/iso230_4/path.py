"""A circle as a machine drives it, point by point: positions of both axes with their errors, then the bar's length.

Nothing here is linearised, and no column of the package is used.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Mill:
    """mm, rad, s; (x, y) each. reversal: approached positively less negatively; play: shift across, positive where it
    goes with the other axis; lag: time by which an axis follows; spike: how far an axis stays behind where it turns,
    and over which path it catches up; cyclic: amplitude and period of x.
    """

    squareness: float = 0.0
    scale: tuple[float, float] = (0.0, 0.0)
    sag: tuple[float, float] = (0.0, 0.0)
    reversal: tuple[float, float] = (0.0, 0.0)
    play: tuple[float, float] = (0.0, 0.0)
    lag: tuple[float, float] = (0.0, 0.0)
    spike: tuple[float, float] = (0.0, 0.0)
    spike_length: float = 4.0
    cyclic: tuple[float, float] = (0.0, 5.0)
    centre: tuple[float, float] = field(default=(0.0, 0.0))
    bar: float = 0.0  # longer than nominal

    def read(self, angle: FloatArray, sense: int, radius: float, feed: float) -> FloatArray:
        """(n,), mm: length of the bar less its nominal one."""
        moving = sense * feed / 60.0 * np.array([-np.sin(angle), np.cos(angle)])
        way = np.sign(moving)
        at = radius * np.array([np.cos(angle), np.sin(angle)])
        at = at - np.array(self.lag)[:, np.newaxis] * moving
        real = at * (1.0 + np.array(self.scale)[:, np.newaxis])
        real = real + 0.5 * np.array(self.reversal)[:, np.newaxis] * way
        real = real + 0.5 * np.array(self.play)[::-1, np.newaxis] * way[::-1]
        real = real + np.array(self.sag)[::-1, np.newaxis] * (at[::-1] / radius) ** 2
        for axis in range(2):
            since = np.mod(sense * (angle - 0.5 * np.pi * axis), np.pi) * radius
            real[axis] += self.spike[axis] * np.exp(-since / self.spike_length) * np.sign(at[axis])
        amplitude, period = self.cyclic
        real[0] += amplitude * np.sin(2 * np.pi * at[0] / period + 0.7)
        x = real[0] - self.squareness * real[1]  # y leans to negative x: more than 90 deg
        x, y = x - self.centre[0], real[1] - self.centre[1]
        return np.asarray(np.hypot(x, y) - radius - self.bar)


def turn(sense: int, count: int = 720, spans: float = 360.0, start: float = 0.3) -> FloatArray:
    """(n,), rad."""
    return np.radians(start + sense * np.linspace(0.0, spans, count))
