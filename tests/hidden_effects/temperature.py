"""A day's temperature in the workshop, and that of the structure, which follows it."""

from dataclasses import dataclass

import numpy as np

from tests.hidden_effects.machine import Array

REFERENCE = 20.0
SOAKING_S = 250.0  # time constant of what is measured behind the air


@dataclass(frozen=True)
class Course:
    """kind: `day`: a swing of 1.5 K over the campaign with cycles of the air conditioning; `linear`: in time, with
    nothing else in it (temperature and time then cannot be told apart).
    """

    kind: str
    phase: float
    cycle: float  # s
    duration: float  # s, of the whole campaign

    def air(self, time: Array) -> Array:
        """degC."""
        if self.kind == "linear":
            return REFERENCE - 1.5 + 3.0 * time / self.duration
        slow = 1.3 * np.sin(2 * np.pi * 1.35 * time / self.duration + self.phase)
        quick = 0.2 * np.sin(2 * np.pi * time / self.cycle)
        return np.asarray(REFERENCE + slow + quick, float)

    def structure(self, time: Array) -> Array:
        """degC, behind the air by a first-order lag."""
        if self.kind == "linear":
            return self.air(time)
        grid = np.arange(-2000.0, self.duration + 60.0, 20.0)
        air = self.air(grid)
        followed = np.empty_like(air)
        followed[0] = air[0]
        share = 1.0 - np.exp(-20.0 / SOAKING_S)
        for k in range(1, len(grid)):
            followed[k] = followed[k - 1] + share * (air[k] - followed[k - 1])
        return np.interp(time, grid, followed)


def course(kind: str, source: np.random.Generator, duration: float) -> Course:
    return Course(kind, source.uniform(0, 2 * np.pi), source.uniform(1500.0, 2700.0), duration)
