"""The motions of a control: lines and arcs of X Y Z as paths. Nothing of the package."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


@dataclass
class Motions:
    """at: where the axes stand. runs: for each run of feed motions its points, arcs cut finely; rapids: ends. tip:
    length of the tool in the spindle; tips: the same at each run.
    """

    at: list[float]
    finely: float = field(default=1e-5, kw_only=True)  # mm between arcs and their chords
    runs: list[list[list[float]]] = field(init=False, default_factory=list)
    rapids: list[list[float]] = field(init=False, default_factory=list)
    feeding: bool = field(init=False, default=False)
    tip: float = field(init=False, default=0.0)
    tips: list[float] = field(init=False, default_factory=list)

    def paths(self) -> list[FloatArray]:
        """The runs, each (3, n)."""
        return [np.array(run).T for run in self.runs]

    def by_radius(self, end: list[float], radius: float, turn: int) -> list[float]:
        """The centre that lies to the left of the chord for a turn to the left by less than half."""
        x, y = end[0] - self.at[0], end[1] - self.at[1]
        chord = math.hypot(x, y)
        rise = math.sqrt(max(radius**2 - chord**2 / 4, 0.0)) * (1 if radius > 0 else -1) * turn
        return [self.at[0] + x / 2 - y / chord * rise, self.at[1] + y / 2 + x / chord * rise]

    def arc(self, centre: Sequence[float], end: list[float], turn: int, sweep: float | None = None) -> None:
        begin = math.atan2(self.at[1] - centre[1], self.at[0] - centre[0])
        finish = math.atan2(end[1] - centre[1], end[0] - centre[0])
        if sweep is None:
            sweep = turn * ((turn * (finish - begin)) % (2 * math.pi))
            if abs(sweep) < 1e-9 or math.dist(self.at[:2], end[:2]) < 1e-9:
                sweep = turn * 2 * math.pi
        first, last = math.dist(self.at[:2], centre), math.dist(end[:2], centre)
        count = max(2, math.ceil(abs(sweep) / math.sqrt(8 * self.finely / max(first, 0.01))))
        points = []
        for k in range(1, count + 1):
            share = k / count
            radius = first + share * (last - first)
            turned = begin + share * sweep
            points.append([
                centre[0] + radius * math.cos(turned), centre[1] + radius * math.sin(turned),
                self.at[2] + share * (end[2] - self.at[2]),
            ])  # fmt: skip
        self.move([*points[:-1], end], rapid=False)

    def move(self, points: list[list[float]], rapid: bool) -> None:
        if rapid:
            self.rapids.append(points[-1])
        else:
            if not self.feeding:
                self.runs.append([self.at.copy()])
                self.tips.append(self.tip)
            self.runs[-1] += points
        self.feeding = not rapid
        self.at = points[-1].copy()
